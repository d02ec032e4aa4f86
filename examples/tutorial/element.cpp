// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Step 1 of the tutorial: one element by itself.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/section/section.hpp>

#include <cmath>
#include <iostream>

int main() {
    using Element = ancf::CrossSectionBeam<3>;
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);  // Pa, 1, kg/m^3
    const auto section = ancf::rectangle(0.01, 0.01);                    // width, height in m
    const Element element(steel, section, 0.5);                          // length in m

    // nodal coordinates: r, r_x, r_y, r_z of the first node, then of the second
    Element::Coordinates e;
    e << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1,  //
        0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;

    e.segment<3>(12) *= 1.001;  // pull the second node, and both slopes r_x with it
    e[3] = e[15] = 1.001;
    const auto [energy, force, tangent] = element.evaluate(e);  // one pass, no allocation
    std::cout << "energy " << energy << " J, pull " << force[12] << " N, stiffness "
              << tangent(12, 12) << " N/m, mass " << element.mass()(12, 12) << " kg\n";

    // Green's strain eps = (1.001^2 - 1)/2 stores E A l eps^2/2
    const double eps = 0.5 * (1.001 * 1.001 - 1.0);
    const double expected = 0.5 * 2.07e11 * 1e-4 * 0.5 * eps * eps;
    return std::abs(energy - expected) <= 1e-9 * expected ? 0 : 1;
}
