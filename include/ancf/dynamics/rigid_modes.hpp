// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The rigid motions of a few nodal vectors, and what is left of a change without them.
///
/// A rigid motion moves positions by c + y x (r - centroid), slopes and r_xx by y x s. Changes are
/// measured by W: 1 for positions, a length squared for slopes, its square for r_xx.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <vector>

namespace ancf::detail {

/// The rigid motions at one configuration. An object serves one configuration after the other
/// without new memory; vectors in the plane have a third component that is zero.
class RigidModes {
public:
    /// Takes a configuration.
    /// @param e             `count` vectors of `dimension` components each.
    /// @param length_power  of each vector's unit: 1 of positions, 0 of slopes, -1 of r_xx.
    /// @param slope_weight  W of slopes, m^2; W^2 is that of r_xx.
    void set(int dimension, int count, const double* e, const int* length_power,
             double slope_weight);

    /// Returns W of a coordinate.
    [[nodiscard]] double weight(int coordinate) const {
        return vectors_[coordinate / dimension_].weight;
    }

    /// Returns the turn of the rigid motion that fits a change best.
    [[nodiscard]] Vector<double, 3> turn_of(const double* change) const;

    /// Returns that turn, without what hardly moves anything: a straight cable's about itself.
    [[nodiscard]] Vector<double, 3> firm_turn_of(const double* change) const;

    /// Writes the derivative of firm_turn_of(change) with respect to the later end, where the
    /// configuration is the middle of both ends.
    /// @param turn  firm_turn_of(change).
    /// @param out   three components for each coordinate.
    void derivative_of_firm_turn(const double* change, const Vector<double, 3>& turn,
                                 double* out) const;

    /// Returns a nodal vector; of positions relative to their centroid.
    [[nodiscard]] const Vector<double, 3>& vector(int k) const { return vectors_[k].value; }

    /// Returns W of the components of a nodal vector.
    [[nodiscard]] double weight_of(int k) const { return vectors_[k].weight; }

    /// Tells whether a nodal vector is a position.
    [[nodiscard]] bool is_position(int k) const { return vectors_[k].position; }

    /// Returns mu of the forces W (mu x x) that have a moment and no resultant.
    [[nodiscard]] Vector<double, 3> spin_of(const Vector<double, 3>& moment) const {
        return inertia_.solve(moment);
    }

    /// Writes a change without its rigid part: W-orthogonal to every rigid motion.
    void without(const double* change, double* rest) const;

    /// Writes the derivative of without(change) with respect to the later end, where the
    /// configuration is the middle of both ends.
    ///
    /// With y the turn of the change and D the rest: (I - P)(I - Y/2) - R J^-1 C/2, Y dx = y x dx,
    /// C dx = sum_k w_k dx_k x D_k.
    /// @param out  square, by columns.
    void derivative_of_without(const double* change, const double* rest, double* out) const;

private:
    struct NodalVector {
        Vector<double, 3> value;  // of positions relative to the centroid
        double weight;
        bool position;
    };

    [[nodiscard]] Vector<double, 3> component(const double* x, std::size_t k) const;
    [[nodiscard]] Vector<double, 3> moment_of(const double* change) const;
    // Returns the mean of the positions.
    [[nodiscard]] Vector<double, 3> shift_of(const double* change) const;
    // Writes a vector of x without the motion of a turn and a shift.
    void subtract(std::size_t k, const Vector<double, 3>& turn, const Vector<double, 3>& shift,
                  double* x) const;

    int dimension_ = 3;
    double positions_ = 0.0;  // how many
    std::vector<NodalVector> vectors_;
    SmallCholesky<3> inertia_, firm_inertia_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/rigid_modes.ipp>  // IWYU pragma: export
#endif
