// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/petsc/distributed_scene.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <petsc/scenes.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace motion_test {

using namespace ancf;
using namespace petsc_test;

double largest(const VectorX& v) { return v.size() == 0 ? 0.0 : v.cwiseAbs().maxCoeff(); }

GeneralizedAlphaOptions of_step(double step) {
    GeneralizedAlphaOptions options;
    options.step = step;
    return options;
}

/// Integrates in one process, by L D L^T where the loads allow.
DynamicsReport in_series(Model& model, const Schedule& schedule,
                         const GeneralizedAlphaOptions& options) {
    const auto& loads = model.loads();
    const bool symmetric = std::all_of(
        loads.begin(), loads.end(), [](const ScaledLoad& load) { return load.load.symmetric(); });
    EigenLu lu;
    EigenLdlt ldlt;
    LinearSolver& solver = symmetric ? static_cast<LinearSolver&>(ldlt) : lu;
    ProblemOptions how;
    how.storage = solver.storage();
    DynamicProblem problem(model, how);
    return GeneralizedAlpha(options).integrate(problem, solver, schedule);
}

/// A net that hangs between its masts when it is hit.
Model hit_net() {
    Model model = net();
    EigenLdlt ldlt;
    REQUIRE(solve_statics(model, ldlt).status == Status::converged);
    model.state().time = 0.0;
    model.add(
        Force<3>(NodeId{model.loads().front().load.coupling().front().node}, Point(1, 2, -20)));
    return model;
}

struct Observed {
    std::vector<double> kinetic, potential, power;
    std::vector<VectorX> q;
};

/// Compares the motion by all processes with that by one; sizes are about one metre.
void same_as_in_series(const std::function<Model()>& make, const petsc::SolverOptions& solver,
                       double tolerance, const GeneralizedAlphaOptions& options, double duration) {
    Model serial = make(), model = make();
    Observed expected, found;
    Schedule schedule = equal_intervals(0.0, duration, duration / 3.5);
    const auto observe = [](Observed& into, VectorX q, const Snapshot& seen) {
        into.kinetic.push_back(seen.energies.kinetic);
        into.potential.push_back(seen.energies.strain + seen.energies.potential);
        into.power.push_back(seen.energies.load_power + seen.energies.constraint_power);
        into.q.push_back(std::move(q));
    };
    schedule.observe = [&](const Snapshot& seen) { observe(expected, seen.state.q, seen); };
    const DynamicsReport alone = in_series(serial, schedule, options);
    INFO(alone.message);
    REQUIRE(alone.status == Status::converged);

    petsc::DistributedScene motion(model, PETSC_COMM_WORLD, solver);
    schedule.observe = [&](const Snapshot& seen) {
        observe(found, motion.gathered(seen.state.q), seen);
    };
    const DynamicsReport report = motion.integrate(schedule, options);
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
    motion.gather();
    CHECK(report.time == alone.time);
    CHECK(report.steps == alone.steps);
    CHECK(report.rejected == alone.rejected);
    const double moved = largest(serial.state().q - make().state().q);
    const double fastest = largest(serial.state().v);
    const double of_q = largest(model.state().q - serial.state().q);
    const double of_v = largest(model.state().v - serial.state().v) / fastest;
    INFO("positions " << of_q << ", rates " << of_v << ", moved " << moved << ", at " << fastest);
    CHECK(moved > 1e-4);
    CHECK(of_q < tolerance);
    CHECK(of_v < 1e3 * tolerance);  // of rates that change within a step
    REQUIRE(found.kinetic.size() == 5);
    REQUIRE(expected.kinetic.size() == 5);
    double most = 0.0, strongest = 0.0;
    for (std::size_t k = 0; k < 5; ++k) {
        most = std::max({most, expected.kinetic[k], std::abs(expected.potential[k])});
        strongest = std::max(strongest, std::abs(expected.power[k]));
    }
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(std::abs(found.kinetic[k] - expected.kinetic[k]) < 1e3 * tolerance * most);
        CHECK(std::abs(found.potential[k] - expected.potential[k]) < 1e3 * tolerance * most);
        CHECK(std::abs(found.power[k] - expected.power[k]) < 1e4 * tolerance * strongest);
        CHECK(largest(found.q[k] - expected.q[k]) < tolerance);
    }
    CHECK(report.energy_start == Approx(alone.energy_start).epsilon(1e-9).margin(1e-12 * most));
    CHECK(std::abs(report.energy_drift - alone.energy_drift) < 1e3 * tolerance * most);
}

