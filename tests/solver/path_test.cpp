// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/path.hpp>

#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints/joints.hpp>
#include <ancf/model/constraints/planar.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/rotational_springs.hpp>
#include <ancf/model/loads/springs.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/statics.hpp>

#include <support/bar.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace path_test {

using ancf::CriticalKind;
using ancf::Field;
using ancf::Status;
using Bar = ancf::test::Bar<3>;
using Truss = ancf::Model;

constexpr double axial_stiffness = 100.0;
constexpr ancf::NodeId apex{2};

/// A bar that has no state where its end at the apex has a height within a band.
class Brittle : public Bar {
public:
    Brittle(double height, double from, double to)
        : Bar(axial_stiffness, 1.0, std::sqrt(1.0 + height * height)), from_(from), to_(to) {}

    [[nodiscard]] bool admissible(const Coordinates& e) const { return e[4] < from_ || e[4] > to_; }

private:
    double from_;
    double to_;
};

/// Two bars from (-1, 0) and (1, 0) to an apex at the given height, pushed down by a unit force.
template <class Kind>
ancf::BasicModel<Kind::dimension> make_truss(double height, const Kind& kind) {
    ancf::BasicModel<Kind::dimension> truss;
    const auto left = truss.add_node({-1, 0, 0});
    const auto right = truss.add_node({1, 0, 0});
    const auto top = truss.add_node({0, height, 0});
    const int bar = truss.add_prototype(kind);
    truss.template connect<Kind>(bar, left, top);
    truss.template connect<Kind>(bar, right, top);
    truss.pin(left);
    truss.pin(right);
    truss.fix(top, Field::r, 2);
    truss.add(ancf::Force(top, {0, -1, 0}));
    return truss;
}

Truss make_truss(double height) {
    return make_truss(height, Bar(axial_stiffness, 1.0, std::sqrt(1.0 + height * height)));
}

/// Load on the symmetric path with the apex at height y: EA (h^2 y - y^3)/l^3.
double load_at(double height, double y) {
    const double length = std::sqrt(1.0 + height * height);
    return axial_stiffness * (height * height * y - y * y * y) / (length * length * length);
}

double limit_load(double height) { return load_at(height, height / std::sqrt(3.0)); }

/// Load at which the steep truss gives way sideways: the tangent's sideways entry vanishes,
/// 1 + eps l^2 = 0 with 2 eps l^2 = y^2 - h^2.
double sideways_load(double height) { return load_at(height, std::sqrt(height * height - 2.0)); }

TEST_CASE("path: a shallow truss snaps through at its two limit loads", "[path]") {
    const auto control = GENERATE(ancf::PathControl::cylindrical, ancf::PathControl::spherical);
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = control;
    options.first_step = 0.5;
    options.last_factor = 10.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    REQUIRE(report.critical.size() == 2);
    for (const auto& critical : report.critical) CHECK(critical.kind == CriticalKind::limit);
    CHECK(report.critical[0].factor == Approx(limit_load(0.5)).epsilon(1e-9));
    CHECK(report.critical[1].factor == Approx(-limit_load(0.5)).epsilon(1e-9));
    CHECK(report.points.back().factor == 10.0);
    CHECK(-load_at(0.5, -truss.position(apex)[1]) == Approx(10.0).epsilon(1e-9));
    CHECK(report.points.front().negative_pivots == 0);
}

TEST_CASE("path: it lands just below a limit load, before the crest", "[path]") {
    const double below = GENERATE(1e-2, 1e-4, 1e-6);
    const double first_step = GENERATE(0.02, 0.1, 0.5, 2.0);
    INFO("below " << below << ", first step " << first_step);
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = first_step;
    options.last_factor = (1.0 - below) * limit_load(0.5);
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.critical.empty());
    CHECK(truss.position(apex)[1] > 0.5 / std::sqrt(3.0));
    CHECK(report.points.back().factor == *options.last_factor);
}

TEST_CASE("path: a negative first step follows the falling load", "[path]") {
    const auto control = GENERATE(ancf::PathControl::cylindrical, ancf::PathControl::spherical,
                                  ancf::PathControl::displacement);
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = control;
    options.at = {apex, Field::r};
    options.component = 1;
    options.first_step = -0.5;
    options.max_points = 30;
    SECTION("to a last factor") { options.last_factor = -5.0; }
    SECTION("and on") {}
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.points.size() >= 3);
    for (std::size_t k = 1; k < report.points.size(); ++k)
        CHECK(report.points[k].factor < report.points[k - 1].factor);
    CHECK(load_at(0.5, truss.position(apex)[1]) ==
          Approx(report.points.back().factor).epsilon(1e-7));
    CHECK(report.critical.empty());
    if (options.last_factor) {
        CHECK(report.status == Status::converged);
        CHECK(report.points.back().factor == -5.0);
    }
}

TEST_CASE("path: the landing is reported, and only the way to it counts", "[path]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    options.last_factor = 3.0;
    std::size_t seen = 0;
    options.progress = [&](const ancf::PathPoint&, const ancf::State&) { return ++seen > 0; };
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    CHECK(seen == report.points.size());
    // the only motion is that of one of three nodes, straight down; size of the scene sqrt(17)/2
    const double moved = (0.5 - truss.position(apex)[1]) / std::sqrt(17.0 / 4.0) / std::sqrt(3.0);
    CHECK(report.points.back().arc == Approx(moved).epsilon(1e-6));
}

TEST_CASE("path: it returns to the load factor that it starts from", "[path]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    options.last_factor = 0.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.points.size() > 3);
    CHECK(report.points.back().factor == 0.0);
    CHECK(std::abs(truss.position(apex)[1]) <= 1e-9);  // between the supports, without load
}

TEST_CASE("path: a step that leaps over the last factor is shortened", "[path]") {
    Truss truss = make_truss(2.0);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 20.0;
    options.last_factor = -1.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    // the load is -1 first just below the supports' line, and again near -2
    CHECK(std::abs(truss.position(apex)[1]) <= 0.1);
    CHECK(load_at(2.0, truss.position(apex)[1]) == Approx(-1.0).epsilon(1e-7));
}

TEST_CASE("path: a step that ends at the last factor but for round-off lands", "[path]") {
    // by engineering strains a straight column shortens in proportion to its load: steps of 0.1,
    // 0.2, 0.4 and 0.8 end at 1.5 less a unit in the last place
    using Column =
        ancf::CrossSectionBeam<3, ancf::Geodesic, ancf::LinearShear, ancf::EngineeringMeasure>;
    ancf::Model model;
    const auto column = ancf::straight_beam<Column>(
        model, ancf::Material::isotropic(1e9, 0.3, 1000.0), ancf::rectangle(0.05, 0.05), {0, 0, 0},
        {1, 0, 0}, 8, ancf::CrossSectionOptions::best());
    model.clamp(column.first());
    model.add(ancf::Force<3>(column.last(), {-1285.0, 0.0, 0.0}));
    ancf::EigenLdlt solver;
    for (const double last : {0.3, 0.7, 1.5, 1.2}) {
        CAPTURE(last);
        ancf::Model copy = model;
        ancf::PathOptions options;
        options.last_factor = last;
        const auto report = ancf::follow_path(copy, solver, options);
        CHECK(report.status == Status::converged);
        CHECK(report.points.back().factor == last);
        CHECK(report.points.size() <= 4);
    }
}

