// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The Jacobian of IDA's system in compressed columns, filled through one map made in advance.
///
/// With the tangent [T, G^T; G, 0] of a problem, T = K + (G^T lambda)_q - dQ/dq, and unknowns
/// (q, v, lambda) or (q, v, lambda, mu):
///
///     index 3:                              Gear, Gupta, Leimkuhler:
///     J = [ c I,  -I,        0   ]          J = [ c M + (G^T mu)_q, -M,        0,   G^T ]
///         [ T,    c M + D,   G^T ]              [ T,                c M + D,   G^T, 0   ]
///         [ G,    0,         0   ]              [ G,                0,         0,   0   ]
///                                               [ (G v + g_t)_q,    G,         0,   0   ]

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/sundials/index.hpp>
#include <ancf/types.hpp>

#include <sundials/sundials_types.h>

#include <cstddef>
#include <vector>

namespace ancf::sundials {

/// How the equations of motion are handed to IDA.
enum class Form {
    index3,                ///< q' = v and g = 0 as they stand
    gear_gupta_leimkuhler  ///< index 2: M (q' - v) + G^T mu = 0 and G v + g_t = 0 added
};

namespace detail {

/// The matrices of a problem that make a Jacobian; all of one pattern, n + m square.
struct JacobianParts {
    const SparseMatrix& tangent;
    const SparseMatrix& mass;
    const SparseMatrix* damping;         ///< null where no load depends on rates
    const SparseMatrix* velocity_level;  ///< (G^T mu)_q and (G v + g_t)_q; null for index 3
};

/// Pattern of J and, for each value of the problem's pattern, its places in J.
class JacobianMap {
public:
    /// @param pattern  n + m square, compressed, rows ascending.
    /// @throws InvalidArgument where SUNDIALS cannot count the entries of J.
    JacobianMap(const SparseMatrix& pattern, int n, Form form);

    [[nodiscard]] Eigen::Index size() const noexcept {
        return static_cast<Eigen::Index>(outer_.size()) - 1;
    }
    [[nodiscard]] Eigen::Index values() const noexcept {
        return static_cast<Eigen::Index>(inner_.size());
    }

    /// Writes pattern and values of J at IDA's c; the pattern too, as SUNMatZero erases it.
    void fill(const JacobianParts& parts, double c, sunindextype* outer, sunindextype* inner,
              double* values) const noexcept;

private:
    // One column of J: rows of the problem's pattern moved by a shift, and where they went.
    void append(const SparseMatrix& pattern, int column, int from, int to, int shift,
                std::vector<sunindextype>& place);
    void append_unit(int row) { inner_.push_back(row); }
    void close_column() {
        const auto entries = static_cast<std::ptrdiff_t>(inner_.size());
        outer_.push_back(checked_index(entries, "entries of the Jacobian"));
    }

    int n_;
    Form form_;
    std::vector<sunindextype> outer_{0}, inner_;

    // Per value of the problem's pattern; -1 where it does not enter.
    std::vector<sunindextype> motion_;       // equation of motion and g: columns q and lambda
    std::vector<sunindextype> rate_;         // equation of motion, column v
    std::vector<sunindextype> kinematic_;    // first row, columns q and mu; last row, column q
    std::vector<sunindextype> kinematic_v_;  // first and last row, column v
};

}  // namespace detail
}  // namespace ancf::sundials

#if !defined(ANCF_COMPILED)
#include <ancf/sundials/jacobian_map.ipp>  // IWYU pragma: export
#endif
