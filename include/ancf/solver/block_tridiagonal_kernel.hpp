// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The inner loops of the direct solver for chains: block LDL^T with blocks of a fixed width.
///
/// Block k of a chain has D_k on the diagonal and B_k below it. Elimination turns D_k into L_k d_k
/// L_k^T, B_k into the rows of L below, and carries -B_k D_k^-1 B_k^T into D_(k+1). A block with
/// fewer unknowns is filled up with unknowns of its own: 1 on the diagonal, 0 elsewhere.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/fixed_column.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace ancf::detail {

/// What the elimination saw of the pivots.
struct PivotSummary {
    int failed_column = -1;  ///< first column whose pivot is zero or not finite; -1 = none
    int negative = 0;
    double energy = 0.0;   ///< sum z_j^2 / |d_j| with z = L^-1 of the probe
    double weights = 0.0;  ///< w^T w of the probe
    bool complete = true;  ///< no entry of the diagonal was zero: the probe is probe_load's
};

/// The lower half of a sparse matrix as its three arrays, compressed columns.
template <class Scalar>
struct LowerColumns {
    const int* outer;
    const int* inner;
    const Scalar* values;
};

/// Block LDL^T of a symmetric block-tridiagonal matrix with blocks of at most N unknowns.
///
/// A panel is two squares of N columns: first the diagonal block, then the block below it. Of a
/// complex scalar the matrix is symmetric too, not Hermitian, and there is no probe.
template <int N, class Scalar = double>
class BlockKernel {
public:
    static constexpr int square_size = N * N;
    static constexpr int panel_size = 2 * square_size;  ///< scalars per block

    /// Factorises the lower half `matrix` into `panels`, panel_size doubles per block.
    ///
    /// The first square then holds L below its diagonal, L^T above it and 1/d on it; the second one
    /// holds L of the next block's rows. Stops at a pivot that is zero or not finite. Along the way
    /// `roots` and `probe`, as long as the matrix, receive the roots of the diagonal and L^-1 of
    /// the load that direct_solver.hpp makes of them: one pass over the matrix, not three.
    ///
    /// Never inlined: in a large caller the sums of a column may not stay in registers.
    ANCF_NOINLINE static PivotSummary factorize(const BlockLayout& layout,
                                                const LowerColumns<Scalar>& matrix, Scalar* panels,
                                                double* roots, double* probe) noexcept {
        Work work;
        for (Column& column : work.carry) column = Column::zero();
        Column rest = Column::zero();
        PivotSummary summary;
        for (int block = 0; block < layout.blocks(); ++block, panels += panel_size) {
            load(layout, matrix, block, panels);
            double* z = nullptr;
            if constexpr (probed) {
                z = probe + layout.start(block);
                load_probe(layout, block, panels, roots + layout.start(block), z, summary);
            }
            eliminate(panels, work);
            if constexpr (probed) forward(panels, layout.size(block), rest, z);
            const int failed = audit(panels, layout.size(block), z, summary);
            if (failed >= 0) {
                summary.failed_column = layout.start(block) + failed;
                return summary;
            }
            update(panels, work);
        }
        return summary;
    }

    /// Solves L D L^T x = x in place.
    static void solve(const BlockLayout& layout, const Scalar* panels, Scalar* x) noexcept {
        Column carry = Column::zero();
        for (int block = 0; block < layout.blocks(); ++block)
            forward(panels + static_cast<std::ptrdiff_t>(block) * panel_size, layout.size(block),
                    carry, x + layout.start(block));
        backward(layout, panels, x);
    }

private:
    static constexpr bool probed = std::is_same_v<Scalar, double>;

    using Column = FixedColumn<Scalar, N>;
    using Square = Column[N];

    struct Work {
        Square scaled;       // L d of the diagonal block
        Square next_scaled;  // and of the next block's rows
        Square carry;        // to add to the next diagonal block
    };

    static void load(const BlockLayout& layout, const LowerColumns<Scalar>& matrix, int block,
                     Scalar* panel) noexcept {
        const int first = layout.start(block);
        const int* outer = matrix.outer + first;
        const Scalar* values = matrix.values;
        Scalar* below = panel + square_size;
        if (layout.dense[block] != 0) {
            // Column j starts at row j; what is read before it lands above the diagonal, unused.
            for (int j = 0; j < N; ++j) {
                const Scalar* column = values + outer[j] - j;
                Column::at(column).store(panel + j * N);
                Column::at(column + N).store(below + j * N);
            }
            return;
        }
        const int size = layout.size(block);
        const int* inner = matrix.inner;
        std::fill(panel, panel + panel_size, Scalar(0.0));
        for (int j = 0; j < size; ++j)
            for (int slot = outer[j]; slot < outer[j + 1]; ++slot) {
                const int row = inner[slot] - first;
                (row < size ? panel[j * N + row] : below[j * N + row - size]) = values[slot];
            }
        for (int j = size; j < N; ++j) panel[j * N + j] = 1.0;
    }

    static void load_probe(const BlockLayout& layout, int block, const double* panel, double* roots,
                           double* probe, PivotSummary& summary) noexcept {
        for (int j = 0; j < layout.size(block); ++j) {
            const double weight = probe_weight(layout.start(block) + j);
            roots[j] = std::sqrt(std::abs(panel[j * N + j]));
            probe[j] = roots[j] * weight;
            summary.weights += weight * weight;
            summary.complete = summary.complete && roots[j] > 0.0;
        }
    }

