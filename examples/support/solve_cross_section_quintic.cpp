// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/elements.hpp>
#include <support/solve.hpp>

template class ancf::Assembly<ancf::Model<examples::CrossSectionQuintic>>;

namespace examples {

template ancf::StaticsReport solve(ancf::Model<CrossSectionQuintic>&, const SolverOptions&);

}  // namespace examples
