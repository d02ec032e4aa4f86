// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/convergence.hpp>
#include <ancf/solver/mechanism.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/stability.hpp>
#include <ancf/solver/subspace.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace ancf {

namespace detail {

/// The tangent of a scene that a load deflects linearly.
class Deflected {
public:
    Deflected(const Scene& model, Assembly& assembly)
        : model_(model),
          assembly_(assembly),
          rest_(VectorX::Zero(model.state().q.size())),
          deflection_(rest_),
          forces_(VectorX::Zero(assembly.numbering().multipliers())) {}

    /// Sets the response to one unit of load, from the factorised tangent of the unloaded scene.
    ANCF_LAZY void respond(const LinearSolver& solver) {
        const Numbering& numbering = assembly_.numbering();
        VectorX load, response;
        numbering.gather_free(assembly_.load_rate(model_.state().q, 0.0, 1.0), load);
        load.conservativeResizeLike(VectorX::Zero(numbering.unknowns()));
        solve_with(solver, load, response);
        numbering.add_free(response.head(numbering.free_coordinates()), 1.0, deflection_);
        forces_ = response.tail(numbering.multipliers());
        const ConvergenceMonitor monitor(model_, numbering);
        size_ = monitor.correction(response);
        VectorX place;
        numbering.gather_free(model_.state().q, place);
        far_ = std::max(1.0, monitor.correction(place));
    }

    /// Writes the change of the tangent per unit of load; returns the element that failed.
    ANCF_LAZY [[nodiscard]] std::optional<Fault> change(const SparseMatrix& unloaded,
                                                        SparseMatrix& out) {
        // central, so that the extension due to linearly added rotations, of even order, drops out;
        // the step leaves the difference ten digits of the tangent
        const double step = 1e-5 / std::max(size_, std::numeric_limits<double>::min());
        const auto& groups = model_.groups();
        const bool takes_stresses = std::all_of(
            groups.begin(), groups.end(),
            [](const auto& group) { return group->evaluates_mixed() || group->size() == 0; });
        if (takes_stresses) {
            // stresses of a small load would be lost beside the tangent
            constexpr double visible = 1e-3;
            const double multiple = size_ > 0.0 ? std::max(1.0, visible / size_) : 1.0;
            const Correction stresses{model_.state().q, multiple * deflection_};
            if (const auto fault = evaluate(model_.state().q, multiple, &stresses)) return fault;
            out = (assembly_.tangent() - unloaded) / multiple;
            // what the loads themselves change
            assembly_.add_load_tangent_rate(model_.state().q, out);
            // what stands from the beginning and bears the load, such as springs, which may be
            // short beside the scene; far from the origin positions have fewer digits
            const double h = 0.01 * step * std::cbrt(far_);
            assembly_.add_load_tangent_change(model_.state().q, h * deflection_, 0.5 / h, out);
            return {};
        }
        if (const auto fault = evaluate(model_.state().q - step * deflection_, -step)) return fault;
        out = assembly_.tangent();
        const auto fault = evaluate(model_.state().q + step * deflection_, step);
        out = (assembly_.tangent() - out) / (2.0 * step);
        assembly_.add_load_tangent_rate(model_.state().q, out);
        return fault;
    }

