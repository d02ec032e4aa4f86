// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The body of a joint: an affine block between the ends of beams that are attached to its node.
///
/// Its gradients are the slopes of one node, G = [r_x r_y r_z], the identity in the reference:
///
///     W = V/2 E : C : E,    E = (G^T G - I)/2,    C of an isotropic material.
///
/// docs/theory-frames.md derives the volume that a joint needs.

#pragma once

#include <ancf/element/compiled_element.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/error.hpp>
#include <ancf/section/material.hpp>
#include <ancf/types.hpp>

#include <cmath>

namespace ancf {

/// An affine block at one node. As an element it stands between that node and itself: its
/// coordinates are the node's slopes twice, of which the second ones have no effect.
template <int Dimension>
class AffineJoint {
public:
    static constexpr int dimension = Dimension;             ///< of space
    static constexpr int dofs = 2 * Dimension * Dimension;  ///< of both sets of slopes
    static constexpr bool one_node = true;                  ///< it stands at one node
    static constexpr Fields fields =
        Dimension == 2 ? Field::r_x | Field::r_y
                       : Field::r_x | Field::r_y | Fields(Field::r_z);  ///< of its node

    using Coordinates = Vector<double, dofs>;  ///< r_x, r_y (and r_z), then the same again

    /// @param volume  V, m^3: that of the block times how much stiffer than its material it is.
    /// @param size    of the block, m: it gives the slopes the inertia of a cube of this edge.
    /// @throws InvalidArgument unless volume and size are positive.
    AffineJoint(const Material& material, double volume, double size)
        : volume_(volume),
          size_(size),
          inertia_(material.density * std::pow(size, 5) / 12.0),
          shear_(material.shear) {
        detail::require_positive("AffineJoint: volume", volume);
        detail::require_positive("AffineJoint: size", size);
        // near one half the block would be far stiffer against a change of volume than of shape
        const double poisson = material.poisson();
        const double ratio = poisson > -0.9 && poisson < 0.45 ? poisson : 0.3;
        lame_ = 2.0 * shear_ * ratio / (1.0 - 2.0 * ratio);
    }

    /// Returns the edge of the block, m.
    [[nodiscard]] double length() const noexcept { return size_; }

    /// Returns energy, J, force and tangent.
    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept {
        const Square<S> s = stress(e);
        return {energy(e), force(e, s), tangent(e, s)};
    }

    /// Returns energy, J, force, the tangent whose stresses are those of `before`, linearised along
    /// `change`, and the force of these: docs/theory-statics.md, "Stresses as unknowns".
    template <class S>
    [[nodiscard]] MixedEvaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                                    const Vector<S, dofs>& before,
                                                    const Vector<S, dofs>& change) const noexcept {
        const Square<Dual<S>> foreseen = stress(detail::course(before, change));
        Square<S> s;
        for (int k = 0; k < s.size(); ++k) s.data()[k] = detail::arrived(foreseen.data()[k]);
        return {{energy(e), force(e), tangent(e, s)}, force(e, s)};
    }

    /// Returns the elastic force.
    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e) const noexcept {
        return force(e, stress(e));
    }

    /// Returns the strain energy, J.
    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& e) const noexcept {
        S trace(0.0), square(0.0);
        for (int a = 0; a < Dimension; ++a) {
            trace += strain(e, a, a);
            for (int b = 0; b < Dimension; ++b) square += strain(e, a, b) * strain(e, a, b);
        }
        return volume_ * (0.5 * lame_ * trace * trace + shear_ * square);
    }

    /// Returns the mass matrix, of the slopes alone, kg m^2.
    [[nodiscard]] Matrix<double, dofs> mass() const {
        Matrix<double, dofs> result = Matrix<double, dofs>::Zero();
        for (int k = 0; k < dofs / 2; ++k) result(k, k) = inertia_;
        return result;
    }

    /// Returns zero: the weight of a joint is in its beams.
    [[nodiscard]] Coordinates gravity(const Vector<double, Dimension>& /*acceleration*/) const {
        return Coordinates::Zero();
    }

    /// Strains are defined for all coordinates.
    [[nodiscard]] bool admissible(const Coordinates& /*e*/) const noexcept { return true; }

private:
    // Returns E_ab.
    template <class S>
    [[nodiscard]] static S strain(const Vector<S, dofs>& e, int a, int b) {
        S product(a == b ? -1.0 : 0.0);
        for (int i = 0; i < Dimension; ++i) product += e[Dimension * a + i] * e[Dimension * b + i];
        return 0.5 * product;
    }

    template <class S>
    using Square = Matrix<S, Dimension>;

    template <class S>
    [[nodiscard]] Square<S> stress(const Vector<S, dofs>& e) const {
        Square<S> s;
        S trace(0.0);
        for (int a = 0; a < Dimension; ++a) trace += strain(e, a, a);
        for (int a = 0; a < Dimension; ++a)
            for (int b = 0; b < Dimension; ++b)
                s(a, b) = 2.0 * shear_ * strain(e, a, b) + (a == b ? lame_ * trace : S(0.0));
        return s;
    }

    // Returns the force of stresses.
    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e, const Square<S>& s) const {
        Vector<S, dofs> result = Vector<S, dofs>::Zero();
        for (int a = 0; a < Dimension; ++a)
            for (int b = 0; b < Dimension; ++b)
                for (int i = 0; i < Dimension; ++i)
                    result[Dimension * a + i] += volume_ * s(a, b) * e[Dimension * b + i];
        return result;
    }

    // Returns the tangent at stresses.
    template <class S>
    [[nodiscard]] Matrix<S, dofs> tangent(const Vector<S, dofs>& e, const Square<S>& s) const {
        Matrix<S, dofs> result = Matrix<S, dofs>::Zero();
        Square<S> metric;  // sum g_i g_i^T
        for (int i = 0; i < Dimension; ++i)
            for (int j = 0; j < Dimension; ++j) {
                metric(i, j) = S(0.0);
                for (int k = 0; k < Dimension; ++k)
                    metric(i, j) += e[Dimension * k + i] * e[Dimension * k + j];
            }
        for (int a = 0; a < Dimension; ++a)
            for (int b = 0; b < Dimension; ++b)
                for (int i = 0; i < Dimension; ++i)
                    for (int j = 0; j < Dimension; ++j)
                        result(Dimension * a + i, Dimension * b + j) =
                            volume_ * ((i == j ? s(a, b) : S(0.0)) +
                                       (a == b ? shear_ * metric(i, j) : S(0.0)) +
                                       lame_ * e[Dimension * a + i] * e[Dimension * b + j] +
                                       shear_ * e[Dimension * b + i] * e[Dimension * a + j]);
        return result;
    }

    double volume_, size_, inertia_, lame_ = 0.0, shear_;
};

#if defined(ANCF_COMPILED)
ANCF_COMPILED_TEMPLATE(AffineJoint<2>);
ANCF_COMPILED_TEMPLATE(AffineJoint<3>);
#endif

}  // namespace ancf
