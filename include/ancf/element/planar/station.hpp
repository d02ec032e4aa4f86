// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A station of the planar element: geometry, strains, energy, first and second derivatives.
///
/// It depends on p = r0', p1 = r0'' and the nodal shears; slopes enter by these shears alone.
/// Vectors are (x, y) pairs of plain scalars.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/hermite.hpp>
#include <ancf/element/planar/nodal.hpp>
#include <ancf/element/planar/section.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/element/station_data.hpp>

#include <algorithm>
#include <cmath>
#include <complex>

namespace ancf::detail {

/// The weights of a planar station: of the line, and of the nodal shears. These are interpolated
/// linearly or, with their rates at the nodes, by Hermite's cubic.
template <class Layout>
struct PlanarShape : StationShape<double, Layout::line> {
    double n[Layout::shears];    ///< weights of s_i, s_j and their rates
    double n_x[Layout::shears];  ///< the same in the rate along the arc length

    /// Takes the weights of a station.
    /// @param length  m, that the parameter of the nodal rates runs through
    static PlanarShape of(const StationShape<double, Layout::line>& shape,
                          [[maybe_unused]] double length) noexcept {
        if constexpr (Layout::rates) {
            const auto value = hermite(shape.n2, length), first = hermite_first(shape.n2, length);
            const double scale = shape.n2_x * length;  // dx/ds
            return {shape,
                    {value[0], value[2], value[1], value[3]},
                    {scale * first[0], scale * first[2], scale * first[1], scale * first[3]}};
        } else {
            return {shape, {1.0 - shape.n2, shape.n2}, {-shape.n2_x, shape.n2_x}};
        }
    }

    /// Writes the shear and its rate along the arc length.
    template <class S>
    void shear(const S (&nodal)[Layout::shears], S& s, S& s1) const noexcept {
        if constexpr (Layout::rates) {
            s = n[0] * nodal[0];
            s1 = n_x[0] * nodal[0];
            for (int m = 1; m < Layout::shears; ++m) {
                s += n[m] * nodal[m];
                s1 += n_x[m] * nodal[m];
            }
        } else {
            const S difference = nodal[1] - nodal[0];
            s = nodal[0] + n[1] * difference;
            s1 = n_x[1] * difference;
        }
    }

