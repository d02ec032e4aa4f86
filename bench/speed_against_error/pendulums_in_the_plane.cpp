// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/planar/beam.hpp>

#include <pendulums.hpp>

void speed::pendulums_in_the_plane(const Plan& plan, const Report& report) {
    using ancf::Rule;
    run_pendulums<ancf::CrossSectionBeam<2>>(plan, report, "planar", {Rule::paper(), Rule::mixed()},
                                             Rule::mixed(), true);
}
