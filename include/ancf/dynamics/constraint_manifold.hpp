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

#include <ancf/algebra.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/dense_lu.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ancf::detail {

/// Adds scale A x, x beginning at an entry of a vector.
inline void add_product(const MatrixX& A, double scale, const VectorX& x, Eigen::Index from,
                        VectorX& out) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
        const double factor = scale * x[from + j];
        for (Eigen::Index i = 0; i < A.rows(); ++i) out[i] += factor * A(i, j);
    }
}

/// Adds scale A^T x likewise.
inline void add_transposed(const MatrixX& A, double scale, const VectorX& x, Eigen::Index from,
                           VectorX& out) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
        double sum = 0.0;
        for (Eigen::Index i = 0; i < A.rows(); ++i) sum += A(i, j) * x[from + i];
        out[j] += scale * sum;
    }
}

/// Adds scale A B, A with many zeros, to a block.
inline void add_product(const MatrixX& A, const MatrixX& B, double scale, Eigen::Index row,
                        Eigen::Index column, MatrixX& out) {
    for (Eigen::Index k = 0; k < A.cols(); ++k)
        for (Eigen::Index i = 0; i < A.rows(); ++i) {
            if (A(i, k) == 0.0) continue;
            const double factor = scale * A(i, k);
            for (Eigen::Index j = 0; j < B.cols(); ++j)
                out(row + i, column + j) += factor * B(k, j);
        }
}

/// The constraints at a place: m equations in k active coordinates.
struct TangentSpace {
    MatrixX G;          ///< m x k; of equations left out the rows are zero
    MatrixX C;          ///< k x m: the active rows of M^-1 G^T
    DenseLu<double> S;  ///< G C; of equations left out 1
    VectorX g;          ///< m
    VectorX rate;       ///< m: g_t, and what driven supports make
};

/// The manifold of the constraints with the metric M; without constraints all places.
class ConstraintManifold {
public:
    /// Reads M, and which equations are left out. @pre the problem has started.
    explicit ConstraintManifold(DynamicProblem& problem) : problem_(problem) {
        const int n = problem.size(), m = problem.multipliers();
        if (m == 0) return;
        const Numbering& numbering = problem.numbering();
        List<char> acted(static_cast<std::size_t>(numbering.coordinates()), 0);
        for (std::size_t k = 0; k < problem.model().constraints().size(); ++k)
            for (const int coordinate : problem.assembly().constraint_coordinates(k).acted())
                acted[coordinate] = 1;
        place_.assign(static_cast<std::size_t>(n), -1);
        for (int coordinate = 0; coordinate < numbering.coordinates(); ++coordinate) {
            const int equation = numbering.equation(coordinate);
            if (equation < 0 || acted[coordinate] == 0) continue;
            place_[equation] = static_cast<int>(active_.size());
            active_.push_back(equation);
            coordinates_.push_back(coordinate);
        }
        const auto k = static_cast<Eigen::Index>(active_.size());
        const VectorX& scales = problem.scales();
        gather(scales, active_, scales_);
        columns_.resize(n, k);
        block_.resize(k, k);
        VectorX unit = VectorX::Zero(n), column, part;
        for (Eigen::Index j = 0; j < k; ++j) {
            const int equation = active_[j];
            unit[equation] = 1.0;
            problem.solve_mass(unit, column);
            unit[equation] = 0.0;
            std::copy_n(column.data(), n, columns_.data() + j * n);
            gather(column, active_, part);
            std::copy_n(part.data(), k, block_.data() + j * k);
            const double least = 1e-18 * largest_ratio(column, scales);
            int first = 0, last = n;
            while (std::abs(column[first]) <= least * scales[first]) ++first;
            while (std::abs(column[last - 1]) <= least * scales[last - 1]) --last;
            first_.push_back(first);
            last_.push_back(last);
        }
        push_.setZero(2 * m);
        before_.setZero(2 * m);
    }

