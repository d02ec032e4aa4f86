// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Corners of frames against linear frame analysis (stiffness matrices of Timoshenko's beam, exact
/// at their ends), under refinement, and far bent.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <Eigen/Cholesky>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace frames_test {

using namespace ancf;
using P2 = Vector<double, 2>;
using P3 = Vector<double, 3>;

const Material steel = Material::isotropic(2e11, 0.3, 7800.0);

/// A frame that is clamped at its first joint and loaded at another one.
struct Case {
    const char* name;
    std::vector<P3> points;
    std::vector<Member> members;
    int loaded;
};

std::vector<Case> corners() {
    return {
        {"L", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1}, {1, 2}}, 2},
        {"T", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}}, {{0, 1}, {1, 2}, {1, 3}}, 2},
        {"straight", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1}, {1, 2}}, 2},
        {"one member", {{0, 0, 0}, {1, 0, 0}}, {{0, 1}}, 1},
        {"Y", {{0, 0, 0}, {1, 0, 0}, {1.7, 0.7, 0}, {1.7, -0.7, 0}}, {{0, 1}, {1, 2}, {1, 3}}, 2},
        {"oblique", {{0, 0, 0}, {1, 0, 0}, {1.6, 0.8, 0.3}}, {{0, 1}, {1, 2}}, 2},
        {"three axes", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {{0, 1}, {1, 2}, {1, 3}}, 2},
        {"portal",
         {{0, 0, 0}, {0.2, 0, 1}, {1, 0, 1}, {1.3, 0.4, 0.2}},
         {{0, 1}, {1, 2}, {2, 3}},
         3},
        {"cell",
         {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
         {{0, 1},
          {1, 2},
          {2, 3},
          {3, 0},
          {4, 5},
          {5, 6},
          {6, 7},
          {7, 4},
          {0, 4},
          {1, 5},
          {2, 6},
          {3, 7}},
         6}};
}

/// Returns the displacement of the loaded joint by linear frame analysis.
P3 linear(const Case& of, const Section& section, const P3& force) {
    const int n = 6 * static_cast<int>(of.points.size());
    MatrixX K = MatrixX::Zero(n, n);
    const Moments& m = section.moments();
    const double E = steel.young, G = steel.shear, A = m.area, J = section.torsion_constant();
    for (const Member& member : of.members) {
        const P3 from = of.points[static_cast<std::size_t>(member.first)];
        const P3 axis = of.points[static_cast<std::size_t>(member.second)] - from;
        const double L = axis.norm();
        const Matrix<double, 3> R = reference_slopes(axis);
        MatrixX k = MatrixX::Zero(12, 12);
        const auto pair = [&](int i, double stiffness) {
            k(i, i) = k(i + 6, i + 6) = stiffness;
            k(i, i + 6) = k(i + 6, i) = -stiffness;
        };
        pair(0, E * A / L);
        pair(3, G * J / L);
        for (int axis_of = 0; axis_of < 2; ++axis_of) {  // bending along y, then along z
            const double I = axis_of == 0 ? m.yy : m.zz;
            const double kappa =
                axis_of == 0 ? section.shear_correction_y() : section.shear_correction_z();
            const double phi = 12.0 * E * I / (kappa * G * A * L * L);
            const double c = E * I / (L * L * L * (1.0 + phi)), s = axis_of == 0 ? 1.0 : -1.0;
            const int at[4] = {1 + axis_of, 5 - axis_of, 7 + axis_of, 11 - axis_of};
            const double b[4][4] = {{12, s * 6 * L, -12, s * 6 * L},
                                    {s * 6 * L, (4 + phi) * L * L, -s * 6 * L, (2 - phi) * L * L},
                                    {-12, -s * 6 * L, 12, -s * 6 * L},
                                    {s * 6 * L, (2 - phi) * L * L, -s * 6 * L, (4 + phi) * L * L}};
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j) k(at[i], at[j]) += c * b[i][j];
        }
        MatrixX turn = MatrixX::Zero(12, 12);
        for (int i = 0; i < 4; ++i) turn.block<3, 3>(3 * i, 3 * i) = R.transpose();
        k = turn.transpose() * k * turn;
        const int place[2] = {6 * member.first, 6 * member.second};
        for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b)
                K.block<6, 6>(place[a], place[b]) += k.block<6, 6>(6 * a, 6 * b);
    }
    VectorX f = VectorX::Zero(n);
    f.segment<3>(6 * of.loaded) = force;
    const VectorX u = K.bottomRightCorner(n - 6, n - 6).ldlt().solve(f.tail(n - 6));
    return u.segment<3>(6 * of.loaded - 6);
}

