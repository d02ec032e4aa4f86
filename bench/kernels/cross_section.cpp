// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

void cross_section(const Settings& settings) {
    run<CrossSectionBeam<3>>(settings, "cross-section",
                             {Rule::paper(), Rule::gauss(3), Rule::mixed()});
    run<CrossSectionBeam<3, Projected, PointwiseShear>, false>(settings, "cross-section-pointwise",
                                                               {Rule::paper()});
}

}  // namespace ancf::bench::kernels
