// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/elements.hpp>
#include <support/solve.hpp>

template class ancf::Assembly<ancf::Model<examples::PlanarCrossSection>>;
template class ancf::Assembly<ancf::Model<examples::PlanarContinuum>>;

namespace examples {

template ancf::StaticsReport solve(ancf::Model<PlanarCrossSection>&, const SolverOptions&);
template ancf::StaticsReport solve(ancf::Model<PlanarContinuum>&, const SolverOptions&);

}  // namespace examples
