// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The evaluation of a cross-section beam: constant data and the walk over stations.
///
/// Double precision walks over packs of stations, as many side by side as the target's registers
/// hold; any other scalar walks over single stations. T is double, or a pack that holds the data of
/// several elements.

#pragma once

#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/cross_section/nodal_tangent.hpp>
#include <ancf/element/cross_section/shear.hpp>
#include <ancf/element/cross_section/station.hpp>
#include <ancf/element/cross_section/transverse.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <type_traits>

namespace ancf::detail {

/// Constant data of an element, and what follows from nodal coordinates.
template <class T, class Formulation>
struct CrossSectionKernel {
    static constexpr int line = Formulation::line;  ///< nodal vectors in the centre line
    static constexpr int dimension = 3, dofs = dofs_with<line>;

    StationTable<T, line> stations;
    StationTable<Pack<native_lanes>, line> packs;  ///< again, side by side; used where T is double
    TransverseData<T> transverse;
    TransverseStrain transverse_measure = TransverseStrain::green;

    /// Makes e the stress-free state: its strains are the ones subtracted from now on.
    void set_reference(const Vector<double, dofs>& e) {
        Nodes<double> nodes;
        Lanes<double> lanes;
        prepare(e, nodes, lanes);
        for (StationData<T, line>& station : stations.full) {
            At<double> at;
            (void)Formulation::state(station, lanes.vectors, lanes.scalars, at);
            for (int k = 0; k < strain_count; ++k) station.reference[k] += at.strain[k];
        }
        for (AxialStationData<T, line>& station : stations.axial) {
            AxialState<double> at;
            (void)axial_state(station, lanes.vectors, at);
            station.reference += at.stress / station.stiffness;
        }
        for (int node = 0; node < 2; ++node) {
            const Vec3<double>&a = nodes.vectors[n_a1 + node], &b = nodes.vectors[n_b1 + node];
            transverse.reference[0][node] = stretch_strain(transverse_measure, a).value;
            transverse.reference[1][node] = stretch_strain(transverse_measure, b).value;
            transverse.reference[2][node] = dot(a, b);
        }
        packs = packed<native_lanes>(stations);
    }

    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& e) const noexcept;
    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e) const noexcept;
    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept;

    /// As LineElement::evaluate() of a state and the correction that led to it.
    template <class S>
    [[nodiscard]] MixedEvaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                                    const Vector<S, dofs>& before,
                                                    const Vector<S, dofs>& change) const noexcept {
        return pass<S, true>(e, &before, &change);
    }

    /// Returns B^T C dB/dt of the coordinates e + t v.
    [[nodiscard]] Matrix<double, dofs> rate_coupling(const Vector<double, dofs>& e,
                                                     const Vector<double, dofs>& v) const noexcept {
        using P = Rate<Pack<2>>;
        using Sums = typename Formulation::template Gradient<P>;
        Nodes<P> nodes;
        Lanes<P> lanes;
        prepare(moving<Pack<2>>(e, v), nodes, lanes);
        Matrix<double, strain_count, dofs> B, rate, weighted;  // of some strains; weighted: C B
        const auto write = [&](Sums& gradient, int k) {
            Formulation::finish(nodes.scalars, gradient);
            Vector<P, dofs> row;
            expand(gradient, row);
            for (int i = 0; i < dofs; ++i)
                for (const int lane : {0, 1}) {
                    B(k + lane, i) = row[i].value[lane];
                    rate(k + lane, i) = row[i].rate[lane];
                }
        };
        Matrix<double, dofs> sum = Matrix<double, dofs>::Zero();
        P units[2] = {P(0.0), P(0.0)};  // of a strain in one lane and of the next in the other
        for (const int lane : {0, 1}) units[lane].value.set(lane, 1.0);
        for (const StationData<T, line>& station : stations.full) {
            At<P> at;
            (void)Formulation::state(station, lanes.vectors, lanes.scalars, at);
            for (int k = 0; k < strain_count; k += 2) {
                std::fill_n(at.stress, strain_count, P(0.0));
                std::copy_n(units, 2, at.stress + k);
                Sums gradient{};
                Formulation::gradient(station, at, gradient);
                write(gradient, k);
            }
            for (int i = 0; i < dofs; ++i)
                stress<(1U << strain_count) - 1U>(station.stiffness, B.col(i).data(),
                                                  weighted.col(i).data());
            for (int j = 0; j < dofs; ++j)
                for (int i = 0; i < dofs; ++i) sum(i, j) += weighted.col(i).dot(rate.col(j));
        }
        for (const AxialStationData<T, line>& station : stations.axial) {
            Sums gradient{};
            axial_gradient(station,
                           {line_derivative(station.p, lanes.vectors), P(station.stiffness)},
                           gradient);
            write(gradient, 0);
            sum += B.row(0).transpose().lazyProduct(rate.row(0)) / station.stiffness;
        }
        for (int k = 0; k < 3; ++k) {
            std::fill_n(&nodes.transverse.stress[0][0], 6, P(0.0));
            std::copy_n(units, 2, nodes.transverse.stress[k]);
            Sums gradient{};
            add_transverse(nodes.transverse, nodes.vectors, gradient);
            write(gradient, 0);
            for (const int node : {0, 1})
                sum += (transverse.stiffness[k] / 6.0 *
                        (B.row(0) + B.row(1) + B.row(node)).transpose())
                           .lazyProduct(rate.row(node));
        }
        return sum;
    }

