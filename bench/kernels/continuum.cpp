// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/continuum/beam.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

extern template void measure<Pack<4>>(const Subject&, const ContinuumBeam<3>&);
extern template void measure<Pack<8>>(const Subject&, const ContinuumBeam<3>&);

void continuum(const Settings& settings) {
    run<ContinuumBeam<3>>(settings, "continuum", {Rule::paper(), Rule::gauss(3), Rule::lobatto3()});
}

}  // namespace ancf::bench::kernels
