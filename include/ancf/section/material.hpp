// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The material of a beam: linearly elastic, isotropic, by two moduli and a density.
///
/// The two moduli are independent numbers because the diagonal material law of [Dufva2006, Eq. 29]
/// uses E and G side by side; Poisson's ratio follows from them.

#pragma once

#include <ancf/error.hpp>

namespace ancf {

/// Young's modulus, shear modulus and density.
struct Material {
    double young;    ///< E, Pa
    double shear;    ///< G, Pa
    double density;  ///< kg/m^3

    /// Returns the material of E and Poisson's ratio: G = E/(2 (1 + nu)).
    /// @param young    Young's modulus, Pa, > 0
    /// @param poisson  Poisson's ratio, 1, in (-1, 0.5]
    /// @param density  kg/m^3, > 0
    /// @throws InvalidArgument naming the value that is out of range or not finite.
    [[nodiscard]] static Material isotropic(double young, double poisson, double density) {
        detail::require_positive("young", young);
        detail::require(poisson > -1.0 && poisson <= 0.5, "poisson must lie in (-1, 0.5], got ",
                        poisson);
        return from_moduli(young, young / (2.0 * (1.0 + poisson)), density);
    }

    /// Returns the material of both moduli.
    /// @param young    Young's modulus, Pa, > 0
    /// @param shear    shear modulus, Pa, > 0
    /// @param density  kg/m^3, > 0
    /// @throws InvalidArgument naming the value that is not positive or not finite.
    [[nodiscard]] static Material from_moduli(double young, double shear, double density) {
        const Material material{young, shear, density};
        material.validate();
        return material;
    }

    /// Returns Poisson's ratio E/(2 G) - 1, 1; outside (-1, 0.5] when the moduli belong to no
    /// isotropic solid.
    [[nodiscard]] constexpr double poisson() const noexcept { return young / (2.0 * shear) - 1.0; }

    /// Throws unless every value is positive and finite: for a material that was filled in by hand.
    /// @throws InvalidArgument naming the value.
    void validate() const {
        detail::require_positive("young", young);
        detail::require_positive("shear", shear);
        detail::require_positive("density", density);
    }
};

}  // namespace ancf
