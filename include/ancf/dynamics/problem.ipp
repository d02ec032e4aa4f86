// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/frequency.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/convergence.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/redundancy.hpp>

#include <cstddef>
#include <limits>
#include <utility>

namespace ancf {

ANCF_INLINE DynamicProblem::DynamicProblem(Scene& model, const ProblemOptions& options)
    : model_(model),
      exchange_(model.exchange()),
      options_(options),
      assembly_(model, options.storage),
      revision_(model.revision()),
      constraints_(assembly_) {
    options_.check();
    check_sizes();
    list_driven();
    detail::require((exchange_ == nullptr) == (options_.mass_solver == nullptr),
                    "ProblemOptions: a part of a scene needs a mass_solver, a whole scene none");
    detail::require(exchange_ == nullptr || exchange_->constraints().empty(),
                    "DynamicProblem: a part of a scene moves without constraints");
    full_q_ = model.state().q;
    full_v_.setZero(full_q_.size());
    full_a_.setZero(full_q_.size());
    measure();
    if (exchange_ != nullptr) options_.mass_solver->analyze(assembly_.pattern().matrix());
    set_mass();
    if (exchange_ == nullptr)
        kkt_.analyze(kkt_matrix_, size(), detail::blocks_of(numbering(), numbering().unknowns()));
}

ANCF_INLINE DynamicProblem::~DynamicProblem() = default;

ANCF_INLINE void DynamicProblem::add_parts(VectorX& forces) const {
    if (exchange_ == nullptr) return;
    VectorX all = VectorX::Zero(numbering().coordinates());
    numbering().add_free_force(forces, 1.0, all);
    exchange_->add(all);
    numbering().gather_free(all, forces);
}

ANCF_INLINE double DynamicProblem::own_dot(const VectorX& x, const VectorX& y) const {
    if (exchange_ == nullptr) return x.dot(y);
    double sum = 0.0;
    for (Eigen::Index k = 0; k < x.size(); ++k)
        if (exchange_->owns(static_cast<int>(k))) sum += x[k] * y[k];
    return sum;
}

ANCF_INLINE void DynamicProblem::solve_mass(const VectorX& b, VectorX& x) const {
    detail::require(b.size() == size(), "DynamicProblem::solve_mass: expected ", size(),
                    " entries, got ", b.size());
    if (exchange_ != nullptr) return detail::solve_with(*options_.mass_solver, b, x);
    x = b;
    mass_factor_.solve(x);
}

ANCF_INLINE void DynamicProblem::check_multipliers(const VectorX& lambda) const {
    detail::require(lambda.size() == multipliers(), "DynamicProblem: expected ", multipliers(),
                    " multipliers, got ", lambda.size());
}

ANCF_INLINE void DynamicProblem::set_mass() {
    mass_ = assembly_.mass();
    compact_mass_ = detail::leading_block(mass_, size(), options_.storage);
    bool definite =
        exchange_ != nullptr
            ? options_.mass_solver->factorize(mass_).status == Status::converged
            : mass_factor_.factorize(compact_mass_, detail::blocks_of(numbering(), size()));
    if (exchange_ == nullptr)
        for (int row = 0; definite && row < size(); ++row) definite = mass_factor_.pivot(row) > 0.0;
    detail::require(definite,
                    "DynamicProblem: the mass matrix is not positive definite; every node needs an "
                    "element of positive density");
    if (exchange_ == nullptr) kkt_matrix_ = mass_;
}

ANCF_INLINE void DynamicProblem::refresh() {
    if (model_.revision() == revision_) return;
    assembly_.refresh();
    set_mass();
    revision_ = model_.revision();
}

ANCF_INLINE void DynamicProblem::list_driven() {
    detail::together(exchange_, [&] {
        for (const Support& support : model_.supports()) {
            if (!support.value) continue;
            detail::require(
                static_cast<bool>(support.rate) && static_cast<bool>(support.acceleration),
                "DynamicProblem: the support of ", to_string(support.field), ", component ",
                support.component, ", of node ", support.node.index,
                " has a value over time; dynamics needs its rate and acceleration too");
            driven_.push_back(
                {model_.coordinate(support.node, support.field) + support.component, &support});
        }
    });
    drives_ = largest_of_parts(driven_.empty() ? 0.0 : 1.0) > 0.0;
}

ANCF_INLINE void DynamicProblem::measure() {
    double length = detail::diagonal_of(model_.layout(), model_.dimension(), full_q_, exchange_);
    if (!std::isfinite(length)) length = 0.0;
    for (const auto& group : model_.groups())
        for (int k = 0; k < group->prototype_count(); ++k)
            length = std::max(length, group->length(k));
    set_length_scale(length > 0.0 ? length : 1.0);
}

ANCF_INLINE void DynamicProblem::set_length_scale(double length) {
    detail::require_positive("DynamicProblem: length scale", length);
    length_ = length;
    full_scales_ = scales_of(length);
    numbering().gather_free(full_scales_, scales_);
}

ANCF_INLINE VectorX DynamicProblem::scales_of(double length) const {
    const Layout& layout = model_.layout();
    const double scale_of[] = {1.0 / length, 1.0, length};  // r_xx, slopes, positions
    VectorX scales(layout.size());
    for (int k = 0; k < layout.size(); ++k)
        scales[k] = scale_of[length_power(layout.field_of(k)) + 1];
    return scales;
}

ANCF_INLINE void DynamicProblem::expand(double t, const VectorX& q, const VectorX& v) {
    refresh();
    const Numbering& numbers = numbering();
    detail::require(q.size() == size() && v.size() == size(), "DynamicProblem: expected ", size(),
                    " free coordinates and rates, got ", q.size(), " and ", v.size());
    time_ = t;
    numbers.set_free(q, full_q_);
    numbers.set_free(v, full_v_);
    for (const Driven& driven : driven_) {
        const double rate = driven.support->rate(t);
        const double acceleration = driven.support->acceleration(t);
        // one that is not finite ends a run as such a value does
        const bool finite = std::isfinite(rate) && std::isfinite(acceleration);
        full_q_[driven.coordinate] = finite ? driven.support->value(t) : rate + acceleration;
        full_v_[driven.coordinate] = rate;
        full_a_[driven.coordinate] = acceleration;
    }
    const Dependence& dependence = numbers.dependence();
    for (VectorX* const full : {&full_q_, &full_v_, &full_a_}) dependence.complete(*full);
}

ANCF_INLINE std::string DynamicProblem::check_supports(double t, double fastest) const {
    const State& state = model_.state();
    for (const Support& support : model_.supports()) {
        const int at = model_.coordinate(support.node, support.field) + support.component;
        const double value = support.value ? support.value(t) : state.q[at];
        const double gap = std::abs(state.q[at] - value);
        const double rate = support.value ? 0.0 : std::abs(state.v[at]);
        const double allowed = options_.consistency * full_scales_[at];
        if (gap <= allowed && rate <= fastest * allowed) continue;
        const std::string which =
            detail::joined({"the support of ", to_string(support.field), ", component ",
                            support.component, ", of node ", support.node.index});
        if (!(gap <= allowed))
            return detail::joined(
                {which, " prescribes ", value, " at the start, the state has ", state.q[at]});
        return detail::joined({which, " holds it, the state moves it at ", state.v[at]});
    }
    return {};
}

ANCF_INLINE std::string DynamicProblem::check_constraints() {
    constraints_.evaluate(time_, full_q_, full_v_);
    const VectorX lengths = constraints_.magnitude(full_scales_);
    for (int i = 0; i < multipliers(); ++i)
        if (!std::isfinite(lengths[i]) || !std::isfinite(constraints_.violation()[i]) ||
            !std::isfinite(constraints_.rate()[i]))
            return "no direction belongs to " + constraints_.describe(i) +
                   ": it or its derivatives are not finite, do points or directions coincide?";
    const double fastest = detail::largest_ratio(full_v_, full_scales_);
    // worst equation, at position and then at velocity level
    const auto worst = [&](const VectorX& values, const auto& allowed, const char* what) {
        int at = -1;
        double ratio = 1.0;
        for (int i = 0; i < values.size(); ++i) {
            const double limit = options_.consistency * allowed(i);
            const double size = std::abs(values[i]);
            if (size <= limit || (limit > 0.0 && size / limit <= ratio)) continue;
            at = i;
            if (limit > 0.0) ratio = size / limit;
        }
        if (at < 0) return std::string();
        return detail::joined({constraints_.describe(at), ": |", what, "| = ", std::abs(values[at]),
                               ", allowed ", options_.consistency * allowed(at)});
    };
    std::string message = worst(
        constraints_.violation(), [&](int i) { return lengths[i]; }, "g");
    if (!message.empty()) return "the initial coordinates violate " + message;
    const VectorX slide = constraints_.product(full_v_);
    message = worst(
        constraints_.rate(),
        [&](int i) { return lengths[i] * fastest + std::abs(constraints_.rate()[i] - slide[i]); },
        "G v + g_t");
    if (message.empty()) return message;
    return "the initial rates violate " + message +
           "; give the nodes rates that fit by set_rate or set_rigid_rates, or a drive that starts "
           "from rest";
}

ANCF_INLINE void DynamicProblem::find_redundant(Start& start) {
    left_out_.clear();
    constraints_.leave_out(left_out_);
    if (multipliers() == 0) return;
    constraints_.write_jacobian(kkt_matrix_);
    const List<int> dependent =
        detail::dependent_rows(kkt_matrix_, size(), scales_, options_.redundancy_tolerance);
    if (dependent.empty()) return;
    if (options_.redundancy == Redundancy::minimum_norm) {
        left_out_ = dependent;
        constraints_.leave_out(left_out_);
        return;
    }
    start.status = Status::redundant;
    start.message = "these follow from the equations before them: ";
    for (std::size_t k = 0; k < dependent.size(); ++k)
        start.message += (k == 0 ? "" : "; ") + constraints_.describe(dependent[k]);
    start.message += "; ProblemOptions::redundancy can leave them out";
}

ANCF_INLINE void DynamicProblem::check_sizes() const {
    const State& state = model_.state();
    const int size = model_.layout().size();
    detail::require(state.q.size() == size && state.v.size() == size,
                    "DynamicProblem: the model has ", size, " coordinates, its state ",
                    state.q.size(), " and ", state.v.size(), " rates");
}

/// Checks the state of this part against its supports, and takes it over.
ANCF_INLINE void DynamicProblem::check_state(double fastest, Start& start) {
    const State& state = model_.state();
    const auto refuse = [&](Status status, std::string message) {
        start.status = status;
        start.message = std::move(message);
    };
    if (!detail::all_finite(state.q) || !detail::all_finite(state.v))
        return refuse(Status::not_finite, "the initial state is not finite");
    if (const auto fault = assembly_.inspect(state.q))
        return refuse(fault->status, assembly_.describe(*fault) + " at the start");
    std::string message = check_supports(state.time, fastest);
    if (!message.empty()) return refuse(Status::inconsistent, std::move(message));
    expand(state.time, start.q, start.v);
}

ANCF_INLINE Start DynamicProblem::start() {
    refresh();
    check_sizes();
    const State& state = model_.state();
    Start start;
    start.time = state.time;
    numbering().gather_free(state.q, start.q);
    numbering().gather_free(state.v, start.v);
    start.acceleration.setZero(size());
    start.multipliers.setZero(multipliers());
    angles_.resize(0);
    full_q_ = state.q;
    full_v_.setZero(state.v.size());
    full_a_.setZero(state.v.size());

    const double fastest = largest_of_parts(detail::largest_ratio(state.v, full_scales_));
    const auto check = [&] {
        check_state(fastest, start);
        return static_cast<double>(start.status);
    };
    const double worst = exchange_ == nullptr ? check() : detail::largest_of(*exchange_, check);
    if (worst != static_cast<double>(start.status)) start.message.clear();  // another part has it
    start.status = static_cast<Status>(static_cast<int>(worst));
    if (start.status != Status::converged) return start;
    left_out_.clear();
    constraints_.leave_out(left_out_);
    start.message = check_constraints();
    if (!start.message.empty()) start.status = Status::inconsistent;
    if (start.status == Status::converged) find_redundant(start);
    if (start.status != Status::converged) return start;

    start.status =
        accelerations(state.time, start.q, start.v, start.acceleration, start.multipliers);
    if (start.status == Status::converged) return start;
    start.message = "the initial accelerations could not be solved for: " +
                    std::string(to_string(start.status));
    if (start.status == Status::not_finite && exchange_ == nullptr)
        if (const auto fault = evaluate(start.time, start.q, start.v, VectorX::Zero(multipliers()),
                                        Request::force))
            start.message += "; " + assembly_.describe(*fault);
    if (exchange_ != nullptr && !options_.mass_solver->failure().empty())
        start.message += "; " + options_.mass_solver->failure();
    return start;
}

ANCF_INLINE Status DynamicProblem::solve_kkt(const VectorX& b, VectorX& x) {
    if (exchange_ != nullptr) {
        solve_mass(b, x);
        const bool finite = largest_of_parts(detail::all_finite(x) ? 0.0 : 1.0) == 0.0;
        return finite ? Status::converged : Status::not_finite;
    }
    if (!detail::all_finite(b)) return Status::not_finite;
    const Status status = kkt_.solve(b, x);
    return detail::all_finite(x) ? status : Status::not_finite;
}

ANCF_INLINE Status DynamicProblem::accelerations(double t, const VectorX& q, const VectorX& v,
                                                 VectorX& acceleration, VectorX& multipliers) {
    const VectorX none = VectorX::Zero(this->multipliers());
    if (const auto fault = evaluate(t, q, v, none, Request::force)) return fault->status;
    constraints_.evaluate(t, full_q_, full_v_);
    if (const Status status = factorize_kkt(); status != Status::converged) return status;
    // held coordinates only: the free ones are unknown
    VectorX b(numbering().unknowns()), x;
    const VectorX known = constraints_.product(full_a_);
    for (int i = 0; i < size(); ++i) b[i] = -force_[i];
    for (int i = 0; i < known.size(); ++i) b[size() + i] = -constraints_.convection()[i] - known[i];
    if (const Status status = solve_kkt(b, x); status != Status::converged) return status;
    acceleration = x.head(size());
    multipliers = x.tail(this->multipliers());
    return Status::converged;
}

ANCF_INLINE Status DynamicProblem::jerk(const Start& at, double step, VectorX& jerk) {
    if (const auto fault =
            evaluate(at.time, at.q, at.v, at.multipliers, Request::tangent_and_damping))
        return fault->status;
    VectorX b = VectorX::Zero(numbering().unknowns());
    VectorX sum = VectorX::Zero(size());
    detail::add_product(tangent(), options_.storage, -1.0, at.v, sum);
    detail::add_product(damping(), options_.storage, -1.0, at.acceleration, sum);
    add_parts(sum);
    std::copy(sum.data(), sum.data() + size(), b.data());
    VectorX whole = VectorX::Zero(full_a_.size());
    // one-sided: a load may begin at the start, and no function of time is asked for earlier
    constexpr double weights[] = {-1.5, 2.0, -0.5};
    VectorX values[3];  // of r, and of what d2g/dt2 has besides G v'
    for (int place = 0; place < 3; ++place) {
        const double later = place * step;
        const double t = at.time + later;
        if (const auto fault = evaluate(t, at.q, at.v, at.multipliers, Request::force))
            return fault->status;
        values[place].resize(b.size());
        for (int i = 0; i < size(); ++i) values[place][i] = force_[i];
        if (multipliers() == 0) continue;
        VectorX q = at.q, v = at.v;
        for (int i = 0; i < size(); ++i) {
            q[i] = at.q[i] + later * at.v[i] + 0.5 * later * later * at.acceleration[i];
            v[i] += later * at.acceleration[i];
        }
        evaluate_constraints(t, q, v);
        whole = full_a_;  // of driven coordinates at that time
        numbering().set_free(at.acceleration, whole);
        numbering().dependence().complete(whole);
        const VectorX known = constraints_.product(whole);
        for (int i = 0; i < multipliers(); ++i)
            values[place][size() + i] = known[i] + constraints_.convection()[i];
    }
    for (Eigen::Index i = 0; i < b.size(); ++i) {
        const double change = values[1][i] - values[0][i], next = values[2][i] - values[1][i];
        const double least = std::min(std::abs(change), std::abs(next));
        // of a function t^n they differ by the factor 2^n - 1, of one that jumps by far more, as of
        // a load that is zero at the start itself: there the change without the jump counts
        if (20.0 * least < std::max(std::abs(change), std::abs(next)))
            b[i] -= (std::abs(change) == least ? change : next) / step;
        else
            for (int place = 0; place < 3; ++place)
                b[i] -= weights[place] / step * values[place][i];
    }
    evaluate_constraints(at.time, at.q, at.v, false);
    if (const Status status = factorize_kkt(); status != Status::converged) return status;
    VectorX x;
    if (const Status status = solve_kkt(b, x); status != Status::converged) return status;
    jerk = x.head(size());
    return Status::converged;
}

ANCF_INLINE std::optional<Fault> DynamicProblem::force_curvature(const Start& at, double distance,
                                                                 VectorX& curvature) {
    if (auto fault = evaluate(at.time, at.q, at.v, at.multipliers, Request::tangent)) return fault;
    curvature.setZero(size());
    detail::add_product(tangent(), options_.storage, 1.0, at.acceleration, curvature);
    const auto add_forces = [&](double weight) {
        for (int k = 0; k < numbering().coordinates(); ++k)
            if (const int equation = numbering().equation(k); equation >= 0)
                curvature[equation] += weight / (distance * distance) * assembly_.unbalanced(k);
    };
    add_forces(-2.0);
    for (const double later : {distance, -distance}) {
        VectorX q = full_q_;
        for (Eigen::Index k = 0; k < q.size(); ++k)
            q[k] = q[k] + later * full_v_[k] + 0.5 * later * later * full_a_[k];
        if (auto fault = assembly_.evaluate({q, full_v_, lambda_, {at.time, 1.0}}, Request::force))
            return fault;
        add_forces(1.0);
    }
    return {};
}

ANCF_INLINE std::optional<Fault> DynamicProblem::evaluate(double t, const VectorX& q,
                                                          const VectorX& v, const VectorX& lambda,
                                                          Request request) {
    refresh();
    detail::together(drives_ ? exchange_ : nullptr, [&] { expand(t, q, v); });
    check_multipliers(lambda);
    lambda_ = lambda;
    for (const int equation : left_out_) lambda_[equation] = 0.0;
    const auto fault = assembly_.evaluate({full_q_, full_v_, lambda_, {t, 1.0}}, request);
    force_.resize(size());
    for (int k = 0; k < numbering().coordinates(); ++k)
        if (const int equation = numbering().equation(k); equation >= 0)
            force_[equation] = assembly_.unbalanced(k);
    if (drives_) {
        VectorX inertia;
        numbering().gather_free(assembly_.mass_product(full_a_), inertia);
        force_ += inertia;
    }
    constraint_residual_ = assembly_.violation();
    for (const int equation : left_out_) constraint_residual_[equation] = lambda[equation];
    if (request != Request::force && !left_out_.empty()) {
        tangent_ = assembly_.tangent();
        constraints_.evaluate(t, full_q_, full_v_);
        constraints_.write_jacobian(tangent_);
    }
    return fault;
}

ANCF_INLINE Energies DynamicProblem::energies(double t, const VectorX& q, const VectorX& v,
                                              const VectorX& lambda) {
    (void)evaluate(t, q, v, lambda, Request::force);  // NaN energies tell of a fault
    Energies result = energies();
    const auto& found = assembly_.angle_potentials();
    const auto count = static_cast<Eigen::Index>(found.size());
    const bool first = angles_.size() != count;
    if (first) angles_.setZero(count);
    double further = 0.0;
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto& [scale, value, period] = found[k];
        const double turns = first ? 0.0 : std::round((angles_[k] - value) / period);
        if (std::isfinite(turns)) angles_[k] = value + turns * period;
        further += scale * turns * period;
    }
    result.potential += sum_of_parts(further);
    return result;
}

