// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Hard cases in the plane with engineering strains, against Reissner's theory.

#include <ancf/element/joint/affine_joint.hpp>
#include <ancf/model/constraints/planar.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <hard_cases/planar.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace hard_cases {

namespace {

using namespace planar;
using ancf::Field;

/// Both cantilevers of the paper.
void cantilever(Rows& rows, bool deep, int elements) {
    Row row = make(deep ? "deep_cantilever" : "slender_cantilever", elements,
                   deep ? 1e-8 : 0.05 / std::pow(elements, 4));
    const double start = now();
    Scene scene;
    const auto section = deep ? ancf::rectangle(0.1, 0.5) : ancf::rectangle(0.01, 0.01);
    const auto beam =
        ancf::straight_beam<Beam>(scene, ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0),
                                  section, {0, 0}, {2, 0}, elements, mixed());
    scene.clamp(beam.first(), ancf::Clamp::free_slope);
    scene.add(ancf::Force<2>(beam.last(), {0, deep ? 2.5e6 : 1.5 * 2.07e11 * 1e-8 / 48.0}));
    ancf::EigenLdlt solver;
    set(row, ancf::solve_statics(scene, solver));
    const Plane theory =
        deep ? Plane(1.999697522945, 0.032416944776) : Plane(1.784113323480, 0.821971481194);
    row.error = (scene.position(beam.last()) - theory).norm() / 2.0;
    row.seconds = now() - start;
    rows.push_back(row);
}

/// A clamped column beyond its buckling load; a side force leads it there and goes.
void column(Rows& rows) {
    Row row = make("column_after_buckling", 16, 1e-5);
    const double start = now();
    Scene scene;
    const double height = 1e-3, bending = 1e9 * std::pow(height, 4) / 12.0;
    const auto beam =
        ancf::straight_beam<Beam>(scene, ancf::Material::from_moduli(1e9, 4e8, 1000.0),
                                  ancf::rectangle(height, height), {0, 0}, {1, 0}, 16, mixed());
    scene.clamp(beam.first(), ancf::Clamp::free_slope);
    const double load = 1.151719620469 * 0.25 * pi * pi * bending;
    scene.add(ancf::Force<2>(beam.last(), {-load, 0}),
              [](double factor) { return std::min(1.0, 2.0 * factor); });
    scene.add(ancf::Force<2>(beam.last(), {0, 0.05 * load}),
              [](double factor) { return std::min(1.0, 2.0 - 2.0 * factor); });
    ancf::StaticsOptions how;
    how.steps = 20;
    how.adaptive = true;
    ancf::EigenLdlt solver;
    set(row, ancf::solve_statics(scene, solver, how));
    row.error = (scene.position(beam.last()) - Plane(0.741019606076, 0.593207646165)).norm();
    row.seconds = now() - start;
    rows.push_back(row);
}

/// Lee's frame, welded or attached to a joint: the larger error of both limit loads.
void frame(Rows& rows, int refinement, bool attached) {
    // an attached corner yields by 0.002 h/L = 3.3e-5 of the bending
    Row row = make(attached ? "lee_frame_attached" : "lee_frame", 20 * refinement,
                   std::max(1e-3 / std::pow(refinement, 3), attached ? 4e-5 : 0.0));
    const double start = now();
    Scene scene;
    ancf::Moments moments;
    moments.area = 6.0;
    moments.yy = moments.zz = 2.0;
    const auto section =
        ancf::Section::from_moments(moments).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    const auto material = ancf::Material::isotropic(7.2e6, 0.3, 1.0);
    const auto leg = ancf::straight_beam<Beam>(scene, material, section, {0, 0}, {0, 120},
                                               6 * refinement, mixed());
    const auto corner = ancf::straight_beam<Beam>(scene, material, section, {0, 120}, {24, 120},
                                                  2 * refinement, mixed());
    const double own = 8.0 / refinement;
    const int rest = scene.add_prototype(Beam(material, section, own, mixed()));
    ancf::NodeId end = corner.last();
    for (int k = 1; k <= 12 * refinement; ++k) {
        const ancf::NodeId next = scene.add_node({24.0 + own * k, 120.0});
        scene.connect<Beam>(rest, end, next);
        end = next;
    }
    scene.pin(leg.first());
    scene.pin(end);
    if (attached) {
        const ancf::NodeId joint = scene.add_node({0, 120});
        using Body = ancf::AffineJoint<2>;
        const int body = scene.add_prototype(Body(material, 100.0 * 6.0 * 2.0, 2.0));
        scene.connect<Body>(body, joint, joint);
        scene.attach(leg.last(), joint);
        scene.attach(corner.first(), joint);
    } else {
        scene.add(ancf::PlanarWeld(scene, leg.last(), corner.first(), Field::r_y));
    }
    constexpr double upper = 18544.52709444, lower = -9392.489640346;
    scene.add(ancf::Force<2>(corner.last(), {0, -upper}));
    ancf::PathOptions how;
    how.first_step = 0.05;
    how.largest_step = 3.0;
    how.max_points = 400;
    how.progress = [](const ancf::PathPoint& point, const ancf::State&) {
        return point.factor < 1.2;
    };
    ancf::EigenLu solver;
    const auto report = ancf::follow_path(scene, solver, how);
    set(row, report);
    row.error = report.critical.size() < 2
                    ? 1.0
                    : std::max(std::abs(report.critical[0].factor - 1.0),
                               std::abs(report.critical[1].factor * upper / lower - 1.0));
    row.seconds = now() - start;
    rows.push_back(row);
}

}  // namespace

std::vector<Case> planar_cases() {
    const std::vector<Case> all = {
        {"slender_cantilever",
         [](Rows& rows, bool quick) {
             for (const int elements : {2, 4, 8, 16})
                 if (!quick || elements < 8) cantilever(rows, false, elements);
         }},
        {"deep_cantilever", [](Rows& rows, bool) { cantilever(rows, true, 16); }},
        {"column_after_buckling", [](Rows& rows, bool) { column(rows); }},
        {"lee_frame",
         [](Rows& rows, bool quick) {
             frame(rows, 1, false);
             if (!quick) frame(rows, 2, false);
         }},
        {"lee_frame_attached",
         [](Rows& rows, bool quick) {
             for (const int refinement : {1, 2, 4})
                 if (!quick || refinement == 1) frame(rows, refinement, true);
         }},
    };
    return of_element("planar-engineering", all);
}

}  // namespace hard_cases
