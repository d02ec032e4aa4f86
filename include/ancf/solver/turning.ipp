// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/list.hpp>
#include <ancf/model/triad.hpp>
#include <ancf/solver/turning.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ancf {

namespace detail {

/// The spin of a node's section by the components of its slopes: w = sum_k spin_k dslope_k.
using NodeSpin = std::array<Vec3<double>, 9>;

/// Returns a vector of two or three coordinates.
[[nodiscard]] ANCF_INLINE Vec3<double> vector_at(const double* x, int dimension) noexcept {
    return {{x[0], x[1], dimension == 3 ? x[2] : 0.0}};
}

/// Returns v + change with the part of the change across v as a turn.
/// @param twist  angle by which v turns about itself meanwhile: both are one rotation
[[nodiscard]] ANCF_INLINE Vec3<double> turned(const Vec3<double>& v, const Vec3<double>& change,
                                              double twist, TurnBy by) {
    const double before = length(v);
    if (before == 0.0) return v + change;
    const Vec3<double> unit = v / before;
    const double along = dot(unit, change);
    const Vec3<double> across = (change - along * unit) / before;
    const double bend = length(across);
    if (bend < 1e-12) return v + change;
    // exp of the spin w = unit x across + twist unit, on the unit vector
    const double size = std::hypot(bend, twist);
    const double angle = by == TurnBy::angle ? size : std::atan(size);
    const double first = std::sin(angle) / size, second = (1.0 - std::cos(angle)) / (size * size);
    return (before + along) * ((1.0 - second * bend * bend) * unit + first * across +
                               second * twist * cross(unit, across));
}

/// Finds how a node's section turns, as moments and joints have it: in the plane with r_y, in space
/// with r_y and r_z, or with r_x and r_y where there is no r_z.
/// @return false where slopes are parallel or without length
[[nodiscard]] ANCF_INLINE bool spin_of(const double* slopes, int count, int dimension,
                                       NodeSpin& spin) {
    constexpr double least = 1e-12;
    spin = {};
    if (dimension == 2) {
        const double x = slopes[2], y = slopes[3], square = x * x + y * y;
        if (!(square > least)) return false;
        spin[2][2] = -y / square;
        spin[3][2] = x / square;
        return true;
    }
    const int across = 3 * (count - 2);
    const Vec3<double> first = vector_at(slopes + across, 3),
                       second = vector_at(slopes + across + 3, 3);
    if (!(length(cross(first, second)) > least)) return false;
    const auto frame = count == 3 ? Triad<double>::of_section(first, second, 0.5)
                                  : Triad<double>::of_slopes(first, second);
    std::copy(frame.spin.begin(), frame.spin.end(), spin.begin() + across);
    return true;
}

/// Returns exp(W) v, W of the spin w.
/// @param by  tangent: exp takes atan of the angle of W instead of the angle
[[nodiscard]] ANCF_INLINE Vec3<double> turned_by(const Vec3<double>& spin, const Vec3<double>& v,
                                                 TurnBy by) {
    const double size = length(spin);
    const double angle = by == TurnBy::tangent ? std::atan(size) : size;
    const double first = size > 0.0 ? std::sin(angle) / size : 1.0;
    const double half = size > 0.0 ? std::sin(0.5 * angle) / size : 0.5;
    const Vec3<double> across = cross(spin, v);
    return v + first * across + 2.0 * half * half * cross(spin, across);
}

/// Moves a node's slopes G to exp(W) (G + dG - W G), W the spin w that dG gives the section: dG_k
/// and what w takes from it, w x G_k, turned by w.
/// @param tangent_only  w keeps the part about r_x
/// @param by            tangent: exp takes atan of the angle of W instead of the angle
ANCF_INLINE void turn_frame(const double* before, const double* change, int count, int dimension,
                            bool tangent_only, TurnBy by, double* after) {
    NodeSpin by_slopes;
    if (!spin_of(before, count, dimension, by_slopes)) return;
    Vec3<double> spin = {};
    for (int k = 0; k < count * dimension; ++k) add(spin, change[k], by_slopes[k]);
    if (tangent_only) {
        const Vec3<double> axis = vector_at(before, dimension);
        spin = dot(spin, axis) / dot(axis, axis) * axis;
    }
    for (int k = 0; k < count; ++k) {
        const Vec3<double> slope = vector_at(before + dimension * k, dimension);
        const Vec3<double> end = turned_by(
            spin, slope + vector_at(change + dimension * k, dimension) - cross(spin, slope), by);
        std::copy_n(end.v, dimension, after + dimension * k);
    }
}

/// Writes rate + change, the rate of a slope along the line, with what turns it as the tangent
/// turned: R exp(W) (rate + change - w x rate), w = t x dt the spin of t = r_x/|r_x|, and R the
/// smallest rotation from exp(W) t to the new tangent's direction.
/// @param before,after  r_x
/// @param change        of r_x
ANCF_INLINE void turn_rate(const double* before, const double* change, const double* after,
                           const double* rate, const double* rate_change, int dimension, TurnBy by,
                           double* out) {
    const Vec3<double> r_x = vector_at(before, dimension), end = vector_at(after, dimension);
    const Vec3<double> t = r_x / length(r_x), to = end / length(end);
    const Vec3<double> spin = cross(t, vector_at(change, dimension) / length(r_x));
    const Vec3<double> from = turned_by(spin, t, by);
    const double cosine = dot(from, to);
    if (!(cosine > -0.9)) return;  // where that rotation is not unique
    const Vec3<double> axis = cross(from, to), old = vector_at(rate, dimension);
    const Vec3<double> v =
        turned_by(spin, old + vector_at(rate_change, dimension) - cross(spin, old), by);
    const Vec3<double> turned = cosine * v + cross(axis, v) + dot(axis, v) / (1.0 + cosine) * axis;
    std::copy_n(turned.v, dimension, out);
}

/// Writes the second derivative of rho . exp(W) (G + dG - W G) by dG, of which (i, k) is component
/// i of slope k. With M = sum_k rho_k G_k^T the entry of a = (i, k) and b = (j, l) is
///
///     (rho_l x w_a)_j + (rho_k x w_b)_i + w_a . (tr M I - (M + M^T)/2) w_b.
///
/// @param curvature  9 x 9, as many rows and columns as there are components
/// @return false where there is no spin
[[nodiscard]] ANCF_INLINE bool frame_curvature(const double* slopes, const Vec3<double> (&rho)[3],
                                               int count, int dimension, double* curvature) {
    NodeSpin spin;
    if (!spin_of(slopes, count, dimension, spin)) return false;
    std::array<Vec3<double>, 3> of_spins = {};  // the symmetric matrix, by rows
    for (int k = 0; k < count; ++k) {
        const Vec3<double> slope = vector_at(slopes + dimension * k, dimension);
        const double trace = dot(rho[k], slope);
        for (int i = 0; i < 3; ++i) {
            of_spins[i][i] += trace;
            add(of_spins[i], -0.5 * rho[k][i], slope);
            add(of_spins[i], -0.5 * slope[i], rho[k]);
        }
    }
    const int size = count * dimension;
    for (int b = 0; b < size; ++b) {
        Vec3<double> turned = {};
        for (int i = 0; i < 3; ++i) turned[i] = dot(of_spins[i], spin[b]);
        for (int a = 0; a < size; ++a)
            curvature[9 * a + b] = dot(spin[a], turned) +
                                   cross(rho[b / dimension], spin[a])[b % dimension] +
                                   cross(rho[a / dimension], spin[b])[a % dimension];
    }
    return true;
}

/// Writes the second derivative of force . v by v, 3 x 3, v a vector that turns: with the unit
/// vector u along v of length L, its change a along and b across it, v changes by
/// (a b - b.b u/2)/L to second order.
ANCF_INLINE void vector_curvature(const Vec3<double>& v, const Vec3<double>& force,
                                  double* curvature) {
    const double length = detail::length(v);
    const Vec3<double> unit = v / length;
    const double tension = dot(force, unit);
    for (int k = 0; k < 3; ++k)
        for (int m = 0; m < 3; ++m)
            curvature[3 * k + m] = (unit[k] * force[m] + force[k] * unit[m] -
                                    tension * ((k == m ? 1.0 : 0.0) + unit[k] * unit[m])) /
                                   length;
}

/// Adds a block to the values of a matrix, where its pattern has entries.
/// @param down,along  between the entries of a column and of a row of the block
/// @param row,column  their equations
ANCF_INLINE void add_block(const double* block, int down, int along, const int* row, int rows,
                           const int* column, int columns, const SparseMatrix& pattern,
                           double* values) {
    const int* const inner = pattern.innerIndexPtr();
    for (int j = 0; j < columns; ++j) {
        const int* const last = inner + pattern.outerIndexPtr()[column[j] + 1];
        const int* at = inner + pattern.outerIndexPtr()[column[j]];
        for (int i = 0; i < rows; ++i) {
            // what follows in the block mostly follows in the column
            if (at == last || *at != row[i])
                at = std::lower_bound(inner + pattern.outerIndexPtr()[column[j]], last, row[i]);
            if (at != last && *at == row[i]) values[at++ - inner] += block[down * i + along * j];
        }
    }
}

}  // namespace detail

