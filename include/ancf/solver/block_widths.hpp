// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The widths of blocks for which the kernel of chains is compiled.

#pragma once

#include <algorithm>
#include <type_traits>

namespace ancf::detail {

/// Unknowns in the widest block.
inline constexpr int widest_compiled_block = 24;

/// The widths of blocks that are compiled.
using BlockWidths = std::integer_sequence<int, 6, 12, widest_compiled_block>;

/// Returns the smallest compiled width that holds `widest`, which is at most the widest.
template <int... Width>
int fitting_width(int widest, std::integer_sequence<int, Width...>) {
    int fitting = widest_compiled_block;
    ((fitting = widest <= Width ? std::min(fitting, Width) : fitting), ...);
    return fitting;
}

/// Calls action(std::integral_constant<int, N>()) with the N that `width` is.
template <class Action, int... Width>
void with_block_width(int width, Action&& action, std::integer_sequence<int, Width...>) {
    ((width == Width ? action(std::integral_constant<int, Width>()) : void()), ...);
}

}  // namespace ancf::detail