TEST_CASE("DistributedScene::integrate: by MUMPS, any number of processes finds the serial motion",
          "[petsc]") {
    // 1e-10 of the scenes' size, one metre; measured: see docs/petsc.md
    const auto direct = petsc::SolverOptions::direct();
    SECTION("lattice") {
        same_as_in_series([] { return lattice(4); }, direct, 1e-10, of_step(5e-4), 0.01);
    }
    SECTION("chain, driven at its end") {
        same_as_in_series([] { return chain(); }, direct, 1e-10, of_step(1e-3), 0.02);
    }
    SECTION("arc on a mast") {
        same_as_in_series([] { return curved_beam(); }, direct, 1e-10, of_step(1e-3), 0.02);
    }
    SECTION("net between masts") { same_as_in_series(hit_net, direct, 1e-10, of_step(5e-4), 0.01); }
    SECTION("bar that spins, by a matrix that turns") {
        const auto bar = [] {
            Model model;
            straight_beam<CrossSectionBeam<3>>(model, Material::isotropic(2e11, 0.3, 7800.0),
                                               rectangle(0.05, 0.05), {0, 0, 0}, {1, 0, 0}, 8);
            model.set_rigid_rates({0, 0, 0}, {0, 0, 10});
            model.set_gravity({0, -9.81, 0});
            return model;
        };
        same_as_in_series(bar, direct, 1e-10, of_step(1e-3), 0.05);
    }
}

TEST_CASE("DistributedScene::integrate: it starts from the equilibrium that solve left",
          "[petsc]") {
    Model model = curved_beam();
    petsc::DistributedScene scene(model);
    StaticsOptions exact;
    exact.residual_tolerance = 1e-14;
    REQUIRE(scene.solve(exact).status == Status::converged);
    scene.part().state().time = 0.0;
    const VectorX before = scene.part().state().q;
    CHECK(largest(scene.gathered(before) - model.state().q) > 1e-3);
    Schedule schedule;
    schedule.end = 0.01;
    REQUIRE(scene.integrate(schedule, of_step(1e-3)).status == Status::converged);
    CHECK(scene.part().state().time == Approx(0.01));
    CHECK(largest(scene.part().state().q - before) < 1e-8);  // of a metre; measured below 1e-10
}

TEST_CASE("DistributedScene::integrate: by conjugate gradients it finds the serial motion to 1e-8",
          "[petsc]") {
    petsc::SolverOptions options = petsc::SolverOptions::iterative();
    options.options += " -ksp_rtol 1e-10 -pc_mg_cycle_type v";  // fewer messages
    SECTION("lattice") {
        same_as_in_series([] { return lattice(4); }, options, 1e-8, of_step(5e-4), 0.005);
    }
    SECTION("net between masts") {
        same_as_in_series(hit_net, options, 1e-8, of_step(5e-4), 0.005);
    }
}

TEST_CASE("DistributedScene::integrate: following and damping forces move it as in series",
          "[petsc]") {
    const auto followed = [] {
        Model model = lattice(3);
        model.add(FollowerForce(NodeId{26}, Point(0, 0, 300)));
        model.add(LinearDamping({{NodeId{18}, Field::r}, {NodeId{24}, Field::r}},
                                20.0 * MatrixX::Identity(6, 6)));
        return model;
    };
    same_as_in_series(followed, petsc::SolverOptions::direct(), 1e-10, of_step(5e-4), 0.01);
    Model model = followed();
    petsc::DistributedScene motion(model, PETSC_COMM_WORLD, petsc::SolverOptions::iterative());
    Schedule schedule;
    schedule.end = 0.01;
    const DynamicsReport report = motion.integrate(schedule);
    CHECK(report.status == Status::diverged);
    CHECK_THAT(report.message, ContainsSubstring("unsymmetric"));
    CHECK_THAT(report.message, ContainsSubstring("cg"));
}

