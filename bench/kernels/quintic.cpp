// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

void quintic(const Settings& settings) {
    run<QuinticBeam<>>(settings, "cross-section-quintic", {Rule::quintic()});
}

}  // namespace ancf::bench::kernels
