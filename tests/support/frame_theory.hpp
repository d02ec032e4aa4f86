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

#include <support/dense.hpp>

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

/// A frame by linear frame analysis: stiffness matrices of Timoshenko's beam, exact at their ends.
///
/// Six coordinates a joint: displacement, m, and turn.
class LinearFrame {
public:
    using Point = Vector<double, 3>;

    LinearFrame(const std::vector<Point>& points, const std::vector<Member>& members,
                const Material& material, const Section& section)
        : stiffness_(MatrixX::Zero(6 * static_cast<int>(points.size()),
                                   6 * static_cast<int>(points.size()))),
          mass_(VectorX::Zero(stiffness_.rows())) {
        for (const Member& member : members)
            add(member.first, member.second,
                points[static_cast<std::size_t>(member.second)] -
                    points[static_cast<std::size_t>(member.first)],
                material, section);
    }

    /// Returns the coordinates under forces, with the first joints clamped.
    [[nodiscard]] VectorX displaced(int clamped, const VectorX& force) const {
        const Eigen::Index n = force.size(), free = n - 6 * clamped;
        VectorX all = VectorX::Zero(n);
        all.tail(free) = solved(stiffness_.bottomRightCorner(free, free), force.tail(free));
        return all;
    }

    /// Returns the lowest square of a natural frequency, 1/s^2, with the first joint clamped; half
    /// of a member's mass stands at each end.
    /// @param planar  motion in the plane Z = 0 alone
    [[nodiscard]] double lowest(bool planar) const {
        std::vector<int> free;
        for (int k = 6; k < mass_.size(); ++k)
            if (const int of = k % 6; !planar || of < 2 || of == 5) free.push_back(k);
        const auto n = static_cast<Eigen::Index>(free.size());
        MatrixX K(n, n);
        VectorX m(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const int at = free[static_cast<std::size_t>(i)];
            m[i] = mass_[at];
            for (Eigen::Index j = 0; j < n; ++j)
                K(i, j) = stiffness_(at, free[static_cast<std::size_t>(j)]);
        }
        // inverse iteration; the next eigenvalue may be near, its mode does no harm
        const MatrixX flexibility = inverted(K);
        VectorX mode(n);
        for (Eigen::Index i = 0; i < n; ++i) mode[i] = std::cos(static_cast<double>(i * i));
        double quotient = 0.0;
        for (int k = 0; k < 200; ++k) {
            const VectorX next = flexibility * m.cwiseProduct(mode);
            quotient = next.dot(m.cwiseProduct(mode)) / next.dot(m.cwiseProduct(next));
            mode = next / next.cwiseAbs().maxCoeff();
        }
        return quotient;
    }

private:
    void add(int first, int second, const Point& axis, const Material& material,
             const Section& section) {
        const Moments& m = section.moments();
        const double E = material.young, G = material.shear, A = m.area;
        const double J = section.torsion_constant(), L = axis.norm();
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
        const int place[2] = {6 * first, 6 * second};
        for (int i = 0; i < 2; ++i) {
            for (int j = 0; j < 2; ++j)
                stiffness_.block<6, 6>(place[i], place[j]) += k.block<6, 6>(6 * i, 6 * j);
            mass_.segment<3>(place[i]).array() += 0.5 * material.density * A * L;
        }
    }

    MatrixX stiffness_;
    VectorX mass_;  // its diagonal
};

/// Returns the displacement of the loaded joint, m, by linear frame analysis.
inline Vector<double, 3> linear_frame(const FrameCase& of, const Material& material,
                                      const Section& section, const Vector<double, 3>& force) {
    VectorX forces = VectorX::Zero(6 * static_cast<Eigen::Index>(of.points.size()));
    forces.segment<3>(6 * of.loaded) = force;
    return LinearFrame(of.points, of.members, material, section)
        .displaced(1, forces)
        .segment<3>(6 * of.loaded);
}

/// Returns the lowest square of a natural frequency, 1/s^2, by linear frame analysis of members in
/// 32 parts.
/// @param planar  motion in the plane Z = 0 alone
inline double lowest_of_linear_frame(const FrameCase& of, const Material& material,
                                     const Section& section, bool planar) {
    constexpr int parts = 32;
    std::vector<Vector<double, 3>> points = of.points;
    std::vector<Member> members;
    for (const Member& member : of.members) {
        const Vector<double, 3> from = of.points[static_cast<std::size_t>(member.first)];
        const Vector<double, 3> to = of.points[static_cast<std::size_t>(member.second)];
        int last = member.first;
        for (int k = 1; k < parts; ++k) {
            points.push_back(from + (to - from) * k / parts);
            members.push_back({last, static_cast<int>(points.size()) - 1});
            last = members.back().second;
        }
        members.push_back({last, member.second});
    }
    return LinearFrame(points, members, material, section).lowest(planar);
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