TEST_CASE("path: it lands where a load ends", "[path]") {
    // behind the last factor the load stands still: no state is as far as a whole step wants
    const auto control = GENERATE(ancf::PathControl::cylindrical, ancf::PathControl::displacement);
    const double load = GENERATE(100.0, 2000.0);  // N: one bends it little, one far
    ancf::PlanarModel model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
        model, ancf::Material::isotropic(2.1e11, 0.3, 7850.0), ancf::rectangle(0.02, 0.01), {0, 0},
        {2, 0}, 8, ancf::CrossSectionOptions{ancf::Rule::mixed()});
    model.clamp(beam.first());
    model.add(ancf::Force<2>(beam.last(), {0.0, load}), ancf::tabular_amplitude({{0, 0}, {1, 1}}));
    ancf::PlanarModel loaded(model);

    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = control;
    options.at = {beam.last(), Field::r};
    options.component = 1;
    options.last_factor = 1.0;
    const auto report = ancf::follow_path(model, solver, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.points.back().factor == 1.0);
    CHECK(report.points.size() < 50);  // measured: 10 to 28
    REQUIRE(ancf::solve_statics(loaded, solver).status == Status::converged);
    // measured: 5e-13 m; the corrections are as exact as 1e-6 of the length
    CHECK((model.position(beam.last()) - loaded.position(beam.last())).norm() < 1e-6);
}

TEST_CASE("path: it lands where one load ends, and goes on where the next begins", "[path]") {
    // the path has a corner there: its direction is that of one load before, of the other behind
    const double first = GENERATE(1.0, 10.0, 100.0), second = GENERATE(1.0, 10.0, 100.0);  // N
    INFO("loads " << first << " and " << second);
    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        model, ancf::Material::isotropic(2.1e11, 0.3, 7850.0), ancf::rectangle(0.01, 0.01),
        {0, 0, 0}, {1, 0, 0}, 8, ancf::CrossSectionOptions{ancf::Rule::mixed()});
    model.clamp(beam.first());
    ancf::Model loaded(model);
    const ancf::NodeId tip = beam.last();
    model.add(ancf::Force<3>(tip, {0, first, 0}), ancf::tabular_amplitude({{0, 0}, {1, 1}}));
    model.add(ancf::Force<3>(tip, {0, 0, second}), ancf::tabular_amplitude({{1, 0}, {2, 1}}));

    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.last_factor = 1.0;
    REQUIRE(ancf::follow_path(model, solver, options).status == Status::converged);
    options.first_factor = 1.0;
    options.last_factor = 2.0;
    REQUIRE(ancf::follow_path(model, solver, options).status == Status::converged);
    loaded.add(ancf::Force<3>(tip, {0, first, second}));
    REQUIRE(ancf::solve_statics(loaded, solver).status == Status::converged);
    // measured: 5e-15 m; the corrections are as exact as 1e-6 of the length
    CHECK((model.position(tip) - loaded.position(tip)).norm() < 1e-6);
}

TEST_CASE("path: it goes on from a limit point", "[path]") {
    const auto control = GENERATE(ancf::PathControl::cylindrical, ancf::PathControl::spherical);
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = control;
    options.first_step = 0.5;
    options.progress = [](const ancf::PathPoint& point, const ancf::State&) {
        return point.negative_pivots == 0;
    };
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::stopped);
    REQUIRE(report.critical.size() == 1);
    truss.state() = report.critical[0].state;
    ancf::PathOptions rest;
    rest.control = control;
    rest.first_factor = report.critical[0].factor;
    SECTION("by a first step of bounded length") {
        rest.max_points = 1;
        const auto on = ancf::follow_path(truss, solver, rest);
        REQUIRE(on.points.size() == 1);
        CHECK(on.points[0].arc <= 1.01 * rest.branch_step);
        CHECK(on.points[0].factor < limit_load(0.5));
        CHECK(load_at(0.5, truss.position(apex)[1]) == Approx(on.points[0].factor).epsilon(1e-7));
    }
    SECTION("on the side that a direction chooses") {
        rest.direction = report.critical[0].mode;
        const int coordinate = truss.coordinate(apex, Field::r) + 1;
        if (rest.direction[coordinate] > 0.0) rest.branch_step = -rest.branch_step;
        rest.last_factor = 10.0;
        const auto on = ancf::follow_path(truss, solver, rest);
        REQUIRE(on.status == Status::converged);
        REQUIRE(on.critical.size() == 1);
        CHECK(on.critical[0].factor == Approx(-limit_load(0.5)).epsilon(1e-9));
        CHECK(-load_at(0.5, -truss.position(apex)[1]) == Approx(10.0).epsilon(1e-9));
    }
}

TEST_CASE("path: every point lies on the closed path", "[path]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    options.max_points = 40;
    int seen = 0;
    options.progress = [&](const ancf::PathPoint& point, const ancf::State& state) {
        const double y = state.q[truss.coordinate(apex, Field::r) + 1];
        CHECK(std::abs(load_at(0.5, y) - point.factor) <=
              1e-7 * std::max(1.0, std::abs(point.factor)));
        ++seen;
        return y > -1.0;
    };
    const auto report = ancf::follow_path(truss, solver, options);
    CHECK(seen == static_cast<int>(report.points.size()));
    CHECK(seen >= 5);
}

