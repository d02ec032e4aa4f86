// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Joints of the plane: welds at any angle and driven hinges. A hinge of the plane is a Pin<2>.
///
/// The angle th of a slope p has dth = (p x dp)/|p|^2. The joint holds F sin psi = 0 with
/// psi = th_b - th_a - phi(t) and the factor of turn.hpp, without which psi = pi were a root too.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/constraints_motion.hpp>
#include <ancf/model/constraints_points.hpp>
#include <ancf/model/node.hpp>
#include <ancf/model/slope.hpp>
#include <ancf/model/turn.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <utility>

namespace ancf {

/// Positions and the angle between two slopes held, or that angle driven; 3 equations.
class PlanarWeld {
public:
    static constexpr int dimension = 2;  ///< of the model it belongs to

    /// @param slope  whose direction counts on both sides; without it r_y, the section's, where a
    ///               node carries it, and r_x elsewhere.
    /// @throws InvalidArgument for equal nodes, the field r, a slope of no length or a motion that
    ///         is not complete.
    template <class Scene>
    PlanarWeld(const Scene& model, NodeId a, NodeId b, std::optional<Field> slope = {})
        : PlanarWeld(model, a, b, resting(), slope) {}

    /// As above, the angle driven.
    /// @param angle  added to the angle of the start, rad.
    template <class Scene>
    PlanarWeld(const Scene& model, NodeId a, NodeId b, Motion angle,
               std::optional<Field> slope = {})
        : a_(a),
          b_(b),
          to_space_(false),
          slope_a_(chosen(model, a, slope)),
          slope_b_(chosen(model, b, slope)),
          angle_(std::move(angle)) {
        static_assert(Scene::dimension == 2, "a planar weld is of two dimensions");
        detail::require(a != b, "PlanarWeld: two nodes are joined, got node ", a.index, " twice");
        angle_.check("PlanarWeld");
        start_ = heading(model, b, slope_b_) - heading(model, a, slope_a_);
    }

    /// A weld to space, at the node's place.
    template <class Scene>
    explicit PlanarWeld(const Scene& model, NodeId a, std::optional<Field> slope = {})
        : PlanarWeld(model, a, resting(), slope) {}

    /// A driven hinge to space: the node turns by -angle(t).
    template <class Scene>
    PlanarWeld(const Scene& model, NodeId a, Motion angle, std::optional<Field> slope = {})
        : a_(a),
          b_(a),
          to_space_(true),
          slope_a_(chosen(model, a, slope)),
          slope_b_(slope_a_),
          angle_(std::move(angle)) {
        static_assert(Scene::dimension == 2, "a planar weld is of two dimensions");
        angle_.check("PlanarWeld");
        place_ = model.position(a);
        start_ = -heading(model, a, slope_a_);
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const {
        if (to_space_) return {{a_, Field::r}, {a_, slope_a_}};
        return {{a_, Field::r}, {b_, Field::r}, {a_, slope_a_}, {b_, slope_b_}};
    }
    /// Returns the number of equations.
    [[nodiscard]] int equations() const { return 3; }
    /// Returns the word that messages use.
    [[nodiscard]] std::string name() const {
        return "planar weld of node " + std::to_string(a_.index) + " and " +
               (to_space_ ? std::string("space") : "node " + std::to_string(b_.index));
    }

    /// Returns the angle that it is driven to, rad.
    [[nodiscard]] double driven_angle(double time) const { return angle_.value(time); }

    /// Returns g.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> violation(const DynamicVector<Scalar>& q,
                                                  const Scalar& time) const {
        DynamicVector<Scalar> g(3);
        g[0] = q[0];
        g[1] = q[1];
        for (int k = 0; k < 2; ++k) g[k] -= to_space_ ? Scalar(place_[k]) : q[2 + k];
        g[2] = held(turn(q, time)).value;
        return g;
    }

    /// Returns G = dg/dq.
    template <class Scalar>
    [[nodiscard]] DynamicMatrix<Scalar> jacobian(const DynamicVector<Scalar>& q,
                                                 const Scalar& time) const {
        DynamicMatrix<Scalar> g = DynamicMatrix<Scalar>::Zero(3, q.size());
        for (int k = 0; k < 2; ++k) {
            g(k, k) = Scalar(1.0);
            if (!to_space_) g(k, 2 + k) = Scalar(-1.0);
        }
        g.row(2) = held(turn(q, time)).first * angle_gradient(q).transpose();
        return g;
    }

    /// Returns g_t.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> rate(const DynamicVector<Scalar>& q,
                                             const Scalar& time) const {
        DynamicVector<Scalar> g = DynamicVector<Scalar>::Zero(3);
        g[2] =
            -held(turn(q, time)).first * detail::continued(angle_.rate, angle_.acceleration, time);
        return g;
    }

