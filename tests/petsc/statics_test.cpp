// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/petsc/distributed_scene.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <petsc/scenes.hpp>
#include <support/catch.hpp>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace statics_test {

using namespace ancf;
using namespace petsc_test;

double largest(const VectorX& v) { return v.size() == 0 ? 0.0 : v.cwiseAbs().maxCoeff(); }

/// Newton until the residual stops falling.
StaticsOptions exact() {
    StaticsOptions options;
    options.newton = NewtonKind::plain;  // what both of them can do
    options.steps = 2;
    options.residual_tolerance = 1e-15;
    options.correction_tolerance = 1e-9;
    return options;
}

/// Compares what all processes find together with what one finds alone.
void same_as_in_series(const std::function<Model()>& make, const petsc::SolverOptions& options,
                       double tolerance) {
    Model serial = make(), model = make();
    EigenLu lu;
    const StaticsReport expected = solve_statics(serial, lu, exact());
    CHECK(expected.message.empty());
    REQUIRE(expected.status == Status::converged);
    petsc::DistributedScene statics(model, PETSC_COMM_WORLD, options);
    const StaticsReport report = statics.solve(exact());
    INFO(report.message);
    INFO(expected.message);
    REQUIRE(report.status == Status::converged);
    CHECK(report.factor == 1.0);
    CHECK(report.steps.size() == expected.steps.size());
    statics.gather();
    const VectorX reactions = statics.gathered(report.reactions);
    const double error = largest(model.state().q - serial.state().q);  // scenes of one metre
    const double of_reactions =
        largest(reactions - expected.reactions) / largest(expected.reactions);
    const double of_energy = std::abs(report.strain_energy / expected.strain_energy - 1.0);
    if (petsc::Session::rank() == 0)
        UNSCOPED_INFO("rows " << statics.solver().rows() << ", block "
                              << statics.solver().block_size() << ", iterations "
                              << report.iterations() << " (" << expected.iterations() << "), KSP "
                              << statics.solver().most_iterations() << ", positions " << error
                              << ", reactions " << of_reactions << ", energy " << of_energy);
    CHECK(largest(serial.state().q) > 0.5);
    CHECK(error < tolerance);
    CHECK(of_reactions < tolerance);
    CHECK(of_energy < tolerance);
    CHECK(report.largest_turn == Approx(expected.largest_turn).epsilon(1e-8));
    // of forces of some hundred newton; measured up to 2e-8
    CHECK(report.imbalance.force.norm() < 1e-6);
    CHECK(report.imbalance.moment.norm() < 1e-6);
}

const std::vector<std::function<Model()>> scenes = {
    [] { return lattice(4); }, [] { return chain(); }, [] { return curved_beam(); },
    [] { return net(); }};

TEST_CASE("DistributedScene::solve: by MUMPS, any number of processes finds the serial solution",
          "[petsc]") {
    const std::size_t k = GENERATE(0U, 1U, 2U, 3U);
    // 1e-10 of the scenes' size, one metre; measured: see docs/petsc.md
    same_as_in_series(scenes[k], petsc::SolverOptions::direct(), 1e-10);
}

TEST_CASE("DistributedScene::solve: by conjugate gradients it finds the serial solution to 1e-8",
          "[petsc]") {
    const std::size_t k = GENERATE(0U, 1U, 2U, 3U);
    petsc::SolverOptions options = petsc::SolverOptions::iterative();
    options.options += " -ksp_rtol 1e-10 -pc_mg_cycle_type v";  // fewer messages
    same_as_in_series(scenes[k], options, 1e-8);
}

TEST_CASE("DistributedScene::solve: the iteration of mixed integration points is the serial one",
          "[petsc]") {
    Model serial = chain(), model = chain();
    EigenLu lu;
    StaticsOptions options;
    options.newton = NewtonKind::mixed;
    const StaticsReport expected = solve_statics(serial, lu, options);
    petsc::DistributedScene statics(model);
    const StaticsReport report = statics.solve(options);
    statics.gather();
    REQUIRE(report.status == Status::converged);
    CHECK(report.iterations() == expected.iterations());
    CHECK(report.steps.front().newton == NewtonKind::mixed);
    CHECK(largest(model.state().q - serial.state().q) < 1e-9);
}

TEST_CASE(
    "DistributedScene::solve: a scene with multipliers is solved by MUMPS and refused by others",
    "[petsc]") {
    const auto pinned = [] {
        Model model = lattice(3);
        const NodeId corner{26};
        model.add(Pin<3>(corner, Point(0.5, 0.5, 0.5)));
        return model;
    };
    same_as_in_series(pinned, petsc::SolverOptions::direct(), 1e-10);
    same_as_in_series(body_with_slider, petsc::SolverOptions::direct(), 1e-10);
    Model model = pinned();
    petsc::DistributedScene statics(model, PETSC_COMM_WORLD, petsc::SolverOptions::iterative());
    const StaticsReport report = statics.solve();
    CHECK(report.status == Status::diverged);
    CHECK_THAT(report.message, ContainsSubstring("multipliers"));
}

