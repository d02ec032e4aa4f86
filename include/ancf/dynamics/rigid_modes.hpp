// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The rigid motions of a few nodal vectors, what is left of a change without them, and half turns.
///
/// A rigid motion moves positions by c + y x (r - centroid), slopes and r_xx by y x s. Changes are
/// measured by W: 1 for positions, a length squared for slopes, its square for r_xx.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

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
             double slope_weight) {
        dimension_ = dimension;
        positions_ = 0.0;
        vectors_.resize(static_cast<std::size_t>(count));
        Vector<double, 3> centroid = Vector<double, 3>::Zero();
        for (std::size_t k = 0; k < vectors_.size(); ++k) {
            NodalVector& vector = vectors_[k];
            vector.value = component(e, k);
            vector.position = length_power[k] > 0;
            vector.weight = slope_weight;
            if (length_power[k] < 0) vector.weight *= slope_weight;
            if (!vector.position) continue;
            vector.weight = 1.0;
            centroid += vector.value;
            positions_ += 1.0;
        }
        if (positions_ > 0.0) centroid /= positions_;
        Matrix<double, 3> inertia = Matrix<double, 3>::Zero();
        for (NodalVector& vector : vectors_) {
            Vector<double, 3>& x = vector.value;
            if (vector.position) x -= centroid;
            const double square = vector.weight * (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
            if (dimension == 2) {  // about the normal alone
                for (int i = 0; i < 3; ++i) inertia(i, i) += square;
                continue;
            }
            for (int i = 0; i < 3; ++i) {
                inertia(i, i) += square;
                for (int j = 0; j < 3; ++j) inertia(i, j) -= vector.weight * x[i] * x[j];
            }
        }
        // a turn that moves nothing (a straight cable's about itself) has no inertia
        const double floor = 1e-15 * (inertia(0, 0) + inertia(1, 1) + inertia(2, 2));
        for (int i = 0; i < 3; ++i) inertia(i, i) += floor > 0.0 ? floor : 1.0;
        inertia_ = SmallCholesky<3>(inertia);
        // constant, so that it has no derivative
        for (int i = 0; i < 3; ++i) inertia(i, i) += 1e-6 * slope_weight;
        firm_inertia_ = SmallCholesky<3>(inertia);
    }

    /// Returns a vector of coordinates.
    [[nodiscard]] Vector<double, 3> component(const double* x, std::size_t k) const {
        const double* const at = x + dimension_ * k;
        return {at[0], at[1], dimension_ == 3 ? at[2] : 0.0};
    }

    /// Returns W of a coordinate.
    [[nodiscard]] double weight(int coordinate) const {
        return vectors_[coordinate / dimension_].weight;
    }

    /// Returns the turn of the rigid motion that fits a change best.
    [[nodiscard]] Vector<double, 3> turn_of(const double* change) const {
        return inertia_.solve(moment_of(change));
    }

    /// Returns that turn, without what hardly moves anything: a straight cable's about itself.
    [[nodiscard]] Vector<double, 3> firm_turn_of(const double* change) const {
        return firm_inertia_.solve(moment_of(change));
    }

    /// Writes the derivative of firm_turn_of(change) with respect to the later end, where the
    /// configuration is the middle of both ends.
    /// @param turn  firm_turn_of(change).
    /// @param out   three components for each coordinate.
    void derivative_of_firm_turn(const double* change, const Vector<double, 3>& turn,
                                 double* out) const {
        const Vector<double, 3> shift = shift_of(change);
        for (std::size_t k = 0; k < vectors_.size(); ++k) {
            const NodalVector& vector = vectors_[k];
            Vector<double, 3> left = component(change, k) - cross(turn, vector.value);
            if (vector.position) left -= shift;
            for (int i = 0; i < dimension_; ++i) {
                // one vector alone changes, by d
                const Vector<double, 3> d = Vector<double, 3>::Unit(i);
                const Vector<double, 3> kept = d - 0.5 * cross(turn, d);
                const Vector<double, 3> moment =
                    vector.weight * (cross(vector.value, kept) + 0.5 * cross(d, left));
                const Vector<double, 3> rate = firm_inertia_.solve(moment);
                for (int a = 0; a < 3; ++a) *out++ = rate[a];
            }
        }
    }

    /// Returns a nodal vector; of positions relative to their centroid.
    [[nodiscard]] const Vector<double, 3>& vector(int k) const { return vectors_[k].value; }

    /// Returns W of the components of a nodal vector.
    [[nodiscard]] double weight_of(int k) const { return vectors_[k].weight; }

    /// Tells whether a nodal vector is a position.
    [[nodiscard]] bool is_position(int k) const { return vectors_[k].position; }

    /// Returns the number of positions.
    [[nodiscard]] double positions() const { return positions_; }

    /// Returns the mean change of the positions.
    [[nodiscard]] Vector<double, 3> shift_of(const double* change) const {
        Vector<double, 3> shift = Vector<double, 3>::Zero();
        for (std::size_t k = 0; k < vectors_.size(); ++k)
            if (vectors_[k].position) shift += component(change, k);
        if (positions_ > 0.0) shift /= positions_;
        return shift;
    }

    /// Returns mu of the forces W (mu x x) that have a moment and no resultant.
    [[nodiscard]] Vector<double, 3> spin_of(const Vector<double, 3>& moment) const {
        return inertia_.solve(moment);
    }

    /// Writes a change without its rigid part: W-orthogonal to every rigid motion.
    void without(const double* change, double* rest) const {
        const Vector<double, 3> shift = shift_of(change);
        const Vector<double, 3> turn = turn_of(change);
        std::copy_n(change, dimension_ * vectors_.size(), rest);
        for (std::size_t k = 0; k < vectors_.size(); ++k) subtract(k, turn, shift, rest);
    }

    /// Writes the derivative of without(change) with respect to the later end, where the
    /// configuration is the middle of both ends.
    ///
    /// With y the turn of the change and D the rest: (I - P)(I - Y/2) - R J^-1 C/2, Y dx = y x dx,
    /// C dx = sum_k w_k dx_k x D_k.
    /// @param out  square, by columns.
    void derivative_of_without(const double* change, const double* rest, double* out) const {
        const Vector<double, 3> y = turn_of(change);
        const std::size_t size = dimension_ * vectors_.size();
        for (std::size_t k = 0; k < vectors_.size(); ++k)
            for (int i = 0; i < dimension_; ++i) {
                // one vector alone changes, by d: what is left of (I - Y/2) d, the turn of C d/2
                const NodalVector& vector = vectors_[k];
                const Vector<double, 3> d = Vector<double, 3>::Unit(i);
                const Vector<double, 3> kept = d - 0.5 * cross(y, d);
                const Vector<double, 3> moment = vector.weight * cross(vector.value, kept) +
                                                 0.5 * vector.weight * cross(d, component(rest, k));
                const Vector<double, 3> turn = inertia_.solve(moment);
                Vector<double, 3> shift = Vector<double, 3>::Zero();
                if (vector.position) shift = kept / positions_;
                std::fill_n(out, size, 0.0);
                for (int j = 0; j < dimension_; ++j) out[dimension_ * k + j] = kept[j];
                for (std::size_t j = 0; j < vectors_.size(); ++j) subtract(j, turn, shift, out);
                out += size;
            }
    }

private:
    struct NodalVector {
        Vector<double, 3> value;  // of positions relative to the centroid
        double weight;
        bool position;
    };

    [[nodiscard]] Vector<double, 3> moment_of(const double* change) const {
        Vector<double, 3> moment = Vector<double, 3>::Zero();
        for (std::size_t k = 0; k < vectors_.size(); ++k)
            moment += vectors_[k].weight * cross(vectors_[k].value, component(change, k));
        return moment;
    }

    // Writes a vector of x without the motion of a turn and a shift.
    void subtract(std::size_t k, const Vector<double, 3>& turn, const Vector<double, 3>& shift,
                  double* x) const {
        double* const at = x + dimension_ * k;
        const Vector<double, 3> turned = cross(turn, vectors_[k].value);
        for (int i = 0; i < dimension_; ++i) {
            at[i] -= turned[i];
            if (vectors_[k].position) at[i] -= shift[i];
        }
    }

    int dimension_ = 3;
    double positions_ = 0.0;  // how many
    List<NodalVector> vectors_;
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
    explicit HalfTurn(const Vector<double, 3>& turn)
        : a_(std::sqrt(1.0 + 0.25 * turn.dot(turn))), over_(1.0 / a_), stretch_(a_ / (1.0 + a_)) {
        half_ = 0.5 * over_ * turn;
    }

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
    [[nodiscard]] Vector<double, 3> symmetric_rate(int b, const Vector<double, 3>& v) const {
        // S = (I + y y^T/(4 (1 + a)))/a with y = 2 a half_ and da/dy_b = half_/2
        const double fall = 0.5 * half_[b], share = 0.25 / (1.0 + a_);
        const double along = 2.0 * a_ * half_.dot(v);
        Vector<double, 3> out = 2.0 * a_ * share * (v[b] - 4.0 * share * fall * along) * half_;
        out[b] += share * along;
        return over_ * (out - fall * symmetric(v));
    }

    /// Returns dX/dy_b v.
    [[nodiscard]] Vector<double, 3> skew_rate(int b, const Vector<double, 3>& v) const {
        const Vector<double, 3> axis = Vector<double, 3>::Unit(b);
        return 0.5 * over_ * (cross(axis, v) - half_[b] * skew(v));
    }

private:
    Vector<double, 3> half_;  // y/(2 a)
    double a_, over_;         // and its inverse
    double stretch_;          // a/(1 + a)
};

}  // namespace ancf::detail
