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
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

namespace ancf::detail {

/// One scene's step. Vectors q, v are of all coordinates.
class EnergyMomentumSystem {
public:
    explicit EnergyMomentumSystem(DynamicProblem& problem)
        : problem_(problem),
          numbering_(problem.numbering()),
          pattern_(problem.assembly().pattern()),
          tangent_(pattern_.storage() == Storage::full ? StepTangent::exact
                                                       : StepTangent::symmetric),
          matrix_(problem.mass()) {
        const Scene& model = problem.model();
        for_each_element([&](const ElementGroup& group, const ElementPlace& place) {
            const double length = group.length(group.prototype_of(place.element));
            length_ = before_.empty() ? length : std::min(length_, length);
            before_.push_back(0.0);
        });
        const Assembly& assembly = problem.assembly();
        for (const ScaledLoad& load : model.loads())
            add(load.load, assembly.load_coordinates(loads_.size()), loads_);
        for (const AnyConstraint& constraint : model.constraints())
            add(constraint, assembly.constraint_coordinates(constraints_.size()), constraints_);
        for (const Support& support : model.supports()) driven_ = driven_ || support.value;
    }

    /// Takes the start of a step; the supports at both ends are already in q0 and, later, in q1.
    void begin(double t0, double h, const VectorX& q0, const VectorX& v0) {
        t0_ = t0;
        h_ = h;
        q0_ = q0;
        v0_ = v0;
        problem_.refresh();
        std::size_t index = 0;
        for_each_element([&](const ElementGroup& group, const ElementPlace& place) {
            double e[ElementGroup::max_dofs];
            problem_.assembly().gather_element(place, q0_, e);
            before_[index++] = group.energy(group.prototype_of(place.element), e);
        });
    }

    /// Evaluates the residual at the later end and, where wanted, the matrix
    /// [M + h^2/4 K + h/2 D, G_d^T; G, 0] for (dq_1, h^2/2 dlambda).
    ///
    /// Written to rhs: -h^2/2 of the forces' residual, and -g(q_1, t_1).
    [[nodiscard]] bool evaluate(const VectorX& q1, const VectorX& v1, const VectorX& lambda,
                                bool matrix, VectorX& rhs) {
        middle_ = 0.5 * (q0_ + q1);
        change_ = q1 - q0_;
        force_.setZero(q1.size());
        violation_.setZero(problem_.multipliers());
        if (matrix) std::fill_n(matrix_.valuePtr(), detail::entries(matrix_), 0.0);
        add_elements(q1, matrix);
        add_loads(q1, matrix);
        add_constraints(q1, lambda, matrix);
        numbering_.dependence().carry(force_);
        if (matrix)
            for (Eigen::Index k = 0; k < detail::entries(matrix_); ++k)
                matrix_.valuePtr()[k] += problem_.mass().valuePtr()[k];
        add_inertia(v1);
        VectorX free;
        numbering_.gather_free(force_, free);
        rhs.resize(numbering_.unknowns());
        rhs.head(problem_.size()) = -0.5 * h_ * h_ * free;
        rhs.tail(problem_.multipliers()) = -violation_;
        return detail::all_finite(rhs);
    }

    [[nodiscard]] const SparseMatrix& matrix() const noexcept { return matrix_; }

    /// Returns the length of the shortest element, m.
    [[nodiscard]] double length() const noexcept { return length_; }

private:
    struct LocalLoad {
        const LocalCoordinates& at;
        List<int> power = {};    // of a length in each vector's unit
        bool invariant = false;  // rigid motions leave the potential, or g, as it is
    };

    // Calls visit(group, place of the element), element by element.
    template <class Visitor>
    void for_each_element(const Visitor& visit) const {
        const auto& groups = problem_.model().groups();
        for (std::size_t k = 0; k < groups.size(); ++k)
            for (int element = 0; element < groups[k]->size(); ++element)
                visit(*groups[k], ElementPlace{static_cast<int>(k), element});
    }

    template <class Acting>
    void add(const Acting& acting, const LocalCoordinates& coordinates,
             List<LocalLoad>& list) const {
        LocalLoad& local = list.emplace_back(LocalLoad{coordinates});
        for (const NodeField& at : acting.coupling()) local.power.push_back(length_power(at.field));
        local.invariant = is_invariant(acting, local);
    }

