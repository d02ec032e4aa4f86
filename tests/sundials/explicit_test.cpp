// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Explicit methods: order, accuracy, stability, and how a run starts, fails and ends.

#include <ancf/constants.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/model/model.hpp>
#include <ancf/sundials/arkode.hpp>
#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/ida.hpp>

#include <sundials/scenes.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace explicit_test {

using ancf::InvalidArgument;
using ancf::Status;
using ancf::VectorX;
using ancf::sundials::Explicit;
using ancf::sundials::ExplicitOptions;
using ancf::sundials::ExplicitReport;
using ancf::sundials::Table;
using namespace ancf_test;

constexpr Table all_tables[] = {Table::bogacki_shampine, Table::zonneveld,      Table::ark436,
                                Table::ark437,           Table::dormand_prince, Table::verner,
                                Table::fehlberg};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The paper's pendulum, its pin a support.
Hanging supported(int elements) {
    Hanging scene = soft_beam(elements);
    scene.model->pin(scene.beam.first());
    return scene;
}

/// A run by an explicit method with what was seen on the way.
struct Seen {
    ExplicitReport report;
    std::vector<Row> rows;
};

Seen move(Hanging& scene, ancf::Schedule schedule, const ExplicitOptions& options = {}) {
    ancf::DynamicProblem problem(*scene.model);
    Seen seen;
    schedule.observe = [&](const ancf::Snapshot& at) {
        seen.rows.push_back({at.state, at.energies, at.violation, at.violation_rate});
    };
    seen.report = Explicit(options).integrate(problem, schedule);
    return seen;
}

ExplicitOptions with_tolerance(double tolerance) {
    ExplicitOptions options;
    options.tolerance = tolerance;
    return options;
}

/// Forty milliseconds of a beam that stretches and bends smoothly: its lowest modes, set going.
VectorX end_of_smooth_motion(Table table, double step) {
    Hanging scene = supported(1);
    scene.model->set_gravity(Point::Zero());
    const ancf::NodeId tip = scene.beam.last();
    scene.model->set_rate(tip, ancf::Field::r, {0.3, 0.5, 0.0});
    ExplicitOptions options;
    options.table = table;
    options.step = step;
    const Seen seen = move(scene, until(0.04), options);
    REQUIRE(seen.report.status == Status::converged);
    return scene.model->state().q;
}

TEST_CASE("Explicit: fixed steps have the order of their table", "[explicit][order]") {
    struct Expected {
        Table table;
        double order, step, margin;
    };
    // steps far from round-off and from the stable step; order 6 has little room between them
    const auto [table, order, step, margin] = GENERATE(
        Expected{Table::ark436, 4.0, 8e-4, 0.1}, Expected{Table::zonneveld, 4.0, 4e-4, 0.1},
        Expected{Table::bogacki_shampine, 3.0, 2e-4, 0.1}, Expected{Table::verner, 6.0, 1e-3, 0.4});
    const VectorX exact = end_of_smooth_motion(Table::fehlberg, 5e-5);
    const double coarse = (end_of_smooth_motion(table, step) - exact).norm();
    const double fine = (end_of_smooth_motion(table, 0.5 * step) - exact).norm();
    const double measured = std::log2(coarse / fine);
    CAPTURE(order, measured, coarse, fine);
    CHECK(std::abs(measured - order) <= margin);
}

