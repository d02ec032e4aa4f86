// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Model II, semicircle and pendulum by the ANCF elements of Project Chrono, as comma-separated
/// values: the cases of bench/speed_against_error and in its columns.
///
/// Time is that of Chrono's setup and solution, of one processor, the least of several runs. An
/// error is the distance of the tip from the limit of the element's own theory: a fine mesh of
/// 3333, whose theory is that of 3243 too; of the cable what ancf::Cable has.
/// It is relative to the length in statics; for the pendulum it is the largest at 0.3, 0.5, 0.7 and
/// 1 s, in m. Errors below the distance of two fine meshes are not told.
///
///     chrono_cases [CASE...]    model2, semicircle and pendulum unless told otherwise
///     chrono_cases --version    of Chrono

#include "chrono_chain.hpp"  // first: it includes Chrono before Eigen

#include <chrono/ChVersion.h>
#include <chrono/physics/ChLoad.h>
#include <chrono/physics/ChLoadContainer.h>
#include <chrono/timestepper/ChStaticAnalysis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace peers;

constexpr double pi = 3.141592653589793;
constexpr Beam model_2{2.0, 0.01, 2.07e11, 7.9615e10, 0.0, 7850.0};
constexpr Beam semicircle{1.0, 0.035, 2e8, 1e8, 0.0, 7850.0};
constexpr Beam pendulum{1.2, 0.05, 0.7e6, 2.6923e5, 0.3, 5540.0};

/// Where the tip was, once or at several times.
using Tips = std::vector<ChVector3d>;

struct Run {
    Tips tips;  ///< empty where the run failed
    double milliseconds = 0.0;
    int iterations = 0;
};

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double bending_stiffness(const Beam& beam) {
    return beam.young * beam.side * beam.side * beam.side * beam.side / 12.0;
}

/// Whether a beam is bent by a moment, and not by a force.
bool rolled_up(const Beam& beam) { return beam.length == semicircle.length; }

/// A moment about Z on a slope of a node: M z x d / |d|^2, d the slope's part in the plane.
class SlopeMoment : public chrono::ChLoadCustom {
public:
    SlopeMoment(std::shared_ptr<Node> node, int place, double moment)
        : ChLoadCustom(std::move(node)), place_(place), moment_(moment) {}
    SlopeMoment* Clone() const override { return new SlopeMoment(*this); }
    bool IsStiff() override { return true; }

    void ComputeQ(chrono::ChState* state, chrono::ChStateDelta*) override {
        const auto [x, y] = slope(state);
        load_Q.setZero(LoadGetNumCoordsVelLevel());  // a node is sized when its system starts
        load_Q.segment<2>(place_) = moment_ / (x * x + y * y) * Eigen::Vector2d(-y, x);
    }
    void ComputeJacobian(chrono::ChState* state, chrono::ChStateDelta*) override {
        const auto [x, y] = slope(state);
        const double square = x * x + y * y, mixed = y * y - x * x;
        m_jacobians->K.setZero();
        m_jacobians->K.block<2, 2>(place_, place_) =  // Chrono's is -dQ/dx
            -moment_ / (square * square) *
            (Eigen::Matrix2d() << 2.0 * x * y, mixed, mixed, -2.0 * x * y).finished();
    }

private:
    std::array<double, 2> slope(chrono::ChState* state) {
        chrono::ChState present(LoadGetNumCoordsPosLevel(), nullptr);
        if (!state) LoadGetStateBlock_x(*(state = &present));
        return {(*state)(place_), (*state)(place_ + 1)};
    }

    int place_;
    double moment_;
};

/// Clamps the first node. Beams may shear there, the cable may stretch.
void clamp(Chain& chain, const Kind& kind) {
    Node& node = *chain.nodes.front();
    if (kind.nodes == Kind::Nodes::beam_3333) return node.SetFixed(true);
    chain.pin();
    if (auto* beam = dynamic_cast<fea::ChNodeFEAxyzDDD*>(&node)) {
        beam->SetSlope2Fixed(true);
        beam->SetSlope3Fixed(true);
        return;
    }
    auto direction = std::make_shared<fea::ChLinkNodeSlopeFrame>();
    direction->Initialize(chain.nodes.front(), chain.ground);
    chain.system.Add(direction);
}

/// Bends a cantilever by Chrono's statics.
Run bend(const Beam& beam, const Kind& kind, int count, int load_steps = 1) {
    Chain chain(beam, kind, count);
    clamp(chain, kind);
    auto container = std::make_shared<chrono::ChLoadContainer>();
    chain.system.Add(container);
    constexpr int most = 100;
    chrono::ChStaticNonLinearAnalysis analysis;
    analysis.SetMaxIterations(most);
    analysis.SetCorrectionTolerance(0.0, 1e-7);
    Run run;
    for (int step = 1; step <= load_steps; ++step) {
        const double part = static_cast<double>(step) / load_steps * bending_stiffness(beam);
        container->GetLoadList().clear();
        if (rolled_up(beam))
            container->Add(std::make_shared<SlopeMoment>(chain.nodes.back(), kind.turning_slope(),
                                                         pi / beam.length * part));
        else
            chain.nodes.back()->SetForce(
                ChVector3d(0, 1.5 * part / (beam.length * beam.length), 0));
        const unsigned before = chain.solver->GetNumSetupCalls();
        const double began = processor_ms();
        chain.system.DoStaticAnalysis(analysis);
        run.milliseconds += processor_ms() - began;
        run.iterations = static_cast<int>(chain.solver->GetNumSetupCalls() - before);
        if (run.iterations >= most || !std::isfinite(chain.nodes.back()->GetPos().Length()))
            return run;
    }
    run.tips = {chain.nodes.back()->GetPos()};
    return run;
}

