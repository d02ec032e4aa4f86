// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <hard_cases/spatial.hpp>

std::vector<hard_cases::Case> hard_cases::quintic_cases() {
    return Spatial<ancf::QuinticBeam<>>("quintic", ancf::QuinticOptions(), green_tip).cases();
}
