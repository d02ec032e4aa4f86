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

#include <ancf/algebra.hpp>
#include <ancf/dynamics/discrete_gradient.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/load.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ancf::detail {

/// One scene's step. Vectors q, v are of all coordinates.
template <class Scene>
class EnergyMomentumSystem {
public:
    explicit EnergyMomentumSystem(DynamicProblem<Scene>& problem);

    /// Takes the start of a step; the supports at both ends are already in q0 and, later, in q1.
    void begin(double t0, double h, const VectorX& q0, const VectorX& v0);

    /// Evaluates the residual at the later end and, where wanted, the matrix
    /// [M + h^2/4 K + h/2 D, G_d^T; G, 0] for (dq_1, h^2/2 dlambda).
    ///
    /// Written to rhs: -h^2/2 of the forces' residual, and -g(q_1, t_1).
    [[nodiscard]] bool evaluate(const VectorX& q1, const VectorX& v1, const VectorX& lambda,
                                bool matrix, VectorX& rhs);

    [[nodiscard]] const SparseMatrix& matrix() const noexcept { return matrix_; }

private:
    struct LocalLoad {
        std::vector<int> at;
        std::vector<int> power;  // of a length in each vector's unit
    };

    void weigh();
    [[nodiscard]] LocalLoad local(const Coupling& coupling) const;
    [[nodiscard]] bool is_invariant(const AnyConstraint& constraint, const LocalLoad& local) const;
    void add_elements(const VectorX& q1, bool matrix);
    void add_loads(const VectorX& q1, bool matrix);
    void add_constraints(const VectorX& q1, const VectorX& lambda, bool matrix);
    void evaluate_constraint(std::size_t k, int first, const VectorX& q1, const VectorX& lambda,
                             ConstraintResult& middle, ConstraintResult& end) const;
    [[nodiscard]] bool is_left_out(int equation) const {
        return left_out_[static_cast<std::size_t>(equation)] != 0;
    }
    void add_block(const std::vector<int>& at, const MatrixX& block, double scale);
    void add_inertia(const VectorX& v1);
    void write_rows(int constraint, const std::vector<int>& at, const MatrixX& end,
                    const MatrixX& middle, int first);

    DynamicProblem<Scene>& problem_;
    const Numbering& numbering_;
    const BlockPattern& pattern_;
    StepTangent tangent_;
    std::vector<LocalLoad> loads_, constraints_;
    std::vector<char> invariant_;
    std::vector<char> left_out_;
    Revision revision_;    // of the model that gravity_ is of
    VectorX gravity_;      // at unit scale
    double length_ = 1.0;  // of an element: the weight of slopes in joints and loads
    bool driven_ = false;

    double t0_ = 0.0, h_ = 0.0;
    VectorX q0_, v0_, middle_, change_;
    std::vector<double> before_;  // strain energies of the elements at the start
    VectorX force_;               // of all coordinates, inertia aside
    VectorX violation_;
    SparseMatrix matrix_;
};

template <class Scene>
EnergyMomentumSystem<Scene>::EnergyMomentumSystem(DynamicProblem<Scene>& problem)
    : problem_(problem),
      numbering_(problem.numbering()),
      pattern_(problem.assembly().pattern()),
      tangent_(pattern_.storage() == Storage::full ? StepTangent::exact : StepTangent::symmetric),
      matrix_(problem.mass()) {
    const Scene& model = problem.model();
    weigh();
    problem.assembly().for_each_element([&](const auto& element, const int*, const auto&) {
        length_ = before_.empty() ? element.length() : std::min(length_, element.length());
        before_.push_back(0.0);
    });
    for (const ScaledLoad& load : model.loads()) loads_.push_back(local(load.load.coupling()));
    for (const AnyConstraint& constraint : model.constraints()) {
        constraints_.push_back(local(constraint.coupling()));
        invariant_.push_back(is_invariant(constraint, constraints_.back()) ? 1 : 0);
    }
    left_out_.assign(static_cast<std::size_t>(problem.multipliers()), 0);
    for (const int equation : problem.left_out()) left_out_[static_cast<std::size_t>(equation)] = 1;
    for (const Support& support : model.supports()) driven_ = driven_ || support.value;
}

template <class Scene>
void EnergyMomentumSystem<Scene>::weigh() {
    const Scene& model = problem_.model();
    VectorX field = VectorX::Zero(numbering_.coordinates());
    for (int node = 0; node < model.layout().nodes(); ++node)
        if (model.layout().fields(node).contains(Field::r))
            field.template segment<Scene::dimension>(model.layout().first(node)) = model.gravity();
    gravity_ = problem_.assembly().mass_product(field);
    revision_ = model.revision();
}

