// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What hard cases in the plane share: the element with engineering strains and its rows.

#pragma once

#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>

#include <hard_cases/cases.hpp>

#include <string>
#include <utility>

namespace hard_cases::planar {

using Beam =
    ancf::CrossSectionBeam<2, ancf::Projected, ancf::LinearShear, ancf::EngineeringMeasure>;
using Scene = ancf::PlanarModel;
using Plane = ancf::Vector<double, 2>;

inline Row make(std::string name, int elements, double limit) {
    return make_row("planar-engineering", "mixed", std::move(name), elements, limit);
}

inline ancf::CrossSectionOptions mixed() {
    ancf::CrossSectionOptions options;
    options.rule = ancf::Rule::mixed();
    return options;
}

}  // namespace hard_cases::planar
