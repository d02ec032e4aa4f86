// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/solver/turning.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ancf {

namespace detail {

/// A frame of slopes in the plane or in space, by columns, and what acts on it.
struct SlopeFrame {
    int dimension;
    double entry[9] = {};

    [[nodiscard]] double& operator()(int i, int j) { return entry[j * dimension + i]; }
    [[nodiscard]] double operator()(int i, int j) const { return entry[j * dimension + i]; }
};

/// Returns the inner product of two vectors of 2, 3, 4 or 9 entries.
[[nodiscard]] ANCF_INLINE double inner(const double* a, const double* b, int size) noexcept {
    if (size <= 3) {
        const double sum = a[0] * b[0] + a[1] * b[1];
        return size == 3 ? sum + a[2] * b[2] : sum;
    }
    // pairs side by side, as a register of two takes them
    double pairs[2] = {a[0] * b[0] + a[2] * b[2], a[1] * b[1] + a[3] * b[3]};
    if (size == 9)
        for (int k = 0; k < 2; ++k) pairs[k] += a[4 + k] * b[4 + k] + a[6 + k] * b[6 + k];
    const double sum = pairs[0] + pairs[1];
    return size == 9 ? sum + a[8] * b[8] : sum;
}

/// Writes v + change with the part of the change across v as a turn.
/// @param twist  angle by which v turns about itself meanwhile: both are one rotation
ANCF_INLINE void turned(const double* v, const double* change, double twist, int dimension,
                        TurnBy by, double* out) {
    const double length = std::sqrt(inner(v, v, dimension));
    double unit[3] = {}, across[3] = {};
    for (int k = 0; k < dimension; ++k) {
        unit[k] = v[k] / length;
        out[k] = v[k] + change[k];
    }
    if (length == 0.0) return;
    const double along = inner(unit, change, dimension);
    for (int k = 0; k < dimension; ++k) across[k] = change[k] - along * unit[k];
    for (double& entry : across) entry /= length;
    const double bend = std::sqrt(inner(across, across, dimension));
    if (bend < 1e-12) return;
    // exp of the spin w = unit x across + twist unit, on the unit vector
    const double size = std::hypot(bend, twist);
    const double angle = by == TurnBy::angle ? size : std::atan(size);
    const double first = std::sin(angle) / size, second = (1.0 - std::cos(angle)) / (size * size);
    const double normal[3] = {unit[1] * across[2] - unit[2] * across[1],
                              unit[2] * across[0] - unit[0] * across[2],
                              unit[0] * across[1] - unit[1] * across[0]};
    for (int k = 0; k < dimension; ++k)
        out[k] = (length + along) * ((1.0 - second * bend * bend) * unit[k] + first * across[k] +
                                     second * twist * normal[k]);
}

[[nodiscard]] ANCF_NOINLINE ANCF_INLINE SlopeFrame product(const SlopeFrame& a,
                                                           const SlopeFrame& b) {
    SlopeFrame result{a.dimension};
    for (int j = 0; j < a.dimension; ++j)
        for (int k = 0; k < a.dimension; ++k)
            for (int i = 0; i < a.dimension; ++i) result(i, j) += a(i, k) * b(k, j);
    return result;
}

/// Returns exp(W), W skew.
[[nodiscard]] ANCF_INLINE SlopeFrame rotation(const SlopeFrame& skew) {
    const int dimension = skew.dimension;
    const double square = 0.5 * inner(skew.entry, skew.entry, dimension * dimension);
    const double angle = std::sqrt(square);
    const bool small = angle < 1e-4;  // where the series is exact to round-off
    const double first = small ? 1.0 - square / 6.0 : std::sin(angle) / angle;
    const double second = small ? 0.5 - square / 24.0 : (1.0 - std::cos(angle)) / square;
    SlopeFrame result = product(skew, skew);
    for (int j = 0; j < dimension; ++j)
        for (int i = 0; i < dimension; ++i)
            result(i, j) = (i == j ? 1.0 : 0.0) + first * skew(i, j) + second * result(i, j);
    return result;
}

/// Writes the inverse of a frame of unit size.
/// @return false where its determinant is below 1e-12.
[[nodiscard]] ANCF_INLINE bool invert(const SlopeFrame& a, SlopeFrame& inverse) {
    double determinant = 0.0;
    if (a.dimension == 2) {
        determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
        inverse(0, 0) = a(1, 1);
        inverse(0, 1) = -a(0, 1);
        inverse(1, 0) = -a(1, 0);
        inverse(1, 1) = a(0, 0);
    } else {
        for (int k = 0; k < 3; ++k) {  // row k is the vector product of the other two columns
            const int p = (k + 1) % 3, q = (k + 2) % 3;
            for (int j = 0; j < 3; ++j) {
                const int m = (j + 1) % 3, n = (j + 2) % 3;
                inverse(k, j) = a(m, p) * a(n, q) - a(n, p) * a(m, q);
            }
        }
        determinant = inverse(0, 0) * a(0, 0) + inverse(0, 1) * a(1, 0) + inverse(0, 2) * a(2, 0);
    }
    if (!(std::abs(determinant) > 1e-12)) return false;
    for (double& entry : inverse.entry) entry /= determinant;
    return true;
}

/// Keeps of a spin [w]x the part about the first column of a frame.
ANCF_INLINE void keep_tangent_part(const SlopeFrame& frame, SlopeFrame& skew) {
    const double* const t = frame.entry;
    const double spin[3] = {skew(2, 1), skew(0, 2), skew(1, 0)};
    const double part = inner(spin, t, 3) / inner(t, t, 3);
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        skew(k, k) = 0.0;
        skew(j, i) = part * t[k];
        skew(i, j) = -skew(j, i);
    }
}

