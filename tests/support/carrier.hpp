// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// An element that gives its nodes vectors and no force or mass: for tests that need a model but
/// no mechanics.

#pragma once

#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/types.hpp>

namespace ancf::test {

/// @tparam Bits  the fields as a set of bits.
template <int Dimension, unsigned Bits>
struct Carrier {
    static constexpr int dimension = Dimension;
    static constexpr Fields all() {
        Fields set;
        for (int k = 0; k < field_count; ++k)
            if ((Bits & (1U << static_cast<unsigned>(k))) != 0)
                set = set | Fields(static_cast<Field>(k));
        return set;
    }
    static constexpr Fields fields = all();
    static constexpr int dofs = 2 * Dimension * all().count();
    using Coordinates = Vector<double, dofs>;
    [[nodiscard]] double length() const { return reference_length; }
    [[nodiscard]] double energy(const Coordinates& /*e*/) const { return 0.0; }
    [[nodiscard]] Coordinates force(const Coordinates& /*e*/) const { return Coordinates::Zero(); }
    [[nodiscard]] Evaluation<double, dofs> evaluate(const Coordinates& /*e*/) const {
        return {0.0, Coordinates::Zero(), Matrix<double, dofs>::Zero()};
    }
    [[nodiscard]] Matrix<double, dofs> mass() const { return Matrix<double, dofs>::Zero(); }
    [[nodiscard]] Coordinates gravity(const Vector<double, Dimension>& /*g*/) const {
        return Coordinates::Zero();
    }
    [[nodiscard]] bool admissible(const Coordinates& /*e*/) const { return true; }
    double reference_length = 1.0;
};

using BeamCarrier = Carrier<3, 0b1111U>;
using CableCarrier = Carrier<3, 0b0011U>;
using PlanarCarrier = Carrier<2, 0b0111U>;

}  // namespace ancf::test