    /// Writes the values of some functions of local coordinates, and their gradients by rows.
    using Functions = std::function<void(const VectorX& q, VectorX& values, MatrixX& gradients)>;

    /// @param strain  of the state looked at: a spring at rest, of a length or an angle, shows
    ///                nothing.
    [[nodiscard]] bool is_invariant(const LocalLoad& local, double strain,
                                    const Functions& functions) const {
        const int dimension = problem_.model().dimension();
        VectorX q, rest, values;
        MatrixX gradients;
        gather(problem_.model().state().q, local.at.read(), q);
        for (Eigen::Index i = 0; i < q.size(); ++i)
            q[i] += strain * (q[i] + (local.power[i / dimension] == 0 ? std::cos(i) : 0.0));
        functions(q, rest, gradients);
        // two finite turns about different axes, each with a shift
        for (int trial = 0; trial < 2; ++trial) {
            const double shift = (0.3 + 0.4 * trial) * problem_.length_scale();
            Matrix<double, 3> turn = Matrix<double, 3>::Identity();
            const int a = trial;
            const int b = trial == 0 || dimension == 2 ? 1 - trial : 2;
            turn(a, a) = turn(b, b) = 0.8;
            turn(a, b) = -0.6;
            turn(b, a) = 0.6;
            VectorX moved = q;
            for (std::size_t k = 0; k < local.power.size(); ++k) {
                const int first = dimension * static_cast<int>(k);
                for (int i = 0; i < dimension; ++i) {
                    moved[first + i] = local.power[k] > 0 ? shift : 0.0;
                    for (int j = 0; j < dimension; ++j)
                        moved[first + i] += turn(i, j) * q[first + j];
                }
            }
            functions(moved, values, gradients);
            for (Eigen::Index e = 0; e < rest.size(); ++e) {
                double size = 0.0;  // of the terms that cancel
                for (Eigen::Index j = 0; j < moved.size(); ++j)
                    size += std::abs(gradients(e, j) * moved[j]);
                if (!(std::abs(values[e] - rest[e]) <= 1e-10 * size)) return false;
            }
        }
        return true;
    }

    /// Returns what a load gives in a local state.
    [[nodiscard]] static LoadResult result_of(const AnyLoad& load, const LoadState& state) {
        const Eigen::Index size = state.q.size();
        LoadResult out{VectorX::Zero(size), MatrixX::Zero(size, size), MatrixX::Zero(size, size)};
        load.evaluate(state, out);
        return out;
    }

    [[nodiscard]] bool is_invariant(const AnyLoad& load, const LocalLoad& local) const {
        const double time = problem_.model().state().time;
        if (load.constant()) return false;
        // a stop shows its potential where its points are nearer, a slack rope farther apart
        for (const double strain : {0.1, -0.5, -0.9, 9.0}) {
            bool shows = false;
            const bool found = is_invariant(
                local, strain, [&](const VectorX& q, VectorX& values, MatrixX& gradients) {
                    const LoadResult out =
                        result_of(load, {q, VectorX::Zero(q.size()), time, false});
                    const double none = std::numeric_limits<double>::quiet_NaN();
                    shows = shows || out.potential != 0.0;
                    values.setConstant(1, out.potential != 0.0 ? out.potential : none);
                    gradients = -out.force.transpose();
                });
            if (shows) return found;
        }
        return false;
    }

    [[nodiscard]] bool is_invariant(const AnyConstraint& constraint, const LocalLoad& local) const {
        const double time = problem_.model().state().time;
        const int equations = constraint.equations();
        ConstraintResult out;
        return is_invariant(local, 0.0, [&](const VectorX& q, VectorX& values, MatrixX& gradients) {
            constraint.evaluate({q, VectorX::Zero(q.size()), VectorX::Zero(equations), time}, out);
            values = out.violation;
            gradients = out.jacobian;
        });
    }

