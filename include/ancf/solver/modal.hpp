// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Natural frequencies about any state, and linear buckling: docs/theory-modal.md.
///
/// Both are the largest eigenvalues th of B x = th A x with A factorised once: A = K - shift M and
/// B = M for vibration, A = K_0 and B = -dK/df for buckling. Constraints stay in A.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/types.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ancf {

/// What modes are wanted and how well.
struct ModalOptions {
    int count = 6;             ///< number of modes
    double factor = 1.0;       ///< load factor of the state that the model is in
    double shift = 0.0;        ///< rad^2/s^2, below all wanted; negative for bodies that can move
    double probe = 1e-3;       ///< buckling: load factor up to which the tangent's change is taken
    double tolerance = 1e-10;  ///< relative change of the eigenvalues
    int max_iterations = 500;

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// One mode.
struct Mode {
    double value;     ///< vibration: omega^2, rad^2/s^2; buckling: the load factor
    double residual;  ///< |B x - th A x|/(th |A x|)
    VectorX shape;    ///< all coordinates; of unit modal mass, or x^T K_0 x = 1

    /// Returns omega/(2 pi), Hz; negative where the square is.
    [[nodiscard]] double frequency() const noexcept {
        return std::copysign(std::sqrt(std::abs(value)), value) / 6.283185307179586;
    }
};

/// What an eigenvalue analysis reports.
struct ModalReport {
    Status status = Status::converged;
    std::vector<Mode> modes;  ///< by rising value, of buckling by rising magnitude
    int iterations = 0;
};

/// Returns the lowest natural modes of small vibrations about the model's state, undamped.
///
/// @note  the factorised K - shift M must be positive definite on what constraints allow: status
///        singular where it is not; lower the shift. Unsymmetric load stiffness is symmetrised.
template <class Scene, class LinearSolver>
[[nodiscard]] ModalReport natural_modes(const Scene& model, LinearSolver& solver,
                                        const ModalOptions& options = {});

/// Returns the load factors at which the tangent, linear in the load factor from an unloaded state
/// on, becomes singular; negative ones are of the reversed load.
///
/// The model stands in equilibrium without load and is left there.
template <class Scene, class LinearSolver>
[[nodiscard]] ModalReport buckling_modes(Scene& model, LinearSolver& solver,
                                         const ModalOptions& options = {});

namespace detail {

/// Largest eigenvalues of B x = th A x by subspace iteration with Rayleigh's quotients.
template <class LinearSolver>
class Subspace {
public:
    Subspace(const SparseMatrix& A, const SparseMatrix& B, LinearSolver& solver)
        : A_(A), B_(B), solver_(solver) {}

    /// @param free  number of coordinates; the rest of the unknowns are multipliers
    Status run(int free, const ModalOptions& options, int& iterations) {
        const Eigen::Index size = A_.rows();
        const auto width = std::min<Eigen::Index>(2 * options.count + 8, free);
        // a fixed mixture of all modes: results repeat bit for bit
        MatrixX start(size, width);
        double state = 0.5;
        for (Eigen::Index k = 0; k < start.size(); ++k) {
            state = std::fmod(997.0 * state + 0.123456789, 1.0);
            start(k) = state - 0.5;
        }
        vectors = std::move(start);
        VectorX last = VectorX::Zero(options.count);
        for (iterations = 1; iterations <= options.max_iterations; ++iterations) {
            const MatrixX image = product(B_, vectors);
            VectorX column;
            for (Eigen::Index k = 0; k < vectors.cols(); ++k) {
                solver_.solve(image.col(k), column);
                vectors.col(k) = column;
            }
            if (!vectors.allFinite()) return Status::not_finite;
            if (!reduce(options.count)) return Status::singular;
            const VectorX wanted =
                values.head(std::min<Eigen::Index>(options.count, values.size()));
            if (wanted.size() == last.size() &&
                ((wanted - last).array().abs() <= options.tolerance * wanted.array().abs()).all())
                return Status::converged;
            last = wanted;
        }
        return Status::max_iterations;
    }

    /// Returns |B x - th A x|/(th |A x|) of mode k.
    [[nodiscard]] double residual(Eigen::Index k) const {
        const VectorX Ax = product(A_, vectors.col(k));
        return (product(B_, vectors.col(k)) - values[k] * Ax).norm() /
               (std::abs(values[k]) * Ax.norm());
    }

    VectorX values;   ///< by falling magnitude
    MatrixX vectors;  ///< columns, x^T A x = 1

private:
    [[nodiscard]] static MatrixX product(const SparseMatrix& matrix, const MatrixX& x) {
        if constexpr (LinearSolver::storage == Storage::lower) {
            return matrix.template selfadjointView<Eigen::Lower>() * x;
        } else {
            return matrix * x;
        }
    }

