// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/torsion/beam.hpp>

#include <statics.hpp>

void speed::torsion(const Plan& plan, const Report& report) {
    using ancf::Rule;
    run_statics<ancf::TorsionBeam>(plan, report, "torsion", {Rule::paper(), Rule::mixed()},
                                   Rule::mixed());
}
