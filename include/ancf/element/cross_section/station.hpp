// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// One station of a beam: directors, then measure, then section; and the way back to the nodes.
///
///     state:    nodal vectors -> local vectors -> invariants w -> strains e(w)
///               -> stresses sigma = C (e - e0)
///     gradient: sigma -> U = e_w^T sigma -> local vectors -> nodal vectors
///     Hessian:  D = e_w^T C e_w + sum sigma_i e_i,ww -> local blocks -> nodal blocks

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/cross_section/projected.hpp>
#include <ancf/element/cross_section/projected_hessian.hpp>
#include <ancf/element/cross_section/shear.hpp>
#include <ancf/element/cross_section/sparse_jacobian.hpp>
#include <ancf/element/invariants.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/element/station_data.hpp>

namespace ancf::detail {

/// Writes strains and stresses of the section; returns the energy.
template <class Measure, class Data, class S>
inline S section_energy(const Data& data, const Invariants<S>& w, S (&strain)[strain_count],
                        S (&stresses)[strain_count]) noexcept {
    Measure::strains(w, typename Measure::template Rates<S>(w), strain);
    for (int k = 0; k < strain_count; ++k) strain[k] = deformation(strain[k], data.reference[k]);
    stress<(1U << strain_count) - 1U>(data.stiffness, strain, stresses);
    S twice = strain[0] * stresses[0];
    for (int k = 1; k < strain_count; ++k) twice += strain[k] * stresses[k];
    return 0.5 * twice;
}

/// Writes the Hessian with respect to the invariants: symmetric, filled. Nodal shears take the
/// places of the station's.
template <class Measure, bool NodalShear, class Data, class S>
ANCF_NOINLINE void invariant_hessian(const Data& data, const Invariants<S>& w,
                                     const StrainJacobian<S>& J, const S (&stresses)[strain_count],
                                     InvariantHessian<S>& D) noexcept {
    material_hessian<Measure>(J, data.stiffness, D);
    Measure::add_curvature(w, typename Measure::template Rates<S>(w), stresses, D);
    const auto mirror = [&D](int first) noexcept {
        for (int i = first + 1; i < invariant_count; ++i) {
            for (int j = first; j < i; ++j) D[i][j] = D[j][i];
        }
    };
    if constexpr (NodalShear) {
        mirror(w_s);
        ANCF_UNROLL
        for (int i = w_s; i < invariant_count; ++i)
            shears_to_nodes(data.shape, D[w_s][i], D[w_s1][i], D[w_q][i], D[w_q1][i]);
        for (auto& row : D) shears_to_nodes(data.shape, row[w_s], row[w_s1], row[w_q], row[w_q1]);
    }
    mirror(0);
}

/// What a walk over the stations of an element does, for directors that are projected: functions of
/// six local vectors.
template <class Shear, class Measure>
struct LocalFormulation {
    static constexpr int line = 3;  ///< nodal vectors in the centre line

    template <class S>
    using Gradient = NodalGradient<S>;
    template <class S>
    using Hessian = NodalHessian<S>;
    /// Everything that a station's derivatives are made of.
    template <class S>
    struct State {
        ProjectedFrames<S> frames;
        typename Shear::template Station<S> shear;
        Invariants<S> w;
        S strain[strain_count];  ///< less the reference
        S stress[strain_count];  ///< times weight and length
        S U[invariant_count];    ///< written by gradient
        StrainJacobian<S> J;     ///< written by gradient
    };

    /// What is evaluated at the nodes.
    template <class S>
    struct Nodes {
        NodalSines<S> sines;
    };

    /// What stations need of it.
    template <class P>
    struct Lanes {
        P shears[shear_count];
    };

    template <class S, class P>
    static void prepare(const NodalVectors<S>& vectors, Nodes<S>& nodes, Lanes<P>& lanes) noexcept {
        if constexpr (Shear::nodal) {
            nodal_sines(vectors, nodes.sines);
            for (int m = 0; m < shear_count; ++m) lanes.shears[m] = P(nodes.sines[m].value);
        }
    }