template <class Scene>
typename EnergyMomentumSystem<Scene>::LocalLoad EnergyMomentumSystem<Scene>::local(
    const Coupling& coupling) const {
    LocalLoad result;
    for (const NodeField& at : coupling) {
        const int first = problem_.model().layout().index(at);
        for (int k = 0; k < Scene::dimension; ++k) result.at.push_back(first + k);
        result.power.push_back(length_power(at.field));
    }
    return result;
}

template <class Scene>
bool EnergyMomentumSystem<Scene>::is_invariant(const AnyConstraint& constraint,
                                               const LocalLoad& local) const {
    constexpr int dimension = Scene::dimension;
    using Point = Vector<double, dimension>;
    const State& state = problem_.model().state();
    const int equations = constraint.equations();
    ConstraintResult out;
    const auto value = [&](const VectorX& q) {
        ConstraintState at{q, VectorX::Zero(q.size()), VectorX::Zero(equations), state.time};
        out.reset(equations, q.size());
        constraint.evaluate(at, out);
        return out.violation;
    };
    // two finite turns about different axes, each with a shift
    VectorX q;
    gather(state.q, local.at, q);
    const VectorX rest = value(q);
    for (int trial = 0; trial < 2; ++trial) {
        const Point shift = Point::Constant((0.3 + 0.4 * trial) * problem_.length_scale());
        Matrix<double, dimension> turn = Matrix<double, dimension>::Identity();
        const int a = trial;
        const int b = trial == 0 || dimension == 2 ? 1 - trial : 2;
        turn(a, a) = turn(b, b) = 0.8;
        turn(a, b) = -0.6;
        turn(b, a) = 0.6;
        VectorX moved = q;
        for (std::size_t k = 0; k < local.power.size(); ++k) {
            const int first = dimension * static_cast<int>(k);
            for (int i = 0; i < dimension; ++i) {
                moved[first + i] = local.power[k] > 0 ? shift[i] : 0.0;
                for (int j = 0; j < dimension; ++j) moved[first + i] += turn(i, j) * q[first + j];
            }
        }
        const VectorX change = value(moved) - rest;
        for (int e = 0; e < equations; ++e) {
            double size = 0.0;  // of the terms that cancel
            for (Eigen::Index j = 0; j < moved.size(); ++j)
                size += std::abs(out.jacobian(e, j) * moved[j]);
            if (!(std::abs(change[e]) <= 1e-10 * size)) return false;
        }
    }
    return true;
}

template <class Scene>
void EnergyMomentumSystem<Scene>::begin(double t0, double h, const VectorX& q0, const VectorX& v0) {
    t0_ = t0;
    h_ = h;
    q0_ = q0;
    v0_ = v0;
    problem_.refresh();
    if (!(problem_.model().revision() == revision_)) weigh();
    std::size_t index = 0;
    problem_.assembly().for_each_element([&](const auto& element, const int* at, const auto&) {
        typename std::decay_t<decltype(element)>::Coordinates e;
        for (int i = 0; i < e.size(); ++i) e[i] = q0_[at[i]];
        before_[index++] = element.energy(e);
    });
}

template <class Scene>
bool EnergyMomentumSystem<Scene>::evaluate(const VectorX& q1, const VectorX& v1,
                                           const VectorX& lambda, bool matrix, VectorX& rhs) {
    middle_ = 0.5 * (q0_ + q1);
    change_ = q1 - q0_;
    force_.setZero(q1.size());
    violation_.setZero(problem_.multipliers());
    if (matrix) std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    add_elements(q1, matrix);
    add_loads(q1, matrix);
    add_constraints(q1, lambda, matrix);
    if (matrix)
        for (Eigen::Index k = 0; k < matrix_.nonZeros(); ++k)
            matrix_.valuePtr()[k] += problem_.mass().valuePtr()[k];
    add_inertia(v1);
    VectorX free;
    numbering_.gather_free(force_, free);
    rhs.resize(numbering_.unknowns());
    rhs.head(problem_.size()) = -0.5 * h_ * h_ * free;
    rhs.tail(problem_.multipliers()) = -violation_;
    return rhs.allFinite();
}