TEST_CASE("Explicit: tables are stable as far along the imaginary axis as stated",
          "[explicit][tables]") {
    for (const Table table : all_tables) {
        const auto& known = ancf::sundials::detail::erk_tables[static_cast<int>(table)];
        CAPTURE(static_cast<int>(table));
        const auto butcher = ARKodeButcherTable_LoadERK(known.id);
        REQUIRE(butcher != nullptr);
        const auto growth = [&](std::complex<double> z) {
            std::vector<std::complex<double>> slope;
            std::complex<double> end = 1.0;
            for (int i = 0; i < butcher->stages; ++i) {
                std::complex<double> stage = 1.0;
                for (int j = 0; j < i; ++j)
                    stage += z * butcher->A[i][j] * slope[static_cast<std::size_t>(j)];
                slope.push_back(stage);
                end += z * butcher->b[i] * stage;
            }
            return std::abs(end);
        };
        constexpr double slack = 1e-9;
        int checked = 0;
        for (int k = 1; k <= 1000; ++k, ++checked)
            CHECK(growth({0.0, 1e-3 * k * known.axis}) <= 1.0 + slack);
        CHECK(growth({0.0, known.axis + 5e-3}) > 1.0 + slack);
        for (int turn = 0; turn <= 90; ++turn)
            for (int k = 1; k <= 50; ++k, ++checked)
                CHECK(growth(std::polar(0.02 * k * known.disc, ancf::pi * (90 + turn) / 180)) <=
                      1.0 + slack);
        CHECK(checked == 1000 + 91 * 50);
        ARKodeButcherTable_Free(butcher);
    }
}

TEST_CASE("Explicit: the paper's pendulum passes the known heights", "[explicit][pendulum]") {
    Hanging scene = supported(4);
    const Seen seen = move(scene, until(1.2, {0.2, 0.5, 0.8, 1.2}), with_tolerance(1e-6));
    REQUIRE(seen.report.status == Status::converged);
    REQUIRE(seen.rows.size() == 4);
    const double heights[] = {-0.194023, -1.303027, -0.766241, 0.170784};  // exact in time, 1e-6
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(std::abs(seen.rows[k].state.q[scene.tip() + 1] - heights[k]) <= 2e-6);  // 4e-7
    CHECK(seen.report.energy_drift <= 1e-6 * seen.report.kinetic_largest);            // 8e-8
    CHECK(seen.report.steps <= 1500);                                                 // 852
    CHECK(seen.report.factorisations == 0);
    CHECK(seen.report.code == "ARK_TSTOP_RETURN");
}

TEST_CASE("Explicit: the error falls with the tolerance, and IDA agrees", "[explicit][pendulum]") {
    const auto tip_by = [](double tolerance) {
        Hanging scene = supported(4);
        const Seen seen = move(scene, until(0.6), with_tolerance(tolerance));
        REQUIRE(seen.report.status == Status::converged);
        return Point(scene.model->state().q.segment<3>(scene.tip()));
    };
    Hanging scene = supported(4);
    ancf::sundials::IdaOptions ida;
    ida.form = ancf::sundials::Form::gear_gupta_leimkuhler;
    ida.tolerance = 1e-10;
    REQUIRE(run(scene, until(0.6), ida).report.status == Status::converged);
    const Point exact = scene.model->state().q.segment<3>(scene.tip());
    double before = std::numeric_limits<double>::infinity();
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        const double error = (tip_by(tolerance) - exact).norm();
        CAPTURE(tolerance, error, before);
        CHECK(error <= 0.2 * before);
        before = error;
    }
    CHECK(before <= 1e-6);        // 2.4e-7 measured
    constexpr double size = 1.2;  // m
    before = std::numeric_limits<double>::infinity();
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        const double error = (tip_by(tolerance) - exact).norm() / size;
        CAPTURE(tolerance, error, before);
        CHECK(error / tolerance <= 3.0);
        CHECK(error < before);
        before = error;
    }
}

TEST_CASE("Explicit: what is seen between steps has the accuracy of the run",
          "[explicit][output]") {
    const Table table = GENERATE(Table::ark436, Table::verner);
    ExplicitOptions options = with_tolerance(1e-6);
    options.table = table;
    ExplicitOptions fine = with_tolerance(1e-11);
    fine.table = Table::fehlberg;
    const ancf::Schedule schedule = ancf::equal_intervals(0.0, 0.6, 0.0037);
    Hanging scene = supported(4), other = supported(4);
    const Seen seen = move(scene, schedule, options);
    const Seen exact = move(other, schedule, fine);
    REQUIRE(seen.report.status == Status::converged);
    REQUIRE(exact.report.status == Status::converged);
    REQUIRE(seen.rows.size() == schedule.times.size());
    double place = 0.0, rate = 0.0;
    for (std::size_t k = 0; k < seen.rows.size(); ++k) {
        CHECK(seen.rows[k].state.time == schedule.times[k]);
        const int tip = scene.tip();
        const auto& at = seen.rows[k].state;
        const auto& there = exact.rows[k].state;
        place = std::max(place, (at.q.segment<3>(tip) - there.q.segment<3>(tip)).norm());
        rate = std::max(rate, (at.v.segment<3>(tip) - there.v.segment<3>(tip)).norm());
    }
    CAPTURE(place, rate);
    CHECK(place <= 5e-6);  // m; 1.5e-6 measured
    CHECK(rate <= 2e-3);   // m/s; 7e-4: vibrations of 800 rad/s within the former
}

