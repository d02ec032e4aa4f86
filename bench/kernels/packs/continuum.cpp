// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/continuum/beam.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

template void measure<Pack<4>>(const Subject&, const ContinuumBeam<3>&);
template void measure<Pack<8>>(const Subject&, const ContinuumBeam<3>&);

}  // namespace ancf::bench::kernels
