// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cantilever and a pendulum in Chrono, by its own ANCF element and by elements of this library.
///
/// Chrono's statics and its HHT integrator solve all of them. With an element of the library the
/// cantilever's tip must be that of the library's own statics to 1e-8 m, and the pendulum's tip
/// must have that of the library's own motion as its limit for small steps: the program exits with
/// 1 otherwise. It prints what force and Jacobian of one element take, in one
/// run.

#include "element.hpp"  // first: it includes Chrono before Eigen

#include <chrono/fea/ChElementBeamANCF_3243.h>
#include <chrono/fea/ChLinkNodeFrame.h>
#include <chrono/physics/ChSystemSMC.h>
#include <chrono/solver/ChDirectSolverLS.h>
#include <chrono/timestepper/ChStaticAnalysis.h>
#include <chrono/timestepper/ChTimestepperHHT.h>

#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

namespace {

namespace fea = chrono::fea;
using chrono::ChVector3d;
using Node = fea::ChNodeFEAxyzDDD;
using NodePointer = std::shared_ptr<Node>;
using ElementPointer = std::shared_ptr<fea::ChElementGeneric>;
using Clock = std::chrono::steady_clock;

/// A straight beam along X, of a square section.
struct Problem {
    double length, side, young, poisson, density;  // m, m, Pa, 1, kg/m^3

    [[nodiscard]] ancf::Material material() const {
        return ancf::Material::isotropic(young, poisson, density);
    }
    [[nodiscard]] ancf::Section section() const { return ancf::rectangle(side, side); }
};
constexpr Problem cantilever{2.0, 0.01, 2.07e11, 0.3, 7850.0};  // Model II of [Dufva2006]
constexpr double load = 64.7;                                   // N
constexpr Problem pendulum{1.2, 0.05, 0.7e6, 0.3, 5540.0};      // section 5.1 of it
constexpr double earth = 9.81;                                  // m/s^2
constexpr double duration = 0.5;                                // s

/// Makes an element between two nodes, adds it to the mesh and returns it.
using Adder = std::function<ElementPointer(fea::ChMesh&, NodePointer, NodePointer, double length)>;

/// Adds Chrono's own element.
Adder chronos(const Problem& problem, fea::ChElementBeamANCF_3243::IntFrcMethod method) {
    return [=](fea::ChMesh& mesh, NodePointer first, NodePointer last, double length) {
        const double k = 10.0 * (1.0 + problem.poisson) / (12.0 + 11.0 * problem.poisson);
        auto element = std::make_shared<fea::ChElementBeamANCF_3243>();
        element->SetNodes(first, last);
        element->SetDimensions(length, problem.side, problem.side);
        element->SetMaterial(std::make_shared<fea::ChMaterialBeamANCF>(
            problem.density, problem.young, problem.poisson, k, k));
        element->SetAlphaDamp(0.0);
        element->SetIntFrcCalcMethod(method);
        mesh.AddElement(element);
        return element;
    };
}

/// Adds an element of the library.
template <class Element>
Adder librarys(const Problem& problem, const ancf::CrossSectionOptions& options) {
    return [=](fea::ChMesh& mesh, NodePointer first, NodePointer last, double length) {
        const Element element(problem.material(), problem.section(), length, options);
        return ancf_chrono::add_element(mesh, first, last, element);
    };
}

/// A chain along X in a system of Chrono.
struct Chain {
    chrono::ChSystemSMC system;
    std::shared_ptr<fea::ChMesh> mesh = std::make_shared<fea::ChMesh>();
    std::shared_ptr<chrono::ChSolverSparseLU> solver = std::make_shared<chrono::ChSolverSparseLU>();
    std::vector<NodePointer> nodes;
    std::vector<ElementPointer> elements;

    Chain(const Problem& problem, int count, const Adder& add, double gravity) {
        system.SetGravitationalAcceleration(ChVector3d(0, -gravity, 0));
        for (int k = 0; k <= count; ++k) {
            nodes.push_back(std::make_shared<Node>(ChVector3d(problem.length * k / count, 0, 0),
                                                   ChVector3d(1, 0, 0), ChVector3d(0, 1, 0),
                                                   ChVector3d(0, 0, 1)));
            mesh->AddNode(nodes.back());
        }
        for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
            elements.push_back(add(*mesh, nodes[k], nodes[k + 1], problem.length / count));
        system.Add(mesh);
        system.SetSolver(solver);
    }

