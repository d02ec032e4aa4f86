// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam's energy, force and tangent: the walk over its stations.

#pragma once

#include <ancf/element/continuum/kernel.hpp>
#include <ancf/element/continuum/nodes.hpp>
#include <ancf/element/continuum/tangent.hpp>
#include <ancf/element/dual.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/types.hpp>

#include <vector>

namespace ancf::detail::continuum {

/// The stations of an element, and what they add up to.
template <int Dimension>
struct Kernel {
    static constexpr int dimension = Dimension, dofs = 2 * Dimension * (Dimension + 1);

    std::vector<Station<Dimension>> stations;
    std::vector<AxialStation> axial;  ///< of a rule that treats E A eps^2/2 apart

    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& e) const noexcept;

    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e) const noexcept;

    /// Returns B(e)^T C s, s the strains of other coordinates.
    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e,
                                        const Vector<S, dofs>& strained) const noexcept;

    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept;

    /// Returns the same with a tangent whose geometric part has the stresses C (s + B change) of a
    /// state before.
    template <class S>
    [[nodiscard]] MixedEvaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                                    const Vector<S, dofs>& before,
                                                    const Vector<S, dofs>& change) const noexcept;
};

template <int Dimension>
template <class S>
auto Kernel<Dimension>::energy(const Vector<S, dofs>& e) const noexcept -> S {
    const Nodes<S, Dimension> nodes(e);
    Force<S, Dimension> sum;
    for (const AxialStation& station : axial) {
        const Vector<S, Dimension> p = nodes.tangent_at(station.tangent);
        add_axial_force(station, p, p, sum);
    }
    for (const Station<Dimension>& station : stations)
        sum.energy += station_energy(station, nodes.at(station.xi, station.tangent));
    return sum.energy;
}

template <int Dimension>
template <class S>
auto Kernel<Dimension>::force(const Vector<S, dofs>& e) const noexcept -> Vector<S, dofs> {
    return force(e, e);
}

template <int Dimension>
template <class S>
auto Kernel<Dimension>::force(const Vector<S, dofs>& e,
                              const Vector<S, dofs>& strained) const noexcept -> Vector<S, dofs> {
    const Nodes<S, Dimension> nodes(e), of(strained);
    Force<S, Dimension> sum;
    for (const AxialStation& station : axial)
        add_axial_force(station, nodes.tangent_at(station.tangent), of.tangent_at(station.tangent),
                        sum);
    for (const Station<Dimension>& station : stations)
        add_force(station, nodes.at(station.xi, station.tangent),
                  of.at(station.xi, station.tangent), sum);
    return nodal_force(sum);
}

template <int Dimension>
template <class S>
auto Kernel<Dimension>::evaluate(const Vector<S, dofs>& e) const noexcept -> Evaluation<S, dofs> {
    const Nodes<S, Dimension> nodes(e);
    Force<S, Dimension> sum;
    Tangent<S, Dimension> tangent;
    for (const AxialStation& station : axial) {
        const Vector<S, Dimension> p = nodes.tangent_at(station.tangent);
        add_axial_tangent(station, p, add_axial_force(station, p, p, sum), tangent);
    }
    for (const Station<Dimension>& station : stations) {
        const Vectors<S, Dimension> v = nodes.at(station.xi, station.tangent);
        add_tangent(station, v, add_force(station, v, v, sum), tangent);
    }
    Evaluation<S, dofs> result;
    result.energy = sum.energy;
    result.force = nodal_force(sum);
    write_tangent(tangent, result.tangent);
    return result;
}

template <int Dimension>
template <class S>
auto Kernel<Dimension>::evaluate(const Vector<S, dofs>& e, const Vector<S, dofs>& before,
                                 const Vector<S, dofs>& change) const noexcept
    -> MixedEvaluation<S, dofs> {
    const Nodes<S, Dimension> nodes(e);
    const Nodes<Dual<S>, Dimension> earlier(course(before, change));
    Force<S, Dimension> sum, predicted;
    Tangent<S, Dimension> tangent;
    for (const AxialStation& station : axial) {
        const Vector<S, Dimension> p = nodes.tangent_at(station.tangent);
        const S normal =
            station.stiffness * arrived(axial_strain(station, earlier.tangent_at(station.tangent)));
        add_axial_force(station, p, p, sum);
        add_normal(station, p, normal, predicted);
        add_axial_tangent(station, p, normal, tangent);
    }
    for (const Station<Dimension>& station : stations) {
        const Vectors<S, Dimension> v = nodes.at(station.xi, station.tangent);
        const auto stress = foreseen(station, earlier.at(station.xi, station.tangent));
        add_force(station, v, v, sum);
        add_stress(station, v, stress, predicted);
        add_tangent(station, v, stress, tangent);
    }
    MixedEvaluation<S, dofs> result;
    result.energy = sum.energy;
    result.force = nodal_force(sum);
    result.predicted = nodal_force(predicted);
    write_tangent(tangent, result.tangent);
    return result;
}

}  // namespace ancf::detail::continuum