TEST_CASE("DistributedScene::solve: a load with an unsymmetric stiffness is refused by cg",
          "[petsc]") {
    const auto followed = [] {
        Model model = lattice(3);
        model.add(FollowerForce(NodeId{26}, Point(0, 0, 30)));
        return model;
    };
    same_as_in_series(followed, petsc::SolverOptions::direct(), 1e-10);
    Model model = followed();
    petsc::DistributedScene statics(model, PETSC_COMM_WORLD, petsc::SolverOptions::iterative());
    const StaticsReport report = statics.solve();
    CHECK(report.status == Status::diverged);
    CHECK_THAT(report.message, ContainsSubstring("unsymmetric"));
    CHECK_THAT(report.message, ContainsSubstring("cg"));
}

TEST_CASE("DistributedScene::solve: processes without elements wait and learn the result",
          "[petsc]") {
    same_as_in_series(petsc_test::short_beam, petsc::SolverOptions::direct(), 1e-10);
    const Model model = petsc_test::short_beam();
    const petsc::detail::Partition partition(model, PETSC_COMM_WORLD);
    double counts[2] = {static_cast<double>(partition.held().elements[0].size()),
                        partition.held().elements[0].empty() ? 1.0 : 0.0};
    partition.sum(counts, 2);
    CHECK(counts[0] == 1.0);
    CHECK(counts[1] == petsc::Session::ranks() - 1.0);
}

TEST_CASE(
    "DistributedScene::solve: a fault in one process ends all with its status and its element",
    "[petsc]") {
    Model model = lattice(4);
    const int last = model.group<petsc_test::Beam>().size() - 1;
    const NodeId end = model.group<petsc_test::Beam>().connection(last).second;
    // the own slope r_x of one member's end has no length: its element is degenerate
    const int at = model.coordinate(end, Field::r_x);
    for (int k = 0; k < 3; ++k) model.state().q[at + k] = 0.0;
    petsc::DistributedScene statics(model);
    const VectorX before = statics.part().state().q;
    const StaticsReport report = statics.solve();
    CHECK(report.status == Status::degenerate);
    CHECK(report.factor == 0.0);
    CHECK_THAT(report.message, ContainsSubstring("element " + std::to_string(last) + " "));
    REQUIRE(report.fault);
    CHECK((report.fault->element == last || report.fault->element == -1));
    double knowing = report.fault->element == last ? 1.0 : 0.0;
    statics.partition().sum(&knowing, 1);
    CHECK(knowing == 1.0);
    CHECK(statics.part().state().q == before);
}

/// A load that throws.
struct Thrower {
    NodeId node;
    static constexpr bool symmetric_stiffness = true;
    [[nodiscard]] Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const LoadState&, LoadResult&) const { throw std::domain_error("no such load"); }
};

TEST_CASE("DistributedScene::solve: what a user's function throws in one process ends all",
          "[petsc]") {
    Model model = lattice(4);
    model.add(Thrower{NodeId{63}});
    petsc::DistributedScene statics(model);
    CHECK_THROWS_AS(statics.solve(), std::exception);
    Model calm = lattice(4);
    petsc::DistributedScene other(calm);
    StaticsOptions options;
    options.steps = 3;
    const int rank = petsc::Session::rank();
    options.progress = [&](double factor, const State&) { return rank != 0 || factor < 0.5; };
    const StaticsReport report = other.solve(options);
    CHECK(report.status == Status::stopped);
    CHECK(report.factor == Approx(2.0 / 3.0));
}

TEST_CASE("DistributedScene::solve: a support whose function throws in one process ends all",
          "[petsc]") {
    Model model = lattice(4);
    model.prescribe(NodeId{63}, Field::r, 2, [](double t) {
        if (t > 0.5) throw std::domain_error("no such place");
        return 0.75 + 0.01 * t;
    });
    petsc::DistributedScene statics(model);
    StaticsOptions options;
    options.steps = 2;
    CHECK_THROWS_AS(statics.solve(options), std::exception);
    CHECK(statics.part().state().time == 0.5);  // of the step that converged
}

TEST_CASE("DistributedScene: every process refuses what is on a vector that no element has",
          "[petsc]") {
    const auto refuses = [](const std::function<void(Model&)>& change, const std::string& what) {
        Model model = lattice(4);
        change(model);
        CHECK_THROWS_WITH(petsc::DistributedScene(model), ContainsSubstring(what));
    };
    refuses(
        [](Model& model) {
            model.add(Force<3>(model.add_node({9, 0, 0}), Point(1, 0, 0)));
        },
        "load acts on r of node");
    refuses(
        [](Model& model) {
            model.add(GeneralisedForce({{NodeId{63}, Field::r_xx}}, VectorX::Ones(3)));
        },
        "load acts on r_xx of node 63");
    refuses(
        [](Model& model) {
            model.prescribe(model.add_node({9, 0, 0}), Field::r, 0, {});
        },
        "support acts on r of node");
    refuses(
        [](Model& model) {
            model.add(Pin<3>(NodeId{63}, model.add_node({0.75, 0.75, 0.75})));
        },
        "constraint acts on r of node");
}

