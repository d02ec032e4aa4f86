// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/elements.hpp>
#include <support/solve.hpp>

template class ancf::Assembly<ancf::Model<examples::CrossSectionTransported>>;

namespace examples {

template ancf::StaticsReport solve(ancf::Model<CrossSectionTransported>&, const SolverOptions&);

}  // namespace examples
