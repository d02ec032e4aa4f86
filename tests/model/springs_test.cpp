// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Springs and dampers between points: derivatives, and scenes with a closed form.

#include <ancf/constants.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads/forces.hpp>
#include <ancf/model/loads/springs.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/load_result.hpp>
#include <support/load_theory.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace springs_test {

using namespace ancf;
using Point = Vector<double, 3>;
using Beam3 = CrossSectionBeam<3>;

constexpr double tolerance = 1e-14;  // round-off; measured 4e-16

template <int Dimension>
void check_derivatives(const MaterialPoint& a, const MaterialPoint& b, test::Random& random) {
    const auto size = static_cast<int>(Dimension * (a.vectors.size() + b.vectors.size()));
    VectorX q(size), v(size);
    for (int i = 0; i < size; ++i) {
        q[i] = random.uniform(-2.0, 2.0);
        v[i] = random.uniform(-2.0, 2.0);
    }
    test::WeightedPoints<Dimension> points{a.weights};
    for (const double weight : b.weights) points.weights.push_back(-weight);
    for (const double length : {0.0, 0.7}) {
        const Spring<Dimension> spring(a, b, 3.0, length);
        const auto force = [&](const auto& z) { return points.spring(3.0, length, z); };
        const LoadResult result = test::load_result(spring, q, v);
        const auto expected = test::complex_step_jacobian(force, q);
        CHECK(test::relative_error(result.stiffness, expected) < tolerance);
        CHECK(test::relative_error(result.force, force(q)) < tolerance);
        // U = k (l - l0)^2/2 and Q = -dU/dq: U(q) by the work along a straight way, Simpson's rule
        const VectorX aside = q + 1e-3 * v;
        const VectorX middle = 0.5 * (q + aside);
        const double work = (force(q) + 4.0 * force(middle) + force(aside)).dot(aside - q) / 6.0;
        CHECK(test::load_result(spring, aside, v).potential - result.potential ==
              Approx(-work).epsilon(1e-9));
    }
    const Damper<Dimension> damper(a, b, 0.3);
    test::check_damper(
        damper, [&](const auto& x, const auto& rate) { return points.damper(0.3, x, rate); }, q, v,
        tolerance);
}

TEST_CASE("Spring, Damper: force of the theory, derivatives equal its complex step's",
          "[model][springs]") {
    const auto seed = GENERATE(range(0U, 20U));
    INFO("seed " << seed);
    test::Random random(seed);
    const MaterialPoint along({{{0}, Field::r}, {{0}, Field::r_x}, {{1}, Field::r}},
                              {0.6, 0.1, 0.4}, "a point between the nodes 0 and 1");
    check_derivatives<2>(NodeId{0}, NodeId{1}, random);
    check_derivatives<3>(NodeId{0}, NodeId{1}, random);
    check_derivatives<2>(along, NodeId{2}, random);
    check_derivatives<3>(NodeId{2}, along, random);
}

/// A straight bar of 1 m from a point in a direction: so stiff that it moves as one mass of 2 kg.
Beam<Beam3> add_bar(Model& model, const Point& from, const Point& direction) {
    return straight_beam<Beam3>(model, Material::isotropic(2e11, 0.3, 2e4), rectangle(0.01, 0.01),
                                from, from + direction, 1);
}

DynamicsReport keep_energy(DynamicProblem& problem, double step, double end) {
    EigenLu solver;
    EnergyMomentumOptions options;
    options.step = step;
    Schedule schedule;
    schedule.end = end;
    return EnergyMomentum(options).integrate(problem, solver, schedule);
}

TEST_CASE("Spring, Damper: a bar swings and decays as the closed form", "[model][springs]") {
    constexpr double mass = 2.0, stiffness = 50.0, damping = 1.5, length = 0.4, out = 0.1;
    Model model;
    const Point direction(0.48, -0.6, 0.64), root(0.1, 0.2, 0.3);
    const NodeId end = add_bar(model, root + (length + out) * direction, direction).first();
    model.add(Spring<3>(end, root, stiffness, length));
    model.add(Damper<3>(end, root, damping));
    DynamicProblem problem(model);
    EigenLu solver;
    GeneralizedAlphaOptions options;
    options.step = 1e-3;
    Schedule schedule;
    schedule.end = 1.0;
    REQUIRE(GeneralizedAlpha(options).integrate(problem, solver, schedule).status ==
            Status::converged);
    const double decay = damping / (2.0 * mass);
    const double frequency = std::sqrt(stiffness / mass - decay * decay);
    const double x =
        out * std::exp(-decay) * (std::cos(frequency) + decay / frequency * std::sin(frequency));
    CHECK((model.position(end) - root - (length + x) * direction).norm() < 2e-5 * out);
}

