// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The inertia of a rigid body. The slopes of its node are its frame.
///
/// Its point at (x, y, z) of that frame stands at r + x r_x + y r_y + z r_z, so its mass matrix is
/// constant: docs/theory-dynamics.md, "Rigid bodies".

#pragma once

#include <ancf/element/compiled_element.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// The mass of a body at one node, without stiffness. As an element it stands between that node and
/// itself. Its coordinates are those of the node, twice; the second half has no effect.
template <int Dimension>
class BodyMass {
public:
    static constexpr int dimension = Dimension;                   ///< of space
    static constexpr int dofs = 2 * Dimension * (1 + Dimension);  ///< of both sets of vectors
    static constexpr bool one_node = true;                        ///< it stands at one node
    static constexpr Fields fields =
        Dimension == 2 ? Field::r | Field::r_x | Field::r_y
                       : Field::r | Field::r_x | Field::r_y | Fields(Field::r_z);  ///< of its node

    using Coordinates = Vector<double, dofs>;  ///< r, r_x, r_y (and r_z), then the same again
    /// int (1, x, y, z)^T (1, x, y, z) dm.
    using Moments = Matrix<double, 1 + Dimension>;

    /// @param moments  int (1, x, y, z)^T (1, x, y, z) dm: kg, kg m and kg m^2.
    /// @param size     of the body, m.
    BodyMass(const Moments& moments, double size) : size_(size) {
        weights_.setZero();
        weights_.template topLeftCorner<1 + Dimension, 1 + Dimension>() = moments;
    }

    /// Returns the size of the body, m.
    [[nodiscard]] double length() const noexcept { return size_; }

    /// Returns zeros: there is no stiffness.
    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept {
        return {energy(e), force(e), Matrix<S, dofs>::Zero()};
    }
    /// Returns zeros likewise: there is no stress.
    template <class S>
    [[nodiscard]] MixedEvaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                                    const Vector<S, dofs>& /*before*/,
                                                    const Vector<S, dofs>&) const noexcept {
        return {evaluate(e), force(e)};
    }
    /// Returns zero.
    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& /*e*/) const noexcept {
        return Vector<S, dofs>::Zero();
    }
    /// Returns zero.
    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& /*e*/) const noexcept {
        return S(0.0);
    }

    /// Returns the mass matrix, kg, kg m and kg m^2.
    [[nodiscard]] Matrix<double, dofs> mass() const { return mass_matrix<Dimension>(weights_); }

    /// Returns the weight.
    /// @param acceleration  of gravity, m/s^2.
    [[nodiscard]] Coordinates gravity(const Vector<double, Dimension>& acceleration) const {
        return gravity_force<Dimension>(weights_, acceleration);
    }

    /// Every state has a mass.
    [[nodiscard]] bool admissible(const Coordinates& /*e*/) const noexcept { return true; }

private:
    // the moments; zero for the second, idle set of vectors
    Matrix<double, 2 * (1 + Dimension)> weights_;
    double size_;
};

#if defined(ANCF_COMPILED)
ANCF_COMPILED_TEMPLATE(detail::BodyMass<2>);
ANCF_COMPILED_TEMPLATE(detail::BodyMass<3>);
#endif

}  // namespace ancf::detail
