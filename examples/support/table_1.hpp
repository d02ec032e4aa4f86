// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Tip (x, y) in m of the slender cantilever, Model II: [Dufva2006, section 5.2, Table 1].

#pragma once

#include <support/report.hpp>

namespace examples {

/// The printed x of the last cell, 1.852, is a misprint.
inline constexpr Published table_1[] = {{"cross-section", 1, 1.8548, 0.6444},
                                        {"cross-section", 2, 1.8008, 0.7815},
                                        {"cross-section", 4, 1.7872, 0.8139},
                                        {"cross-section", 8, 1.7844, 0.8212},
                                        {"cross-section", 16, 1.7841, 0.8220},
                                        {"cross-section-pointwise", 1, 1.9520, 0.3758},
                                        {"cross-section-pointwise", 2, 1.8683, 0.6383},
                                        {"cross-section-pointwise", 4, 1.7944, 0.8002},
                                        {"cross-section-pointwise", 8, 1.7853, 0.8191},
                                        {"cross-section-pointwise", 16, 1.7844, 0.8213},
                                        {"continuum", 1, 1.9988, 0.0612},
                                        {"continuum", 2, 1.9915, 0.1596},
                                        {"continuum", 4, 1.9516, 0.3847},
                                        {"continuum", 8, 1.8515, 0.6777},
                                        {"continuum", 16, 1.7924, 0.8052}};

/// One unit of the last printed digit, m.
inline constexpr double table_1_tolerance = 1e-4;

}  // namespace examples