    /// Solves the problem on the span of the vectors; those that add nothing are left out.
    bool reduce(int count) {
        const MatrixX a = vectors.transpose() * product(A_, vectors);
        // of unit diagonal: columns differ by the ratio of the eigenvalues
        const VectorX diagonal = a.diagonal();
        if (!(diagonal.minCoeff() > 0.0)) return false;
        const VectorX scale = diagonal.cwiseSqrt().cwiseInverse();
        const MatrixX unit = scale.asDiagonal() * a * scale.asDiagonal();
        const Eigen::SelfAdjointEigenSolver<MatrixX> metric(unit);
        const VectorX& weights = metric.eigenvalues();
        Eigen::Index first = 0;
        while (first < weights.size() && weights[first] <= 1e-13 * weights[weights.size() - 1])
            ++first;
        const Eigen::Index rank = weights.size() - first;
        const MatrixX basis =
            vectors * (scale.asDiagonal() * metric.eigenvectors().rightCols(rank) *
                       weights.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal());
        const MatrixX b = basis.transpose() * product(B_, basis);
        const Eigen::SelfAdjointEigenSolver<MatrixX> reduced(0.5 * (b + b.transpose()));
        std::vector<Eigen::Index> order(static_cast<std::size_t>(rank));
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
        std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
            return std::abs(reduced.eigenvalues()[i]) > std::abs(reduced.eigenvalues()[j]);
        });
        MatrixX sorted(rank, rank);
        values.resize(rank);
        for (Eigen::Index k = 0; k < rank; ++k) {
            const Eigen::Index from = order[static_cast<std::size_t>(k)];
            values[k] = reduced.eigenvalues()[from];
            sorted.col(k) = reduced.eigenvectors().col(from);
        }
        vectors = basis * sorted;
        return rank >= std::min<Eigen::Index>(count, 1);
    }

    const SparseMatrix& A_;
    const SparseMatrix& B_;
    LinearSolver& solver_;
};

/// Factorises A, finds the modes and turns th into values.
template <class Scene, class LinearSolver, class Value>
ModalReport modes_of(const Assembly<Scene>& assembly, const SparseMatrix& A, const SparseMatrix& B,
                     LinearSolver& solver, const ModalOptions& options, const Value& value) {
    ModalReport report;
    solver.analyze(A);
    const FactorReport factor = solver.factorize(A);
    report.status = factor.status;
    if (factor.status != Status::converged) return report;
    const Numbering& numbering = assembly.numbering();
    if (factor.negative_pivots > numbering.multipliers()) {
        report.status = Status::singular;
        return report;
    }
    Subspace<LinearSolver> space(A, B, solver);
    report.status = space.run(numbering.free_coordinates(), options, report.iterations);
    const auto count = std::min<Eigen::Index>(options.count, space.values.size());
    for (Eigen::Index k = 0; k < count; ++k) {
        if (space.values[k] == 0.0) break;
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

inline void ModalOptions::check() const {
    detail::require(count >= 1, "ModalOptions: count must be at least 1, got ", count);
    detail::require(max_iterations >= 1, "ModalOptions: max_iterations must be at least 1, got ",
                    max_iterations);
    detail::require_finite("ModalOptions: factor", factor);
    detail::require_finite("ModalOptions: shift", shift);
    detail::require_positive("ModalOptions: probe", probe);
    detail::require_positive("ModalOptions: tolerance", tolerance);
}

template <class Scene, class LinearSolver>
ModalReport natural_modes(const Scene& model, LinearSolver& solver, const ModalOptions& options) {
    require_linear_solver<LinearSolver>();
    options.check();
    Assembly<Scene> assembly(model, LinearSolver::storage);
    const State& state = model.state();
    const VectorX rest = VectorX::Zero(state.q.size());
    const Instant instant{options.factor, options.factor};
    if (const auto fault =
            assembly.evaluate({state.q, rest, state.multipliers, instant}, Request::tangent))
        return {fault->status, {}, 0};
    const SparseMatrix mass = assembly.mass();
    const SparseMatrix A = assembly.tangent() - options.shift * mass;
    return detail::modes_of(assembly, A, mass, solver, options, [&](double th, double& scale) {
        scale = 1.0 / std::sqrt(std::abs(th));  // x^T M x = th where x^T A x = 1
        return options.shift + 1.0 / th;
    });
}

template <class Scene, class LinearSolver>
ModalReport buckling_modes(Scene& model, LinearSolver& solver, const ModalOptions& options) {
    require_linear_solver<LinearSolver>();
    options.check();
    Assembly<Scene> assembly(model, LinearSolver::storage);
    const State before = model.state();
    const VectorX rest = VectorX::Zero(before.q.size());
    const auto tangent = [&](double factor) {
        const State& state = model.state();
        const auto fault = assembly.evaluate({state.q, rest, state.multipliers, {factor, factor}},
                                             Request::tangent);
        return fault ? fault->status : Status::converged;
    };
    if (const Status status = tangent(0.0); status != Status::converged) return {status, {}, 0};
    const SparseMatrix unloaded = assembly.tangent();
    StaticsOptions loading;
    loading.last_factor = options.probe;
    const StaticsReport loaded = solve_statics(model, solver, loading);
    const Status status =
        loaded.status == Status::converged ? tangent(options.probe) : loaded.status;
    model.state() = before;
    if (status != Status::converged) return {status, {}, 0};
    const SparseMatrix change = (unloaded - assembly.tangent()) / options.probe;
    ModalReport report = detail::modes_of(assembly, unloaded, change, solver, options,
                                          [](double th, double&) { return 1.0 / th; });
    return report;
}

}  // namespace ancf
