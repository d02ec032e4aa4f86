// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/automatic.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <dynamics/radau_runs.hpp>
#include <dynamics/scenes.hpp>
#include <support/catch.hpp>
#include <support/driven_arm.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <vector>

namespace radau_test {

/// Checks that a scene ends where the Runge-Kutta method takes it.
/// @param steps   of the Runge-Kutta method
/// @param margin  largest difference of coordinates
template <class Make>
void check_end(const Make& make, double end, int steps, double step, double margin) {
    const State exact = exact_states(make, end, steps, 1).back();
    for (const int stages : {3, 5})
        for (const bool by_tolerance : {false, true}) {
            CAPTURE(stages, by_tolerance);
            auto scene = make();
            RadauOptions options = fixed(stages, step);
            if (by_tolerance) options.tolerance = 1e-8;
            const DynamicsReport report = run(scene.model, options, until(end));
            CAPTURE(report.message);
            REQUIRE(report.status == Status::converged);
            CHECK(distance(scene.model.state().q, exact.q) <= margin);
        }
}

TEST_CASE("Radau IIA: damped motions", "[dynamics][radau]") {
    const bool link = GENERATE(false, true);
    check_end(
        [=] {
            Chain scene = soft_swing(link);
            MatrixX damping = MatrixX::Zero(6, 6);
            damping.diagonal().setConstant(1.3);
            damping(0, 4) = 0.4;  // unsymmetric
            const Coupling ends = {{scene.nodes[1], Field::r}, {scene.nodes[2], Field::r}};
            scene.model.add(LinearDamping(ends, damping));
            return scene;
        },
        0.5, 1000, 0.01, 1e-8);
}

TEST_CASE("Radau IIA: driven supports", "[dynamics][radau]") {
    check_end(
        [] {
            Chain scene = chain(2, {0.0, -0.5, 0.0}, {1.2, -0.5, 0.0}, 20.0);
            const Motion path = sine(0.2, 7.0);
            for (const int k : {0, 2}) scene.model.fix(scene.first(), Field::r, k);
            scene.model.prescribe(
                scene.first(), Field::r, 1, [=](double t) { return path.value(t) - 0.5; },
                path.rate, path.acceleration);
            scene.model.state().v[1] = path.rate(0.0);
            return scene;
        },
        0.5, 1000, 0.01, 2e-8);
}

TEST_CASE("Radau IIA: lengths that are driven", "[dynamics][radau]") {
    check_end(
        [] {
            Chain scene = chain(2, {0.0, -0.5, 0.0}, {1.2, -0.5, 0.0}, 20.0);
            const Motion change = sine(0.1, 5.0);
            scene.model.add(Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0),
                                        Motion{[=](double t) { return 0.5 + change.value(t); },
                                               change.rate, change.acceleration}));
            for (const NodeId node : scene.nodes)
                scene.model.set_rate(node, Field::r, {0.0, -change.rate(0.0), 0.0});
            scene.model.set_gravity({0.0, -2.0, 0.0});
            return scene;
        },
        0.5, 1000, 0.01, 1e-8);
}

/// Two rubber elements in the plane, pinned, pushed by a force or moment that follows.
struct Pushed {
    PlanarModel model;
    NodeId last;
};

TEST_CASE("Radau IIA: loads that follow", "[dynamics][radau]") {
    check_end(
        [] {
            Pushed scene;
            const auto beam = straight_beam<CrossSectionBeam<2>>(
                scene.model, Material::isotropic(1e5, 0.3, 1000.0), rectangle(0.1, 0.1), {0.0, 0.0},
                {1.0, 0.0}, 2, CrossSectionOptions::best());
            scene.last = beam.last();
            scene.model.pin(beam.first());
            scene.model.add(PlanarSlopeMoment(beam.last(), Field::r_y, 0.3));
            return scene;
        },
        0.2, 2000, 1e-3, 1e-7);
}

