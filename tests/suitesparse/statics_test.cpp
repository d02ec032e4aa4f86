// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/suitesparse/klu.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <support/catch.hpp>

#include <random>

namespace suitesparse_statics_test {

using namespace ancf;
using namespace ancf::suitesparse;
using Point = Vector<double, 3>;
using Bar = CrossSectionBeam<3>;

/// Loads the end of two beams of random shapes with a body welded between them: the body bears the
/// load, or nothing where that end is clamped.
/// @return how far the body moves, m
Point loaded_body(unsigned seed, LinearSolver& solver) {
    std::mt19937 engine(seed);
    const auto draw = [&engine](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(engine);
    };
    const Material steel = Material::isotropic(2.1e11, 0.3, 7800.0);
    const double height = draw(0.01, 0.05), width = draw(0.01, 0.05);
    const Section section = rectangle(height, width);
    const double y = draw(-0.5, 0.5), z = draw(-0.5, 0.5);
    const Point middle(1.0, y, z), end(2.0, -z, y);
    Model model;
    const auto left =
        straight_beam<Bar>(model, steel, section, Point(0, 0, 0), middle, 1 + seed % 6);
    const NodeId body = model.add_node(middle);
    add_body(model, body, 2.0, Point(0.03, 0.04, 0.05).asDiagonal());
    const auto right = straight_beam<Bar>(model, steel, section, middle, end, 1 + seed / 6 % 6);
    model.clamp(left.first());
    if (seed % 2 == 0) model.clamp(right.last());
    model.add(Weld(model, left.last(), body));
    model.add(Weld(model, body, right.first()));
    model.add(Force<3>(right.last(), {3e-5, 1e-4, -6e-5}));
    const auto report = solve_statics(model, solver);
    CAPTURE(seed, solver.name(), report.message);
    REQUIRE(report.status == Status::converged);
    return model.position(body) - middle;
}

TEST_CASE("statics: a body between welds is no mechanism for SuiteSparse", "[suitesparse]") {
    // the body's own stiffness is that of the forces in it, which the diagonal may not show
    for (unsigned seed = 0; seed < 72; ++seed) {
        EigenLu core;
        Klu klu;
        Umfpack umfpack;
        const Point moved = loaded_body(seed, core);
        CHECK((loaded_body(seed, klu) - moved).norm() <= 1e-13);  // of up to 1.5e-7
        CHECK((loaded_body(seed, umfpack) - moved).norm() <= 1e-13);
    }
}

}  // namespace suitesparse_statics_test
