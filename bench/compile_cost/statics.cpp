// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// A cantilever: model, statics and the solver for chains.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/statics.hpp>

int main() {
    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        model, ancf::Material::isotropic(2e11, 0.3, 7800.0), ancf::rectangle(0.01, 0.01), {0, 0, 0},
        {2, 0, 0}, 8);
    model.clamp(beam.first());
    model.add(ancf::Force<3>(beam.last(), {0.0, 50.0, 0.0}));
    ancf::BlockTridiagonal solver;
    return ancf::solve_statics(model, solver).status == ancf::Status::converged ? 0 : 1;
}
