// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What must hold for every element type: one list of checks, run over each of them.
///
/// An element has `dimension`, `dofs`, `fields`, `length()`, `energy`, `force`, `evaluate`, `mass`,
/// `gravity` and `admissible`; its straight reference along e_x is
/// test::reference_coordinates(element). The checks see it without its type, and are compiled once.

#pragma once

#include <ancf/element/evaluation.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/types.hpp>

#include <support/random_state.hpp>

#include <Eigen/Core>

#include <complex>
#include <cstdint>
#include <functional>

namespace ancf::test {

inline constexpr std::uint64_t states = 100;

/// An element without its type. It refers to the element, which must live longer.
struct AnyElement {
    /// Energy, force and tangent.
    using Evaluated = ancf::Evaluation<double, Eigen::Dynamic>;

    template <class Element>
    AnyElement(const Element& element)
        : shape(shape_of<Element>(element.length())),
          energy([&](const VectorX& e) { return element.energy(fixed<Element>(e)); }),
          force([&](const VectorX& e) -> VectorX { return element.force(fixed<Element>(e)); }),
          evaluate([&](const VectorX& e) {
              const auto all = element.evaluate(fixed<Element>(e));
              return Evaluated{all.energy, all.force, all.tangent};
          }),
          mass([&]() -> MatrixX { return element.mass(); }),
          gravity([&](const VectorX& g) -> VectorX {
              return element.gravity(Vector<double, Element::dimension>(g));
          }),
          admissible([&](const VectorX& e) { return element.admissible(fixed<Element>(e)); }) {}

    template <class Element>
    static Vector<double, Element::dofs> fixed(const VectorX& e) {
        return e;
    }

    Shape shape;
    std::function<double(const VectorX& e)> energy;
    std::function<VectorX(const VectorX& e)> force;
    std::function<Evaluated(const VectorX& e)> evaluate;
    std::function<MatrixX()> mass;
    std::function<VectorX(const VectorX& g)> gravity;
    std::function<bool(const VectorX& e)> admissible;
};

/// An element's energy and force of complex coordinates. It refers to the element.
struct ComplexElement {
    using Coordinates = Eigen::VectorXcd;

    template <class Element>
    ComplexElement(const Element& element)
        : energy([&](const Coordinates& e) { return element.energy(fixed<Element>(e)); }),
          force([&](const Coordinates& e) -> Coordinates {
              return element.force(fixed<Element>(e));
          }) {}

    template <class Element>
    static Vector<std::complex<double>, Element::dofs> fixed(const Coordinates& e) {
        return e;
    }

    std::function<std::complex<double>(const Coordinates& e)> energy;
    std::function<Coordinates(const Coordinates& e)> force;
};

/// Returns a rigid motion of the reference: random rotation, shift of up to `distance` lengths.
[[nodiscard]] VectorX rigid_state(const Shape& shape, Random& random, double distance);

template <class Element>
[[nodiscard]] Vector<double, Element::dofs> rigid_state(const Element& element, Random& random,
                                                        double distance) {
    return rigid_state(shape_of<Element>(element.length()), random, distance);
}

/// At rest, and in any rigid motion of it, energy and force vanish.
void check_zero_at_rest(const AnyElement& element);

/// The energy does not change in a rigid motion: to 1e-12 within one length, and far away to what
/// the rounding of the positions leaves, 10 eps D/largest strain for a distance of D lengths.
void check_rigid_invariance(const AnyElement& element, double strain = 0.3);

/// Relative errors of the derivatives of an element in one state, or the largest of several.
struct DerivativeErrors {
    double force = 0.0;     ///< of the force, against the complex step of the energy
    double tangent = 0.0;   ///< of the tangent, against the complex step of the force
    double symmetry = 0.0;  ///< of the tangent
    double pass = 0.0;      ///< of energy and force from functions of their own, against one pass
};

/// Raises `worst` to the errors of what an element returned in the state e: of one pass, and of
/// functions of their own.
void raise(DerivativeErrors& worst, const AnyElement::Evaluated& pass, double energy,
           const VectorX& force, const ComplexElement& stepped, const VectorX& e);

/// Raises `worst` to the errors in the state e.
void raise(DerivativeErrors& worst, const AnyElement& element, const ComplexElement& stepped,
           const VectorX& e);

/// Force and tangent are the first and second derivative of the energy, to round-off; one pass and
/// separate functions agree; the tangent is symmetric.
void check_derivatives(const AnyElement& element, const ComplexElement& stepped, double strain);

template <class Element>
void check_derivatives(const Element& element, double strain = 0.3) {
    check_derivatives(AnyElement(element), ComplexElement(element), strain);
}

/// The tangent of a stress-free state has exactly as many zero eigenvalues as rigid motions, and no
/// negative one.
void check_zero_modes(const AnyElement& element);

/// Turning the element turns its force, K (n x e) = n x Q, and moving it changes nothing, also at
/// stressed states.
void check_turning(const AnyElement& element);

/// The mass is symmetric, positive definite, and gives the translational and rotary inertia of a
/// straight bar of the given moments, in any orientation.
/// @param density  kg/m^3
void check_mass(const AnyElement& element, double density, const Moments& moments);

/// Gravity does the work of the weight in translations, and that of the weight at the centre of
/// mass in rotations.
void check_gravity(const AnyElement& element, double density, const Moments& moments);

/// A state in the plane of x and y, the z slopes along z, has no force out of it.
void check_planar(const AnyElement& element);

/// Elements refuse what has no strain: no number, a slope of no length or along the tangent.
void check_admissible(const AnyElement& element);

/// Checks that an element tells when its line is shorter than 1/sqrt(3) of its length, and that one
/// whose law does not soften never does.
void check_softened(const Shape& shape, const VectorX& reference, bool softens,
                    const std::function<bool(const VectorX& e)>& softened);

template <class Element>
void check_softened(const Element& element, const Vector<double, Element::dofs>& reference,
                    bool softens) {
    check_softened(shape_of<Element>(element.length()), reference, softens, [&](const VectorX& e) {
        return element.softened(AnyElement::fixed<Element>(e));
    });
}

}  // namespace ancf::test
