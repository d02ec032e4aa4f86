// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Energy, force and tangent of the torsion beam, station by station.
///
/// The directors and their calculus are those of docs/theory-directors.md with one director and no
/// shears: what varies at a station are lam, the curvatures kap and chi, and the twist rate om.
/// They depend on the vectors (D, g_i, g_j) and on the spins of the nodes' directors; the spins are
/// expanded in slopes and tangents once for an element.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/carried.hpp>
#include <ancf/element/carried_hessian.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/invariants.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/element/transport.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <type_traits>

namespace ancf::detail {

/// Where bending and torsion are integrated.
struct TorsionStation {
    StationShape<double> shape;
    double reference[3] = {};  ///< kap, chi, om of the stress-free state
    double stiffness[3][3];    ///< of (kap, chi, om), times weight and length

    /// Writes the strains (kap, chi, om) without those of the stress-free state, and their
    /// stresses.
    template <class S>
    void stresses(const Invariants<S>& w, S (&strain)[3], S (&stress)[3]) const noexcept {
        strain[0] = deformation(w.kap, reference[0]);
        strain[1] = deformation(w.chi, reference[1]);
        strain[2] = deformation(w.om, reference[2]);
        for (int i = 0; i < 3; ++i)
            stress[i] = stiffness[i][0] * strain[0] + stiffness[i][1] * strain[1] +
                        stiffness[i][2] * strain[2];
    }
};

/// What holds r_y normal to the tangent and of unit length at a node.
struct TorsionHold {
    double square = 1.0, along = 0.0;      ///< r_y.r_y and r_y.r_x of the stress-free state
    double stretching = 0.0, shear = 0.0;  ///< EA and k G A times half of the length

    /// Writes the strains of length and lean, and their stresses.
    template <class S>
    void stresses(const Vec3<S>& g, const Vec3<S>& a, S (&strain)[2],
                  S (&stress)[2]) const noexcept {
        strain[0] = 0.5 * deformation(S(dot(a, a)), square);
        strain[1] = deformation(S(dot(a, g)), along);
        stress[0] = stretching * strain[0];
        stress[1] = shear * strain[1];
    }
};

/// Places of the five nodal vectors that the energy depends on.
enum TorsionVector : int { tv_D, tv_g1, tv_g2, tv_a1, tv_a2, torsion_vectors };

/// Coordinates of a station: (D, g1, g2) and the two spins.
inline constexpr int torsion_line = 9, torsion_size = 11, torsion_local = 15;

template <class S>
using TorsionRow = Vector<S, torsion_size>;
template <class S>
using TorsionMatrix = Matrix<S, torsion_size>;

/// The geometry of a station with the variations of (kap, chi, om) as rows.
template <class S>
struct TorsionState {
    CarriedFrame<S> frame;
    Invariants<S> w;
    TorsionRow<S> kap, chi;  ///< at fixed spin
    TorsionRow<S> spin;      ///< of the director
    TorsionRow<S> rate[3];   ///< of kap, chi, om
};

/// The nodal vectors and directors of an element.
template <class S>
struct TorsionNodes {
    Vec3<S> vector[torsion_vectors];
    NodalDirector<S> y[2];