TEST_CASE("path: a steep truss bifurcates sideways before its limit load", "[path]") {
    Truss truss = make_truss(2.0);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    options.last_factor = -1.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.critical.size() >= 2);
    CHECK(report.critical[0].kind == CriticalKind::bifurcation);
    CHECK(report.critical[0].factor == Approx(sideways_load(2.0)).epsilon(1e-7));
    CHECK(report.critical[1].kind == CriticalKind::limit);
    CHECK(report.critical[1].factor == Approx(limit_load(2.0)).epsilon(1e-9));

    SECTION("its mode leads to the branch, where the load falls") {
        const double side = GENERATE(-1.0, 1.0);
        truss.state() = report.critical[0].state;
        ancf::PathOptions branch;
        branch.first_factor = report.critical[0].factor;
        branch.direction = report.critical[0].mode;
        branch.branch_step = side * 0.05;
        branch.max_points = 8;
        const auto along = ancf::follow_path(truss, solver, branch);
        REQUIRE(along.points.size() == 8);
        CHECK(along.points.back().factor < 0.999 * branch.first_factor);
        const double sideways = truss.position(apex)[0];
        CHECK(std::abs(sideways) > 0.1);
        const int coordinate = truss.coordinate(apex, Field::r);
        CHECK(sideways * side * branch.direction[coordinate] > 0.0);
    }

    SECTION("a path along its mode lands on the branch, however long the first step") {
        // which is a circle, x^2 + y^2 = h^2 - 2, under a load in proportion to y
        const double share = GENERATE(0.99, 0.5, -0.5), first_step = GENERATE(0.3, 1.0, 2.0, 8.0);
        INFO("share " << share << ", first step " << first_step);
        truss.state() = report.critical[0].state;
        ancf::PathOptions branch;
        branch.first_factor = report.critical[0].factor;
        branch.direction = report.critical[0].mode;
        branch.branch_step = first_step;
        branch.last_factor = share * sideways_load(2.0);
        REQUIRE(ancf::follow_path(truss, solver, branch).status == Status::converged);
        CHECK(truss.position(apex)[1] == Approx(share * std::sqrt(2.0)).epsilon(1e-6));
        CHECK(std::abs(truss.position(apex)[0]) ==
              Approx(std::sqrt(2.0 * (1.0 - share * share))).epsilon(1e-6));
    }
}

TEST_CASE("path: one step may hold several critical points", "[path]") {
    const double first_step = GENERATE(5.0, 20.0, 40.0);
    INFO("first step " << first_step);
    Truss truss = make_truss(2.0);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = first_step;
    options.branch_step = 1.0;  // no bound of the first step
    options.last_factor = 40.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.bifurcations_sought);
    REQUIRE(report.critical.size() == 4);
    const double sideways = sideways_load(2.0), limit = limit_load(2.0);
    const double expected[] = {sideways, limit, -limit, -sideways};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& critical = report.critical[k];
        CHECK(critical.kind ==
              (k == 0 || k == 3 ? CriticalKind::bifurcation : CriticalKind::limit));
        CHECK(critical.factor == Approx(expected[k]).epsilon(1e-7));
        CHECK(critical.multiplicity == 1);
        CHECK(critical.half_width <= 1e-8);  // 2^-31 of a step
    }
}

TEST_CASE("path: two bars that buckle at once bifurcate, whatever the step", "[path]") {
    // the tangent is singular twice, so that the direction of the path is round-off nearby
    const double height = GENERATE(0.1, 0.12, 0.2);
    const double first_step = GENERATE(3.0, 10.0, 20.0, 30.0);
    const auto control = GENERATE(ancf::PathControl::displacement, ancf::PathControl::cylindrical);
    CAPTURE(height, first_step);
    ancf::PlanarModel truss;
    const auto bars = ancf::net<ancf::Cable<2, ancf::EngineeringAxial>>(
        truss, {{ancf::Material::isotropic(1e9, 0.3, 1000.0), ancf::rectangle(0.02, 0.02)}},
        {{-1.0, 0.0}, {0.0, height}, {1.0, 0.0}}, {{0, 1, 0, 1}, {1, 2, 0, 1}});
    truss.pin(bars.joints[0]);
    truss.pin(bars.joints[2]);
    truss.add(ancf::Force<2>(bars.joints[1], {0.0, -1.0}));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = control;
    options.at = {bars.joints[1], Field::r};
    options.component = 1;
    options.first_step = first_step;
    options.last_factor = 1000.0;  // below the limit load of the highest truss alone
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    int limits = 0, bifurcations = 0;
    for (const auto& critical : report.critical) {
        const bool crest = std::abs(critical.factor) > (height == 0.2 ? 1000.0 : 150.0);
        CHECK((critical.kind == CriticalKind::limit) == crest);
        ++(crest ? limits : bifurcations);
    }
    CHECK(limits == (height == 0.2 ? 0 : 2));
    CHECK(bifurcations >= (height == 0.2 ? 2 : 4));  // a double one may be told apart
}

TEST_CASE("path: it does not leap to another branch near a bifurcation", "[path]") {
    // a small force aside leaves limit points alone: the branches do not meet
    const double aside = GENERATE(1e-1, 1e-2, 1e-3, 1e-4);
    const double first_step = GENERATE(0.5, 2.0, 5.0, 10.0);
    INFO("aside " << aside << ", first step " << first_step);
    Truss truss = make_truss(2.0);
    truss.add(ancf::Force(apex, {aside, 0, 0}));
    ancf::EigenLdlt counts;
    ancf::EigenLu counts_none;
    ancf::LinearSolver& solver =
        GENERATE(true, false) ? static_cast<ancf::LinearSolver&>(counts) : counts_none;
    INFO(solver.name());
    ancf::PathOptions options;
    options.first_step = first_step;
    options.branch_step = 1.0;  // no bound of the first step
    options.last_factor = 40.0;
    options.max_points = 400;
    const auto report = ancf::follow_path(truss, solver, options);
    CHECK(report.status == Status::converged);
    REQUIRE(report.critical.size() >= 4);
    for (const auto& critical : report.critical) CHECK(critical.kind == CriticalKind::limit);
    // aside of the apex first, then over it and back by the other side
    CHECK(report.critical[0].factor < sideways_load(2.0));
    CHECK(report.critical[1].factor < -sideways_load(2.0));
    CHECK(report.critical[2].factor == Approx(-report.critical[1].factor).epsilon(1e-9));
    CHECK(report.critical[3].factor == Approx(-report.critical[0].factor).epsilon(1e-9));
}

TEST_CASE("path: a bisection that breaks off says how far it came", "[path]") {
    // no state within 0.01 of the apex at the limit load
    const double y = 0.5 / std::sqrt(3.0);
    auto truss = make_truss(0.5, Brittle(0.5, y - 0.01, y + 0.01));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 1.0;
    options.last_factor = -1.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    REQUIRE(report.critical.size() == 1);
    // half of the gap at least, in the measure of the path
    const double gap = 0.01 / std::sqrt(17.0 / 4.0) / std::sqrt(3.0);
    CHECK(report.critical[0].half_width >= gap);
    CHECK(report.critical[0].half_width <= 4.0 * gap);
    CHECK(report.critical[0].kind == CriticalKind::limit);
}

TEST_CASE("path: a path that ends names the element that failed", "[path]") {
    auto truss = make_truss(0.5, Brittle(0.5, -1.0, 0.4));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    const auto report = ancf::follow_path(truss, solver, options);
    CHECK(report.status == Status::diverged);
    CHECK(report.failure == Status::degenerate);
    REQUIRE(report.fault);
    CHECK(report.fault->status == Status::degenerate);
    CHECK(report.fault->group == 0);
    CHECK(report.fault->element == 0);
    SECTION("one that goes well names none") {
        Truss sound = make_truss(0.5);
        options.last_factor = 1.0;
        const auto whole = ancf::follow_path(sound, solver, options);
        CHECK(whole.failure == Status::converged);
        CHECK_FALSE(whole.fault);
    }
}

