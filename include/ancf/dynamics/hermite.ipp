// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of hermite.hpp.

#pragma once

#include <ancf/dynamics/hermite.hpp>

#include <algorithm>
#include <cstddef>

namespace ancf::detail {

ANCF_INLINE void interpolate(const std::vector<Knot>& knots, double time, VectorX& q, VectorX& v) {
    constexpr std::size_t derivatives = 3, most = 9;
    const double last = knots.back().time;
    const double width = last - knots[knots.size() - 2].time;
    const std::size_t count = std::min(most, derivatives * knots.size());
    double places[most];
    for (std::size_t k = 0; k < count; ++k)
        places[k] = (knots[k / derivatives].time - last) / width;
    const double x = (time - last) / width;
    q.resize(knots.back().q.size());
    v.resize(q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) {
        double differences[most];
        for (std::size_t k = 0; k < count; ++k) differences[k] = knots[k / derivatives].q[i];
        for (std::size_t order = 1; order < count; ++order)
            for (std::size_t k = count - 1; k >= order; --k) {
                const Knot& knot = knots[k / derivatives];
                if (k / derivatives != (k - order) / derivatives)
                    differences[k] =
                        (differences[k] - differences[k - 1]) / (places[k] - places[k - order]);
                else if (order == 1)
                    differences[k] = width * knot.v[i];
                else
                    differences[k] = 0.5 * width * width * knot.acceleration[i];
            }
        double value = differences[count - 1], slope = 0.0;
        for (std::size_t k = count - 1; k-- > 0;) {
            slope = slope * (x - places[k]) + value;
            value = value * (x - places[k]) + differences[k];
        }
        q[i] = value;
        v[i] = slope / width;
    }
}

}  // namespace ancf::detail
