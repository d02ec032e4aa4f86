// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of radau_system.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/radau_system.hpp>
#include <ancf/solver/complex_solver_for.hpp>

#include <algorithm>
#include <cstddef>

namespace ancf::detail {

ANCF_LAZY RadauSystem::RadauSystem(const DynamicProblem& problem, LinearSolver& solver,
                                   const RadauTableau& tableau)
    : problem_(problem),
      solver_(solver),
      tableau_(tableau),
      damping_(problem.mass()),
      system_(problem.mass()),
      stiff_(static_cast<std::size_t>(entries(system_))),
      values_(stiff_.size()) {
    const int n = problem.size();
    for (int j = 0; j < system_.outerSize(); ++j)
        for (int k = system_.outerIndexPtr()[j]; k < system_.outerIndexPtr()[j + 1]; ++k)
            stiff_[k] = j < n && system_.innerIndexPtr()[k] < n;
    solver_.analyze(system_);
    for (std::size_t k = 1; k < tableau.modes.size(); ++k)
        complex_solvers_.push_back(complex_solver_for(solver, system_));
    rhs_.resize(problem.size() + problem.multipliers());
    complex_.resize(rhs_.size());
}

ANCF_INLINE Status RadauSystem::factorise(double h, long& count) {
    width_ = 0.0;
    const double* mass = problem_.mass().valuePtr();
    const double* tangent = problem_.tangent().valuePtr();
    const double* damping = problem_.damping().valuePtr();
    std::copy_n(damping, entries(damping_), damping_.valuePtr());
    damped_ = std::any_of(damping, damping + entries(damping_),
                          [](double value) { return value != 0.0; });
    double* system = system_.valuePtr();
    const double tau = h / tableau_.modes.front().eigenvalue.real();
    for (std::size_t k = 0; k < stiff_.size(); ++k)
        system[k] = mass[k] + (stiff_[k] != 0 ? tau * tau : 1.0) * tangent[k] + tau * damping[k];
    ++count;
    if (const Status status = solver_.factorize(system_).status; status != Status::converged)
        return status;
    for (std::size_t mode = 1; mode < tableau_.modes.size(); ++mode) {
        const std::complex<double> t = h / tableau_.modes[mode].eigenvalue;
        const double first[2] = {t.real(), t.imag()};
        const double second[2] = {(t * t).real(), (t * t).imag()};
        for (std::size_t k = 0; k < stiff_.size(); ++k) {
            const double real = stiff_[k] != 0 ? second[0] : 1.0;
            const double imaginary = stiff_[k] != 0 ? second[1] : 0.0;
            values_[k] = {mass[k] + real * tangent[k] + first[0] * damping[k],
                          imaginary * tangent[k] + first[1] * damping[k]};
        }
        ++count;
        if (const Status status = complex_solvers_[mode - 1]->factorize(values_);
            status != Status::converged)
            return status;
    }
    width_ = h;
    return Status::converged;
}

ANCF_INLINE void RadauSystem::solve(double h, const Stages& force, const Stages& lengths, Stages& Y,
                                    Stages& lambda) {
    const Eigen::Index n = problem_.size(), m = problem_.multipliers();
    const std::size_t stages = force.size();
    for (std::size_t i = 0; i < stages; ++i) {
        Y[i].setZero(n);
        lambda[i].setZero(m);
    }
    for (std::size_t mode = 0; mode < tableau_.modes.size(); ++mode) {
        const auto& [mu, column, row] = tableau_.modes[mode];
        const std::complex<double> square = mu * mu, inverse = 1.0 / square;
        const std::complex<double> scale = square / (h * h);
        // Of a pair the sum of both is twice the real part.
        if (mode == 0) {
            rhs_.setZero();
            for (std::size_t i = 0; i < stages; ++i) {
                const double w = -row[i].real();
                rhs_.head(n) += w * force[i];
                rhs_.tail(m) += w * scale.real() * lengths[i];
            }
            solver_.solve(rhs_, solution_);
            for (std::size_t i = 0; i < stages; ++i) {
                const double w = column[i].real();
                Y[i] += w * inverse.real() * solution_.head(n);
                lambda[i] += w * solution_.tail(m);
            }
            continue;
        }
        complex_.setZero();
        double* pairs = reinterpret_cast<double*>(complex_.data());
        for (std::size_t i = 0; i < stages; ++i) {
            const std::complex<double> w = -row[i], u = w * scale;
            for (Eigen::Index k = 0; k < n; ++k) {
                pairs[2 * k] += w.real() * force[i][k];
                pairs[2 * k + 1] += w.imag() * force[i][k];
            }
            for (Eigen::Index k = 0; k < m; ++k) complex_[n + k] += u * lengths[i][k];
        }
        complex_solvers_[mode - 1]->solve(complex_);
        pairs = reinterpret_cast<double*>(complex_.data());  // a solver may take another memory
        for (std::size_t i = 0; i < stages; ++i) {
            const std::complex<double> w = 2.0 * column[i], u = w * inverse;
            for (Eigen::Index k = 0; k < n; ++k)
                Y[i][k] += u.real() * pairs[2 * k] - u.imag() * pairs[2 * k + 1];
            for (Eigen::Index k = n; k < n + m; ++k)
                lambda[i][k - n] += w.real() * pairs[2 * k] - w.imag() * pairs[2 * k + 1];
        }
    }
}

ANCF_INLINE const VectorX& RadauSystem::filter(const VectorX& a, const VectorX& b) {
    const double tau = width_ / tableau_.modes.front().eigenvalue.real();
    error_.setZero(a.size());
    add_product(problem_.compact_mass(), Storage::full, 1.0, a + b, error_);
    if (damped_) add_product(damping_, solver_.storage(), tau, a, error_);
    rhs_.setZero();
    std::copy_n(error_.data(), error_.size(), rhs_.data());
    solver_.solve(rhs_, solution_);
    std::copy_n(solution_.data(), error_.size(), error_.data());
    return error_;
}

}  // namespace ancf::detail
