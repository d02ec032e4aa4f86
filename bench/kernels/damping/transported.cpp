// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>

#include <kernels/damping.hpp>

namespace ancf::bench::kernels {

template void measure_damping(const Subject&, const CrossSectionBeam<3, Transported>&);

}  // namespace ancf::bench::kernels