TEST_CASE("path: one whose smallest step is the least number above zero fails too", "[path]") {
    Truss truss = make_truss(0.5);
    truss.add(ancf::Force(apex, {0.3, 0, 0}), [calls = 0](double factor) mutable {
        return ++calls > 6 ? std::numeric_limits<double>::quiet_NaN() : factor;
    });
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.smallest_step = std::numeric_limits<double>::denorm_min();
    CHECK(ancf::follow_path(truss, solver, options).status == Status::diverged);
}

TEST_CASE("path: one that fails at a start out of balance says so", "[path]") {
    Truss truss = make_truss(0.5);
    truss.add(ancf::Force(apex, {0.3, 0, 0}));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.wanted_iterations = options.max_iterations = 1;
    options.smallest_step = 1.0;
    const auto balanced = ancf::follow_path(truss, solver, options);
    REQUIRE(balanced.status == Status::diverged);
    CHECK_THAT(balanced.message, !ContainsSubstring("out of balance"));
    truss.add(ancf::Force(apex, {0, -0.1, 0}), [](double) { return 1.0; });  // also at factor 0
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::diverged);
    CHECK_THAT(report.message, ContainsSubstring("out of balance: solve_statics() first"));
}

TEST_CASE("path: a start out of balance is told where the path goes on from it", "[path]") {
    Truss truss = make_truss(0.5);
    truss.add(ancf::Force(apex, {0.3, 0, 0}));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.max_points = 2;
    const auto balanced = ancf::follow_path(truss, solver, options);
    REQUIRE(balanced.status == Status::max_iterations);
    CHECK_THAT(balanced.message, !ContainsSubstring("out of balance"));
    truss.add(ancf::Force(apex, {0, -0.01, 0}), [](double) { return 1.0; });  // also at factor 0
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::max_iterations);
    REQUIRE(report.points.size() == 2);
    CHECK_THAT(report.message, ContainsSubstring("out of balance: solve_statics() first"));
}

TEST_CASE("path: a start out of balance is told wherever the last attempt went", "[path]") {
    // the round-off of the start was measured by the tangent of that attempt: in four of these
    // scenes it hid what the spring leaves of balance
    using Beam = ancf::CrossSectionBeam<2>;
    const auto rubber = ancf::Material::isotropic(2e7, 0.3, 1000.0);
    const auto section = ancf::rectangle(0.05, 0.05);
    int checked = 0;
    for (int k = 0; k < 24; ++k) {
        const double angle = 0.1 * k - 1.2;
        ancf::PlanarModel model;
        const auto upper = ancf::straight_beam<Beam>(model, rubber, section, {0, 0}, {1, 0}, 3);
        const auto lower = ancf::straight_beam<Beam>(model, rubber, section, {1, 0},
                                                     {1.0 + std::cos(angle), std::sin(angle)}, 2);
        model.pin(upper.first());
        model.add(ancf::PlanarRotationalSpring(model, upper.first(), 30.0));
        model.add(ancf::Pin<2>(upper.last(), lower.first()));
        model.add(ancf::PlanarRotationalSpring(model, upper.last(), lower.first(), 30.0));
        model.add(ancf::Spring<2>(lower.last(), {1.6, 0.5}, 200.0, 0.2));  // in full at factor 0
        model.add(ancf::Force<2>(lower.last(), {0.0, 5.0}));
        ancf::EigenLu solver;
        ancf::PathOptions options;
        options.last_factor = 1.0;
        options.first_step = 0.02;
        const auto report = ancf::follow_path(model, solver, options);
        CAPTURE(k, report.message);
        CHECK(report.status == Status::diverged);
        CHECK_THAT(report.message, ContainsSubstring("out of balance: solve_statics() first"));
        ++checked;
    }
    CHECK(checked == 24);
}

/// A guide that turns with the load factor about the truss's apex at rest.
struct TurningGuide {
    double height;
    double turn;  // rad per unit of the load factor

    [[nodiscard]] ancf::Coupling coupling() const { return {{apex, Field::r}}; }
    [[nodiscard]] int equations() const { return 1; }
    [[nodiscard]] std::string name() const { return "turning guide"; }
    void evaluate(const ancf::ConstraintState& at, ancf::ConstraintResult& out) const {
        const double c = std::cos(turn * at.time), s = std::sin(turn * at.time);
        out.violation[0] = c * at.q[0] + s * (at.q[1] - height);
        out.jacobian << c, s, 0.0;
        out.rate[0] = turn * (c * (at.q[1] - height) - s * at.q[0]);
    }
};

TEST_CASE("path: constraints move with the load factor", "[path]") {
    ancf::EigenLu solver;
    ancf::PathOptions options;
    options.first_step = 0.25;
    options.last_factor = 1.0;
    Truss truss = make_truss(0.5);
    SECTION("a coordinate, which takes the truss through its limit points") {
        const auto zero = [](double) { return 0.0; };
        truss.add(ancf::FixedCoordinate<3>(
            apex, Field::r, 1,
            ancf::Motion{[](double f) { return 0.5 - f; }, [](double) { return -1.0; }, zero}));
        const auto report = ancf::follow_path(truss, solver, options);
        REQUIRE(report.status == Status::converged);
        CHECK(report.points.size() <= 4);
        for (const auto& point : report.points) CHECK(point.iterations <= 3);
        CHECK(truss.position(apex)[1] == Approx(-0.5).epsilon(1e-9));
        // stress-free again: the guide holds what the load pushes
        CHECK(std::abs(truss.state().multipliers[0]) == Approx(1.0).epsilon(1e-7));
    }
    SECTION("a guide whose direction turns") {
        truss.add(TurningGuide{0.5, 0.3});
        Truss expected = truss;
        const auto report = ancf::follow_path(truss, solver, options);
        REQUIRE(report.status == Status::converged);
        REQUIRE(ancf::solve_statics(expected, solver).status == Status::converged);
        CHECK((truss.state().q - expected.state().q).norm() <= 1e-9);
        CHECK(std::abs(truss.state().multipliers[0]) > 1e-3);
    }
}

/// A cantilever of length 1 under its Euler load, as if of a square section with that height.
template <class Element, class Axis>
ancf::BasicModel<Element::dimension> make_column(double width, double height, int elements,
                                                 const Axis& tip) {
    constexpr double young = 2.07e11;
    ancf::CrossSectionOptions options;
    options.rule = ancf::Rule::mixed();
    ancf::BasicModel<Element::dimension> scene;
    const Axis start = Axis::Zero();
    const auto beam =
        ancf::straight_beam<Element>(scene, ancf::Material::isotropic(young, 0.3, 7850.0),
                                     ancf::rectangle(width, height), start, tip, elements, options);
    scene.clamp(beam.first(), ancf::Clamp::free_slope);
    const double euler = ancf::pi * ancf::pi / 4.0 * young * std::pow(height, 4) / 12.0;
    scene.add(ancf::Force<Element::dimension>(beam.last(), -euler * tip));
    return scene;
}

