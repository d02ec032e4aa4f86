// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cable/cable.hpp>

#include <statics.hpp>

void speed::cable(const Plan& plan, const Report& report) {
    using ancf::Rule;
    const std::vector<Rule> rules = {Rule::paper(), ancf::cable_rule()};
    run_statics<ancf::Cable<3>>(plan, report, "cable", rules, ancf::cable_rule());
    run_statics<ancf::Cable<2>>(plan, report, "planar-cable", rules, ancf::cable_rule());
}