    /// Adds to the conjugates of the nodal shears those of shear and rate.
    template <class S>
    void add(const S& by_s, const S& by_s1, S (&nodal)[Layout::shears]) const noexcept {
        if constexpr (Layout::rates) {
            for (int m = 0; m < Layout::shears; ++m) nodal[m] += n[m] * by_s + n_x[m] * by_s1;
        } else {
            const S to_second = n[1] * by_s + n_x[1] * by_s1;
            nodal[0] += by_s - to_second;
            nodal[1] += to_second;
        }
    }
};

/// A station of the planar element.
template <class Layout>
struct PlanarStation {
    PlanarShape<Layout> shape;
    double reference[planar_strain_count];  ///< strains of the stress-free state, subtracted
    PlanarStiffness stiffness;
};

/// Returns a component of the sum of nodal vectors by weights of the line.
template <class S, int Line, int Vectors>
[[nodiscard]] inline S planar_line(const double (&weights)[Line], const S (&v)[Vectors][2],
                                   int k) noexcept {
    S sum = weights[0] * v[0][k];
    ANCF_UNROLL
    for (int x = 1; x < Line; ++x) sum += weights[x] * v[x][k];
    return sum;
}

/// The geometry of a planar station.
template <class S>
struct PlanarFrame {
    S p[2], p1[2];
    S t[2], n[2];  ///< unit tangent, normal: t turned by a right angle counterclockwise
    S inv_lam, eta;
    PlanarInvariants<S> w;
};

template <class S, class Layout>
inline void planar_frame(const PlanarShape<Layout>& shape, const PlanarNodes<S, Layout>& nodes,
                         PlanarFrame<S>& f) noexcept {
    using std::sqrt;
    ANCF_UNROLL
    for (int k = 0; k < 2; ++k) {
        f.p[k] = planar_line(shape.p, nodes.v, k);
        f.p1[k] = planar_line(shape.p1, nodes.v, k);
    }
    f.w.lam = sqrt(f.p[0] * f.p[0] + f.p[1] * f.p[1]);
    f.inv_lam = 1.0 / f.w.lam;
    for (int k = 0; k < 2; ++k) f.t[k] = f.inv_lam * f.p[k];
    f.n[0] = -f.t[1];
    f.n[1] = f.t[0];
    f.eta = f.inv_lam * (f.t[0] * f.p1[0] + f.t[1] * f.p1[1]);
    f.w.kap = f.inv_lam * (f.n[0] * f.p1[0] + f.n[1] * f.p1[1]);
    shape.shear(nodes.values, f.w.s, f.w.s1);
}

/// Sums over the stations: derivatives by the vectors of the line and by the nodal shears.
template <class S, class Layout>
struct PlanarSums {
    static constexpr int line_count = Layout::line, shears = Layout::shears;
    S energy{};
    S line[line_count][2]{};
    S sine[shears]{};
    S line_line[line_count][line_count][2][2]{};  ///< [x][y] for x <= y, components (of x, of y)
    S line_sine[line_count][2][shears]{};         ///< [vector][component][shear]
    S sine_sine[shears][shears]{};
};

/// Adds a station's Hessian.
/// @param b_p,b_p1  rows of d lam and d kap by p, and of d kap by p1
template <class Measure, class S, class Layout>
inline void add_planar_hessian(const PlanarStation<Layout>& data, const PlanarFrame<S>& f,
                               const S (&stress)[planar_strain_count],
                               const S (&U)[planar_invariant_count], const S (&b_p)[2][2],
                               const S (&b_p1)[2], PlanarSums<S, Layout>& sums) noexcept {
    S J[planar_invariant_count][planar_strain_count];
    Measure::jacobian(f.w, J);
    S D[planar_invariant_count][planar_invariant_count];
    for (int j = 0; j < planar_invariant_count; ++j) {
        S column[planar_strain_count];
        planar_stress(data.stiffness, J[j], column);
        for (int i = 0; i <= j; ++i) {
            D[i][j] = J[i][0] * column[0];
            for (int k = 1; k < planar_strain_count; ++k) D[i][j] += J[i][k] * column[k];
        }
    }
    Measure::add_curvature(f.w, stress, D);

    const S scale = f.inv_lam * f.inv_lam * U[pw_kap];
    const S tt = 2.0 * f.w.kap * scale, tn = 2.0 * f.eta * scale;
    const S nn = f.inv_lam * U[pw_lam] - 2.0 * f.w.kap * scale;
    const PlanarShape<Layout> shape = data.shape;  // which the sums, written below, do not alias
    const auto &n = shape.n, &n_x = shape.n_x;
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            const S pp = D[pw_lam][pw_lam] * b_p[0][i] * b_p[0][j] +
                         D[pw_kap][pw_kap] * b_p[1][i] * b_p[1][j] +
                         D[pw_lam][pw_kap] * (b_p[0][i] * b_p[1][j] + b_p[1][i] * b_p[0][j]) +
                         tt * f.t[i] * f.t[j] + nn * f.n[i] * f.n[j] +
                         tn * (f.t[i] * f.n[j] + f.n[i] * f.t[j]);
            const S bend = scale * (f.t[i] * f.n[j] + f.n[i] * f.t[j]);  // symmetric in p and p1
            const S pv =
                (D[pw_lam][pw_kap] * b_p[0][i] + D[pw_kap][pw_kap] * b_p[1][i]) * b_p1[j] - bend;
            const S vp =
                b_p1[i] * (D[pw_lam][pw_kap] * b_p[0][j] + D[pw_kap][pw_kap] * b_p[1][j]) - bend;
            const S vv = D[pw_kap][pw_kap] * b_p1[i] * b_p1[j];
            for (int y = 0; y < Layout::line; ++y) {
                const S p = shape.p[y] * pp + shape.p1[y] * pv,
                        w = shape.p[y] * vp + shape.p1[y] * vv;
                for (int x = 0; x <= y; ++x)
                    sums.line_line[x][y][i][j] += shape.p[x] * p + shape.p1[x] * w;
            }
        }
        for (int m = 0; m < Layout::shears; ++m) {
            const S lam = n[m] * D[pw_lam][pw_s] + n_x[m] * D[pw_lam][pw_s1];
            const S kap = n[m] * D[pw_kap][pw_s] + n_x[m] * D[pw_kap][pw_s1];
            const S p = lam * b_p[0][i] + kap * b_p[1][i], v1 = kap * b_p1[i];
            for (int x = 0; x < Layout::line; ++x)
                sums.line_sine[x][i][m] += shape.p[x] * p + shape.p1[x] * v1;
        }
    }
    for (int m = 0; m < Layout::shears; ++m) {
        for (int k = 0; k < Layout::shears; ++k) {
            sums.sine_sine[m][k] += n[m] * n[k] * D[pw_s][pw_s] +
                                    n_x[m] * n_x[k] * D[pw_s1][pw_s1] +
                                    (n[m] * n_x[k] + n_x[m] * n[k]) * D[pw_s][pw_s1];
        }
    }
}

