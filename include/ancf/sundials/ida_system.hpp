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

#include <ancf/algebra.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/turning_frames.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/sundials/run.hpp>
#include <ancf/types.hpp>

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_nvector.h>
#include <sundials/sundials_types.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ancf::sundials::detail {

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
    /// @param pattern     n + m square, compressed, rows ascending.
    /// @param stabilised  the form of Gear, Gupta, Leimkuhler; else index 3.
    /// @throws InvalidArgument where SUNDIALS cannot count the entries of J.
    JacobianMap(const SparseMatrix& pattern, int n, bool stabilised)
        : n_(n), stabilised_(stabilised) {
        const int all = static_cast<int>(pattern.cols());
        const int m = all - n;
        static_cast<void>(
            checked_index(2 * pattern.cols(), "unknowns"));  // and so every row of J fits
        const auto count = static_cast<std::size_t>(pattern.nonZeros());
        motion_.assign(count, -1);
        rate_.assign(count, -1);
        kinematic_.assign(count, -1);
        kinematic_v_.assign(count, -1);
        const auto append_columns = [&](std::vector<sunindextype>& kinematic,
                                        std::vector<sunindextype>& motion, int end) {
            for (int j = 0; j < n; ++j) {
                if (stabilised)
                    append(pattern, j, 0, n, 0, kinematic);
                else
                    inner_.push_back(j);
                append(pattern, j, 0, end, n, motion);
                if (stabilised) append(pattern, j, n, all, n + m, kinematic);
                close_column();
            }
        };
        append_columns(kinematic_, motion_, all);  // q
        append_columns(kinematic_v_, rate_, n);    // v
        for (int j = n; j < all; ++j) {            // lambda
            append(pattern, j, 0, all, n, motion_);
            close_column();
        }
        for (int j = n; stabilised && j < all; ++j) {  // mu
            append(pattern, j, 0, n, 0, kinematic_);
            append(pattern, j, n, all, n + m, kinematic_);
            close_column();
        }
    }

    [[nodiscard]] Eigen::Index size() const noexcept {
        return static_cast<Eigen::Index>(outer_.size()) - 1;
    }
    [[nodiscard]] Eigen::Index values() const noexcept {
        return static_cast<Eigen::Index>(inner_.size());
    }

    /// Writes pattern and values of J at IDA's c; the pattern too, as SUNMatZero erases it.
    void fill(const JacobianParts& parts, double c, sunindextype* outer, sunindextype* inner,
              double* values) const noexcept {
        std::copy(outer_.begin(), outer_.end(), outer);
        std::copy(inner_.begin(), inner_.end(), inner);
        const SparseMatrix& pattern = parts.tangent;
        const double* tangent = parts.tangent.valuePtr();
        const double* mass = parts.mass.valuePtr();
        const double* damping = parts.damping != nullptr ? parts.damping->valuePtr() : nullptr;
        if (!stabilised_)
            for (int j = 0; j < n_; ++j) {
                values[outer_[j]] = c;
                values[outer_[n_ + j]] = -1.0;
            }
        for (std::size_t k = 0; k < motion_.size(); ++k) {
            values[motion_[k]] = tangent[k];
            if (rate_[k] >= 0)
                values[rate_[k]] = c * mass[k] + (damping != nullptr ? damping[k] : 0.0);
        }
        if (!stabilised_) return;
        const double* level = parts.velocity_level->valuePtr();
        for (int j = 0; j < static_cast<int>(pattern.cols()); ++j)
            for (int k = pattern.outerIndexPtr()[j]; k < pattern.outerIndexPtr()[j + 1]; ++k) {
                const bool inertia = j < n_ && pattern.innerIndexPtr()[k] < n_;
                const bool of_q = j < n_;
                values[kinematic_[k]] =
                    of_q ? level[k] + (inertia ? c * mass[k] : 0.0) : tangent[k];
                if (of_q) values[kinematic_v_[k]] = inertia ? -mass[k] : tangent[k];
            }
    }

private:
    // One column of J: rows of the problem's pattern moved by a shift, and where they went.
    void append(const SparseMatrix& pattern, int column, int from, int to, int shift,
                std::vector<sunindextype>& place) {
        for (int k = pattern.outerIndexPtr()[column]; k < pattern.outerIndexPtr()[column + 1];
             ++k) {
            const int row = pattern.innerIndexPtr()[k];
            if (row < from || row >= to) continue;
            place[k] = static_cast<sunindextype>(inner_.size());
            inner_.push_back(static_cast<sunindextype>(row) + shift);
        }
    }

    void close_column() {
        const auto entries = static_cast<std::ptrdiff_t>(inner_.size());
        outer_.push_back(checked_index(entries, "entries of the Jacobian"));
    }

    int n_;
    bool stabilised_;
    std::vector<sunindextype> outer_{0}, inner_;

    // Per value of the problem's pattern; -1 where it does not enter.
    std::vector<sunindextype> motion_;       // equation of motion and g: columns q and lambda
    std::vector<sunindextype> rate_;         // equation of motion, column v
    std::vector<sunindextype> kinematic_;    // first row, columns q and mu; last row, column q
    std::vector<sunindextype> kinematic_v_;  // first and last row, column v
};