TEST_CASE("Explicit: steps stay below the stable one when the tolerance asks for nothing",
          "[explicit][stability]") {
    const Table table = GENERATE(from_range(std::begin(all_tables), std::end(all_tables)));
    CAPTURE(static_cast<int>(table));
    Hanging scene = supported(4);
    ExplicitOptions options = with_tolerance(0.5);
    options.table = table;
    const Seen seen = move(scene, until(0.6), options);
    REQUIRE(seen.report.status == Status::converged);
    CHECK(seen.report.limited > 10);
    CHECK(seen.report.largest_step <= 1.05 * seen.report.stable_step);  // of the last estimate
    CHECK(seen.report.highest_frequency > 100.0);
    CHECK(seen.report.energy_drift <= 0.1 * seen.report.kinetic_largest);
}

TEST_CASE("Explicit: a fixed step above the stable one ends as diverged and says both",
          "[explicit][stability]") {
    Hanging scene = supported(4);
    ExplicitOptions options;
    options.step = 0.02;
    const Seen seen = move(scene, until(1.2, {0.0, 0.6}), options);
    CHECK(seen.report.status == Status::diverged);
    CHECK(seen.report.steps == 0);
    CHECK(seen.rows.size() == 1);
    CHECK_THAT(seen.report.message, ContainsSubstring("0.02 s is above the stable one of"));
}

TEST_CASE("Explicit: a fixed step that a stiffer beam makes unstable ends as diverged",
          "[explicit][stability]") {
    Hanging scene = supported(4);
    ExplicitOptions options;
    options.step = 4e-3;  // s; 5.1e-3 are stable in space as well, and in the stiffer beam 3.6e-3
    ancf::Schedule schedule = until(40 * options.step);
    // less than the fifty steps between two estimates: it ended as converged after 3, with an error
    // in energy of 6 %, and after 10 with an element to blame
    const int later = GENERATE(1, 3, 10);
    CAPTURE(later);
    int steps = 0;
    schedule.progress = [&](double, double) {
        if (++steps == 40 - later)
            scene.model->prototype<Element>(scene.beam.prototypes[0]) =
                Element(ancf::Material::from_moduli(1.4e6, 5.3846e5, 5540.0),
                        ancf::rectangle(0.05, 0.05), 0.3);
        return true;
    };
    const Seen seen = move(scene, schedule, options);
    CHECK(seen.report.status == Status::diverged);
    CHECK(seen.report.steps == 40 - later);
    CHECK(seen.report.energy_drift <= 1e-4 * seen.report.kinetic_largest);
    CHECK_THAT(seen.report.message, ContainsSubstring("0.004 s is above the stable one of"));
}

