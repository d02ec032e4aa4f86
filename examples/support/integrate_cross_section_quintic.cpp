// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/elements.hpp>
#include <support/integrate.hpp>

namespace examples {

template Motion integrate(ancf::Model<CrossSectionQuintic>&, const MotionOptions&, ancf::Schedule);

}  // namespace examples