    explicit TorsionNodes(const Vector<S, 18>& e) noexcept {
        for (int k = 0; k < 3; ++k) {
            vector[tv_D][k] = e[9 + k] - e[k];
            for (int node = 0; node < 2; ++node) {
                vector[tv_g1 + node][k] = e[9 * node + 3 + k];
                vector[tv_a1 + node][k] = e[9 * node + 6 + k];
            }
        }
        for (int node = 0; node < 2; ++node)
            y[node] = nodal_director(vector[tv_g1 + node], vector[tv_a1 + node]);
    }
};

/// Returns the sum of the line's vectors (D, g1, g2) times their weights.
template <class S>
[[nodiscard]] inline Vec3<S> line_sum(const double (&weights)[3],
                                      const Vec3<S> (&vector)[torsion_vectors]) noexcept {
    return weights[0] * vector[tv_D] + weights[1] * vector[tv_g1] + weights[2] * vector[tv_g2];
}

/// Returns eps of a slope r0' at a station, without that of the stress-free state.
template <class S>
[[nodiscard]] inline S axial_strain(const AxialStationData<double>& station,
                                    const Vec3<S>& slope) noexcept {
    return deformation(S(0.5 * (dot(slope, slope) - 1.0)), station.reference);
}

/// No state before a correction.
struct NoState {};

/// Replaces stresses by those of a state before, linearised along its correction.
template <class S, int Count>
inline void predict(const Dual<S> (&before)[Count], S (&stress)[Count]) noexcept {
    for (int i = 0; i < Count; ++i) stress[i] = arrived(before[i]);
}

/// Writes a form of p and p1 as a row.
template <class S>
inline void set_line(const StationShape<double>& shape, const Vec3<S>& p, const Vec3<S>& p1,
                     TorsionRow<S>& row) noexcept {
    for (int a = 0; a < 3; ++a)
        for (int k = 0; k < 3; ++k) row[3 * a + k] = shape.p[a] * p[k] + shape.p1[a] * p1[k];
    row[torsion_line] = row[torsion_line + 1] = S(0.0);
}

/// Writes the frame of a station and (kap, chi, om) in w.
template <class S>
inline void torsion_frame(const StationShape<double>& shape, const TorsionNodes<S>& nodes,
                          CarriedFrame<S>& f, Invariants<S>& w) noexcept {
    f.p = line_sum(shape.p, nodes.vector);
    f.p1 = line_sum(shape.p1, nodes.vector);
    f.g[0] = nodes.vector[tv_g1];
    f.g[1] = nodes.vector[tv_g2];
    f.n2 = S(shape.n2);
    f.n2_x = S(shape.n2_x);
    const S aligned[2] = {S(0.0), S(0.0)};
    carried_invariants(nodes.y, aligned, f, w);
}

/// Writes frame and variations of a station.
template <class S>
ANCF_NOINLINE void torsion_state(const StationShape<double>& shape, const TorsionNodes<S>& nodes,
                                 TorsionState<S>& at) noexcept {
    CarriedFrame<S>& f = at.frame;
    torsion_frame(shape, nodes, f, at.w);
    Vec3<S> kap_p, kap_v, chi_p, chi_v, spin_p, rate_p, rate_v;
    const double part[2] = {1.0 - shape.n2, shape.n2};
    for (int k = 0; k < 3; ++k) {
        kap_p[k] = -f.inv_lam * (f.kap * f.t[k] + f.eta * f.n[k]);
        chi_p[k] = -f.inv_lam * (f.chi * f.t[k] + f.eta * f.c[k]);
        kap_v[k] = f.inv_lam * f.n[k];
        chi_v[k] = f.inv_lam * f.c[k];
        spin_p[k] = part[0] * f.from[0].sp[k] + part[1] * f.from[1].sp[k];
        rate_p[k] = part[0] * f.from[0].dF[t_p][k] + part[1] * f.from[1].dF[t_p][k] +
                    shape.n2_x * (f.from[1].sp[k] - f.from[0].sp[k]);
        rate_v[k] = part[0] * f.from[0].dF[t_p1][k] + part[1] * f.from[1].dF[t_p1][k];
    }
    const Vec3<S> none{{S(0.0), S(0.0), S(0.0)}};
    set_line(shape, kap_p, kap_v, at.kap);
    set_line(shape, chi_p, chi_v, at.chi);
    set_line(shape, spin_p, none, at.spin);
    set_line(shape, rate_p, rate_v, at.rate[2]);
    for (int node = 0; node < 2; ++node) {
        const double sign = node == 0 ? -1.0 : 1.0;
        for (int k = 0; k < 3; ++k) {
            const int g = 3 * (tv_g1 + node) + k;
            at.spin[g] += part[node] * f.from[node].sg[k];
            at.rate[2][g] +=
                part[node] * f.from[node].dF[t_g][k] + sign * shape.n2_x * f.from[node].sg[k];
        }
        at.spin[torsion_line + node] = S(part[node]);
        at.rate[2][torsion_line + node] = S(sign * shape.n2_x);
    }
    at.rate[0] = at.kap + f.chi * at.spin;
    at.rate[1] = at.chi - f.kap * at.spin;
}

/// Adds the blocks of a station's second variation beyond products of forms.
template <class S>
ANCF_NOINLINE void add_torsion_curvature(const StationShape<double>& shape,
                                         const CarriedFrame<S>& f, const S (&U)[3],
                                         TorsionMatrix<S>& K) noexcept {
    S weights[invariant_count];
    for (S& weight : weights) weight = S(0.0);
    weights[w_kap] = U[0];
    weights[w_chi] = U[1];
    weights[w_om] = U[2];
    CarriedHessian<S> h;
    for (Block<S>* block : {&h(v_p, v_p), &h(v_p, v_p1)})
        for (S& value : block->v) value = S(0.0);
    add_line_curvature(f, weights, h);
    const SpinWeights<S> w = spin_weights(f, weights);
    for (int m = 0; m < 2; ++m) {
        Block<S> gg{}, gp{}, gv{};
        add_transport_hessian(f.from[m], f.g[m], f.p, f.p1, f.lam, f.t, w.F[m], w.spin[m], gg, gp,
                              gv, h(v_p, v_p), h(v_p, v_p1));
        const int g = 3 * (tv_g1 + m);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                K(g + i, g + j) += gg(i, j);
                for (int a = 0; a < 3; ++a) {
                    const S value = shape.p[a] * gp(i, j) + shape.p1[a] * gv(i, j);
                    K(g + i, 3 * a + j) += value;
                    K(3 * a + j, g + i) += value;
                }
            }
    }
    const Block<S>&pp = h(v_p, v_p), &pv = h(v_p, v_p1);
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    K(3 * a + i, 3 * b + j) += shape.p[a] * shape.p[b] * pp(i, j) +
                                               shape.p[a] * shape.p1[b] * pv(i, j) +
                                               shape.p1[a] * shape.p[b] * pv(j, i);
}