/// Adds a x b to a third of a frame's columns: where a node has two slopes, r_x x r_y stands for
/// the third.
ANCF_INLINE void add_product(const double* a, const double* b, SlopeFrame& frame) {
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        frame(k, 2) += a[i] * b[j] - a[j] * b[i];
    }
}

/// Returns the frame of a node from its slopes, as many as the dimension or one less in space.
[[nodiscard]] ANCF_INLINE SlopeFrame frame_of(const double* slopes, int count, int dimension) {
    SlopeFrame G{dimension};
    std::copy_n(slopes, count * dimension, G.entry);
    if (count < dimension) add_product(slopes, slopes + 3, G);
    return G;
}

/// Returns the change of that frame, to first order.
[[nodiscard]] ANCF_INLINE SlopeFrame change_of_frame(const double* slopes, const double* change,
                                                     int count, int dimension) {
    SlopeFrame dG{dimension};
    std::copy_n(change, count * dimension, dG.entry);
    if (count < dimension) {
        add_product(change, slopes + 3, dG);
        add_product(slopes, change + 3, dG);
    }
    return dG;
}

/// Moves a derivative by dG to the slopes of a node, in place: adds what the third column of dG
/// has of the two others where a node has two slopes.
/// @param stride  between the entries
ANCF_INLINE void pull_back(const double* slopes, int count, int stride, double* derivative) {
    if (count == 3) return;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double of_i = derivative[(6 + i) * stride], of_j = derivative[(6 + j) * stride];
        derivative[k * stride] += slopes[3 + i] * of_j - slopes[3 + j] * of_i;
        derivative[(3 + k) * stride] += slopes[j] * of_i - slopes[i] * of_j;
    }
}

/// Writes the derivative of u . spin by the slopes of a node in space, 9 entries. The spin of a
/// frame G is the axial vector of the skew part of dG G^-1: half the sum of g_k x dG_k, g_k the
/// columns of G^-T.
/// @return false where the frame has no inverse
[[nodiscard]] ANCF_INLINE bool spin_about(const double* unit, const double* slopes, int count,
                                          double* derivative) {
    SlopeFrame inverse{3};
    if (!invert(frame_of(slopes, count, 3), inverse)) return false;
    for (int k = 0; k < 9; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        derivative[k] = 0.5 * (unit[i] * inverse(k / 3, j) - unit[j] * inverse(k / 3, i));
    }
    pull_back(slopes, count, 1, derivative);
    return true;
}

