// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/assembly.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/solver/convergence.hpp>
#include <ancf/solver/dense_lu.hpp>
#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/sparse_ldlt.hpp>
#include <ancf/solver/stability.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace ancf {

namespace detail {

ANCF_INLINE VectorX stiffest_of_unit(const Assembly& assembly, const VectorX& diagonal) {
    const Numbering& numbering = assembly.numbering();
    const Layout& layout = assembly.model().layout();
    const double size = ConvergenceMonitor(assembly.model(), numbering).size();
    double largest[3] = {}, most = 0.0;  // of r_xx, slopes, positions; of a turn by 1 rad, J
    VectorX stiffest(diagonal.size());
    for (const bool known : {false, true})
        for (int k = 0; k < numbering.coordinates(); ++k) {
            const int equation = numbering.equation(k);
            if (equation < 0) continue;
            const int power = length_power(layout.field_of(k));
            const double square = std::pow(size, 2 * power);
            double& own = largest[1 + power];
            if (known) {
                stiffest[equation] = own > 0.0 ? own : most / square;
                continue;
            }
            own = std::max(own, std::abs(diagonal[equation]));
            most = std::max(most, std::abs(diagonal[equation]) * square);
        }
    return stiffest;
}

ANCF_INLINE bool add_springs(const SparseMatrix& tangent, double stiffness, const VectorX& held,
                             const VectorX& otherwise, VectorX& diagonal,
                             List<MatrixEntry>& entries) {
    const int* const row = tangent.innerIndexPtr();
    const double* const g = tangent.valuePtr();
    const auto counts = [&](int k) { return row[k] < held.size() && g[k] != 0.0; };
    for (auto column = static_cast<int>(held.size()); column < tangent.cols(); ++column) {
        const int first = tangent.outerIndexPtr()[column];
        const int last = tangent.outerIndexPtr()[column + 1];
        const auto flexibility = [&](const VectorX& measure) {
            double sum = 0.0;
            for (int k = first; k < last; ++k)
                if (counts(k) && measure[row[k]] > 0.0) sum += g[k] * g[k] / measure[row[k]];
            return sum;
        };
        double flexible = flexibility(held);
        if (!(flexible > 0.0)) flexible = flexibility(otherwise);
        if (!(flexible > 0.0)) return false;
        const double spring = stiffness / flexible;
        for (int a = first; a < last; ++a)
            for (int b = first; counts(a) && b <= a; ++b) {
                if (!counts(b)) continue;
                const double value = spring * g[a] * g[b];
                entries.push_back({row[a], row[b], value});
                if (a == b) diagonal[row[a]] += value;
            }
    }
    return true;
}

/// Tells whether the energy of the softest displacement, of either sign, is more than round-off and
/// what the residual makes of it: that of a turn by an angle a is a^2 times the residual's moment.
/// @param lower     half of the stiffness, with its diagonal and its factors; rows of constraints
///                  may follow
/// @param residual  of the state
/// @param lever     what a turn by 1 rad makes of each displacement at most
ANCF_INLINE bool resists(const SparseMatrix& lower, const VectorX& diagonal,
                         const SparseLdlt& factor, const VectorX& residual, const VectorX& lever) {
    constexpr int inverse_iterations = 3;
    const auto size = static_cast<int>(diagonal.size());
    VectorX x = unit_scales(lower);
    for (int k = 0; k < size; ++k) x[k] *= probe_weight(k);
    for (int sweep = 0; sweep < inverse_iterations; ++sweep) {
        for (int k = 0; k < size; ++k) x[k] *= std::abs(diagonal[k]);
        for (int k = size; k < x.size(); ++k) x[k] = 0.0;
        factor.solve(x);
        double square = 0.0;
        for (int k = 0; k < size; ++k) square += x[k] * x[k] * std::abs(diagonal[k]);
        for (int k = 0; k < size; ++k) x[k] /= std::sqrt(square);
    }
    double energy = 0.0, terms = 0.0;
    for (int j = 0; j < size; ++j)
        for (int k = lower.outerIndexPtr()[j]; k < lower.outerIndexPtr()[j + 1]; ++k) {
            const int i = lower.innerIndexPtr()[k];
            if (i >= size) continue;
            const double term = (i == j ? 1.0 : 2.0) * x[i] * lower.valuePtr()[k] * x[j];
            energy += term;
            terms += std::abs(term);
        }
    double angle = 0.0, moment = 0.0;
    for (int k = 0; k < size; ++k) {
        angle = std::max(angle, std::abs(x[k]) / lever[k]);
        moment += std::abs(residual[k]) * lever[k];
    }
    return std::abs(energy) >
           16.0 * std::numeric_limits<double>::epsilon() * terms + angle * angle * moment;
}

/// Counts the negative directions of a stiffness by the pivots of L D L^T. Constraints are springs
/// or, exactly, rows behind what they hold. Each row has a negative pivot that does not count.
/// @param tangent          of which that is the stiffness
/// @param held, otherwise  as in add_springs()
/// @param diagonal         of the stiffness
/// @param entries          of its lower half; none where the tangent stores that
/// @return                 unknown also where a row is not independent of the others
[[nodiscard]] ANCF_INLINE NegativeDirections
negative_pivots(const Assembly& assembly, const SparseMatrix& tangent, const VectorX& held,
                const VectorX& otherwise, bool exact, VectorX diagonal, List<MatrixEntry> entries) {
    constexpr double round_off = 1e-14;      // of a pivot, to the diagonal it comes from
    constexpr double dependent = 1e-9;       // of a row's pivot, likewise
    const double stiff = exact ? 1.0 : 1e4;  // of a spring, to what it holds
    const auto free = static_cast<int>(diagonal.size());
    const int rows = exact ? static_cast<int>(tangent.cols()) : free;
    const bool stored = assembly.pattern().storage() == Storage::lower;  // and no constraints
    if (!add_springs(tangent, stiff, held, otherwise, diagonal, entries)) return {};
    VectorX sizes = VectorX::Zero(rows);
    for (int column = 0; column < free; ++column) {
        sizes[column] = round_off * std::abs(diagonal[column]);
        for (int k = tangent.outerIndexPtr()[column];
             exact && k < tangent.outerIndexPtr()[column + 1]; ++k) {
            const int row = tangent.innerIndexPtr()[k];
            const double value = tangent.valuePtr()[k];
            if (row < free || value == 0.0) continue;
            entries.push_back({row, column, value});
            sizes[row] += dependent * value * value / std::abs(diagonal[column]);
        }
    }
    const SparseMatrix made = stored ? SparseMatrix() : compressed(rows, entries);
    const SparseMatrix& lower = stored ? tangent : made;
    SparseLdlt factor;
    if (!factor.factorize(lower, blocks_of(assembly.numbering(), rows), rows - free, false))
        return {};
    NegativeDirections found{free - rows, true};
    for (int k = 0; k < rows; ++k) {
        const bool small = !(std::abs(factor.pivot(k)) > sizes[k]);
        if (small && k >= free) return {};
        found.count += factor.pivot(k) < 0.0 ? 1 : 0;
        found.certain = found.certain && !small;
    }
    VectorX residual;
    assembly.residual(residual);
    // what a turn by 1 rad makes of each free coordinate at most
    const double size = ConvergenceMonitor(assembly.model(), assembly.numbering()).size();
    const VectorX lever = length_powers(size, assembly.model().layout(), assembly.numbering());
    found.certain = found.certain && resists(lower, diagonal, factor, residual, lever);
    found.count = std::max(found.count, 0);
    return found;
}

ANCF_INLINE NegativeDirections negative_directions(const Assembly& assembly,
                                                   const SparseMatrix& tangent, bool symmetric) {
    const int free = assembly.numbering().free_coordinates();
    const bool stored = assembly.pattern().storage() == Storage::lower;
    VectorX diagonal = VectorX::Zero(free);
    List<MatrixEntry> entries;
    if (!stored) entries.reserve(static_cast<std::size_t>(detail::entries(tangent)));
    for (int column = 0; column < free; ++column)
        for (int k = tangent.outerIndexPtr()[column]; k < tangent.outerIndexPtr()[column + 1];
             ++k) {
            const int row = tangent.innerIndexPtr()[k];
            const double own = tangent.valuePtr()[k];
            if (!std::isfinite(own)) return {};
            if (row < column || row >= free) continue;
            const double value = symmetric ? own : 0.5 * (own + tangent.coeff(column, row));
            if (!stored) entries.push_back({row, column, value});
            if (row == column) diagonal[column] = value;
        }
    if (free == 0) return {0, true};
    const VectorX stiffest = stiffest_of_unit(assembly, diagonal);
    const auto found =
        negative_pivots(assembly, tangent, diagonal, stiffest, false, diagonal, entries);
    if ((found.certain && found.count == 0) || assembly.numbering().multipliers() == 0)
        return found;
    // springs may be too soft, and of what has next to no stiffness itself, such as a body between
    // two welds, they are
    const auto exact =
        negative_pivots(assembly, tangent, stiffest, stiffest, true, diagonal, entries);
    return exact.count < 0 ? found : exact;
}

ANCF_INLINE NegativeDirections negative_directions(const Assembly& assembly,
                                                   const SparseMatrix& tangent,
                                                   const FactorReport& factor,
                                                   const LinearSolver& solver) {
    if (factor.negative_pivots >= 0)
        return {std::max(factor.negative_pivots - assembly.numbering().multipliers(), 0), true};
    if (solver.iterative()) return {};
    return negative_directions(assembly, tangent, assembly.model().has_symmetric_loads());
}

/// Random pendulums had at most 1.7 times the round-off of a number. Clamped beams with less than
/// four times it were more than 10^5 times as long as thick.
ANCF_INLINE bool moves_freely(const Assembly& assembly, const LinearSolver& solver) {
    constexpr int inverse_iterations = 3;
    constexpr double round_off = 4.0 * std::numeric_limits<double>::epsilon();
    const Numbering& numbering = assembly.numbering();
    const SparseMatrix& tangent = assembly.tangent();
    const int components = assembly.model().dimension();
    VectorX diagonal(numbering.free_coordinates());
    for (int k = 0; k < diagonal.size(); ++k) diagonal[k] = std::abs(tangent.coeff(k, k));
    const VectorX otherwise = stiffest_of_unit(assembly, diagonal);
    // of each vector what its stiffest component has; of a body what the stiffest of its unit has
    VectorX stiffness = VectorX::Zero(tangent.cols());
    for (int first = 0; first < numbering.coordinates(); first += components) {
        double most = 0.0;
        for (const bool known : {false, true})
            for (int k = first; k < first + components; ++k) {
                const int equation = numbering.equation(k);
                if (equation < 0) continue;
                most = std::max(most, diagonal[equation]);
                if (known) stiffness[equation] = most > 0.0 ? most : otherwise[equation];
            }
    }
    VectorX x = unit_scales(tangent), load = x;
    for (Eigen::Index k = 0; k < x.size(); ++k) x[k] *= probe_weight(k);
    for (int sweep = 0; sweep < inverse_iterations; ++sweep) {
        for (Eigen::Index k = 0; k < x.size(); ++k) load[k] = stiffness[k] * x[k];
        solve_with(solver, load, x);
        x.tail(numbering.multipliers()).setZero();
        double apart = 0.0;
        for (Eigen::Index k = 0; k < x.size(); ++k) apart += stiffness[k] * x[k] * x[k];
        if (!(apart > 0.0)) return false;
        for (double& entry : x) entry /= std::sqrt(apart);
    }
    const VectorX force = multiply(tangent, assembly.pattern().storage(), x);
    double energy = 0.0;
    for (Eigen::Index k = 0; k < x.size(); ++k) energy += x[k] * force[k];
    return std::abs(energy) <= round_off;
}

/// Sums r r^T of each part, r what a rigid motion makes of a held coordinate: its three parameters
/// are two displacements, over the scene's size, and an angle.
ANCF_INLINE bool supports_hold(const Assembly& assembly) {
    constexpr double least = 1e-9;  // of the determinant of the sum: 1 and more of a clamp
    const Scene& model = assembly.model();
    const Layout& layout = model.layout();
    if (!model.attachments().empty() || layout.nodes() == 0) return false;
    List<int> above(static_cast<std::size_t>(layout.nodes()));  // a node of the same part, at last
    for (int node = 0; node < layout.nodes(); ++node) above[node] = node;
    const auto part = [&](int node) {
        while (above[node] != node) node = above[node] = above[above[node]];
        return node;
    };
    for (const auto& group : model.groups())
        for (const Connection& c : group->connections)
            above[part(c.first.index)] = part(c.second.index);

    const VectorX& q = model.state().q;
    const double size = ConvergenceMonitor(model, assembly.numbering()).size();
    List<std::array<Vec3<double>, 3>> sums(above.size());
    for (const int k : assembly.numbering().held()) {
        const Field field = layout.field_of(k);
        const int node = layout.node_of(k), axis = (k - layout.first(node)) % 2;
        const int other = axis == 0 ? k + 1 : k - 1;
        const bool is_position = field == Field::r;
        if (!is_position && field != Field::r_x && field != Field::r_y) continue;
        Vec3<double> r = {};
        if (is_position) r[axis] = 1.0;
        const double arm = is_position ? (q[other] - q[1 - axis]) / size : q[other];
        r[2] = axis == 0 ? -arm : arm;
        for (int row = 0; row < 3; ++row) add(sums[part(node)][row], r[row], r);
    }
    for (int k = 0; k < assembly.numbering().coordinates(); ++k) {
        if (assembly.numbering().equation(k) < 0) continue;  // a point that is held cannot turn
        const auto& sum = sums[part(layout.node_of(k))];
        if (!(dot(sum[0], cross(sum[1], sum[2])) > least)) return false;
    }
    return true;
}

/// Whether all eigenvalues of a small matrix have positive real parts: S = (S + S^-1)/2 then goes
/// from the matrix to the identity.
[[nodiscard]] ANCF_INLINE bool all_to_the_right(DenseLu<double>::Matrix matrix) {
    constexpr int sweeps = 40;  // a spread of 2^20 takes twenty and a few
    const Eigen::Index size = matrix.rows();
    double largest = 0.0, trace = 0.0;
    for (Eigen::Index k = 0; k < size * size; ++k)
        largest = std::max(largest, std::abs(matrix.data()[k]));
    for (Eigen::Index k = 0; k < size * size; ++k) matrix.data()[k] /= largest;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        DenseLu<double> lu{matrix, {}};
        if (!lu.factorize()) return false;
        const DenseLu<double>::Matrix inverse = lu.inverse();
        for (Eigen::Index k = 0; k < size * size; ++k)
            matrix.data()[k] = 0.5 * (matrix.data()[k] + inverse.data()[k]);
    }
    for (Eigen::Index k = 0; k < size; ++k) trace += matrix(k, k);
    return std::abs(trace - static_cast<double>(size)) < 0.5;
}

