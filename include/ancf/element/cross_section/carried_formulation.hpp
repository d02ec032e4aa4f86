// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The walk over stations with directors carried along the tangent: docs/theory-directors.md.
///
/// Eight scalars at the nodes stand beside the vectors: the shear sines of the four slopes, and the
/// spins of the four directors about the tangent.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/carried.hpp>
#include <ancf/element/carried_hessian.hpp>
#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/cross_section/nodal_tangent.hpp>
#include <ancf/element/cross_section/shear.hpp>
#include <ancf/element/cross_section/sparse_jacobian.hpp>
#include <ancf/element/cross_section/station.hpp>
#include <ancf/element/station_data.hpp>

#include <cmath>

namespace ancf {

namespace detail {

/// A director at a node with its spin as a form of the slope and the tangent.
template <class S>
struct NodalSpin : NodalForm<S> {
    NodalDirector<S> director;
};

template <class S>
inline NodalSpin<S> nodal_spin(const Vec3<S>& a, const Vec3<S>& g) noexcept {
    NodalSpin<S> spin;
    spin.director = nodal_director(g, a);
    const NodalDirector<S>& f = spin.director;
    for (int k = 0; k < 3; ++k) {
        spin.da[k] = f.inv_nu * f.c[k];
        spin.dg[k] = -f.al * f.inv_g * f.c[k];
    }
    return spin;
}

/// @tparam Measure  strains of the section
/// @tparam Angle    LinearAngle or ChordAngle
/// @tparam Line     number of nodal vectors in the centre line, 3 or 5
template <class Measure, class Angle, int Line = 3>
struct CarriedFormulation {
    static constexpr int line = Line;  ///< nodal vectors in the centre line
    static constexpr int scalars = 8;
    template <class S>
    using Gradient = NodalGradient<S, scalars, Line>;
    template <class S>
    using Hessian = NodalHessian<S, Line, scalars>;

    template <class S>
    struct Nodes {
        NodalSines<S> sines;
        NodalSpin<S> spins[4];  ///< y directors of both nodes, then z directors
    };

    template <class P>
    struct Lanes {
        P shears[shear_count];
        NodalDirector<P> y[2];
        P angle[2];  ///< from the y to the z director
    };

    template <class S>
    struct State {
        CarriedFrame<S, Angle> frame;
        Invariants<S> w;
        S strain[strain_count];  ///< less the reference
        S stress[strain_count];  ///< times weight and length
        S U[invariant_count];    ///< written by gradient
        StrainJacobian<S> J;     ///< written by gradient
    };

    template <class S, class P>
    static void prepare(const NodalVectors<S, Line>& vectors, Nodes<S>& nodes,
                        Lanes<P>& lanes) noexcept {
        nodal_sines(vectors, nodes.sines);
        for (int m = 0; m < 4; ++m) {
            nodes.spins[m] = nodal_spin(vectors[slope_of(m)], vectors[tangent_of(m)]);
            lanes.shears[m] = P(nodes.sines[m].value);
        }
        for (int node = 0; node < 2; ++node) {
            const NodalDirector<S>&y = nodes.spins[node].director,
                  &z = nodes.spins[2 + node].director;
            lanes.angle[node] = P(turn_angle(S(dot(y.n, z.n)), S(dot(y.c, z.n))));
            for (int k = 0; k < 3; ++k) {
                lanes.y[node].t[k] = P(y.t[k]);
                lanes.y[node].n[k] = P(y.n[k]);
            }
        }
    }

    template <class T, class P>
    ANCF_NOINLINE static P state(const StationData<T, Line>& data, const NodalVectors<P, Line>& n,
                                 const Lanes<P>& lanes, State<P>& at) noexcept {
        CarriedFrame<P, Angle>& f = at.frame;
        const StationShape<T, Line>& shape = data.shape;
        f.p = line_derivative(shape.p, n);
        f.p1 = line_derivative(shape.p1, n);
        f.g[0] = n[n_g1];
        f.g[1] = n[n_g2];
        f.n2 = P(shape.n2);
        f.n2_x = P(shape.n2_x);
        carried_invariants(lanes.y, lanes.angle, f, at.w);
        interpolate_shears(shape, lanes.shears, at.w);
        return section_energy<Measure>(data, at.w, at.strain, at.stress);
    }

