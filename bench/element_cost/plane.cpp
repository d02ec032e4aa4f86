// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/planar/beam.hpp>

#include <element_cost/measure.hpp>

#include <vector>

namespace ancf::bench::element_cost {

std::vector<Cost> plane(const Settings& settings) {
    return {measure<Cable<2>>("Cable<2>", settings, {}),
            measure<CrossSectionBeam<2>>("CrossSectionBeam<2>", settings),
            measure<PlanarQuinticBeam<>>("PlanarQuinticBeam<>", settings, {})};
}

}  // namespace ancf::bench::element_cost
