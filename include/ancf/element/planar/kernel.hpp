// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The evaluation of the cross-section beam in the plane.
///
/// Stations depend on p = r0', p1 = r0'' and the shear sines of the two nodes; slopes enter by
/// these sines and by the transverse strain alone. Vectors are (x, y) pairs of plain scalars.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/cross_section_options.hpp>
#include <ancf/element/dual.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/planar/section.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace ancf::detail {

/// Places of the planar nodal vectors: D = r_j - r_i, g = r_x, a = r_y.
enum PlanarNodal : int { pn_D, pn_g1, pn_g2, pn_a1, pn_a2, planar_nodal_count };

/// Where their coordinates start; those of D are those of r_j, and r_i has their negatives.
inline constexpr int planar_start[planar_nodal_count] = {6, 2, 8, 4, 10};

/// A station of the planar element.
template <class T>
struct PlanarStation {
    StationShape<T> shape;
    T reference[planar_strain_count];  ///< strains of the stress-free state, subtracted
    PlanarStiffness<T> stiffness;
};

/// The shear sine s = a.g/(|a| |g|) of a node.
template <class S>
struct PlanarSine {
    S value;
    S a[2], g[2];    ///< ds/da, ds/dg
    S u[2], t[2];    ///< unit slope, unit tangent
    S inv_a, inv_g;  ///< 1/|a|, 1/|g|
};

template <class S>
inline PlanarSine<S> planar_sine(const S* a, const S* g) noexcept {
    using std::sqrt;
    PlanarSine<S> s;
    s.inv_a = 1.0 / sqrt(a[0] * a[0] + a[1] * a[1]);
    s.inv_g = 1.0 / sqrt(g[0] * g[0] + g[1] * g[1]);
    for (int k = 0; k < 2; ++k) {
        s.u[k] = s.inv_a * a[k];
        s.t[k] = s.inv_g * g[k];
    }
    s.value = s.u[0] * s.t[0] + s.u[1] * s.t[1];
    for (int k = 0; k < 2; ++k) {
        s.a[k] = s.inv_a * (s.t[k] - s.value * s.u[k]);
        s.g[k] = s.inv_g * (s.u[k] - s.value * s.t[k]);
    }
    return s;
}

/// The geometry of a planar station.
template <class S>
struct PlanarFrame {
    S p[2], p1[2];
    S t[2], n[2];  ///< unit tangent, normal: t turned by a right angle counterclockwise
    S inv_lam, eta;
    PlanarInvariants<S> w;
};

template <class T, class S>
inline void planar_frame(const StationShape<T>& shape, const S (&v)[planar_nodal_count][2],
                         const S (&sines)[2], PlanarFrame<S>& f) noexcept {
    using std::sqrt;
    ANCF_UNROLL
    for (int k = 0; k < 2; ++k) {
        f.p[k] = shape.p[0] * v[pn_D][k] + shape.p[1] * v[pn_g1][k] + shape.p[2] * v[pn_g2][k];
        f.p1[k] = shape.p1[0] * v[pn_D][k] + shape.p1[1] * v[pn_g1][k] + shape.p1[2] * v[pn_g2][k];
    }
    f.w.lam = sqrt(f.p[0] * f.p[0] + f.p[1] * f.p[1]);
    f.inv_lam = 1.0 / f.w.lam;
    for (int k = 0; k < 2; ++k) f.t[k] = f.inv_lam * f.p[k];
    f.n[0] = -f.t[1];
    f.n[1] = f.t[0];
    f.eta = f.inv_lam * (f.t[0] * f.p1[0] + f.t[1] * f.p1[1]);
    f.w.kap = f.inv_lam * (f.n[0] * f.p1[0] + f.n[1] * f.p1[1]);
    const S difference = sines[1] - sines[0];
    f.w.s = sines[0] + shape.n2 * difference;
    f.w.s1 = shape.n2_x * difference;
}

/// Sums over the stations: derivatives by (D, g1, g2) and by the two sines.
template <class S>
struct PlanarSums {
    S energy{};
    S line[3][2]{};
    S sine[2]{};
    S line_line[3][3][2][2]{};  ///< [x][y] for x <= y, components (of x, of y)
    S line_sine[3][2][2]{};     ///< [vector][component][sine]
    S sine_sine[2][2]{};
};

