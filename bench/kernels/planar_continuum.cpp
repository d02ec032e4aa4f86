// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/continuum/beam.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

extern template void measure<Pack<4>>(const Subject&, const ContinuumBeam<2>&);
extern template void measure<Pack<8>>(const Subject&, const ContinuumBeam<2>&);

void planar_continuum(const Settings& settings) {
    run<ContinuumBeam<2>>(settings, "planar-continuum", {Rule::paper()});
}

}  // namespace ancf::bench::kernels
