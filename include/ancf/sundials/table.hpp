// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The tables of explicit methods, and how far each is stable.

#pragma once

namespace ancf::sundials {

/// A pair of explicit Runge-Kutta formulas. Only those whose stability region holds a piece of the
/// imaginary axis are here; the comments have that piece, as frequency times step.
enum class Table {
    bogacki_shampine,  ///< order 3, 3 forces a step, stable to 1.73
    zonneveld,         ///< order 4, 5 forces, 2.82: the classical method with an error estimate
    ark436,            ///< order 4, 6 forces, 4.00: explicit part of ARK4(3)6L[2]SA
    ark437,            ///< order 4, 7 forces, 4.69: explicit part of ARK4(3)7L[2]SA1
    dormand_prince,    ///< order 5, 6 forces, 0.99
    verner,            ///< order 6, 8 forces, 1.30
    fehlberg           ///< order 8, 13 forces, 2.36
};

namespace detail {

/// How far from zero a table is stable, as a product of step and rate.
struct Reach {
    double axis;  ///< on the imaginary axis: without damping
    double disc;  ///< radius of the left half of a disc: with damping
};

/// Returns the reach of a table, from its coefficients, rounded down.
[[nodiscard]] constexpr Reach reach_of(Table table) noexcept {
    switch (table) {
        case Table::bogacki_shampine: return {1.732, 1.732};
        case Table::zonneveld: return {2.828, 2.615};
        case Table::ark437: return {4.695, 4.503};
        case Table::dormand_prince: return {0.997, 0.997};
        case Table::verner: return {1.306, 1.306};
        case Table::fehlberg: return {2.365, 2.365};
        case Table::ark436: break;
    }
    return {3.999, 3.688};
}

}  // namespace detail
}  // namespace ancf::sundials
