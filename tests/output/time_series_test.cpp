// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Results over time: section forces and reactions of a cantilever are statics, the reactions of a
/// pendulum are what its momentum lacks.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/output/time_series.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace time_series_test {

using namespace ancf;
using Element = CrossSectionBeam<2>;
using Point = Vector<double, 2>;

constexpr double side = 0.1, pull = 800.0, lift = 30.0, length = 2.0;

/// A cantilever welded to space at its first node, under a force at its tip.
struct Cantilever {
    PlanarModel model;
    Beam<Element> beam;
    int weld = -1;  // place of the constraint

    Cantilever()
        : beam(straight_beam<Element>(model, Material::isotropic(2e9, 0.3, 7800.0),
                                      rectangle(side, side), Point(0, 0), Point(length, 0), 4)) {
        weld = model.add(PlanarWeld(model, beam.first()));
        model.add(Force<2>(beam.last(), Point(pull, lift)));
    }

    [[nodiscard]] bool settle() {
        EigenLu solver;
        return solve_statics(model, solver, {}).status == Status::converged;
    }
};

/// The rows of a series, by the names of their columns.
struct Table {
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;

    explicit Table(const std::string& text);

    [[nodiscard]] double value(std::size_t row, const std::string& name) const {
        for (std::size_t k = 0; k < names.size(); ++k)
            if (names[k] == name) return rows.at(row)[k];
        FAIL("no column " << name);
        return 0.0;
    }
};

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
    return result;
}

Table::Table(const std::string& text) {
    std::istringstream in(text);
    std::string line;
    std::getline(in, line);
    names = cells(line);
    while (std::getline(in, line)) {
        rows.emplace_back();
        for (const std::string& cell : cells(line)) rows.back().push_back(std::stod(cell));
        REQUIRE(rows.back().size() == names.size());
    }
}

TEST_CASE("TimeSeries: section forces, stress and reactions of a cantilever are those of statics",
          "[output][time-series]") {
    Cantilever scene;
    std::ostringstream out;
    TimeSeries series(out, scene.model);
    series.add_section_forces<Element>("tip", 3, 1.0);
    series.add_stress<Element>("axis", 0, 0.5);
    series.add_reaction("weld", scene.weld, scene.beam.first());
    REQUIRE(scene.settle());
    State state = scene.model.state();
    state.time = 0.25;
    Energies energies;
    energies.strain = 7.5;
    series.write({state, energies, 0.0, 0.0});
    series.write({state, energies, 0.0, 0.0});

    std::istringstream in(out.str());
    std::string header, first, second;
    std::getline(in, header);
    std::getline(in, first);
    std::getline(in, second);
    CHECK(header ==
          "t,kinetic,strain,potential,load_power,constraint_power,tip_N,tip_Q_y,tip_Q_z,tip_T,"
          "tip_M_y,tip_M_z,axis_S_xx,axis_S_yy,axis_S_xy,weld_F_x,weld_F_y,weld_F_z,weld_M_x,"
          "weld_M_y,weld_M_z");
    CHECK(first == second);
    const auto names = cells(header), values = cells(first);
    REQUIRE(values.size() == names.size());
    const auto value = [&](const std::string& name) {
        for (std::size_t k = 0; k < names.size(); ++k)
            if (names[k] == name) return std::stod(values[k]);
        FAIL("no column " << name);
        return 0.0;
    };
    CHECK(value("t") == 0.25);
    CHECK(value("strain") == 7.5);
    // the tip turns by lift L^2/(2 E I) = 4e-3: the axial force is the pull but for its square
    CHECK(value("tip_N") == Approx(pull).epsilon(2e-3));
    CHECK(value("axis_S_xx") == Approx(pull / (side * side)).epsilon(2e-2));
    const Point tip = scene.model.position(scene.beam.last());
    CHECK(value("weld_F_x") == Approx(-pull).epsilon(1e-9));
    CHECK(value("weld_F_y") == Approx(-lift).epsilon(1e-9));
    CHECK(value("weld_M_z") == Approx(-(tip[0] * lift - tip[1] * pull)).epsilon(1e-9));
    CHECK(value("weld_M_x") == 0.0);
}

/// The rubber beam of 1.2 m, hung from its first node by a support or by a joint.
struct Pendulum {
    static constexpr double mass = 5540.0 * 0.05 * 0.05 * 1.2, gravity = 9.81;
    PlanarModel model;
    Beam<Element> beam;