private:
    /// The scalar that stations are evaluated with.
    template <class S>
    using Lane =
        std::conditional_t<std::is_same_v<S, double> && (native_lanes > 1), Pack<native_lanes>, S>;

    template <class P>
    using At = typename Formulation::template State<P>;

    /// Nodal vectors and what is evaluated at the nodes.
    template <class S>
    struct Nodes {
        NodalVectors<S, line> vectors;
        typename Formulation::template Nodes<S> scalars;
        TransverseState<S> transverse;
    };

    /// The same in every lane, as far as stations need it.
    template <class P>
    struct Lanes {
        NodalVectors<P, line> vectors;
        typename Formulation::template Lanes<P> scalars;
    };

    /// Returns the stations that the scalar P walks over.
    template <class P, class S>
    [[nodiscard]] const auto& table() const noexcept {
        if constexpr (std::is_same_v<P, S>) {
            return stations;
        } else {
            return packs;
        }
    }

    /// Writes what is evaluated at the nodes, from their vectors, and what stations need of it.
    template <class P, class S>
    void prepare(Nodes<S>& nodes, Lanes<P>& lanes) const noexcept {
        for (int x = 0; x < vectors_with<line>; ++x) {
            for (int k = 0; k < 3; ++k) lanes.vectors[x][k] = P(nodes.vectors[x][k]);
        }
        Formulation::prepare(nodes.vectors, nodes.scalars, lanes.scalars);
        transverse_state(transverse, transverse_measure, nodes.vectors, nodes.transverse);
    }

    template <class P, class S>
    void prepare(const Vector<S, dofs>& e, Nodes<S>& nodes, Lanes<P>& lanes) const noexcept {
        nodal_vectors(e, nodes.vectors);
        prepare(nodes, lanes);
    }

    /// The state before a change of coordinates, linearised along it.
    template <class S, class P>
    struct Linearised {
        Nodes<Dual<S>> nodes;
        Lanes<Dual<P>> lanes;
    };

    /// Writes the linearised stresses of a station.
    template <class Station, class S, class P>
    ANCF_NOINLINE static void predict(const Station& station, const Linearised<S, P>& before,
                                      P (&stresses)[strain_count]) noexcept {
        At<Dual<P>> at;
        (void)Formulation::state(station, before.lanes.vectors, before.lanes.scalars, at);
        for (int k = 0; k < strain_count; ++k) stresses[k] = arrived(at.stress[k]);
    }
    template <class Station, class S, class P>
    static void predict(const Station& station, const Linearised<S, P>& before,
                        P& stress) noexcept {
        AxialState<Dual<P>> at;
        (void)axial_state(station, before.lanes.vectors, at);
        stress = arrived(at.stress);
    }

    template <class S, bool Mixed>
    [[nodiscard]] auto pass(const Vector<S, dofs>& e, const Vector<S, dofs>* from,
                            const Vector<S, dofs>* change) const noexcept {
        using P = Lane<S>;
        Nodes<S> nodes;
        Lanes<P> lanes;
        prepare(e, nodes, lanes);
        [[maybe_unused]] std::conditional_t<Mixed, Linearised<S, P>, char> before;
        if constexpr (Mixed) prepare(course(*from, *change), before.nodes, before.lanes);
        typename Formulation::template Gradient<P> sums{};
        [[maybe_unused]] typename Formulation::template Gradient<P> predicted{};
        typename Formulation::template Hessian<P> blocks{};
        P sum(0.0);
        for (const auto& station : table<P, S>().full) {
            At<P> at;
            sum += Formulation::state(station, lanes.vectors, lanes.scalars, at);
            Formulation::gradient(station, at, sums);
            if constexpr (Mixed) {
                predict(station, before, at.stress);
                Formulation::gradient(station, at, predicted);
            }
            Formulation::hessian(station, at, blocks);
        }
        for (const auto& station : table<P, S>().axial) {
            AxialState<P> at;
            sum += axial_state(station, lanes.vectors, at);
            axial_gradient(station, at, sums);
            if constexpr (Mixed) {
                predict(station, before, at.stress);
                axial_gradient(station, at, predicted);
            }
            axial_hessian(station, at, blocks);
        }
        typename Formulation::template Gradient<S> gradient;
        [[maybe_unused]] typename Formulation::template Gradient<S> weights;
        sum_lanes(sums, gradient);
        if constexpr (Mixed) sum_lanes(predicted, weights);
        std::conditional_t<Mixed, MixedEvaluation<S, dofs>, Evaluation<S, dofs>> result;
        result.energy = nodes.transverse.energy + collapsed<S>(sum);
        const HalfTangent<S, dofs> half(result.tangent);
        Formulation::assign(nodes.scalars, Mixed ? weights : gradient, blocks, half);
        Formulation::finish(nodes.scalars, gradient);
        add_transverse(nodes.transverse, nodes.vectors, gradient);
        if constexpr (Mixed) {
            detail::predict(before.nodes.transverse, nodes.transverse);
            Formulation::finish(nodes.scalars, weights);
            add_transverse(nodes.transverse, nodes.vectors, weights);
            expand(weights, result.predicted);
        }
        add_transverse(transverse, transverse_measure, nodes.transverse, nodes.vectors, half);
        half.finish(blocks);
        expand(gradient, result.force);
        return result;
    }
};