/// What IDA integrates.
class IdaSystem : public SceneCalls {
    using View = Eigen::Map<VectorX>;

public:
    /// @pre problem.start() has converged.
    /// @param stabilised  as of JacobianMap.
    IdaSystem(DynamicProblem& problem, bool stabilised)
        : SceneCalls(problem),
          stabilised_(stabilised),
          m_(problem.multipliers()),
          map_(problem.mass(), n_, stabilised),
          units_(VectorX::Ones(map_.size())),
          frames_(problem.model(), problem.numbering()) {}

    [[nodiscard]] Eigen::Index size() const noexcept { return map_.size(); }
    [[nodiscard]] const JacobianMap& map() const noexcept { return map_; }

    /// Sets the units of y, one for each entry, near the given sizes.
    void set_units(const VectorX& sizes) {
        for (Eigen::Index i = 0; i < units_.size(); ++i)
            units_[i] =
                sizes[i] > 0.0 ? ancf::detail::power_of_two(std::ilogb(sizes[i])) : 1.0;  // exact
    }

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

    /// Sets the tolerances; they may change between steps.
    /// @param absolute  in the units of y; kept, not copied.
    void set_tolerances(double relative, N_Vector absolute) noexcept {
        relative_ = relative;
        absolute_ = absolute;
    }

    /// Writes one over the tolerances at y. @return fatal where one is not positive.
    static int weights(N_Vector y, N_Vector weights, void* self) noexcept {
        const auto& system = *static_cast<const IdaSystem*>(self);
        const View at = view(y), absolute = view(system.absolute_);
        View out = view(weights);
        for (Eigen::Index i = 0; i < at.size(); ++i) {
            const double allowed = system.relative_ * std::abs(at[i]) + absolute[i];
            if (!(allowed > 0.0)) return fatal;
            out[i] = 1.0 / allowed;
        }
        return good;
    }

    static int residual(sunrealtype t, N_Vector y, N_Vector dy, N_Vector r, void* self) noexcept {
        auto& system = *static_cast<IdaSystem*>(self);
        return system.guarded([&] { return system.write_residual(t, view(y), view(dy), view(r)); });
    }

    static int jacobian(sunrealtype t, sunrealtype c, N_Vector y, N_Vector, N_Vector,
                        SUNMatrix matrix, void* self, N_Vector, N_Vector, N_Vector) noexcept {
        auto& system = *static_cast<IdaSystem*>(self);
        return system.guarded([&] { return system.write_jacobian(t, c, view(y), matrix); });
    }

    /// Solves for a correction by a solver of the Jacobian; where frames turn with the nodes, in
    /// those from the state of the Jacobian.
    /// @param correction, residual  vectors of IDA, two of them.
    int solve(SUNLinearSolver solver, SUNMatrix matrix, N_Vector correction,
              N_Vector residual) noexcept {
        return solved([&] {
            if (!frames_.turn()) return SUNLinSolSolve(solver, matrix, correction, residual, 0.0);
            const VectorX force = v(view(residual));
            N_VScale(1.0, residual, correction);
            carry(q_, linearised_, correction);
            const int code = SUNLinSolSolve(solver, matrix, correction, correction, 0.0);
            carry(linearised_, q_, correction);
            work_ = std::abs(q(view(correction)).cwiseProduct(q(units_)).dot(force));
            return code;
        });
    }
    /// Takes back the strains of the prediction: a correction to slopes of the start, turned.
    /// @param c         1/s, IDA's dy'/dy of the step.
    /// @param rescaled  what IDA divides a correction by.
    int keep_strains(double c, double rescaled, N_Vector correction) noexcept {
        return solved([&] {
            VectorX kept = q_;
            frames_.keep_strains(q(begin_y_).cwiseProduct(q(units_)), kept);
            kept -= q_;
            auto entries = view(correction);
            entries.setZero();
            q(entries) = rescaled * kept.cwiseQuotient(q(units_));
            v(entries) = rescaled * c * kept.cwiseQuotient(v(units_));
            return good;
        });
    }
    /// Tells whether the Jacobian is of the step.
    [[nodiscard]] bool fresh() const noexcept { return fresh_; }
    /// Returns IDA's c of the Jacobian, 1/s.
    [[nodiscard]] double c() const noexcept { return c_; }
    /// Returns the work of the residual along the last correction in frames that turn, J.
    [[nodiscard]] double work() const noexcept { return work_; }
    /// Returns the frames.
    [[nodiscard]] ancf::detail::TurningFrames& frames() noexcept { return frames_; }

