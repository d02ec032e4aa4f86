// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sizes in the integer that SUNDIALS counts by.
///
/// A build of SUNDIALS has `sunindextype` of 32 or of 64 bits; those of Eigen have 64.

#pragma once

#include <ancf/error.hpp>

#include <sundials/sundials_types.h>

#include <cstddef>
#include <limits>

namespace ancf::sundials::detail {

/// Returns a count as an index of SUNDIALS.
/// @tparam Index  signed.
/// @param what    what is counted, for the message.
/// @throws InvalidArgument where the type cannot hold the count.
template <class Index = sunindextype>
[[nodiscard]] Index checked_index(std::ptrdiff_t count, const char* what) {
    constexpr auto most = std::numeric_limits<Index>::max();
    if (count > most)
        ancf::detail::reject_parts({count, " ", what, "; this build of SUNDIALS counts them by ",
                                    static_cast<int>(8 * sizeof(Index)), " bits and takes at most ",
                                    most});
    return static_cast<Index>(count);
}

}  // namespace ancf::sundials::detail