/// Moves a node's frame G = [r_x r_y r_z] to exp(W) (I + D) G, W + D = dG G^-1, W skew.
/// @param tangent_only  W keeps the part about r_x
/// @param by            tangent: exp takes atan of the angle of W instead of the angle
ANCF_INLINE void turn_frame(const double* before, const double* change, int count, int dimension,
                            bool tangent_only, TurnBy by, double* after) {
    const SlopeFrame G = frame_of(before, count, dimension);
    const SlopeFrame dG = change_of_frame(before, change, count, dimension);
    SlopeFrame inverse{dimension}, skew{dimension};
    if (!invert(G, inverse)) return;
    SlopeFrame rate = product(dG, inverse);
    for (int j = 0; j < dimension; ++j)
        for (int i = 0; i < dimension; ++i) skew(i, j) = 0.5 * (rate(i, j) - rate(j, i));
    if (tangent_only) keep_tangent_part(G, skew);
    for (int j = 0; j < dimension; ++j)  // I + D
        for (int i = 0; i < dimension; ++i) rate(i, j) += (i == j ? 1.0 : 0.0) - skew(i, j);
    const double angle = std::sqrt(0.5 * inner(skew.entry, skew.entry, dimension * dimension));
    if (by == TurnBy::tangent && angle > 1e-8)
        for (double& entry : skew.entry) entry *= std::atan(angle) / angle;
    const SlopeFrame result = product(rotation(skew), product(rate, G));
    std::copy_n(result.entry, count * dimension, after);
}

/// Writes rate + change, the rate of a slope along the line, with what turns it as the tangent
/// turned: R (rate + change - w x rate), R the smallest rotation from t to the new tangent's
/// direction and w = t x dt its spin, t = r_x/|r_x|.
/// @param before,after  r_x
/// @param change        of r_x
ANCF_INLINE void turn_rate(const double* before, const double* change, const double* after,
                           const double* rate, const double* rate_change, int dimension,
                           double* out) {
    Vector<double, 3> t = Vector<double, 3>::Zero(), dt = t, to = t, v = t, dv = t;
    for (int k = 0; k < dimension; ++k) {
        t[k] = before[k];
        dt[k] = change[k];
        to[k] = after[k];
        v[k] = rate[k];
        dv[k] = rate_change[k];
    }
    const double length = t.norm();
    t /= length;
    to /= to.norm();
    dt /= length;
    const double cosine = t.dot(to);
    if (!(cosine > -0.9)) return;  // where that rotation is not unique
    const Vector<double, 3> spin = cross(t, dt), axis = cross(t, to);
    v += dv - cross(spin, v);
    const Vector<double, 3> turned =
        cosine * v + cross(axis, v) + axis.dot(v) / (1.0 + cosine) * axis;
    std::copy_n(turned.data(), dimension, out);
}