/// Adds a station's Hessian.
/// @param b_p,b_p1  rows of d lam and d kap by p, and of d kap by p1
template <class Measure, class T, class S>
inline void add_planar_hessian(const PlanarStation<T>& data, const PlanarFrame<S>& f,
                               const S (&stress)[planar_strain_count],
                               const S (&U)[planar_invariant_count], const S (&b_p)[2][2],
                               const S (&b_p1)[2], PlanarSums<S>& sums) noexcept {
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
    const StationShape<T>& shape = data.shape;
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
            for (int y = 0; y < 3; ++y) {
                const S p = shape.p[y] * pp + shape.p1[y] * pv,
                        w = shape.p[y] * vp + shape.p1[y] * vv;
                for (int x = 0; x <= y; ++x)
                    sums.line_line[x][y][i][j] += shape.p[x] * p + shape.p1[x] * w;
            }
        }
        for (int m = 0; m < 2; ++m) {
            const T n = m == 0 ? T(1.0 - shape.n2) : shape.n2;
            const T n_x = m == 0 ? T(-shape.n2_x) : shape.n2_x;
            const S lam = n * D[pw_lam][pw_s] + n_x * D[pw_lam][pw_s1];
            const S kap = n * D[pw_kap][pw_s] + n_x * D[pw_kap][pw_s1];
            const S p = lam * b_p[0][i] + kap * b_p[1][i], v1 = kap * b_p1[i];
            for (int x = 0; x < 3; ++x)
                sums.line_sine[x][i][m] += shape.p[x] * p + shape.p1[x] * v1;
        }
    }
    const T n[2] = {T(1.0 - shape.n2), shape.n2}, n_x[2] = {T(-shape.n2_x), shape.n2_x};
    for (int m = 0; m < 2; ++m) {
        for (int k = 0; k < 2; ++k) {
            sums.sine_sine[m][k] += n[m] * n[k] * D[pw_s][pw_s] +
                                    n_x[m] * n_x[k] * D[pw_s1][pw_s1] +
                                    (n[m] * n_x[k] + n_x[m] * n[k]) * D[pw_s][pw_s1];
        }
    }
}

/// Writes a station's geometry, strains and stresses.
template <class Measure, class T, class S>
inline void planar_state(const PlanarStation<T>& data, const S (&v)[planar_nodal_count][2],
                         const S (&sines)[2], PlanarFrame<S>& f, S (&strains)[planar_strain_count],
                         S (&stress)[planar_strain_count]) noexcept {
    planar_frame(data.shape, v, sines, f);
    Measure::strains(f.w, strains);
    ANCF_UNROLL
    for (int k = 0; k < planar_strain_count; ++k)
        strains[k] = deformation(strains[k], data.reference[k]);
    planar_stress(data.stiffness, strains, stress);
}

/// Adds a station's energy and gradient; `Second` adds the Hessian as well.
/// @param predicted  stresses to take instead of its own; null: its own
template <bool Second, class Measure, class T, class S>
inline void add_planar_station(const PlanarStation<T>& data, const S (&v)[planar_nodal_count][2],
                               const S (&sines)[2], PlanarSums<S>& sums,
                               const S* predicted = nullptr) noexcept {
    PlanarFrame<S> f;
    S strains[planar_strain_count], stress[planar_strain_count];
    planar_state<Measure>(data, v, sines, f, strains, stress);
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
    const StationShape<T>& shape = data.shape;
    ANCF_UNROLL
    for (int k = 0; k < 2; ++k) {
        const S p = U[pw_lam] * b_p[pw_lam][k] + U[pw_kap] * b_p[pw_kap][k],
                v1 = U[pw_kap] * b_p1[k];
        ANCF_UNROLL
        for (int x = 0; x < 3; ++x) sums.line[x][k] += shape.p[x] * p + shape.p1[x] * v1;
    }
    const S to_second = shape.n2 * U[pw_s] + shape.n2_x * U[pw_s1];
    sums.sine[0] += U[pw_s] - to_second;
    sums.sine[1] += to_second;
    if constexpr (Second) add_planar_hessian<Measure>(data, f, stress, U, b_p, b_p1, sums);
}

/// Constant data of a planar element and its evaluation.
template <class T, class Measure>
struct PlanarKernel {
    static constexpr int dofs = 12;

    std::vector<PlanarStation<T>> stations;
    detail::Records<AxialStationData<T>> axial;
    T transverse_stiffness;     ///< of e_yy times the length, N m
    T transverse_reference[2];  ///< nodal e_yy of the stress-free state
    TransverseStrain transverse_measure = TransverseStrain::green;