    explicit Pendulum(bool support, const Point& tip = Point(1.2, 0.0))
        : beam(straight_beam<Element>(model, Material::from_moduli(0.7e6, 2.6923e5, 5540.0),
                                      rectangle(0.05, 0.05), Point(0, 0), tip, 4)) {
        if (support)
            model.pin(beam.first());
        else
            model.add(Pin<2>(beam.first(), Point(0, 0)));
        model.set_gravity(Point(0.0, -gravity));
    }
};

constexpr double step = 5e-4;
constexpr int sampled = 20;  // steps between two looks at the reactions

/// Runs a pendulum with its reactions as they are written, and the momenta around each row.
template <class Integrator, class Options>
Table swing(Pendulum& scene, bool support, const Options& options, std::vector<Point>& rates) {
    DynamicProblem problem(scene.model);
    EigenLu solver;
    std::ostringstream out;
    TimeSeries series(out, scene.model);
    if (support)
        series.add_reaction("top", problem, scene.beam.first());
    else
        series.add_reaction("top", 0, scene.beam.first());
    Schedule schedule = equal_intervals(0.0, 0.1, step);
    std::vector<Point> momenta;
    schedule.observe = [&](const Snapshot& seen) {
        const Momentum now = momentum(problem, seen.state);
        momenta.emplace_back(now.linear.head<2>());
        if ((momenta.size() - 1) % sampled == sampled / 2) series.write(seen);
    };
    const DynamicsReport report = Integrator(options).integrate(problem, solver, schedule);
    REQUIRE(report.status == Status::converged);
    for (std::size_t k = sampled / 2; k + 1 < momenta.size(); k += sampled)
        rates.push_back((momenta[k + 1] - momenta[k - 1]) / (2.0 * step));
    return Table(out.str());
}

