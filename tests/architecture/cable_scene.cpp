// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A scene of cables alone; check_symbols.py looks at what the compiler made of it.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

int main() {
    using Element = ancf::Cable<2>;
    ancf::PlanarModel model;
    const auto cable =
        ancf::straight_beam<Element>(model, ancf::Material::isotropic(1e9, 0.3, 1000.0),
                                     ancf::circle(0.01), {0.0, 0.0}, {1.0, 0.0}, 4);
    model.clamp(cable.first());
    model.set_gravity({0.0, -9.81});
    ancf::EigenLdlt solver;
    return ancf::solve_statics(model, solver, {}).status == ancf::Status::converged ? 0 : 1;
}