TEST_CASE("Explicit: fixed steps that a rope pulled taut makes unstable are told of at the end",
          "[explicit][stability]") {
    // five steps ended as converged 0.1 m off, with an error in energy as large as the kinetic one;
    // eight end where an element fails
    const auto [steps, status] = GENERATE(table<int, Status>({{5, Status::diverged},  //
                                                              {8, Status::degenerate}}));
    CAPTURE(steps);
    const auto rubber = ancf::Material::isotropic(0.7e6, 0.3, 5540.0);
    ancf::PlanarModel model;
    const auto rope = ancf::straight_beam<ancf::Cable<2>>(
        model, rubber, ancf::rectangle(0.02, 0.02), {0.0, 0.0}, {1.0, 0.0}, 4,
        ancf::CableOptions{ancf::cable_rule(), 0.0});
    for (const ancf::NodeId node : rope.nodes) {  // loose by half a per cent between its ends
        model.set_value(node, ancf::Field::r, 0.995 * model.position(node));
        model.set_value(node, ancf::Field::r_x, {0.995, 0.0});
    }
    model.pin(rope.first());
    model.pin(rope.last());
    model.set_gravity({0.0, -9.81});
    ancf::DynamicProblem problem(model);
    ExplicitOptions options;
    options.step = 0.015;  // s; 0.076 are stable while the rope is loose
    const auto report = Explicit(options).integrate(problem, until(steps * options.step));
    CHECK(report.status == status);
    CHECK_THAT(report.message, ContainsSubstring("0.015 s is above the stable one of"));
}

TEST_CASE("Explicit: a stiff scene is refused before it would take for ever",
          "[explicit][stability]") {
    Hanging scene = steel_beam(4);
    scene.model->pin(scene.beam.first());
    ExplicitOptions options;
    options.max_steps = 1000;
    const Seen seen = move(scene, until(1.2), options);
    CHECK(seen.report.status == Status::max_iterations);
    CHECK(seen.report.steps == 0);
    CHECK_THAT(seen.report.message, ContainsSubstring("GeneralizedAlpha"));
}

TEST_CASE("Explicit: constraints are refused with what to take instead", "[explicit][input]") {
    Hanging scene = pendulum(2);
    ancf::DynamicProblem problem(*scene.model);
    CHECK_THROWS_AS(Explicit().integrate(problem, until(0.1)), InvalidArgument);
    for (const char* name : {"3 multipliers", "RadauIIA", "Ida", "attach"})
        CHECK_THROWS_WITH(Explicit().integrate(problem, until(0.1)), ContainsSubstring(name));
}

TEST_CASE("Explicit: options, schedules and scenes that cannot be meant are refused",
          "[explicit][input]") {
    const auto refused = [](auto change, const std::string& name) {
        ExplicitOptions options;
        change(options);
        CHECK_THROWS_WITH(Explicit(options), ContainsSubstring(name));
        CHECK_THROWS_AS(Explicit(options), InvalidArgument);
    };
    for (const double tolerance : {-1e-6, 0.0, 1.0, 1e-20, nan})
        refused([&](ExplicitOptions& o) { o.tolerance = tolerance; }, "tolerance");
    for (const double value : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
        refused([&](ExplicitOptions& o) { o.step = value; }, "step");
        refused([&](ExplicitOptions& o) { o.length_scale = value; }, "length_scale");
        refused([&](ExplicitOptions& o) { o.velocity_scale = value; }, "velocity_scale");
        refused([&](ExplicitOptions& o) { o.first_step = value; }, "first_step");
        refused([&](ExplicitOptions& o) { o.max_step = value; }, "max_step");
    }
    for (const double share : {0.0, 1.0, -0.5, nan})
        refused([&](ExplicitOptions& o) { o.stable_share = share; }, "stable_share");
    refused([](ExplicitOptions& o) { o.stable_interval = 0; }, "stable_interval");
    refused([](ExplicitOptions& o) { o.max_steps = -1; }, "max_steps");

    Hanging scene = supported(1);
    CHECK_THROWS_AS(move(scene, until(-1.0)), InvalidArgument);
    CHECK_THROWS_AS(move(scene, until(1.0, {0.5, 0.2})), InvalidArgument);
    ExplicitOptions tiny;
    tiny.step = 1e-18;
    CHECK_THROWS_WITH(move(scene, until(1.0), tiny), ContainsSubstring("resolution of time"));
    for (const ancf::NodeId node : scene.beam.nodes) scene.model->clamp(node);
    CHECK_THROWS_WITH(move(scene, until(1.0)), ContainsSubstring("no free coordinate"));
}

