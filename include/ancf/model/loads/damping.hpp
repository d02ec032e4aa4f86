// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Damping as loads: Rayleigh's a M + b K0 of elements, drag along a line, and Kelvin and Voigt's
/// on the generalised strains.
///
/// The first two are forces -D v with a constant matrix D per element, the last turns with the
/// element. Derivatives are exact. Every integrator but Leapfrog takes them. An amplitude varies
/// them in time.

#pragma once

#include <ancf/element/evaluation.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/load.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <unordered_map>
#include <utility>

namespace ancf {

/// The force -D v on the coordinates of some nodal vectors.
class LinearDamping {
public:
    static constexpr bool symmetric_stiffness = true;  ///< its stiffness is symmetric

    /// @param matrix  D, in the order of the coupling; N s/m for positions. Where it is not
    ///                symmetric take full storage: from its lower half steps converge slowly.
    /// @throws InvalidArgument for a matrix that is not square or not finite.
    LinearDamping(Coupling coupling, MatrixX matrix)
        : coupling_(std::move(coupling)), matrix_(std::move(matrix)) {
        detail::require(matrix_.rows() == matrix_.cols() && detail::all_finite(matrix_),
                        "LinearDamping: the matrix must be square with finite entries, got ",
                        matrix_.rows(), " x ", matrix_.cols());
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return coupling_; }

    /// Evaluates it where it stands.
    ANCF_LAZY void evaluate(const LoadState& state, LoadResult& out) const;

private:
    Coupling coupling_;
    MatrixX matrix_;
};

namespace detail {

ANCF_LAZY void add_rayleigh_damping(Scene& model, const ElementGroup& group,
                                    const List<int>& elements, double a, double b,
                                    const Amplitude& amplitude);
ANCF_LAZY void add_drag(Scene& model, const ElementGroup& group, const List<int>& elements,
                        double c, const Amplitude& amplitude);

/// Of an element that has derivatives of its damping.
template <class Element>
using Viscous = decltype(&Element::template viscous<>);

}  // namespace detail

/// Adds Rayleigh damping D = a M + b K0 to a beam, K0 the tangent where the model stands.
///
/// A mode of the angular frequency w has the damping ratio a/(2 w) + b w/2. D is fixed in space:
/// a M damps rigid motions too, and K0 belongs to the present orientation, so b is for beams that
/// turn by small angles.
/// @param a  >= 0, 1/s  @param b  >= 0, s
/// @throws InvalidArgument for a value that is negative or not finite.
template <class Element>
void add_rayleigh_damping(Scene& model, const Beam<Element>& beam, double a, double b,
                          const Amplitude& amplitude = {}) {
    detail::add_rayleigh_damping(model, model.group<Element>(), beam.elements, a, b, amplitude);
}

/// Adds a drag -c v per length of the stress-free centre line, the same in all directions.
/// @param c  >= 0, N s/m^2
/// @throws InvalidArgument for a value that is negative or not finite.
template <class Element>
void add_drag(Scene& model, const Beam<Element>& beam, double c, const Amplitude& amplitude = {}) {
    detail::add_drag(model, model.group<Element>(), beam.elements, c, amplitude);
}

/// The force -eta B^T C B v of stresses eta C ds/dt, s the element's generalised strains.
///
/// In a rigid motion the force is zero. A mode of the angular frequency w has the damping ratio
/// eta w/2; where tension or gravity stiffens it eta w_e^2/(2 w), w_e^2 the elastic part of w^2. In
/// Cable<3> it damps changes of |kappa|, the length of the curvature vector, and of a
/// straight line bending in every direction: docs/theory-damping.md.
template <class Element>
class KelvinVoigt {
public:
    static constexpr int dofs = Element::dofs;  ///< coordinates of the element

    /// @param element   shared by the dampers of equal elements
    /// @param coupling  of the element's coordinates, as from coupling_of()
    /// @param eta       ratio of viscosity to stiffness, >= 0, s
    /// @throws InvalidArgument for a value that is negative or not finite.
    KelvinVoigt(std::shared_ptr<const Element> element, Coupling coupling, double eta)
        : element_(std::move(element)), coupling_(std::move(coupling)), eta_(eta) {
        detail::require_not_negative("KelvinVoigt: eta", eta);
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return coupling_; }

    /// Returns the force on the element's coordinates; N for positions, N m for slopes, N m^2 for
    /// r_xx.
    /// @param e,v  nodal coordinates and their rates
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, dofs> force(const Vector<Scalar, dofs>& e,
                                             const Vector<Scalar, dofs>& v) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    std::shared_ptr<const Element> element_;
    Coupling coupling_;
    double eta_;
};

template <class Element>
template <class Scalar>
auto KelvinVoigt<Element>::force(const Vector<Scalar, dofs>& e, const Vector<Scalar, dofs>& v) const
    -> Vector<Scalar, dofs> {
    return detail::rates(-eta_, element_->force(detail::moving<Scalar>(e, v)));
}

template <class Element>
void KelvinVoigt<Element>::evaluate(const LoadState& state, LoadResult& out) const {
    detail::require(state.q.size() == dofs, "KelvinVoigt: ", state.q.size(),
                    " coordinates are coupled, the element has ", dofs);
    const Vector<double, dofs> e = state.q, v = state.v;
    if (!state.derivatives) {
        out.force = force<double>(e, v);
    } else if constexpr (detail::offers<detail::Viscous, Element>) {
        const Evaluation<detail::Rate<double>, dofs> at = element_->viscous(e, v);
        out.force = detail::rates(-eta_, at.force);
        out.stiffness = detail::rates(-eta_, at.tangent);
        for (int k = 0; k < dofs * dofs; ++k)
            out.damping.data()[k] = -eta_ * at.tangent.data()[k].value;
    } else {
        using Both = Pack<2>;
        const Vector<double, dofs> zero = Vector<double, dofs>::Zero();
        const auto rate = detail::moving<Both>(v, zero);
        const Vector<Both, dofs> place = detail::rates(1.0, detail::moving<Both>(zero, e));
        out.force = force<double>(e, v);
        out.stiffness = detail::columns<Element::dimension, dofs>([&](const auto& unit) {
            return detail::rates(1.0, force(detail::moving<Both>(e, unit), rate));
        });
        out.damping = detail::columns<Element::dimension, dofs>(
            [&](const auto& unit) { return force(place, unit); });  // it is linear in v
    }
}

/// Adds Kelvin and Voigt's damping to a beam, with its elements as they are now.
/// @param eta  >= 0, s
/// @throws InvalidArgument for a value that is negative or not finite.
template <class Element>
void add_kelvin_voigt(Scene& model, const Beam<Element>& beam, double eta,
                      const Amplitude& amplitude = {}) {
    const auto& group = model.group<Element>();
    std::unordered_map<int, std::shared_ptr<const Element>> shared;
    for (const int index : beam.elements) {
        const Connection& connection = group.connection(index);
        auto& element = shared[connection.prototype];
        if (!element) element = std::make_shared<const Element>(group.element(index));
        model.add(KelvinVoigt<Element>(element, coupling_of<Element>(connection), eta), amplitude);
    }
}

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/loads/damping.ipp>  // IWYU pragma: export
#endif
