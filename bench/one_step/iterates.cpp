// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/assembly/assembly.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/turning.hpp>

#include <one_step/elements.hpp>

#include <cmath>
#include <iostream>

namespace ancf::bench::one_step {

namespace {

/// Prints the largest strains, axial and of the section in its plane, and the tangent's negative
/// pivots in the iterates of the elastica under 10 E I/L^2.
template <class Element>
void print_iterates(bool mixed, bool turned) {
    Problem p = cantilever<Element>(0.01, 32, 10.0 * Point(0.0, std::cos(0.6), std::sin(0.6)),
                                    Point::Zero());
    EigenLdlt solver;
    Assembly assembly(p.scene, solver.storage());
    solver.analyze(assembly.tangent());
    Turning turning(p.scene, assembly.numbering());
    VectorX& q = p.scene.state().q;
    const VectorX rest = VectorX::Zero(q.size());
    VectorX residual, x;
    Correction last;
    for (int iterate = 0; iterate < 7; ++iterate) {
        if (assembly.evaluate({q, rest, VectorX(), {1.0, 1.0}}, Request::tangent, nullptr,
                              mixed && iterate > 0 ? &last : nullptr))
            return;
        double axial = 0.0, stretch = 0.0, shear = 0.0;
        const auto larger = [](double a, double b) { return std::abs(b) > std::abs(a) ? b : a; };
        const auto& group = p.scene.group<Element>();
        for (int k = 0; k < group.size(); ++k)
            for (const double xi : {0.0, 0.5, 1.0}) {
                const auto e = p.scene.element_coordinates<Element>(k);
                axial = larger(axial, group.element(k).strains(e, xi)[0]);
                const auto across = group.element(k).transverse_strains(e, xi);
                stretch = larger(stretch, across[0]);
                shear = larger(shear, across[2]);
            }
        const auto factors = solver.factorize(assembly.tangent());
        std::cout << "| " << (turned ? "turned by the tangent" : "added") << " | "
                  << measure<Element>() << ", " << (mixed ? "mixed" : "plain") << " | " << iterate
                  << " | " << axial << " | " << stretch << " | " << shear << " | "
                  << factors.negative_pivots << " |\n";
        assembly.residual(residual);
        solver.solve(residual, x);
        last.before = q;
        assembly.numbering().add_free(x, -1.0, q);
        last.change = q - last.before;
        if (turned)
            turning.turn(last.before, last.change, q, TurnBy::tangent);
        else if (mixed)
            turning.twist(last.before, last.change, q);
    }
}

}  // namespace

void print_iterates() {
    std::cout << "| corrections | tangent | iterate | axial | e_yy | 2e_yz | negative pivots |\n"
                 "|---|---|---|---|---|---|---|\n";
    for (const bool turned : {false, true})
        for (const bool mixed : {false, true}) {
            print_iterates<Green>(mixed, turned);
            print_iterates<Engineering>(mixed, turned);
        }
}

}  // namespace ancf::bench::one_step