template <class Scene>
void EnergyMomentumSystem<Scene>::add_inertia(const VectorX& v1) {
    const VectorX mean = (v1 - v0_) / h_;
    if (driven_) {
        force_ += problem_.assembly().mass_product(mean);
        return;
    }
    VectorX free;
    numbering_.gather_free(mean, free);
    numbering_.add_free(multiply(problem_.compact_mass(), Storage::full, free), 1.0, force_);
}

template <class Scene>
void EnergyMomentumSystem<Scene>::add_elements(const VectorX& q1, bool matrix) {
    std::size_t index = 0;
    problem_.assembly().for_each_element([&](const auto& element, const int* at, const auto& add) {
        typename std::decay_t<decltype(element)>::Coordinates e0, e1;
        for (int i = 0; i < e0.size(); ++i) {
            e0[i] = q0_[at[i]];
            e1[i] = q1[at[i]];
        }
        auto step =
            step_force(element, e0, e1, before_[index], matrix ? tangent_ : StepTangent::none);
        ++index;
        for (int i = 0; i < e0.size(); ++i) force_[at[i]] += step.force[i];
        if (!matrix) return;
        step.tangent *= 0.5 * h_ * h_;
        add(step.tangent, matrix_);
    });
}

template <class Scene>
void EnergyMomentumSystem<Scene>::add_loads(const VectorX& q1, bool matrix) {
    const Scene& model = problem_.model();
    const Instant middle{t0_ + 0.5 * h_, 1.0};
    force_ -= model.gravity_scale(middle) * gravity_;
    const auto evaluate = [&](const ScaledLoad& load, const VectorX& q, const VectorX& v) {
        const Eigen::Index size = q.size();
        LoadResult out{VectorX::Zero(size), MatrixX::Zero(size, size), MatrixX::Zero(size, size),
                       0.0};
        load.load.evaluate({q, v, middle.time}, out);
        return out;
    };
    for (std::size_t k = 0; k < loads_.size(); ++k) {
        const ScaledLoad& load = model.loads()[k];
        const LocalLoad& place = loads_[k];
        VectorX change, middle_q, end;
        gather(change_, place.at, change);
        gather(middle_, place.at, middle_q);
        const VectorX rate = change / h_;
        LoadResult result = evaluate(load, middle_q, rate);
        if (result.potential != 0.0 || result.period > 0.0) {
            // a conservative load does the work by which its potential falls
            gather(q1, place.at, end);
            const double later = evaluate(load, end, rate).potential;
            gather(q0_, place.at, end);
            const double earlier = evaluate(load, end, rate).potential;
            const double work = result.force.dot(change);
            double fall = earlier - later;
            if (result.period > 0.0)  // an angle that passes pi
                fall -= result.period * std::round((fall - work) / result.period);
            if (std::abs(fall - work) > 1e-14 * (std::abs(earlier) + std::abs(later)))
                correct_gradient<Scene::dimension>(
                    fall, middle_q, change, false,
                    [&](int i) { return place.power[static_cast<std::size_t>(i)]; }, length_,
                    result.force);
        }
        const double scale = load.scale(middle);
        for (std::size_t i = 0; i < place.at.size(); ++i)
            force_[place.at[i]] -= scale * result.force[static_cast<Eigen::Index>(i)];
        if (!matrix) continue;
        add_block(place.at, result.stiffness, -0.25 * h_ * h_ * scale);
        add_block(place.at, result.damping, -0.5 * h_ * scale);
    }
}