TEMPLATE_TEST_CASE("Radau IIA: driven joints turn by the angle in steps of any length",
                   "[dynamics][radau]", DrivenArm, DrivenCrank) {
    int checked = 0;
    for (const double angle : {0.1, 1.7, pi, 10.0})
        for (const int steps : {1, 4, 16})
            for (const bool by_tolerance : {false, true}) {
                CAPTURE(angle, steps, by_tolerance);
                TestType arm(smooth_turn(angle));
                RadauOptions options = fixed(3, 1.0 / steps);
                if (by_tolerance) options.tolerance = 1e-4;
                const DynamicsReport report = run(arm.model, options, until(1.0));
                CAPTURE(report.message);
                if (by_tolerance || angle < 7.0 || steps == 16)
                    CHECK(report.status == Status::converged);
                if (report.status == Status::converged) {
                    CHECK(arm.off(angle) <= 1e-9);
                    CHECK(arm.wound() <= 0.5);
                } else {
                    CHECK_FALSE(report.message.empty());
                }
                ++checked;
            }
    CHECK(checked == 24);
}

TEST_CASE("Radau IIA: a driven angle that jumps ends the motion and names the joint",
          "[dynamics][radau]") {
    const Motion jump{[](double t) { return t > 0.5 ? 4.0 : 0.0; }, [](double) { return 0.0; },
                      [](double) { return 0.0; }};
    for (const bool by_tolerance : {false, true}) {
        DrivenArm arm(jump);
        RadauOptions options = fixed(3, 0.3);
        if (by_tolerance) options.tolerance = 1e-4;
        const DynamicsReport report = run(arm.model, options, until(1.0));
        CHECK(report.status != Status::converged);
        CHECK_THAT(report.message, ContainsSubstring("planar weld of node 0 and space"));
        CHECK_THAT(report.message, ContainsSubstring("driven by 4 rad"));
        CHECK(report.time <= 0.5);
    }
}

TEST_CASE("Radau IIA: redundant rows change no motion", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    VectorX ends[2], forces[2];
    for (const bool twice : {false, true}) {
        Chain scene = soft_swing(true);
        if (twice) scene.model.add(Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0), 0.5));
        ProblemOptions options;
        options.redundancy = Redundancy::minimum_norm;
        DynamicProblem problem(scene.model, options);
        EigenLu solver;
        RadauOptions fine = fixed(stages, 5e-3);
        fine.newton_tolerance = 1e-15;
        const DynamicsReport report = RadauIIA(fine).integrate(problem, solver, until(0.5));
        REQUIRE(report.status == Status::converged);
        ends[twice] = scene.model.state().q;
        forces[twice] = scene.model.state().multipliers;
    }
    CHECK(distance(ends[0], ends[1]) <= 1e-12);
    CHECK(forces[1][0] == Approx(0.5 * forces[0][0]).epsilon(1e-7));
    CHECK(forces[1][1] == Approx(0.5 * forces[0][0]).epsilon(1e-7));
}

TEST_CASE("Radau IIA: a restarted run continues bit for bit", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    const bool by_tolerance = GENERATE(false, true);
    CAPTURE(stages, by_tolerance);
    const RadauOptions options = by_tolerance ? adaptive(stages, 1e-6) : fixed(stages, 5e-3);
    // cut where it steps anyway
    double middle = 0.0;
    Chain probe = swing();
    Schedule schedule = until(0.5);
    schedule.progress = [&](double time, double) {
        middle = time;
        return time < 0.2;
    };
    REQUIRE(run(probe.model, options, schedule).status == Status::stopped);
    Chain parts = swing(), whole = swing(), resumed = swing();
    schedule.progress = [&](double time, double) { return time < middle; };
    const DynamicsReport first = run(parts.model, options, schedule);
    REQUIRE(first.status == Status::stopped);
    std::stringstream file;
    write_state(file, {parts.model.state(), first.memory});
    const SavedState saved = read_state(file);
    resumed.model.state() = saved.state;

    VectorX seen[2];
    int which = 0;
    Schedule rest = until(0.5);
    rest.times = {middle + 2e-3};
    rest.observe = [&](const Snapshot& at) { seen[which] = at.state.q; };
    const DynamicsReport second = run(resumed.model, options, rest, saved.memory);
    REQUIRE(second.status == Status::converged);
    which = 1;
    const DynamicsReport all = run(whole.model, options, rest);
    REQUIRE(all.status == Status::converged);
    CHECK(all.steps == first.steps + second.steps);
    CHECK(resumed.model.state().q == whole.model.state().q);
    CHECK(resumed.model.state().v == whole.model.state().v);
    CHECK(resumed.model.state().multipliers == whole.model.state().multipliers);
    CHECK(seen[0] == seen[1]);
}

