// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the instruction counts are taken of: one force and tangent of an element, and one Newton
/// iteration of a chain. The functions named measured_* are counted, nothing else.

#include <ancf/assembly/assembly.hpp>
#include <ancf/compiler.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/block_tridiagonal.hpp>

#include <cmath>
#include <cstdio>

namespace {

using Element = ancf::CrossSectionBeam<3>;
using Scene = ancf::Model;

constexpr int elements = 100;

const ancf::Material steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);

}  // namespace

extern "C" {

ANCF_NOINLINE double measured_evaluation(const Element& element, const Element::Coordinates& e) {
    const auto result = element.evaluate(e);
    return result.energy + result.force[3] + result.tangent(3, 4);
}

ANCF_NOINLINE double measured_iteration(ancf::Assembly& assembly, ancf::BlockTridiagonal& solver,
                                        const ancf::Configuration& at, ancf::VectorX& residual,
                                        ancf::VectorX& correction) {
    if (assembly.evaluate(at, ancf::Request::tangent)) return NAN;
    assembly.residual(residual);
    if (solver.factorize(assembly.tangent()).status != ancf::Status::converged) return NAN;
    solver.solve(residual, correction);
    return correction.squaredNorm();
}
}

int main() {
    const Element element(steel, ancf::rectangle(0.1, 0.2), 1.0);
    Element::Coordinates e;
    e << 0.1, -0.2, 0.3, 0.9, 0.1, -0.1, -0.05, 1.02, 0.03, 0.02, 0.01, 0.97,  //
        1.0, 0.1, 0.25, 0.8, 0.5, -0.2, -0.5, 0.9, 0.1, 0.1, -0.2, 1.05;
    const double evaluation = measured_evaluation(element, e);

    Scene scene;
    const auto beam = ancf::straight_beam<Element>(scene, steel, ancf::rectangle(0.02, 0.02),
                                                   {0, 0, 0}, {0.1 * elements, 0, 0}, elements);
    scene.clamp(beam.first());
    ancf::VectorX q = scene.state().q;
    for (Eigen::Index k = 0; k < q.size(); ++k)
        q[k] += 1e-4 * static_cast<double>((k * 37) % 11 - 5);
    const ancf::VectorX rest = ancf::VectorX::Zero(q.size());
    const ancf::VectorX none;
    ancf::Assembly assembly(scene, ancf::Storage::lower);
    ancf::BlockTridiagonal solver(0.0);
    solver.analyze(assembly.tangent());
    ancf::VectorX residual(assembly.numbering().unknowns()), correction(residual.size());
    const double iteration =
        measured_iteration(assembly, solver, {q, rest, none, {0.0, 1.0}}, residual, correction);
    std::printf("%.17g %.17g\n", evaluation, iteration);
    return std::isfinite(evaluation) && std::isfinite(iteration) ? 0 : 1;
}
