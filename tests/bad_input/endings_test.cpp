// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Every status but `converged` comes with a message.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <support/endings.hpp>

namespace endings_test {

using namespace ancf;
using namespace ancf::test;

const auto unchanged = [](PlanarModel&) {};
const auto loose = [](PlanarModel& model) {  // a beam that nothing holds
    PlanarModel free;
    const Scale s;
    straight_beam<CrossSectionBeam<2>>(free, s.material(2.07e11, 0.3, 7850.0),
                                       rectangle(0.01, 0.01), {0.0, 0.0}, {1.0, 0.0}, 4);
    free.add(Force<2>(NodeId{4}, {0.0, 1000.0}));
    model = free;
};
const auto far_turn = [](PlanarModel& model) {  // by more than a step may, wherever it is cut
    model.add(PlanarWeld(model, NodeId{4},
                         Motion{[](double t) { return t > 0.0 ? 2.0 : 0.0; },
                                [](double) { return 0.0; }, [](double) { return 0.0; }}));
};

/// Runs an analysis on each broken scene; `run` returns its report.
template <class Run>
void check_broken(const Run& run) {
    for (const Ending& ending : broken_scenes()) {
        PlanarModel model = cantilever(Scale{});
        ending.change(model);
        const auto report = run(model);
        check_ending(ending.name, report.status, report.message, ending.may, ending.says);
    }
}

/// Runs an analysis on one scene.
template <class Change, class Run>
void check_one(const char* name, const Change& change, Status expected, const Run& run) {
    PlanarModel model = cantilever(Scale{});
    change(model);
    const auto report = run(model);
    check_ending(name, report.status, report.message, {expected});
}

TEST_CASE("endings: statics say why they did not converge", "[statics][endings]") {
    const auto run = [](StaticsOptions options = {}) {
        return [=](PlanarModel& model) {
            EigenLu solver;
            return solve_statics(model, solver, options);
        };
    };
    check_broken(run());
    check_one("loose", loose, Status::singular, run());
    check_one("turn", far_turn, Status::diverged, run());
    StaticsOptions options;
    options.max_iterations = 1;
    check_one("iterations", unchanged, Status::max_iterations, run(options));
    options = {};
    options.progress = [](double, const State&) { return false; };
    check_one("progress", unchanged, Status::stopped, run(options));
    check_one("none", unchanged, Status::converged, run());
}

TEST_CASE("endings: paths say why they did not reach their end", "[path][endings]") {
    PathOptions usual;
    usual.last_factor = 1.0;
    const auto run = [](const PathOptions& options) {
        return [=](PlanarModel& model) {
            EigenLu solver;
            return follow_path(model, solver, options);
        };
    };
    check_broken(run(usual));
    check_one("loose", loose, Status::singular, run(usual));
    PathOptions options = usual;
    options.max_iterations = options.wanted_iterations = 1;
    check_one("smallest step", unchanged, Status::diverged, run(options));
    options = usual;
    options.max_points = 1;
    check_one("points", unchanged, Status::max_iterations, run(options));
    options = usual;
    options.progress = [](const PathPoint&, const State&) { return false; };
    check_one("progress", unchanged, Status::stopped, run(options));
    check_one("none", unchanged, Status::converged, run(usual));
}

TEST_CASE("endings: paths of coincident points in space say why they cannot start",
          "[path][endings]") {
    Model model = elbow(Scale{});
    model.add(Distance<3>(NodeId{model.nodes() - 1}, {1.0, 1.0, 0.0}, 0.1));
    EigenLu solver;
    const PathReport report = follow_path(model, solver);
    check_ending("coincident", report.status, report.message,
                 {Status::singular, Status::not_finite}, "constraint 2 (distance between node 5");
}

template <class Analysis>
void check_modes(const Analysis& analysis) {
    const auto run = [&](const ModalOptions& options) {
        return [=](PlanarModel& model) {
            EigenLdlt solver;
            return analysis(model, solver, options);
        };
    };
    check_broken([&](PlanarModel& model) {
        EigenLu solver;
        return analysis(model, solver, ModalOptions{});
    });
    check_one("loose", loose, Status::singular, run({}));
    ModalOptions options;
    options.max_iterations = 1;
    options.count = 3;
    check_one("iterations", unchanged, Status::max_iterations, run(options));
    check_one("none", unchanged, Status::converged, run({}));
}

TEST_CASE("endings: modes say why there are none", "[modal][endings]") {
    check_modes([](auto& model, auto& solver, ModalOptions options) {
        options.factor = 0.0;  // the scene rests
        return natural_modes(model, solver, options);
    });
    ModalOptions options;
    options.shift = 1e12;  // rad^2/s^2, above the lowest modes
    check_one("shift", unchanged, Status::singular, [&](PlanarModel& model) {
        EigenLdlt solver;
        return natural_modes(model, solver, options);
    });
}

TEST_CASE("endings: buckling loads say why there are none", "[modal][endings]") {
    check_modes([](auto& model, auto& solver, const ModalOptions& options) {
        return buckling_modes(model, solver, options);
    });
}

template <class Integrator>
void check_integrator(const Integrator& integrator) {
    const auto run = [&](PlanarModel& model, const Schedule& schedule) {
        DynamicProblem problem(model);
        EigenLu solver;
        return integrator.integrate(problem, solver, schedule);
    };
    check_motions(run);
    check_constrained_motions(run);
}

TEST_CASE("endings: integrators say why they stopped", "[dynamics][endings]") {
    GeneralizedAlphaOptions alpha;
    alpha.step = 1e-4;
    check_integrator(GeneralizedAlpha(alpha));
    alpha.tolerance = 1e-5;
    check_integrator(GeneralizedAlpha(alpha));
    RadauOptions radau;
    radau.step = 1e-4;
    check_integrator(RadauIIA(radau));
    radau.tolerance = 0.0;
    check_integrator(RadauIIA(radau));
    EnergyMomentumOptions middle;
    middle.step = 1e-4;
    check_integrator(EnergyMomentum(middle));
    const auto explicitly = [](PlanarModel& model, const Schedule& schedule) {
        DynamicProblem problem(model);
        return Leapfrog().integrate(problem, schedule);
    };
    check_motions(explicitly, false);
    check_constrained_motions(explicitly);
}

TEST_CASE("endings: multipliers that are not finite end a run", "[dynamics][endings]") {
    PlanarModel model = cantilever(Scale{});
    const auto zero = [](double) { return 0.0; };
    model.add(FixedCoordinate<2>(
        NodeId{4}, Field::r, 1,
        Motion{zero, zero, [](double t) { return t >= 1e-4 ? no_number : 0.0; }}));
    DynamicProblem problem(model);
    Schedule schedule;
    schedule.end = 2e-4;
    const auto report = Leapfrog().integrate(problem, schedule);
    check_ending("multipliers", report.status, report.message, {Status::not_finite},
                 "the multipliers at the end are not finite");
}

/// A motion that an integrator cannot finish.
template <class Integrator>
void check_failure(const char* name, const Integrator& integrator, const std::vector<Status>& may,
                   double end = 2e-4) {
    PlanarModel model = cantilever(Scale{});
    DynamicProblem problem(model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = end;
    const auto report = integrator.integrate(problem, solver, schedule);
    check_ending(name, report.status, report.message, may);
}

TEST_CASE("endings: integrators say which step failed", "[dynamics][endings]") {
    GeneralizedAlphaOptions alpha;
    alpha.step = 1e-4;
    alpha.max_iterations = 1;
    check_failure("iterations", GeneralizedAlpha(alpha), {Status::max_iterations});
    alpha = {};
    alpha.step = alpha.min_step = 1e-4;
    alpha.tolerance = 1e-13;
    check_failure("least step", GeneralizedAlpha(alpha), {Status::step_too_small});
    RadauOptions radau;
    radau.step = 10.0;
    radau.max_iterations = 2;
    radau.tolerance = 0.0;
    check_failure("iterations", RadauIIA(radau), {Status::max_iterations, Status::diverged}, 10.0);
    radau = {};
    radau.step = radau.min_step = 1e-4;
    radau.tolerance = 1e-13;
    check_failure("least step", RadauIIA(radau), {Status::step_too_small});
    EnergyMomentumOptions middle;
    middle.step = 1e-4;
    middle.max_iterations = 1;
    check_failure("iterations", EnergyMomentum(middle), {Status::max_iterations, Status::diverged});
}

}  // namespace endings_test