TEST_CASE("Radau IIA: times of output change no bit of a motion", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    Chain plain = swing(), observed = swing();
    REQUIRE(run(plain.model, adaptive(stages, 1e-5), until(0.3)).status == Status::converged);
    Schedule schedule = equal_intervals(0.0, 0.3, 7.1e-4);
    std::size_t seen = 0;
    double largest = 0.0;
    schedule.observe = [&](const Snapshot& at) {
        CHECK(at.state.time == Approx(schedule.times[seen]).margin(1e-12));
        largest = std::max({largest, at.violation, at.violation_rate});
        ++seen;
    };
    REQUIRE(run(observed.model, adaptive(stages, 1e-5), schedule).status == Status::converged);
    CHECK(seen == schedule.times.size());
    CHECK(largest <= 1e-14);  // on the constraints at every time
    CHECK(observed.model.state().q == plain.model.state().q);
    CHECK(observed.model.state().v == plain.model.state().v);
}

TEST_CASE("Radau IIA: solvers of lower and full storage take the same steps", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    VectorX ends[2];
    for (const bool lower : {false, true}) {
        Chain scene = soft_swing(false);
        ProblemOptions storage;
        storage.storage = lower ? Storage::lower : Storage::full;
        DynamicProblem problem(scene.model, storage);
        EigenLu lu;
        Automatic automatic;
        const RadauIIA method(adaptive(stages, 1e-6));
        const DynamicsReport report = lower ? method.integrate(problem, automatic, until(0.3))
                                            : method.integrate(problem, lu, until(0.3));
        REQUIRE(report.status == Status::converged);
        ends[lower] = scene.model.state().q;
        if (lower) CHECK_THROWS_AS(method.integrate(problem, lu, until(0.4)), InvalidArgument);
    }
    CHECK(distance(ends[0], ends[1]) <= 1e-12);
}