/// Where the local coordinates (D, g1, g2, a1, a2) stand among the element's; D takes the second
/// node's position, the first node's is its negative.
inline constexpr int torsion_place[torsion_local] = {9,  10, 11, 3, 4,  5,  12, 13,
                                                     14, 6,  7,  8, 15, 16, 17};

/// The constant data of an element, and the walk over its stations.
struct TorsionKernel {
    static constexpr int dimension = 3, dofs = 18;

    List<AxialStationData<double>> axial;
    List<TorsionStation> stations;
    TorsionHold holds[2];

    /// Takes the strains of a state as those of the stress-free state.
    void set_reference(const Vector<double, 18>& e) noexcept {
        const TorsionNodes<double> nodes(e);
        for (AxialStationData<double>& station : axial)
            station.reference += axial_strain(station, line_sum(station.p, nodes.vector));
        for (TorsionStation& station : stations) {
            CarriedFrame<double> f;
            Invariants<double> w;
            torsion_frame(station.shape, nodes, f, w);
            station.reference[0] = w.kap;
            station.reference[1] = w.chi;
            station.reference[2] = w.om;
        }
        for (int node = 0; node < 2; ++node) {
            const Vec3<double>&g = nodes.vector[tv_g1 + node], &a = nodes.vector[tv_a1 + node];
            holds[node].square = dot(a, a);
            holds[node].along = dot(a, g);
        }
    }