    /// Evaluates it where it stands.
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        out.violation = violation(at.q, at.time);
        out.jacobian = jacobian(at.q, at.time);
        out.rate = rate(at.q, at.time);
        const Held<double> now = held(turn(at.q, at.time));
        const VectorX gradient = angle_gradient(at.q);
        const MatrixX curvature = angle_hessian(at.q);
        out.stiffness = at.multipliers[2] *
                        (now.first * curvature + now.second * gradient * gradient.transpose());
        const VectorX bent = curvature * at.v;  // named: within the product g++ 12 warns
        const double speed = gradient.dot(at.v) - angle_.rate(at.time);
        out.convection[2] = now.first * (at.v.dot(bent) - angle_.acceleration(at.time)) +
                            now.second * speed * speed;
    }

private:
    template <class Scalar>
    struct Turn {
        Scalar sine, cosine;  // of psi = th_b - th_a - start - phi
    };

    // F sin psi and its derivatives with respect to psi; of complex numbers the second is not
    // continued.
    template <class Scalar>
    struct Held {
        Scalar value, first, second;
    };

    template <class Scalar>
    [[nodiscard]] static Held<Scalar> held(const Turn<Scalar>& psi) {
        const auto f = detail::turn_factor(std::real(psi.sine), psi.cosine);
        const Scalar s = psi.sine, c = psi.cosine;
        return {f.value * s, f.value * c - f.first * s * s,
                -(f.value * s) - s * (3.0 * f.first * c - f.second * s * s)};
    }

    static Motion resting() {
        const auto zero = [](double) { return 0.0; };
        return {zero, zero, zero};
    }

    template <class Scene>
    static Field chosen(const Scene& model, NodeId node, std::optional<Field> slope) {
        if (slope) detail::require_slope<2>("PlanarWeld", *slope);
        const bool section = model.layout().index({node, Field::r_y}) >= 0;
        return slope.value_or(section ? Field::r_y : Field::r_x);
    }

    template <class Scene>
    static double heading(const Scene& model, NodeId node, Field slope) {
        const Vector<double, 2> p = model.value(node, slope);
        detail::require(p.norm() > 0.0, "PlanarWeld: ", to_string(slope), " of node ", node.index,
                        " has no length");
        return std::atan2(p[1], p[0]);
    }

    [[nodiscard]] int place_of_a() const noexcept { return to_space_ ? 2 : 4; }

    template <class Scalar>
    [[nodiscard]] Turn<Scalar> turn(const DynamicVector<Scalar>& q, const Scalar& time) const {
        using std::cos;
        using std::sin;
        using std::sqrt;
        const Vector<Scalar, 2> a = q.template segment<2>(place_of_a());
        Vector<Scalar, 2> b(Scalar(1.0), Scalar(0.0));
        if (!to_space_) b = q.template segment<2>(6);
        const Scalar lengths = sqrt(Scalar(a.transpose() * a) * Scalar(b.transpose() * b));
        const Scalar sine = (a[0] * b[1] - a[1] * b[0]) / lengths;
        const Scalar cosine = Scalar(a.transpose() * b) / lengths;
        const Scalar target = start_ + detail::continued(angle_.value, angle_.rate, time);
        return {sine * cos(target) - cosine * sin(target),
                cosine * cos(target) + sine * sin(target)};
    }

    /// d(th_b - th_a)/dq.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> angle_gradient(const DynamicVector<Scalar>& q) const {
        DynamicVector<Scalar> d = DynamicVector<Scalar>::Zero(q.size());
        const auto add = [&](int at, double sign) {
            const Vector<Scalar, 2> p = q.template segment<2>(at);
            const Scalar square = p.transpose() * p;
            d[at] = -sign * p[1] / square;
            d[at + 1] = sign * p[0] / square;
        };
        add(place_of_a(), -1.0);
        if (!to_space_) add(6, 1.0);
        return d;
    }

    [[nodiscard]] MatrixX angle_hessian(const VectorX& q) const {
        MatrixX h = MatrixX::Zero(q.size(), q.size());
        const auto add = [&](int at, double sign) {
            const double x = q[at];
            const double y = q[at + 1];
            const double scale = sign / ((x * x + y * y) * (x * x + y * y));
            h(at, at) = 2.0 * scale * x * y;
            h(at + 1, at + 1) = -h(at, at);
            h(at, at + 1) = h(at + 1, at) = scale * (y * y - x * x);
        };
        add(place_of_a(), -1.0);
        if (!to_space_) add(6, 1.0);
        return h;
    }

    NodeId a_, b_;
    bool to_space_;
    Field slope_a_, slope_b_;
    Motion angle_;
    double start_ = 0.0;  // th_b - th_a at the start, rad
    Vector<double, 2> place_ = Vector<double, 2>::Zero();
};

}  // namespace ancf
