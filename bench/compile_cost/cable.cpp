// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// A cable inside somebody else's code: force and tangent.

#include <ancf/element/cable/cable.hpp>
#include <ancf/section/profiles.hpp>

double stiffness(const ancf::Cable<3>& element, const ancf::Cable<3>::Coordinates& e) {
    return element.evaluate(e).tangent(0, 0);
}
