// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/planar/beam.hpp>

#include <statics.hpp>

void speed::planar(const Plan& plan, const Report& report) {
    using ancf::Rule;
    run_statics<ancf::CrossSectionBeam<2>>(
        plan, report, "planar", {Rule::paper(), Rule::gauss(3), Rule::lobatto3(), Rule::mixed()},
        Rule::mixed());
    run_statics<ancf::PlanarQuinticBeam<>>(plan, report, "planar-quintic", {Rule::quintic()},
                                           Rule::quintic());
}
