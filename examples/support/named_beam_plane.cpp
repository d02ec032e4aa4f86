// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/with_element.hpp>

namespace examples {

template NamedBeam straight_beam(ancf::PlanarModel&, const BeamOptions&, int);
template NamedBeam straight_beam(ancf::PlanarModel&, const BeamOptions&, const ancf::Material&,
                                 const ancf::Section&, const ancf::Vector<double, 2>&,
                                 const ancf::Vector<double, 2>&, int);
template void check<2>(const BeamOptions&);

}  // namespace examples