TEST_CASE("Spring: EnergyMomentum keeps the energy of a bar on a spring",
          "[model][springs][long]") {
    Model model;
    const auto bar = add_bar(model, {1.0, 0.0, 0.0}, {0.8, 0.0, 0.6});
    model.add(Spring<3>(bar.first(), Point::Zero(), 80.0, 0.9));
    model.set_gravity({0.0, 0.0, -9.81});
    for (const NodeId node : {bar.first(), bar.last()}) model.set_rate(node, Field::r, {0, 1, 0});
    DynamicProblem problem(model);
    const auto report = keep_energy(problem, 0.01, 5.0);
    REQUIRE(report.status == Status::converged);
    CHECK(report.energy_drift < 1e-9);  // of some 50 J
}

TEST_CASE("Spring: between two bars it keeps energy and momenta", "[model][springs][long]") {
    Model model;
    const auto first = add_bar(model, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    const auto second = add_bar(model, {0.0, 1.0, 0.0}, {0.6, 0.0, 0.8});
    const double length = GENERATE(1.0, std::sqrt(2.0));  // stretched at the start, or not
    model.add(Spring<3>(first.last(), second.first(), 500.0, length));
    for (const NodeId node : first.nodes) model.set_rate(node, Field::r, {1.0, 2.0, 0.3});
    for (const NodeId node : second.nodes) model.set_rate(node, Field::r, {-1.0, 0.5, 2.0});
    DynamicProblem problem(model);
    const Momentum start = momentum(problem, model.state());
    const auto report = keep_energy(problem, 5e-3, 0.5);
    REQUIRE(report.status == Status::converged);
    CHECK(report.energy_drift < 1e-9);  // of 20 J
    CHECK(report.steps < 2000);         // 100, most of them divided
    const Momentum end = momentum(problem, model.state());
    CHECK((end.linear - start.linear).norm() < 1e-11 * start.linear.norm());
    CHECK((end.angular - start.angular).norm() < 1e-11 * start.angular.norm());
}

/// A spring to the origin that pulls alone, and is slack within its length.
struct Rope {
    NodeId node;
    double stiffness, length;
    [[nodiscard]] Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const LoadState& at, LoadResult& out) const {
        const double distance = at.q.norm(), stretch = std::max(0.0, distance - length);
        out.potential = 0.5 * stiffness * stretch * stretch;
        out.force = -stiffness * stretch / distance * at.q;
        if (stretch > 0.0)
            out.stiffness = -stiffness * (1.0 - length / distance) * MatrixX::Identity(3, 3) -
                            stiffness * length / std::pow(distance, 3) * at.q * at.q.transpose();
    }
};

TEST_CASE("EnergyMomentum: a load that is slack at the start keeps its energy",
          "[model][springs]") {
    Model model;
    const auto bar = add_bar(model, {0.5, 0.0, 0.0}, {1.0, 0.0, 0.0});
    model.add(Rope{bar.first(), 200.0, 1.0});
    for (const NodeId node : bar.nodes) model.set_rate(node, Field::r, {3.0, 1.0, 0.0});
    DynamicProblem problem(model);
    const auto report = keep_energy(problem, 5e-3, 1.0);
    REQUIRE(report.status == Status::converged);
    CHECK(report.energy_drift < 1e-9);  // of 10 J
}

TEST_CASE("Spring: a beam on a spring bends as both bend", "[model][springs]") {
    const Material steel = Material::isotropic(2e11, 0.0, 7800.0);
    const Section section = rectangle(0.01, 0.01);
    const double bending = 3.0 * steel.young * section.moments().yy;  // of 1 m
    for (const bool at_tip : {true, false}) {
        Model model;
        const auto beam = straight_beam<Beam3>(model, steel, section, {0, 0, 0}, {1, 0, 0}, 4);
        model.clamp(beam.first());
        model.add(Force<3>(beam.last(), {0.0, 0.0, 1e-3}));
        if (at_tip)  // of no length, so that it holds the tip in all directions
            model.add(Spring<3>(beam.last(), Point(1.0, 0.0, 0.0), bending, 0.0));
        else
            model.add(Spring<3>(point_along<Beam3>(model, beam.elements[3], 1.0),
                                Point(1.0, 0.0, -2.0), bending, 2.0));
        EigenLdlt solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        CHECK(model.position(beam.last())[2] == Approx(1e-3 / (2.0 * bending)).epsilon(3e-4));
    }
}

