// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/complex_elements.hpp>

namespace ancf {

ANCF_COMPLEX_INSTANCE(, CrossSectionBeam<3>);
ANCF_COMPLEX_INSTANCE(, CrossSectionBeam<3, Geodesic>);
ANCF_COMPLEX_INSTANCE(, CrossSectionBeam<3, Projected, PointwiseShear>);
ANCF_COMPLEX_INSTANCE(, CrossSectionBeam<2>);

}  // namespace ancf
