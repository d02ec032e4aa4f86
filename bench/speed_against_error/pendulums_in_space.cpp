// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

#include <pendulums.hpp>

void speed::pendulums_in_space(const Plan& plan, const Report& report) {
    using ancf::Rule;
    run_pendulums<ancf::CrossSectionBeam<3>>(plan, report, "cross-section",
                                             {Rule::paper(), Rule::mixed()}, Rule::mixed(), true);
}
