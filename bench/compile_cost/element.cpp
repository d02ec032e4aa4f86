// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// One element inside somebody else's code: force and tangent.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/section/profiles.hpp>

double stiffness(const ancf::CrossSectionBeam<3>& element,
                 const ancf::CrossSectionBeam<3>::Coordinates& e) {
    return element.evaluate(e).tangent(0, 0);
}