    /// Evaluates the constraints at a place. @return false where they depend on each other.
    [[nodiscard]] bool find(double t, const VectorX& q, TangentSpace& at) {
        if (!binds()) return true;
        gather(q, active_, there_);
        look(t, there_, at);
        return factorize(at);
    }

    /// Adds M^-1 G^T l to x, so that G x + b = 0, and l to a vector where one is given.
    void project(const TangentSpace& at, const VectorX& b, VectorX& x, VectorX* sum = nullptr) {
        if (!binds()) return;
        gather(x, active_, there_);
        multipliers_ = b;
        add_product(at.G, 1.0, there_, 0, multipliers_);
        at.S.solve(multipliers_.data());
        force_.setZero(there_.size());
        add_transposed(at.G, -1.0, multipliers_, 0, force_);
        add(force_, 1.0, x);
        if (sum != nullptr) *sum -= multipliers_;
    }

    /// Moves q onto g = 0 along M^-1 G^T of a place nearby, and evaluates the constraints there.
    /// @return false where the iteration fails.
    [[nodiscard]] bool bring(double t, const TangentSpace& along, VectorX& q, TangentSpace& at) {
        if (!binds()) return true;
        gather(q, active_, there_);
        force_.setZero(there_.size());
        for (int iteration = 0; iteration < 12; ++iteration) {
            look(t, there_, at);
            multipliers_ = at.g;
            along.S.solve(multipliers_.data());
            change_.setZero(there_.size());
            add_product(along.C, -1.0, multipliers_, 0, change_);
            add_transposed(along.G, -1.0, multipliers_, 0, force_);
            there_ += change_;
            const double gap = largest_ratio(change_, scales_);
            if (!(gap < 1.0)) return false;
            if (gap > 1e-9) continue;
            add(force_, 1.0, q);
            return factorize(at);
        }
        return false;
    }

    /// Moves q and v by h on the constraints. What v has along G^T at the begin has no effect; at
    /// the end it is left to project(). @return false where Newton's method fails.
    [[nodiscard]] bool drift(double t, double h, const TangentSpace& from, VectorX& q, VectorX& v,
                             TangentSpace& to) {
        if (!binds()) {
            q += h * v;
            return true;
        }
        const Eigen::Index m = from.G.rows();
        gather(q, active_, place_now_);
        gather(v, active_, rate_);
        if (!find_push(t, h, from, to) || !factorize(to)) {
            middle_.C.resize(0, 0);  // no guess for the next one
            push_.setZero();
            before_.setZero();
            return false;
        }
        q += h * v;
        force_.setZero(rate_.size());
        add_transposed(from.G, h * h / 6.0, push_, 0, force_);
        add_transposed(middle_.G, h * h / 3.0, push_, m, force_);
        add(force_, -1.0, q);
        force_.setZero();
        add_transposed(from.G, h / 6.0, push_, 0, force_);
        add_transposed(middle_.G, 2.0 * h / 3.0, push_, m, force_);
        add(force_, -1.0, v);
        return true;
    }

private:
    [[nodiscard]] bool binds() const noexcept { return problem_.multipliers() > 0; }

    /// Evaluates the constraints at active coordinates.
    void look(double t, const VectorX& place, TangentSpace& at) {
        problem_.evaluate_constraints(t, coordinates_, place);
        at.G.resize(problem_.multipliers(), place.size());
        problem_.constraints().write_rows(place_, at.G);
        at.g = problem_.constraints().violation();
        for (const int equation : problem_.left_out()) at.g[equation] = 0.0;
        at.rate = problem_.constraints().rate();
    }

    void spread(TangentSpace& at) const {
        at.C.setZero(at.G.cols(), at.G.rows());
        for (Eigen::Index i = 0; i < at.G.rows(); ++i)
            for (Eigen::Index j = 0; j < at.G.cols(); ++j) {
                const double factor = at.G(i, j);
                if (factor == 0.0) continue;
                for (Eigen::Index l = 0; l < at.G.cols(); ++l) at.C(l, i) += factor * block_(l, j);
            }
    }

