// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// All constraints of a scene evaluated without its elements: g, G, G v + g_t, c and products with
/// G.
///
/// Equations can be left out (redundant ones): their rows of G, of the rate and of c are then zero.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/assembly.hpp>
#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <string>

namespace ancf::detail {

/// The constraints of one model; sizes are of all coordinates unless said to be free ones.
class ConstraintSet {
public:
    /// Those of the assembly's scene; it outlives the set.
    explicit ConstraintSet(const Assembly& assembly);

    /// Leaves equations out of everything but violations and their largest values.
    void leave_out(const List<int>& equations) {
        std::fill(left_out_.begin(), left_out_.end(), char{0});
        for (const int equation : equations) left_out_[equation] = 1;
    }

    /// Tells whether an equation is left out.
    [[nodiscard]] bool left_out(int equation) const { return left_out_[equation] != 0; }

    /// Evaluates every constraint at one instant; without c it is cheaper.
    void evaluate(double time, const VectorX& q, const VectorX& v, bool convection = true);

    /// Returns the number of equations.
    [[nodiscard]] int size() const noexcept { return static_cast<int>(violation_.size()); }

    /// Returns g of all equations.
    [[nodiscard]] const VectorX& violation() const noexcept { return violation_; }

    /// Returns G v + g_t.
    [[nodiscard]] const VectorX& rate() const noexcept { return rate_; }

    /// Returns c of d2g/dt2 = G a + c.
    [[nodiscard]] const VectorX& convection() const noexcept { return convection_; }

    /// Returns the largest |g|.
    [[nodiscard]] double largest_violation() const noexcept {
        return largest_magnitude(violation_);
    }
    /// Returns the largest |G v + g_t|.
    [[nodiscard]] double largest_rate() const noexcept { return largest_magnitude(full_rate_); }

    /// Returns G a for all coordinates.
    [[nodiscard]] VectorX product(const VectorX& a) const;

    /// Returns sum_j |G_ij| x_j for all coordinates and equations: the scale of each equation.
    [[nodiscard]] VectorX magnitude(const VectorX& x) const;

    /// Adds scale G^T mu to a vector of free coordinates.
    void add_transpose_product(const VectorX& mu, double scale, VectorX& free) const;

    /// Writes G and G^T into a matrix of the system's pattern (full storage); equations left out
    /// get a 1 on the diagonal.
    void write_jacobian(SparseMatrix& matrix) const;

    /// Writes G into a dense matrix: each free coordinate has a column, or -1.
    void write_rows(const List<int>& columns, MatrixX& rows) const;

    /// Adds (G^T mu)_q, and (G v + g_t)_q in the rows of the equations, to a matrix of the system's
    /// pattern.
    void add_velocity_level(const VectorX& mu, SparseMatrix& matrix) const;

    /// Returns the constraint and the place in it of an equation, as messages name them.
    [[nodiscard]] std::string describe(int equation) const;

private:
    // Calls visit(constraint, result, its coordinates, its first equation).
    template <class Visitor>
    void for_each(const Visitor& visit) const;
    // Calls visit(equation, free coordinate, G of both) for those that are not left out.
    template <class Visitor>
    void for_each_entry(const Visitor& visit) const;

    const Assembly& assembly_;
    const List<AnyConstraint>& constraints_;
    List<int> first_;  // first equation of each constraint
    List<ConstraintResult> results_;
    List<char> left_out_;
    ConstraintState local_;
    double time_ = 0.0;  // s, with q and v of the last evaluation that had c
    VectorX q_, v_;
    VectorX violation_, rate_, full_rate_, convection_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/constraint_set.ipp>  // IWYU pragma: export
#endif
