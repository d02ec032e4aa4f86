// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sliders: on beams against beam theory and conservation laws, on bodies against closed forms.

#include <ancf/assembly/assembly.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/constraints/slider.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace slider_test {

using namespace ancf;
template <int Dimension>
using Point = Vector<double, Dimension>;
template <int Dimension>
using Bar = CrossSectionBeam<Dimension>;

constexpr double g = 9.81;

Material steel() { return Material::isotropic(2e11, 0.3, 7800.0); }

/// Returns the point (x, 0) or (x, 0, 0).
template <int Dimension>
Point<Dimension> along(double x) {
    return Point<Dimension>::Unit(0) * x;
}

/// Moves a scene; `look` gets every snapshot.
template <class Integrator, class Look>
void run(Scene& model, const Integrator& integrator, double end, double interval,
         const Look& look) {
    DynamicProblem problem(model);
    EigenLu solver;
    Schedule schedule = equal_intervals(0.0, end, interval);
    schedule.observe = [&](const Snapshot& seen) { look(problem, seen); };
    const auto report = integrator.integrate(problem, solver, schedule);
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
}

EnergyMomentum conserving(double step) {
    EnergyMomentumOptions options;
    options.step = step;
    return EnergyMomentum(options);
}

RadauIIA accurate(double tolerance) {
    RadauOptions options;
    options.tolerance = tolerance;
    return RadauIIA(options);
}

/// Returns the tip's deflection of a cantilever of 1 m under 10 N at its tip, on a roller.
template <int Dimension>
double deflection(int elements, double roller) {
    BasicModel<Dimension> model;
    const auto beam =
        straight_beam<Bar<Dimension>>(model, steel(), rectangle(0.01, 0.01), along<Dimension>(0),
                                      along<Dimension>(1), elements, CrossSectionOptions::best());
    model.clamp(beam.first());
    const NodeId place = model.add_node(along<Dimension>(roller));
    model.add_mass(place, 1.0);
    model.pin(place);
    model.add(Slider<Dimension>(place, guide_along(model, beam)));
    const Point<Dimension> down = Point<Dimension>::Unit(Dimension - 1);
    model.add(Force<Dimension>(beam.last(), Point<Dimension>(-10.0 * down)));
    EigenLu solver;
    const auto report = solve_statics(model, solver);
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
    return -model.position(beam.last())[Dimension - 1];
}

TEST_CASE("Slider: a cantilever on a roller bends as beam theory says", "[slider][statics]") {
    // R a^3/3 = P a^2 (3 L - a)/6 at the roller a
    const double a = 0.6, force = 10.0, reaction = force * (3.0 - a) / (2.0 * a);
    const double stiffness = 2e11 * 1e-8 / 12.0;
    const double exact = (force / 3.0 - reaction * a * a * (3.0 - a) / 6.0) / stiffness;
    CHECK(deflection<2>(5, a) == Approx(exact).epsilon(2e-3));  // at a node
    CHECK(deflection<2>(8, a) == Approx(exact).epsilon(2e-3));  // within an element
    CHECK(deflection<3>(8, a) == Approx(exact).epsilon(2e-3));
    CHECK(deflection<3>(8, a) == Approx(deflection<2>(8, a)).epsilon(1e-6));
}

TEST_CASE("Slider: a force driven over a beam bends it by its influence line",
          "[slider][statics]") {
    constexpr double length = 4.0, side = 0.05, force = 200.0;
    for (const int steps : {1, 16}) {
        CAPTURE(steps);
        PlanarModel model;
        const auto beam = straight_beam<Bar<2>>(model, steel(), rectangle(side, side), {0, 0},
                                                {length, 0}, 8, CrossSectionOptions::best());
        model.pin(beam.first());
        model.fix(beam.last(), Field::r, 1);
        const NodeId point = model.add_node({0.1 * length, 0});
        model.add_mass(point, 1.0);
        model.add(Slider<2>(point, guide_along(model, beam)));
        model.add(Force<2>(point, {0.0, -force}));
        model.prescribe(point, Field::r, 0,
                        [](double factor) { return (0.1 + 0.8 * factor) * length; });
        StaticsOptions options;
        options.steps = steps;
        options.progress = [&](double factor, const State& now) {
            const double a = (0.1 + 0.8 * factor) * length, b = length - a;
            const double stiffness = 2e11 * std::pow(side, 4) / 12.0;
            const double exact = factor * force * a * a * b * b / (3.0 * stiffness * length);
            CHECK(-model.value(point, Field::r, now.q)[1] == Approx(exact).epsilon(1e-3));
            return true;
        };
        EigenLu solver;
        const auto report = solve_statics(model, solver, options);
        CHECK(report.status == Status::converged);
        CHECK(report.iterations() <= 4 * steps);
    }
}