TEST_CASE("Scene::add_mass: a mass on a spring hangs and swings without an element",
          "[model][springs]") {
    constexpr double mass = 2.0, stiffness = 100.0;  // kg, N/m
    PlanarModel model;
    const NodeId weight = model.add_node({0.0, -1.0});
    model.add(Spring<2>(weight, {0.0, 0.0}, stiffness, 1.0));
    EigenLdlt solver;
    CHECK_THROWS_WITH(solve_statics(model, solver),
                      ContainsSubstring("no element there has one, and no mass"));
    model.add_mass(weight, mass);
    model.fix(weight, Field::r, 0);
    model.set_gravity({0.0, -9.81});
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    CHECK(model.position(weight)[1] == Approx(-1.0 - mass * 9.81 / stiffness).epsilon(1e-12));
    ModalOptions options;
    options.count = 1;
    const ModalReport modes = natural_modes(model, solver, options);
    REQUIRE(modes.status == Status::converged);
    CHECK(modes.modes[0].value == Approx(stiffness / mass).epsilon(1e-12));
}

TEST_CASE("Scene::add_mass: an attached mass beside a beam turns with it", "[model][springs]") {
    const auto kinetic = [](double mass) {
        constexpr double w = 3.0;  // rad/s, about the first node
        PlanarModel model;
        const auto rod =
            straight_beam<CrossSectionBeam<2>>(model, Material::isotropic(2e11, 0.3, 7800.0),
                                               rectangle(0.02, 0.02), {0, 0}, {1, 0}, 2);
        model.pin(rod.first());
        if (mass > 0.0) {
            const NodeId beside = model.add_node({0.5, 0.2});
            model.add_mass(beside, mass);
            model.attach(beside, rod.node(1));
        }
        for (const NodeId node : rod.nodes) {
            const auto r = model.position(node);
            model.set_rate(node, Field::r, {-w * r[1], w * r[0]});
            model.set_rate(node, Field::r_x, {0.0, w});
            model.set_rate(node, Field::r_y, {-w, 0.0});
        }
        DynamicProblem problem(model);
        EigenLu solver;
        double energy = 0.0;
        auto schedule = equal_intervals(0.0, 0.01, 0.01);
        schedule.observe = [&](const Snapshot& seen) {
            if (seen.state.time == 0.0) energy = seen.energies.kinetic;
        };
        const auto report = GeneralizedAlpha().integrate(problem, solver, schedule);
        return report.status == Status::converged ? energy : -1.0;
    };
    CHECK(kinetic(0.7) - kinetic(0.0) == Approx(0.5 * 0.7 * 9.0 * (0.25 + 0.04)).epsilon(1e-12));
}

TEST_CASE("Scene::add_mass: no mass stands beside a beam along a slope that nothing holds",
          "[model][springs][bad-input]") {
    // such a mass fell freely, 0.196 m in 0.2 s
    const auto assembled = [](auto line, const Point& arm) {
        using Line = decltype(line);
        Model model;
        const auto beam = straight_beam<Line>(model, Material::isotropic(2e11, 0.3, 7800.0),
                                              circle(0.02), {0, 0, 0}, {1, 0, 0}, 2);
        const NodeId beside = model.add_node({1.0 + arm[0], arm[1], arm[2]});
        model.add_mass(beside, 1.0);
        model.attach(beside, beam.last());
        model.add(Force<3>(beside, {0, -1, 0}));
        return DynamicProblem(model).size();
    };
    const Material steel = Material::isotropic(2e11, 0.3, 7800.0);
    const TorsionBeam beam(steel, circle(0.02), 1.0);
    const Cable<3> cable(steel, circle(0.02), 1.0);
    CHECK(assembled(beam, {0.1, 0.1, 0.0}) == 27);
    CHECK(assembled(cable, {0.1, 0.0, 0.0}) == 18);
    CHECK_THROWS_WITH(assembled(beam, {0.0, 0.0, 0.2}), ContainsSubstring("along r_z"));
    CHECK_THROWS_WITH(assembled(cable, {0.0, 0.1, 0.0}), ContainsSubstring("along r_y"));
}

