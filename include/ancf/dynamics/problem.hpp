// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A scene as a differential-algebraic system in its free coordinates q, rates v and multipliers:
///
///     q' = v,    M v' + r(t, q, v, lambda) = 0,    g(q, t) = 0,
///     r = Q_e(q) + G^T lambda - Q(t, q, v) + M_fp a_p,
///
/// with a_p the accelerations of driven supports. Every integrator works on this one interface.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/compiler.hpp>
#include <ancf/dynamics/constraint_set.hpp>
#include <ancf/dynamics/kkt.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/model/state.hpp>
#include <ancf/solver/sparse_ldlt.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace ancf {

class LinearSolver;

/// What to do with constraints that repeat each other.
enum class Redundancy {
    refuse,       ///< the start has Status::redundant and names them
    minimum_norm  ///< one of them is left out; reported multipliers have the least norm, each
                  ///< measured by what the scene's size makes of its equation. A motion in which
                  ///< what was left out does not follow from the rest ends as inconsistent
};

/// How a problem is set up.
struct ProblemOptions {
    Storage storage = Storage::full;  ///< lower only without constraints and unsymmetric loads
    Redundancy redundancy = Redundancy::refuse;  ///< what repeated constraints lead to
    double consistency = 1e-8;  ///< |g| and |G v + g_t| allowed at the start, relative to the
                                ///< scene's size and to its largest rate
    double redundancy_tolerance = 1e-10;  ///< a row of G whose part independent of the rows before
                                          ///< it is shorter than this, relative, is redundant
    /// Solves with M, by all parts of a scene together, in full storage. A part (Scene::part) needs
    /// one, a whole scene takes none. It outlives the problem.
    LinearSolver* mass_solver = nullptr;

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const {
        detail::require_positive("ProblemOptions: consistency", consistency);
        detail::require_positive("ProblemOptions: redundancy_tolerance", redundancy_tolerance);
    }
};

/// Where a motion starts.
struct Start {
    /// Or inconsistent, redundant, degenerate, not_finite, singular.
    Status status = Status::converged;
    std::string message;   ///< which constraint, by how much
    double time = 0.0;     ///< s
    VectorX q;             ///< free coordinates
    VectorX v;             ///< their rates
    VectorX acceleration;  ///< consistent v', free
    VectorX multipliers;   ///< consistent lambda
};

/// A scene as the system above. n free coordinates, m multipliers; n + m unknowns in the order of
/// Numbering. Sparse matrices have one pattern, that of tangent().
///
/// The model outlives the problem. Prototypes, masses at nodes and gravity can change at any time:
/// start() and every evaluation take that over, mass included; a run that begins after the change
/// has consistent accelerations from its first step. Evaluations refuse a model that has gained or
/// lost nodes, elements, supports, loads or constraints.
///
/// Of a part of a scene whose parts stand in several processes, start(), evaluations, energies,
/// largest_ratio() and what solves are collective, and forces are sums over all parts: enough for
/// GeneralizedAlpha; the other integrators refuse it. There are no multipliers then.
class DynamicProblem {
public:
    /// @throws InvalidArgument for a support that has a value but no rate or acceleration, a load
    ///         or constraint on a vector that its node does not carry, storage that does not suit,
    ///         or a part of a scene with constraints or without a mass_solver.
    explicit DynamicProblem(Scene& model, const ProblemOptions& options = {});

    ~DynamicProblem();
    DynamicProblem(const DynamicProblem&) = delete;
    DynamicProblem& operator=(const DynamicProblem&) = delete;

    [[nodiscard]] int size() const noexcept { return numbering().free_coordinates(); }    ///< n
    [[nodiscard]] int multipliers() const noexcept { return numbering().multipliers(); }  ///< m
    /// Returns the scene.
    [[nodiscard]] const Scene& model() const noexcept { return model_; }
    /// Returns the order of unknowns.
    [[nodiscard]] const Numbering& numbering() const noexcept { return assembly_.numbering(); }
    /// Returns what evaluates the scene.
    [[nodiscard]] const Assembly& assembly() const noexcept { return assembly_; }