    /// Evaluates the tangent at the load factor 0, with the multipliers of a multiple of the load;
    /// returns the element that failed.
    [[nodiscard]] std::optional<Fault> evaluate(const VectorX& q, double multiple,
                                                const Correction* stresses = nullptr) {
        VectorX multipliers = model_.state().multipliers;
        if (multiple != 0.0) multipliers += multiple * forces_;  // 0 first: it refuses a bad size
        return assembly_.evaluate({q, rest_, multipliers, {0.0, 0.0}}, Request::tangent, nullptr,
                                  stresses);
    }

private:
    const Scene& model_;
    Assembly& assembly_;
    VectorX rest_;
    VectorX deflection_;  // all coordinates per unit of load
    VectorX forces_;      // multipliers per unit of load
    double size_ = 0.0;   // of the deflection, each coordinate relative to its scale
    double far_ = 1.0;    // distance from the origin, relative to the scene's size, at least 1
};

/// Throws where supports or constraints move with the load factor: their stresses do not count.
ANCF_INLINE void require_resting(const Assembly& assembly, const VectorX& q) {
    VectorX here = q, ahead = q;
    const double step = factor_step(0.0);
    assembly.apply_supports({0.0, 0.0}, here);
    assembly.apply_supports({step, step}, ahead);
    const char* const advice =
        " with the load factor, and only loads count here: give a load instead, or follow the path";
    for (Eigen::Index k = 0; k < q.size(); ++k)
        require(here[k] == ahead[k], "buckling_modes: a support moves ",
                to_string(assembly.model().layout().field_of(static_cast<int>(k))), " of node ",
                assembly.model().layout().node_of(static_cast<int>(k)), advice);
    Eigen::Index row = 0;
    for (const AnyConstraint& constraint : assembly.model().constraints())
        for (const Eigen::Index end = row + constraint.equations(); row < end; ++row)
            require(assembly.violation_rate()[row] == 0.0, "buckling_modes: the ",
                    constraint.name(), " moves", advice);
}

/// Returns how far B is from symmetric: its largest difference of two opposite entries, relative to
/// its largest entry.
/// @param A  whose diagonal measures the unknowns.
[[nodiscard]] ANCF_INLINE double asymmetry(const SparseMatrix& A, const SparseMatrix& B) {
    VectorX unit = VectorX::Zero(A.cols());
    for (Eigen::Index k = 0; k < A.cols(); ++k)
        if (const double own = std::abs(A.coeff(k, k)); own > 0.0) unit[k] = 1.0 / std::sqrt(own);
    double largest = 0.0, apart = 0.0;
    for (int j = 0; j < B.cols(); ++j)
        for (int k = B.outerIndexPtr()[j]; k < B.outerIndexPtr()[j + 1]; ++k) {
            const int i = B.innerIndexPtr()[k];
            const double value = B.valuePtr()[k];
            largest = std::max(largest, std::abs(value) * unit[i] * unit[j]);
            apart = std::max(apart, std::abs(value - B.coeff(j, i)) * unit[i] * unit[j]);
        }
    return largest > 0.0 ? apart / largest : 0.0;
}

/// Returns A + G^T W G: constraints act as springs, too.
///
/// A solution that keeps the constraints solves both. A body between welds has next to no stiffness
/// of its own, which a solver would take for the scale of its unknowns.
ANCF_LAZY [[nodiscard]] SparseMatrix braced(const Assembly& assembly, const SparseMatrix& A) {
    if (assembly.numbering().multipliers() == 0) return A;
    VectorX diagonal = A.diagonal().head(assembly.numbering().free_coordinates());
    const VectorX stiffest = stiffest_of_unit(assembly, diagonal);
    List<MatrixEntry> entries;  // of springs as stiff as what is stiffest
    if (!add_springs(A, 1.0, stiffest, stiffest, diagonal, entries)) return A;
    const SparseMatrix springs = compressed(static_cast<int>(A.cols()), entries);
    return A + SparseMatrix(springs.selfadjointView<Eigen::Lower>());
}

/// Factorises A; what a constraint does not account for must not be negative.
[[nodiscard]] ANCF_INLINE Status factorise(const Assembly& assembly, const SparseMatrix& A,
                                           LinearSolver& solver) {
    solver.analyze(A);
    const FactorReport factor = solver.factorize(A);
    if (factor.status != Status::converged) return factor.status;
    const auto negative = negative_directions(assembly, A, factor, solver);
    return negative.certain && negative.count > 0 ? Status::singular : Status::converged;
}

/// Returns a report with the cause of its failure in A.
/// @param otherwise  why there are no modes where nothing moves without stiffness
/// @param remedy     what helps where something does
[[nodiscard]] ANCF_INLINE ModalReport with_cause(ModalReport report, const Scene& model,
                                                 const Assembly& assembly, const SparseMatrix& A,
                                                 LinearSolver& solver, const char* otherwise,
                                                 const char* remedy = "") {
    std::string& message = report.message;
    if (report.status == Status::singular) {
        message = singular_cause(model, assembly.numbering(), A, solver);
        if (message.empty())
            message = otherwise;
        else if (message.rfind("a motion", 0) == 0)
            message += remedy;
    } else if (report.status == Status::max_iterations) {
        message = joined({"modes are left to converge after ", report.iterations, " iterations"});
    } else if (report.status != Status::converged) {
        message = joined({"the matrix cannot be factorised: ", to_string(report.status)});
        report.fault = assembly.inspect_values(model.state().q);
        if (report.fault) message += "; " + assembly.describe(*report.fault);
    }
    return report;
}

/// Finds the modes of A, of which the solver has the factors, or those of braced(A), and turns th
/// into values.
/// @param scales  of the unknowns: displacements of one size
/// @param least   the least |th| that counts, relative to the round-off of x^T A x
template <class Value>
[[nodiscard]] ModalReport modes_of(const Assembly& assembly, const SparseMatrix& A,
                                   const SparseMatrix& B, const VectorX& scales,
                                   LinearSolver& solver, const ModalOptions& options, double least,
                                   const Value& value) {
    ModalReport report;
    const Numbering& numbering = assembly.numbering();
    Subspace space(A, B, scales, solver);
    report.status = space.run(numbering.free_coordinates(), options.count, options.tolerance,
                              options.max_iterations);
    report.iterations = space.iterations;
    if (report.status != Status::converged && report.status != Status::max_iterations)
        return report;
    const auto count = std::min<Eigen::Index>(options.count, space.values.size());
    const VectorX noise = space.noise(space.vectors.leftCols(count));
    for (Eigen::Index k = 0; k < count; ++k) {
        if (std::abs(space.values[k]) <= least * noise[k]) continue;
        Mode mode;
        double scale = 1.0;
        mode.value = value(space.values[k], scale);
        mode.residual = space.residual(k);
        mode.shape.setZero(numbering.coordinates());
        numbering.add_free(space.vectors.col(k).head(numbering.free_coordinates()), scale,
                           mode.shape);
        report.modes.push_back(std::move(mode));
    }
    return report;
}

}  // namespace detail