TEST_CASE("Scene::attach: links between points hold the slopes that a body of masses follows",
          "[model][springs]") {
    Model model;
    const NodeId root = model.add_node({0, 0, 0});
    model.add_mass(root, 1.0);
    std::vector<NodeId> body = {root};
    for (int k = 0; k < 3; ++k) {
        const NodeId next = model.add_node(Point::Unit(k));
        model.add_mass(next, 1.0);
        model.attach(next, root);
        for (const NodeId other : body)
            model.add(Distance<3>(other, next, other == root ? 1.0 : std::sqrt(2.0)));
        body.push_back(next);
    }
    model.set_rigid_rates(Point::Zero(), Point(0, 0, 3));
    DynamicProblem problem(model);
    EigenLu solver;
    GeneralizedAlphaOptions options;
    options.step = 1e-3;
    Schedule schedule;
    schedule.end = 0.1;
    REQUIRE(GeneralizedAlpha(options).integrate(problem, solver, schedule).status ==
            Status::converged);
    Point centre = Point::Zero();
    for (const NodeId node : body) centre += 0.25 * model.position(node);
    CHECK((model.position(root) - centre).norm() == Approx(std::sqrt(3.0) / 4.0).epsilon(1e-9));
}

TEST_CASE("Spring: a column held by a spring at mid-height buckles", "[model][springs]") {
    // Half a wave each side of u = sqrt(P/(E I)) L/2: k = 4 P/(L (1 - tan(u)/u)); Euler's 2 u = pi
    const Material steel = Material::isotropic(2e11, 0.0, 7800.0);
    const Section section = rectangle(0.03, 0.01);  // soft along Y
    constexpr double u = 2.2, length = 2.0;
    const double load = 4.0 * u * u * steel.young * section.moments().yy / (length * length);
    const double stiffness = 4.0 * load / (length * (1.0 - std::tan(u) / u));
    PlanarModel model;
    const auto beam = straight_beam<CrossSectionBeam<2>>(model, steel, section, {0, 0}, {length, 0},
                                                         16, CrossSectionOptions::best());
    model.pin(beam.first());
    model.fix(beam.last(), Field::r, 1);
    model.add(Spring<2>(beam.nodes[8], {0.5 * length, 1.0}, stiffness, 1.0));
    model.add(Force<2>(beam.last(), {-load, 0.0}));
    EigenLdlt solver;
    const auto report = buckling_modes(model, solver);
    REQUIRE(report.status == Status::converged);
    CHECK(report.modes.front().value == Approx(1.0).epsilon(2e-4));
}

TEST_CASE("Spring, Damper: what cannot be meant is refused", "[model][springs][bad-input]") {
    const double infinity = std::numeric_limits<double>::infinity();
    const NodeId a{0}, b{1};
    CHECK_THROWS_AS(Spring<3>(a, b, -1.0, 1.0), InvalidArgument);
    CHECK_THROWS_AS(Spring<3>(a, b, infinity, 1.0), InvalidArgument);
    CHECK_THROWS_AS(Spring<3>(a, b, 1.0, -1.0), InvalidArgument);
    CHECK_THROWS_AS(Spring<3>(a, a, 1.0, 1.0), InvalidArgument);
    CHECK_THROWS_AS(Spring<2>(a, Vector<double, 2>(0.0, infinity), 1.0, 1.0), InvalidArgument);
    CHECK_THROWS_AS(Damper<3>(a, b, -1.0), InvalidArgument);
    CHECK_THROWS_AS(Damper<2>(b, b, 1.0), InvalidArgument);

    Model model;
    const NodeId end = add_bar(model, {1.0, 2.0, 3.0}, {1.0, 0.0, 0.0}).first();
    CHECK_THROWS_AS(model.add(Spring<3>(end, NodeId{7}, 1.0, 1.0)), InvalidArgument);
    model.add(Spring<3>(end, Point(1.0, 2.0, 3.0), 1.0, 1.0));
    CHECK(model.loads().front().scale({0.5, 0.5}) == 1.0);  // in full
    EigenLdlt solver;
    const auto report = solve_statics(model, solver);
    CHECK(report.status == Status::not_finite);
    CHECK(report.message == "the force of load 0 is not finite");
}

}  // namespace springs_test