    /// Reads the model's state, checks it against the constraints, finds redundant ones and solves
    /// [M G^T; G 0] (v', lambda) = (-r(lambda = 0), -c) for accelerations and multipliers.
    ///
    /// Call it before any evaluation: it also settles which equations are left out.
    /// @throws InvalidArgument as refresh().
    [[nodiscard]] Start start();

    /// Takes over what changed in the model; start() and every evaluation do it by themselves.
    /// @throws InvalidArgument where nodes, elements, supports, loads or constraints have changed,
    ///         or the mass matrix is no longer positive definite.
    void refresh();

    /// Returns the constraint equations left out as redundant, by their place in lambda.
    [[nodiscard]] const List<int>& left_out() const noexcept { return left_out_; }

    /// Solves the same system at any consistent (t, q, v).
    [[nodiscard]] Status accelerations(double t, const VectorX& q, const VectorX& v,
                                       VectorX& acceleration, VectorX& multipliers);

    /// Solves for the rate of the accelerations, v'', by one more time derivative of the system.
    ///
    /// K, D and G are exact; what depends on time alone and the third derivative of the constraints
    /// are differences of second order over the two steps after the start.
    [[nodiscard]] Status jerk(const Start& at, double step, VectorX& jerk);

    /// Finds the second derivative in time of r, as it depends on the positions alone, of a whole
    /// scene.
    ///
    /// K v' is exact; the rest is a central difference along v.
    /// @param distance   of the difference, s.
    /// @param curvature  n entries, N/s^2 and N m/s^2.
    /// @return the first element that failed, if one did.
    [[nodiscard]] std::optional<Fault> force_curvature(const Start& at, double distance,
                                                       VectorX& curvature);

    // Evaluation at (t, q, v, lambda); results stand until the next one.

    /// Evaluates the scene.
    /// @param q,v  n entries.  @param lambda  m entries.
    /// @return the first element that failed, if one did; the results are then of no use.
    [[nodiscard]] std::optional<Fault> evaluate(double t, const VectorX& q, const VectorX& v,
                                                const VectorX& lambda, Request request);

    /// Returns r, n entries, N and N m.
    [[nodiscard]] const VectorX& force() const noexcept { return force_; }

    /// Returns g as the integrator must bring it to zero, m entries; for equations left out,
    /// lambda.
    [[nodiscard]] const VectorX& constraint_residual() const noexcept {
        return constraint_residual_;
    }

    /// Returns [K + (G^T lambda)_q - dQ/dq, G^T; G, 0], n + m square, after Request::tangent. For
    /// equations left out the row and column of G are zero and the diagonal is 1.
    [[nodiscard]] const SparseMatrix& tangent() const noexcept {
        return left_out_.empty() ? assembly_.tangent() : tangent_;
    }

    /// Returns [-dQ/dv, 0; 0, 0], n + m square, after Request::tangent_and_damping.
    [[nodiscard]] const SparseMatrix& damping() const noexcept { return assembly_.damping(); }

    /// Returns [M, 0; 0, 0], n + m square, the same at every (t, q).
    [[nodiscard]] const SparseMatrix& mass() const noexcept { return mass_; }

    /// Returns M of the free coordinates, both halves, n square, without stored zeros.
    [[nodiscard]] const SparseMatrix& compact_mass() const noexcept { return compact_mass_; }

    /// Solves M x = b for n entries.
    void solve_mass(const VectorX& b, VectorX& x) const;

    /// Adds scale M a to n entries.
    void add_mass_product(double scale, const VectorX& a, VectorX& out) const {
        if (exchange_ == nullptr)
            return detail::add_product(compact_mass_, Storage::full, scale, a, out);
        VectorX product = VectorX::Zero(size());
        detail::add_product(compact_mass_, Storage::full, scale, a, product);
        add_parts(product);
        out += product;
    }

