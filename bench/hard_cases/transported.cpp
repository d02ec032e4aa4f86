// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <hard_cases/spatial.hpp>

std::vector<hard_cases::Case> hard_cases::transported_cases() {
    using Element = ancf::CrossSectionBeam<3, ancf::Transported>;
    return Spatial<Element>("transported", with_rule(ancf::Rule::mixed()), green_tip).cases();
}
