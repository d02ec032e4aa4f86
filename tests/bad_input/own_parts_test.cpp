// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Parts of a user's own that break their contract while a run uses them.

#include <ancf/assembly/assembly.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/scaled.hpp>
#include <ancf/solver/statics.hpp>

#include <support/bar.hpp>
#include <support/catch.hpp>
#include <support/scales.hpp>

#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace own_parts_test {

using namespace ancf;
using namespace ancf::test;

/// Solves, and gives more or fewer entries than it should.
class Resizing final : public LinearSolver {
public:
    explicit Resizing(int change) : change_(change) {}
    [[nodiscard]] Storage storage() const noexcept override { return lu_.storage(); }
    void analyze(const SparseMatrix& matrix) override { lu_.analyze(matrix); }
    [[nodiscard]] FactorReport factorize(const SparseMatrix& matrix) override {
        return lu_.factorize(matrix);
    }
    void solve(const VectorX& b, VectorX& x) const override {
        lu_.solve(b, x);
        x = VectorX::Zero(x.size() + change_);
    }
    [[nodiscard]] std::string_view name() const noexcept override { return "resizing"; }

private:
    EigenLu lu_;
    int change_;
};

/// Keeps a node from moving along the beam, by as many equations as `count` says.
struct Counting {
    std::shared_ptr<int> count;

    [[nodiscard]] static Coupling coupling() { return {{NodeId{4}, Field::r}}; }
    [[nodiscard]] int equations() const { return *count; }
    [[nodiscard]] static std::string name() { return "counting"; }
    static void evaluate(const ConstraintState& at, ConstraintResult& out) {
        out.violation[0] = at.q[0] - 1.0;
        out.jacobian(0, 0) = 1.0;
    }
};

/// Pulls with a force of another size than asked for.
struct Shrinking {
    std::shared_ptr<int> size;

    [[nodiscard]] static Coupling coupling() { return {{NodeId{4}, Field::r}}; }
    void evaluate(const LoadState&, LoadResult& out) const { out.force.setZero(*size); }
};

/// What of a part is no number, or a mass that is wrong.
enum class Flaw { none, energy, force, tangent, value, direction, damping, skew, negative };

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A bar with a flaw.
struct FlawedBar : Bar<2> {
    Flaw flaw;
    FlawedBar(const Bar<2>& bar, Flaw flaw_) : Bar<2>(bar), flaw(flaw_) {}
    [[nodiscard]] Evaluation<double, 4> evaluate(const Coordinates& e) const {
        auto result = Bar<2>::evaluate(e);
        if (flaw == Flaw::energy) result.energy = no_number;
        if (flaw == Flaw::force) result.force[2] = no_number;
        if (flaw == Flaw::tangent) result.tangent(2, 2) = no_number;
        return result;
    }
    [[nodiscard]] Matrix<double, 4> mass() const {
        Matrix<double, 4> m = Bar<2>::mass();
        if (flaw == Flaw::skew) m(2, 3) += 1e-3;
        if (flaw == Flaw::negative) m *= -1.0;
        return m;
    }
};

/// A spring to the origin with a flaw.
struct FlawedSpring {
    NodeId node;
    Flaw flaw;
    [[nodiscard]] Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const LoadState& at, LoadResult& out) const {
        out.force = -at.q;
        out.stiffness = -Matrix<double, 2>::Identity();
        if (flaw == Flaw::tangent) out.stiffness(0, 0) = no_number;
        if (flaw == Flaw::damping) out.damping(0, 0) = no_number;
        if (flaw == Flaw::energy) out.potential = no_number;
        if (flaw == Flaw::skew) out.stiffness.setZero(1, 3);
    }
};

/// Holds a node on a line, with a flaw.
struct FlawedTrack {
    NodeId node;
    Flaw flaw;
    [[nodiscard]] Coupling coupling() const { return {{node, Field::r}}; }
    [[nodiscard]] static int equations() { return 1; }
    [[nodiscard]] static std::string name() { return "track"; }
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        out.violation[0] = flaw == Flaw::value ? no_number : at.q[1];
        out.jacobian(0, 1) = flaw == Flaw::direction ? no_number : 1.0;
        if (flaw == Flaw::tangent) out.stiffness(0, 0) = no_number;
        if (flaw == Flaw::skew) out.convection.setZero(4);
    }
};

