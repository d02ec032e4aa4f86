// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

void transported(const Settings& settings) {
    run<CrossSectionBeam<3, Transported>>(settings, "cross-section-transported",
                                          {Rule::paper(), Rule::gauss(3), Rule::mixed()});
}

}  // namespace ancf::bench::kernels
