// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <hard_cases/spatial.hpp>

std::vector<hard_cases::Case> hard_cases::continuum_cases() {
    const auto spatial = [](const char* name, ancf::ContinuumMaterial material) {
        return Spatial<ancf::ContinuumBeam<3>>(name, {ancf::Rule::paper(), material}, green_tip);
    };
    std::vector<Case> all =
        spatial("continuum", ancf::ContinuumMaterial::diagonal).straight_cases();
    const auto enhanced = spatial("continuum-enhanced", ancf::ContinuumMaterial::enhanced);
    const auto hooke = spatial("continuum-hooke", ancf::ContinuumMaterial::hooke);
    for (const auto& list : {enhanced.straight_cases(), hooke.bending_cases()})
        all.insert(all.end(), list.begin(), list.end());
    return all;
}