    template <class S>
    [[nodiscard]] S energy(const Vector<S, 18>& e) const noexcept;
    template <class S>
    [[nodiscard]] Vector<S, 18> force(const Vector<S, 18>& e) const noexcept;
    template <class S>
    [[nodiscard]] Evaluation<S, 18> evaluate(const Vector<S, 18>& e) const noexcept;
    /// As LineElement::evaluate() of a state and the correction that led to it.
    template <class S>
    [[nodiscard]] MixedEvaluation<S, 18> evaluate(const Vector<S, 18>& e,
                                                  const Vector<S, 18>& before,
                                                  const Vector<S, 18>& change) const noexcept {
        const TorsionNodes<S> nodes(e);
        const TorsionNodes<Dual<S>> along(course(before, change));
        Local<S> local = Local<S>::Zero();
        LocalMatrix<S> tangent = LocalMatrix<S>::Zero();
        MixedEvaluation<S, 18> result;
        result.energy = walk<true>(nodes, along, local, tangent);
        result.force = force(e);
        expand(local, result.predicted);
        expand(tangent, result.tangent);
        return result;
    }

private:
    template <class S>
    using Local = Vector<S, torsion_local>;
    template <class S>
    using LocalMatrix = Matrix<S, torsion_local>;

    /// Adds the forces and tangents of all stations and nodes; returns the energy.
    /// @param before  NoState, or the nodes of a state before as Dual numbers along its correction:
    ///                forces and tangents have its stresses then
    template <bool WithTangent, class S, class Before>
    S walk(const TorsionNodes<S>& nodes, const Before& before, Local<S>& force,
           LocalMatrix<S>& tangent) const noexcept {
        S energy = add_axial<WithTangent>(nodes, before, force, tangent) +
                   add_holds<WithTangent>(nodes, before, force, tangent);
        TorsionRow<S> sum = TorsionRow<S>::Zero();
        [[maybe_unused]] TorsionMatrix<S> K;
        if constexpr (WithTangent) K.setZero();
        for (const TorsionStation& station : stations) {
            TorsionState<S> at;
            torsion_state(station.shape, nodes, at);
            S strain[3], U[3];
            station.stresses(at.w, strain, U);
            for (int i = 0; i < 3; ++i) energy += 0.5 * U[i] * strain[i];
            if constexpr (!std::is_same_v<Before, NoState>) {
                CarriedFrame<Dual<S>> f;
                Invariants<Dual<S>> w;
                Dual<S> earlier[3], of_earlier[3];
                torsion_frame(station.shape, before, f, w);
                station.stresses(w, earlier, of_earlier);
                predict(of_earlier, U);
            }
            for (int i = 0; i < 3; ++i) sum += U[i] * at.rate[i];
            if constexpr (WithTangent) {
                // kap and chi are coupled, om stands alone
                const TorsionRow<S> moment[3] = {S(station.stiffness[0][0]) * at.rate[0] +
                                                     S(station.stiffness[0][1]) * at.rate[1],
                                                 S(station.stiffness[1][0]) * at.rate[0] +
                                                     S(station.stiffness[1][1]) * at.rate[1],
                                                 S(station.stiffness[2][2]) * at.rate[2]};
                for (int i = 0; i < 3; ++i) K += at.rate[i] * moment[i].transpose();
                // 2 th (U_kap d chi - U_chi d kap) - th^2 (kap U_kap + chi U_chi)
                const TorsionRow<S> turning =
                    U[0] * at.chi - U[1] * at.kap -
                    S(0.5 * (at.frame.kap * U[0] + at.frame.chi * U[1])) * at.spin;
                K += at.spin * turning.transpose() + turning * at.spin.transpose();
                add_torsion_curvature(station.shape, at.frame, U, K);
            }
        }
        Local<S> forms[2];
        add_spins(nodes, sum, forms, force);
        if constexpr (WithTangent) add_spin_tangent(nodes, sum, K, forms, tangent);
        return energy;
    }
    template <bool WithTangent, class S, class Before>
    S add_axial(const TorsionNodes<S>& nodes, const Before& before, Local<S>& force,
                LocalMatrix<S>& tangent) const noexcept {
        S energy(0.0);
        for (const AxialStationData<double>& station : axial) {
            const Vec3<S> p = line_sum(station.p, nodes.vector);
            const S strain = axial_strain(station, p);
            S stress = station.stiffness * strain;
            energy += 0.5 * stress * strain;
            if constexpr (!std::is_same_v<Before, NoState>) {
                const auto earlier = axial_strain(station, line_sum(station.p, before.vector));
                stress = station.stiffness * arrived(earlier);
            }
            for (int a = 0; a < 3; ++a)
                for (int i = 0; i < 3; ++i) force[3 * a + i] += station.p[a] * stress * p[i];
            if constexpr (WithTangent) {
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) {
                        S value = station.stiffness * p[i] * p[j];
                        if (i == j) value += stress;
                        for (int a = 0; a < 3; ++a)
                            for (int b = 0; b < 3; ++b)
                                tangent(3 * a + i, 3 * b + j) +=
                                    station.p[a] * station.p[b] * value;
                    }
            }
        }
        return energy;
    }
    template <bool WithTangent, class S, class Before>
    S add_holds(const TorsionNodes<S>& nodes, const Before& before, Local<S>& force,
                LocalMatrix<S>& tangent) const noexcept {
        S energy(0.0);
        for (int node = 0; node < 2; ++node) {
            const TorsionHold& hold = holds[node];
            const int g_at = 3 * (tv_g1 + node), a_at = 3 * (tv_a1 + node);
            const Vec3<S>&g = nodes.vector[tv_g1 + node], &a = nodes.vector[tv_a1 + node];
            S strain[2], stress[2];
            hold.stresses(g, a, strain, stress);
            energy += 0.5 * (stress[0] * strain[0] + stress[1] * strain[1]);
            if constexpr (!std::is_same_v<Before, NoState>) {
                Dual<S> earlier[2], of_earlier[2];
                hold.stresses(before.vector[tv_g1 + node], before.vector[tv_a1 + node], earlier,
                              of_earlier);
                predict(of_earlier, stress);
            }
            const S N = stress[0], Q = stress[1];
            for (int i = 0; i < 3; ++i) {
                force[a_at + i] += N * a[i] + Q * g[i];
                force[g_at + i] += Q * a[i];
                if constexpr (WithTangent) {
                    tangent(a_at + i, a_at + i) += N;
                    tangent(a_at + i, g_at + i) += Q;
                    tangent(g_at + i, a_at + i) += Q;
                    for (int j = 0; j < 3; ++j) {
                        tangent(a_at + i, a_at + j) +=
                            hold.stretching * a[i] * a[j] + hold.shear * g[i] * g[j];
                        tangent(a_at + i, g_at + j) += hold.shear * g[i] * a[j];
                        tangent(g_at + i, a_at + j) += hold.shear * a[i] * g[j];
                        tangent(g_at + i, g_at + j) += hold.shear * a[i] * a[j];
                    }
                }
            }
        }
        return energy;
    }
    /// Writes what an element returns.
    template <class S>
    static void expand(const Local<S>& local, Vector<S, 18>& force) noexcept {
        for (int i = 0; i < torsion_local; ++i) force[torsion_place[i]] = local[i];
        for (int k = 0; k < 3; ++k) force[k] = -local[k];
    }
    template <class S>
    static void expand(const LocalMatrix<S>& local, Matrix<S, 18>& tangent) noexcept {
        for (int i = 0; i < torsion_local; ++i)
            for (int j = 0; j < torsion_local; ++j)
                tangent(torsion_place[i], torsion_place[j]) = local(i, j);
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < torsion_local; ++i) {
                tangent(k, torsion_place[i]) = -local(k, i);
                tangent(torsion_place[i], k) = -local(i, k);
            }
            for (int j = 0; j < 3; ++j) tangent(k, j) = local(k, j);
        }
    }
    /// Adds the force, and writes the variations of the nodes' spins.
    template <class S>
    static void add_spins(const TorsionNodes<S>& nodes, const TorsionRow<S>& force,
                          Local<S> (&forms)[2], Local<S>& to_force) noexcept {
        to_force.template head<torsion_line>() += force.template head<torsion_line>();
        for (int node = 0; node < 2; ++node) {
            const NodalDirector<S>& y = nodes.y[node];
            forms[node].setZero();
            for (int k = 0; k < 3; ++k) {
                forms[node][3 * (tv_a1 + node) + k] = y.inv_nu * y.c[k];
                forms[node][3 * (tv_g1 + node) + k] = -y.al * y.inv_g * y.c[k];
            }
            to_force += force[torsion_line + node] * forms[node];
        }
    }
    template <class S>
    static void add_spin_tangent(const TorsionNodes<S>& nodes, const TorsionRow<S>& force,
                                 const TorsionMatrix<S>& K, const Local<S> (&forms)[2],
                                 LocalMatrix<S>& tangent) noexcept {
        tangent.template topLeftCorner<torsion_line, torsion_line>() +=
            K.template topLeftCorner<torsion_line, torsion_line>();
        for (int node = 0; node < 2; ++node) {
            const int column = torsion_line + node;
            Local<S> z = S(0.5) * (K(torsion_line, column) * forms[0] +
                                   K(torsion_line + 1, column) * forms[1]);
            for (int i = 0; i < torsion_line; ++i) z[i] += K(i, column);
            for (const int vector : {tv_g1 + node, tv_a1 + node})  // where the form is not zero
                for (int j = 3 * vector; j < 3 * vector + 3; ++j)
                    for (int i = 0; i < torsion_local; ++i) {
                        const S value = z[i] * forms[node][j];
                        tangent(i, j) += value;
                        tangent(j, i) += value;
                    }
            Block<S> gg{}, ga{}, aa{};
            add_nodal_spin(nodes.y[node], force[column], gg, ga, aa);
            const int g = 3 * (tv_g1 + node), a = 3 * (tv_a1 + node);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) {
                    tangent(g + i, g + j) += gg(i, j);
                    tangent(a + i, a + j) += aa(i, j);
                    tangent(g + i, a + j) += ga(i, j);
                    tangent(a + j, g + i) += ga(i, j);
                }
        }
    }
};