TEST_CASE("path: a column bends onto its elastica with the steps as they come", "[path]") {
    using Element = ancf::CrossSectionBeam<2>;
    auto column = make_column<Element>(0.01, 0.01, 16, ancf::Vector<double, 2>(1, 0));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.last_factor = 2.0;
    const auto straight = ancf::follow_path(column, solver, options);
    REQUIRE(straight.status == Status::converged);
    REQUIRE(straight.critical.size() == 1);
    CHECK(straight.critical[0].kind == CriticalKind::bifurcation);
    CHECK(straight.critical[0].factor == Approx(1.0).epsilon(1e-3));

    column.state() = straight.critical[0].state;
    ancf::PathOptions branch;
    branch.first_factor = straight.critical[0].factor;
    branch.direction = straight.critical[0].mode;
    branch.last_factor = 1.151719620469;
    branch.control = GENERATE(ancf::PathControl::cylindrical, ancf::PathControl::spherical,
                              ancf::PathControl::displacement);
    branch.at = {{16}, Field::r};
    branch.component = 1;
    const auto bent = ancf::follow_path(column, solver, branch);
    REQUIRE(bent.status == Status::converged);
    CHECK(bent.points.size() <= 40);
    // the elastica whose tip has turned by 60 degrees; shear and strain of h/L = 1/100 take 3e-4
    CHECK(column.position({16})[0] == Approx(0.74102).margin(1e-3));
    CHECK(std::abs(column.position({16})[1]) == Approx(0.59321).margin(1e-3));
}

TEST_CASE("path: a branch step that fails is halved", "[path]") {
    using Element = ancf::CrossSectionBeam<2>;
    auto column = make_column<Element>(0.001, 0.001, 8, ancf::Vector<double, 2>(1, 0));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.last_factor = 2.0;
    const auto straight = ancf::follow_path(column, solver, options);
    REQUIRE(straight.critical.size() == 1);
    column.state() = straight.critical[0].state;
    ancf::PathOptions branch;
    branch.first_factor = straight.critical[0].factor;
    branch.direction = straight.critical[0].mode;
    branch.branch_step = 4.0;
    branch.max_points = 1;
    const auto bent = ancf::follow_path(column, solver, branch);
    REQUIRE(bent.points.size() == 1);
    CHECK(bent.points[0].arc < 0.5 * branch.branch_step);
    CHECK(bent.failure != Status::converged);
}

TEST_CASE("path: close bifurcations of a column are told apart or counted", "[path]") {
    using Element = ancf::CrossSectionBeam<3>;
    const double width = GENERATE(0.01, 0.0102);
    INFO("width " << width);
    auto column = make_column<Element>(width, 0.01, 4, ancf::Vector<double, 3>(1, 0, 0));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.last_factor = 2.0;
    const auto report = ancf::follow_path(column, solver, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.points.back().negative_pivots == 2);
    int sum = 0;
    for (const auto& critical : report.critical) {
        CHECK(critical.kind == CriticalKind::bifurcation);
        sum += critical.multiplicity;
    }
    CHECK(sum == 2);
    if (width == 0.01) return;
    REQUIRE(report.critical.size() == 2);
    // about one axis the load is as width^3 height, about the other as width height^3
    CHECK(report.critical[1].factor / report.critical[0].factor ==
          Approx(1.02 * 1.02).epsilon(1e-4));
}

/// Watches the angle between successive steps: the cosine is -1 where a path travels back.
class Turns {
public:
    void see(const ancf::VectorX& q) {
        if (last_.size() > 0) {
            const ancf::VectorX step = q - last_;
            if (before_.size() > 0) {
                least_ = std::min(least_, step.dot(before_) / (step.norm() * before_.norm()));
                ++seen_;
            }
            before_ = step;
        }
        last_ = q;
    }
    [[nodiscard]] double least() const { return least_; }
    [[nodiscard]] int seen() const { return seen_; }

private:
    ancf::VectorX last_, before_;
    double least_ = 1.0;
    int seen_ = 0;
};

using Planar = ancf::CrossSectionBeam<2>;

ancf::CrossSectionOptions mixed() {
    ancf::CrossSectionOptions options;
    options.rule = ancf::Rule::mixed();
    return options;
}

ancf::Section section_of(double area, double second) {
    ancf::Moments moments;
    moments.area = area;
    moments.yy = moments.zz = second;
    return ancf::Section::from_moments(moments).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
}

using Engineering =
    ancf::CrossSectionBeam<2, ancf::Projected, ancf::LinearShear, ancf::EngineeringMeasure>;

/// A circular arch under a force in its middle, and how its path is to be followed.
struct Arch {
    int elements;
    double degrees, first_step;
    bool clamped = true;  ///< at its first end; hinged otherwise, as the second one
    double unit = 1.0;    ///< of length
};

std::ostream& operator<<(std::ostream& out, const Arch& arch) {
    return out << arch.elements << " elements, " << arch.degrees << " degrees, first step "
               << arch.first_step << (arch.clamped ? ", clamped" : ", hinged") << ", unit "
               << arch.unit;
}

/// What was seen of a path.
struct Followed {
    Turns turns;
    ancf::PathReport report;
};

/// Follows 100 points of the path of an arch: radius 100, EA 1e8, EI 1e6.
template <class Element>
Followed follow(const Arch& arch) {
    ancf::PlanarModel scene;
    const double unit = arch.unit, half = arch.degrees * ancf::pi / 360.0;
    const auto beam = ancf::arc<Element>(scene, ancf::Material::isotropic(1e8, 0.0, 1.0),
                                         section_of(unit * unit, 0.01 * std::pow(unit, 4)), {0, 0},
                                         {std::cos(half), std::sin(half)}, 100.0 * unit,
                                         -2.0 * half, arch.elements, mixed());
    if (arch.clamped)
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
    else
        scene.pin(beam.first());
    scene.pin(beam.last());
    const double load = (arch.degrees < 100 ? 3600.0 : 900.0) * unit * unit;
    scene.add(ancf::Force<2>(beam.node(arch.elements / 2), {0, -load}));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = arch.first_step;
    options.max_points = 100;
    Followed result;
    options.progress = [&](const ancf::PathPoint& point, const ancf::State& state) {
        result.turns.see(state.q);
        return std::abs(point.factor) < 10.0;
    };
    result.report = ancf::follow_path(scene, solver, options);
    return result;
}