/// Inverse iteration with six vectors, and the projection of K^-1 D on what they span. The slowest
/// come first. Where the first four end within a pair of complex ones, the first five do not.
ANCF_INLINE bool softest_decay(const Assembly& assembly, const LinearSolver& solver) {
    constexpr int least = 4, most = 6, sweeps = 6;
    const int free = assembly.numbering().free_coordinates(), count = std::min(most, free);
    VectorX metric = VectorX::Zero(free), load = VectorX::Zero(assembly.numbering().unknowns());
    for (int k = 0; k < free; ++k) metric[k] = std::abs(assembly.tangent().coeff(k, k));
    const auto product = [&](const VectorX& a, const VectorX& b) {
        double sum = 0.0;
        for (int k = 0; k < free; ++k) sum += a[k] * metric[k] * b[k];
        return sum;
    };
    VectorX x[most], y[most];
    for (int i = 0; i < count; ++i) {
        y[i] = VectorX::Zero(free);
        for (int k = 0; k < free; ++k)
            y[i][k] = (probe_weight(most * k + i) - 1.0) / std::sqrt(metric[k]);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (int i = 0; i < count; ++i) {
            x[i].swap(y[i]);
            for (int j = 0; j < i; ++j) {
                const double part = product(x[j], x[i]);
                for (int k = 0; k < free; ++k) x[i][k] -= part * x[j][k];
            }
            const double length = std::sqrt(product(x[i], x[i]));
            for (int k = 0; k < free; ++k) {
                x[i][k] /= length;
                load[k] = metric[k] * x[i][k];
            }
            solve_with(solver, load, y[i]);
        }
    for (int size = std::min(least, count); size <= count; ++size) {
        DenseLu<double>::Matrix projected(size, size);
        for (int i = 0; i < size; ++i)
            for (int j = 0; j < size; ++j) projected(i, j) = product(x[i], y[j]);
        if (all_to_the_right(std::move(projected))) return true;
    }
    return false;
}

/// By power iteration. One product is enough where it leaves less of the probe than the share that
/// an eigenvector has of it.
ANCF_INLINE bool has_same_signs(const Assembly& assembly, const LinearSolver& solver) {
    constexpr int products = 3;
    constexpr double most = 0.25;  // of the largest eigenvalue
    const SparseMatrix& tangent = assembly.tangent();
    const VectorX scale = unit_scales(tangent);
    VectorX x = scale, next;
    for (Eigen::Index k = 0; k < x.size(); ++k) x[k] *= probe_weight(k);
    double before = 0.0, after = 0.0;
    for (int product = 0; product < products; ++product) {
        next = multiply(tangent, assembly.pattern().storage(), x);
        solve_with(solver, next, next);
        before = std::exchange(after, 0.0);
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            x[k] = next[k] - x[k];
            const double scaled = x[k] / scale[k];
            after += scaled * scaled;
        }
        if (product == 0 && after < most * most * probe_share * probe_share) return true;
    }
    return after < most * most * before;
}

}  // namespace detail

ANCF_INLINE Stability stability(const Assembly& assembly, const FactorReport& counted,
                                const LinearSolver* solver) {
    constexpr double well_conditioned = 1e-10;
    const bool symmetric = assembly.model().has_symmetric_loads();
    if (!symmetric || counted.negative_pivots < 0 || !(counted.rcond > well_conditioned) ||
        (solver != nullptr && !detail::has_same_signs(assembly, *solver))) {
        const auto negative = detail::negative_directions(assembly, assembly.tangent(), symmetric);
        if (!negative.certain) return Stability::unknown;
        if (negative.count == 0) return Stability::stable;
        return symmetric ? Stability::unstable : Stability::unknown;
    }
    return counted.negative_pivots > assembly.numbering().multipliers() ? Stability::unstable
                                                                        : Stability::stable;
}

}  // namespace ancf