    void add_elements(const VectorX& q1, bool matrix) {
        std::size_t index = 0;
        for_each_element([&](const ElementGroup& group, const ElementPlace& place) {
            const int dofs = group.dofs();
            double e0[ElementGroup::max_dofs], e1[ElementGroup::max_dofs];
            int at[ElementGroup::max_dofs];
            problem_.assembly().element_coordinates(place, at);
            for (int i = 0; i < dofs; ++i) {
                e0[i] = q0_[at[i]];
                e1[i] = q1[at[i]];
            }
            step_force(group, group.prototype_of(place.element), e0, e1, before_[index++],
                       matrix ? tangent_ : StepTangent::none, step_);
            for (int i = 0; i < dofs; ++i) force_[at[i]] += step_.force[i];
            if (!matrix) return;
            for (int i = 0; i < dofs * dofs; ++i) step_.tangent[i] *= 0.5 * h_ * h_;
            problem_.assembly().add_block(place, step_.tangent, matrix_);
        });
    }

    void add_loads(const VectorX& q1, bool matrix) {
        const Scene& model = problem_.model();
        const Instant middle{t0_ + 0.5 * h_, 1.0};
        force_ -= model.gravity_scale(middle) * problem_.assembly().gravity_force();
        for (std::size_t k = 0; k < loads_.size(); ++k) {
            const ScaledLoad& load = model.loads()[k];
            const LocalLoad& place = loads_[k];
            VectorX change, middle_q, end;
            gather(change_, place.at.read(), change);
            gather(middle_, place.at.read(), middle_q);
            const VectorX rate = change / h_;
            LoadResult result = result_of(load.load, {middle_q, rate, middle.time, matrix});
            // a conservative load does the work by which its potential falls; the potential of a
            // one-sided load may be zero at the middle or at an end
            const bool shows = result.potential != 0.0 || result.period > 0.0;
            if (shows || (load.load.symmetric() && !load.load.constant())) {
                const auto potential = [&](const VectorX& q) {
                    gather(q, place.at.read(), end);
                    return result_of(load.load, {end, rate, middle.time, false}).potential;
                };
                const double later = potential(q1), earlier = potential(q0_);
                // what the rates make of its force, as in a spring with a damper, does its own work
                VectorX held =
                    result_of(load.load, {middle_q, VectorX::Zero(rate.size()), middle.time, false})
                        .force;
                const VectorX by_rates = result.force - held;
                const double work = held.dot(change);
                double fall = earlier - later;
                if (result.period > 0.0)  // an angle that passes pi
                    fall -= result.period * std::round((fall - work) / result.period);
                if ((shows || earlier != 0.0 || later != 0.0) &&
                    std::abs(fall - work) > 1e-14 * (std::abs(earlier) + std::abs(later))) {
                    correct_gradient(model.dimension(), fall, middle_q, change, place.invariant,
                                     place.power, length_, held);
                    result.force = held + by_rates;
                }
            }
            const double scale = load.scale(middle);
            const List<int>& read = place.at.read();
            for (std::size_t i = 0; i < read.size(); ++i)
                force_[read[i]] -= scale * result.force[i];
            if (!matrix) continue;
            place.at.carry(result.stiffness);
            place.at.carry(result.damping);
            const Assembly& assembly = problem_.assembly();
            assembly.add_matrix(place.at.acted(), -0.25 * h_ * h_ * scale, result.stiffness,
                                matrix_);
            assembly.add_matrix(place.at.acted(), -0.5 * h_ * scale, result.damping, matrix_);
        }
    }

    void add_constraints(const VectorX& q1, const VectorX& lambda, bool matrix) {
        int first = 0;
        ConstraintResult middle, end;
        for (std::size_t k = 0; k < constraints_.size(); ++k) {
            const LocalCoordinates& map = constraints_[k].at;
            const List<int>&read = map.read(), &at = map.acted();
            evaluate_constraint(k, first, q1, lambda, matrix, middle, end);
            const auto equations = static_cast<int>(end.violation.size());
            for (std::size_t j = 0; j < read.size(); ++j)
                for (int i = 0; i < equations; ++i)
                    force_[read[j]] += middle.jacobian(i, j) * lambda[first + i];
            for (int i = 0; i < equations; ++i)
                violation_[first + i] = problem_.constraints().left_out(first + i)
                                            ? lambda[first + i]
                                            : end.violation[i];
            if (matrix) {
                map.carry_columns(end.jacobian);
                map.carry_columns(middle.jacobian);
                const List<int>& stiff = map.carry(middle.stiffness, middle.active);
                problem_.assembly().add_matrix(stiff, 0.25 * h_ * h_, middle.stiffness, matrix_);
                write_rows(static_cast<int>(k), at, end.jacobian, middle.jacobian, first);
            }
            first += equations;
        }
    }