    template <class T, class P>
    ANCF_NOINLINE static void gradient(const StationData<T, Line>& data, State<P>& at,
                                       Gradient<P>& sums) noexcept {
        const StationShape<T, Line>& shape = data.shape;
        Measure::jacobian(at.w, typename Measure::template Rates<P>(at.w), at.J);
        energy_gradient<Measure>(at.J, at.stress, at.U);
        Vec3<P> vector[carried_count];
        P spin[spin_count];
        carried_gradient(at.frame, at.U, vector, spin);
        for (int i = 0; i < Line; ++i) {
            add(sums.vector[line_vector(i)], shape.p[i], vector[v_p]);
            add(sums.vector[line_vector(i)], shape.p1[i], vector[v_p1]);
        }
        for (int k = 0; k < 3; ++k) {
            sums.vector[n_g1][k] += vector[v_g1][k];
            sums.vector[n_g2][k] += vector[v_g2][k];
        }
        P s[shear_count];
        for (int m = 0; m < shear_count; ++m) s[m] = at.U[w_s + m];
        shears_to_nodes(shape, s[0], s[1], s[2], s[3]);
        for (int m = 0; m < shear_count; ++m) sums.scalar[m] += s[m];
        for (int node = 0; node < 2; ++node) {
            sums.scalar[4 + node] += spin[spin_y1 + node] - spin[angle_1 + node];
            sums.scalar[6 + node] += spin[angle_1 + node];
        }
    }

    template <class T, class P>
    static void hessian(const StationData<T, Line>& data, const State<P>& at,
                        Hessian<P>& blocks) noexcept {
        InvariantHessian<P> D;
        invariant_hessian<Measure, true>(data, at.w, at.J, at.stress, D);
        CarriedHessian<P> local;
        carried_hessian(at.frame, at.U, D, local);
        add_blocks(data.shape, local, blocks);
        add_scalars(data.shape, local, blocks);
    }

    template <class S>
    static void finish(const Nodes<S>& nodes, Gradient<S>& gradient) noexcept {
        const NodalForm<S>* forms[scalars];
        list_forms(nodes, forms);
        add_forms(forms, gradient);
    }

    template <class P, class S>
    ANCF_NOINLINE static void assign(const Nodes<S>& nodes, const Gradient<S>& gradient,
                                     const Hessian<P>& blocks,
                                     const HalfTangent<S, dofs_with<Line>>& half) noexcept {
        const NodalForm<S>* forms[scalars];
        list_forms(nodes, forms);
        Vector<S, dofs_with<Line>> Z[scalars];
        form_columns(forms, blocks, Z);
        for (int m = 0; m < 4; ++m) add_sine_shares(nodes.sines[m], gradient.scalar[m], m, Z[m]);
        assign_columns(forms, Z, half);
        for (int m = 0; m < 4; ++m) {
            add_second(nodes.sines[m], gradient.scalar[m], tangent_of(m), slope_of(m), half);
            add_spin(nodes.spins[m].director, gradient.scalar[4 + m], m, half);
        }
    }

private:
    template <class S>
    static void list_forms(const Nodes<S>& nodes, const NodalForm<S>* (&forms)[scalars]) noexcept {
        for (int m = 0; m < 4; ++m) {
            forms[m] = &nodes.sines[m];
            forms[4 + m] = &nodes.spins[m];
        }
    }

    /// Adds the blocks of p, p1 and the nodal tangents.
    template <class T, class P>
    ANCF_NOINLINE static void add_blocks(const StationShape<T, Line>& shape,
                                         const CarriedHessian<P>& local, Hessian<P>& n) noexcept {
        add_line_blocks(shape, local(v_p, v_p), local(v_p, v_p1), local(v_p1, v_p1), n);
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) {
                ANCF_UNROLL
                for (int m = 0; m < 2; ++m) {
                    const int g = n_g1 + m;
                    const P pg = local(v_p, v_g1 + m)(i, j), vg = local(v_p1, v_g1 + m)(i, j);
                    ANCF_UNROLL
                    for (int a = 0; a < Line; ++a) {  // (D, g1, g2, k1, k2) with this tangent
                        const P with = shape.p[a] * pg + shape.p1[a] * vg;
                        if (a <= g) n(a, g)(i, j) += with;
                        if (a >= g) n(g, a)(j, i) += with;
                    }
                    n(g, g)(i, j) += local(v_g1 + m, v_g1 + m)(i, j);
                }
                n(n_g1, n_g2)(i, j) += local(v_g1, v_g2)(i, j);
            }
        }
    }