ANCF_INLINE Energies DynamicProblem::energies() const {
    detail::require(assembly_.external_force().size() == full_v_.size(),
                    "DynamicProblem: energies() follows an evaluation, and there was none");
    Energies result;
    result.strain = assembly_.strain_energy();
    result.potential = assembly_.load_potential();
    result.load_power = own_dot(assembly_.external_force(), full_v_);
    result.constraint_power = lambda_.dot(assembly_.violation_rate());
    if (drives_) {
        result.kinetic = 0.5 * own_dot(full_v_, assembly_.mass_product(full_v_));
        result.constraint_power += driving_power();
    } else {
        VectorX v;
        numbering().gather_free(full_v_, v);
        result.kinetic = 0.5 * v.dot(detail::multiply(compact_mass_, Storage::full, v));
    }
    if (exchange_ == nullptr) return result;
    double sums[3] = {result.kinetic, result.load_power, result.constraint_power};
    exchange_->sum(sums, 3);
    result.kinetic = sums[0];
    result.load_power = sums[1];
    result.constraint_power = sums[2];
    return result;
}

/// Returns the power of the supports that drive coordinates of this part, W.
ANCF_INLINE double DynamicProblem::driving_power() const {
    VectorX acceleration = full_a_;
    VectorX change;
    solve_mass(force_, change);
    numbering().add_free(change, -1.0, acceleration);
    const VectorX inertia = assembly_.mass_product(acceleration);
    double power = 0.0;
    for (const Driven& driven : driven_) {
        const int k = driven.coordinate;
        if (exchange_ == nullptr || exchange_->owns(k))
            power += full_v_[k] * (inertia[k] + assembly_.internal_force()[k] +
                                   assembly_.constraint_force()[k] - assembly_.external_force()[k]);
    }
    return power;
}