/// Writes the second derivative of rho . exp(W) (I + D) G by dG, 9 x 9. With the columns g_k of
/// G^-T and M = rho G^T, the entry of dG_ik and dG_jl is an eighth of
///
///     3 g_k[j] rho_l[i] + (g_k . g_l) M_ij - 3 [i = j] g_k . rho_l - g_l[i] (M^T g_k)[j],
///
/// plus the same with (i, k) and (j, l) exchanged.
/// @return false where the frame has no inverse
[[nodiscard]] ANCF_INLINE bool frame_curvature(const SlopeFrame& G, const SlopeFrame& rho,
                                               double* curvature) {
    SlopeFrame inverse{3}, M{3}, Mg{3}, gg{3}, gr{3};
    if (!invert(G, inverse)) return false;
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) {
                M(i, j) += rho(i, k) * G(j, k);
                gg(i, j) += inverse(i, k) * inverse(j, k);
                gr(i, j) += inverse(i, k) * rho(k, j);
            }
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) Mg(j, k) += M(i, j) * inverse(k, i);
    const auto half = [&](int a, int b) {
        const int i = a % 3, k = a / 3, j = b % 3, l = b / 3;
        return 0.125 * (3.0 * inverse(k, j) * rho(i, l) + gg(k, l) * M(i, j) -
                        (i == j ? 3.0 * gr(k, l) : 0.0) - inverse(l, i) * Mg(j, k));
    };
    for (int a = 0; a < 9; ++a)
        for (int b = 0; b < 9; ++b) curvature[9 * a + b] = half(a, b) + half(b, a);
    return true;
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
            const double* const v = before.data() + at.first + slope * dimension_;
            const double* const d = change.data() + at.first + slope * dimension_;
            const double square = detail::inner(v, v, dimension_);
            if (!(square > 0.0)) continue;
            const double along = detail::inner(v, d, dimension_) / square;
            double across[3] = {};
            for (int k = 0; k < dimension_; ++k) across[k] = d[k] - along * v[k];
            largest = std::max(
                largest, std::sqrt(detail::inner(across, across, dimension_)) / std::sqrt(square));
        }
    }
    return largest;
}

ANCF_INLINE void Turning::add_curvature(const VectorX& q, const VectorX& residual,
                                        const SparseMatrix& pattern, double* values, bool chords) {
    if (dimension_ < 3) return;
    for (int node = 0; node < layout_.nodes(); ++node) {
        const Slopes at = slopes(node);
        if (!at.whole) continue;
        const double* const slopes = q.data() + at.first;
        detail::SlopeFrame rho{3};
        int equations[9];
        double curvature[81];
        for (int k = 0; k < 3 * at.count; ++k) {
            equations[k] = numbering_.equation(at.first + k);
            rho.entry[k] = residual[equations[k]];
        }
        if (!detail::frame_curvature(detail::frame_of(slopes, at.count, 3), rho, curvature))
            continue;
        for (int k = 0; k < 9; ++k) detail::pull_back(slopes, at.count, 9, curvature + k);
        for (int k = 0; k < 9; ++k) detail::pull_back(slopes, at.count, 1, curvature + 9 * k);
        detail::add_block(curvature, 9, 1, equations, 3 * at.count, equations, 3 * at.count,
                          pattern, values);
    }
    if (!chords) return;
    factorize();
    const std::vector<double> forces = chord_forces(residual);
    for (std::size_t c = 0; c < chords_.size(); ++c)
        add_curvature_of_chord(chords_[c], &forces[3 * c], q, pattern, values);
}

