// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <support/scales.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace solver_scales_test {

using namespace ancf::test;
using ancf::Status;

/// What an analysis did, and what it found in the scene's own units.
struct Outcome {
    std::vector<long> counts;
    std::vector<double> values;
};

/// Checks that an analysis takes as many iterations and finds the same in any units.
/// @param apart  by how much each count may differ
template <class Analysis>
void check_scales(const Analysis& analysis, double base, long apart) {
    const Outcome one = analysis(Scale{});
    REQUIRE(!one.counts.empty());
    int checked = 0;
    for (const Scale& scale : powers_of(base)) {
        INFO(scale);
        const Outcome other = analysis(scale);
        REQUIRE(other.counts.size() == one.counts.size());
        for (std::size_t k = 0; k < one.counts.size(); ++k)
            CHECK(std::abs(other.counts[k] - one.counts[k]) <= apart);
        REQUIRE(other.values.size() == one.values.size());
        // tolerances of 1e-9 and of 1e-6 that are met with some digits to spare
        for (std::size_t k = 0; k < one.values.size(); ++k)
            CHECK(other.values[k] == Approx(one.values[k]).epsilon(1e-7).margin(1e-9));
        ++checked;
    }
    CHECK(checked == 11);
}

void add_tip(const ancf::Scene& model, const Scale& scale, Outcome& outcome) {
    const int tip = model.coordinate({model.nodes() - 1}, ancf::Field::r);
    for (int k = 0; k < model.dimension(); ++k)
        outcome.values.push_back(model.state().q[tip + k] / scale.length);
}

Outcome statics(ancf::Scene&& model, ancf::LinearSolver&& solver, const Scale& scale) {
    const auto report = ancf::solve_statics(model, solver);
    CAPTURE(report.message);
    CHECK(report.status == Status::converged);
    Outcome outcome{{report.iterations(), static_cast<long>(report.stability)}, {}};
    add_tip(model, scale, outcome);
    return outcome;
}

Outcome path(ancf::Scene&& model, ancf::LinearSolver&& solver, const Scale& scale,
             ancf::PathControl control) {
    ancf::PathOptions options;
    options.control = control;
    options.at = {{model.nodes() - 1}, ancf::Field::r};
    options.component = 1;
    options.last_factor = 1.0;
    const auto report = ancf::follow_path(model, solver, options);
    CHECK(report.status == Status::converged);
    Outcome outcome;
    for (const ancf::PathPoint& point : report.points) {
        outcome.counts.push_back(point.iterations);
        outcome.values.push_back(point.factor);
    }
    add_tip(model, scale, outcome);
    return outcome;
}

Outcome modes(ancf::Scene&& model, ancf::LinearSolver&& solver, const Scale& scale) {
    const auto natural = ancf::natural_modes(model, solver);
    CHECK(natural.status == Status::converged);
    Outcome outcome{{natural.iterations}, {}};
    for (const ancf::Mode& mode : natural.modes)
        outcome.values.push_back(mode.value * scale.time * scale.time);
    const auto buckling = ancf::buckling_modes(model, solver);
    CHECK(buckling.status == Status::converged);
    outcome.counts.push_back(buckling.iterations);
    // of pairs of either sign either comes first
    for (const ancf::Mode& mode : buckling.modes) outcome.values.push_back(std::abs(mode.value));
    return outcome;
}

using Ldlt = ancf::EigenLdlt;
using Lu = ancf::EigenLu;

TEST_CASE("scales: statics take the same iterations in any units", "[statics][scales]") {
    const auto check = [](double base, long apart) {
        check_scales([](const Scale& s) { return statics(cantilever(s), Ldlt(), s); }, base, apart);
        check_scales([](const Scale& s) { return statics(linkage(s), Lu(), s); }, base, apart);
        check_scales([](const Scale& s) { return statics(elbow(s), Lu(), s); }, base, apart);
    };
    check(2.0, 0);
    check(1e3, 1);
    check(1e9, 1);
}

TEST_CASE("scales: paths take the same steps and iterations in any units", "[path][scales]") {
    const auto check = [](double base, long apart) {
        using Control = ancf::PathControl;
        for (const Control control :
             {Control::cylindrical, Control::spherical, Control::displacement})
            check_scales([&](const Scale& s) { return path(cantilever(s), Ldlt(), s, control); },
                         base, apart);
        const auto along = Control::cylindrical;
        check_scales([&](const Scale& s) { return path(linkage(s), Lu(), s, along); }, base, apart);
        check_scales([&](const Scale& s) { return path(elbow(s), Lu(), s, along); }, base, apart);
    };
    check(2.0, 0);
    check(1e3, 1);
    check(1e9, 1);
}

TEST_CASE("scales: modes and buckling loads take the same iterations in any units",
          "[modal][scales]") {
    const auto check = [](double base, long apart) {
        check_scales([](const Scale& s) { return modes(cantilever(s), Ldlt(), s); }, base, apart);
        check_scales([](const Scale& s) { return modes(linkage(s), Lu(), s); }, base, apart);
        check_scales([](const Scale& s) { return modes(elbow(s), Lu(), s); }, base, apart);
    };
    check(2.0, 0);
    check(1e3, 1);
    check(1e9, 1);
}

}  // namespace solver_scales_test