TEST_CASE("DistributedScene::integrate: adaptive steps are those of the serial run", "[petsc]") {
    GeneralizedAlphaOptions options = of_step(1e-3);
    options.tolerance = 1e-4;
    same_as_in_series([] { return chain(4, 4); }, petsc::SolverOptions::direct(), 1e-10, options,
                      0.005);
}

TEST_CASE("DistributedScene::integrate: adaptive steps end where the load of one part jumps",
          "[petsc]") {
    GeneralizedAlphaOptions options = of_step(1e-3);
    options.tolerance = 1e-4;
    const auto make = [] {
        Model model = chain(4, 4);
        const NodeId hit = model.loads().front().load.coupling().front().node;
        model.add(Force<3>(hit, Point(1, 2, -20)),
                  [](double t) { return t > 0.0012 && t < 0.0031 ? 1.0 : 0.0; });
        return model;
    };
    same_as_in_series(make, petsc::SolverOptions::direct(), 1e-10, options, 0.005);
}

TEST_CASE("DistributedScene::integrate: adaptive steps see a pulse on one part after a rest",
          "[petsc]") {
    GeneralizedAlphaOptions options = of_step(1e-3);
    options.tolerance = 1e-4;
    const auto make = [] {
        Model model;
        const auto bars = frame<petsc_test::Beam>(
            model, {{steel, bar()}}, {Point(0, 0, 0), Point(0.25, 0, 0), Point(0.5, 0, 0)},
            {{0, 1, 0, 4}, {1, 2, 0, 4}});
        model.clamp(bars.joints.front());
        model.add(Force<3>(bars.joints.back(), Point(0, 2, 0)),  // within a step from 31 to 63 ms
                  [](double t) { return t > 0.035 && t < 0.045 ? 1.0 : 0.0; });
        return model;
    };
    same_as_in_series(make, petsc::SolverOptions::direct(), 1e-10, options, 0.07);
}

TEST_CASE("DistributedScene::integrate: a run goes on from its memory as if it had not stopped",
          "[petsc]") {
    const auto make = [] { return chain(4, 4); };
    Schedule half, whole;
    half.end = 0.005;
    whole.end = 0.01;
    Model straight = make(), first = make();
    petsc::DistributedScene all(straight);
    REQUIRE(all.integrate(whole, of_step(1e-3)).status == Status::converged);
    all.gather();
    petsc::DistributedScene begin(first);
    const DynamicsReport before = begin.integrate(half, of_step(1e-3));
    REQUIRE(before.status == Status::converged);
    begin.gather();
    CHECK(first.state().time == Approx(0.005));
    Model second = first;  // another scene in that state, divided in the same way
    petsc::DistributedScene end(second);
    const DynamicsReport after = end.integrate(whole, of_step(1e-3), before.memory);
    INFO(after.message);
    REQUIRE(after.status == Status::converged);
    CHECK(after.steps == 5);
    end.gather();
    CHECK(largest(second.state().q - straight.state().q) < 1e-14);
    CHECK(largest(second.state().v - straight.state().v) < 1e-11);

    // a memory that fits no longer, in one process alone
    Memory odd = before.memory;
    if (petsc::Session::rank() == petsc::Session::ranks() - 1) odd.values.clear();
    petsc::DistributedScene other(first);
    CHECK_THROWS_AS(other.integrate(whole, of_step(1e-3), odd), std::exception);
    Model heavier = first;
    heavier.add_mass(NodeId{4}, 1.0);
    petsc::DistributedScene changed(heavier);
    CHECK_THROWS_AS(changed.integrate(whole, of_step(1e-3), before.memory), InvalidArgument);
}

/// Takes the own slope r_x of the last member's end away, at a time.
Model breaking(double when) {
    Model model = chain(4, 2);
    const auto& group = model.group<petsc_test::Beam>();
    const NodeId end = group.connection(group.size() - 1).second;
    const int at = model.coordinate(end, Field::r_x);
    for (int k = 0; k < 3; ++k) {
        const double full = model.state().q[at + k];
        model.prescribe(
            end, Field::r_x, k, [=](double t) { return t < when ? full : 0.0; },
            [](double) { return 0.0; }, [](double) { return 0.0; });
    }
    return model;
}

/// Checks that every process has the same.
void same_everywhere(const petsc::DistributedScene& motion, double value) {
    CHECK(motion.partition().largest(value) == -motion.partition().largest(-value));
}

