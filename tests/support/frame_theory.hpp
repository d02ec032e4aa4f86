// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Frames that are clamped at their first joint and loaded at another one, with what theories of
/// beams say of them: linear frame analysis, and Reissner's geometrically exact beam [Reissner1981]
/// by integration along the members.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ancf::test {

/// A frame of members of one section.
struct FrameCase {
    const char* name;
    std::vector<Vector<double, 3>> points;
    std::vector<Member> members;  ///< each leads away from the clamped joint, where that is one way
    int loaded;                   ///< place of the joint that the force acts on
};

/// Returns corners of all kinds, a portal with oblique members and a cell of a lattice.
inline std::vector<FrameCase> frame_cases() {
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

/// Returns the displacement of the loaded joint, m, by linear frame analysis: stiffness matrices of
/// Timoshenko's beam, exact at their ends.
inline Vector<double, 3> linear_frame(const FrameCase& of, const Material& material,
                                      const Section& section, const Vector<double, 3>& force) {
    const int n = 6 * static_cast<int>(of.points.size());
    MatrixX K = MatrixX::Zero(n, n);
    const Moments& m = section.moments();
    const double E = material.young, G = material.shear, A = m.area, J = section.torsion_constant();
    for (const Member& member : of.members) {
        const Vector<double, 3> from = of.points[static_cast<std::size_t>(member.first)];
        const Vector<double, 3> axis = of.points[static_cast<std::size_t>(member.second)] - from;
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

/// The way from the clamped to the loaded joint, as Reissner's beam under a dead force at its end.
///
/// Along a member r' = R (e_1 + strain) and R' = R skew(curvature). Strain and curvature are those
/// of the force F and of the moment (r_end - r) x F in the section's axes, which are constant and
/// known but for r_end. Members beside that way carry nothing.
class ExactFrame {
public:
    using Point = Vector<double, 3>;

    ExactFrame(const FrameCase& of, const Material& material, const Section& section) {
        const Moments& m = section.moments();
        axial_ = {1.0 / (material.young * m.area),
                  1.0 / (section.shear_correction_y() * material.shear * m.area),
                  1.0 / (section.shear_correction_z() * material.shear * m.area)};
        bending_ = {1.0 / (material.shear * section.torsion_constant()),
                    1.0 / (material.young * m.zz), 1.0 / (material.young * m.yy)};
        for (int at = of.loaded; at != 0;) {
            const auto member = std::find_if(of.members.begin(), of.members.end(),
                                             [&](const Member& one) { return one.second == at; });
            way_.insert(way_.begin(), Point(of.points[static_cast<std::size_t>(member->second)] -
                                            of.points[static_cast<std::size_t>(member->first)]));
            at = member->first;
        }
    }

    /// Returns the displacement of the loaded joint, m, by Newton's method on it.
    /// @throws InvalidArgument where that does not converge.
    [[nodiscard]] Point displacement(const Point& force) const {
        Point straight = Point::Zero();
        for (const Point& axis : way_) straight += axis;
        Point end = straight;
        constexpr int loads = 8;
        for (int load = 1; load <= loads; ++load) {
            const Point applied = force * (static_cast<double>(load) / loads);
            double error = 1.0;
            for (int k = 0; k < 30 && error > 1e-12; ++k) {
                const Point off = reached(applied, end) - end;
                error = off.norm();
                Matrix<double, 3> slope;
                constexpr double h = 1e-5;
                for (int i = 0; i < 3; ++i) {
                    const Point by = h * Point::Unit(i);
                    slope.col(i) =
                        (reached(applied, end + by) - reached(applied, end - by)) / (2.0 * h) -
                        Point::Unit(i);
                }
                end -= slope.inverse() * off;
            }
            detail::require(error <= 1e-12, "the reference did not converge: ", error);
        }
        return end - straight;
    }

private:
    struct Place {
        Point r;
        Matrix<double, 3> R;
    };

    /// Returns where the way ends if its moments are those of an end at `end`.
    [[nodiscard]] Point reached(const Point& force, const Point& end) const {
        const auto rate = [&](const Place& at) -> Place {
            const Point n = at.R.transpose() * force;
            const Point m = at.R.transpose() * cross(Point(end - at.r), force);
            const Point strain = Point::Unit(0) + axial_.cwiseProduct(n);
            const Point k = bending_.cwiseProduct(m);
            Matrix<double, 3> skew;
            skew << 0.0, -k[2], k[1], k[2], 0.0, -k[0], -k[1], k[0], 0.0;
            return {at.R * strain, at.R * skew};
        };
        const auto moved = [](const Place& from, const Place& by, double h) -> Place {
            return {from.r + h * by.r, from.R + h * by.R};
        };
        Place at{Point::Zero(), Matrix<double, 3>::Identity()};
        for (const Point& axis : way_) {
            const Matrix<double, 3> rest = reference_slopes(axis);
            at.R = at.R * rest;
            constexpr int steps = 200;
            const double h = axis.norm() / steps;
            for (int k = 0; k < steps; ++k) {
                const Place a = rate(at), b = rate(moved(at, a, 0.5 * h)),
                            c = rate(moved(at, b, 0.5 * h)), d = rate(moved(at, c, h));
                at.r += h / 6.0 * (a.r + 2.0 * b.r + 2.0 * c.r + d.r);
                at.R += h / 6.0 * (a.R + 2.0 * b.R + 2.0 * c.R + d.R);
            }
            at.R = at.R * rest.transpose();
        }
        return at.r;
    }

    std::vector<Point> way_;
    Point axial_, bending_;  // compliances of a section, in its axes
};

}  // namespace ancf::test
