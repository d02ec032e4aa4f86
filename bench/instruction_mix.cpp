// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What instruction_mix.py counts: one force, and one energy, force and tangent, of as many beams
/// side by side as a register holds. The functions named measured_* are counted, nothing else.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/section/profiles.hpp>

#include <cmath>
#include <cstdio>

namespace {

using namespace ancf;

using Element = CrossSectionBeam<3>;
using Lanes = Pack<register_lanes>;
using Coordinates = Vector<Lanes, Element::dofs>;

}  // namespace

extern "C" {

ANCF_NOINLINE double measured_force(const Element& element, const Coordinates& e) {
    return element.force(e)[3][0];
}

ANCF_NOINLINE double measured_tangent(const Element& element, const Coordinates& e) {
    return element.evaluate(e).tangent(3, 4)[0];
}
}

int main() {
    const Element element(Material::isotropic(2.07e11, 0.3, 7850.0), rectangle(0.1, 0.2), 1.0);
    Element::Coordinates e;
    e << 0.1, -0.2, 0.3, 0.9, 0.1, -0.1, -0.05, 1.02, 0.03, 0.02, 0.01, 0.97,  //
        1.0, 0.1, 0.25, 0.8, 0.5, -0.2, -0.5, 0.9, 0.1, 0.1, -0.2, 1.05;
    const Coordinates packs = e.cast<Lanes>();
    const double force = measured_force(element, packs), tangent = measured_tangent(element, packs);
    std::printf("%.17g %.17g\n", force, tangent);
    return std::isfinite(force) && std::isfinite(tangent) ? 0 : 1;
}