    /// Returns energies and powers at (t, q, v, lambda) by an evaluation of its own.
    ///
    /// The potential of a load that works through an angle goes on from the last call since
    /// start(), over any number of turns; between two calls it turns by less than half of one.
    [[nodiscard]] Energies energies(double t, const VectorX& q, const VectorX& v,
                                    const VectorX& lambda);

    /// Returns the potentials of such loads at unit amplitude that the last call gave, J; empty
    /// before the first one since start().
    [[nodiscard]] const VectorX& angle_potentials() const noexcept { return angles_; }

    /// Lets them go on from the last call of another run; of another size they begin anew.
    void set_angle_potentials(VectorX potentials) { angles_ = std::move(potentials); }

    /// Returns energies and powers of the last evaluation, angles between -pi and pi.
    /// @throws InvalidArgument before the first evaluation
    [[nodiscard]] Energies energies() const;

    /// Evaluates g, G, g_t and c at (t, q, v) for the functions below, and no element. Equations
    /// left out have zero rows. c only where it is asked for.
    void evaluate_constraints(double t, const VectorX& q, const VectorX& v,
                              bool convection = true) {
        expand(t, q, v);
        constraints_.evaluate(t, full_q_, full_v_, convection);
    }

    /// Evaluates the same but c, at rest, which is cheaper; the rate is then g_t and what driven
    /// supports make.
    /// @param active  places among all coordinates of the free ones that constraints act on.
    /// @param q       of these alone.
    void evaluate_constraints(double t, const List<int>& active, const VectorX& q);

    /// Returns the constraints as they were evaluated last.
    [[nodiscard]] const detail::ConstraintSet& constraints() const noexcept { return constraints_; }

    /// Returns c + G a_p, m entries, a_p the accelerations of driven supports.
    [[nodiscard]] VectorX constraint_convection() const {
        return constraints_.convection() + constraints_.product(full_a_);
    }

    /// Writes [(G^T mu)_q, 0; (G v + g_t)_q, 0] into a matrix of tangent()'s pattern, for forms
    /// that hold the constraint at velocity level.
    void velocity_level(const VectorX& mu, SparseMatrix& out) const {
        check_multipliers(mu);
        if (detail::entries(out) != detail::entries(mass_)) out = mass_;
        std::fill_n(out.valuePtr(), detail::entries(out), 0.0);
        constraints_.add_velocity_level(mu, out);
    }

    /// Moves q on g(q, t) = 0, then v on G v + g_t = 0, each by the least change in the mass norm.
    /// @return false where the iteration does not reach round-off; q and v are then as they came.
    bool project(double t, VectorX& q, VectorX& v);

    /// Moves v on G v + g_t = 0 at (t, q), by the least change in the mass norm.
    /// @param passes  a second one removes the round-off of the first.
    /// @return false where the system cannot be solved; v is then as it came.
    bool project_rates(double t, const VectorX& q, VectorX& v, int passes = 2);

    /// Moves accelerations on G v' + c = 0 at (t, q, v), by the least change in the mass norm.
    /// @return false where the system cannot be solved; they are then as they came.
    bool project_accelerations(double t, const VectorX& q, const VectorX& v, VectorX& acceleration);

    /// Returns the state of all coordinates, supports included, with the multipliers as reported.
    [[nodiscard]] State state(double t, const VectorX& q, const VectorX& v, const VectorX& lambda) {
        check_multipliers(lambda);
        State result = raw_state(t, q, v);
        result.multipliers = lambda;
        if (!left_out_.empty()) minimize_multipliers(result.multipliers);
        return result;
    }

    /// Returns all coordinates and rates, supports included, without multipliers.
    [[nodiscard]] State raw_state(double t, const VectorX& q, const VectorX& v);