/// A flawed bar from a pin to a node that is pulled.
PlanarModel flawed_pendulum(Flaw flaw) {
    PlanarModel model;
    const NodeId a = model.add_node({0.0, 0.0}), b = model.add_node({1.0, 0.0});
    model.connect<FlawedBar>(model.add_prototype(FlawedBar(Bar<2>(100.0, 1.0, 1.0), flaw)), a, b);
    model.pin(a);
    model.add(Force<2>(b, {1.0, 0.0}));
    return model;
}

/// Every analysis that takes a linear solver and has progress or an observer, which it calls.
struct Analysis {
    const char* name;
    std::function<void(PlanarModel&, LinearSolver&, const std::function<void()>&)> run;
};

template <class Integrator>
Analysis motion(const char* name, const Integrator& integrator) {
    return {name, [=](PlanarModel& model, LinearSolver& solver, const std::function<void()>& call) {
                DynamicProblem problem(model);
                Schedule schedule = equal_intervals(0.0, 4e-3, 1e-3);
                schedule.observe = [&](const Snapshot&) { call(); };
                static_cast<void>(integrator.integrate(problem, solver, schedule));
            }};
}

std::vector<Analysis> analyses() {
    return {{"statics",
             [](PlanarModel& model, LinearSolver& solver, const std::function<void()>& call) {
                 StaticsOptions options;
                 options.steps = 2;
                 options.progress = [&](double, const State&) {
                     call();
                     return true;
                 };
                 static_cast<void>(solve_statics(model, solver, options));
             }},
            {"path",
             [](PlanarModel& model, LinearSolver& solver, const std::function<void()>& call) {
                 PathOptions options;
                 options.max_points = 3;
                 options.progress = [&](const PathPoint&, const State&) {
                     call();
                     return true;
                 };
                 static_cast<void>(follow_path(model, solver, options));
             }},
            motion("generalized-alpha", GeneralizedAlpha()),
            motion("energy-momentum", EnergyMomentum()),
            motion("radau", RadauIIA())};
}

PlanarModel loaded_cantilever() {
    PlanarModel model = cantilever(Scale{}, 10.0);
    model.add(Force<2>(NodeId{4}, {0.0, -1.0}));
    return model;
}

TEST_CASE("own parts: a linear solver that gives another number of entries is refused",
          "[bad-input]") {
    const int change = GENERATE(-3, 400);
    Resizing solver(change);
    const auto says = ContainsSubstring("resizing: solve gave ");
    for (const Analysis& analysis : analyses()) {
        CAPTURE(change, analysis.name);
        PlanarModel model = loaded_cantilever();
        CHECK_THROWS_WITH(analysis.run(model, solver, [] {}), says);
    }
    const PlanarModel model = loaded_cantilever();
    CHECK_THROWS_WITH(natural_modes(model, solver), says);
    CHECK_THROWS_WITH(buckling_modes(model, solver), says);
    Scaled scaled(std::make_unique<Resizing>(change));
    CHECK_THROWS_WITH(natural_modes(model, scaled), says);
}

TEST_CASE("own parts: a constraint that changes its number of equations is refused",
          "[bad-input]") {
    const int other = GENERATE(0, 500);
    for (const Analysis& analysis : analyses()) {
        CAPTURE(other, analysis.name);
        PlanarModel model = loaded_cantilever();
        const auto count = std::make_shared<int>(1);
        model.add(Counting{count});
        EigenLu solver;
        CHECK_THROWS_WITH(analysis.run(model, solver, [&] { *count = other; }),
                          ContainsSubstring("constraint counting had 1 equations when it was added "
                                            "and " +
                                            std::to_string(other) + " now"));
    }
}

