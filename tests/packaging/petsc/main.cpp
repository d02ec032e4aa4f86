// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/petsc/distributed_scene.hpp>
#include <ancf/section/profiles.hpp>

#include <cstdio>

int main(int argc, char** argv) {
    const ancf::petsc::Session session(&argc, &argv);
    ancf::Model model;
    const auto steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);
    const auto rope = ancf::straight_beam<ancf::Cable<3>>(model, steel, ancf::rectangle(0.01, 0.01),
                                                          {0, 0, 0}, {1, 0, 0}, 4);
    model.clamp(rope.first());
    model.add(ancf::Force<3>(rope.last(), {0, 0, -1}));

    ancf::petsc::DistributedScene scene(model, PETSC_COMM_WORLD);
    const auto report = scene.solve();
    scene.gather();

    // P l^3 / (3 E I) = 2 mm
    const double sag = model.position(rope.last())[2];
    if (ancf::petsc::Session::rank() == 0)
        std::printf("%s: %.6f m\n", std::string(to_string(report.status)).c_str(), sag);
    return report.status == ancf::Status::converged && sag < -1.99e-3 && sag > -2.01e-3 ? 0 : 1;
}
