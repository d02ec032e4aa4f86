// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cable/cable.hpp>

#include <pendulums.hpp>

void speed::pendulums_of_cable(const Plan& plan, const Report& report) {
    run_pendulums<ancf::Cable<2>>(plan, report, "planar-cable", {ancf::cable_rule()},
                                  ancf::cable_rule(), false);
}