ANCF_INLINE Turning::Turning(const Scene& model, const Numbering& numbering)
    : layout_(model.layout()), numbering_(numbering), dimension_(model.dimension()) {
    // an attached end moves with its joint
    const auto moving = [&](NodeId node) {
        const int first = layout_.index({node, Field::r});
        return first < 0 ? -1 : layout_.node_of(numbering.dependence().parts(first).front().first);
    };
    for (const auto& group : model.groups()) {
        if (!group->fields().contains(Field::r)) continue;
        for (const Connection& c : group->connections)
            chords_.push_back({moving(c.first), moving(c.second)});
    }
}

ANCF_INLINE Turning::Slopes Turning::slopes(int node) const {
    const int first =
        layout_.first(node) + (layout_.fields(node).contains(Field::r) ? dimension_ : 0);
    int last = layout_.first(node + 1);
    for (const Field rate : slope_rates)
        if (const int at = layout_.index({{node}, rate}); at >= 0) last = at;
    const int count = (last - first) / dimension_;
    bool whole = count == dimension_ || (count == 2 && dimension_ == 3);
    for (int slope = 0; slope < count; ++slope)
        whole = whole && is_free(first + slope * dimension_);
    return {first, count, whole};
}

ANCF_INLINE void Turning::twist(const VectorX& before, const VectorX& change, VectorX& q) const {
    if (dimension_ < 3) return;
    for (int node = 0; node < layout_.nodes(); ++node)
        if (const Slopes at = slopes(node); at.whole)
            detail::turn_frame(before.data() + at.first, change.data() + at.first, at.count,
                               dimension_, true, TurnBy::angle, q.data() + at.first);
    numbering_.dependence().complete(q);
}

