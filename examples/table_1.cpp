// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The paper's Table 1 and nothing else: [Dufva2006, section 5.2].
///
/// A slender cantilever (L 2, 0.01 x 0.01) under a dead force 1.5 E I/L^2 at its tip, by the
/// paper's three elements. The library is used header-only: this file is compiled, and beside it
/// the element that takes longest. The program `cantilever` solves the same scene by every element
/// and with options.

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

#include <support/report.hpp>
#include <support/table_1.hpp>

#include <iostream>
#include <string>

namespace ancf {

ANCF_COMPILED_ELEMENT(ContinuumBeam<3>);  // in table_1/continuum_beam.cpp

}  // namespace ancf

namespace {

constexpr double length = 2.0;                        // m
constexpr double side = 0.01;                         // m, of the square section
constexpr double young = 2.07e11, shear = 7.9615e10;  // Pa
constexpr double force = 1.5 * young * (side * side * side * side / 12.0) / (length * length);  // N

/// Solves the meshes of one element and adds their rows; returns whether all converged.
template <class Element>
bool solve(const std::string& name, examples::Table& table, examples::Verdict& verdict) {
    using examples::fixed;
    bool converged = true;
    const auto steel = ancf::Material::from_moduli(young, shear, 7850.0);  // kg/m^3, unused here
    const auto section = ancf::rectangle(side, side).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    for (const examples::Published& published : examples::table_1) {
        if (published.element != name) continue;
        const int elements = published.elements;
        ancf::Model model;
        const auto beam = ancf::straight_beam<Element>(model, steel, section, {0, 0, 0},
                                                       {length, 0, 0}, elements);
        model.clamp(beam.first(), ancf::Clamp::free_slope);
        model.add(ancf::Force<3>(beam.last(), {0.0, force, 0.0}));

        ancf::EigenLdlt solver;
        const auto report = ancf::solve_statics(model, solver);
        converged = converged && report.status == ancf::Status::converged;
        const ancf::Vector<double, 3> tip = model.position(beam.last());
        const double deviation =
            verdict.deviation(published, tip[0], tip[1], examples::table_1_tolerance);
        table.add({name, std::to_string(elements), std::to_string(report.iterations()),
                   std::string(to_string(report.status)), fixed(tip[0], 7), fixed(tip[1], 7),
                   fixed(published.first, 4), fixed(published.second, 4),
                   examples::scientific(deviation)});
    }
    return converged;
}

}  // namespace

int main() {
    using namespace ancf;
    examples::Table table({"element", "elements", "iterations", "status", "x", "y", "published x",
                           "published y", "deviation"});
    examples::Verdict verdict;
    bool good = solve<CrossSectionBeam<3>>("cross-section", table, verdict);
    good &= solve<CrossSectionBeam<3, Projected, PointwiseShear>>("cross-section-pointwise", table,
                                                                  verdict);
    good &= solve<ContinuumBeam<3>>("continuum", table, verdict);
    std::cout << "Table 1: cantilever, Model II, tip position in m\n";
    table.print(std::cout);
    if (!std::cout.flush()) {
        std::cerr << "cannot write standard output\n";
        return 2;
    }
    return good && verdict.good() ? 0 : 1;
}
