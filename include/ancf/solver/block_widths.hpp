// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The widths of blocks for which the kernel of chains is compiled.

#pragma once

#include <ancf/solver/block_tridiagonal.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace ancf::detail {

/// The widths of blocks that are compiled.
using BlockWidths = std::integer_sequence<int, 6, 12, BlockTridiagonal::max_block>;

/// Returns the smallest compiled width that holds `widest`, which is at most max_block.
template <int... Width>
int fitting_width(int widest, std::integer_sequence<int, Width...>) {
    int fitting = BlockTridiagonal::max_block;
    ((fitting = widest <= Width ? std::min(fitting, Width) : fitting), ...);
    return fitting;
}

/// Calls action(std::integral_constant<int, N>()) with the N that `width` is.
template <class Action, int... Width>
void with_block_width(int width, Action&& action, std::integer_sequence<int, Width...>) {
    ((width == Width ? action(std::integral_constant<int, Width>()) : void()), ...);
}

}  // namespace ancf::detail
