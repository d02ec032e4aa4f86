// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Torsion constants: definitions.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/section/torsion.hpp>

#include <algorithm>
#include <cmath>

namespace ancf {

ANCF_INLINE double rectangle_torsion_constant(double width, double height) {
    detail::require_positive("width", width);
    detail::require_positive("height", height);
    constexpr double zeta5 = 1.03692775514336992633;
    const double a = std::max(width, height);
    const double b = std::min(width, height);
    double sum = 31.0 / 32.0 * zeta5;
    for (int n = 1; n <= 15; n += 2)  // exp(-15 pi) < 1e-20
        sum -= 2.0 / ((std::exp(n * pi * (a / b)) + 1.0) * std::pow(n, 5));
    return a * b * b * b * (1.0 / 3.0 - 64.0 * (b / a) / std::pow(pi, 5) * sum);
}

}  // namespace ancf