TEST_CASE("own parts: a load that changes the size of its force is refused", "[bad-input]") {
    const int other = GENERATE(0, 1, 500);
    for (const Analysis& analysis : analyses()) {
        CAPTURE(other, analysis.name);
        PlanarModel model = loaded_cantilever();
        const auto size = std::make_shared<int>(2);
        model.add(Shrinking{size});
        EigenLu solver;
        CHECK_THROWS_WITH(analysis.run(model, solver, [&] { *size = other; }),
                          ContainsSubstring("a load on 2 coordinates changed the size"));
    }
}

TEST_CASE("own parts: an element without a length is refused", "[bad-input]") {
    const double length = GENERATE(0.0, -1.0, std::numeric_limits<double>::quiet_NaN());
    PlanarModel model;
    CHECK_THROWS_WITH(model.add_prototype(test::Bar<2>(1.0, 1.0, length)),
                      ContainsSubstring("the length of an element must be positive and finite"));
}

TEST_CASE("own parts: an element whose values are no numbers is named", "[bad-input]") {
    const Flaw flaw = GENERATE(Flaw::energy, Flaw::force, Flaw::tangent);
    const auto says = ContainsSubstring("element 0 of the type own_parts_test::FlawedBar");
    const PlanarModel scene = flawed_pendulum(flaw);
    CAPTURE(static_cast<int>(flaw));
    EigenLu solver;
    PlanarModel model = scene;
    const StaticsReport statics = solve_statics(model, solver);
    CHECK(statics.status == Status::not_finite);
    CHECK_THAT(statics.message, says);
    PathOptions to_one;
    to_one.last_factor = 1.0;
    CHECK_THAT(follow_path(model, solver, to_one).message, says);
    const ModalReport modes = natural_modes(scene, solver);
    CHECK(modes.status == Status::not_finite);
    CHECK_THAT(modes.message, says);
    DynamicProblem problem(model);
    const Schedule schedule = equal_intervals(0.0, 1.0, 1.0);
    CHECK_THAT(GeneralizedAlpha().integrate(problem, solver, schedule).message, says);
    CHECK_THAT(RadauIIA().integrate(problem, solver, schedule).message, says);
    if (flaw == Flaw::tangent) return;  // which the leapfrog does not take
    // the force alone is finite where a bar's energy is not: there the frequency is not known
    CHECK(Leapfrog().integrate(problem, schedule).status == Status::not_finite);
}

TEST_CASE("own parts: a load that is no number is named, and what of it", "[bad-input]") {
    const auto [flaw, what] =
        GENERATE(table<Flaw, std::string>({{Flaw::tangent, "a derivative of the force"},
                                           {Flaw::damping, "a derivative of the force"},
                                           {Flaw::energy, "the potential"}}));
    const auto says = ContainsSubstring(what + " of load 1 is not finite");
    PlanarModel model = flawed_pendulum(Flaw::none);
    model.add(FlawedSpring{{1}, flaw});
    DynamicProblem problem(model);
    EigenLu solver;
    const Schedule schedule = equal_intervals(0.0, 1.0, 1.0);
    CHECK_THAT(GeneralizedAlpha().integrate(problem, solver, schedule).message, says);
    CHECK_THAT(RadauIIA().integrate(problem, solver, schedule).message, says);
    CHECK_THAT(solve_statics(model, solver).message, says);
}

TEST_CASE("own parts: a constraint that is no number is named, and what of it", "[bad-input]") {
    const auto [flaw, what] =
        GENERATE(table<Flaw, std::string>({{Flaw::value, "the value"},
                                           {Flaw::direction, "the direction"},
                                           {Flaw::tangent, "the stiffness"}}));
    PlanarModel model = flawed_pendulum(Flaw::none);
    model.add(FlawedTrack{{1}, flaw});
    EigenLu solver;
    const StaticsReport report = solve_statics(model, solver);
    CHECK(report.status == Status::not_finite);
    CHECK_THAT(report.message, ContainsSubstring(what + " of constraint 0 (track) is not finite"));
}

