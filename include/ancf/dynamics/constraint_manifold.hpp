// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Motion on the constraints without forces: what the leapfrog does between two kicks.
///
///     M q'' = -G^T mu,    g(t, q) = 0.
///
/// G acts on few coordinates, the active ones. All is solved for in these alone, by small dense
/// systems; columns of M^-1 bring the rest. docs/theory-leapfrog.md has the equations.
/// Source: Jay, SIAM Journal on Numerical Analysis 33, 1996.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/types.hpp>

#include <vector>

namespace ancf::detail {

/// L U of a small matrix, with rows exchanged.
struct DenseLu {
    MatrixX factors;         ///< the matrix, then L and U
    std::vector<int> order;  ///< rows by their pivots

    /// Factorises in place. @return false where a pivot is zero or no number.
    [[nodiscard]] bool factorize();
    /// Solves in place.
    void solve(VectorX& x) const;
};

/// The constraints at a place: m equations in k active coordinates.
struct TangentSpace {
    MatrixX G;     ///< m x k; of equations left out the rows are zero
    MatrixX C;     ///< k x m: the active rows of M^-1 G^T
    DenseLu S;     ///< G C; of equations left out 1
    VectorX g;     ///< m
    VectorX rate;  ///< m: g_t, and what driven supports make
};

/// The manifold of the constraints with the metric M; without constraints all places.
class ConstraintManifold {
public:
    /// Reads M, and which equations are left out. @pre the problem has started.
    explicit ConstraintManifold(DynamicProblem& problem);

    /// Evaluates the constraints at a place. @return false where they depend on each other.
    [[nodiscard]] bool find(double t, const VectorX& q, TangentSpace& at);

    /// Adds M^-1 G^T l to x, so that G x + b = 0, and l to a vector where one is given.
    void project(const TangentSpace& at, const VectorX& b, VectorX& x, VectorX* sum = nullptr);

    /// Moves q onto g = 0 along M^-1 G^T of a place nearby, and evaluates the constraints there.
    /// @return false where the iteration fails.
    [[nodiscard]] bool bring(double t, const TangentSpace& along, VectorX& q, TangentSpace& at);

    /// Moves q and v by h on the constraints. What v has along G^T at the begin has no effect; at
    /// the end it is left to project(). @return false where Newton's method fails.
    [[nodiscard]] bool drift(double t, double h, const TangentSpace& from, VectorX& q, VectorX& v,
                             TangentSpace& to);

private:
    [[nodiscard]] bool binds() const noexcept { return problem_.multipliers() > 0; }
    void look(double t, const VectorX& place, TangentSpace& at);
    void spread(TangentSpace& at) const;
    [[nodiscard]] bool factorize(TangentSpace& at) const;
    [[nodiscard]] bool find_push(double t, double h, const TangentSpace& from, TangentSpace& to);
    void add(const VectorX& force, double scale, VectorX& x) const;

    DynamicProblem& problem_;
    std::vector<int> active_, coordinates_;  // active ones among the free, and among all
    std::vector<int> place_;                 // of each free coordinate among the active, or -1
    MatrixX columns_, block_;                // of M^-1: n x k, k x k
    std::vector<int> first_, last_;          // of each column what is no round-off
    VectorX scales_;                         // of active coordinates
    // of the drift: half-way, mu of begin and middle, those of the drift before
    TangentSpace middle_;
    VectorX push_, before_;
    MatrixX guess_;
    DenseLu newton_;
    VectorX place_now_, rate_, there_, slip_, force_, multipliers_, change_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/constraint_manifold.ipp>  // IWYU pragma: export
#endif
