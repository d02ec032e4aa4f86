// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/loads/damping.hpp>

#include <dynamics/random_scenes.hpp>

namespace ancf::test {

template <class Element>
void damp(Scene& model, const Beam<Element>& beam, double eta) {
    add_kelvin_voigt(model, beam, eta);
}

template void damp(Scene&, const Beam<Cable<2>>&, double);
template void damp(Scene&, const Beam<CrossSectionBeam<2>>&, double);
template void damp(Scene&, const Beam<CrossSectionBeam<3>>&, double);

}  // namespace ancf::test