    [[nodiscard]] ancf::Vector<double, 3> tip() const { return nodes.back()->GetPos().eigen(); }
};

double milliseconds(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// ---- the cantilever

struct Bent {
    ancf::Vector<double, 3> tip;
    int iterations;
    double time;  // ms
};

/// Bends the cantilever by Chrono's statics, the whole load at once.
Bent bend(int count, const Adder& add) {
    Chain chain(cantilever, count, add, 0.0);
    chain.nodes.front()->SetFixed(true);
    chain.nodes.back()->SetForce(ChVector3d(0, load, 0));
    chrono::ChStaticNonLinearAnalysis analysis;
    analysis.SetMaxIterations(500);
    analysis.SetCorrectionTolerance(0.0, 1e-10);
    const auto start = Clock::now();
    chain.system.DoStaticAnalysis(analysis);
    const double time = milliseconds(start);
    return {chain.tip(), static_cast<int>(chain.solver->GetNumSetupCalls()), time};
}

/// Bends it by the library alone.
template <class Element>
ancf::Vector<double, 3> bend_alone(int count, const typename Element::Options& options) {
    ancf::Model model;
    const auto beam =
        ancf::straight_beam<Element>(model, cantilever.material(), cantilever.section(), {0, 0, 0},
                                     {cantilever.length, 0, 0}, count, options);
    for (const auto field : {ancf::Field::r, ancf::Field::r_x, ancf::Field::r_y, ancf::Field::r_z})
        model.fix(beam.first(), field);
    model.add(ancf::Force<3>(beam.last(), {0.0, load, 0.0}));
    ancf::EigenLdlt solver;
    const auto report = ancf::solve_statics(model, solver);
    if (report.status != ancf::Status::converged) std::printf("%s\n", report.message.c_str());
    return model.position(beam.last());
}

void print(const char* name, int count, const Bent& bent, const ancf::Vector<double, 3>& limit) {
    std::printf("  %2d  %-38s %12.9f %12.9f %9.1e %6d %9.2f\n", count, name, bent.tip[0],
                bent.tip[1], (bent.tip - limit).norm() / cantilever.length, bent.iterations,
                bent.time);
}

template <class Element>
bool compare(const char* name, int count, const ancf::CrossSectionOptions& options,
             const ancf::Vector<double, 3>& limit) {
    const Bent bent = bend(count, librarys<Element>(cantilever, options));
    print(name, count, bent, limit);
    const double difference = (bent.tip - bend_alone<Element>(count, options)).norm();
    std::printf("      %.1e m from the library's own statics\n", difference);
    return difference < 1e-8;
}

// ---- the pendulum

/// Returns the tip after the pendulum's fall in Chrono.
Bent swing(int count, const Adder& add, double step) {
    Chain chain(pendulum, count, add, earth);
    auto ground = std::make_shared<chrono::ChBody>();
    ground->SetFixed(true);
    chain.system.Add(ground);
    auto pin = std::make_shared<fea::ChLinkNodeFrame>();
    pin->Initialize(chain.nodes.front(), ground);
    chain.system.Add(pin);
    chain.system.SetTimestepperType(chrono::ChTimestepper::Type::HHT);
    const auto integrator =
        std::static_pointer_cast<chrono::ChTimestepperHHT>(chain.system.GetTimestepper());
    integrator->SetAlpha(0.0);  // another value loses the old forces of slopes: docs/chrono.md
    integrator->SetMaxIters(20);
    integrator->SetRelTolerance(0.0);
    integrator->SetAbsTolerances(1e-9);
    integrator->SetStepControl(false);
    integrator->SetJacobianUpdateMethod(chrono::ChTimestepperImplicit::JacobianUpdate::EVERY_STEP);
    const auto start = Clock::now();
    const int steps = static_cast<int>(duration / step + 0.5);
    int iterations = 0;
    for (int k = 0; k < steps; ++k) {
        chain.system.DoStepDynamics(step);
        iterations += static_cast<int>(integrator->GetNumStepIterations());
    }
    return {chain.tip(), iterations, milliseconds(start)};
}

/// Returns the tip by the library alone, to many digits.
template <class Element>
ancf::Vector<double, 3> swing_alone(int count, const ancf::CrossSectionOptions& options) {
    ancf::Model model;
    const auto beam =
        ancf::straight_beam<Element>(model, pendulum.material(), pendulum.section(), {0, 0, 0},
                                     {pendulum.length, 0, 0}, count, options);
    model.pin(beam.first());
    model.set_gravity({0.0, -earth, 0.0});
    ancf::DynamicProblem problem(model);
    ancf::EigenLu solver;
    ancf::RadauOptions radau;
    radau.tolerance = 1e-9;
    const auto report = ancf::RadauIIA(radau).integrate(
        problem, solver, ancf::equal_intervals(0.0, duration, duration));
    if (report.status != ancf::Status::converged) std::printf("%s\n", report.message.c_str());
    return model.position(beam.last());
}

// ---- the cost of one element

template <class Call>
double least_time(const Call& call) {
    double least = 1e99;
    for (int round = 0; round < 400; ++round) {
        const auto start = Clock::now();
        for (int k = 0; k < 50; ++k) call();
        least = std::min(least, 1e6 * milliseconds(start) / 50);
    }
    return least;
}

void print_cost(const char* name, const Adder& add) {
    Chain chain(cantilever, 8, add, 0.0);
    chain.nodes.front()->SetFixed(true);
    chain.nodes.back()->SetForce(ChVector3d(0, 0.1 * load, 0));
    chrono::ChStaticNonLinearAnalysis analysis;
    chain.system.DoStaticAnalysis(analysis);  // a state that is bent
    fea::ChElementGeneric& element = *chain.elements[3];
    chrono::ChVectorDynamic<> force(24);
    chrono::ChMatrixDynamic<> h(24, 24);
    const double first = least_time([&] { element.ComputeInternalForces(force); });
    const double second = least_time([&] { element.ComputeKRMmatricesGlobal(h, 1.0, 0.0, 0.0); });
    std::printf("  %-42s %8.0f %10.0f\n", name, first, second);
}

}  // namespace

int main() {
    using Paper = ancf::CrossSectionBeam<3>;
    using Best = ancf::CrossSectionBeam<3, ancf::Geodesic>;
    using Method = fea::ChElementBeamANCF_3243::IntFrcMethod;
    ancf::CrossSectionOptions mixed;
    mixed.rule = ancf::Rule::mixed();
    const auto best = ancf::CrossSectionOptions::best();
    bool good = true;

    const auto limit = bend_alone<ancf::QuinticBeam<>>(16, {});
    std::printf("Cantilever: elements, tip (m), error over length, iterations, ms\n");
    for (const int count : {4, 8, 16, 32}) {
        good &= compare<Paper>("CrossSectionBeam<3>, rule mixed", count, mixed, limit);
        good &= compare<Best>("CrossSectionBeam<3, Geodesic>, best()", count, best, limit);
        print("Chrono 3243", count, bend(count, chronos(cantilever, Method::ContInt)), limit);
    }

    const auto own = swing_alone<Paper>(4, mixed);
    std::printf(
        "\nPendulum, 4 elements at %g s: step (s), distance from the library's own (m), "
        "iterations, ms\n",
        duration);
    ancf::Vector<double, 3> before = own;
    double extrapolated = 1.0;
    for (const double step : {1e-3, 5e-4, 2.5e-4, 1.25e-4}) {
        const Bent swung = swing(4, librarys<Paper>(pendulum, mixed), step);
        extrapolated =
            (2.0 * swung.tip - before - own).norm();  // of first order: see docs/chrono.md
        std::printf("  CrossSectionBeam<3>, rule mixed  %8.2e %9.1e %9.1e %6d %8.1f\n", step,
                    (swung.tip - own).norm(), extrapolated, swung.iterations, swung.time);
        before = swung.tip;
        const Bent theirs = swing(4, chronos(pendulum, Method::ContInt), step);
        std::printf("  Chrono 3243: tip %.6f %.6f, %d iterations, %.1f ms\n", theirs.tip[0],
                    theirs.tip[1], theirs.iterations, theirs.time);
    }
    good &= extrapolated < 1e-5;

    std::printf("\nOne element, ns: force, Jacobian\n");
    print_cost("Chrono 3243, continuous integration", chronos(cantilever, Method::ContInt));
    print_cost("Chrono 3243, pre-integration", chronos(cantilever, Method::PreInt));
    print_cost("CrossSectionBeam<3>, rule mixed, in Chrono", librarys<Paper>(cantilever, mixed));
    print_cost("CrossSectionBeam<3, Geodesic>, in Chrono", librarys<Best>(cantilever, best));
    return good ? 0 : 1;
}
