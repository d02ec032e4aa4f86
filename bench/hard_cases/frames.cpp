// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Frames under refinement. Two members at a right angle, the second one loaded across their plane,
// attached to a joint or welded, and a cell of a lattice, against linear frame analysis. A corner
// in the plane and a portal with oblique members, far bent, against Reissner's beam.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <hard_cases/cases.hpp>
#include <support/frame_theory.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace hard_cases {

namespace {

using Element = ancf::CrossSectionBeam<3>;

/// Members of 1 m; the deflection of the end, relative to that of linear frame analysis.
void corner(Rows& rows, bool welded, int elements) {
    // h/L = 0.02: a joint k = 100 times as stiff as its members yields by 4e-5 h/L of the bending
    Row row = make_row("cross-section", "best", welded ? "corner_welded" : "corner_attached",
                       elements, 1e-4);
    const double start = now();
    const auto steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);
    const auto section = ancf::rectangle(0.02, 0.02);
    const auto best = ancf::CrossSectionOptions::best();
    ancf::Model scene;
    ancf::NodeId foot, end;
    if (welded) {
        const auto first = ancf::straight_beam<Element>(scene, steel, section, {0, 0, 0}, {1, 0, 0},
                                                        elements, best);
        const auto second = ancf::straight_beam<Element>(scene, steel, section, {1, 0, 0},
                                                         {1, 1, 0}, elements, best);
        scene.add(ancf::Weld(scene, first.last(), second.first()));
        foot = first.first();
        end = second.last();
    } else {
        const auto frame =
            ancf::frame<Element>(scene, {{steel, section}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                                 {{0, 1, 0, elements}, {1, 2, 0, elements}}, {}, best);
        foot = frame.joints[0];
        end = frame.joints[2];
    }
    scene.clamp(foot);
    constexpr double load = 0.01;
    scene.add(ancf::Force<3>(end, {0, 0, load}));
    ancf::EigenLu solver;
    set(row, ancf::solve_statics(scene, solver));
    const ancf::Moments& m = section.moments();
    const double theory = load * (2.0 / (3.0 * steel.young * m.zz) +
                                  1.0 / (steel.shear * section.torsion_constant()) +
                                  2.0 / (section.shear_correction_z() * steel.shear * m.area));
    row.error = std::abs(scene.position(end)[2] / theory - 1.0);
    row.seconds = now() - start;
    rows.push_back(row);
}

/// A frame of tests/support/frame_theory.hpp under a force; the error of the loaded joint's
/// displacement, relative to that of the theory.
void attached(Rows& rows, const std::string& name, const ancf::test::FrameCase& of, bool bent,
              const ancf::Vector<double, 3>& force, int elements) {
    // the joints' compliance, as of corner(), which the first mesh doubles
    Row row = make_row("cross-section", "best", name, elements, 1e-4);
    const double start = now();
    const auto steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);
    const auto section = ancf::rectangle(0.02, 0.02);
    std::vector<ancf::Member> members = of.members;
    for (ancf::Member& member : members) member.elements = elements;
    ancf::Model scene;
    const auto frame = ancf::frame<Element>(scene, {{steel, section}}, of.points, members, {},
                                            ancf::CrossSectionOptions::best());
    scene.clamp(frame.joints[0]);
    const auto at = static_cast<std::size_t>(of.loaded);
    scene.add(ancf::Force<3>(frame.joints[at], force));
    ancf::EigenLu solver;
    ancf::StaticsOptions how;
    how.steps = bent ? 2 : 1;
    set(row, ancf::solve_statics(scene, solver, how));
    const ancf::Vector<double, 3> theory =
        bent ? ancf::test::ExactFrame(of, steel, section).displacement(force)
             : ancf::test::linear_frame(of, steel, section, force);
    row.error = (scene.position(frame.joints[at]) - of.points[at] - theory).norm() / theory.norm();
    row.seconds = now() - start;
    rows.push_back(row);
}

}  // namespace

std::vector<Case> frame_cases() {
    const auto of = [](bool welded) {
        return [welded](Rows& rows, bool quick) {
            for (const int elements : {1, 4, 16, 64})
                if (!quick || elements < 16) corner(rows, welded, elements);
        };
    };
    const auto known = [](const std::string& name, const std::string& theirs, bool bent,
                          const ancf::Vector<double, 3>& force) -> Case {
        return {name, [=](Rows& rows, bool quick) {
                    for (const auto& one : ancf::test::frame_cases()) {
                        if (one.name != theirs) continue;
                        for (const int elements : {1, 4, 16, 64})
                            if (!quick || elements < 16)
                                attached(rows, name, one, bent, force, elements);
                    }
                }};
    };
    return of_element("cross-section",
                      {{"corner_attached", of(false)},
                       {"corner_welded", of(true)},
                       known("corner_in_plane_attached", "L", true, {-30.0, 80.0, 0.0}),
                       known("portal_attached", "portal", true, {0.0, 50.0, 80.0}),
                       known("cell_attached", "cell", false, {0.003, -0.007, 0.01})});
}

}  // namespace hard_cases
