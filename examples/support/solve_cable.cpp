// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/elements.hpp>
#include <support/solve.hpp>

template class ancf::Assembly<ancf::Model<examples::Cable>>;
template class ancf::Assembly<ancf::Model<examples::PlanarCable>>;

namespace examples {

template ancf::StaticsReport solve(ancf::Model<Cable>&, const SolverOptions&);
template ancf::StaticsReport solve(ancf::Model<PlanarCable>&, const SolverOptions&);

}  // namespace examples
