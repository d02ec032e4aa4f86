// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A dynamic problem as IDA's residual F(t, y, y') = 0 and its Jacobian, behind C callbacks.
///
/// y = (q, v, lambda) for index 3, (q, v, lambda, mu) for Gear, Gupta, Leimkuhler:
///
///     index 3:  F = (q' - v,                 M v' + r, g)
///     GGL:      F = (M (q' - v) + G^T mu,    M v' + r, g, G v + g_t)
///
/// IDA holds y in units of powers of two, so that the columns of the Jacobian compare in KLU
/// whatever the units of the scene; KLU scales the rows itself.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/sundials/run.hpp>
#include <ancf/types.hpp>

#include <sundials/sundials_types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ancf::sundials {

enum class Form;  // ida.hpp

namespace detail {

/// The matrices of a problem that make a Jacobian; all of one pattern, n + m square.
struct JacobianParts {
    const SparseMatrix& tangent;
    const SparseMatrix& mass;
    const SparseMatrix* damping;         ///< null where no load depends on rates
    const SparseMatrix* velocity_level;  ///< (G^T mu)_q and (G v + g_t)_q; null for index 3
};

/// Pattern of the Jacobian J in compressed columns and, for each value of the problem's pattern,
/// its places in J.
///
/// With the tangent [T, G^T; G, 0] of a problem, T = K + (G^T lambda)_q - dQ/dq, and unknowns
/// (q, v, lambda) or (q, v, lambda, mu):
///
///     index 3:                              Gear, Gupta, Leimkuhler:
///     J = [ c I,  -I,        0   ]          J = [ c M + (G^T mu)_q, -M,        0,   G^T ]
///         [ T,    c M + D,   G^T ]              [ T,                c M + D,   G^T, 0   ]
///         [ G,    0,         0   ]              [ G,                0,         0,   0   ]
///                                               [ (G v + g_t)_q,    G,         0,   0   ]
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

/// What IDA integrates.
class IdaSystem : public SceneCalls {
public:
    /// @pre problem.start() has converged.
    IdaSystem(DynamicProblem& problem, Form form);

    [[nodiscard]] Eigen::Index size() const noexcept { return map_.size(); }
    [[nodiscard]] const JacobianMap& map() const noexcept { return map_; }

    /// Sets the units of y, one for each entry, near the given sizes.
    void set_units(const VectorX& sizes);
    /// Returns them.
    [[nodiscard]] const VectorX& units() const noexcept { return units_; }

    /// The further parts of y or of a vector of its size; mu is empty for index 3.
    template <class Column>
    [[nodiscard]] auto lambda(Column&& y) const {
        return y.segment(2 * n_, m_);
    }
    template <class Column>
    [[nodiscard]] auto mu(Column&& y) const {
        return y.tail(y.size() - 2 * n_ - m_);
    }

    static int residual(sunrealtype t, N_Vector y, N_Vector dy, N_Vector r, void* self) noexcept;

    static int jacobian(sunrealtype t, sunrealtype c, N_Vector y, N_Vector, N_Vector,
                        SUNMatrix matrix, void* self, N_Vector, N_Vector, N_Vector) noexcept;

    /// Takes the time that steps start from.
    void begin_step(double time) {
        begin_ = time;
        turn_.clear();
    }
    /// Returns which driven joint turns by too much in the step last tried; empty where none does.
    [[nodiscard]] const std::string& turn() const noexcept { return turn_; }

private:
    using View = Eigen::Map<VectorX>;

    // Evaluates the problem at y, in the units of IDA; false where an element failed.
    [[nodiscard]] bool evaluate(double t, const View& y, Request request);

    // Whether a step to t may take the turns of driven joints.
    [[nodiscard]] bool turns_fit(double t);

    int write_residual(double t, const View& y, const View& dy, View r);
    int write_jacobian(double t, double c, const View& y, SUNMatrix matrix);

    Form form_;
    int m_;
    JacobianMap map_;
    VectorX units_, y_, dy_, lambda_, mu_, gap_, kinematic_;
    SparseMatrix velocity_level_;
    double begin_ = 0.0;
    std::string turn_;
};

}  // namespace detail
}  // namespace ancf::sundials

#if !defined(ANCF_COMPILED)
#include <ancf/sundials/ida_system.ipp>  // IWYU pragma: export
#endif