TEST_CASE("TimeSeries: a pinned pendulum's reaction is the rate of its momentum less its weight",
          "[output][time-series][dynamics]") {
    const bool conserving = GENERATE(false, true);
    const auto run = [&](Pendulum& scene, bool support, std::vector<Point>& rates) {
        if (conserving) {
            EnergyMomentumOptions options;
            options.step = step;
            return swing<EnergyMomentum>(scene, support, options, rates);
        }
        GeneralizedAlphaOptions options;
        options.step = step;
        return swing<GeneralizedAlpha>(scene, support, options, rates);
    };
    Pendulum pinned(true), joined(false);
    std::vector<Point> rates, others;
    const Table table = run(pinned, true, rates), joint = run(joined, false, others);
    REQUIRE(table.rows.size() == 10);
    REQUIRE(rates.size() == 10);
    REQUIRE(joint.rows.size() == 10);
    const double weight = Pendulum::mass * Pendulum::gravity;
    double largest = 0.0, of_momentum = 0.0, of_joint = 0.0;
    for (std::size_t k = 0; k < rates.size(); ++k) {
        const Point force(table.value(k, "top_F_x"), table.value(k, "top_F_y"));
        const Point multiplier(joint.value(k, "top_F_x"), joint.value(k, "top_F_y"));
        const Point expected = rates[k] + Point(0.0, weight);
        largest = std::max(largest, force.norm());
        of_momentum = std::max(of_momentum, (force - expected).norm());
        of_joint = std::max(of_joint, (force - multiplier).norm());
        CHECK(table.value(k, "top_F_z") == 0.0);
        CHECK(table.value(k, "top_M_z") == 0.0);  // a pin holds no slope
    }
    CAPTURE(largest, of_momentum, of_joint);
    CHECK(largest > 0.2 * weight);
    CHECK(of_momentum <= 3e-4 * weight);  // the differences' error; measured 1e-4
    // measured 1e-11 and, as the multipliers of this scheme belong to the middle of a step, 1.3e-3
    CHECK(of_joint <= (conserving ? 4e-3 : 1e-9) * weight);

    // who does not look has the same motion, bit for bit
    Pendulum unseen(true);
    DynamicProblem problem(unseen.model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = 0.1;
    if (conserving) {
        EnergyMomentumOptions options;
        options.step = step;
        REQUIRE(EnergyMomentum(options).integrate(problem, solver, schedule).status ==
                Status::converged);
    } else {
        GeneralizedAlphaOptions options;
        options.step = step;
        REQUIRE(GeneralizedAlpha(options).integrate(problem, solver, schedule).status ==
                Status::converged);
    }
    CHECK(unseen.model.state().q == pinned.model.state().q);
    CHECK(unseen.model.state().v == pinned.model.state().v);
}

TEST_CASE("TimeSeries: at rest a pin carries the weight, a clamp what a weld carries",
          "[output][time-series]") {
    std::ostringstream out;
    SECTION("a pin") {
        Pendulum scene(true, Point(0.0, -1.2));
        scene.model.fix(scene.beam.first(), Field::r_x, 0);  // or it turns freely
        EigenLu solver;
        REQUIRE(solve_statics(scene.model, solver).status == Status::converged);
        DynamicProblem problem(scene.model);
        TimeSeries series(out, scene.model);
        series.add_reaction("top", problem, scene.beam.first());
        const Start start = problem.start();
        REQUIRE(start.status == Status::converged);
        series.write({scene.model.state(), {}, 0.0, 0.0});
        const Table table(out.str());
        CHECK(table.value(0, "top_F_y") ==
              Approx(Pendulum::mass * Pendulum::gravity).epsilon(1e-8));
        CHECK(std::abs(table.value(0, "top_F_x")) <= 1e-8);
        CHECK(std::abs(table.value(0, "top_M_z")) <= 1e-8);
    }
    SECTION("a clamp") {
        Cantilever scene;
        PlanarModel clamped;
        const auto beam =
            straight_beam<Element>(clamped, Material::isotropic(2e9, 0.3, 7800.0),
                                   rectangle(side, side), Point(0, 0), Point(length, 0), 4);
        clamped.clamp(beam.first(), Clamp::free_slope);
        clamped.add(Force<2>(beam.last(), Point(pull, lift)));
        EigenLu solver;
        REQUIRE(solve_statics(clamped, solver).status == Status::converged);
        DynamicProblem problem(clamped);
        REQUIRE(problem.start().status == Status::converged);
        TimeSeries series(out, clamped);
        series.add_reaction("foot", problem, beam.first());
        series.write(clamped.state());
        const Table table(out.str());
        const Point tip = clamped.position(beam.last());
        CHECK(table.value(0, "foot_F_x") == Approx(-pull).epsilon(1e-8));
        CHECK(table.value(0, "foot_F_y") == Approx(-lift).epsilon(1e-8));
        CHECK(table.value(0, "foot_M_z") == Approx(-(tip[0] * lift - tip[1] * pull)).epsilon(1e-8));
    }
}

TEST_CASE("TimeSeries: supports carry the load of each load step", "[output][time-series]") {
    constexpr double push = 40.0, held = 15.0;
    PlanarModel model;
    const auto beam = straight_beam<Element>(model, Material::isotropic(2e9, 0.3, 7800.0),
                                             rectangle(0.02, 0.02), Point(0, 0), Point(1, 0), 4);
    model.clamp(beam.first(), Clamp::free_slope);
    model.add(Force<2>(beam.last(), Point(0, push)));
    double factor = 1.0;
    model.add(Force<2>(beam.last(), Point(held, 0)), [&factor](double) { return factor; });
    std::ostringstream out;
    TimeSeries series(out, model);
    series.add_reaction("foot", beam.first());
    StaticsOptions options;
    options.steps = 4;
    std::vector<double> arms;
    options.progress = [&](double, const State& state) {
        series.write(state);
        const Point tip = state.q.segment<2>(model.coordinate(beam.last(), Field::r));
        arms.push_back(tip[0] * state.time * push - tip[1] * held);
        return true;
    };
    EigenLu solver;
    const StaticsReport report = solve_statics(model, solver, options);
    REQUIRE(report.status == Status::converged);
    const Table table(out.str());
    REQUIRE(table.rows.size() >= 4);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double share = table.value(row, "t");
        CHECK(table.value(row, "foot_F_x") == Approx(-held).epsilon(1e-8));
        CHECK(table.value(row, "foot_F_y") == Approx(-share * push).epsilon(1e-8));
        CHECK(table.value(row, "foot_M_z") == Approx(-arms[row]).epsilon(1e-8));
    }
    CHECK_THROWS_WITH(TimeSeries(out, model).add_reaction("tip", beam.last()),
                      "TimeSeries: no support holds node 4: pin or fix it");
    DynamicProblem problem(model);
    TimeSeries other(out, model);
    other.add_reaction("foot", beam.first());
    CHECK_THROWS_AS(other.add_reaction("moving", problem, beam.first()), InvalidArgument);
    std::ostringstream row;
    TimeSeries failing(row, model);
    failing.add_reaction("foot", beam.first());
    model.add(Force<2>(beam.nodes[1], Point(0, push)));  // before the first row
    factor = std::numeric_limits<double>::quiet_NaN();
    failing.write(model.state());
    CHECK(std::isnan(Table(row.str()).value(0, "foot_F_y")));
}