template <class S>
S TorsionKernel::energy(const Vector<S, 18>& e) const noexcept {
    const TorsionNodes<S> nodes(e);
    Local<S> force = Local<S>::Zero();
    LocalMatrix<S> unused;
    S sum = add_axial<false>(nodes, NoState(), force, unused) +
            add_holds<false>(nodes, NoState(), force, unused);
    for (const TorsionStation& station : stations) {
        CarriedFrame<S> f;
        Invariants<S> w;
        torsion_frame(station.shape, nodes, f, w);
        S strain[3], stress[3];
        station.stresses(w, strain, stress);
        for (int i = 0; i < 3; ++i) sum += 0.5 * stress[i] * strain[i];
    }
    return sum;
}

template <class S>
Vector<S, 18> TorsionKernel::force(const Vector<S, 18>& e) const noexcept {
    const TorsionNodes<S> nodes(e);
    Local<S> local = Local<S>::Zero();
    LocalMatrix<S> unused;
    (void)walk<false>(nodes, NoState(), local, unused);
    Vector<S, 18> result;
    expand(local, result);
    return result;
}

template <class S>
Evaluation<S, 18> TorsionKernel::evaluate(const Vector<S, 18>& e) const noexcept {
    const TorsionNodes<S> nodes(e);
    Local<S> local = Local<S>::Zero();
    LocalMatrix<S> tangent = LocalMatrix<S>::Zero();
    Evaluation<S, 18> result;
    result.energy = walk<true>(nodes, NoState(), local, tangent);
    expand(local, result.force);
    expand(tangent, result.tangent);
    return result;
}

}  // namespace ancf::detail
