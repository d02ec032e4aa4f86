// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <hard_cases/spatial.hpp>

std::vector<hard_cases::Case> hard_cases::projected_cases() {
    std::vector<Case> all;
    for (const ancf::Rule& rule : {ancf::Rule::paper(), ancf::Rule::mixed()})
        for (Case& one :
             Spatial<ancf::CrossSectionBeam<3>>("cross-section", with_rule(rule), green_tip)
                 .cases())
            all.push_back(std::move(one));
    return all;
}
