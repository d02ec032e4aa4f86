// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How element_cost measures one element. The elements of the plane and of space have a unit each:
/// with all of them in one it takes a gigabyte to compile.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_ldlt.hpp>

#include <counting.hpp>
#include <peak.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace ancf::bench::element_cost {

struct Settings {
    bool csv = false;
    int repeats = 200;
    int elements = 1000;
};

struct Cost {
    std::string element;
    int coordinates;    ///< of an element
    long operations;    ///< of force and tangent
    double evaluation;  ///< of force and tangent, ns
    double assembly;    ///< of the scene's force and tangent, us
    double solution;    ///< factorisation and solution, us
};

inline volatile double sink;

/// Returns an element's options with the rule "mixed".
template <class Element>
typename Element::Options mixed() {
    typename Element::Options options;
    options.rule = Rule::mixed();
    return options;
}

template <class Element>
Cost measure(const char* name, const Settings& settings,
             const typename Element::Options& options = mixed<Element>()) {
    using Point = Vector<double, Element::dimension>;
    BasicModel<Element::dimension> model;
    const auto material = Material::isotropic(2e11, 0.3, 7800.0);
    const Point from = Point::Zero(), to = Point::Unit(0) * 0.1 * settings.elements;
    const auto beam = straight_beam<Element>(model, material, rectangle(0.02, 0.02), from, to,
                                             settings.elements, options);
    model.clamp(beam.first());
    State& state = model.state();
    for (int k = 0; k < state.q.size(); ++k) state.q[k] += 1e-3 * ((k * 37) % 11 - 5);

    Cost cost{name, Element::dofs, 0, 0.0, 0.0, 0.0};
    const Element& element = model.template group<Element>().element(0);
    typename Element::Coordinates e = model.template element_coordinates<Element>(1);
    Vector<Counting, Element::dofs> counted;
    for (int k = 0; k < Element::dofs; ++k) counted[k] = e[k];
    Counting::reset();
    sink = element.evaluate(counted).energy.value();
    cost.operations = Counting::operations();
    cost.evaluation = nanoseconds(
        [&] {
            const auto evaluation = element.evaluate(e);
            e[0] += 1e-12 * evaluation.force[1] / (1.0 + evaluation.tangent(1, 1));
        },
        20, settings.repeats);
    sink = e[0];

    EigenLdlt solver;
    Assembly assembly(model, solver.storage());
    solver.analyze(assembly.tangent());
    const VectorX rest = VectorX::Zero(state.q.size());
    const int repeats = std::max(3, settings.repeats / 20);
    const auto assemble = [&] {
        if (assembly.evaluate({state.q, rest, state.multipliers, {0.0, 1.0}}, Request::tangent))
            std::fprintf(stderr, "%s: the state is not admissible\n", name);
    };
    cost.assembly = nanoseconds(assemble, 1, repeats) * 1e-3;
    VectorX residual, correction;
    assembly.residual(residual);
    const auto solve = [&] {
        if (solver.factorize(assembly.tangent()).status != Status::converged)
            std::fprintf(stderr, "%s: the tangent has no factors\n", name);
        solver.solve(residual, correction);
        sink = correction[0];
    };
    cost.solution = nanoseconds(solve, 1, repeats) * 1e-3;
    return cost;
}

/// Measures cables and beams in the plane.
std::vector<Cost> plane(const Settings& settings);

/// Measures cables and beams in space, first the cross-section beam.
std::vector<Cost> space(const Settings& settings);

}  // namespace ancf::bench::element_cost
