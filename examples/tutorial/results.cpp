// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Step 7 of the tutorial: reactions, section forces, stresses and pictures of the cantilever.

#include <ancf/assembly/resultant.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/transmitted_forces.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/output/vtk.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

#include <cmath>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);  // Pa, 1, kg/m^3
    const auto section = ancf::rectangle(0.01, 0.01);                    // width, height in m

    using Element = ancf::CrossSectionBeam<3>;
    ancf::Model model;
    const auto beam = ancf::straight_beam<Element>(model, steel, section, {0, 0, 0}, {2, 0, 0}, 8);
    model.clamp(beam.first());
    model.add(ancf::Force<3>(beam.last(), {0.0, 64.7, 0.0}));  // N
    ancf::EigenLdlt solver;
    const auto report = ancf::solve_statics(model, solver);

    // what the clamp exerts on its node: a force in N, a moment about the node in N m
    const auto clamp =
        ancf::nodal_resultant(model, model.state().q, report.reactions, beam.first());

    // what the section in the middle of the first element transmits, and a stress there
    const Element& element = model.group<Element>().element(beam.elements[0]);
    const auto e = model.element_coordinates<Element>(beam.elements[0]);
    const auto forces = ancf::transmitted_forces(element, e, 0.5);
    const double stress = element.stress(e, 0.5, 0.005, 0.0)[0];  // S_xx at y = 5 mm, Pa

    ancf::Surface surface;  // with section forces, stresses and velocities at its points
    surface.add(model, beam, section);
    ancf::write_vtk("cantilever.vtp", surface);  // for ParaView

    std::cout << "clamp " << clamp.force.transpose() << " N, " << clamp.moment.transpose()
              << " N m\nsection N " << forces.axial << " N, Q_y " << forces.shear_y << " N, M_z "
              << forces.moment_z << " N m, S_xx " << stress / 1e6 << " MPa\n";

    const double arm = model.position(beam.last())[0];
    const bool balanced = std::abs(clamp.force[1] + 64.7) < 1e-6 &&
                          std::abs(clamp.moment[2] + 64.7 * arm) < 1e-6 &&
                          std::abs(std::hypot(forces.axial, forces.shear_y) - 64.7) < 1e-6;
    return report.status == ancf::Status::converged && balanced ? 0 : 1;
}