    /// Writes the row of derivatives by (sines, spins) from that by (spins y, angles, sines).
    template <class P>
    static void nodal_row(P (&row)[scalars]) noexcept {
        for (int node = 0; node < 2; ++node) {
            const P spin = row[spin_y1 + node], angle = row[angle_1 + node];
            row[spin_y1 + node] = row[4 + node], row[angle_1 + node] = row[6 + node];
            row[4 + node] = spin - angle;
            row[6 + node] = angle;
        }
    }

    template <class T, class P>
    ANCF_NOINLINE static void add_scalars(const StationShape<T, Line>& shape,
                                          const CarriedHessian<P>& local, Hessian<P>& n) noexcept {
        P row[scalars];
        for (int k = 0; k < 3; ++k) {
            for (int x = 0; x < carried_count; ++x) {
                for (int m = 0; m < scalars; ++m) row[m] = local.coupling[x][m][k];
                nodal_row(row);
                for (int m = 0; m < scalars; ++m) {
                    if (x >= v_g1) {
                        n.coupling[m][n_g1 + x - v_g1][k] += row[m];
                    } else {
                        for (int a = 0; a < Line; ++a)
                            n.coupling[m][a][k] += (x == v_p ? shape.p[a] : shape.p1[a]) * row[m];
                    }
                }
            }
        }
        P square[scalars][scalars];
        for (int m = 0; m < scalars; ++m) {
            for (int k = 0; k < scalars; ++k) row[k] = local.scalar[m][k];
            nodal_row(row);
            for (int k = 0; k < scalars; ++k) square[k][m] = row[k];
        }
        for (int k = 0; k < scalars; ++k) {
            nodal_row(square[k]);
            for (int m = 0; m < scalars; ++m) n.scalar[k][m] += square[k][m];
        }
    }

    /// Adds half of the symmetric second variation of a nodal spin.
    template <class S>
    static void add_spin(const NodalDirector<S>& director, const S& weight, int m,
                         const HalfTangent<S, dofs_with<Line>>& half) noexcept {
        constexpr int stride = dofs_with<Line>;
        const int g = tangent_of(m), a = slope_of(m);
        Block<S> gg{}, ga{}, aa{};
        add_nodal_spin(director, weight, gg, ga, aa);
        S *const to_gg = half.block(g, g), *const to_aa = half.block(a, a),
                 *const to_ga = half.block(g, a);
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) {
                to_gg[i + stride * j] += 0.5 * gg(i, j);
                to_aa[i + stride * j] += 0.5 * aa(i, j);
                to_ga[i + stride * j] += ga(i, j);
            }
        }
    }
};

/// Tells whether directors can be carried from both nodes to a station of tangent vector p, and
/// turned into each other: no turn is within `smallest` of 180 degrees.
template <int Vectors>
bool carriable(const Vec3<double> (&vectors)[Vectors], const Vec3<double>& p,
               double smallest) noexcept {
    const double square = dot(p, p);
    if (!(square > smallest * smallest)) return false;
    const Vec3<double> t = (1.0 / std::sqrt(square)) * p;
    const double least = 0.5 * smallest * smallest;  // of 1 + cos near 180 degrees
    NodalDirector<double> y[2], z[2];
    for (int node = 0; node < 2; ++node) {
        y[node] = nodal_director(vectors[n_g1 + node], vectors[n_a1 + node]);
        z[node] = nodal_director(vectors[n_g1 + node], vectors[n_b1 + node]);
        if (!(1.0 + dot(y[node].t, t) > least) || !(1.0 + dot(y[node].n, z[node].n) > least))
            return false;
    }
    return 1.0 + dot(carried(y[0], t), carried(y[1], t)) > least &&
           1.0 + dot(carried(z[0], t), carried(z[1], t)) > least;
}

}  // namespace detail

/// Directors carried from the nodes along the tangent, their angle interpolated:
/// docs/theory-directors.md.
struct Geodesic {};

/// Directors carried from the nodes along the tangent, interpolated as vectors:
/// docs/theory-directors.md.
struct Transported {};

}  // namespace ancf
