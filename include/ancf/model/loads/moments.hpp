// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Moments on one slope or on the frame of a node, and forces that follow a frame, with their exact
/// stiffness.
///
/// A moment acts on slopes, so its generalised force depends on them. docs/theory-statics.md
/// derives each.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

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

    /// @param slope   r_y or r_z, the one normal to the axis; r_x bends cables and TorsionBeam. On
    ///                r_x of other beams the moment passes through the shear of one element.
    /// @param axis    of any length but zero.
    /// @param moment  N m.
    /// @throws InvalidArgument for another field, an axis of no length, or a value that is not
    ///         finite.
    SlopeMoment(NodeId node, Field slope, const VectorArgument<3>& axis, double moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, slope_}}; }

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

    /// @param slope   r_y; of cables r_x. On r_x of a beam the moment passes through the shear of
    ///                one element.
    /// @param moment  N m.
    /// @throws InvalidArgument for another field or a moment that is not finite.
    PlanarSlopeMoment(NodeId node, Field slope, double moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, slope_}}; }

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
    TangentMoment(NodeId node, const VectorArgument<3>& moment) : node_(node), moment_(moment) {
        detail::require_finite("TangentMoment: components", detail::components(moment));
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r_x}}; }

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 3> moment_;
};

/// Whether a load keeps its direction in space or its components in the node's frame.
enum class Attachment { space, frame };

/// A moment vector on the frame (t, n, c) of a node's section, N m: t is normal to r_y and r_z, n
/// and c are their directions turned to a right angle, r_y by 1 - f of what it lacks, r_z by f.
///
/// With u, w the unit vectors of r_y and r_z, s = |u x w|, t = u x w/s:
///     Q_ry = (f m_t t x u - m.w/s t)/|r_y|,   Q_rz = ((1 - f) m_t t x w + m.u/s t)/|r_z|.
/// The share f of r_y is Layout::torsion_share of the model when the moment is added.
/// A node without r_z has the frame of its tangent, t along r_x:
///     Q_rx = (m_c n - (m_n + alpha m_t) c)/|r_x|,   Q_ry = m_t c/|r_y normal to t|
/// with alpha the slope of r_y against the normal plane. Either way sum slope x Q = m.
class Moment {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    /// @param moment  in global axes (space) or in (t, n, c) (frame), N m.
    /// @throws InvalidArgument unless the moment is finite.
    Moment(NodeId node, const VectorArgument<3>& moment, Attachment attachment = Attachment::space)
        : node_(node), moment_(moment), attachment_(attachment) {
        detail::require_finite("Moment: components", detail::components(moment));
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const {
        if (on_section_) return {{node_, Field::r_y}, {node_, Field::r_z}};
        return {{node_, Field::r_x}, {node_, Field::r_y}};
    }

    /// Takes the section of its node, where that has one; the model calls it.
    /// @throws InvalidArgument for a node that carries no r_y.
    void settle(const Layout& layout);

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 3> moment_;
    Attachment attachment_;
    bool on_section_ = false;
    double share_ = 0.5;  ///< of r_y in a torque
};

/// A force that keeps its components in the frame (t, n, c) of its node, t along r_x, n the part of
/// r_y normal to t, c = t x n, N.
class FollowerForce {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    /// @throws InvalidArgument unless the force is finite.
    FollowerForce(NodeId node, const VectorArgument<3>& force) : node_(node), force_(force) {
        detail::require_finite("FollowerForce: components", detail::components(force));
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const {
        return {{node_, Field::r}, {node_, Field::r_x}, {node_, Field::r_y}};
    }

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 3> force_;
};

/// The force of FollowerForce in the plane, N: its components along r_x and along r_x turned by a
/// right angle, counterclockwise.
class PlanarFollowerForce {
public:
    static constexpr int dimension = 2;  ///< of the model it belongs to

    /// @throws InvalidArgument unless the force is finite.
    PlanarFollowerForce(NodeId node, const VectorArgument<2>& force) : node_(node), force_(force) {
        detail::require_finite("PlanarFollowerForce: components", detail::components(force));
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r}, {node_, Field::r_x}}; }

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 2> force_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/loads/moments.ipp>  // IWYU pragma: export
#endif
