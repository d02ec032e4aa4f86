// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Moments on one slope of a node, with their exact stiffness.
///
/// A moment acts on slopes, so its generalised force depends on them. docs/theory-statics.md
/// derives each.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/model/load.hpp>
#include <ancf/model/node.hpp>
#include <ancf/model/slope.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <cmath>

namespace ancf {

/// A moment m about a fixed unit axis n that works through the angle of one slope a, N m.
///
///     Q_a = m (n x a_p)/|a_p|^2,    a_p = a - (a.n) n
///
/// It is a moment about n while the slope stays normal to n: in planar bending and in pure twist.
/// A slope parallel to n has no angle about it; a run that comes there ends as not_finite.
/// Its potential is -m times that angle.
class SlopeMoment {
public:
    static constexpr int dimension = 3;                ///< of the model it belongs to
    static constexpr bool symmetric_stiffness = true;  ///< its stiffness is symmetric

    /// @param slope   r_x, r_y or r_z.
    /// @param axis    of any length but zero.
    /// @param moment  N m.
    /// @throws InvalidArgument for another field, an axis of no length, or a value that is not
    ///         finite.
    SlopeMoment(NodeId node, Field slope, const VectorArgument<3>& axis, double moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, slope_}}; }

    /// Returns the generalised force on the slope, 3 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 3> force(const Vector<Scalar, 3>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Field slope_;
    Vector<double, 3> axis_;
    double moment_;
};

/// The moment of SlopeMoment in the plane: counterclockwise positive, N m; of potential -m times
/// the slope's angle.
class PlanarSlopeMoment {
public:
    static constexpr int dimension = 2;                ///< of the model it belongs to
    static constexpr bool symmetric_stiffness = true;  ///< its stiffness is symmetric

    /// @param slope   r_x or r_y.
    /// @param moment  N m.
    /// @throws InvalidArgument for another field or a moment that is not finite.
    PlanarSlopeMoment(NodeId node, Field slope, double moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, slope_}}; }

    /// Returns the generalised force on the slope, 2 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 2> force(const Vector<Scalar, 2>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Field slope_;
    double moment_;
};

/// A moment vector fixed in space on a node that has no slope but r_x, N m.
///
/// Only the part of m normal to the tangent does work: Q_rx = (m x t)/|r_x|.
class TangentMoment {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    /// @throws InvalidArgument unless the moment is finite.
    TangentMoment(NodeId node, const VectorArgument<3>& moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r_x}}; }

    /// Returns the generalised force on r_x, 3 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 3> force(const Vector<Scalar, 3>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 3> moment_;
};

inline SlopeMoment::SlopeMoment(NodeId node, Field slope, const VectorArgument<3>& axis,
                                double moment)
    : node_(node), slope_(slope), axis_(axis), moment_(moment) {
    detail::require_slope<3>("SlopeMoment", slope);
    const double length = detail::span(axis);
    detail::require(std::isfinite(length) && length > 0.0,
                    "SlopeMoment: the axis must have a length, got ", detail::components(axis));
    axis_ /= length;
    detail::require_finite("SlopeMoment: moment", moment);
}

template <class Scalar>
Vector<Scalar, 3> SlopeMoment::force(const Vector<Scalar, 3>& slope) const {
    const Vector<Scalar, 3> n = axis_.cast<Scalar>();
    const Vector<Scalar, 3> ap = slope - Scalar(n.transpose() * slope) * n;
    return moment_ / Scalar(ap.transpose() * ap) * cross(n, ap);
}

inline void SlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 3> slope = state.q, ap = slope - axis_.dot(slope) * axis_;
    const double square = ap.squaredNorm(), scale = moment_ / square;
    const Vector<double, 3> turned = cross(axis_, ap);
    // ap and turned are normal to the axis: n x dap - 2 turned (ap.dap)/|ap|^2
    const Matrix<double, 3> turn = cross_matrix(axis_);
    for (int i = 0; i < 3; ++i) {
        out.force[i] = scale * turned[i];
        for (int j = 0; j < 3; ++j)
            out.stiffness(i, j) = scale * (turn(i, j) - 2.0 / square * turned[i] * ap[j]);
    }
    // the angle from the global axis e that leans least along n: ap.e and ap.(n x e)
    int across = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(axis_[i]) < std::abs(axis_[across])) across = i;
    const Vector<double, 3> ahead = turn.col(across);
    out.potential = -moment_ * std::atan2(ap.dot(ahead), ap[across]);
    out.period = 2.0 * pi * std::abs(moment_);
}

inline PlanarSlopeMoment::PlanarSlopeMoment(NodeId node, Field slope, double moment)
    : node_(node), slope_(slope), moment_(moment) {
    detail::require_slope<2>("PlanarSlopeMoment", slope);
    detail::require_finite("PlanarSlopeMoment: moment", moment);
}

template <class Scalar>
Vector<Scalar, 2> PlanarSlopeMoment::force(const Vector<Scalar, 2>& slope) const {
    return moment_ / Scalar(slope.transpose() * slope) * Vector<Scalar, 2>(-slope[1], slope[0]);
}

inline void PlanarSlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 2> slope = state.q;
    const double x = slope[0];
    const double y = slope[1];
    const double scale = moment_ / (slope.squaredNorm() * slope.squaredNorm());
    out.force = force(slope);
    out.stiffness << 2.0 * scale * x * y, scale * (y * y - x * x), scale * (y * y - x * x),
        -2.0 * scale * x * y;
    out.potential = -moment_ * std::atan2(y, x);
    out.period = 2.0 * pi * std::abs(moment_);
}

inline TangentMoment::TangentMoment(NodeId node, const VectorArgument<3>& moment)
    : node_(node), moment_(moment) {
    detail::require(moment.allFinite(), "TangentMoment: components must be finite, got ",
                    detail::components(moment));
}

template <class Scalar>
Vector<Scalar, 3> TangentMoment::force(const Vector<Scalar, 3>& slope) const {
    return cross(Vector<Scalar, 3>(moment_.cast<Scalar>()), slope) /
           Scalar(slope.transpose() * slope);
}

inline void TangentMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 3> slope = state.q;
    const double square = slope.squaredNorm();
    const Vector<double, 3> turned = cross(moment_, slope);
    const Matrix<double, 3> turn = cross_matrix(moment_);
    for (int i = 0; i < 3; ++i) {
        out.force[i] = turned[i] / square;
        for (int j = 0; j < 3; ++j)
            out.stiffness(i, j) = (turn(i, j) - 2.0 / square * turned[i] * slope[j]) / square;
    }
}

}  // namespace ancf