ANCF_INLINE void DynamicProblem::evaluate_constraints(double t, const List<int>& active,
                                                      const VectorX& q) {
    time_ = t;
    full_v_.setZero();
    for (std::size_t j = 0; j < active.size(); ++j) full_q_[active[j]] = q[j];
    if (!driven_.empty() || !numbering().dependence().empty()) {
        VectorX free;
        numbering().gather_free(full_q_, free);
        expand(t, free, VectorX::Zero(size()));
    }
    constraints_.evaluate(t, full_q_, full_v_, false);
}

ANCF_INLINE bool DynamicProblem::project(double t, VectorX& q, VectorX& v) {
    if (multipliers() == 0) return true;
    VectorX moved = q;
    VectorX slowed = v;
    if (!project_positions(t, moved, v) || !project_rates(t, moved, slowed)) return false;
    q = std::move(moved);
    v = std::move(slowed);
    return true;
}

ANCF_INLINE bool DynamicProblem::project_positions(double t, VectorX& q, const VectorX& v) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    VectorX b = VectorX::Zero(numbering().unknowns());
    VectorX x;
    double before = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < 20; ++iteration) {
        evaluate_constraints(t, q, v, false);
        double relative = 0.0;
        const VectorX scale = constraints_.magnitude(full_scales_);
        for (int i = 0; i < multipliers(); ++i) {
            const bool out = constraints_.left_out(i);
            b[size() + i] = out ? 0.0 : -constraints_.violation()[i];
            if (!out && scale[i] > 0.0)
                relative = std::max(relative, std::abs(constraints_.violation()[i]) / scale[i]);
        }
        if (relative <= epsilon) return true;
        // round-off may lie a little higher: stop when the iteration no longer gains
        if (relative >= 0.5 * before) return relative <= 64.0 * epsilon;
        before = relative;
        if (factorize_kkt() != Status::converged) return false;
        if (solve_kkt(b, x) != Status::converged) return false;
        q += x.head(size());
    }
    return false;
}

