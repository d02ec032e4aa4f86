// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Step 6 of the tutorial: how far a mesh is from its limit, told by three meshes.

#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/richardson.hpp>

#include <cmath>
#include <iostream>
#include <vector>

namespace {

/// Returns the first natural frequency of a steel cantilever, Hz.
double frequency(int elements) {
    ancf::PlanarModel model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
        model, ancf::Material::isotropic(2.07e11, 0.3, 7850.0), ancf::rectangle(0.01, 0.01), {0, 0},
        {2, 0}, elements);
    model.clamp(beam.first());

    ancf::EigenLdlt solver;
    ancf::ModalOptions options;
    options.count = 1;
    const auto report = ancf::natural_modes(model, solver, options);
    return report.status == ancf::Status::converged ? report.modes[0].frequency() : std::nan("");
}

}  // namespace

int main() {
    const auto first = ancf::richardson(frequency, 2);  // 2, 4 and 8 elements
    std::cout << first.values[2] << " Hz with " << first.elements[2] << " elements, order "
              << first.order << ", error " << first.error << ", limit " << first.estimate << '\n';

    // Euler's beam: 1.875104^2 sqrt(E I/(rho A L^4))/(2 pi); shear and rotary inertia take 2e-5
    const double theory = 3.516015 / 4.0 * std::sqrt(2.07e11 * 1e-4 / 12.0 / 7850.0) / 6.283185;
    const bool right = first.settles && std::abs(first.estimate / theory - 1.0) <= 1e-4;
    return right ? 0 : 1;
}
