// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cable's energy, force and tangent: the walk over its stations.

#pragma once

#include <ancf/element/cable/axial.hpp>
#include <ancf/element/cable/kernel.hpp>
#include <ancf/element/cable/natural.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// The stations of an element, and what they add up to.
template <int Dimension, class Measure>
struct CableKernel {
    static constexpr int dimension = Dimension, dofs = 4 * Dimension;

    List<CableAxialStation> axial;
    List<CableBendingStation> bending;
    List<NaturalCurvature> natural;
    double natural_energy = 0.0;  ///< int EI kappa0^2/2 ds, J
    double softening = 0.0;       ///< 1 less the ratio of stiffness in compression to tension
    double straight = 0.0;        ///< a curvature that counts as none, 1/m

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
        const auto line = line_of<Dimension>(e);
        const EarlierLine<S, Dimension> earlier{line_of<Dimension>(before),
                                                line_of<Dimension>(change)};
        LineHessian<S, Dimension> hessian;
        const auto sum = gradient<true, S>(line, &hessian);
        LineGradient<S, Dimension> gain;
        for (const auto& at : axial)
            foresee_axial<Measure, Dimension>(at, softening, line, earlier, gain, hessian);
        for (const auto& at : bending) foresee_bending<Dimension>(at, line, earlier, gain, hessian);
        MixedEvaluation<S, dofs> result;
        result.energy = sum.energy + natural_energy;
        result.force = nodal_force<Dimension>(sum.vector);
        result.predicted = result.force + nodal_force<Dimension>(gain.vector);
        write_tangent<Dimension>(hessian, result.tangent);
        return result;
    }

private:
    template <bool Tangent, class S>
    [[nodiscard]] LineGradient<S, Dimension> gradient(
        const LineVector<S, Dimension>& line, LineHessian<S, Dimension>* hessian) const noexcept {
        LineGradient<S, Dimension> sum;
        for (const auto& at : axial)
            add_axial<Tangent, Measure, Dimension>(at, softening, line, sum, hessian);
        if constexpr (is_rate<S> && Dimension == 2) {
            for (const auto& at : bending) add_curvature_rate(at, line, sum);
        } else if constexpr (is_rate<S>) {
            for (const auto& at : bending) add_curvature_rate(at, straight, line, sum);
        } else {
            for (const auto& at : bending) add_bending<Tangent, Dimension>(at, line, sum, hessian);
            for (const auto& at : natural) add_natural<Tangent>(at, bending, line, sum, hessian);
        }
        return sum;
    }
};

template <int Dimension, class Measure>
template <class S>
auto CableKernel<Dimension, Measure>::energy(const Vector<S, dofs>& e) const noexcept -> S {
    return gradient<false, S>(line_of<Dimension>(e), nullptr).energy + natural_energy;
}

template <int Dimension, class Measure>
template <class S>
auto CableKernel<Dimension, Measure>::force(const Vector<S, dofs>& e) const noexcept
    -> Vector<S, dofs> {
    return nodal_force<Dimension>(gradient<false, S>(line_of<Dimension>(e), nullptr).vector);
}

template <int Dimension, class Measure>
template <class S>
auto CableKernel<Dimension, Measure>::evaluate(const Vector<S, dofs>& e) const noexcept
    -> Evaluation<S, dofs> {
    LineHessian<S, Dimension> hessian;
    const auto sum = gradient<true, S>(line_of<Dimension>(e), &hessian);
    Evaluation<S, dofs> result;
    result.energy = sum.energy + natural_energy;
    result.force = nodal_force<Dimension>(sum.vector);
    write_tangent<Dimension>(hessian, result.tangent);
    return result;
}

}  // namespace ancf::detail