    /// Writes invariants, strains and stresses; returns the energy.
    template <class T, class P>
    ANCF_NOINLINE static P state(const StationData<T>& data, const NodalVectors<P>& vectors,
                                 const Lanes<P>& lanes, State<P>& at) noexcept {
        LocalVectors<P> local;
        interpolate(data.shape, vectors, local);
        projected_frames(local, at.frames);
        projected_invariants(at.frames, at.w);
        Shear::shears(data.shape, lanes.shears, local, at.shear, at.w);
        return section_energy<Measure>(data, at.w, at.strain, at.stress);
    }

    /// Adds the gradient of the energy to the nodes.
    template <class T, class P>
    ANCF_NOINLINE static void gradient(const StationData<T>& data, State<P>& at,
                                       Gradient<P>& sums) noexcept {
        Measure::jacobian(at.w, typename Measure::template Rates<P>(at.w), at.J);
        energy_gradient<Measure>(at.J, at.stress, at.U);
        LocalGradient<P> local;
        projected_gradient(at.frames, at.U, local.vector);
        Shear::gradient(data.shape, at.shear, at.U, local);
        add_to_nodes(data.shape, local, sums);
    }

    /// Adds the Hessian of the energy to the nodes, after gradient().
    template <class T, class P>
    static void hessian(const StationData<T>& data, const State<P>& at,
                        Hessian<P>& blocks) noexcept {
        InvariantHessian<P> D;
        invariant_hessian<Measure, Shear::nodal>(data, at.w, at.J, at.stress, D);
        LocalHessian<P> local;
        projected_hessian(at.frames, at.w, at.U, D, local);
        if constexpr (!Shear::nodal) Shear::hessian(at.shear, at.U, local);
        add_to_nodes<Shear::nodal>(data.shape, local, blocks);
    }

    /// Adds what the nodal scalars mean for the gradient.
    template <class S>
    static void finish(const Nodes<S>& nodes, Gradient<S>& gradient) noexcept {
        if constexpr (Shear::nodal) add_sines(nodes.sines, gradient);
    }

    /// Sets F to what the nodal scalars mean for the tangent, before the gradient is finished.
    template <class P, class S>
    static void assign(const Nodes<S>& nodes, const Gradient<S>& gradient, const Hessian<P>& blocks,
                       const HalfTangent<S>& half) noexcept {
        if constexpr (Shear::nodal) {
            assign_sines(nodes.sines, gradient, blocks, half);
        } else {
            half.clear(n_D, nodal_count);
        }
    }
};

/// A station of the axial term alone.
template <class S>
struct AxialState {
    Vec3<S> p;
    S stress;  ///< times weight and length
};

template <class T, int Line, class S>
inline S axial_state(const AxialStationData<T, Line>& data, const NodalVectors<S, Line>& nodes,
                     AxialState<S>& at) noexcept {
    at.p = line_derivative(data.p, nodes);
    const S strain = deformation(S(0.5 * (dot(at.p, at.p) - 1.0)), data.reference);
    at.stress = data.stiffness * strain;
    return 0.5 * at.stress * strain;
}

template <class T, int Line, class S, int Scalars>
inline void axial_gradient(const AxialStationData<T, Line>& data, const AxialState<S>& at,
                           NodalGradient<S, Scalars, Line>& nodal) noexcept {
    for (int i = 0; i < Line; ++i)
        add(nodal.vector[line_vector(i)], S(data.p[i] * at.stress), at.p);
}

template <class T, int Line, class S, int Vectors, int Scalars>
inline void axial_hessian(const AxialStationData<T, Line>& data, const AxialState<S>& at,
                          NodalHessian<S, Vectors, Scalars>& nodal) noexcept {
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            S entry = data.stiffness * at.p[i] * at.p[j];
            if (i == j) entry += at.stress;
            for (int b = 0; b < Line; ++b) {
                const S weighted = data.p[b] * entry;
                for (int a = 0; a <= b; ++a) nodal(a, b)(i, j) += data.p[a] * weighted;
            }
        }
    }
}

}  // namespace ancf::detail