    /// Evaluates a constraint at the middle and at the end of the step; the Jacobian at the middle
    /// is replaced by the discrete gradients. Rows of equations that are left out are zero.
    void evaluate_constraint(std::size_t k, int first, const VectorX& q1, const VectorX& lambda,
                             bool stiffness, ConstraintResult& middle,
                             ConstraintResult& end) const {
        const AnyConstraint& constraint = problem_.model().constraints()[k];
        const LocalLoad& place = constraints_[k];
        const int equations = constraint.equations();
        const auto size = static_cast<Eigen::Index>(place.at.read().size());
        ConstraintState state;
        state.v.setZero(size);
        state.multipliers = lambda.segment(first, equations);
        const auto evaluate = [&](double time, const VectorX& q, ConstraintResult& out) {
            state.time = time;
            gather(q, place.at.read(), state.q);
            constraint.terms(state, out);
        };
        // of the change of g that the coordinates make, at one time
        const double middle_time = t0_ + 0.5 * h_;
        evaluate(middle_time, q0_, middle);
        const VectorX before = middle.violation;
        evaluate(middle_time, q1, end);
        const VectorX difference = end.violation - before;
        evaluate(middle_time, middle_, middle);
        if (stiffness) constraint.evaluate(state, middle);
        evaluate(t0_ + h_, q1, end);
        VectorX change, middle_q, gradient(size);
        gather(change_, place.at.read(), change);
        gather(middle_, place.at.read(), middle_q);
        for (int i = 0; i < equations; ++i) {
            if (problem_.constraints().left_out(first + i)) {
                for (Eigen::Index j = 0; j < size; ++j)
                    middle.jacobian(i, j) = end.jacobian(i, j) = 0.0;
                continue;
            }
            double size_of_terms = 0.0;
            for (Eigen::Index j = 0; j < size; ++j) {
                gradient[j] = middle.jacobian(i, j);
                size_of_terms += std::abs(gradient[j] * middle_q[j]);
            }
            const double rest = difference[i] - gradient.dot(change);
            if (!(std::abs(rest) > 1e-15 * size_of_terms)) continue;
            correct_gradient(problem_.model().dimension(), difference[i], middle_q, change,
                             place.invariant, place.power, length_, gradient);
            for (Eigen::Index j = 0; j < size; ++j) middle.jacobian(i, j) = gradient[j];
        }
    }

    void add_inertia(const VectorX& v1) {
        const VectorX mean = (v1 - v0_) / h_;
        if (driven_) {
            force_ += problem_.assembly().mass_product(mean);
            return;
        }
        VectorX free;
        numbering_.gather_free(mean, free);
        numbering_.add_free_force(multiply(problem_.compact_mass(), Storage::full, free), 1.0,
                                  force_);
    }

    /// Adds G of the end in the rows of a constraint, G of the step in its columns.
    void write_rows(int constraint, const List<int>& at, const MatrixX& end, const MatrixX& middle,
                    int first) {
        double* const values = matrix_.valuePtr();
        problem_.assembly().visit_border(constraint, at,
                                         [&](int i, int j, int place, int mirrored) {
                                             values[place] += end(i, j);
                                             values[mirrored] += middle(i, j);
                                         });
        const int own = numbering_.constraint_block(constraint);
        for (int i = 0; i < end.rows(); ++i)
            if (problem_.constraints().left_out(first + i))
                values[pattern_.base(own, own) + pattern_.column_offset(own, i) + i] = 1.0;
    }

    DynamicProblem& problem_;
    const Numbering& numbering_;
    const BlockPattern& pattern_;
    StepTangent tangent_;
    List<LocalLoad> loads_, constraints_;
    double length_ = 1.0;  // of an element: the weight of slopes in joints and loads
    bool driven_ = false;

    double t0_ = 0.0, h_ = 0.0;
    VectorX q0_, v0_, middle_, change_;
    List<double> before_;  // strain energies of the elements at the start
    StepForce step_;       // of one element after the other
    VectorX force_;        // of all coordinates, inertia aside
    VectorX violation_;
    SparseMatrix matrix_;
};

}  // namespace ancf::detail