ANCF_INLINE bool DynamicProblem::project_rates(double t, const VectorX& q, VectorX& v, int passes) {
    VectorX b = VectorX::Zero(numbering().unknowns());
    VectorX x;
    for (int pass = 0; pass < passes; ++pass) {
        evaluate_constraints(t, q, v, false);
        if (factorize_kkt() != Status::converged) return false;
        for (int i = 0; i < multipliers(); ++i) b[size() + i] = -constraints_.rate()[i];
        if (solve_kkt(b, x) != Status::converged) return false;
        v += x.head(size());
    }
    return true;
}

ANCF_INLINE bool DynamicProblem::project_accelerations(double t, const VectorX& q, const VectorX& v,
                                                       VectorX& acceleration) {
    if (multipliers() == 0) return true;
    detail::require(acceleration.size() == size(), "DynamicProblem: expected ", size(),
                    " accelerations, got ", acceleration.size());
    evaluate_constraints(t, q, v);
    if (factorize_kkt() != Status::converged) return false;
    VectorX whole = full_a_;  // of driven coordinates
    numbering().set_free(acceleration, whole);
    VectorX b = VectorX::Zero(numbering().unknowns()), x;
    const VectorX slide = constraints_.product(whole);
    for (int i = 0; i < multipliers(); ++i)
        b[size() + i] = -slide[i] - constraints_.convection()[i];
    if (solve_kkt(b, x) != Status::converged) return false;
    for (int i = 0; i < size(); ++i) acceleration[i] += x[i];
    return true;
}

