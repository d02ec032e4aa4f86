// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/section/material.hpp>

namespace ancf {

ANCF_INLINE Material Material::isotropic(double young, double poisson, double density) {
    detail::require_positive("young", young);
    detail::require(poisson > -1.0 && poisson <= 0.5, "poisson must lie in (-1, 0.5], got ",
                    poisson);
    return from_moduli(young, young / (2.0 * (1.0 + poisson)), density);
}

ANCF_INLINE Material Material::from_moduli(double young, double shear, double density) {
    const Material material{young, shear, density};
    material.validate();
    return material;
}

ANCF_INLINE void Material::validate() const {
    detail::require_positive("young", young);
    detail::require_positive("shear", shear);
    detail::require_positive("density", density);
}

}  // namespace ancf