    /// Makes e the stress-free state: its strains are the ones subtracted from now on.
    void set_reference(const Vector<double, dofs>& e) noexcept {
        const Nodes<double> nodes(e);
        for (PlanarStation<T>& station : stations) {
            PlanarFrame<double> f;
            planar_frame(station.shape, nodes.v, nodes.values, f);
            double strains[planar_strain_count];
            Measure::strains(f.w, strains);
            for (int k = 0; k < planar_strain_count; ++k) station.reference[k] = strains[k];
        }
        for (AxialStationData<T>& station : axial) {
            const double p[2] = {axial_slope(station, nodes.v, 0),
                                 axial_slope(station, nodes.v, 1)};
            station.reference = 0.5 * (p[0] * p[0] + p[1] * p[1] - 1.0);
        }
        TransverseTerm<double> terms[2];
        transverse_reference[0] = transverse_reference[1] = 0.0;
        transverse_strains(nodes, terms, transverse_reference);
    }

    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& e) const noexcept {
        Nodes<S> nodes(e);
        PlanarSums<S> sums;
        walk<false>(nodes, sums);
        TransverseTerm<S> transverse[2];
        return sums.energy + transverse_terms(nodes, transverse);
    }

    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e) const noexcept {
        Nodes<S> nodes(e);
        PlanarSums<S> sums;
        walk<false>(nodes, sums);
        TransverseTerm<S> transverse[2];
        (void)transverse_terms(nodes, transverse);
        return gradient(nodes, sums, transverse);
    }

    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept {
        Nodes<S> nodes(e);
        PlanarSums<S> sums;
        walk<true>(nodes, sums);
        TransverseTerm<S> transverse[2];
        Evaluation<S, dofs> result;
        result.energy = sums.energy + transverse_terms(nodes, transverse);
        result.force = gradient(nodes, sums, transverse);
        write_tangent(nodes, sums, transverse, result.tangent);
        return result;
    }

    /// Returns the same with a tangent whose geometric part has the stresses C (s + B change) of a
    /// state before.
    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                               const Vector<S, dofs>& before,
                                               const Vector<S, dofs>& change) const noexcept {
        const Nodes<S> nodes(e);
        PlanarSums<S> sums;
        walk<false>(nodes, sums);
        TransverseTerm<S> transverse[2];
        Evaluation<S, dofs> result;
        result.energy = sums.energy + transverse_terms(nodes, transverse);
        result.force = gradient(nodes, sums, transverse);

        Dual<S> course[dofs];
        for (int i = 0; i < dofs; ++i) course[i] = Dual<S>(before[i], change[i]);
        const Nodes<Dual<S>> line(course);
        PlanarSums<S> predicted;
        for (const PlanarStation<T>& station : stations) {
            PlanarFrame<Dual<S>> frame;
            Dual<S> strains[planar_strain_count], course_stress[planar_strain_count];
            planar_state<Measure>(station, line.v, line.values, frame, strains, course_stress);
            S stress[planar_strain_count];
            for (int k = 0; k < planar_strain_count; ++k) stress[k] = arrived(course_stress[k]);
            add_planar_station<true, Measure>(station, nodes.v, nodes.values, predicted, stress);
        }
        for (const AxialStationData<T>& station : axial) {
            const S stress = arrived(axial_state(station, line.v).stress);
            add_axial<true>(station, nodes.v, predicted, &stress);
        }
        TransverseTerm<Dual<S>> course_transverse[2];
        (void)transverse_terms(line, course_transverse);
        for (int node = 0; node < 2; ++node)
            transverse[node].stress = arrived(course_transverse[node].stress);
        write_tangent(nodes, predicted, transverse, result.tangent);
        return result;
    }