TEST_CASE("path: circular arches are followed without a turn back", "[path]") {
    const double unit = GENERATE(1.0, 1e-6);
    // Newton's method lands behind the last point of the first six, in one unit or the other
    const Arch arches[] = {{8, 120, 0.3}, {12, 60, 0.02}, {12, 120, 0.02}, {16, 60, 0.02},
                           {24, 60, 0.3}, {24, 60, 0.02}, {16, 215, 0.1},  {8, 215, 0.3}};
    int checked = 0;
    for (Arch arch : arches) {
        arch.unit = unit;
        INFO(arch);
        const Followed path = follow<Planar>(arch);
        CHECK(path.turns.seen() >= 40);
        CHECK(path.turns.least() > 0.0);
        CHECK(path.report.critical.size() >= 1);
        ++checked;
    }
    CHECK(checked == 8);
}

/// Follows an arch from first steps of three lengths and checks that all take one path.
template <class Element>
int check_arches(int elements, double degrees, bool clamped) {
    int checked = 0;
    std::vector<ancf::CriticalPoint> limits;  // by the path that got farthest
    for (const double first_step : {0.02, 0.1, 0.3}) {
        const Arch arch{elements, degrees, first_step, clamped};
        INFO(arch);
        const Followed path = follow<Element>(arch);
        CHECK(path.turns.seen() >= 20);
        // A point lies within 60 degrees of the direction there, so two steps differ by 120 at
        // most. Hinged arches of 60 degrees bend so sharply in long steps, measured -0.16; steps
        // of a tenth have 0.95 there and find the same loads.
        CHECK(path.turns.least() > -0.5);
        std::vector<ancf::CriticalPoint> found;
        for (const auto& critical : path.report.critical)
            if (critical.kind == CriticalKind::limit) found.push_back(critical);
        CHECK(found.size() >= 1);
        for (const auto& limit : found) CHECK(limit.half_width <= 1e-6);
        for (std::size_t k = 0; k < std::min(found.size(), limits.size()); ++k)
            CHECK(found[k].factor == Approx(limits[k].factor).epsilon(1e-6));
        if (found.size() > limits.size()) limits = found;
        ++checked;
    }
    return checked;
}

TEST_CASE("path: arches take one path whatever the first step", "[path]") {
    // 25 of them travelled back before corrections were held to the path's direction
    int checked = 0;
    for (const int elements : {8, 12, 16, 20, 24, 28, 32, 40})
        for (const double degrees : {60.0, 120.0, 215.0})
            for (const bool clamped : {true, false}) {
                checked += check_arches<Planar>(elements, degrees, clamped);
                checked += check_arches<Engineering>(elements, degrees, clamped);
            }
    CHECK(checked == 288);
}

/// Lee's frame: two legs of 120, the load of 1e4 f at a fifth of the second one; both limit loads.
template <class Element>
std::pair<double, double> limit_loads_of_lee(int elements, double least_cosine,
                                             const typename Element::Options& choices) {
    INFO(elements << " elements a leg");
    ancf::PlanarModel scene;
    const auto section = section_of(6.0, 2.0);
    const auto material = ancf::Material::isotropic(7.2e6, 0.3, 1.0);
    const auto column =
        ancf::straight_beam<Element>(scene, material, section, {0, 0}, {0, 120}, elements, choices);
    const auto beam = ancf::straight_beam<Element>(scene, material, section, {0, 120}, {120, 120},
                                                   elements, choices);
    scene.pin(column.first());
    scene.pin(beam.last());
    scene.add(ancf::PlanarWeld(scene, column.last(), beam.first(), Field::r_y));
    scene.add(ancf::Force<2>(beam.node(elements / 5), {0, -1e4}));
    ancf::EigenLu solver;
    ancf::PathOptions options;
    options.first_step = 0.1;
    options.max_points = 400;
    Turns turns;
    options.progress = [&](const ancf::PathPoint& point, const ancf::State& state) {
        turns.see(state.q);
        return point.factor < 2.0;
    };
    const auto report = ancf::follow_path(scene, solver, options);
    REQUIRE(report.status == Status::stopped);
    CHECK(turns.seen() >= 40);
    CHECK(turns.least() > least_cosine);
    REQUIRE(report.critical.size() == 2);
    return {1e4 * report.critical[0].factor, 1e4 * report.critical[1].factor};
}

TEST_CASE("path: Lee's frame of five elements a leg does not travel back", "[path]") {
    // Green's strain; docs/hard-cases.md
    const auto loads = limit_loads_of_lee<Planar>(5, 0.5, mixed());  // 0.88
    // of this mesh, as smaller steps find them; Reissner's are 18545 and -9392
    CHECK(loads.first == Approx(18495.106).epsilon(1e-6));
    CHECK(loads.second == Approx(-9265.682).epsilon(1e-6));
}

/// Limit loads of Reissner's theory, and of Green's strain, whose second one is 2.9e-3 off and
/// whose first one 7e-4: values of 80 elements a leg.
const std::pair<double, double> reissner_of_lee(18544.52, -9392.49);
const std::pair<double, double> green_of_lee(18530.88, -9365.11);

TEST_CASE("path: Lee's frame has its limit loads on any mesh, by both measures", "[path]") {
    int checked = 0;
    for (const int elements : {5, 10, 20, 30, 40}) {
        CAPTURE(elements);
        const auto engineering = limit_loads_of_lee<Engineering>(elements, 0.5, mixed());  // 0.84
        const auto published = limit_loads_of_lee<Planar>(elements, 0.5, mixed());         // 0.88
        // measured with 10: 1.4e-3 and 6.6e-4
        const double bound = elements < 10 ? 2.1e-2 : 1.5e-3;
        CHECK(engineering.first == Approx(reissner_of_lee.first).epsilon(bound));
        CHECK(engineering.second == Approx(reissner_of_lee.second).epsilon(bound));
        CHECK(published.first == Approx(green_of_lee.first).epsilon(bound));
        CHECK(published.second == Approx(green_of_lee.second).epsilon(bound));
        if (elements == 40) {  // their difference is no error of the mesh
            CHECK(engineering.second == Approx(reissner_of_lee.second).epsilon(1e-5));
            CHECK(published.second == Approx(green_of_lee.second).epsilon(1e-5));
        }
        ++checked;
    }
    CHECK(checked == 5);
}

template <class Measure>
using Quintic =
    ancf::CrossSectionBeam<2, ancf::Projected, ancf::CubicShear, Measure, ancf::QuinticLine>;

TEST_CASE("path: Lee's frame has its limit loads with five quintic elements a leg", "[path]") {
    const auto engineering = limit_loads_of_lee<Quintic<ancf::EngineeringMeasure>>(5, 0.5, {});
    CHECK(engineering.first == Approx(reissner_of_lee.first).epsilon(1e-5));      // 1.4e-6
    CHECK(engineering.second == Approx(reissner_of_lee.second).epsilon(1.5e-4));  // 8e-5
    const auto published = limit_loads_of_lee<Quintic<ancf::GreenMeasure>>(5, 0.5, {});
    CHECK(published.first == Approx(green_of_lee.first).epsilon(1e-5));
    CHECK(published.second == Approx(green_of_lee.second).epsilon(1.5e-4));  // 6.5e-5
}