ANCF_INLINE void ModalOptions::check() const {
    detail::require(count >= 1, "ModalOptions: count must be at least 1, got ", count);
    detail::require(max_iterations >= 1, "ModalOptions: max_iterations must be at least 1, got ",
                    max_iterations);
    detail::require_finite("ModalOptions: factor", factor);
    detail::require_finite("ModalOptions: shift", shift);
    detail::require_positive("ModalOptions: tolerance", tolerance);
}

ANCF_LAZY ModalReport natural_modes(const Scene& model, LinearSolver& solver,
                                    const ModalOptions& options) {
    options.check();
    Assembly assembly(model, solver.storage());
    const State& state = model.state();
    const VectorX rest = VectorX::Zero(state.q.size());
    const Instant instant{options.factor, options.factor};
    auto fault = assembly.evaluate({state.q, rest, state.multipliers, instant}, Request::tangent);
    if (!fault) fault = assembly.inspect(state.q);
    if (fault) return {fault->status, {}, 0, fault, assembly.describe(*fault)};
    if (assembly.numbering().free_coordinates() == 0) return {};
    std::string remarks;
    const auto remark = [&](const std::string& text) {
        remarks += (remarks.empty() ? "" : "; ") + text;
    };
    const auto with_remarks = [&](ModalReport report) {
        report.message += (report.message.empty() || remarks.empty() ? "" : "; ") + remarks;
        return report;
    };
    const ConvergenceMonitor monitor(model, assembly.numbering());
    const double violated = monitor.violation(assembly);
    if (!(violated <= 1e-6))
        remark(detail::joined({"the state violates its constraints by ", violated,
                               " of the scene's size at a load factor of ", options.factor},
                              17));
    if (!(monitor.residual(assembly) <= 1e-6) && !monitor.at_round_off(assembly, state.q))
        remark(
            detail::joined({"the state is out of balance at a load factor of ", options.factor}));
    if (!model.has_symmetric_loads() &&
        detail::asymmetry(assembly.tangent(), assembly.tangent()) > 1e-12)
        remark(
            "loads without a potential count by the symmetric part of their stiffness: only a "
            "motion tells what they do to frequencies and stability");
    const char* const high =
        "K - shift M is not positive definite: the state is unstable, or the shift too high";
    const char* const remedy =
        options.shift < 0.0 ? "" : "; a negative ModalOptions::shift allows it";
    const SparseMatrix mass = assembly.mass();
    SparseMatrix A = assembly.tangent() - options.shift * mass;
    if (solver.storage() == Storage::full) detail::symmetrise(A);
    const SparseMatrix firm = detail::braced(assembly, A);
    if (const Status status = detail::factorise(assembly, firm, solver);
        status != Status::converged)
        return with_remarks(detail::with_cause({status, {}, 0, {}, {}}, model, assembly, firm,
                                               solver, high, remedy));
    const auto value = [&](double th, double& scale) {
        scale = 1.0 / std::sqrt(std::abs(th));  // x^T M x = th where x^T A x = 1
        return options.shift + 1.0 / th;
    };
    const int left = assembly.numbering().free_coordinates() - assembly.numbering().multipliers();
    ModalReport report;
    if (left != 0)  // 0: the matrix is regular, so constraints hold everything
        report = detail::with_cause(detail::modes_of(assembly, A, mass, detail::unit_scales(firm),
                                                     solver, options, 0.0, value),
                                    model, assembly, firm, solver, high, remedy);
    const int wanted = std::min(options.count, std::max(left, 0));
    const auto found = static_cast<int>(report.modes.size());
    if (report.status == Status::converged && found < wanted)
        report.message = detail::joined(
            {"of ", wanted, " modes ", wanted - found,
             " have no mass, or are lost in round-off beside the slowest one: those a negative "
             "shift of the size of the squares wanted will find"});
    return with_remarks(std::move(report));
}

