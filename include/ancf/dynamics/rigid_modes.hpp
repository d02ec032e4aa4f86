// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The rigid motions of a few nodal vectors, and what is left of a change without them.
///
/// A rigid motion moves positions by c + y x (r - centroid), slopes and r_xx by y x s. Changes are
/// measured by W: 1 for positions, a length squared for slopes, its square for r_xx.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// Returns y x v: a vector in space, a number times the vector turned by a right angle in the
/// plane.
[[nodiscard]] inline Vector<double, 3> turned(const Vector<double, 3>& y,
                                              const Vector<double, 3>& v) {
    return cross(y, v);
}
[[nodiscard]] inline Vector<double, 2> turned(const Vector<double, 1>& y,
                                              const Vector<double, 2>& v) {
    return {-y[0] * v[1], y[0] * v[0]};
}

/// Returns v x w with y.(v x w) = (y x v).w.
[[nodiscard]] inline Vector<double, 3> moment_of(const Vector<double, 3>& v,
                                                 const Vector<double, 3>& w) {
    return cross(v, w);
}
[[nodiscard]] inline Vector<double, 1> moment_of(const Vector<double, 2>& v,
                                                 const Vector<double, 2>& w) {
    return Vector<double, 1>(v[0] * w[1] - v[1] * w[0]);
}

/// The rigid motions at one configuration of `Size` coordinates (or of any number).
template <int Dimension, int Size>
class RigidModes {
public:
    static constexpr int turns = Dimension == 3 ? 3 : 1;
    using Coordinates = Vector<double, Size>;
    using Turn = Vector<double, turns>;
    using Point = Vector<double, Dimension>;
    using Square = Matrix<double, Size>;

    /// @param length_power   of each vector's unit: 1 of positions, 0 of slopes, -1 of r_xx.
    /// @param slope_weight   W of slopes, m^2; W^2 is that of r_xx.
    template <class Power>
    RigidModes(const Coordinates& e, const Power& length_power, double slope_weight) {
        count_ = static_cast<int>(e.size()) / Dimension;
        relative_ = e;
        weight_.resize(e.size());
        position_.resize(count_);
        centroid_.setZero();
        for (int k = 0; k < count_; ++k) {
            const int power = length_power(k);
            position_[k] = power > 0;
            for (int i = 0; i < Dimension; ++i)
                weight_[Dimension * k + i] = power > 0    ? 1.0
                                             : power == 0 ? slope_weight
                                                          : slope_weight * slope_weight;
            if (power <= 0) continue;
            centroid_ += vector(e, k);
            ++positions_;
        }
        if (positions_ > 0) centroid_ /= positions_;
        Matrix<double, turns> inertia = Matrix<double, turns>::Zero();
        for (int k = 0; k < count_; ++k) {
            if (at_position(k)) subtract(relative_, k, centroid_);
            const Point x = vector(relative_, k);
            const double square = weight(k) * x.squaredNorm();
            for (int i = 0; i < turns; ++i) {
                inertia(i, i) += square;
                if constexpr (Dimension == 3)
                    for (int j = 0; j < 3; ++j) inertia(i, j) -= weight(k) * x[i] * x[j];
            }
        }
        // a turn that moves nothing (a straight cable's about itself) has no inertia
        const double floor = 1e-15 * inertia.trace();
        for (int i = 0; i < turns; ++i) inertia(i, i) += floor > 0.0 ? floor : 1.0;
        inertia_ = SmallCholesky<turns>(inertia);
    }

    [[nodiscard]] const Coordinates& weights() const noexcept { return weight_; }

    /// Returns the turn of the rigid motion that fits a change best.
    [[nodiscard]] Turn turn_of(const Coordinates& change) const {
        Turn moment = Turn::Zero();
        for (int k = 0; k < count_; ++k)
            moment += weight(k) * moment_of(vector(relative_, k), vector(change, k));
        return inertia_.solve(moment);
    }

    /// Returns a change without its rigid part: W-orthogonal to every rigid motion.
    [[nodiscard]] Coordinates without(const Coordinates& change) const {
        Coordinates rest = change;
        Point shift = Point::Zero();
        for (int k = 0; k < count_; ++k)
            if (at_position(k)) shift += vector(change, k);
        if (positions_ > 0) shift /= positions_;
        const Turn turn = turn_of(change);
        for (int k = 0; k < count_; ++k) {
            subtract(rest, k, turned(turn, vector(relative_, k)));
            if (at_position(k)) subtract(rest, k, shift);
        }
        return rest;
    }

    /// Returns the derivative of without(change) with respect to the later end, where the
    /// configuration is the middle of both ends.
    ///
    /// With y the turn of the change and D the rest: (I - P)(I - Y/2) - R J^-1 C/2, Y dx = y x dx,
    /// C dx = sum_k w_k dx_k x D_k.
    [[nodiscard]] Square derivative_of_without(const Coordinates& change,
                                               const Coordinates& rest) const {
        const Turn y = turn_of(change);
        Square out(change.size(), change.size());
        Coordinates unit(change.size());
        for (int column = 0; column < change.size(); ++column) {
            const int k = column / Dimension;
            unit.setZero();
            unit[column] = 1.0;
            const Point direction = vector(unit, k);
            subtract(unit, k, 0.5 * turned(y, direction));
            Coordinates derivative = without(unit);
            const Turn turn = inertia_.solve(weight(k) * moment_of(direction, vector(rest, k)));
            for (int j = 0; j < count_; ++j)
                subtract(derivative, j, 0.5 * turned(turn, vector(relative_, j)));
            for (int i = 0; i < change.size(); ++i) out(i, column) = derivative[i];
        }
        return out;
    }

private:
    [[nodiscard]] static Point vector(const Coordinates& x, int k) {
        return x.template segment<Dimension>(Dimension * k);
    }
    static void subtract(Coordinates& x, int k, const Point& part) {
        for (int i = 0; i < Dimension; ++i) x[Dimension * k + i] -= part[i];
    }
    [[nodiscard]] double weight(int k) const { return weight_[Dimension * k]; }
    [[nodiscard]] bool at_position(int k) const { return position_[k]; }

    int count_ = 0;
    int positions_ = 0;
    Eigen::Matrix<bool, Size == Eigen::Dynamic ? Eigen::Dynamic : Size / Dimension, 1> position_;
    Coordinates relative_, weight_;
    Point centroid_;
    SmallCholesky<turns> inertia_;
};

}  // namespace ancf::detail