/// Lets a mass of 20 kg roll at 5 m/s over a beam of 4 m on two supports; its place after 0.6 s.
template <int Dimension>
Point<Dimension> rolled(int elements) {
    BasicModel<Dimension> model;
    const auto beam = straight_beam<Bar<Dimension>>(
        model, steel(), rectangle(0.05, 0.05), along<Dimension>(0), along<Dimension>(4), elements);
    model.pin(beam.first());
    for (int i = 1; i < Dimension; ++i) model.fix(beam.last(), Field::r, i);
    if (Dimension == 3) model.fix(beam.first(), Field::r_y, 2);
    const NodeId mass = model.add_node(along<Dimension>(0.5));
    model.add_mass(mass, 20.0);
    const Slider<Dimension> slider(mass, guide_along(model, beam));
    model.add(slider);
    const Point<Dimension> up = Point<Dimension>::Unit(Dimension - 1);
    model.set_gravity(Point<Dimension>(-g * up));
    model.set_rate(mass, Field::r, along<Dimension>(5.0));
    std::vector<double> totals;
    run(model, conserving(1e-3), 0.6, 0.1, [&](const DynamicProblem&, const Snapshot& seen) {
        totals.push_back(seen.energies.total());
    });
    for (const double total : totals) CHECK(total == Approx(totals.front()).margin(1e-7));
    const double part = model.position(mass)[0] / 4.0;  // the beam hardly moves along
    CHECK(slider.station(model, model.state().q) == Approx(part * elements).epsilon(1e-3));
    return model.position(mass);
}

TEST_CASE("Slider: a mass rolls over a beam and keeps its energy", "[slider][dynamics][long]") {
    const auto plane = rolled<2>(4), fine = rolled<2>(8);
    const auto space = rolled<3>(4);
    CHECK(space[1] == Approx(0.0).margin(1e-12));
    CHECK(space[0] == Approx(plane[0]).epsilon(1e-9));
    CHECK(space[2] == Approx(plane[1]).margin(1e-9));
    CHECK((fine - plane).norm() < 1e-4);
}

TEST_CASE("Slider: a free beam and a mass that runs off its end keep their momenta",
          "[slider][dynamics][long]") {
    using Place = Point<3>;
    Model model;
    const auto beam = straight_beam<Bar<3>>(model, steel(), rectangle(0.02, 0.03), Place(0, 0, 0),
                                            Place(1, 0.5, 0.2), 4);
    const NodeId mass = model.add_node(Place(0.3, 0.15, 0.06));
    model.add_mass(mass, 2.0);
    const Slider<3> slider(mass, guide_along(model, beam));
    model.add(slider);
    model.set_rigid_rates(Place(1, 2, 3), Place(4, -7, 9), Place(0.2, 0.1, 0));
    std::vector<Momentum> momenta;
    run(model, conserving(1e-3), 0.15, 0.05,
        [&](const DynamicProblem& problem, const Snapshot& seen) {
            momenta.push_back(momentum(problem, seen.state));
        });
    CHECK(slider.station(model, model.state().q) < -0.1);
    for (const Momentum& now : momenta) {
        CHECK((now.linear - momenta.front().linear).norm() < 1e-9);
        CHECK((now.angular - momenta.front().angular).norm() < 1e-9);
    }
}

TEST_CASE("Slider: on a cable in space as in the plane", "[slider][dynamics]") {
    const auto place = [](auto tag) {
        constexpr int dimension = decltype(tag)::value;
        BasicModel<dimension> model;
        const auto rope = straight_beam<Cable<dimension>>(
            model, Material::isotropic(1e9, 0.3, 1000.0), circle(0.01), along<dimension>(0),
            along<dimension>(2), 4);
        model.pin(rope.first());
        model.pin(rope.last());
        const NodeId mass = model.add_node(along<dimension>(0.7));
        model.add_mass(mass, 3.0);
        Point<dimension> across = Point<dimension>::Unit(1);
        model.add(Slider<dimension>(mass, guide_along(model, rope, across)));
        const Point<dimension> up = Point<dimension>::Unit(dimension - 1);
        model.set_gravity(Point<dimension>(-g * up));
        run(model, accurate(1e-7), 0.1, 0.1, [](const DynamicProblem&, const Snapshot&) {});
        const Point<dimension> end = model.position(mass);
        return Point<2>(end[0], end[dimension - 1]);
    };
    const Point<2> plane = place(std::integral_constant<int, 2>()),
                   space = place(std::integral_constant<int, 3>());
    CHECK(plane[1] < -0.02);
    CHECK((space - plane).norm() < 1e-6);
}

/// A body that turns about Z by `speed` rad/s, and a guide on it through its node along X.
struct Turntable {
    static constexpr double speed = 3.0;
    Model model;
    NodeId table = model.add_node({0, 0, 0});