struct Found {
    P3 moved;
    double lowest;  // natural frequency of the clamped frame, 1/s^2
};

Found solve(const Case& of, const Section& section, int elements, const P3& force, int steps = 1) {
    using Beam = CrossSectionBeam<3>;
    std::vector<Member> members = of.members;
    for (Member& member : members) member.elements = elements;
    Model model;
    const auto built =
        frame<Beam>(model, {{steel, section}}, of.points, members, {}, CrossSectionOptions::best());
    model.clamp(built.joints[0]);
    EigenLdlt solver;
    ModalOptions one;
    one.count = 1;
    const ModalReport modes = natural_modes(model, solver, one);
    REQUIRE(modes.status == Status::converged);
    const auto at = static_cast<std::size_t>(of.loaded);
    model.add(Force<3>(built.joints[at], force));
    StaticsOptions options;
    options.steps = steps;
    REQUIRE(solve_statics(model, solver, options).status == Status::converged);
    return {model.position(built.joints[at]) - of.points[at], modes.modes[0].value};
}

TEST_CASE("frames: corners are those of linear frame analysis, at every mesh", "[verification]") {
    const Section section = rectangle(0.02, 0.03);
    const P3 force(0.003, -0.007, 0.01);
    double worst = 0.0;
    int checked = 0;
    for (const Case& of : corners()) {
        const P3 expected = linear(of, section, force);
        for (const int elements : {1, 2, 8, 32}) {
            INFO(of.name << ", " << elements << " elements");
            const Found found = solve(of, section, elements, force);
            const double error = (found.moved - expected).norm() / expected.norm();
            worst = std::max(worst, error);
            CHECK(error <= 4e-5);  // found 2.4e-5; a hinge or a corner that softens gives 1e-2
            CHECK(found.lowest > 100.0);  // a hinge has 0
            ++checked;
        }
    }
    CHECK(checked == 36);
    INFO("worst " << worst);
    CHECK(worst > 0.0);
}

TEST_CASE("frames: far bent corners settle under refinement", "[verification]") {
    const Section section = rectangle(0.02, 0.02);
    int checked = 0;
    for (const Case& of : corners()) {
        INFO(of.name);
        const P3 force(0.0, 50.0, 80.0);
        const Found coarse = solve(of, section, 16, force, 2),
                    fine = solve(of, section, 32, force, 2);
        CHECK(fine.moved.norm() > 0.01);
        CHECK((fine.moved - coarse.moved).norm() <= 1e-6);  // of a member's length
        ++checked;
    }
    CHECK(checked == 9);
}

TEST_CASE("frames: planar corners are those of space", "[verification]") {
    const Section section = rectangle(0.02, 0.02);
    const auto tip = [&](auto element, auto from, auto knee, auto end, auto force) {
        using Beam = decltype(element);
        BasicModel<Beam::dimension> model;
        const auto built =
            frame<Beam>(model, {{steel, section}}, {from, knee, end},
                        {{0, 1, 0, 16}, {1, 2, 0, 16}}, {}, CrossSectionOptions::best());
        model.clamp(built.joints[0]);
        model.add(Force<Beam::dimension>(built.joints[2], force));
        EigenLdlt solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        return P2(model.position(built.joints[2]).template head<2>());
    };
    struct {
        static CrossSectionBeam<2> planar() { return {steel, rectangle(0.02, 0.02), 1.0}; }
        static CrossSectionBeam<3> spatial() { return {steel, rectangle(0.02, 0.02), 1.0}; }
    } sample;
    const P2 flat = tip(sample.planar(), P2(0, 0), P2(1, 0), P2(1, 1), P2(100, 50));
    const P2 deep = tip(sample.spatial(), P3(0, 0, 0), P3(1, 0, 0), P3(1, 1, 0), P3(100, 50, 0));
    CHECK((flat - P2(1, 1)).norm() > 0.02);
    CHECK((flat - deep).norm() <= 1e-5);
}

}  // namespace frames_test