ANCF_INLINE double Turning::largest_angle(const VectorX& before, const VectorX& change) const {
    double largest = 0.0;
    for (int node = 0; node < layout_.nodes(); ++node) {
        const Slopes at = slopes(node);
        for (int slope = 0; slope < at.count; ++slope) {
            const int k = at.first + slope * dimension_;
            const auto v = detail::vector_at(before.data() + k, dimension_);
            const auto d = detail::vector_at(change.data() + k, dimension_);
            const double square = dot(v, v);
            if (!(square > 0.0)) continue;
            largest = std::max(largest, length(d - dot(v, d) / square * v) / std::sqrt(square));
        }
    }
    return largest;
}

ANCF_INLINE void Turning::add_curvature(const VectorX& q, const VectorX& residual,
                                        const SparseMatrix& pattern, double* values, bool chords) {
    for (int node = 0; node < layout_.nodes(); ++node) {
        const Slopes at = slopes(node);
        for (const Field field : slope_rates)
            if (const int rate = layout_.index({{node}, field}); rate >= 0)
                add_curvature_of_rate(rate, at, q, residual, pattern, values);
        if (!at.whole) {
            for (int slope = 0; slope < at.count; ++slope)
                add_curvature_of_slope(at.first + slope * dimension_, q, residual, pattern, values);
            continue;
        }
        const int size = dimension_ * at.count;
        int equations[9];
        double curvature[81];
        detail::Vec3<double> rho[3] = {};
        for (int k = 0; k < size; ++k) {
            equations[k] = numbering_.equation(at.first + k);
            rho[k / dimension_][k % dimension_] = residual[equations[k]];
        }
        if (detail::frame_curvature(q.data() + at.first, rho, at.count, dimension_, curvature))
            detail::add_block(curvature, 9, 1, equations, size, equations, size, pattern, values);
    }
    if (!chords) return;
    factorize();
    const List<double> forces = chord_forces(residual);
    for (std::size_t c = 0; c < chords_.size(); ++c)
        add_curvature_of_chord(chords_[c], &forces[3 * c], q, pattern, values);
}

