// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

#include <statics.hpp>

void speed::geodesic(const Plan& plan, const Report& report) {
    using ancf::Rule;
    run_statics<ancf::CrossSectionBeam<3, ancf::Geodesic>>(
        plan, report, "cross-section-geodesic", {Rule::paper(), Rule::gauss(3), Rule::mixed()},
        Rule::mixed());
}
