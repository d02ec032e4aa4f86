// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The scene of Project Chrono's own benchmark of its beam 3243, btest_FEA_ANCFbeam_3243_
/// LargeDisplacement.cpp: 32 elements, pinned at one end, swing with an initial velocity.
///
/// It is solved by Chrono, by elements of the library inside Chrono, and by the library alone. A
/// time is the least of some repeats, which take turns.
///
///     chrono_swing [REPEATS]    3 unless told otherwise

#include "chrono_chain.hpp"  // first: it includes Chrono before Eigen

#include <element.hpp>  // of examples/chrono

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace peers;
using Paper = ancf::CrossSectionBeam<3>;
using Best = ancf::CrossSectionBeam<3, ancf::Geodesic>;

ancf::CrossSectionOptions mixed() {
    ancf::CrossSectionOptions options;
    options.rule = ancf::Rule::mixed();
    return options;
}

const Beam swinging{1.0, std::sqrt(2.5e-4), 1.6e5, 8e4, 0.0, 320.0};
constexpr double earth = 9.80665;  // m/s^2, along -Z
constexpr double step = 1e-3;      // s
constexpr int steps = 1010;
constexpr int members = 32;

/// Velocity along Y of a point in the beginning, as the benchmark has it; slopes have none.
double first_velocity(double x) { return -8.0 * x; }

struct Swung {
    ancf::Vector<double, 3> tip;
    double milliseconds;
    long iterations;
};

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Swung swing_in_chrono(const Kind& kind, double alpha) {
    Chain chain(swinging, kind, members, {0, 0, -earth});
    for (const NodePointer& node : chain.nodes)
        node->SetPosDt({0, first_velocity(node->GetPos().x()), 0});
    chain.pin();
    const auto hht = chain.take_hht(alpha);
    long iterations = 0;
    const double began = processor_ms();
    for (int k = 0; k < steps; ++k) {
        chain.system.DoStepDynamics(step);
        iterations += hht->GetNumStepIterations();
    }
    return {chain.nodes.back()->GetPos().eigen(), processor_ms() - began, iterations};
}

/// A kind of the nodes of 3243 with elements of the library.
template <class Element>
Kind inside_chrono(const ancf::CrossSectionOptions& options) {
    const auto add = [=](fea::ChMesh& mesh, const std::vector<NodePointer>& nodes, double length) {
        const auto node = [&](int k) {
            return std::static_pointer_cast<fea::ChNodeFEAxyzDDD>(nodes[k]);
        };
        const Element element(material(swinging), section(swinging), length, options);
        return ancf_chrono::add_element(mesh, node(0), node(1), element);
    };
    return {"", "", Kind::Nodes::beam_3243, add};
}

/// @param integrate  integrates a problem with a solver over a schedule
template <class Element, class Integrator>
Swung swing_alone(const typename Element::Options& options, const Integrator& integrator,
                  double damping = 0.0) {
    ancf::Model model;
    const auto beam =
        ancf::straight_beam<Element>(model, material(swinging), section(swinging), {0, 0, 0},
                                     {swinging.length, 0, 0}, members, options);
    model.pin(beam.first());
    model.set_gravity({0, 0, -earth});
    for (const auto node : beam.nodes)
        model.set_rate(node, ancf::Field::r,
                       ancf::Vector<double, 3>(0, first_velocity(model.position(node)[0]), 0));
    if (damping > 0.0) ancf::add_kelvin_voigt(model, beam, damping);
    const double began = processor_ms();
    std::unique_ptr<ancf::LinearSolver> solver = std::make_unique<ancf::BlockTridiagonal>();
    if (damping > 0.0) solver = std::make_unique<ancf::EigenLu>();  // it has no symmetric tangent
    ancf::ProblemOptions for_solver;
    for_solver.storage = solver->storage();
    ancf::DynamicProblem problem(model, for_solver);
    const double end = steps * step;
    const auto report =
        integrator.integrate(problem, *solver, ancf::equal_intervals(0.0, end, end));
    if (report.status != ancf::Status::converged) std::printf("%s\n", report.message.c_str());
    return {model.position(beam.last()), processor_ms() - began, report.iterations};
}

void measure_scene(int rounds) {
    ancf::GeneralizedAlphaOptions fixed;
    fixed.rho = 1.0;  // HHT without damping
    fixed.step = step;
    fixed.newton_tolerance = 1e-10;
    fixed.follow_energy = false;
    const ancf::GeneralizedAlpha trapezoid(fixed);
    ancf::RadauOptions adaptive;
    adaptive.tolerance = 1e-4;
    adaptive.follow_energy = false;
    const ancf::RadauIIA radau(adaptive);
    const auto best = ancf::CrossSectionOptions::best();
    const auto chrono_at = [](bool continuous, double alpha, double damping) {
        return [=] { return swing_in_chrono(chrono_3243(swinging, continuous, damping), alpha); };
    };
    const std::vector<std::pair<const char*, std::function<Swung()>>> runs = {
        {"Chrono 3243, continuous, as its benchmark has it", chrono_at(true, -0.2, 0.01)},
        {"Chrono 3243, pre-integrated, as its benchmark has it", chrono_at(false, -0.2, 0.01)},
        {"damping 0.01 s, Chrono 3243, continuous, alpha 0", chrono_at(true, 0.0, 0.01)},
        {"damping 0.01 s, Chrono 3243, pre-integrated, alpha 0", chrono_at(false, 0.0, 0.01)},
        {"damping 0.01 s, CrossSectionBeam<3> alone, same steps",
         [&] { return swing_alone<Paper>(mixed(), trapezoid, 0.01); }},
        {"damping 0.01 s, CrossSectionBeam<3> alone, RadauIIA",
         [&] { return swing_alone<Paper>(mixed(), radau, 0.01); }},
        {"no damping, Chrono 3243, continuous, alpha 0", chrono_at(true, 0.0, 0.0)},
        {"no damping, Chrono 3243, pre-integrated, alpha 0", chrono_at(false, 0.0, 0.0)},
        {"no damping, CrossSectionBeam<3>, in Chrono, alpha 0",
         [&] { return swing_in_chrono(inside_chrono<Paper>(mixed()), 0.0); }},
        {"no damping, CrossSectionBeam<3, Geodesic>, in Chrono, alpha 0",
         [&] { return swing_in_chrono(inside_chrono<Best>(best), 0.0); }},
        {"no damping, CrossSectionBeam<3> alone, same steps",
         [&] { return swing_alone<Paper>(mixed(), trapezoid); }},
        {"no damping, CrossSectionBeam<3, Geodesic> alone, same steps",
         [&] { return swing_alone<Best>(best, trapezoid); }},
        {"no damping, CrossSectionBeam<3, Geodesic> alone, RadauIIA",
         [&] { return swing_alone<Best>(best, radau); }}};
    std::printf("\nThe scene of Chrono's benchmark, %d elements: tip at %g s (m), ms, iterations\n",
                members, steps * step);
    std::vector<Swung> least;
    for (int round = 0; round < rounds; ++round)
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const Swung again = runs[k].second();
            if (round == 0) least.push_back(again);
            least[k].milliseconds = std::min(least[k].milliseconds, again.milliseconds);
        }
    for (std::size_t k = 0; k < runs.size(); ++k)
        std::printf("  %-62s %9.5f %9.5f %9.5f %8.1f %7ld\n", runs[k].first, least[k].tip[0],
                    least[k].tip[1], least[k].tip[2], least[k].milliseconds, least[k].iterations);
}

}  // namespace

int main(int argc, char** argv) {
    measure_scene(argc > 1 ? std::atoi(argv[1]) : 3);
    return 0;
}
