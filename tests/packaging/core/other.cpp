// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

/// Returns the energy of an element of length 1 stretched by 0.1 % along X.
double stretched_energy(const ancf::CrossSectionBeam<3>& element) {
    const double stretch = 1.001;
    ancf::CrossSectionBeam<3>::Coordinates e = ancf::CrossSectionBeam<3>::Coordinates::Zero();
    for (int node = 0; node < 2; ++node) {
        e(12 * node) = node * stretch;  // r
        e(12 * node + 3) = stretch;     // r_x
        e(12 * node + 7) = 1.0;         // r_y
        e(12 * node + 11) = 1.0;        // r_z
    }
    return element.evaluate(e).energy;
}
