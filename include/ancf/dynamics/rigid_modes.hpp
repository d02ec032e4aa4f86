// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The rigid motions of a few nodal vectors, what is left of a change without them, and half turns.
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

    /// Returns the number of positions.
    [[nodiscard]] double positions() const { return positions_; }

    /// Returns the mean change of the positions.
    [[nodiscard]] Vector<double, 3> shift_of(const double* change) const;

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
    // Writes a vector of x without the motion of a turn and a shift.
    void subtract(std::size_t k, const Vector<double, 3>& turn, const Vector<double, 3>& shift,
                  double* x) const;

    int dimension_ = 3;
    double positions_ = 0.0;  // how many
    std::vector<NodalVector> vectors_;
    SmallCholesky<3> inertia_, firm_inertia_;
};

/// Half of a turn, which brings both ends of a step to its middle, and its derivatives, as they act
/// on a vector.
///
/// The turn y = 2 tan(theta/2) n of a change belongs to the angle theta about n. Its half is
///
///     R = S + X,   S = (I + y y^T/(4 (1 + a)))/a,   X = [y]x/(2 a),   a = sqrt(1 + y.y/4):
///
/// S is cos(theta/2) across n and 1 along it. docs/theory-dynamics.md, "Energy-momentum".
class HalfTurn {
public:
    /// @param turn  y, rad for small ones.
    explicit HalfTurn(const Vector<double, 3>& turn);

    /// Returns S v.
    [[nodiscard]] Vector<double, 3> symmetric(const Vector<double, 3>& v) const {
        return over_ * v + stretch_ * half_.dot(v) * half_;
    }
    /// Returns X v.
    [[nodiscard]] Vector<double, 3> skew(const Vector<double, 3>& v) const {
        return cross(half_, v);
    }
    /// Writes S x - X d, the mean of R (x - d) and R^T (x + d), and X times their difference,
    /// 2 X (S d - X x).
    void middle(const Vector<double, 3>& x, const Vector<double, 3>& d, Vector<double, 3>& mean,
                Vector<double, 3>& arm) const {
        const Vector<double, 3> back = cross(half_, d);
        const double along = half_.dot(x);
        mean = over_ * x + stretch_ * along * half_ - back;
        arm = 2.0 * (over_ * back + half_.dot(half_) * x - along * half_);
    }
    /// Returns dS/dy_b v.
    [[nodiscard]] Vector<double, 3> symmetric_rate(int b, const Vector<double, 3>& v) const;
    /// Returns dX/dy_b v.
    [[nodiscard]] Vector<double, 3> skew_rate(int b, const Vector<double, 3>& v) const;

private:
    Vector<double, 3> half_;  // y/(2 a)
    double a_, over_;         // and its inverse
    double stretch_;          // a/(1 + a)
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/rigid_modes.ipp>  // IWYU pragma: export
#endif
