// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// richardson: definition.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/richardson.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ancf {

ANCF_INLINE Convergence richardson(const std::function<double(int)>& value, int elements) {
    detail::require(elements >= 1, "richardson: elements must be at least 1, got ", elements);
    Convergence result{{elements, 2 * elements, 4 * elements}, {}};
    for (std::size_t k = 0; k < 3; ++k) result.values[k] = value(result.elements[k]);
    const double coarse = result.values[1] - result.values[0];
    const double fine = result.values[2] - result.values[1];
    const double ratio = coarse / fine;
    result.estimate = result.values[2];
    if (fine == 0.0 && std::isfinite(coarse)) {
        result.settles = true;  // to the last digit
        return result;
    }
    result.settles = std::isfinite(ratio) && ratio > 1.0;
    // std::max would drop a NaN
    result.error = std::isnan(ratio) ? ratio : std::max(std::abs(coarse), std::abs(fine));
    if (!result.settles) return result;
    result.order = std::log2(ratio);
    result.error = std::abs(fine) / (ratio - 1.0);
    result.estimate += fine / (ratio - 1.0);
    return result;
}

}  // namespace ancf