ANCF_INLINE State DynamicProblem::raw_state(double t, const VectorX& q, const VectorX& v) {
    expand(t, q, v);
    return {full_q_, full_v_, {}, t};
}

ANCF_INLINE void DynamicProblem::minimize_multipliers(VectorX& multipliers) {
    for (const int equation : left_out_) multipliers[equation] = 0.0;
    constraints_.evaluate(time_, full_q_, full_v_);
    if (factorize_kkt() != Status::converged) return;
    constraints_.leave_out({});
    constraints_.write_jacobian(kkt_matrix_);  // of all equations, for their rows alone
    constraints_.leave_out(left_out_);
    // multipliers of all units compare by the work that changes by the coordinates' scales take
    VectorX weights = constraints_.magnitude(full_scales_);
    for (Eigen::Index i = 0; i < weights.size(); ++i) weights[i] *= weights[i];
    const auto product = [&](const VectorX& a, const VectorX& b) {
        double sum = 0.0;
        for (Eigen::Index i = 0; i < a.size(); ++i) sum += weights[i] * a[i] * b[i];
        return sum;
    };
    List<VectorX> basis;
    for (const int equation : left_out_) {
        VectorX b = VectorX::Zero(numbering().unknowns()), x;
        for (SparseMatrix::InnerIterator entry(kkt_matrix_, size() + equation); entry; ++entry)
            if (entry.row() < size()) b[entry.row()] = entry.value();
        if (solve_kkt(b, x) != Status::converged) continue;
        // of an equation that no longer follows from the others something is left
        const VectorX rest = detail::multiply(compact_mass_, Storage::full, x.head(size()));
        const auto work = [&](const VectorX& force) {
            double sum = 0.0;
            for (int i = 0; i < size(); ++i) sum += std::pow(force[i] * scales_[i], 2);
            return std::sqrt(sum);
        };
        if (work(rest) > 1e-8 * work(b)) continue;
        VectorX silent = x.tail(multipliers.size());
        silent[equation] = -1.0;
        for (int pass = 0; pass < 2; ++pass)  // Gram-Schmidt, twice
            for (const VectorX& earlier : basis) silent -= product(earlier, silent) * earlier;
        silent /= std::sqrt(product(silent, silent));
        basis.push_back(silent);
        multipliers -= product(silent, multipliers) * silent;
    }
}

