// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Springs and dampers of hinges: derivatives, and scenes with a closed form.

#include <ancf/constants.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/rotational_springs.hpp>
#include <ancf/model/model.hpp>
#include <ancf/model/triad.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/load_result.hpp>
#include <support/random_state.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

namespace rotational_springs_test {

using namespace ancf;
using Point = Vector<double, 3>;
using Point2 = Vector<double, 2>;
using Bar = CrossSectionBeam<3>;
using Flat = CrossSectionBeam<2>;

constexpr double tolerance = 1e-12;  // round-off; measured 1e-14

VectorX local(const Scene& model, const Coupling& coupling) {
    const int dimension = model.dimension();
    VectorX q(dimension * static_cast<int>(coupling.size()));
    for (std::size_t k = 0; k < coupling.size(); ++k)
        q.segment(dimension * static_cast<int>(k), dimension) = model.state().q.segment(
            model.coordinate(coupling[k].node, coupling[k].field), dimension);
    return q;
}

/// Returns the angle of a sine and a cosine, rad, of complex numbers continued by its derivative.
double angle_of(double s, double c) { return std::atan2(s, c); }
std::complex<double> angle_of(const std::complex<double>& s, const std::complex<double>& c) {
    return {std::atan2(s.real(), c.real()),
            (c.real() * s.imag() - s.real() * c.imag()) / (std::norm(c) + std::norm(s))};
}

/// Returns the frame of a hinge's side at its slopes, which start at q[first].
template <class S>
detail::Triad<S> frame_of(const detail::JointSide& side, const DynamicVector<S>& q, int first) {
    if (side.kind == detail::SideKind::space) return detail::Triad<S>::at_rest(side.axes);
    const auto p = detail::vec3<S>(q, first), a = detail::vec3<S>(q, first + 3);
    return side.kind == detail::SideKind::section ? detail::Triad<S>::of_section(p, a, side.share)
                                                  : detail::Triad<S>::of_slopes(p, a);
}

/// phi = atan2(s, c), s = n_A.p_B, c = p_A.p_B; p and n normal to the axis, fixed in both frames.
struct SpatialAngle {
    detail::JointSide a, b;
    std::array<detail::Vec3<double>, 2> normals;  ///< p, n as the model stands at the start

    SpatialAngle(const Model& model, const FrameAt& on_a, const FrameAt* on_b, const Point& axis)
        : a(detail::JointSide::frame(model, on_a)),
          b(on_b == nullptr ? detail::JointSide::space(model, on_a.node)
                            : detail::JointSide::frame(model, *on_b)),
          normals(detail::normals_of(detail::vec3<double>(Point(axis.normalized())))) {}

    /// Returns a normal, fixed in a side's frame, as that stands now.
    template <class S>
    [[nodiscard]] detail::Vec3<S> carried(const detail::JointSide& side,
                                          const detail::Triad<S>& now, int k) const {
        const auto& v = normals[static_cast<std::size_t>(k)];
        return now.in_space({{dot(side.axes[0], v), dot(side.axes[1], v), dot(side.axes[2], v)}});
    }

    /// Returns phi and writes phi_q = (c s_q - s c_q)/(s^2 + c^2); a carried v turns by w x v.
    template <class S>
    S operator()(const DynamicVector<S>& q, DynamicVector<S>& gradient) const {
        const auto frame_a = frame_of(a, q, 0), frame_b = frame_of(b, q, 6);
        const auto p_a = carried(a, frame_a, 0), n_a = carried(a, frame_a, 1),
                   p_b = carried(b, frame_b, 0);
        const S s = dot(n_a, p_b), c = dot(p_a, p_b);
        gradient.resize(q.size());
        for (int k = 0; k < q.size(); ++k) {
            const bool of_a = k < 6;
            const auto& spin = of_a ? frame_a.spin[k] : frame_b.spin[k - 6];
            const S by_s = of_a ? dot(cross(spin, n_a), p_b) : dot(n_a, cross(spin, p_b));
            const S by_c = of_a ? dot(cross(spin, p_a), p_b) : dot(p_a, cross(spin, p_b));
            gradient[k] = (c * by_s - s * by_c) / (s * s + c * c);
        }
        return angle_of(s, c);
    }
};

/// phi = th_B - th_A less that of the start, th the angles of the slopes; of space 0.
struct PlanarAngle {
    double start;  ///< th_B - th_A of the start, rad

