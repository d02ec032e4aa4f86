// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cable/cable.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

void planar_cable(const Settings& settings) {
    run<Cable<2>, false>(settings, "planar-cable", {cable_rule()});
}

}  // namespace ancf::bench::kernels