TEST_CASE(
    "DistributedScene::integrate: an element that fails in one process ends all in the same way",
    "[petsc]") {
    Model model = breaking(0.0021), serial = breaking(0.0021);
    const int last = model.group<petsc_test::Beam>().size() - 1;
    Schedule schedule;
    schedule.end = 0.01;
    const DynamicsReport alone = in_series(serial, schedule, of_step(5e-4));
    petsc::DistributedScene motion(model);
    const DynamicsReport report = motion.integrate(schedule, of_step(5e-4));
    INFO(report.message);
    CHECK(alone.status == Status::degenerate);
    CHECK(report.status == alone.status);
    CHECK(report.time == alone.time);
    CHECK(report.time == Approx(0.0021).margin(1e-6));
    CHECK_THAT(report.message, ContainsSubstring("element " + std::to_string(last) + " "));
    REQUIRE(report.fault);
    double knowing = report.fault->element == last ? 1.0 : 0.0;
    motion.partition().sum(&knowing, 1);
    CHECK(knowing == 1.0);
    same_everywhere(motion, static_cast<double>(report.message.size()));
    same_everywhere(motion, static_cast<double>(report.evaluations));
    motion.gather();
    CHECK(model.state().time == report.time);
}

/// Soft ropes in a row; the slope at the end of the last turns round within 2e-4 s, which folds it.
Model folding() {
    std::vector<Point> points = {Point::Zero()};
    std::vector<Member> members;
    for (int k = 0; k < 4; ++k) {
        points.emplace_back(k + 1.0, 0.0, 0.0);
        members.push_back({k, k + 1, 0, 2});
    }
    Model model;
    const auto row =
        net<Rope>(model, {{Material::isotropic(1.0, 0.3, 1000.0), bar()}}, points, members);
    model.set_rate(row.members.back().last(), Field::r_x, {-1e4, 1e3, 0.0});
    return model;
}

TEST_CASE(
    "DistributedScene::integrate: an element that one process sees fold ends all, or all tell",
    "[petsc]") {
    const bool pass = GENERATE(false, true);
    Model model = folding(), serial = folding();
    const int last = model.group<Rope>().size() - 1;
    Schedule schedule;
    schedule.end = 3e-4;
    schedule.pass_degenerate = pass;
    const DynamicsReport alone = in_series(serial, schedule, of_step(1e-5));
    petsc::DistributedScene motion(model);
    const DynamicsReport report = motion.integrate(schedule, of_step(1e-5));
    INFO(report.message);
    CHECK(report.status == (pass ? Status::converged : Status::degenerate));
    CHECK(report.status == alone.status);
    CHECK(report.time == alone.time);
    CHECK((report.time < 2.5e-4) == !pass);
    CHECK(report.fault.has_value() == !pass);
    CHECK(report.message == alone.message);
    CHECK(report.left_range == alone.left_range);
    CHECK_THAT(report.left_range, ContainsSubstring("element " + std::to_string(last) + " "));
    same_everywhere(motion, static_cast<double>(report.evaluations));
}

TEST_CASE("DistributedScene::integrate: a start that is refused in one process is refused in all",
          "[petsc]") {
    Schedule schedule;
    schedule.end = 0.01;
    SECTION("a support that its coordinate does not meet") {
        Model model = lattice(3);
        model.prescribe(
            NodeId{26}, Field::r, 2, [](double) { return 0.6; }, [](double) { return 0.0; },
            [](double) { return 0.0; });
        petsc::DistributedScene motion(model);
        const DynamicsReport report = motion.integrate(schedule);
        CHECK(report.status == Status::inconsistent);
        CHECK_THAT(report.message, ContainsSubstring("node 26"));
    }
    SECTION("an element") {
        Model model = breaking(0.0);
        const int last = model.group<petsc_test::Beam>().size() - 1;
        const NodeId end = model.group<petsc_test::Beam>().connection(last).second;
        for (int k = 0; k < 3; ++k) model.state().q[model.coordinate(end, Field::r_x) + k] = 0.0;
        petsc::DistributedScene motion(model);
        const DynamicsReport report = motion.integrate(schedule);
        CHECK(report.status == Status::degenerate);
        CHECK_THAT(report.message, ContainsSubstring("element " + std::to_string(last) + " "));
    }
    SECTION("a support without a rate") {
        Model model = lattice(3);
        model.prescribe(NodeId{26}, Field::r, 2, [](double) { return 0.5; });
        petsc::DistributedScene motion(model);
        CHECK_THROWS_AS(motion.integrate(schedule), std::exception);
    }
    SECTION("constraints") {
        Model model = lattice(3);
        model.add(Pin<3>(NodeId{26}, Point(0.5, 0.5, 0.5)));
        CHECK_THROWS_AS(petsc::DistributedScene(model).integrate(schedule), InvalidArgument);
    }
}

