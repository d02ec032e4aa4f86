// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/complex_elements.hpp>

namespace ancf {

ANCF_COMPLEX_INSTANCE(, ContinuumBeam<3>);
ANCF_COMPLEX_INSTANCE(, ContinuumBeam<2>);
ANCF_COMPLEX_INSTANCE(, TorsionBeam);
ANCF_COMPLEX_INSTANCE(, Cable<3>);

}  // namespace ancf