/// Lets the pendulum fall for 1.2 s by Chrono's HHT integrator without its damping.
Run swing(const Beam& beam, const Kind& kind, int count, double step) {
    Chain chain(beam, kind, count, {0, -9.81, 0});
    chain.pin();
    const auto hht = chain.take_hht(0.0);
    hht->SetStepControl(false);  // else the first step stays the longest for long
    Run run;
    const int per_tenth = static_cast<int>(std::lround(0.1 / step));
    const double began = processor_ms();
    chain.system.DoStepDynamics(1e-9);  // finds the accelerations, which Chrono starts from zero
    for (int tenth = 1; tenth <= 12; ++tenth) {
        for (int k = 0; k < per_tenth; ++k) {
            chain.system.DoStepDynamics(step);
            run.iterations += static_cast<int>(hht->GetNumStepIterations());
        }
        if (tenth == 3 || tenth == 5 || tenth == 7 || tenth == 10)
            run.tips.push_back(chain.nodes.back()->GetPos());
    }
    run.milliseconds = processor_ms() - began;
    return run;
}

/// Returns the largest distance of two sets of places, NaN where one is missing.
double distance(const Tips& some, const Tips& others) {
    if (some.size() != others.size()) return std::numeric_limits<double>::quiet_NaN();
    double largest = 0.0;
    for (std::size_t k = 0; k < some.size(); ++k) {
        const double apart = (some[k] - others[k]).Length();
        if (!(apart <= largest)) largest = apart;
    }
    return largest;
}

/// Returns a run with the least time of as many as fill some milliseconds.
template <class Call>
Run least(const Call& call, double enough, int most) {
    Run best = call();
    double spent = best.milliseconds;
    for (int k = 1; k < most && spent < enough; ++k) {
        const double again = call().milliseconds;
        spent += again;
        best.milliseconds = std::min(best.milliseconds, again);
    }
    return best;
}

void print(const std::string& scene, const Kind& kind, const char* solver, int count, double step,
           double error, const Run& run) {
    std::printf("%s,%s,%s,%s,%d,%g,%.4e,%.5g,%d\n", scene.c_str(), kind.name, kind.integration,
                solver, count, step, error, run.milliseconds, run.iterations);
    std::fflush(stdout);
}

/// Returns the tip's limit of Chrono's cable, which is that of ancf::Cable: its Newton method, of
/// differences, does not solve meshes that are fine enough to tell it.
Tips cable_limit(const Beam& beam) {
    if (!rolled_up(beam)) return {{1.7841188708, 0.8219629162, 0.0}};  // 256 elements of Cable<3>
    // EA (l^2 - 1)/2 = EI k^2/l^2, k = M l/EI: bending by the true curvature k stretches it
    const double moment = pi / beam.length * bending_stiffness(beam);
    const double axial = beam.young * beam.side * beam.side;
    const double square = 1.0 + 2.0 * moment * moment / (axial * bending_stiffness(beam));
    const double turned = pi * square, radius = beam.length * std::sqrt(square) / turned;
    return {{radius * std::sin(turned), radius * (1.0 - std::cos(turned)), 0.0}};
}

void statics(const std::string& scene, const Beam& beam) {
    const Tips fine = bend(beam, chrono_3333(beam), 256, 10).tips;
    const double doubt = distance(bend(beam, chrono_3333(beam), 128, 10).tips, fine);
    std::fprintf(stderr, "%s: limit of the beams known to %.1e m\n", scene.c_str(), doubt);
    for (const Kind& kind : {chrono_3243(beam), chrono_3243(beam, false), chrono_3333(beam),
                             chrono_3333(beam, false), chrono_cable(beam)})
        for (const int count : {1, 2, 3, 4, 6, 8, 12, 16, 32, 64}) {
            const Run run = least([&] { return bend(beam, kind, count); }, 20.0, 30);
            const double error = kind.nodes == Kind::Nodes::cable
                                     ? distance(run.tips, cable_limit(beam))
                                     : std::max(distance(run.tips, fine), doubt);
            print(scene, kind, "sparse-lu", count, 0.0, error / beam.length, run);
        }
}

void motion(const std::string& scene, const Beam& beam) {
    const Tips limit = swing(beam, chrono_3333(beam), 64, 2e-4).tips;
    const double doubt = distance(swing(beam, chrono_3333(beam), 32, 4e-4).tips, limit);
    std::fprintf(stderr, "%s: limit known to %.1e m\n", scene.c_str(), doubt);
    for (const Kind& kind :
         {chrono_3243(beam), chrono_3243(beam, false), chrono_3333(beam), chrono_3333(beam, false)})
        for (const double step : {1e-2, 4e-3, 2e-3, 1e-3, 5e-4})
            for (const int count : {2, 4, 8, 16, 32}) {
                const Run run = least([&] { return swing(beam, kind, count, step); }, 60.0, 3);
                print(scene, kind, "hht", count, step, std::max(distance(run.tips, limit), doubt),
                      run);
            }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> cases(argv + 1, argv + argc);
    if (cases == std::vector<std::string>{"--version"})
        return std::puts("Project Chrono " CHRONO_VERSION), 0;
    if (cases.empty()) cases = {"model2", "semicircle", "pendulum"};
    std::puts("case,element,rule,solver,elements,step_or_tolerance,error,cpu_ms,iterations");
    for (const std::string& scene : cases) {
        if (scene == "model2")
            statics(scene, model_2);
        else if (scene == "semicircle")
            statics(scene, semicircle);
        else if (scene == "pendulum")
            motion(scene, pendulum);
        else
            return std::fprintf(stderr, "no case %s\n", scene.c_str()), 2;
    }
    return 0;
}
