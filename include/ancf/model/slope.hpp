// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Which nodal vectors are slopes, for joints and moments that act on one.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>

namespace ancf::detail {

/// @throws InvalidArgument unless the field is a slope: r_x, r_y or, in space, r_z.
template <int Dimension>
inline void require_slope(const char* user, Field field) {
    require(field == Field::r_x || field == Field::r_y || (Dimension == 3 && field == Field::r_z),
            user,
            Dimension == 3 ? ": expected a slope r_x, r_y or r_z, got "
                           : ": expected a slope r_x or r_y, got ",
            to_string(field));
}

}  // namespace ancf::detail