    /// Writes the state of all coordinates into the model.
    void store(double t, const VectorX& q, const VectorX& v, const VectorX& lambda) {
        model_.state() = state(t, q, v, lambda);
    }

    /// Returns what an observer sees at (t, q, v, lambda), after projection; `into` holds the
    /// state.
    /// @param solve  whether to solve for the multipliers of the projected state; where that fails
    ///               they are lambda.
    [[nodiscard]] Snapshot snapshot(double t, VectorX q, VectorX v, VectorX lambda, State& into,
                                    bool solve = false);

    /// Solves for the forces that supports exert on the coordinates that they hold or drive,
    ///
    ///     M v' + Q_e + G^T lambda - Q,
    ///
    /// with the accelerations and multipliers that belong to (t, q, v). What it costs, one
    /// factorisation, only those who ask for it pay; no run takes notice.
    /// @param state   all coordinates and rates, as an observer sees them; not its multipliers.
    /// @param forces  of all coordinates, zero where free; N and N m.
    /// @return converged, or why the accelerations could not be solved for; forces are then zero.
    /// @throws InvalidArgument for a state of another size.
    [[nodiscard]] Status reactions(const State& state, VectorX& forces);

    /// Returns the scene's size, m: the diagonal of its nodes, at least an element's length, when
    /// the problem was made.
    [[nodiscard]] double length_scale() const noexcept { return length_; }

    /// Sets the scene's size, m: a run that continues another one keeps the scale that it had.
    /// @throws InvalidArgument unless it is positive.
    void set_length_scale(double length);

    /// Returns the typical size of each free coordinate: the scene's size; of slopes 1, of r_xx one
    /// over that size.
    [[nodiscard]] const VectorX& scales() const noexcept { return scales_; }

    /// Returns the largest |x_i| / scale_i of n entries, and of those of all parts of a scene; not
    /// finite where an entry is not.
    [[nodiscard]] double largest_ratio(const VectorX& x) const {
        return largest_of_parts(detail::largest_ratio(x, scales_));
    }

    /// Tells whether any coordinate is free, of all parts of a scene.
    [[nodiscard]] bool can_move() const { return largest_of_parts(size()) > 0.0; }

    /// Returns a sum over all parts of a scene; of a whole one the number itself.
    [[nodiscard]] double sum_of_parts(double value) const {
        if (exchange_ != nullptr) exchange_->sum(&value, 1);
        return value;
    }
    /// Returns x.y over all coordinates that this part answers for.
    [[nodiscard]] double own_dot(const VectorX& x, const VectorX& y) const;

    /// Returns the typical size of every coordinate, held ones too, for a scene of the given size:
    /// that of positions, 1 of slopes, one over it of r_xx.
    /// @param length  m, positive
    [[nodiscard]] VectorX scales_of(double length) const;

    /// Returns a typical force of the start, N: the largest of the loads, of the inertia forces and
    /// of the elastic force; 0 where all of it is round-off.
    [[nodiscard]] double force_scale(const Start& start);

    /// Returns the round-off of the elastic force at (t, q), N: what one rounding of every
    /// coordinate changes in it, at most.
    [[nodiscard]] double force_round_off(double t, const VectorX& q);

    /// Returns what one rounding of every coordinate changes in the forces of a matrix, at most, N
    /// for one of stiffness.
    /// @param matrix  in the pattern of tangent().
    [[nodiscard]] double round_off_of(const SparseMatrix& matrix) const;

    /// Returns how fast the start moves or begins to move, rad/s: the largest rate, or the root of
    /// the largest acceleration, over length_scale(); 0 where all of it is round-off.
    [[nodiscard]] double motion_frequency(const Start& start);

    /// Returns the largest |eigenvalue| of M^-1 A within some per cent, by power iteration with the
    /// Rayleigh quotient.
    /// @param matrix  A, in the pattern of tangent().
    /// @param mode    of an earlier estimate, n entries, from which the iteration begins, or empty;
    ///                becomes the mode.
    [[nodiscard]] double largest_eigenvalue(const SparseMatrix& matrix, VectorX& mode) const;