/// Adds the second derivative of residual . slope of a slope that turns alone.
/// @param first  its first coordinate
ANCF_INLINE void Turning::add_curvature_of_slope(int first, const VectorX& q,
                                                 const VectorX& residual,
                                                 const SparseMatrix& pattern,
                                                 double* values) const {
    const detail::Vec3<double> slope = detail::vector_at(q.data() + first, dimension_);
    if (!(length(slope) > 0.0)) return;
    detail::Vec3<double> force = {};
    int equations[3], axis[3], free = 0;
    for (int k = 0; k < dimension_; ++k)
        if (const int equation = numbering_.equation(first + k); equation >= 0) {
            force[k] = residual[equation];
            axis[free] = k;
            equations[free++] = equation;
        }
    double whole[9], block[9];
    detail::vector_curvature(slope, force, whole);
    for (int i = 0; i < free; ++i)
        for (int j = 0; j < free; ++j) block[3 * i + j] = whole[3 * axis[i] + axis[j]];
    detail::add_block(block, 3, 1, equations, free, equations, free, pattern, values);
}

/// Adds the second derivative of f . rate of the rate of a slope, which turn_rate() turns.
///
/// With t = r_x/L, L = |r_x|, dr_x = a t + L b, w = t x b and the spin s of the section, rho + drho
/// becomes to second order
///
///     rho + drho + w x drho - w x (w x rho)/2 + (t x u) x rho,
///     u = a/L (s x t - b) + s.t t x b - s.t t x (s x t)/2,
///
/// u what the turned r_x has across t besides b.
ANCF_INLINE void Turning::add_curvature_of_rate(int rate, const Slopes& at, const VectorX& q,
                                                const VectorX& residual,
                                                const SparseMatrix& pattern, double* values) const {
    using Vector = detail::Vec3<double>;
    if (!is_free(rate) || !is_free(at.first)) return;
    const Vector r_x = detail::vector_at(q.data() + at.first, dimension_);
    const double length = detail::length(r_x);
    if (!(length > 0.0)) return;
    const int slopes = dimension_ * (at.whole ? at.count : 1), size = slopes + dimension_;
    const Vector t = r_x / length, rho = detail::vector_at(q.data() + rate, dimension_);
    detail::NodeSpin of_section = {};
    if (at.whole && !detail::spin_of(q.data() + at.first, at.count, dimension_, of_section)) return;
    int equations[12];
    Vector force = {}, w[12] = {}, s[12] = {};
    double stretch[12] = {};
    for (int k = 0; k < slopes; ++k) {
        equations[k] = numbering_.equation(at.first + k);
        if (k < dimension_) {
            Vector axis = {};
            axis[k] = 1.0;
            w[k] = cross(t, axis) / length;
            stretch[k] = t[k] / length;
        }
        s[k] = at.whole ? of_section[k] : w[k];
    }
    for (int k = 0; k < dimension_; ++k) {
        equations[slopes + k] = numbering_.equation(rate + k);
        force[k] = residual[equations[slopes + k]];
    }
    const Vector of_tangent = cross(cross(rho, force), t);  // f . ((t x u) x rho) = of_tangent . u
    double half[12 * 12], curvature[12 * 12];
    for (int a = 0; a < size; ++a)
        for (int b = 0; b < size; ++b) {
            const Vector across = cross(s[b], t);
            Vector u = stretch[a] * (across - cross(w[b], t));
            add(u, dot(s[b], t), cross(t, cross(w[a], t)));
            add(u, -0.5 * dot(s[a], t), cross(t, across));
            half[12 * a + b] = dot(of_tangent, u) + 0.5 * dot(force, rho) * dot(w[a], w[b]) -
                               0.5 * dot(force, w[a]) * dot(rho, w[b]);
            if (b >= slopes) half[12 * a + b] += cross(force, w[a])[b - slopes];
        }
    for (int a = 0; a < size; ++a)
        for (int b = 0; b < size; ++b) curvature[12 * a + b] = half[12 * a + b] + half[12 * b + a];
    detail::add_block(curvature, 12, 1, equations, size, equations, size, pattern, values);
}