    template <class S>
    S operator()(const DynamicVector<S>& q, DynamicVector<S>& gradient) const {
        const bool space = q.size() == 2;
        gradient.resize(q.size());
        for (int k = 0; k < q.size(); k += 2) {
            const S square = q[k] * q[k] + q[k + 1] * q[k + 1];
            const double sign = k == 0 ? -1.0 : 1.0;
            gradient[k] = -sign * q[k + 1] / square;
            gradient[k + 1] = sign * q[k] / square;
        }
        const S th_a = angle_of(q[1], q[0]), th_b = space ? S(0.0) : angle_of(q[3], q[2]);
        const S phi = th_b - th_a - start;
        return phi - 2.0 * pi * std::round(std::real(phi) / (2.0 * pi));
    }
};

template <class Angle, class Spring, class Damper>
void check_derivatives(const Scene& model, const Angle& angle, const Spring& spring,
                       const Damper& damper, test::Random& random) {
    const auto force = [&](const auto& x) {  // -k phi phi_q
        auto gradient = x;
        const auto phi = angle(x, gradient);
        gradient *= -3.0 * phi;
        return gradient;
    };
    const auto resistance = [&](const auto& x, const auto& rate) {  // -c (phi_q.v) phi_q
        auto gradient = x;
        (void)angle(x, gradient);
        const auto turn = (gradient.transpose() * rate).value();
        gradient *= -0.3 * turn;
        return gradient;
    };
    VectorX q = local(model, spring.coupling()), v(q.size());
    CHECK(test::load_result(spring, q, v).force.norm() <= 1e-12);  // at rest where it was made
    for (Eigen::Index i = 0; i < q.size(); ++i) {
        q[i] += random.uniform(-0.4, 0.4);
        v[i] = random.uniform(-2.0, 2.0);
    }
    const LoadResult at = test::load_result(spring, q, v);
    const auto expected = test::complex_step_jacobian(force, q);
    CHECK(test::relative_error(at.stiffness, expected) < tolerance);
    CHECK(test::relative_error(at.force, force(q)) < tolerance);
    CHECK(test::relative_error(at.stiffness, at.stiffness.transpose()) < tolerance);
    // Q = -dV/dq, by a central difference
    const double h = 1e-5;
    const double slope = (test::load_result(spring, q + h * v, v).potential -
                          test::load_result(spring, q - h * v, v).potential) /
                         (2.0 * h);
    CHECK(slope == Approx(-at.force.dot(v)).epsilon(1e-7).margin(1e-8));
    test::check_damper(damper, resistance, q, v, tolerance);
}

/// A hundred times as stiff as steel: bars hardly bend.
Material stiff() { return Material::isotropic(2e13, 0.3, 7800.0); }

Beam<Bar> bar(Model& model, const Point& from, const Point& to, int elements = 1) {
    return straight_beam<Bar>(model, stiff(), rectangle(0.02, 0.03), from, to, elements,
                              CrossSectionOptions::best());
}

Beam<Flat> flat(PlanarModel& model, const Point2& from, const Point2& to, int elements = 1) {
    return straight_beam<Flat>(model, stiff(), rectangle(0.02, 0.03), from, to, elements,
                               CrossSectionOptions::best());
}

TEST_CASE("RotationalSpring, RotationalDamper: force of the theory, derivatives by complex steps",
          "[model][springs]") {
    const auto seed = GENERATE(range(0U, 20U));
    INFO("seed " << seed);
    test::Random random(seed);
    Model model;
    const NodeId a = bar(model, {0, 0, 0}, random.vector<3>()).last(),
                 b = bar(model, {0, 0, 0}, random.vector<3>()).first();
    const Point axis = random.vector<3>();
    const FrameAt tangent(a, Field::r_x, Field::r_y);
    const FrameAt of_b(b);
    check_derivatives(model, SpatialAngle(model, a, &of_b, axis),
                      RotationalSpring(model, a, b, axis, 3.0),
                      RotationalDamper(model, a, b, axis, 0.3), random);
    check_derivatives(model, SpatialAngle(model, tangent, &of_b, axis),
                      RotationalSpring(model, tangent, b, axis, 3.0),
                      RotationalDamper(model, tangent, b, axis, 0.3), random);
    check_derivatives(model, SpatialAngle(model, b, nullptr, axis),
                      RotationalSpring(model, b, axis, 3.0), RotationalDamper(model, b, axis, 0.3),
                      random);
    PlanarModel plane;
    const NodeId c = flat(plane, {0, 0}, random.vector<2>()).last(),
                 d = flat(plane, {0, 0}, random.vector<2>()).first();
    const auto heading = [&](NodeId node) {
        const Point2 slope = plane.value(node, Field::r_y);
        return std::atan2(slope[1], slope[0]);
    };
    check_derivatives(plane, PlanarAngle{heading(d) - heading(c)},
                      PlanarRotationalSpring(plane, c, d, 3.0),
                      PlanarRotationalDamper(plane, c, d, 0.3), random);
    check_derivatives(plane, PlanarAngle{-heading(d)}, PlanarRotationalSpring(plane, d, 3.0),
                      PlanarRotationalDamper(plane, d, 0.3), random);
}

TEST_CASE("a hinge with a spring turns by the moment over its stiffness, about any axis",
          "[model][springs][statics]") {
    // Two bars; a moment about the axis of the hinge between them, up to 2.4 rad.
    const Point along = Point(0.6, -0.3, 0.5).normalized();
    const Point axis = cross(along, Point(0.2, 1.0, -0.4)).normalized(),
                across = cross(axis, along);
    int checked = 0;
    for (const double angle : {-1.3, 0.4, 2.4}) {
        Model model;
        const auto first = bar(model, Point::Zero(), 0.5 * along),
                   second = bar(model, 0.5 * along, along);
        model.clamp(first.first());
        model.add(Revolute(model, first.last(), second.first(), axis));
        model.add(RotationalSpring(model, first.last(), second.first(), axis, 20.0));
        model.add(Moment(second.last(), 20.0 * angle * axis));
        EigenLu solver;
        StaticsOptions options;
        options.steps = 4;
        const StaticsReport report = solve_statics(model, solver, options);
        CAPTURE(angle, report.message);
        REQUIRE(report.status == Status::converged);
        const Point arm =
            model.value(second.last(), Field::r) - model.value(second.first(), Field::r);
        const double turn = std::atan2(arm.dot(across), arm.dot(along));
        CHECK(std::abs(turn - angle) <= 1e-4);  // the bars bend by up to 4.5e-5 rad
        ++checked;
    }
    CHECK(checked == 3);
}

TEST_CASE(
    "a bar on a hinge with a spring and a damper swings as the closed form, in plane and space",
    "[model][springs][dynamics][long]") {
    // J phi'' + c phi' + k phi = 0 about the hinge, J = m L^2/3.
    constexpr double stiffness = 30.0, damping = 0.15, start = 0.2;
    const double inertia =
        7800.0 * 0.02 * 0.03 * (0.25 / 3.0 * 0.5) + 7800.0 * 0.5 * 0.02 * std::pow(0.03, 3) / 12.0;
    const double decay = damping / (2.0 * inertia);
    const double frequency = std::sqrt(stiffness / inertia - decay * decay);
    const double end = 0.9;
    const double expected =
        start * std::exp(-decay * end) *
        (std::cos(frequency * end) + decay / frequency * std::sin(frequency * end));
    const auto run = [&](auto& model) {
        EigenLu solver;
        DynamicProblem problem(model);
        RadauOptions options;
        options.tolerance = 1e-7;
        Schedule schedule;
        schedule.end = end;
        REQUIRE(RadauIIA(options).integrate(problem, solver, schedule).status == Status::converged);
    };
    PlanarModel plane;
    const auto rod = flat(plane, {0, 0}, {0.5, 0});
    plane.pin(rod.first());
    plane.add(PlanarRotationalSpring(plane, rod.first(), stiffness));
    plane.add(PlanarRotationalDamper(plane, rod.first(), damping));
    const auto turned = [&](const Point2& v) {
        return Point2(std::cos(start) * v[0] - std::sin(start) * v[1],
                      std::sin(start) * v[0] + std::cos(start) * v[1]);
    };
    for (const NodeId node : rod.nodes)
        for (const Field field : {Field::r, Field::r_x, Field::r_y})
            plane.set_value(node, field, turned(plane.value(node, field)));
    run(plane);
    const Point2 tip = plane.value(rod.last(), Field::r);
    CHECK(std::atan2(tip[1], tip[0]) == Approx(expected).margin(2e-4 * start));

    Model model;
    const Point axis(0.0, 0.0, 1.0);
    const auto beam = bar(model, Point::Zero(), Point(0.5, 0.0, 0.0));
    model.add(Revolute(model, beam.first(), axis));
    model.add(RotationalSpring(model, beam.first(), axis, stiffness));
    model.add(RotationalDamper(model, beam.first(), axis, damping));
    for (const NodeId node : beam.nodes)
        for (const Field field : {Field::r, Field::r_x, Field::r_y}) {
            const Point at = model.value(node, field);
            const Point2 in_plane = turned({at[0], at[1]});
            model.set_value(node, field, Point(in_plane[0], in_plane[1], at[2]));
        }
    run(model);
    const Point place = model.value(beam.last(), Field::r);
    CHECK(std::atan2(place[1], place[0]) == Approx(expected).margin(2e-4 * start));
}

TEST_CASE("EnergyMomentum keeps energy and momenta of a hinge with a spring",
          "[model][springs][dynamics][long]") {
    Model model;
    const Point axis = Point(0.1, 0.3, 1.0).normalized();
    const auto first = bar(model, {0, 0, 0}, {0.5, 0, 0}),
               second = bar(model, {0.5, 0, 0}, {1.0, 0, 0});
    model.add(Revolute(model, first.last(), second.first(), axis));
    model.add(RotationalSpring(model, first.last(), second.first(), axis, 50.0));
    model.set_rigid_rates(second.nodes, Point::Zero(), 4.0 * axis, Point(0.5, 0, 0));
    EigenLu solver;
    DynamicProblem problem(model);
    const Momentum start = momentum(problem, model.state());
    EnergyMomentumOptions options;
    options.step = 2e-3;
    Schedule schedule;
    schedule.end = 0.4;
    const DynamicsReport report = EnergyMomentum(options).integrate(problem, solver, schedule);
    REQUIRE(report.status == Status::converged);
    CHECK(report.energy_drift <= 1e-9 * report.kinetic_largest);
    const Momentum end = momentum(problem, model.state());
    CHECK((end.linear - start.linear).norm() < 1e-11 * start.linear.norm());
    // measured 1e-15; 5e-7 where a spring at rest counted as one that a turn stretches
    CHECK((end.angular - start.angular).norm() < 1e-11 * start.angular.norm());
}

TEST_CASE("rotational springs and dampers refuse what cannot be meant", "[model][springs]") {
    Model model;
    const auto beam = bar(model, {0, 0, 0}, {1, 0, 0});
    const NodeId a = beam.first(), b = beam.last();
    const Point axis(0, 0, 1);
    CHECK_THROWS_AS(RotationalSpring(model, a, a, axis, 1.0), InvalidArgument);
    CHECK_THROWS_AS(RotationalSpring(model, a, b, Point::Zero(), 1.0), InvalidArgument);
    CHECK_THROWS_AS(RotationalSpring(model, a, b, axis, -1.0), InvalidArgument);
    CHECK_THROWS_AS(RotationalDamper(model, a, axis, std::numeric_limits<double>::quiet_NaN()),
                    InvalidArgument);
    PlanarModel plane;
    const auto rod = flat(plane, {0, 0}, {1, 0});
    CHECK_THROWS_AS(PlanarRotationalSpring(plane, rod.first(), rod.first(), 1.0), InvalidArgument);
    CHECK_THROWS_AS(PlanarRotationalDamper(plane, rod.first(), -1.0), InvalidArgument);
}

}  // namespace rotational_springs_test