    [[nodiscard]] bool factorize(TangentSpace& at) const {
        spread(at);
        at.S.factors.setZero(at.G.rows(), at.G.rows());
        add_product(at.G, at.C, 1.0, 0, 0, at.S.factors);
        for (const int equation : problem_.left_out()) at.S.factors(equation, equation) = 1.0;
        return at.S.factorize();
    }

    /// Finds mu at the begin and half-way, so that there and at the end g = 0.
    [[nodiscard]] bool find_push(double t, double h, const TangentSpace& from, TangentSpace& to) {
        const Eigen::Index m = from.G.rows(), k = from.G.cols();
        const double part = h * h / 24.0;
        change_ = push_;
        push_ = 2.0 * push_ - before_;
        before_ = change_;
        guess_ = from.C;
        if (middle_.C.cols() == guess_.cols()) guess_ = 2.0 * guess_ - middle_.C;
        for (int iteration = 0; iteration < 12; ++iteration) {
            there_ = place_now_ + 0.5 * h * rate_;
            add_product(from.C, -2.0 * part, push_, 0, there_);
            add_product(guess_, -part, push_, m, there_);
            look(t + 0.5 * h, there_, middle_);
            spread(middle_);
            slip_.setZero(k);
            add_product(guess_, part, push_, m, slip_);
            add_product(middle_.C, -part, push_, m, slip_);
            guess_ = middle_.C;
            multipliers_ = middle_.g;
            add_product(middle_.G, 1.0, slip_, 0, multipliers_);
            there_ = place_now_ + h * rate_;
            add_product(from.C, -4.0 * part, push_, 0, there_);
            add_product(middle_.C, -8.0 * part, push_, m, there_);
            look(t + h, there_, to);
            if (iteration == 0) {
                newton_.factors.setZero(2 * m, 2 * m);
                add_product(middle_.G, from.C, 2.0 * part, 0, 0, newton_.factors);
                add_product(middle_.G, middle_.C, part, 0, m, newton_.factors);
                add_product(to.G, from.C, 4.0 * part, m, 0, newton_.factors);
                add_product(to.G, middle_.C, 8.0 * part, m, m, newton_.factors);
                for (const int i : problem_.left_out())
                    newton_.factors(i, i) = newton_.factors(m + i, m + i) = 1.0;
                if (!newton_.factorize()) return false;
            }
            change_.resize(2 * m);
            std::copy_n(to.g.data(), m, std::copy_n(multipliers_.data(), m, change_.data()));
            newton_.solve(change_.data());
            push_ += change_;
            there_.setZero();
            add_product(from.C, 4.0 * part, change_, 0, there_);
            add_product(middle_.C, 8.0 * part, change_, m, there_);
            const double gap =
                std::max(largest_ratio(there_, scales_), largest_ratio(slip_, scales_));
            if (!(gap < 1.0)) return false;
            if (gap <= 1e-8) return true;
        }
        return false;
    }

    /// Adds scale M^-1 f of active forces.
    void add(const VectorX& force, double scale, VectorX& x) const {
        for (std::size_t j = 0; j < active_.size(); ++j) {
            const double factor = scale * force.data()[j];
            const double* const column = columns_.data() + j * x.size();
            for (int i = first_[j]; i < last_[j]; ++i) x.data()[i] += factor * column[i];
        }
    }

    DynamicProblem& problem_;
    List<int> active_, coordinates_;  // active ones among the free, and among all
    List<int> place_;                 // of each free coordinate among the active, or -1
    MatrixX columns_, block_;         // of M^-1: n x k, k x k
    List<int> first_, last_;          // of each column what is no round-off
    VectorX scales_;                  // of active coordinates
    // of the drift: half-way, mu of begin and middle, those of the drift before
    TangentSpace middle_;
    VectorX push_, before_;
    MatrixX guess_;
    DenseLu<double> newton_;
    VectorX place_now_, rate_, there_, slip_, force_, multipliers_, change_;
};

}  // namespace ancf::detail