    // Column by column: what the columns before it leave of this one, divided by its pivot.
    static void eliminate(Scalar* panel, Work& work) noexcept {
        Scalar* below = panel + square_size;
        for (int j = 0; j < N; ++j) {
            Column column = Column::at(panel + j * N);
            column += work.carry[j];
            Column next = Column::at(below + j * N);
            for (int k = 0; k < j; ++k) {
                const Scalar factor = work.scaled[k][j];
                column.subtract(panel + k * N, factor);
                next.subtract(below + k * N, factor);
            }
            work.scaled[j] = column;
            work.next_scaled[j] = next;
            const Scalar inverse = reciprocal(work.scaled[j][j]);
            (column * inverse).store(panel + j * N);
            (next * inverse).store(below + j * N);
            panel[j * N + j] = inverse;
        }
        for (int j = 1; j < N; ++j)
            for (int k = 0; k < j; ++k) panel[j * N + k] = panel[k * N + j];
    }

    // Returns the first bad pivot of the panel, or -1.
    static int audit(const Scalar* panel, int size, [[maybe_unused]] const double* z,
                     [[maybe_unused]] PivotSummary& summary) noexcept {
        for (int j = 0; j < size; ++j) {
            const Scalar inverse = panel[j * N + j];  // of zero: infinite, of an infinity: zero
            const double amount = magnitude(inverse);
            if (!(amount > 0.0 && amount <= std::numeric_limits<double>::max())) return j;
            if constexpr (probed) {
                summary.energy += z[j] * z[j] * amount;
                summary.negative += inverse < 0.0 ? 1 : 0;
            }
        }
        return -1;
    }

    static void update(const Scalar* panel, Work& work) noexcept {
        const Scalar* below = panel + square_size;
        for (int c = 0; c < N; ++c) {
            Column column = Column::zero();
            for (int k = 0; k < N; ++k) column.subtract(below + k * N, work.next_scaled[k][c]);
            work.carry[c] = column;
        }
    }

    // Solves L y = y within a block; `carry` comes from the block before and goes to the next.
    ANCF_NOINLINE static void forward(const Scalar* panel, int size, Column& carry,
                                      Scalar* y) noexcept {
        const Scalar* below = panel + square_size;
        Column rest = padded(y, size);
        rest += carry;
        Column next = Column::zero();
        Scalar solved[N];
        each_column([&](int j) {
            solved[j] = rest[j];
            rest.subtract(panel + j * N, solved[j]);
            next.subtract(below + j * N, solved[j]);
        });
        std::copy_n(solved, size, y);
        carry = next;
    }

    static void backward(const BlockLayout& layout, const Scalar* panels, Scalar* x) noexcept {
        Column next = Column::zero();
        for (int block = layout.blocks() - 1; block >= 0; --block) {
            const Scalar* panel = panels + static_cast<std::ptrdiff_t>(block) * panel_size;
            const Scalar* below = panel + square_size;
            const int size = layout.size(block);
            Scalar* y = x + layout.start(block);
            const Column given = padded(y, size);
            Column rest = Column::zero(), solved = Column::zero();
            each_column([&](int j) {
                rest.set(j, given[j] * panel[j * N + j] - dot(Column::at(below + j * N), next));
            });
            each_column([&](int before) {
                const int j = N - 1 - before;
                const Scalar one = rest[j];
                solved.set(j, one);
                rest.subtract(panel + j * N, one);
            });
            store(solved, size, y);
            next = solved;
        }
    }

    // Where the loop is unrolled, entries of a column stay in registers; beyond some size it is not
    // worth its code.
    template <class Action>
    static void each_column(const Action& action) noexcept {
        if constexpr (N * Column::parts <= 144) {
            ANCF_UNROLL_BLOCK
            for (int j = 0; j < N; ++j) action(j);
        } else {
            for (int j = 0; j < N; ++j) action(j);
        }
    }

    static void store(const Column& from, int size, Scalar* y) noexcept {
        if (size == N) return from.store(y);
        Scalar all[N];
        from.store(all);
        std::copy_n(all, size, y);
    }

    static Column padded(const Scalar* y, int size) noexcept {
        if (size == N) return Column::at(y);
        Scalar all[N];
        std::copy_n(y, size, all);
        std::fill(all + size, all + N, Scalar(0.0));
        return Column::at(all);
    }
};

/// Factorises a chain by the kernel of its width; see BlockKernel::factorize.
template <class Scalar>
PivotSummary factorize_chain(const BlockLayout& layout, const LowerColumns<Scalar>& matrix,
                             Scalar* panels, double* roots, double* probe) {
    return with_block_width(layout.width, [&](auto width) {
        return BlockKernel<width(), Scalar>::factorize(layout, matrix, panels, roots, probe);
    });
}

/// Solves L D L^T x = x in place, by the same kernel.
template <class Scalar>
void solve_chain(const BlockLayout& layout, const Scalar* panels, Scalar* x) {
    with_block_width(layout.width,
                     [&](auto width) { BlockKernel<width(), Scalar>::solve(layout, panels, x); });
}

}  // namespace ancf::detail
