// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <hard_cases/spatial.hpp>

std::vector<hard_cases::Case> hard_cases::projected_cases() {
    return spatial_cases<ancf::CrossSectionBeam<3>>("cross-section", {"paper", "mixed"});
}