/// Adds the second derivative of force . chord by the positions and slopes of its two nodes. With
/// the nodes' mean twist t, the chord of unit vector u that changes by b across it changes by
/// t u x b/2 besides what vector_curvature() has.
ANCF_INLINE void Turning::add_curvature_of_chord(const std::array<int, 2>& chord,
                                                 const double* forces, const VectorX& q,
                                                 const SparseMatrix& pattern,
                                                 double* values) const {
    const detail::Vec3<double> line = vector_of(chord, q), force = detail::vector_at(forces, 3);
    const double length = detail::length(line);
    if (!(length > 0.0)) return;
    const detail::Vec3<double> unit = line / length;
    const detail::Vec3<double> turn = cross(force, unit);  // force . (u x b) = turn . b
    double bend[9];
    detail::vector_curvature(line, force, bend);

    int position[6], axis[6], positions = 0;
    double sign[6];
    int slope[18], slope_count = 0;
    double twist[18];
    for (const int node : chord) {
        for (int k = 0; k < dimension_; ++k) {
            position[positions] = numbering_.equation(layout_.first(node) + k);
            if (position[positions] < 0) continue;
            axis[positions] = k;
            sign[positions++] = node == chord[0] ? -1.0 : 1.0;
        }
        if (dimension_ < 3) continue;
        const Slopes at = slopes(node);
        detail::NodeSpin spin;
        if (at.count < 2 || !detail::spin_of(q.data() + at.first, at.count, 3, spin)) continue;
        for (int k = 0; k < 3 * at.count; ++k) {
            slope[slope_count] = numbering_.equation(at.first + k);
            if (slope[slope_count] >= 0) twist[slope_count++] = 0.5 * dot(unit, spin[k]);
        }
    }
    double of_positions[6 * 6], of_both[6 * 18];
    for (int i = 0; i < positions; ++i) {
        for (int j = 0; j < positions; ++j)
            of_positions[6 * i + j] = sign[i] * sign[j] * bend[3 * axis[i] + axis[j]];
        for (int j = 0; j < slope_count; ++j)
            of_both[18 * i + j] = 0.5 * sign[i] * turn[axis[i]] * twist[j];
    }
    const auto add = [&](const double* block, int down, int along, const int* row, int rows,
                         const int* column, int columns) {
        detail::add_block(block, down, along, row, rows, column, columns, pattern, values);
    };
    add(of_positions, 6, 1, position, positions, position, positions);
    add(of_both, 18, 1, position, positions, slope, slope_count);
    add(of_both, 1, 18, slope, slope_count, position, positions);
}

/// Returns the forces of the chords whose resultants at the nodes are the residual of positions, in
/// the least squares that turn() has.
ANCF_INLINE List<double> Turning::chord_forces(const VectorX& residual) const {
    List<double> forces(3 * chords_.size());
    for (int component = 0; component < dimension_; ++component) {
        const Component& of = components_[component];
        VectorX pull = VectorX::Zero(of.count);
        const auto at = [&](int node) {
            const int i = of.unknown[node];
            return i >= 0 ? pull[i] : 0.0;
        };
        for (int node = 0; node < layout_.nodes(); ++node)
            if (const int i = of.unknown[node]; i >= 0)
                pull[i] = residual[numbering_.equation(layout_.first(node) + component)];
        if (of.count > 0) of.factors.solve(pull);
        for (std::size_t c = 0; c < chords_.size(); ++c)
            forces[3 * c + component] = at(chords_[c][1]) - at(chords_[c][0]);
    }
    return forces;
}

/// Factorises the graph of chords: sum over chords of (x_j - x_i - wanted)^2, and a little of the
/// distance from the linear sum, for parts that nothing holds.
ANCF_INLINE void Turning::factorize(int component) {
    constexpr double tether = 1e-9;  // beside chords of weight 1
    Component& of = components_[component];
    of.unknown.assign(static_cast<std::size_t>(layout_.nodes()), -1);
    List<detail::MatrixEntry> entries;
    List<int> blocks;
    for (int node = 0; node < layout_.nodes(); ++node)
        if (layout_.fields(node).contains(Field::r) &&
            numbering_.equation(layout_.first(node) + component) >= 0) {
            entries.push_back({of.count, of.count, tether});
            blocks.push_back(of.count);
            of.unknown[node] = of.count++;
        }
    for (const auto& chord : chords_) {
        const int i = of.unknown[chord[0]];
        const int j = of.unknown[chord[1]];
        for (const int k : {i, j})
            if (k >= 0) entries.push_back({k, k, 1.0});
        if (i >= 0 && j >= 0) entries.push_back({std::max(i, j), std::min(i, j), -1.0});
    }
    // positive definite by its tethers
    static_cast<void>(of.factors.factorize(detail::compressed(of.count, entries), blocks));
}

