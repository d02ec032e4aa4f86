// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

#include <statics.hpp>

void speed::quintic(const Plan& plan, const Report& report) {
    using ancf::Rule;
    run_statics<ancf::QuinticBeam<>>(plan, report, "cross-section-quintic",
                                     {Rule::quintic(), Rule::gauss(5)}, Rule::quintic());
}