TEST_CASE("Explicit: a run of no length reports its start", "[explicit][start]") {
    const double step = GENERATE(0.0, 1e-3);
    Hanging scene = supported(2);
    ExplicitOptions options;
    options.step = step;
    const Seen seen = move(scene, until(0.0, {0.0}), options);
    CHECK(seen.report.status == Status::converged);
    CHECK(seen.report.steps == 0);
    CHECK(seen.report.smallest_step == 0.0);
    CHECK(seen.report.code.empty());
    REQUIRE(seen.rows.size() == 1);
    CHECK(seen.rows[0].state.time == 0.0);
}

TEST_CASE("Explicit: a huge step is cut to the run or to the stable step", "[explicit][start]") {
    Hanging scene = supported(2);
    ExplicitOptions options;
    options.step = 1e6;
    const Seen whole = move(scene, until(1e-3), options);
    CHECK(whole.report.status == Status::converged);
    CHECK(whole.report.steps == 1);
    CHECK(scene.model->state().time == Approx(1e-3).epsilon(1e-12));
    options.step = 0.0;
    options.first_step = options.max_step = 1e6;
    const Seen limited = move(scene, until(0.1), options);
    CHECK(limited.report.status == Status::converged);
    CHECK(limited.report.largest_step <= limited.report.stable_step);
}

/// A load that is no number when it is asked for the n-th time, or below a bound.
struct Lapse {
    ancf::NodeId node;
    int at;
    double bound;
    std::shared_ptr<int> calls = std::make_shared<int>(0);

    [[nodiscard]] ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
    void evaluate(const ancf::LoadState& state, ancf::LoadResult& out) const {
        if (++*calls == at || state.q[1] < bound) out.force[1] = nan;
    }
};

TEST_CASE("Explicit: a step into what cannot be evaluated is taken again, shorter",
          "[explicit][failure]") {
    Hanging scene = supported(2), same = supported(2);
    scene.model->add(Lapse{scene.beam.last(), 700, -10.0});
    const Seen once = move(scene, until(0.2));
    CHECK(once.report.status == Status::converged);
    CHECK(once.report.convergence_failures == 1);
    CHECK(!once.report.fault);
    REQUIRE(move(same, until(0.2)).report.status == Status::converged);
    CHECK((scene.model->state().q - same.model->state().q).norm() <= 1e-4);

    Hanging falling = soft_beam(1);
    falling.model->add(Lapse{falling.beam.last(), 0, -0.01});
    const Seen stopped = move(falling, until(0.1), with_tolerance(0.5));
    CHECK(stopped.report.status == Status::not_finite);
    CHECK(stopped.report.convergence_failures >= 12);
    CHECK(stopped.report.time == Approx(std::sqrt(2.0 * 0.01 / 9.81)).epsilon(1e-4));
}

TEST_CASE("Explicit: a force that is no number ends the run where it begins",
          "[explicit][failure]") {
    const double step = GENERATE(0.0, 1e-3);
    const double after = GENERATE(-1.0, 0.0205);
    CAPTURE(step, after);
    Hanging scene = supported(2);
    scene.model->add(Trouble{scene.beam.last(), after, nan, false});
    ExplicitOptions options;
    options.step = step;
    const Seen seen = move(scene, until(0.1, {0.0, 0.01, 0.05}), options);
    CHECK(seen.report.status == Status::not_finite);
    CHECK(!seen.report.message.empty());
    CHECK(seen.report.time <= 0.021);
    if (after > 0.0) {
        CHECK(seen.rows.size() == 2);
        CHECK(seen.report.time >= 0.015);
        CHECK(scene.model->state().time == seen.report.time);
        CHECK(scene.model->state().q.allFinite());
    }
}

TEST_CASE("Explicit: an enormous force ends the run with a reason", "[explicit][failure]") {
    const double step = GENERATE(0.0, 1e-3);
    CAPTURE(step);
    Hanging scene = supported(2);
    scene.model->add(Trouble{scene.beam.last(), 0.0205, 1e200, false});
    ExplicitOptions options;
    options.step = step;
    options.max_steps = 100000;
    const Seen seen = move(scene, until(0.1), options);
    CHECK(seen.report.status != Status::converged);
    CHECK(!seen.report.message.empty());
    CHECK(seen.report.time < 0.1);
}