ANCF_INLINE Snapshot DynamicProblem::snapshot(double t, VectorX q, VectorX v, VectorX lambda,
                                              State& into, bool solve) {
    (void)project(t, q, v);  // where it fails the violation tells
    VectorX acceleration;
    if (solve) (void)accelerations(t, q, v, acceleration, lambda);
    const Energies found = energies(t, q, v, lambda);
    into = state(t, q, v, lambda);
    evaluate_constraints(t, q, v, false);
    return {into, found, constraints_.largest_violation(), constraints_.largest_rate()};
}

ANCF_INLINE Status DynamicProblem::reactions(const State& state, VectorX& forces) {
    const int all = numbering().coordinates();
    detail::require(state.q.size() == all && state.v.size() == all,
                    "DynamicProblem::reactions: expected ", all, " coordinates and rates, got ",
                    state.q.size(), " and ", state.v.size());
    forces.setZero(all);
    const VectorX before = std::exchange(full_q_, state.q);  // supports hold where it has them
    VectorX q, v, acceleration, lambda;
    numbering().gather_free(state.q, q);
    numbering().gather_free(state.v, v);
    Status status = accelerations(state.time, q, v, acceleration, lambda);
    if (status == Status::converged)
        if (const auto fault = evaluate(state.time, q, v, lambda, Request::force))
            status = fault->status;
    for (const int k : numbering().held()) full_q_[k] = before[k];  // as a run goes on with them
    if (status != Status::converged) return status;
    VectorX whole = full_a_;  // of driven coordinates
    numbering().add_free(acceleration, 1.0, whole);
    const VectorX exerted = assembly_.mass_product(whole) + assembly_.internal_force() +
                            assembly_.constraint_force() - assembly_.external_force();
    for (const int k : numbering().held()) forces[k] = exerted[k];
    return Status::converged;
}

