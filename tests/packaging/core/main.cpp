// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Uses one element from two translation units: whatever is defined twice would not link.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/error.hpp>
#include <ancf/section/section.hpp>

#include <cmath>
#include <iostream>

// whatever EIGEN_DEFAULT_TO_ROW_MAJOR says: data() is read by columns
static_assert(!ancf::MatrixX::IsRowMajor && !ancf::Matrix<double, 3, 4>::IsRowMajor);

double stretched_energy(const ancf::CrossSectionBeam<3>& element);

int main() {
    const auto steel = ancf::Material::isotropic(2.0e11, 0.3, 7850.0);
    const auto section = ancf::rectangle(0.01, 0.02);
    const ancf::CrossSectionBeam<3> element(steel, section, 1.0);

    const double stretch = 1.001;
    const double strain = (stretch * stretch - 1.0) / 2.0;
    const double expected = 2.0e11 * 0.01 * 0.02 * strain * strain / 2.0;
    const double energy = stretched_energy(element);
    std::cout << "energy " << energy << ", expected " << expected << '\n';
    if (!(std::abs(energy - expected) <= 1e-9 * expected)) return 1;

    try {
        static_cast<void>(ancf::rectangle(-1.0, 1.0));
    } catch (const ancf::InvalidArgument& error) {
        std::cout << "refused: " << error.what() << '\n';
        return 0;
    }
    return 1;
}