/// Follows the path of a loaded cantilever whose root turns as a motion of the factor says.
ancf::PathReport follow_turned(const ancf::Motion& motion, const ancf::PathOptions& options) {
    ancf::PlanarModel scene;
    const auto beam =
        ancf::straight_beam<Planar>(scene, ancf::Material::isotropic(2e11, 0.3, 7850.0),
                                    section_of(6e-4, 2e-8), {0, 0}, {1, 0}, 3, mixed());
    scene.add(ancf::PlanarWeld(scene, beam.first(), motion));
    scene.add(ancf::Force<2>(beam.last(), {0, -100.0}));
    ancf::EigenLu solver;
    return ancf::follow_path(scene, solver, options);
}

TEST_CASE("path: a joint that the start does not fulfil is named", "[path][bad-input]") {
    const auto none = [](double) { return 0.0; };
    for (const double angle : {1.2, 2.5, 4.0}) {
        CAPTURE(angle);
        const auto report = follow_turned({[=](double) { return -angle; }, none, none}, {});
        CHECK(report.status == Status::diverged);
        CHECK_THAT(report.message, ContainsSubstring("constraint 0 (") &&
                                       ContainsSubstring("solve_statics() first"));
    }
    // one that moves from where it stands is not to blame
    ancf::PathOptions options;
    options.max_iterations = options.wanted_iterations = 1;
    options.smallest_step = 0.9;
    const auto report =
        follow_turned({[](double f) { return -f; }, [](double) { return -1.0; }, none}, options);
    CHECK(report.status == Status::diverged);
    CHECK(report.points.empty());
    CHECK_THAT(report.message, !ContainsSubstring("fulfilled"));
}

TEST_CASE("path: it passes the crest of a load that falls again with its factor", "[path]") {
    Truss truss;
    const auto left = truss.add_node({-1, 0, 0});
    const auto right = truss.add_node({1, 0, 0});
    const auto top = truss.add_node({0, 0.5, 0});
    const int bar = truss.add_prototype(Bar(axial_stiffness, 1.0, std::sqrt(1.25)));
    truss.connect<Bar>(bar, left, top);
    truss.connect<Bar>(bar, right, top);
    truss.pin(left);
    truss.pin(right);
    truss.fix(top, Field::r, 2);
    truss.add(ancf::Force(top, {0, -1, 0}), [](double factor) { return std::sin(factor); });
    const ancf::State start = truss.state();
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = ancf::PathControl::spherical;
    options.first_step = 0.3;
    options.last_factor = 2.0 * ancf::pi;
    double before = 0.0;
    options.progress = [&](const ancf::PathPoint& point, const ancf::State&) {
        CHECK(point.factor > before);
        before = point.factor;
        return true;
    };
    const auto report = ancf::follow_path(truss, solver, options);
    CHECK(report.points.size() >= 5);
    SECTION("by coordinates and factor") {
        REQUIRE(report.status == Status::converged);
        CHECK(truss.position(apex)[1] == Approx(0.5).epsilon(1e-9));  // back at the start
    }
    SECTION("which coordinates alone do not tell from travelling back") {
        truss.state() = start;
        before = 0.0;
        options.control = ancf::PathControl::cylindrical;
        const auto stuck = ancf::follow_path(truss, solver, options);
        CHECK(stuck.status == Status::diverged);
        CHECK(stuck.failure != Status::converged);
        CHECK(stuck.points.back().factor < 0.5 * ancf::pi);
    }
}

TEST_CASE("path: displacement control passes the limit point of the load", "[path]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = ancf::PathControl::displacement;
    options.at = {apex, Field::r};
    options.component = 1;
    options.first_step = 1.0;
    options.progress = [](const ancf::PathPoint&, const ancf::State& state) {
        return state.q[7] > -0.45;
    };
    const auto report = ancf::follow_path(truss, solver, options);
    CHECK(report.status == Status::stopped);
    CHECK(truss.position(apex)[1] <= -0.45);
    REQUIRE(report.critical.size() == 2);
    CHECK(report.critical[0].factor == Approx(limit_load(0.5)).epsilon(1e-9));
}

TEST_CASE("path: displacement control names a coordinate that turns back", "[path]") {
    // the apex is pushed through a long bar, which springs back as the truss snaps through
    Truss truss = make_truss(0.5);
    truss.add(ancf::Force(apex, {0, 1, 0}));  // takes back the load of the apex
    const auto pushed = truss.add_node({0, 10.5, 0});
    truss.connect<Bar>(truss.add_prototype(Bar(axial_stiffness, 1.0, 10.0)), apex, pushed);
    for (const int across : {0, 2}) truss.fix(pushed, Field::r, across);
    truss.fix(apex, Field::r, 0);
    truss.add(ancf::Force(pushed, {0, -1, 0}));
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.at = {pushed, Field::r};
    options.component = 1;
    options.last_factor = -0.9 * limit_load(0.5);
    SECTION("by displacement") {
        options.control = ancf::PathControl::displacement;
        const auto report = ancf::follow_path(truss, solver, options);
        CHECK(report.status == Status::diverged);
        CHECK_THAT(report.message, Catch::Contains("turn back in the controlled coordinate"));
    }
    SECTION("by arc length") {
        const auto report = ancf::follow_path(truss, solver, options);
        CHECK(report.status == Status::converged);
        CHECK(report.critical.size() == 1);
    }
}

/// One that tells nothing of pivots, as solvers that iterate.
class Blind : public ancf::LinearSolver {
public:
    [[nodiscard]] ancf::Storage storage() const noexcept override { return lu_.storage(); }
    void analyze(const ancf::SparseMatrix& matrix) override { lu_.analyze(matrix); }
    [[nodiscard]] ancf::FactorReport factorize(const ancf::SparseMatrix& matrix) override {
        return lu_.factorize(matrix);
    }
    void solve(const ancf::VectorX& b, ancf::VectorX& x) const override { lu_.solve(b, x); }
    [[nodiscard]] std::string_view name() const noexcept override { return "blind"; }
    [[nodiscard]] bool iterative() const noexcept override { return true; }

private:
    ancf::EigenLu lu_;
};

TEST_CASE("path: without a count of pivots limit points are still found", "[path]") {
    Truss truss = make_truss(0.5);
    Blind solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    options.last_factor = 10.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.critical.size() == 2);
    CHECK(report.critical[0].factor == Approx(limit_load(0.5)).epsilon(1e-9));
    CHECK_FALSE(report.bifurcations_sought);
}