    Turntable() {
        const Matrix<double, 3> inertia = Point<3>(1, 1, 1).asDiagonal();
        add_body(model, table, 5.0, inertia);
        const Motion turn = {[](double t) { return -speed * t; }, [](double) { return -speed; },
                             [](double) { return 0.0; }};
        model.add(DrivenRevolute(model, table, {0, 0, 1}, turn));
    }

    /// The distance of a mass that slides outwards from 0.2 m.
    static double distance(double time) { return 0.2 * std::cosh(speed * time); }

    void move(double end) {
        model.set_rigid_rates(Point<3>(0, 0, 0), Point<3>(0, 0, speed), Point<3>(0, 0, 0));
        run(model, accurate(1e-8), end, end, [](const DynamicProblem&, const Snapshot&) {});
    }
};

TEST_CASE("straight_guide: a mass on a turning body slides outwards",
          "[slider][dynamics][body][long]") {
    Turntable scene;
    const NodeId mass = scene.model.add_node(along<3>(0.2));
    scene.model.add_mass(mass, 1.0);
    const Slider<3> slider(mass, straight_guide<3>(scene.model, scene.table, {2, 0, 0}));
    scene.model.add(slider);
    scene.move(1.0);
    const double distance = Turntable::distance(1.0);
    CHECK(slider.station(scene.model, scene.model.state().q) == Approx(distance).epsilon(1e-6));
    const Point<3> exact(std::cos(3.0), std::sin(3.0), 0.0);
    CHECK((scene.model.position(mass) - distance * exact).norm() < 1e-5);
}

TEST_CASE(
    "straight_guide: two points of a body make a cylindrical joint, its turn held a prismatic "
    "one",
    "[slider][dynamics][body][long]") {
    for (const bool prismatic : {false, true}) {
        Turntable scene;
        Model& model = scene.model;
        const auto guide = straight_guide<3>(model, scene.table, {1, 0, 0});
        const NodeId body = model.add_node(along<3>(0.2));
        const Matrix<double, 3> inertia = Point<3>(0.01, 0.02, 0.02).asDiagonal();
        add_body(model, body, 1.0, inertia);
        if (prismatic) {
            model.add(Slider<3>(body, guide));
            model.add(FixedOrientation(model, scene.table, body));
        } else {
            model.add(Slider<3>(body, guide));
            model.add(Slider<3>(point_of_body(model, body, {0.5, 0, 0}), guide));
        }
        scene.move(0.5);
        CHECK(model.position(body).norm() == Approx(Turntable::distance(0.5)).epsilon(1e-6));
        const Point<3> axis = model.value(body, Field::r_x);
        CHECK(axis[0] == Approx(std::cos(1.5)).margin(1e-6));
        CHECK(axis[1] == Approx(std::sin(1.5)).margin(1e-6));
    }
}

TEST_CASE("Slider: the matrix stays sparse on a long guide", "[slider]") {
    const auto entries = [](int elements) {
        PlanarModel model;
        const auto beam =
            straight_beam<Bar<2>>(model, steel(), rectangle(0.1, 0.1), {0, 0}, {1, 0}, elements);
        const NodeId mass = model.add_node({0.5, 0});
        model.add_mass(mass, 1.0);
        model.add(Slider<2>(mass, guide_along(model, beam)));
        return static_cast<double>(Assembly(model, Storage::full).tangent().nonZeros());
    };
    CHECK(entries(200) < 2.1 * entries(100));
}

TEST_CASE("Slider: its stiffness is that of one element", "[slider]") {
    PlanarModel model;
    const auto beam =
        straight_beam<Bar<2>>(model, steel(), rectangle(0.1, 0.1), {0, 0}, {1, 0}, 100);
    const NodeId point = model.add_node({0.503, 0});
    model.add_mass(point, 1.0);
    const Slider<2> slider(point, guide_along(model, beam));
    VectorX q(2 * static_cast<Eigen::Index>(slider.coupling().size()));
    Eigen::Index at = 0;
    for (const NodeField& vector : slider.coupling())
        for (int i = 0; i < 2; ++i) q[at++] = model.value(vector.node, vector.field)[i];
    ConstraintResult out;
    AnyConstraint(slider).evaluate({q, VectorX::Zero(q.size()), VectorX::Ones(1), 0.0}, out);
    // the point, r and r_x of two nodes
    CHECK(out.active.size() == 10);
    CHECK(out.stiffness.rows() == 10);
}

