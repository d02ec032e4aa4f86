// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <hard_cases/spatial.hpp>

std::vector<hard_cases::Case> hard_cases::engineering_cases() {
    using Element =
        ancf::CrossSectionBeam<3, ancf::Geodesic, ancf::LinearShear, ancf::EngineeringMeasure>;
    const Spatial<Element> spatial("geodesic-engineering", with_rule(ancf::Rule::mixed()),
                                   engineering_tip);
    std::vector<Case> all = spatial.cases();
    const Spatial<Element> fine("geodesic-engineering", with_rule(ancf::Rule::gauss(3)),
                                engineering_tip);
    all.push_back({"helix", [fine](Rows& rows, bool quick) { fine.helix(rows, quick); },
                   "geodesic-engineering"});
    return all;
}