/// Evaluates a constraint at the middle and at the end of the step; the Jacobian at the middle is
/// replaced by the discrete gradients. Rows of equations that are left out are zero.
template <class Scene>
void EnergyMomentumSystem<Scene>::evaluate_constraint(std::size_t k, int first, const VectorX& q1,
                                                      const VectorX& lambda,
                                                      ConstraintResult& middle,
                                                      ConstraintResult& end) const {
    const AnyConstraint& constraint = problem_.model().constraints()[k];
    const LocalLoad& place = constraints_[k];
    const int equations = constraint.equations();
    const auto size = static_cast<Eigen::Index>(place.at.size());
    ConstraintState state;
    state.v.setZero(size);
    state.multipliers = lambda.segment(first, equations);
    const auto evaluate = [&](double time, const VectorX& q, ConstraintResult& out) {
        state.time = time;
        gather(q, place.at, state.q);
        out.reset(equations, size);
        constraint.evaluate(state, out);
    };
    // of the change of g that the coordinates make, at one time
    const double middle_time = t0_ + 0.5 * h_;
    evaluate(middle_time, q0_, middle);
    const VectorX before = middle.violation;
    evaluate(middle_time, q1, end);
    const VectorX difference = end.violation - before;
    evaluate(middle_time, middle_, middle);
    evaluate(t0_ + h_, q1, end);
    VectorX change, middle_q, gradient(size);
    gather(change_, place.at, change);
    gather(middle_, place.at, middle_q);
    for (int i = 0; i < equations; ++i) {
        if (is_left_out(first + i)) {
            middle.jacobian.row(i).setZero();
            end.jacobian.row(i).setZero();
            continue;
        }
        double size_of_terms = 0.0;
        for (Eigen::Index j = 0; j < size; ++j) {
            gradient[j] = middle.jacobian(i, j);
            size_of_terms += std::abs(gradient[j] * middle_q[j]);
        }
        const double rest = difference[i] - gradient.dot(change);
        if (!(std::abs(rest) > 1e-15 * size_of_terms)) continue;
        correct_gradient<Scene::dimension>(
            difference[i], middle_q, change, invariant_[k] != 0,
            [&](int j) { return place.power[static_cast<std::size_t>(j)]; }, length_, gradient);
        for (Eigen::Index j = 0; j < size; ++j) middle.jacobian(i, j) = gradient[j];
    }
}

template <class Scene>
void EnergyMomentumSystem<Scene>::add_constraints(const VectorX& q1, const VectorX& lambda,
                                                  bool matrix) {
    int first = 0;
    ConstraintResult middle, end;
    for (std::size_t k = 0; k < constraints_.size(); ++k) {
        const std::vector<int>& at = constraints_[k].at;
        evaluate_constraint(k, first, q1, lambda, middle, end);
        const auto equations = static_cast<int>(end.violation.size());
        for (std::size_t j = 0; j < at.size(); ++j)
            for (int i = 0; i < equations; ++i)
                force_[at[j]] +=
                    middle.jacobian(i, static_cast<Eigen::Index>(j)) * lambda[first + i];
        for (int i = 0; i < equations; ++i)
            violation_[first + i] = is_left_out(first + i) ? lambda[first + i] : end.violation[i];
        if (matrix) {
            add_block(at, middle.stiffness, 0.25 * h_ * h_);
            write_rows(static_cast<int>(k), at, end.jacobian, middle.jacobian, first);
        }
        first += equations;
    }
}

template <class Scene>
void EnergyMomentumSystem<Scene>::add_block(const std::vector<int>& at, const MatrixX& block,
                                            double scale) {
    double* values = matrix_.valuePtr();
    for (std::size_t j = 0; j < at.size(); ++j) {
        const int column = numbering_.equation(at[j]);
        if (column < 0) continue;
        const int b = numbering_.block(at[j]);
        const int offset = pattern_.column_offset(b, column - pattern_.first(b));
        for (std::size_t i = 0; i < at.size(); ++i) {
            const int row = numbering_.equation(at[i]);
            const double value = block(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            if (row < 0 || value == 0.0 || (pattern_.storage() == Storage::lower && row < column))
                continue;
            const int a = numbering_.block(at[i]);
            values[pattern_.base(a, b) + offset + row - pattern_.first(a)] += scale * value;
        }
    }
}

/// Adds G of the end in the rows of a constraint, G of the step in its columns.
template <class Scene>
void EnergyMomentumSystem<Scene>::write_rows(int constraint, const std::vector<int>& at,
                                             const MatrixX& end, const MatrixX& middle, int first) {
    double* values = matrix_.valuePtr();
    const int own = numbering_.constraint_block(constraint);
    for (std::size_t j = 0; j < at.size(); ++j) {
        const int equation = numbering_.equation(at[j]);
        if (equation < 0) continue;
        const int node = numbering_.block(at[j]);
        const int place = equation - pattern_.first(node);
        const int row = pattern_.base(own, node) + pattern_.column_offset(node, place);
        const int column = pattern_.base(node, own) + place;
        for (int i = 0; i < end.rows(); ++i) {
            values[row + i] += end(i, static_cast<Eigen::Index>(j));
            values[column + pattern_.column_offset(own, i)] +=
                middle(i, static_cast<Eigen::Index>(j));
        }
    }
    for (int i = 0; i < end.rows(); ++i)
        if (is_left_out(first + i))
            values[pattern_.base(own, own) + pattern_.column_offset(own, i) + i] = 1.0;
}

}  // namespace ancf::detail
