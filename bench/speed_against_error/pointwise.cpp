// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

#include <statics.hpp>

void speed::pointwise(const Plan& plan, const Report& report) {
    run_statics<ancf::CrossSectionBeam<3, ancf::Projected, ancf::PointwiseShear>>(
        plan, report, "cross-section-pointwise", {ancf::Rule::paper()}, ancf::Rule::paper());
}