/// A load that throws from a time on.
struct LateThrower {
    NodeId node;
    static constexpr bool symmetric_stiffness = true;
    [[nodiscard]] Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const LoadState& state, LoadResult&) const {
        if (state.time > 0.002) throw std::domain_error("no such load");
    }
};

TEST_CASE(
    "DistributedScene::integrate: what a user's function throws or says in one process ends all",
    "[petsc]") {
    Schedule schedule = equal_intervals(0.0, 0.005, 0.001);
    const int rank = petsc::Session::rank();
    SECTION("a load") {
        Model model = lattice(3);
        model.add(LateThrower{NodeId{26}});
        petsc::DistributedScene motion(model);
        CHECK_THROWS_AS(motion.integrate(schedule), std::exception);
    }
    SECTION("a driven support") {
        Model model = lattice(3);
        model.prescribe(
            NodeId{26}, Field::r, 2,
            [](double t) { return t > 0.002 ? throw std::domain_error("too late") : 0.5; },
            [](double) { return 0.0; }, [](double) { return 0.0; });
        petsc::DistributedScene motion(model);
        CHECK_THROWS_AS(motion.integrate(schedule), std::exception);
    }
    SECTION("an observer") {
        Model model = lattice(3);
        petsc::DistributedScene motion(model);
        schedule.observe = [&](const Snapshot& seen) {
            if (rank == 0 && seen.state.time > 0.002) throw std::domain_error("seen enough");
        };
        CHECK_THROWS_AS(motion.integrate(schedule), std::exception);
    }
    SECTION("progress") {
        Model model = lattice(3);
        petsc::DistributedScene motion(model);
        schedule.progress = [&](double time, double) { return rank != 0 || time < 0.0025; };
        const DynamicsReport report = motion.integrate(schedule, of_step(2e-4));
        CHECK(report.status == Status::stopped);
        CHECK(report.time == Approx(0.0026));
    }
}

TEST_CASE("DistributedScene::integrate: a part is refused by integrators that would move it alone",
          "[petsc][refused]") {
    Model model = chain(4, 4);
    petsc::DistributedScene motion(model);
    petsc::Solver mass_solver(motion.part());
    ProblemOptions how;
    how.mass_solver = &mass_solver;
    DynamicProblem problem(motion.part(), how);
    Schedule schedule;
    schedule.end = 0.01;
    CHECK_THROWS_WITH(EnergyMomentum().integrate(problem, motion.solver(), schedule),
                      ContainsSubstring("GeneralizedAlpha alone"));
    CHECK_THROWS_WITH(RadauIIA().integrate(problem, motion.solver(), schedule),
                      ContainsSubstring("GeneralizedAlpha alone"));
}

TEST_CASE("DistributedScene::integrate: a KSP that diverges is a status with PETSc's reason",
          "[petsc]") {
    Model model = lattice(3);
    petsc::SolverOptions options = petsc::SolverOptions::iterative();
    options.options += " -ksp_max_it 2";
    petsc::DistributedScene motion(model, PETSC_COMM_WORLD, options);
    Schedule schedule;
    schedule.end = 0.01;
    const DynamicsReport report = motion.integrate(schedule);
    CHECK(report.status == Status::not_finite);
    CHECK_THAT(report.message, ContainsSubstring("DIVERGED_ITS"));
}

TEST_CASE("DistributedScene::integrate: processes without elements wait and learn the result",
          "[petsc]") {
    same_as_in_series(petsc_test::short_beam, petsc::SolverOptions::direct(), 1e-10, of_step(1e-3),
                      0.02);
}

}  // namespace motion_test
