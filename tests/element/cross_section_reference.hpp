// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The energy of the cross-section beam written down a second time, straight from its definition:
/// strains at points of the volume, [Dufva2006, Eqs. 6 to 29], of a rectangle. No invariants, no
/// section integrals.

#pragma once

#include <ancf/element/quadrature.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <complex>

namespace ancf::test {

/// A rectangular bar; height along y, width along z.
struct Bar {
    double length, height, width, young, shear_y, shear_z;  ///< moduli times correction factor
    bool pointwise, stretch;
};

template <class S>
using V3 = Vector<S, 3>;

/// Inner product without conjugation.
template <class S>
[[nodiscard]] S inner(const V3<S>& a, const V3<S>& b) {
    return (a.transpose() * b)(0);
}

/// A vector with its derivative along x.
template <class S>
struct Jet {
    V3<S> v, dx;
};

/// A number with its derivative along x.
template <class S>
struct ScalarJet {
    S v, dx;
};

template <class S>
[[nodiscard]] ScalarJet<S> inner(const Jet<S>& a, const Jet<S>& b) {
    return {inner(a.v, b.v), inner(a.dx, b.v) + inner(a.v, b.dx)};
}

template <class S>
[[nodiscard]] Jet<S> unit(const Jet<S>& a) {
    using std::sqrt;
    const S length = sqrt(inner(a.v, a.v));
    const V3<S> n = a.v / length;
    return {n, (a.dx - inner(n, a.dx) * n) / length};
}

/// Returns a - b s.
template <class S>
[[nodiscard]] Jet<S> minus(const Jet<S>& a, const Jet<S>& b, const ScalarJet<S>& s) {
    return {a.v - b.v * s.v, a.dx - b.dx * s.v - b.v * s.dx};
}

/// Returns the shear sine of a slope against a tangent.
template <class S>
[[nodiscard]] S sine(const V3<S>& a, const V3<S>& g) {
    using std::sqrt;
    return inner(a, g) / sqrt(inner(a, a) * inner(g, g));
}

/// Returns the director unit(P a) + s t of a slope.
template <class S>
[[nodiscard]] Jet<S> director(const Jet<S>& tangent, const Jet<S>& slope, const ScalarJet<S>& s) {
    const Jet<S> normal = unit(minus(slope, tangent, inner(slope, tangent)));
    return minus(normal, tangent, ScalarJet<S>{-s.v, -s.dx});
}

/// Returns the strain energy by four Gauss points along x and three by three over the section:
/// exact there.
template <class S>
[[nodiscard]] S bar_energy(const Bar& bar, const Vector<S, 24>& e) {
    const double l = bar.length;
    V3<S> n[8];
    for (int k = 0; k < 8; ++k) n[k] = e.template segment<3>(3 * k);
    S energy(0.0);
    for (const QuadraturePoint& at : gauss_quadrature(4)) {
        const double x = at.xi;
        const Jet<S> tangent_vector{(6 * x * x - 6 * x) / l * n[0] +
                                        (1 - 4 * x + 3 * x * x) * n[1] -
                                        (6 * x * x - 6 * x) / l * n[4] + (3 * x * x - 2 * x) * n[5],
                                    ((12 * x - 6) / l * n[0] + (6 * x - 4) * n[1] -
                                     (12 * x - 6) / l * n[4] + (6 * x - 2) * n[5]) /
                                        l};
        const Jet<S> t = unit(tangent_vector);
        Jet<S> directors[2];
        for (int k = 0; k < 2; ++k) {
            const V3<S>&first = n[2 + k], &second = n[6 + k];
            const Jet<S> slope{(1 - x) * first + x * second, (second - first) / l};
            ScalarJet<S> s;
            if (bar.pointwise) {
                s = inner(unit(slope), t);
            } else {
                const S s1 = sine(first, n[1]), s2 = sine(second, n[5]);
                s = {(1 - x) * s1 + x * s2, (s2 - s1) / l};
            }
            directors[k] = director(t, slope, s);
        }
        for (const QuadraturePoint& row : gauss_quadrature(3)) {
            for (const QuadraturePoint& column : gauss_quadrature(3)) {
                const double y = (row.xi - 0.5) * bar.height, z = (column.xi - 0.5) * bar.width;
                const V3<S> F = tangent_vector.v + y * directors[0].dx + z * directors[1].dx;
                const S xx = (inner(F, F) - 1.0) / 2.0;
                const S xy = inner(F, directors[0].v), xz = inner(F, directors[1].v);
                energy += at.weight * row.weight * column.weight * l * bar.height * bar.width *
                          (bar.young * xx * xx + bar.shear_y * xy * xy + bar.shear_z * xz * xz) /
                          2.0;
            }
        }
        using std::sqrt;
        S transverse[3];
        for (int k = 0; k < 2; ++k) {
            S nodal[2];
            for (int node = 0; node < 2; ++node) {
                const S square = inner(n[4 * node + 2 + k], n[4 * node + 2 + k]);
                nodal[node] = bar.stretch ? S(sqrt(square) - 1.0) : S((square - 1.0) / 2.0);
            }
            transverse[k] = (1 - x) * nodal[0] + x * nodal[1];
        }
        transverse[2] = (1 - x) * inner(n[2], n[3]) + x * inner(n[6], n[7]);
        energy += at.weight * l * bar.height * bar.width *
                  (bar.young * (transverse[0] * transverse[0] + transverse[1] * transverse[1]) +
                   (bar.shear_y + bar.shear_z) / 2.0 * transverse[2] * transverse[2]) /
                  2.0;
    }
    return energy;
}

}  // namespace ancf::test