TEST_CASE("Slider: an end of the guide may be attached instead of welded", "[slider][statics]") {
    const auto solved = [](bool attached) {
        PlanarModel model;
        const auto bar_from = [&](double x) {
            return straight_beam<Bar<2>>(model, steel(), rectangle(0.01, 0.01), {x, 0}, {x + 1, 0},
                                         4, CrossSectionOptions::best());
        };
        const auto before = bar_from(0), guide = bar_from(1);
        model.clamp(before.first());
        if (attached)
            model.attach(guide.first(), before.last());
        else
            model.add(PlanarWeld(model, guide.first(), before.last()));
        const NodeId roller = model.add_node({1.1, 0});
        model.add_mass(roller, 1.0);
        model.pin(roller);
        model.add(Slider<2>(roller, guide_along(model, guide)));
        model.add(Force<2>(guide.last(), {0, -20}));
        EigenLu solver;
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        return std::pair(model.position(guide.last()), report.iterations());
    };
    const auto [welded, iterations] = solved(false);
    const auto [moved, iterations_of_attached] = solved(true);
    CHECK(welded[1] < -0.05);
    CHECK((moved - welded).norm() < 1e-9);
    CHECK(iterations_of_attached <= iterations + 1);
}

/// A link of two nodes that hides how its stiffness couples them.
struct Hidden : Distance<2> {
    using Distance::Distance;
    [[nodiscard]] std::vector<Coupling> stiffness_parts() const {
        return {{coupling()[0]}, {coupling()[1]}};
    }
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        out.stiffness.setZero(4, 4);
        Distance::evaluate(at, out);
    }
};

TEST_CASE("stiffness_parts: what they leave out is refused", "[constraint][bad_input]") {
    PlanarModel model;
    NodeId nodes[2];
    for (int k = 0; k < 2; ++k) {
        nodes[k] = model.add_node({1.0 * k, 0});
        model.add_mass(nodes[k], 1.0);
    }
    model.add(Hidden(nodes[0], nodes[1], 1.0));
    Assembly assembly(model, Storage::full);
    const VectorX multipliers = VectorX::Ones(1);
    const State& now = model.state();
    CHECK_THROWS_AS(
        (void)assembly.evaluate({now.q, now.v, multipliers, {0.0, 1.0}}, Request::tangent),
        InvalidArgument);
}

TEST_CASE("Slider: a bead settles at the lowest place of a bowl", "[slider][statics]") {
    PlanarModel model;
    const auto bowl =
        arc<Bar<2>>(model, steel(), rectangle(0.2, 0.2), {-std::sin(1.0), 1.0 - std::cos(1.0)},
                    {std::cos(1.0), -std::sin(1.0)}, 1.0, 2.0, 8);
    for (const NodeId node : bowl.nodes) model.clamp(node);
    const NodeId bead = model.add_node({0.02, 0.0});
    model.add_mass(bead, 1.0);
    model.add(Slider<2>(bead, guide_along(model, bowl)));
    model.set_gravity({0.0, -g});
    EigenLu solver;
    const auto report = solve_statics(model, solver);
    INFO(report.message);
    CHECK(report.status == Status::converged);
    CHECK(report.stability == Stability::stable);
    CHECK(model.position(bead).norm() < 1e-8);
}

TEST_CASE("Slider: wrong guides are refused", "[slider][bad_input]") {
    Model model;
    const auto beam =
        straight_beam<Bar<3>>(model, steel(), rectangle(0.1, 0.1), {0, 0, 0}, {1, 0, 0}, 3);
    const auto rope = straight_beam<Cable<3>>(model, steel(), circle(0.1), {0, 1, 0}, {1, 1, 0}, 1);
    CHECK_THROWS_AS(Slider<3>(beam.last(), Guide<3>()), InvalidArgument);
    Beam<Bar<3>> part;
    CHECK_THROWS_AS(guide_along(model, part), InvalidArgument);
    part.elements = {0, 2};
    CHECK_THROWS_AS(guide_along(model, part), InvalidArgument);
    part.elements = {0, 3};
    CHECK_THROWS_AS(guide_along(model, part), InvalidArgument);
    CHECK_THROWS_AS(guide_along(model, rope), InvalidArgument);
    CHECK_THROWS_AS(straight_guide<3>(model, rope.first(), {1, 0, 0}), InvalidArgument);
    CHECK_THROWS_AS(straight_guide<3>(model, beam.first(), {0, 0, 0}), InvalidArgument);
    CHECK_THROWS_AS(Slider<3>(beam.node(1), guide_along(model, beam)), InvalidArgument);
    part.elements = {0, 1};
    CHECK(guide_along(model, part).pieces.size() == 4);  // with the straight ends
    model.connect<Bar<3>>(0, beam.last(), beam.first());
    part.elements = {0, 1, 2, 3};
    CHECK(guide_along(model, part).pieces.size() == 4);  // a ring
    part.elements = {0, 1};
    CHECK_NOTHROW(Slider<3>(beam.last(), guide_along(model, part)));
}

}  // namespace slider_test