TEST_CASE("TimeSeries: columns of one's own stand among the others", "[output][time-series]") {
    Cantilever scene;
    REQUIRE(scene.settle());
    std::ostringstream out;
    TimeSeries series(out, scene.model);
    series.add_section_forces<Element>("tip", 3, 1.0);
    series.add("end", {"x", "y"}, [&](const State& state, std::vector<double>& row) {
        const auto place = scene.model.value(scene.beam.last(), Field::r, state.q);
        row.insert(row.end(), {place[0], place[1]});
    });
    series.add_section_forces<Element>("root", 0, 0.0);
    series.write(scene.model.state());
    const Table table(out.str());
    const auto place = scene.model.position(scene.beam.last());
    CHECK(table.value(0, "end_x") == Approx(place[0]));
    CHECK(table.value(0, "end_y") == Approx(place[1]));
    CHECK(table.names.size() == 6 + 6 + 2 + 6);

    TimeSeries wrong(out, scene.model);
    wrong.add("none", {"x"}, [](const State&, std::vector<double>&) {});
    CHECK_THROWS_AS(wrong.write(scene.model.state()), InvalidArgument);
    CHECK_THROWS_AS(TimeSeries(out, scene.model).add("none", {"x"}, nullptr), InvalidArgument);
}

TEST_CASE("TimeSeries: a cable shows its axial force and stress", "[output][time-series]") {
    Model model;
    const auto cable = straight_beam<Cable<3>>(model, Material::isotropic(2e9, 0.3, 7800.0),
                                               circle(0.01), {0, 0, 0}, {1, 0, 0}, 1);
    std::ostringstream out;
    TimeSeries series(out, model);
    series.add_section_forces<Cable<3>>("middle", 0, 0.5);
    series.add_stress<Cable<3>>("middle", 0, 0.5);
    series.write(model.state());
    const std::string header = out.str().substr(0, out.str().find('\n'));
    CHECK(cells(header).back() == "middle_S_xx");
    CHECK(cells(header).size() == 6 + 6 + 1);
    CHECK(cable.elements.size() == 1);
}

TEST_CASE("TimeSeries: what does not exist is refused", "[output][time-series][bad-input]") {
    Cantilever scene;
    std::ostringstream out;
    TimeSeries series(out, scene.model);
    CHECK_THROWS_AS(series.add_section_forces<Element>("a", 4, 0.5), InvalidArgument);
    CHECK_THROWS_AS(series.add_stress<Element>("a", -1, 0.5), InvalidArgument);
    CHECK_THROWS_AS(series.add_stress<Element>("a", 0, 1.5), InvalidArgument);
    CHECK_THROWS_AS(series.add_reaction("a", 1, scene.beam.first()), InvalidArgument);
    CHECK_THROWS_AS(series.add_reaction("a", 0, scene.beam.last()), InvalidArgument);
    DynamicProblem problem(scene.model);
    CHECK_THROWS_WITH(series.add_reaction("a", problem, scene.beam.first()),
                      ContainsSubstring("no support holds node 0: pin or fix it"));
    Cantilever other;
    DynamicProblem another(other.model);
    CHECK_THROWS_WITH(series.add_reaction("a", another, scene.beam.first()),
                      ContainsSubstring("another model"));
    const State& state = scene.model.state();
    series.write({state, {}, 0.0, 0.0});
    CHECK_THROWS_AS(series.add_section_forces<Element>("late", 0, 0.5), InvalidArgument);
    TimeSeries reactions(out, scene.model);
    reactions.add_reaction("a", 0, scene.beam.first());
    State bare = state;
    bare.multipliers.resize(0);
    CHECK_THROWS_WITH(reactions.write({bare, {}, 0.0, 0.0}), ContainsSubstring("state has 0"));
}

}  // namespace time_series_test