ANCF_INLINE double DynamicProblem::force_scale(const Start& start) {
    const VectorX none = VectorX::Zero(multipliers());
    (void)evaluate(start.time, start.q, start.v, none, Request::force);
    const auto largest = [&](const VectorX& forces) {
        double value = 0.0;
        for (Eigen::Index k = 0; k < forces.size(); ++k)
            value = std::max(value, std::abs(forces[k]) * full_scales_[k] / length_);
        return value;
    };
    VectorX inertia = VectorX::Zero(full_q_.size());
    numbering().add_free_force(detail::multiply(compact_mass_, Storage::full, start.acceleration),
                               1.0, inertia);
    const double loads = largest(assembly_.external_force());
    const double inner = std::max(largest(assembly_.internal_force()), largest(inertia));
    return inner > force_round_off(start.time, start.q) ? std::max(loads, inner) : loads;
}

ANCF_INLINE double DynamicProblem::force_round_off(double t, const VectorX& q) {
    const VectorX rest = VectorX::Zero(size());
    if (evaluate(t, q, rest, VectorX::Zero(multipliers()), Request::tangent)) return 0.0;
    return round_off_of(assembly_.tangent());
}

ANCF_INLINE double DynamicProblem::round_off_of(const SparseMatrix& matrix) const {
    SparseMatrix magnitudes = detail::copied(matrix);
    for (int k = 0; k < detail::entries(magnitudes); ++k)
        magnitudes.valuePtr()[k] = std::abs(magnitudes.valuePtr()[k]);
    VectorX changes = detail::multiply(magnitudes, options_.storage, scales_);
    for (Eigen::Index k = 0; k < changes.size(); ++k) changes[k] *= scales_[k];
    // moments of slopes, N m, over the scene's size
    return std::numeric_limits<double>::epsilon() * detail::largest_magnitude(changes) / length_;
}

