// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/continuum/beam.hpp>

#include <statics.hpp>

void speed::continuum(const Plan& plan, const Report& report) {
    using ancf::Rule;
    const std::vector<Rule> rules = {Rule::paper(), Rule::lobatto3()};
    run_statics<ancf::ContinuumBeam<3>>(plan, report, "continuum", rules, Rule::lobatto3());
    run_statics<ancf::ContinuumBeam<2>>(plan, report, "planar-continuum", rules, Rule::lobatto3());
}