    /// Takes the state that steps start from.
    void begin_step(double time, N_Vector y) {
        begin_ = time;
        begin_y_ = view(y);
        fresh_ = false;
        turn_.clear();
    }
    /// Returns which driven joint turns by too much in the step last tried; empty where none does.
    [[nodiscard]] const std::string& driven_turn() const noexcept { return turn_; }

private:
    // Evaluates the problem at y, in the units of IDA; false where an element failed.
    [[nodiscard]] bool evaluate(double t, const View& y, Request request) {
        y_ = y.cwiseProduct(units_);
        q_ = q(y_);
        v_ = v(y_);
        lambda_ = lambda(y_);
        mu_ = mu(y_);
        return SceneCalls::evaluate(t, lambda_, request);
    }

    // Whether a step to t may take the turns of driven joints.
    [[nodiscard]] bool turns_fit(double t) {
        const auto& constraints = problem_.model().constraints();
        const auto turn = ancf::detail::driven_turn(constraints, begin_, t);
        turn_ = turn.fits() ? "" : ancf::detail::driven_turn_text(constraints, turn, begin_, t);
        return turn.fits();
    }

    int write_residual(double t, const View& y, const View& dy, View r) {
        if (!turns_fit(t) || !evaluate(t, y, Request::force)) return recoverable;
        const SparseMatrix& mass = problem_.compact_mass();
        dy_ = dy.cwiseProduct(units_);
        v(r) = problem_.force();
        v(r).noalias() += mass * v(dy_);
        lambda(r) = problem_.constraint_residual();
        gap_ = q(dy_) - v_;
        if (!stabilised_) {
            q(r) = gap_;
            return good;
        }
        kinematic_.noalias() = mass * gap_;
        problem_.evaluate_constraints(t, q_, v_, false);
        problem_.constraints().add_transpose_product(mu_, 1.0, kinematic_);
        q(r) = kinematic_;
        mu(r) = problem_.constraints().rate();
        for (const int equation : problem_.left_out()) mu(r)[equation] = mu_[equation];
        return good;
    }

    // In frames that turn at the start of the step, which no prediction strains.
    int write_jacobian(double t, double c, const View& y, SUNMatrix matrix) {
        const VectorX at = q_;  // of the residual that is solved for
        const bool turn = frames_.turn();
        const double time = turn ? begin_ : t;
        if (!evaluate(time, turn ? View(begin_y_.data(), size()) : y, request_)) return recoverable;
        if (stabilised_) {
            problem_.evaluate_constraints(time, q_, v_);
            problem_.velocity_level(mu_, velocity_level_);
        }
        linearised_ = std::exchange(q_, at);
        c_ = c;
        fresh_ = true;
        const JacobianParts parts{problem_.tangent(), problem_.mass(),
                                  request_ == Request::tangent ? nullptr : &problem_.damping(),
                                  stabilised_ ? &velocity_level_ : nullptr};
        sunindextype* outer = SUNSparseMatrix_IndexPointers(matrix);
        double* values = SUNSparseMatrix_Data(matrix);
        map_.fill(parts, c, outer, SUNSparseMatrix_IndexValues(matrix), values);
        for (Eigen::Index j = 0; j < units_.size(); ++j)
            for (sunindextype k = outer[j]; k < outer[j + 1]; ++k) values[k] *= units_[j];
        return good;
    }

    // Returns what work returns, or that it threw: by a code of linear solvers that ends a step.
    template <class Work>
    [[nodiscard]] int solved(const Work& work) noexcept {
        const int code = guarded(work);
        return code == fatal ? SUNLS_PSOLVE_FAIL_UNREC : code;
    }

    // Turns q and v, or their residuals, as the nodes turn between two configurations.
    void carry(const VectorX& from, const VectorX& to, N_Vector y) const {
        auto entries = view(y);
        frames_.carry(from, to, q(entries).data());
        frames_.carry(from, to, v(entries).data());
    }

    bool stabilised_;
    int m_;
    JacobianMap map_;
    VectorX units_, y_, dy_, lambda_, mu_, gap_, kinematic_;
    double relative_ = 0.0;  // tolerances
    N_Vector absolute_ = nullptr;
    VectorX begin_y_, linearised_;  // y of the step's start, q of the Jacobian
    ancf::detail::TurningFrames frames_;
    double work_ = 0.0, c_ = 0.0;
    bool fresh_ = false;  // whether the Jacobian is of the step
    SparseMatrix velocity_level_;
    double begin_ = 0.0;
    std::string turn_;
};

}  // namespace ancf::sundials::detail