/// Writes a station's geometry, strains and stresses.
template <class Measure, class S, class Layout>
inline void planar_state(const PlanarStation<Layout>& data, const PlanarNodes<S, Layout>& nodes,
                         PlanarFrame<S>& f, S (&strains)[planar_strain_count],
                         S (&stress)[planar_strain_count]) noexcept {
    planar_frame(data.shape, nodes, f);
    Measure::strains(f.w, strains);
    ANCF_UNROLL
    for (int k = 0; k < planar_strain_count; ++k)
        strains[k] = deformation(strains[k], data.reference[k]);
    planar_stress(data.stiffness, strains, stress);
}

/// Adds a station's energy and gradient; `Second` adds the Hessian as well.
/// @param predicted  stresses to take instead of its own; null: its own
template <bool Second, class Measure, class S, class Layout>
inline void add_planar_station(const PlanarStation<Layout>& data,
                               const PlanarNodes<S, Layout>& nodes, PlanarSums<S, Layout>& sums,
                               const S* predicted = nullptr) noexcept {
    PlanarFrame<S> f;
    S strains[planar_strain_count], stress[planar_strain_count];
    planar_state<Measure>(data, nodes, f, strains, stress);
    if (Second && predicted != nullptr) std::copy_n(predicted, planar_strain_count, stress);
    ANCF_UNROLL
    for (int k = 0; k < planar_strain_count; ++k) sums.energy += 0.5 * stress[k] * strains[k];
    S U[planar_invariant_count];
    Measure::gradient(f.w, stress, U);

    // rows of d lam and d kap by p and p1
    S b_p[2][2], b_p1[2];
    ANCF_UNROLL
    for (int k = 0; k < 2; ++k) {
        b_p[pw_lam][k] = f.t[k];
        b_p[pw_kap][k] = -f.inv_lam * (f.w.kap * f.t[k] + f.eta * f.n[k]);
        b_p1[k] = f.inv_lam * f.n[k];
    }
    const auto& shape = data.shape;
    ANCF_UNROLL
    for (int k = 0; k < 2; ++k) {
        const S p = U[pw_lam] * b_p[pw_lam][k] + U[pw_kap] * b_p[pw_kap][k],
                v1 = U[pw_kap] * b_p1[k];
        ANCF_UNROLL
        for (int x = 0; x < Layout::line; ++x) sums.line[x][k] += shape.p[x] * p + shape.p1[x] * v1;
    }
    shape.add(U[pw_s], U[pw_s1], sums.sine);
    if constexpr (Second) add_planar_hessian<Measure>(data, f, stress, U, b_p, b_p1, sums);
}

/// The slope of the centre line at an axial station with its strain and force.
template <class S>
struct PlanarAxial {
    S p[2];
    S strain, stress;
};

template <class S, class Layout>
[[nodiscard]] inline PlanarAxial<S> planar_axial(const AxialStationData<double, Layout::line>& data,
                                                 const PlanarNodes<S, Layout>& nodes) noexcept {
    PlanarAxial<S> at;
    for (int k = 0; k < 2; ++k) at.p[k] = planar_line(data.p, nodes.v, k);
    at.strain = deformation(S(0.5 * (at.p[0] * at.p[0] + at.p[1] * at.p[1] - 1.0)), data.reference);
    at.stress = data.stiffness * at.strain;
    return at;
}

/// Adds an axial station, as add_planar_station() does.
template <bool Second, class S, class Layout>
inline void add_planar_axial(const AxialStationData<double, Layout::line>& data,
                             const PlanarNodes<S, Layout>& nodes, PlanarSums<S, Layout>& sums,
                             const S* predicted = nullptr) noexcept {
    const PlanarAxial<S> at = planar_axial(data, nodes);
    const S(&p)[2] = at.p;
    const S stress = Second && predicted != nullptr ? *predicted : at.stress;
    sums.energy += 0.5 * stress * at.strain;
    for (int x = 0; x < Layout::line; ++x) {
        for (int k = 0; k < 2; ++k) sums.line[x][k] += data.p[x] * stress * p[k];
    }
    if constexpr (Second) {
        for (int i = 0; i < 2; ++i) {
            for (int j = 0; j < 2; ++j) {
                S entry = data.stiffness * p[i] * p[j];
                if (i == j) entry += stress;
                for (int y = 0; y < Layout::line; ++y) {
                    for (int x = 0; x <= y; ++x)
                        sums.line_line[x][y][i][j] += data.p[x] * data.p[y] * entry;
                }
            }
        }
    }
}

}  // namespace ancf::detail