ANCF_INLINE void Turning::turn(const VectorX& before, const VectorX& change, VectorX& q,
                               TurnBy by) {
    for (int node = 0; node < layout_.nodes(); ++node) {
        const Slopes at = slopes(node);
        if (at.whole)
            detail::turn_frame(before.data() + at.first, change.data() + at.first, at.count,
                               dimension_, false, by, q.data() + at.first);
        else
            for (int k = at.first; k < at.first + at.count * dimension_; k += dimension_) {
                const auto slope =
                    detail::turned(detail::vector_at(before.data() + k, dimension_),
                                   detail::vector_at(change.data() + k, dimension_), 0.0, by);
                for (int i = 0; i < dimension_; ++i)  // what is held or driven is where it must be
                    if (numbering_.equation(k + i) >= 0) q[k + i] = slope[i];
            }
        for (const Field rate : slope_rates)
            if (const int k = layout_.index({{node}, rate}); k >= 0 && is_free(k))
                detail::turn_rate(before.data() + at.first, change.data() + at.first,
                                  q.data() + at.first, before.data() + k, change.data() + k,
                                  dimension_, by, q.data() + k);
    }
    factorize();
    // wanted: how far each chord ends from where the linear sum ends it
    List<double> wanted;
    wanted.reserve(chords_.size() * dimension_);
    for (const auto& chord : chords_) {
        const int i = layout_.first(chord[0]), j = layout_.first(chord[1]);
        const auto moved = detail::turned(vector_of(chord, before), vector_of(chord, change),
                                          twist(chord, before, change), by);
        for (int k = 0; k < dimension_; ++k) wanted.push_back(moved[k] - q[j + k] + q[i + k]);
    }
    for (int k = 0; k < dimension_; ++k) shift(k, wanted, q);
    numbering_.dependence().complete(q);
}

/// Returns the vector along a chord, or its change.
ANCF_INLINE detail::Vec3<double> Turning::vector_of(const std::array<int, 2>& chord,
                                                    const VectorX& x) const {
    const auto at = [&](int node) {
        return detail::vector_at(x.data() + layout_.first(node), dimension_);
    };
    return at(chord[1]) - at(chord[0]);
}

/// Returns the mean angle by which the nodes of a chord turn about it, to first order.
ANCF_INLINE double Turning::twist(const std::array<int, 2>& chord, const VectorX& before,
                                  const VectorX& change) const {
    if (dimension_ < 3) return 0.0;
    const detail::Vec3<double> line = vector_of(chord, before);
    const double length = detail::length(line);
    if (!(length > 0.0)) return 0.0;
    const detail::Vec3<double> unit = line / length;
    double mean = 0.0;
    for (const int node : chord) {
        const Slopes at = slopes(node);
        detail::NodeSpin spin;
        if (at.count < 2 || !detail::spin_of(before.data() + at.first, at.count, 3, spin)) continue;
        for (int k = 0; k < 3 * at.count; ++k)
            mean += 0.5 * dot(unit, spin[k]) * change[at.first + k];
    }
    return mean;
}

/// Moves a component of the positions towards what the chords want.
ANCF_INLINE void Turning::shift(int component, const List<double>& wanted, VectorX& q) {
    const Component& of = components_[component];
    if (of.count == 0) return;
    VectorX pull = VectorX::Zero(of.count);
    for (std::size_t c = 0; c < chords_.size(); ++c) {
        const int i = of.unknown[chords_[c][0]];
        const int j = of.unknown[chords_[c][1]];
        const double by = wanted[c * dimension_ + component];
        if (i >= 0) pull[i] -= by;
        if (j >= 0) pull[j] += by;
    }
    of.factors.solve(pull);
    for (int node = 0; node < layout_.nodes(); ++node)
        if (const int i = of.unknown[node]; i >= 0) q[layout_.first(node) + component] += pull[i];
}

}  // namespace ancf
