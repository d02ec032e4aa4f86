// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Scenes whose analyses cannot end well, for tests that every ending comes with its reason.

#pragma once

#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/error.hpp>

#include <support/scales.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace ancf::test {

/// A cantilever of which one thing is changed.
using Change = std::function<void(PlanarModel&)>;

/// A change, the statuses that may follow, and what the message says.
struct Ending {
    std::string name;
    Change change;
    std::vector<Status> may;
    std::string says = "";
};

/// Checks that an ending is one of those expected and says why.
inline void check_ending(const std::string& name, Status status, const std::string& message,
                         const std::vector<Status>& may, const std::string& says = "") {
    CAPTURE(name, to_string(status), message);
    bool expected = false;
    for (const Status one : may) expected = expected || one == status;
    CHECK(expected);
    CHECK(message.empty() == (status == Status::converged));
    CHECK_THAT(message, ContainsSubstring(says));
}

inline const double no_number = std::numeric_limits<double>::quiet_NaN();

/// States and loads that no analysis can take.
inline std::vector<Ending> broken_scenes() {
    const NodeId tip{4};
    const auto coincident = [=](PlanarModel& model) {
        model.add(Distance<2>(tip, {1.0, 0.0}, 0.1));
    };
    return {
        {"state", [](PlanarModel& model) { model.state().q[9] = no_number; }, {Status::not_finite}},
        {"slope",
         [](PlanarModel& model) {
             model.set_value({2}, Field::r_x, {0.0, 0.0});
         },
         {Status::degenerate}},
        {"coincident points",
         coincident,
         {Status::singular, Status::not_finite, Status::inconsistent},
         "constraint 0 (distance between node 4 and a point of space)"},
    };
}

/// Adds a soft cable that folds: the slope of its end turns round within 2e-4 s.
inline void add_folding(PlanarModel& model) {
    const auto cable = straight_beam<Cable<2>>(model, Material::isotropic(1.0, 0.3, 1000.0),
                                               rectangle(0.01, 0.01), {0.0, 1.0}, {1.0, 1.0}, 1);
    model.set_rate(cable.last(), Field::r_x, {-1e4, 1e3});
}

/// Checks that a motion ends where it folds an element, and not where it may pass.
template <class Run>
void check_folding(const Run& run) {
    for (const bool pass : {false, true}) {
        PlanarModel model = cantilever(Scale{});
        add_folding(model);
        Schedule schedule;
        schedule.end = 2e-4;
        schedule.pass_degenerate = pass;
        const auto report = run(model, schedule);
        INFO(to_string(report.status) << ": " << report.message);
        CHECK(report.status == (pass ? Status::converged : Status::degenerate));
        CHECK(report.message == report.left_range);
        CHECK_THAT(report.left_range,
                   ContainsSubstring("element 0 of the type Cable<2> is degenerate at "));
        CHECK(report.fault.has_value() == !pass);
        CHECK(model.state().time == report.time);
        CHECK(report.time > 1e-4);  // where the slope is zero
    }
}

/// Checks an integrator by a table of motions that cannot end well.
/// @param run         called as run(model, schedule)
/// @param constraints  whether it takes scenes with multipliers
template <class Run>
void check_motions(const Run& run, bool constraints = true) {
    const auto check = [&](const Ending& ending, const std::function<bool(double, double)>& go) {
        PlanarModel model = cantilever(Scale{});
        ending.change(model);
        if (!constraints && !model.constraints().empty()) return;
        Schedule schedule;
        schedule.end = 2e-4;
        schedule.progress = go;
        const auto report = run(model, schedule);
        check_ending(ending.name, report.status, report.message, ending.may, ending.says);
    };
    std::vector<Ending> table = broken_scenes();
    table.push_back({"rate of a support",
                     [](PlanarModel& model) {
                         model.set_rate({0}, Field::r, {0.0, 1.0});
                     },
                     {Status::inconsistent}});
    for (const double from : {0.0, 1e-4})
        table.push_back({"load",
                         [=](PlanarModel& model) {
                             model.add(Force<2>(NodeId{4}, {0.0, 1.0}),
                                       [=](double t) { return t >= from ? no_number : 1.0; });
                         },
                         {Status::not_finite, Status::diverged, Status::step_too_small}});
    const Amplitude zero = [](double) { return 0.0; };
    for (const double from : {0.0, 1e-4}) {
        const Amplitude broken = [=](double t) { return t >= from ? no_number : 0.0; };
        for (const auto& [name, rate, acceleration] :
             {std::tuple{"rate of a driven support", broken, zero},
              std::tuple{"acceleration of a driven support", zero, broken}})
            table.push_back({name,
                             [rate = rate, acceleration = acceleration, zero](PlanarModel& model) {
                                 model.prescribe({4}, Field::r, 1, zero, rate, acceleration);
                             },
                             {Status::not_finite, Status::diverged, Status::step_too_small},
                             from > 0.0 ? "the support of r, component 1, of node 4" : ""});
    }
    table.push_back({"value of a driven support",
                     [=](PlanarModel& model) {
                         model.prescribe(
                             {4}, Field::r, 1, [](double) { return no_number; }, zero, zero);
                     },
                     {Status::inconsistent},
                     "prescribes nan"});
    for (const Ending& ending : table) check(ending, nullptr);
    const auto unchanged = [](PlanarModel&) {};
    check({"progress", unchanged, {Status::stopped}}, [](double, double) { return false; });
    check({"none", unchanged, {Status::converged}}, nullptr);
    check_folding(run);
}

/// Likewise with constraints.
template <class Run>
void check_constrained_motions(const Run& run) {
    const auto twice = [](PlanarModel& model) {
        for (int k = 0; k < 2; ++k) model.add(Pin<2>(NodeId{4}, {1.0, 0.0}));
    };
    const auto apart = [](PlanarModel& model) { model.add(Pin<2>(NodeId{4}, {1.1, 0.0})); };
    const auto rate = [](PlanarModel& model) {
        const auto zero = [](double) { return 0.0; };
        model.add(FixedCoordinate<2>(
            NodeId{4}, Field::r, 1,
            Motion{zero, [](double t) { return t >= 1e-4 ? no_number : 0.0; }, zero}));
    };
    for (const Ending& ending :
         {Ending{"constraint twice", twice, {Status::redundant}},
          Ending{"constraint violated", apart, {Status::inconsistent}},
          Ending{"rate of a motion", rate, {Status::not_finite, Status::max_iterations}}}) {
        PlanarModel model = cantilever(Scale{});
        ending.change(model);
        Schedule schedule;
        schedule.end = 2e-4;
        const auto report = run(model, schedule);
        check_ending(ending.name, report.status, report.message, ending.may, ending.says);
    }
}

}  // namespace ancf::test