TEST_CASE("path: a column of two welded halves bifurcates where one of a piece does", "[path]") {
    using Beam = ancf::CrossSectionBeam<2>;
    const auto critical = [](bool welded, ancf::LinearSolver& solver) {
        INFO(solver.name() << (welded ? ", welded" : ""));
        ancf::PlanarModel column;
        const auto steel = ancf::Material::isotropic(2.1e11, 0.3, 7800.0);
        const auto section = ancf::rectangle(0.01, 0.01);
        const auto foot = ancf::straight_beam<Beam>(column, steel, section, {0, 0}, {0.5, 0}, 2);
        column.clamp(foot.first());
        const auto head = ancf::straight_beam<Beam>(column, steel, section, {0.5, 0}, {1, 0}, 2);
        if (welded)
            column.add(ancf::PlanarWeld(column, foot.last(), head.first()));
        else
            column.attach(head.first(), foot.last());
        column.add(ancf::Force<2>(head.last(), {-1.0, 0.0}));
        ancf::PathOptions options;
        options.first_step = 100.0;
        options.last_factor = 600.0;
        const auto report = ancf::follow_path(column, solver, options);
        REQUIRE(report.status == Status::converged);
        CHECK(report.bifurcations_sought);
        CHECK(report.points.front().negative_pivots == 0);
        CHECK(report.points.back().negative_pivots == 1);
        REQUIRE(report.critical.size() == 1);
        CHECK(report.critical[0].kind == CriticalKind::bifurcation);
        CHECK(report.critical[0].half_width <= 1e-9);
        return report.critical[0].factor;
    };
    ancf::EigenLdlt counts;
    ancf::EigenLu counts_none;
    const double expected = critical(false, counts);
    const double euler = ancf::pi * ancf::pi / 4.0 * 2.1e11 * 1e-8 / 12.0;
    CHECK(expected == Approx(euler).epsilon(5e-3));
    CHECK(critical(false, counts_none) == Approx(expected).epsilon(1e-9));
    CHECK(critical(true, counts_none) == Approx(expected).epsilon(1e-9));
}

TEST_CASE("path: a load that moves nothing is called that", "[path][bad-input]") {
    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        model, ancf::Material::isotropic(2e8, 0.3, 1000.0), ancf::circle(0.02), {0, 0, 0},
        {1, 0, 0}, 2);
    model.clamp(beam.first());
    model.add(ancf::Force<3>(beam.last(), {0.0, 1.0, 0.0}));
    ancf::EigenLu solver;
    ancf::PathOptions options;
    options.control = ancf::PathControl::displacement;
    options.at = {beam.last(), ancf::Field::r};
    options.component = 2;
    auto report = ancf::follow_path(model, solver, options);
    CHECK(report.status == Status::singular);
    CHECK_THAT(report.message,
               ContainsSubstring("the load does not move the coordinate that is controlled"));
    model.pin(beam.last());
    report = ancf::follow_path(model, solver);
    CHECK(report.status == Status::singular);
    CHECK_THAT(report.message, ContainsSubstring("the load moves nothing"));
    // nor where a joint carries it all, which leaves round-off
    for (const int elements : {1, 2, 3, 4}) {
        ancf::Model jointed;
        const auto bar = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
            jointed, ancf::Material::isotropic(2e11, 0.3, 1000.0), ancf::circle(0.02), {1, 2, 3},
            {1.3, 2.8, 3.4}, elements);
        jointed.clamp(bar.first());
        jointed.add(ancf::Revolute(jointed, bar.last(), {0.3, -0.2, 0.9}));
        jointed.add(ancf::Force<3>(bar.last(), {3, 5, 1}));
        ancf::EigenLu lu;
        report = ancf::follow_path(jointed, lu);
        CHECK(report.status == Status::singular);
        CHECK_THAT(report.message, ContainsSubstring("the load moves nothing"));
    }
    // nor does one that begins with the square of its factor, on a beam whose rest is round-off
    ancf::Model inclined;
    const auto across = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        inclined, ancf::Material::isotropic(2e11, 0.3, 1000.0), ancf::circle(0.02), {1, 2, 3},
        {1.3, 2.8, 3.4}, 6);
    inclined.clamp(across.first());
    inclined.add(ancf::Force<3>(across.last(), {0, 0, 1}), [](double f) { return f * f; });
    report = ancf::follow_path(inclined, solver);
    CHECK_THAT(report.message, ContainsSubstring("the load moves nothing"));
    CHECK_THAT(report.message, !ContainsSubstring("out of balance"));
    // four elements leave round-off in that coordinate, along which 23 limit points were found
    ancf::Model finer;
    const auto slender = ancf::straight_beam<
        ancf::CrossSectionBeam<3, ancf::Geodesic, ancf::LinearShear, ancf::EngineeringMeasure>>(
        finer, ancf::Material::isotropic(1e9, 0.3, 1000.0), ancf::rectangle(0.05, 0.05), {0, 0, 0},
        {1, 0, 0}, 4, ancf::CrossSectionOptions::best());
    finer.clamp(slender.first());
    finer.add(ancf::Force<3>(slender.last(), {0.0, 0.0, 100.0}));
    options.component = 1;
    options.at = {slender.last(), ancf::Field::r};
    report = ancf::follow_path(finer, solver, options);
    CHECK(report.status == Status::singular);
    CHECK(report.critical.empty());
}

TEST_CASE("path: calls that cannot be meant are refused", "[path][bad-input]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    const auto refused = [&](auto change) {
        ancf::PathOptions options;
        change(options);
        CHECK_THROWS_AS(ancf::follow_path(truss, solver, options), ancf::InvalidArgument);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    refused([&](auto& o) { o.first_factor = nan; });
    refused([](auto& o) { o.first_step = 0.0; });
    refused([](auto& o) { o.largest_step = -1.0; });
    refused([](auto& o) { o.smallest_step = 0.0; });
    refused([](auto& o) { o.max_iterations = 2; });
    refused([](auto& o) { o.wanted_iterations = 0; });
    refused([](auto& o) { o.max_points = 0; });
    refused([](auto& o) { o.residual_tolerance = -1.0; });
    refused([&](auto& o) { o.correction_tolerance = nan; });
    refused([](auto& o) { o.branch_step = 0.0; });
    refused([&](auto& o) { o.last_factor = nan; });
    refused([](auto& o) { o.direction = ancf::VectorX::Ones(2); });
    ancf::PathOptions nowhere;
    nowhere.control = ancf::PathControl::displacement;
    CHECK_THROWS_WITH(ancf::follow_path(truss, solver, nowhere),
                      Catch::Contains("displacement control needs `at`"));
    refused([](auto& o) {
        o.control = ancf::PathControl::displacement;
        o.at = {{0}, Field::r};  // held
    });
    refused([](auto& o) {
        o.control = ancf::PathControl::displacement;
        o.at = {apex, Field::r};
        o.component = 3;
    });
    truss.prescribe(apex, Field::r, 0, [](double factor) { return factor; });
    refused([](auto&) {});
}

}  // namespace path_test