TEST_CASE("own parts: a result of the wrong size is refused by its size", "[bad-input]") {
    EigenLu solver;
    PlanarModel model = flawed_pendulum(Flaw::none), other = model;
    model.add(FlawedSpring{{1}, Flaw::skew});
    CHECK_THROWS_WITH(solve_statics(model, solver), ContainsSubstring("its stiffness is 1 x 3"));
    other.add(FlawedTrack{{1}, Flaw::skew});
    CHECK_THROWS_WITH(solve_statics(other, solver), ContainsSubstring("its convection 4"));
}

TEST_CASE("own parts: a mass that is not symmetric, or negative, is refused", "[bad-input]") {
    PlanarModel model = flawed_pendulum(GENERATE(Flaw::skew, Flaw::negative));
    EigenLu solver;
    const auto says = ContainsSubstring("FlawedBar is not symmetric or not positive definite");
    CHECK_THROWS_WITH(natural_modes(model, solver), says);
    CHECK_THROWS_WITH(DynamicProblem(model), says);
}

TEST_CASE("own parts: a scene that changes in a call of its run is refused", "[bad-input]") {
    const auto zero = [](double) { return 0.0; };
    const std::vector<std::function<void(PlanarModel&)>> changes = {
        [](PlanarModel& model) {
            static_cast<void>(model.add_node({2.0, 0.0}));
        },
        [&](PlanarModel& model) {  // of a vector that no node has
            for (int k = 0; k < 2; ++k) model.prescribe({4}, Field::r_xx, k, zero, zero, zero);
        },
        [](PlanarModel& model) {
            model.add(Force<2>(NodeId{4}, {1.0, 0.0}));
        },
        [](PlanarModel& model) { model.add(Counting{std::make_shared<int>(1)}); }};
    for (const Analysis& analysis : analyses())
        for (const auto& change : changes) {
            CAPTURE(analysis.name, &change - changes.data());
            PlanarModel model = loaded_cantilever();
            EigenLu solver;
            CHECK_THROWS_WITH(analysis.run(model, solver, [&] { change(model); }),
                              ContainsSubstring("of the model have changed"));
        }
}

TEST_CASE("own parts: an assembly refuses a scene that has changed", "[bad-input]") {
    PlanarModel model = loaded_cantilever();
    const Assembly assembly(model, Storage::lower);
    VectorX q = model.state().q;
    const auto end = model.add_node({2.0, 0.0});
    static_cast<void>(model.connect<CrossSectionBeam<2>>(0, {4}, end));
    const auto says = ContainsSubstring("of the model have changed");
    CHECK_THROWS_WITH(assembly.mass(), says);
    CHECK_THROWS_WITH(assembly.mass_product(q), says);
    CHECK_THROWS_WITH(assembly.inspect(q), says);
    CHECK_THROWS_WITH(assembly.softened(q), says);
    CHECK_THROWS_WITH(assembly.largest_turn(q), says);
    CHECK_THROWS_WITH(assembly.load_rate(q, 0.0), says);
    CHECK_THROWS_WITH(assembly.damping_load(q, q, q, 0.0), says);
    CHECK_THROWS_WITH(assembly.apply_supports({}, q), says);
}

TEST_CASE("own parts: what a call throws reaches the caller, and the model can be used again",
          "[bad-input]") {
    struct Thrown : std::runtime_error {
        using std::runtime_error::runtime_error;
        int code = 7;
    };
    for (const Analysis& analysis : analyses()) {
        CAPTURE(analysis.name);
        PlanarModel model = loaded_cantilever(), other = model;
        const State before = model.state();
        EigenLu solver;
        int code = 0;
        try {
            analysis.run(model, solver, [] { throw Thrown("seen enough"); });
        } catch (const Thrown& thrown) {
            code = thrown.code;
        }
        CHECK(code == 7);
        model.state() = before;
        analysis.run(model, solver, [] {});
        analysis.run(other, solver, [] {});
        CHECK(model.state().q == other.state().q);
        CHECK(model.state().v == other.state().v);
    }
}

}  // namespace own_parts_test
