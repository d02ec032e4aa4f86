// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/torsion/beam.hpp>

#include <element_cost/measure.hpp>

#include <vector>

namespace ancf::bench::element_cost {

std::vector<Cost> space(const Settings& settings) {
    return {measure<CrossSectionBeam<3>>("CrossSectionBeam<3>", settings),
            measure<Cable<3>>("Cable<3>", settings, {}),
            measure<TorsionBeam>("TorsionBeam", settings),
            measure<CrossSectionBeam<3, Geodesic>>("CrossSectionBeam<3, Geodesic>", settings),
            measure<QuinticBeam<>>("QuinticBeam<>", settings, {})};
}

}  // namespace ancf::bench::element_cost
