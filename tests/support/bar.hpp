// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The smallest element that a model takes: a bar with Green strain, positions only.
///
/// U = 1/2 EA l eps^2, eps = ((d.d)/l^2 - 1)/2, d = r_j - r_i; consistent mass.

#pragma once

#include <ancf/element/compiled_element.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <memory>

namespace ancf::test {

template <int Dimension>
class Bar {
public:
    static constexpr int dimension = Dimension;
    static constexpr int dofs = 2 * Dimension;
    static constexpr Fields fields = Field::r;
    using Coordinates = Vector<double, dofs>;

    Bar(double axial_stiffness, double mass_per_length, double length)
        : stiffness_(axial_stiffness), line_density_(mass_per_length), length_(length) {}

    [[nodiscard]] double length() const { return length_; }

    [[nodiscard]] double energy(const Coordinates& e) const {
        return 0.5 * stiffness_ * length_ * strain(e) * strain(e);
    }

    [[nodiscard]] Coordinates force(const Coordinates& e) const { return evaluate(e).force; }

    [[nodiscard]] Evaluation<double, dofs> evaluate(const Coordinates& e) const {
        Evaluation<double, dofs> out;
        Coordinates slope;  // d eps / d e
        const Vector<double, Dimension> d =
            e.template tail<Dimension>() - e.template head<Dimension>();
        slope << -d, d;
        slope /= length_ * length_;
        const double tension = stiffness_ * strain(e);
        out.energy = energy(e);
        out.force = length_ * tension * slope;
        out.tangent = length_ * stiffness_ * slope * slope.transpose();
        const auto unit = Matrix<double, Dimension>::Identity();
        const double geometric = tension / length_;
        out.tangent.template topLeftCorner<Dimension, Dimension>() += geometric * unit;
        out.tangent.template bottomRightCorner<Dimension, Dimension>() += geometric * unit;
        out.tangent.template topRightCorner<Dimension, Dimension>() -= geometric * unit;
        out.tangent.template bottomLeftCorner<Dimension, Dimension>() -= geometric * unit;
        return out;
    }

    [[nodiscard]] Matrix<double, dofs> mass() const {
        Matrix<double, dofs> m = Matrix<double, dofs>::Zero();
        for (int i = 0; i < dofs; ++i) {
            m(i, i) = line_density_ * length_ / 3.0;
            m(i, (i + Dimension) % dofs) = line_density_ * length_ / 6.0;
        }
        return m;
    }

    [[nodiscard]] Coordinates gravity(const Vector<double, Dimension>& g) const {
        Coordinates force;
        force << g, g;
        return 0.5 * line_density_ * length_ * force;
    }

    [[nodiscard]] bool admissible(const Coordinates& e) const { return e.allFinite(); }

private:
    [[nodiscard]] double strain(const Coordinates& e) const {
        const Vector<double, Dimension> d =
            e.template tail<Dimension>() - e.template head<Dimension>();
        return 0.5 * (d.squaredNorm() / (length_ * length_) - 1.0);
    }

    double stiffness_;
    double line_density_;
    double length_;
};

}  // namespace ancf::test

#if defined(ANCF_COMPILED)
namespace ancf {

// in bar.cpp
extern template std::unique_ptr<ElementGroup> detail::make_group<test::Bar<2>>();
extern template std::unique_ptr<ElementGroup> detail::make_group<test::Bar<3>>();

}  // namespace ancf
#endif