/// A load that is not a number.
struct Nothing {
    NodeId node;
    static constexpr bool symmetric_stiffness = true;
    [[nodiscard]] Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const LoadState&, LoadResult& out) const { out.force[1] = std::nan(""); }
};

TEST_CASE("DistributedScene::solve: the message of every process names the load of the whole scene",
          "[petsc]") {
    const int node = GENERATE(20, 63);  // in other parts
    const auto make = [&] {
        Model model = lattice(4);
        model.add(Nothing{NodeId{node}});
        return model;
    };
    Model serial = make(), model = make();
    EigenLu lu;
    const StaticsReport expected = solve_statics(serial, lu);
    CHECK_THAT(expected.message,
               ContainsSubstring("load " + std::to_string(model.loads().size() - 1)));
    petsc::DistributedScene statics(model);
    const StaticsReport report = statics.solve();
    CHECK(report.status == Status::not_finite);
    CHECK(report.message == expected.message);
}

TEST_CASE("DistributedScene::solve: the message of every process names the constraint likewise",
          "[petsc]") {
    const auto make = [] {
        Model model = lattice(4);
        for (const int node : {20, 40, 60}) {
            const Point at = model.position(NodeId{node});
            model.add(Distance<3>(NodeId{node}, node == 60 ? at : Point(at + Point(0, 0, 1)), 1.0));
        }
        return model;
    };
    Model serial = make(), model = make();
    EigenLu lu;
    const StaticsReport expected = solve_statics(serial, lu);
    CHECK_THAT(expected.message, ContainsSubstring("constraint 2"));
    petsc::DistributedScene statics(model);
    CHECK(statics.solve().message == expected.message);
}

TEST_CASE("DistributedScene: an arm along a slope that nothing holds is refused in every process",
          "[petsc]") {
    Model model;
    const auto rope = straight_beam<Rope>(model, steel, bar(), Point(0, 0, 0), Point(1, 0, 0), 40);
    const NodeId beside = model.add_node({1.0, 0.1, 0.0});
    model.clamp(rope.first());
    model.add_mass(beside, 1.0);
    model.attach(beside, rope.last());
    petsc::DistributedScene scene(model);
    Schedule schedule;
    schedule.end = 0.01;
    CHECK_THROWS_AS(scene.solve(), std::exception);
    CHECK_THROWS_AS(scene.integrate(schedule), std::exception);
}

TEST_CASE("DistributedScene::solve: a KSP that diverges is a status with PETSc's reason",
          "[petsc]") {
    Model model = lattice(4);
    petsc::SolverOptions options = petsc::SolverOptions::iterative();
    options.options += " -ksp_max_it 2";
    petsc::DistributedScene statics(model, PETSC_COMM_WORLD, options);
    const StaticsReport report = statics.solve();
    CHECK(report.status == Status::diverged);
    CHECK_THAT(report.message, ContainsSubstring("DIVERGED_ITS"));
}

TEST_CASE("DistributedScene::solve: a tangent that is singular has that status everywhere",
          "[petsc]") {
    Model model;
    const auto frame = ancf::frame<petsc_test::Beam>(
        model, {{steel, bar()}}, {Point(0, 0, 0), Point(1, 0, 0)}, {{0, 1, 0, 40}});
    model.pin(frame.joints.front());  // it turns freely
    model.add(Force<3>(frame.joints.back(), Point(0, 0, -10)));
    petsc::DistributedScene statics(model);
    const StaticsReport report = statics.solve();
    CHECK(report.status != Status::converged);
    const double status = static_cast<double>(report.status);
    CHECK(statics.partition().largest(status) == -statics.partition().largest(-status));
}

TEST_CASE(
    "DistributedScene::solve: a link that a pin makes needless is no equilibrium in any process",
    "[petsc]") {
    Model model = lattice(3);
    const Point here = model.position(NodeId{26}), there(0.3, 0.77, 0.41);
    model.add(Pin<3>(NodeId{26}, here));
    model.add(Distance<3>(NodeId{26}, there, (there - here).norm()));  // MUMPS finds no zero pivot
    petsc::DistributedScene statics(model);
    CHECK(statics.solve().status == Status::singular);
}

TEST_CASE("DistributedScene::solve: a tangent that stays singular is so when it is tried again",
          "[petsc]") {
    Model model = lattice(3);
    model.add_mass(model.add_node({9, 0, 0}), 1.0);  // nothing holds it
    petsc::DistributedScene statics(model);
    const StaticsReport report = statics.solve();
    CHECK(report.steps.size() == 2);  // plainly too
    for (const LoadStep& step : report.steps) CHECK(step.status == Status::singular);
    CHECK(report.status == Status::singular);
    CHECK_THAT(report.message, ContainsSubstring("singular"));
}

}  // namespace statics_test