TEST_CASE("Radau IIA: wrong calls are refused", "[dynamics][radau]") {
    const auto refused = [](auto change, const char* word) {
        RadauOptions options;
        change(options);
        CHECK_THROWS_WITH(RadauIIA(options), ContainsSubstring(word));
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    refused([](RadauOptions& o) { o.stages = 4; }, "stages");
    refused([](RadauOptions& o) { o.tolerance = -1.0; }, "tolerance");
    refused([=](RadauOptions& o) { o.tolerance = nan; }, "tolerance");
    refused([](RadauOptions& o) { o.step = 0.0; }, "step");
    refused([](RadauOptions& o) { o.min_step = 0.0; }, "min_step");
    refused([](RadauOptions& o) { o.max_step = 1e-13; }, "max_step");
    refused([](RadauOptions& o) { o.newton_tolerance = -1.0; }, "newton_tolerance");
    refused([](RadauOptions& o) { o.max_iterations = 1; }, "max_iterations");

    Chain scene = swing();
    const DynamicsReport report = run(scene.model, adaptive(3, 1e-5), until(0.01));
    REQUIRE(report.status == Status::converged);
    CHECK_THROWS_WITH(run(scene.model, adaptive(5, 1e-5), until(0.02), report.memory),
                      ContainsSubstring("stages"));
    Memory other = report.memory;
    other.integrator = "energy_momentum";
    CHECK_THROWS_WITH(run(scene.model, adaptive(3, 1e-5), until(0.02), other),
                      ContainsSubstring("that of energy_momentum"));
    other = report.memory;
    other.values.erase(other.values.begin());
    CHECK_THROWS_WITH(run(scene.model, adaptive(3, 1e-5), until(0.02), other),
                      ContainsSubstring("values of q"));
    CHECK_THROWS_AS(run(scene.model, adaptive(3, 1e-5), until(0.005)), InvalidArgument);
    scene.model.state().v.conservativeResize(2);
    CHECK_THROWS_WITH(run(scene.model, adaptive(3, 1e-5), until(0.02)),
                      ContainsSubstring("2 rates"));
    Chain still = chain(2, {0.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
    for (const NodeId node : still.nodes) still.model.pin(node);
    CHECK_THROWS_WITH(run(still.model, adaptive(3, 1e-5), until(0.1)),
                      ContainsSubstring("no free coordinate"));
}

TEST_CASE("Radau IIA: no step, a huge one, a load that is not finite", "[dynamics][radau]") {
    const bool by_tolerance = GENERATE(false, true);
    CAPTURE(by_tolerance);
    const RadauOptions options = by_tolerance ? adaptive(3, 1e-5) : fixed(3, 1e-3);
    Chain none = swing();
    const VectorX start = none.model.state().q;
    const DynamicsReport nothing = run(none.model, options, until(0.0));
    CHECK(nothing.status == Status::converged);
    CHECK(nothing.steps == 0);
    CHECK(none.model.state().q == start);

    Chain once = swing();
    RadauOptions huge = options;
    huge.step = 1e6;
    const DynamicsReport leap = run(once.model, huge, until(20.0));
    CHECK(once.model.state().q.allFinite());
    if (leap.status != Status::converged) CHECK_FALSE(leap.message.empty());

    for (const double from : {0.0, 0.05}) {
        CAPTURE(from);
        Chain broken = swing();
        broken.model.add(Force<3>(broken.last(), {1.0, 0.0, 0.0}), [=](double t) {
            return t >= from ? std::numeric_limits<double>::quiet_NaN() : 1.0;
        });
        const DynamicsReport report = run(broken.model, options, until(0.1));
        CHECK(report.status != Status::converged);
        CHECK_FALSE(report.message.empty());
        CHECK(report.time <= from);
        CHECK(broken.model.state().q.allFinite());
    }
}

TEST_CASE("RadauIIA: a scene whose load its constraints take whole stays at rest to the end",
          "[radau]") {
    // corrections are round-off of nothing, 1e-50, and do not shrink
    const int stages = GENERATE(3, 5);
    int checked = 0;
    for (double length = 0.5; length < 0.6; length += 0.001) {
        INFO("stages " << stages << ", length " << length);
        Model model;
        const auto cable =
            straight_beam<Cable<3>>(model, Material::isotropic(2e8, 0.3, 7850.0), circle(0.02),
                                    {0.0, 0.0, 0.0}, {0.0, 0.0, -length}, 1);
        model.add(Pin<3>(cable.first(), {0.0, 0.0, 0.0}));
        model.add(AlignedTangent(model, cable.first()));
        model.add(Force<3>(cable.first(), {0.0, 3.0, 0.0}));
        const VectorX before = model.state().q;
        DynamicProblem problem(model);
        EigenLu solver;
        Schedule schedule;
        schedule.end = 0.05;
        RadauOptions options;
        options.stages = stages;
        const auto report = RadauIIA(options).integrate(problem, solver, schedule);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.steps <= 1000);
        CHECK((model.state().q - before).norm() <= 1e-15);
        CHECK(model.state().multipliers[1] == Approx(3.0).epsilon(1e-12));
        ++checked;
    }
    CHECK(checked == 100);
}

}  // namespace radau_test
