// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How far a mesh is from its limit: Richardson's extrapolation from three meshes.
///
/// Of values v(h) = v + c h^p of meshes n, 2n, 4n: the order p = log2((v_2n - v_n)/(v_4n - v_2n))
/// and the limit v_4n + (v_4n - v_2n)/(2^p - 1). [Richardson and Gaunt, Phil. Trans. R. Soc. A 226
/// (1927)]

#pragma once

#include <ancf/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ancf {

/// What three meshes tell.
struct Convergence {
    std::array<int, 3> elements;   ///< n, 2n, 4n
    std::array<double, 3> values;  ///< of each mesh
    double order = 0.0;            ///< p; 0 where the values do not settle
    double estimate = 0.0;         ///< the limit; the finest value where they do not settle
    double error = 0.0;            ///< estimated error of the finest value, absolute; NaN of NaN
    bool settles = false;          ///< whether differences have one sign and shrink
};

/// Computes a value on three meshes and estimates its limit.
///
///     const auto tip = ancf::richardson([](int n) { return solve(n).tip_y; }, 4);
///     // tip.values[2] +- tip.error, order tip.order
///
/// @param value  from a number of elements to the value of interest
/// @throws InvalidArgument unless elements >= 1, or where the finest mesh is past counting.
template <class Value>
[[nodiscard]] Convergence richardson(Value&& value, int elements) {
    constexpr int most = std::numeric_limits<int>::max() / 4;
    detail::require(elements >= 1 && elements <= most, "richardson: elements must be from 1 to ",
                    most, ", got ", elements);
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