TEST_CASE("Explicit: what a load throws comes out as it was thrown", "[explicit][failure]") {
    Hanging scene = supported(2);
    scene.model->add(Trouble{scene.beam.last(), 0.02, 0.0, true});
    int number = 0;
    try {
        (void)move(scene, until(0.1));
    } catch (const Trouble::Code& code) {
        number = code.number;
    }
    CHECK(number == 42);
}

TEST_CASE("Explicit: the limit of steps and a callback stop a run", "[explicit][failure]") {
    Hanging scene = supported(2);
    ExplicitOptions options = with_tolerance(1e-9);
    options.max_steps = 400;
    const Seen limited = move(scene, until(1.2), options);
    CHECK(limited.report.status == Status::max_iterations);
    CHECK(limited.report.steps == 400);
    CHECK_THAT(limited.report.message, ContainsSubstring("400 steps"));

    Hanging other = supported(2);
    ancf::Schedule schedule = until(1.2);
    schedule.progress = [](double time, double) { return time < 0.1; };
    const Seen stopped = move(other, schedule);
    CHECK(stopped.report.status == Status::stopped);
    CHECK(stopped.report.time >= 0.1);
    CHECK(other.model->state().time == stopped.report.time);
}

TEST_CASE("Explicit: a run goes on where another one ended", "[explicit][restart]") {
    Hanging whole = supported(4), parts = supported(4);
    ExplicitOptions fixed;
    fixed.step = 1e-3;
    REQUIRE(move(whole, until(0.5), fixed).report.status == Status::converged);
    REQUIRE(move(parts, until(0.25), fixed).report.status == Status::converged);
    REQUIRE(move(parts, until(0.5), fixed).report.status == Status::converged);
    CHECK((whole.model->state().q - parts.model->state().q).norm() <= 1e-11);
    CHECK((whole.model->state().v - parts.model->state().v).norm() <= 1e-9);
}

TEST_CASE("Explicit: a run that chooses its steps goes on within its tolerance",
          "[explicit][restart]") {
    Hanging exact = supported(4), whole = supported(4), parts = supported(4);
    ExplicitOptions options;
    options.tolerance = 1e-10;
    REQUIRE(move(exact, until(0.5), options).report.status == Status::converged);
    options.tolerance = 1e-6;
    REQUIRE(move(whole, until(0.5), options).report.status == Status::converged);
    REQUIRE(move(parts, until(0.2), options).report.status == Status::converged);
    REQUIRE(move(parts, until(0.5), options).report.status == Status::converged);
    const auto error = [&](const Hanging& scene) {
        return (scene.model->state().q - exact.model->state().q).cwiseAbs().maxCoeff();
    };
    CAPTURE(error(whole), error(parts));
    CHECK(error(whole) > 1e-7);  // 3.0e-5 measured, slopes among the coordinates
    CHECK(error(whole) <= 1e-4);
    CHECK(error(parts) <= 2.0 * error(whole));  // 2.7e-5
}

TEST_CASE("Explicit: what an observer changes holds from the next step on", "[explicit][restart]") {
    const auto change = [](Hanging& scene) { scene.model->set_gravity({0.0, 30.0, -20.0}); };
    ExplicitOptions options;
    options.step = 1e-4;
    Hanging whole = supported(2), parts = supported(2);
    ancf::Schedule schedule;
    schedule.end = 0.05;
    schedule.times = {0.025};
    schedule.observe = [&](const ancf::Snapshot&) { change(whole); };
    ancf::DynamicProblem one(*whole.model), two(*parts.model);
    REQUIRE(Explicit(options).integrate(one, schedule).status == Status::converged);
    schedule = {};
    schedule.end = 0.025;
    REQUIRE(Explicit(options).integrate(two, schedule).status == Status::converged);
    change(parts);
    schedule.end = 0.05;
    REQUIRE(Explicit(options).integrate(two, schedule).status == Status::converged);
    const double off = (whole.model->state().q - parts.model->state().q).cwiseAbs().maxCoeff();
    CHECK(off < 1e-10);
}