private:
    template <class S>
    struct Nodes {
        S v[planar_nodal_count][2];
        PlanarSine<S> sine[2];
        S values[2];

        template <class Coordinates>
        explicit Nodes(const Coordinates& e) noexcept {
            for (int k = 0; k < 2; ++k) {
                v[pn_D][k] = e[6 + k] - e[k];
                for (int x = pn_g1; x < planar_nodal_count; ++x) v[x][k] = e[planar_start[x] + k];
            }
            for (int node = 0; node < 2; ++node) {
                sine[node] = planar_sine(v[pn_a1 + node], v[pn_g1 + node]);
                values[node] = sine[node].value;
            }
        }
    };

    // A nodal strain of the slope's length: gradient by the slope, 1/|a| of the stretch, stress.
    template <class S>
    struct TransverseTerm {
        S gradient[2];
        S inverse;
        S stress;
    };

    template <bool Second, class S>
    void walk(const Nodes<S>& nodes, PlanarSums<S>& sums) const noexcept {
        for (const PlanarStation<T>& station : stations)
            add_planar_station<Second, Measure>(station, nodes.v, nodes.values, sums);
        for (const AxialStationData<T>& station : axial) add_axial<Second>(station, nodes.v, sums);
    }

    template <class S>
    static S axial_slope(const AxialStationData<T>& data, const S (&v)[planar_nodal_count][2],
                         int k) noexcept {
        return data.p[0] * v[pn_D][k] + data.p[1] * v[pn_g1][k] + data.p[2] * v[pn_g2][k];
    }

    // The slope of the centre line with its strain and force.
    template <class S>
    struct Axial {
        S p[2];
        S strain, stress;
    };

    template <class S>
    static Axial<S> axial_state(const AxialStationData<T>& data,
                                const S (&v)[planar_nodal_count][2]) noexcept {
        Axial<S> at;
        for (int k = 0; k < 2; ++k) at.p[k] = axial_slope(data, v, k);
        at.strain =
            deformation(S(0.5 * (at.p[0] * at.p[0] + at.p[1] * at.p[1] - 1.0)), data.reference);
        at.stress = data.stiffness * at.strain;
        return at;
    }

    // What a linearised state has reached at the end of its change.
    template <class S>
    static S arrived(const Dual<S>& course) noexcept {
        return course.value + course.rate;
    }

    template <bool Second, class S>
    static void add_axial(const AxialStationData<T>& data, const S (&v)[planar_nodal_count][2],
                          PlanarSums<S>& sums, const S* predicted = nullptr) noexcept {
        const Axial<S> at = axial_state(data, v);
        const S(&p)[2] = at.p;
        const S stress = Second && predicted != nullptr ? *predicted : at.stress;
        sums.energy += 0.5 * stress * at.strain;
        for (int x = 0; x < 3; ++x) {
            for (int k = 0; k < 2; ++k) sums.line[x][k] += data.p[x] * stress * p[k];
        }
        if constexpr (Second) {
            for (int i = 0; i < 2; ++i) {
                for (int j = 0; j < 2; ++j) {
                    S entry = data.stiffness * p[i] * p[j];
                    if (i == j) entry += stress;
                    for (int y = 0; y < 3; ++y) {
                        for (int x = 0; x <= y; ++x)
                            sums.line_line[x][y][i][j] += data.p[x] * data.p[y] * entry;
                    }
                }
            }
        }
    }

    template <class S>
    void transverse_strains(const Nodes<S>& nodes, TransverseTerm<S> (&terms)[2],
                            S (&strain)[2]) const noexcept {
        using std::sqrt;
        for (int node = 0; node < 2; ++node) {
            const S* a = nodes.v[pn_a1 + node];
            const S square = a[0] * a[0] + a[1] * a[1];
            const bool green = transverse_measure == TransverseStrain::green;
            terms[node].inverse = green ? S(1.0) : nodes.sine[node].inv_a;
            for (int k = 0; k < 2; ++k) terms[node].gradient[k] = terms[node].inverse * a[k];
            strain[node] = deformation(green ? S(0.5 * (square - 1.0)) : S(sqrt(square) - 1.0),
                                       transverse_reference[node]);
        }
    }

    template <class S>
    S transverse_terms(const Nodes<S>& nodes, TransverseTerm<S> (&terms)[2]) const noexcept {
        S strain[2];
        transverse_strains(nodes, terms, strain);
        const S W = transverse_stiffness * S(1.0 / 6.0);
        terms[0].stress = W * (2.0 * strain[0] + strain[1]);
        terms[1].stress = W * (strain[0] + 2.0 * strain[1]);
        return 0.5 * (terms[0].stress * strain[0] + terms[1].stress * strain[1]);
    }

    template <class S>
    static Vector<S, dofs> gradient(const Nodes<S>& nodes, const PlanarSums<S>& sums,
                                    const TransverseTerm<S> (&transverse)[2]) noexcept {
        Vector<S, dofs> force;
        for (int k = 0; k < 2; ++k) {
            force[k] = -sums.line[0][k];
            force[6 + k] = sums.line[0][k];
            for (int node = 0; node < 2; ++node) {
                force[planar_start[pn_g1 + node] + k] =
                    sums.line[1 + node][k] + sums.sine[node] * nodes.sine[node].g[k];
                force[planar_start[pn_a1 + node] + k] =
                    sums.sine[node] * nodes.sine[node].a[k] +
                    transverse[node].stress * transverse[node].gradient[k];
            }
        }
        return force;
    }

    // The upper triangle in the order D, g1, g2, a1, a2, then the rows and columns of r_i.
    template <class S>
    void write_tangent(const Nodes<S>& nodes, const PlanarSums<S>& sums,
                       const TransverseTerm<S> (&transverse)[2],
                       Matrix<S, dofs>& tangent) const noexcept {
        constexpr int size = 2 * planar_nodal_count;
        S L[2][size];  // gradients of the sines
        for (int m = 0; m < 2; ++m) {
            for (S& entry : L[m]) entry = S(0.0);
            for (int k = 0; k < 2; ++k) {
                L[m][2 * (pn_g1 + m) + k] = nodes.sine[m].g[k];
                L[m][2 * (pn_a1 + m) + k] = nodes.sine[m].a[k];
            }
        }
        S Z[2][size];  // coupling + shear matrix/2 L
        for (int m = 0; m < 2; ++m) {
            for (int k = 0; k < size; ++k) {
                Z[m][k] = 0.5 * (sums.sine_sine[m][0] * L[0][k] + sums.sine_sine[m][1] * L[1][k]);
                if (k < 6) Z[m][k] += sums.line_sine[k / 2][k % 2][m];
            }
        }
        S K[size][size];
        for (int j = 0; j < size; ++j) {
            for (int i = 0; i <= j; ++i) {
                K[i][j] =
                    Z[0][i] * L[0][j] + L[0][i] * Z[0][j] + Z[1][i] * L[1][j] + L[1][i] * Z[1][j];
                if (j < 6) K[i][j] += sums.line_line[i / 2][j / 2][i % 2][j % 2];
            }
        }
        const S W = transverse_stiffness * S(1.0 / 6.0);
        for (int node = 0; node < 2; ++node) {
            add_sine_second(nodes.sine[node], sums.sine[node], 2 * (pn_g1 + node),
                            2 * (pn_a1 + node), K);
            for (int other = node; other < 2; ++other) {
                const S weight = node == other ? S(2.0 * W) : W;
                for (int i = 0; i < 2; ++i) {
                    for (int j = 0; j < 2; ++j) {
                        const int row = 2 * (pn_a1 + node) + i, column = 2 * (pn_a1 + other) + j;
                        if (row <= column) {
                            K[row][column] += weight * transverse[node].gradient[i] *
                                              transverse[other].gradient[j];
                        }
                    }
                }
            }
            add_stretch_second(transverse[node], 2 * (pn_a1 + node), K);
        }
        for (int j = 0; j < size; ++j) {
            const int column = planar_start[j / 2] + j % 2;
            for (int i = 0; i <= j; ++i) {
                const int row = planar_start[i / 2] + i % 2;
                tangent(row, column) = tangent(column, row) = K[i][j];
            }
        }
        for (int k = 0; k < 2; ++k) {
            for (int i = 2; i < dofs; ++i) tangent(i, k) = tangent(k, i) = -tangent(i, 6 + k);
        }
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < 2; ++k) tangent(i, k) = tangent(6 + i, 6 + k);
        }
    }

    template <class S>
    static void add_sine_second(const PlanarSine<S>& s, const S& f, int g, int a,
                                S (&K)[2 * planar_nodal_count][2 * planar_nodal_count]) noexcept {
        const S aa = f * s.inv_a, gg = f * s.inv_g, ga = f * s.inv_a * s.inv_g;
        for (int i = 0; i < 2; ++i) {
            for (int j = 0; j < 2; ++j) {
                const S delta(i == j ? 1.0 : 0.0);
                if (i <= j) {
                    K[a + i][a + j] -= aa * (s.u[i] * s.a[j] + s.a[i] * s.u[j] +
                                             s.value * s.inv_a * (delta - s.u[i] * s.u[j]));
                    K[g + i][g + j] -= gg * (s.t[i] * s.g[j] + s.g[i] * s.t[j] +
                                             s.value * s.inv_g * (delta - s.t[i] * s.t[j]));
                }
                K[g + i][a + j] +=
                    ga * (delta - s.u[i] * s.u[j] - s.t[i] * s.t[j] + s.value * s.t[i] * s.u[j]);
            }
        }
    }

    template <class S>
    void add_stretch_second(const TransverseTerm<S>& term, int a,
                            S (&K)[2 * planar_nodal_count][2 * planar_nodal_count]) const noexcept {
        const S share = term.stress * term.inverse;
        const bool green = transverse_measure == TransverseStrain::green;
        for (int j = 0; j < 2; ++j) {
            K[a + j][a + j] += share;
            for (int i = 0; i <= j && !green; ++i)
                K[a + i][a + j] -= share * term.gradient[i] * term.gradient[j];
        }
    }
};

}  // namespace ancf::detail