    /// Returns the highest angular frequency of M^-1 (K + (G^T lambda)_q) at (t, q), rad/s,
    /// likewise; constraints do not hold it, so an upper bound with them. 0 where an element fails,
    /// NaN where a load or constraint does.
    [[nodiscard]] double highest_frequency(double t, const VectorX& q, const VectorX& lambda,
                                           VectorX& mode) {
        const VectorX rest = VectorX::Zero(size());
        if (const auto fault = evaluate(t, q, rest, lambda, Request::tangent))
            return fault->element < 0 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
        return std::sqrt(largest_eigenvalue(assembly_.tangent(), mode));
    }
    /// Returns the same without multipliers, begun with all modes.
    [[nodiscard]] double highest_frequency(double t, const VectorX& q) {
        VectorX mode;
        return highest_frequency(t, q, VectorX::Zero(multipliers()), mode);
    }

    /// Returns the lowest angular frequency of K on M and G at (t, q) that is not of a rigid motion
    /// or mechanism, rad/s, by subspace iteration; 0 where every motion is free.
    [[nodiscard]] double lowest_frequency(double t, const VectorX& q);

private:
    struct Driven {
        int coordinate;
        const Support* support;
    };

    void set_mass();
    // Returns the largest of the parts of a scene; a NaN counts as more than any number.
    [[nodiscard]] double largest_of_parts(double value) const {
        return exchange_ == nullptr ? value : exchange_->largest(value);
    }
    // Replaces forces of free coordinates by their sums over all parts.
    void add_parts(VectorX& forces) const;
    void check_multipliers(const VectorX& lambda) const;
    void check_sizes() const;
    void list_driven();
    void measure();
    [[nodiscard]] double driving_power() const;
    void expand(double t, const VectorX& q, const VectorX& v);
    void check_state(double fastest, Start& start);
    [[nodiscard]] std::string check_supports(double t, double fastest) const;
    [[nodiscard]] std::string check_constraints();
    void find_redundant(Start& start);
    // Takes from the multipliers what does no work: row e of G, left out, is the sum of d_i times
    // the others, (M, G) (0, d) = (G_e^T, 0), so that d - unit vector e is in the null space of
    // G^T. Where the system cannot be solved they stay as they are.
    void minimize_multipliers(VectorX& multipliers);
    [[nodiscard]] Status factorize_kkt() {
        if (exchange_ != nullptr) return Status::converged;  // M alone
        if (multipliers() > 0) constraints_.write_jacobian(kkt_matrix_);
        return kkt_.factorize(kkt_matrix_);
    }
    [[nodiscard]] Status solve_kkt(const VectorX& b, VectorX& x);
    bool project_positions(double t, VectorX& q, const VectorX& v);

    Scene& model_;
    const detail::Exchange* exchange_;  // of a part of a scene
    ProblemOptions options_;
    Assembly assembly_;
    Revision revision_;  // of the model that the mass below is of
    detail::ConstraintSet constraints_;
    SparseMatrix mass_, compact_mass_;
    detail::SparseLdlt mass_factor_;
    SparseMatrix tangent_;     // with the changes for equations left out
    SparseMatrix kkt_matrix_;  // [M G^T; G 0]
    detail::KktSystem kkt_;
    VectorX scales_;       // of free coordinates
    VectorX full_scales_;  // of all coordinates
    double length_ = 1.0;
    List<Driven> driven_;
    bool drives_ = false;  // whether anything is driven, in any part
    List<int> left_out_;
    VectorX angles_;  // potentials of angles that energies() last gave

    // of the last evaluation, all coordinates
    double time_ = 0.0;
    VectorX full_q_, full_v_, full_a_, lambda_;
    VectorX force_, constraint_residual_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/problem.ipp>  // IWYU pragma: export
#endif