TEST_CASE("Explicit: fixed steps stay on their grid late in time", "[explicit][start]") {
    constexpr double step = 1e-4, late = 1e7;
    const auto tip = [&](double start) {
        Hanging scene = supported(2);
        scene.model->state().time = start;
        ExplicitOptions options;
        options.step = step;
        ancf::Schedule schedule;
        schedule.end = start + 0.0625;
        ancf::DynamicProblem problem(*scene.model);
        const ExplicitReport report = Explicit(options).integrate(problem, schedule);
        REQUIRE(report.status == Status::converged);
        CHECK(report.steps == 625);
        return scene.model->position(scene.beam.last());
    };
    CHECK((tip(late) - tip(0.0)).norm() < 1e-9);
}

TEST_CASE("Explicit: a driven support moves the beam as it moves under IDA",
          "[explicit][support]") {
    const auto driven = [] {
        Hanging scene = soft_beam(2);
        scene.model->prescribe(
            scene.beam.first(), ancf::Field::r, 1,
            [](double t) { return 0.05 * std::sin(8.0 * t); },
            [](double t) { return 0.4 * std::cos(8.0 * t); },
            [](double t) { return -3.2 * std::sin(8.0 * t); });
        scene.model->fix(scene.beam.first(), ancf::Field::r, 0);
        scene.model->fix(scene.beam.first(), ancf::Field::r, 2);
        scene.model->set_rate(scene.beam.first(), ancf::Field::r, {0.0, 0.4, 0.0});
        return scene;
    };
    Hanging scene = driven(), other = driven();
    const Seen seen = move(scene, until(0.5, {0.25, 0.5}), with_tolerance(1e-8));
    REQUIRE(seen.report.status == Status::converged);
    ancf::sundials::IdaOptions ida;
    ida.form = ancf::sundials::Form::gear_gupta_leimkuhler;
    ida.tolerance = 1e-10;
    REQUIRE(run(other, until(0.5), ida).report.status == Status::converged);
    const int foot = scene.model->coordinate(scene.beam.first(), ancf::Field::r);
    CHECK(seen.rows[0].state.q[foot + 1] == Approx(0.05 * std::sin(2.0)).epsilon(1e-12));
    CHECK((scene.model->state().q - other.model->state().q).norm() <= 1e-6);
    CHECK(other.model->state().q[foot + 4] != 0.0);
}

TEST_CASE("Explicit: damping shortens the stable step, and IDA agrees with the motion",
          "[explicit][damping]") {
    const auto damped = [] {
        Hanging scene = supported(2);
        ancf::add_kelvin_voigt(*scene.model, scene.beam, 0.01);
        return scene;
    };
    Hanging free = supported(2);
    const Seen undamped = move(free, until(0.01));
    Hanging scene = damped(), other = damped();
    const Seen seen = move(scene, until(0.3), with_tolerance(1e-3));
    REQUIRE(seen.report.status == Status::converged);
    CHECK(seen.report.stable_step < 0.3 * undamped.report.stable_step);
    CHECK(seen.report.rejected <= seen.report.steps / 10);
    ancf::sundials::IdaOptions ida;
    ida.tolerance = 1e-9;
    REQUIRE(run(other, until(0.3), ida).report.status == Status::converged);
    CHECK((scene.model->state().q - other.model->state().q).norm() <= 1e-3);
}

TEST_CASE("Explicit: a free beam falls with g", "[explicit][free]") {
    Hanging scene = soft_beam(4, Point(1.0, 2.0, -2.0));
    const Seen seen = move(scene, ancf::equal_intervals(0.0, 0.5, 0.1));
    REQUIRE(seen.report.status == Status::converged);
    int checked = 0;
    for (const Row& row : seen.rows)
        for (const ancf::NodeId node : scene.beam.nodes) {
            const int at = scene.model->coordinate(node, ancf::Field::r);
            const Point fall(0.0, -9.81 * row.state.time, 0.0);
            CHECK((row.state.v.segment<3>(at) - fall).norm() <= 1e-9);
            ++checked;
        }
    CHECK(checked == 6 * 5);
}

}  // namespace explicit_test