ANCF_INLINE double DynamicProblem::motion_frequency(const Start& start) {
    const double turn = detail::largest_ratio(start.v, scales_);
    const double acceleration = detail::largest_ratio(start.acceleration, scales_);
    if (turn * turn >= acceleration) return turn;
    // accelerations of a scene in equilibrium are round-off: of the loads or, without any, of K
    const VectorX none = VectorX::Zero(multipliers());
    (void)evaluate(start.time, start.q, start.v, none, Request::force);
    VectorX loads, driven;
    numbering().gather_free(assembly_.external_force(), loads);
    solve_mass(loads, driven);
    const double loaded = detail::largest_ratio(driven, scales_);
    // rates below so many times the highest frequency are round-off, and accelerations below its
    // square
    constexpr double noise = 64.0 * std::numeric_limits<double>::epsilon();
    if (loaded > 0.0 && acceleration > 1e-8 * loaded) return std::sqrt(acceleration);
    const double highest = highest_frequency(start.time, start.q);
    if (loaded == 0.0 && acceleration > noise * highest * highest) return std::sqrt(acceleration);
    return turn > noise * highest ? turn : 0.0;
}

ANCF_INLINE double DynamicProblem::largest_eigenvalue(const SparseMatrix& matrix,
                                                      VectorX& mode) const {
    const auto mass = [&](const VectorX& x) {
        return detail::multiply(compact_mass_, Storage::full, x);
    };
    const VectorX all_modes = detail::scattered(scales_, 0);
    if (mode.size() == 0)
        mode = all_modes;
    else  // of another part of the scene the last mode may have nothing
        mode += 0.1 * std::sqrt(mode.dot(mass(mode)) / all_modes.dot(mass(all_modes))) * all_modes;
    double estimate = 0.0;
    for (int k = 0; size() > 0 && k < 60; ++k) {
        // by a power of two: units that differ by such a factor then change no bit
        const double square = mode.dot(mass(mode));
        const double factor = std::ldexp(1.0, std::ilogb(square) / -2);
        mode *= factor;
        const VectorX force = detail::multiply(matrix, options_.storage, mode);
        const double quotient = std::abs(mode.dot(force)) / (square * factor * factor);
        const bool settled = k > 5 && std::abs(quotient - estimate) <= 1e-3 * quotient;
        estimate = std::max(quotient, estimate);
        constexpr double nothing = 1e-150;  // 1/s^2: round-off, whose square underflows
        if (settled || quotient < nothing) break;
        solve_mass(force, mode);
    }
    return estimate;
}

ANCF_INLINE double DynamicProblem::lowest_frequency(double t, const VectorX& q) {
    const double highest = highest_frequency(t, q);
    if (!(highest > 0.0)) return 0.0;
    const double square = highest * highest;
    // far above the round-off of K, far below any elastic frequency
    const double shift = 1e-12 * square;
    SparseMatrix shifted = tangent();
    if (options_.storage == Storage::full) detail::symmetrise(shifted);  // following loads
    for (Eigen::Index k = 0; k < detail::entries(shifted); ++k)
        shifted.valuePtr()[k] += shift * mass_.valuePtr()[k];
    detail::KktSystem system;
    system.analyze(shifted, size(), detail::blocks_of(numbering(), numbering().unknowns()));
    if (system.factorize(shifted) != Status::converged) return 0.0;
    const auto solve = [&](const VectorX& b) {
        VectorX whole = VectorX::Zero(numbering().unknowns()), x;
        whole.head(size()) = b;
        (void)system.solve(whole, x);  // an estimate is enough
        return VectorX(x.head(size()));
    };
    const int freedom = size() - multipliers() + static_cast<int>(left_out_.size());
    return std::sqrt(detail::lowest_eigenvalue(
        scales_, freedom,
        [&](const VectorX& x) { return detail::multiply(tangent(), options_.storage, x); },
        [&](const VectorX& x) { return detail::multiply(compact_mass_, Storage::full, x); }, solve,
        10.0 * shift));
}

}  // namespace ancf