template <class T, class Formulation>
template <class S>
S CrossSectionKernel<T, Formulation>::energy(const Vector<S, dofs>& e) const noexcept {
    using P = Lane<S>;
    Nodes<S> nodes;
    Lanes<P> lanes;
    prepare(e, nodes, lanes);
    P sum(0.0);
    for (const auto& station : table<P, S>().full) {
        At<P> at;
        sum += Formulation::state(station, lanes.vectors, lanes.scalars, at);
    }
    for (const auto& station : table<P, S>().axial) {
        AxialState<P> at;
        sum += axial_state(station, lanes.vectors, at);
    }
    return nodes.transverse.energy + collapsed<S>(sum);
}

template <class T, class Formulation>
template <class S>
auto CrossSectionKernel<T, Formulation>::force(const Vector<S, dofs>& e) const noexcept
    -> Vector<S, dofs> {
    using P = Lane<S>;
    Nodes<S> nodes;
    Lanes<P> lanes;
    prepare(e, nodes, lanes);
    typename Formulation::template Gradient<P> sums{};
    for (const auto& station : table<P, S>().full) {
        At<P> at;
        (void)Formulation::state(station, lanes.vectors, lanes.scalars, at);
        Formulation::gradient(station, at, sums);
    }
    for (const auto& station : table<P, S>().axial) {
        AxialState<P> at;
        (void)axial_state(station, lanes.vectors, at);
        axial_gradient(station, at, sums);
    }
    typename Formulation::template Gradient<S> gradient;
    sum_lanes(sums, gradient);
    add_transverse(nodes.transverse, nodes.vectors, gradient);
    Formulation::finish(nodes.scalars, gradient);
    Vector<S, dofs> force;
    expand(gradient, force);
    return force;
}

template <class T, class Formulation>
template <class S>
auto CrossSectionKernel<T, Formulation>::evaluate(const Vector<S, dofs>& e) const noexcept
    -> Evaluation<S, dofs> {
    return pass<S, false>(e, nullptr, nullptr);
}

}  // namespace ancf::detail
