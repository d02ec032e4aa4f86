// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The tables of explicit methods as ARKODE has them, and how far each is stable.

#pragma once

#include <arkode/arkode_erkstep.h>

namespace ancf::sundials::detail {

/// A table. Its reach from zero, as a product of step and rate, is of its coefficients, rounded
/// down.
struct ErkTable {
    ARKODE_ERKTableID id;
    bool reuses_last;  ///< whether the last stage is the first of the next step
    double axis;       ///< on the imaginary axis: without damping
    double disc;       ///< radius of the left half of a disc: with damping
};

/// The tables in the order of Table.
inline constexpr ErkTable erk_tables[] = {
    {ARKODE_BOGACKI_SHAMPINE_4_2_3, true, 1.732, 1.732},
    {ARKODE_ZONNEVELD_5_3_4, false, 2.828, 2.615},
    {ARKODE_ARK436L2SA_ERK_6_3_4, false, 3.999, 3.688},
    {ARKODE_ARK437L2SA_ERK_7_3_4, false, 4.695, 4.503},
    {ARKODE_DORMAND_PRINCE_7_4_5, true, 0.997, 0.997},
    {ARKODE_VERNER_8_5_6, false, 1.306, 1.306},
    {ARKODE_FEHLBERG_13_7_8, false, 2.365, 2.365},
};

}  // namespace ancf::sundials::detail