ANCF_LAZY ModalReport buckling_modes(const Scene& model, LinearSolver& solver,
                                     const ModalOptions& options) {
    options.check();
    Assembly assembly(model, solver.storage());
    detail::Deflected deflected(model, assembly);
    auto fault = deflected.evaluate(model.state().q, 0.0);
    if (!fault) fault = assembly.inspect(model.state().q);
    if (fault) return {fault->status, {}, 0, fault, assembly.describe(*fault)};
    detail::require_resting(assembly, model.state().q);
    const int free = assembly.numbering().free_coordinates();
    if (free == 0) return {};
    VectorX forces, load;
    assembly.residual(forces);
    assembly.numbering().gather_free(assembly.load_rate(model.state().q, 0.0, 1.0), load);
    const double size = ConvergenceMonitor(model, assembly.numbering()).size();
    const VectorX lever = detail::length_powers(size, model.layout(), assembly.numbering());
    const double largest = detail::largest_magnitude(lever.cwiseProduct(load));  // J
    const double borne =
        largest > 0.0 ? detail::largest_magnitude(lever.cwiseProduct(forces.head(free))) / largest
                      : 0.0;
    SparseMatrix unloaded = assembly.tangent();
    if (solver.storage() == Storage::full) detail::symmetrise(unloaded);
    const SparseMatrix firm = detail::braced(assembly, unloaded);
    if (const Status status = detail::factorise(assembly, firm, solver);
        status != Status::converged)
        return detail::with_cause({status, {}, 0, {}, {}}, model, assembly, firm, solver,
                                  "the matrix is not positive definite");
    deflected.respond(solver);
    SparseMatrix change;
    fault = deflected.change(unloaded, change);
    if (fault) return {fault->status, {}, 0, fault, assembly.describe(*fault)};
    SparseMatrix B = -change;
    detail::require(
        model.has_symmetric_loads() || detail::asymmetry(unloaded, B) <= 1e-6,  // of round-off
        "buckling_modes: loads that have no potential, such as FollowerForce and Moment, make a "
        "tangent that is not symmetric; follow the path, and look at a motion beside it");
    if (solver.storage() == Storage::full) detail::symmetrise(B);
    // B is the difference of two tangents: without load it has their round-off alone
    ModalReport report =
        detail::modes_of(assembly, unloaded, B, detail::unit_scales(firm), solver, options,
                         largest > 0.0 ? 0.0 : 10.0, [](double th, double&) { return 1.0 / th; });
    if (report.status == Status::converged && report.modes.empty())
        report.status = Status::singular;
    report = detail::with_cause(std::move(report), model, assembly, firm, solver,
                                "the load makes no stress, or the scene without it is not stable");
    constexpr double small = 0.01;
    detail::require(report.modes.empty() || borne <= small * std::abs(report.modes[0].value),
                    "buckling_modes: the model's state is not in equilibrium without load, its "
                    "forces are as large as the load at the factor ",
                    borne, ": call it before solve_statics()");
    return report;
}

}  // namespace ancf