/// Adds the second derivative of force . chord by the positions and slopes of its two nodes. With
/// the unit vector u along the chord of length L, its change a along and b across it, and the
/// nodes' mean twist t, the chord changes by (a b - b.b u/2)/L + t u x b/2 to second order. By the
/// difference of positions that is (u f^T + f u^T - (f.u) (I + u u^T))/L, f the force.
ANCF_INLINE void Turning::add_curvature_of_chord(const std::array<int, 2>& chord,
                                                 const double* force, const VectorX& q,
                                                 const SparseMatrix& pattern,
                                                 double* values) const {
    double unit[3], turn[3];
    for (int k = 0; k < 3; ++k)
        unit[k] = q[layout_.first(chord[1]) + k] - q[layout_.first(chord[0]) + k];
    const double length = std::sqrt(detail::inner(unit, unit, 3));
    if (!(length > 0.0)) return;
    for (double& entry : unit) entry /= length;
    for (int k = 0; k < 3; ++k) {  // force . (u x b) = turn . b
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        turn[k] = force[i] * unit[j] - force[j] * unit[i];
    }
    const double tension = detail::inner(force, unit, 3);

    double bend[9];
    for (int k = 0; k < 3; ++k)
        for (int m = 0; m < 3; ++m)
            bend[3 * k + m] = (unit[k] * force[m] + force[k] * unit[m] -
                               tension * ((k == m ? 1.0 : 0.0) + unit[k] * unit[m])) /
                              length;

    int position[6], axis[6], positions = 0;
    double sign[6];
    int slope[18], slope_count = 0;
    double twist[18];
    for (const int node : chord) {
        for (int k = 0; k < 3; ++k) {
            position[positions] = numbering_.equation(layout_.first(node) + k);
            if (position[positions] < 0) continue;
            axis[positions] = k;
            sign[positions++] = node == chord[0] ? -1.0 : 1.0;
        }
        const Slopes at = slopes(node);
        double spin[9];
        if (!at.whole || !detail::spin_about(unit, q.data() + at.first, at.count, spin)) continue;
        for (int k = 0; k < 3 * at.count; ++k) {
            slope[slope_count] = numbering_.equation(at.first + k);
            twist[slope_count++] = 0.5 * spin[k];
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
ANCF_INLINE std::vector<double> Turning::chord_forces(const VectorX& residual) const {
    std::vector<double> forces(3 * chords_.size());
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
    detail::Records<detail::MatrixEntry> entries;
    std::vector<int> blocks;
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
                double slope[3];
                detail::turned(before.data() + k, change.data() + k, 0.0, dimension_, by, slope);
                for (int i = 0; i < dimension_; ++i)  // what is held or driven is where it must be
                    if (numbering_.equation(k + i) >= 0) q[k + i] = slope[i];
            }
        for (const Field rate : slope_rates)
            if (const int k = layout_.index({{node}, rate}); k >= 0 && is_free(k))
                detail::turn_rate(before.data() + at.first, change.data() + at.first,
                                  q.data() + at.first, before.data() + k, change.data() + k,
                                  dimension_, q.data() + k);
    }
    factorize();
    // wanted: how far each chord ends from where the linear sum ends it
    std::vector<double> wanted;
    wanted.reserve(chords_.size() * dimension_);
    for (const auto& chord : chords_) {
        const int i = layout_.first(chord[0]), j = layout_.first(chord[1]);
        double old[3] = {}, step[3] = {}, moved[3];
        for (int k = 0; k < dimension_; ++k) {
            old[k] = before[j + k] - before[i + k];
            step[k] = change[j + k] - change[i + k];
        }
        detail::turned(old, step, twist(chord, before, change), dimension_, by, moved);
        for (int k = 0; k < dimension_; ++k) wanted.push_back(moved[k] - q[j + k] + q[i + k]);
    }
    for (int k = 0; k < dimension_; ++k) shift(k, wanted, q);
    numbering_.dependence().complete(q);
}

/// Returns the mean angle by which the nodes of a chord turn about it, to first order.
ANCF_INLINE double Turning::twist(const std::array<int, 2>& chord, const VectorX& before,
                                  const VectorX& change) const {
    if (dimension_ < 3) return 0.0;
    double unit[3], mean = 0.0;
    for (int k = 0; k < 3; ++k)
        unit[k] = before[layout_.first(chord[1]) + k] - before[layout_.first(chord[0]) + k];
    const double length = std::sqrt(detail::inner(unit, unit, 3));
    if (!(length > 0.0)) return 0.0;
    for (double& entry : unit) entry /= length;
    for (const int node : chord) {
        const Slopes at = slopes(node);
        double spin[9];
        if (at.count < 2 || !detail::spin_about(unit, before.data() + at.first, at.count, spin))
            continue;
        for (int k = 0; k < 3 * at.count; ++k) mean += 0.5 * spin[k] * change[at.first + k];
    }
    return mean;
}

/// Moves a component of the positions towards what the chords want.
ANCF_INLINE void Turning::shift(int component, const std::vector<double>& wanted, VectorX& q) {
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
