// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Residual and matrix of a step of the energy-momentum scheme.
///
/// For the later end (q_1, lambda), with De = q_1 - q_0:
///
///     M (v_1 - v_0)/h + f(q_0, q_1) + G_d^T lambda - Q(q_m, De/h, t_m) = 0,   g(q_1, t_1) = 0,
///     v_1 = 2 De/h - v_0.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/discrete_gradient.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace ancf::detail {

/// One scene's step. Vectors q, v are of all coordinates.
class EnergyMomentumSystem {
public:
    explicit EnergyMomentumSystem(DynamicProblem& problem);

    /// Takes the start of a step; the supports at both ends are already in q0 and, later, in q1.
    void begin(double t0, double h, const VectorX& q0, const VectorX& v0);

    /// Evaluates the residual at the later end and, where wanted, the matrix
    /// [M + h^2/4 K + h/2 D, G_d^T; G, 0] for (dq_1, h^2/2 dlambda).
    ///
    /// Written to rhs: -h^2/2 of the forces' residual, and -g(q_1, t_1).
    [[nodiscard]] bool evaluate(const VectorX& q1, const VectorX& v1, const VectorX& lambda,
                                bool matrix, VectorX& rhs);

    [[nodiscard]] const SparseMatrix& matrix() const noexcept { return matrix_; }

    /// Returns the length of the shortest element, m.
    [[nodiscard]] double length() const noexcept { return length_; }

private:
    struct LocalLoad {
        LocalCoordinates at;
        std::vector<int> power;  // of a length in each vector's unit
        bool invariant = false;  // rigid motions leave the potential, or g, as it is
    };

    // Calls visit(group, place of the element), element by element.
    template <class Visitor>
    void for_each_element(const Visitor& visit) const;
    void weigh();
    [[nodiscard]] LocalLoad local(const Coupling& coupling) const;
    /// Writes the values of some functions of local coordinates, and their gradients by rows.
    using Functions = std::function<void(const VectorX& q, VectorX& values, MatrixX& gradients)>;
    [[nodiscard]] bool is_invariant(const LocalLoad& local, const Functions& functions) const;
    [[nodiscard]] bool is_invariant(const AnyLoad& load, const LocalLoad& local) const;
    [[nodiscard]] bool is_invariant(const AnyConstraint& constraint, const LocalLoad& local) const;
    void add_elements(const VectorX& q1, bool matrix);
    void add_loads(const VectorX& q1, bool matrix);
    void add_constraints(const VectorX& q1, const VectorX& lambda, bool matrix);
    void evaluate_constraint(std::size_t k, int first, const VectorX& q1, const VectorX& lambda,
                             bool stiffness, ConstraintResult& middle, ConstraintResult& end) const;
    [[nodiscard]] bool is_left_out(int equation) const {
        return problem_.constraints().left_out(equation);
    }
    void add_inertia(const VectorX& v1);
    void write_rows(int constraint, const std::vector<int>& at, const MatrixX& end,
                    const MatrixX& middle, int first);

    DynamicProblem& problem_;
    const Numbering& numbering_;
    const BlockPattern& pattern_;
    StepTangent tangent_;
    std::vector<LocalLoad> loads_, constraints_;
    Revision revision_;    // of the model that gravity_ is of
    VectorX gravity_;      // at unit scale
    double length_ = 1.0;  // of an element: the weight of slopes in joints and loads
    bool driven_ = false;

    double t0_ = 0.0, h_ = 0.0;
    VectorX q0_, v0_, middle_, change_;
    std::vector<double> before_;  // strain energies of the elements at the start
    StepForce step_;              // of one element after the other
    VectorX force_;               // of all coordinates, inertia aside
    VectorX violation_;
    SparseMatrix matrix_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/energy_momentum_system.ipp>  // IWYU pragma: export
#endif
