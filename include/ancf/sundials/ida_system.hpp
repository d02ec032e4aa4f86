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
#include <ancf/sundials/jacobian_map.hpp>
#include <ancf/sundials/run.hpp>
#include <ancf/types.hpp>

#include <string>

namespace ancf::sundials::detail {

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

}  // namespace ancf::sundials::detail

#if !defined(ANCF_COMPILED)
#include <ancf/sundials/ida_system.ipp>  // IWYU pragma: export
#endif
