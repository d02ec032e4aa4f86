// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The linear systems of a step of Radau IIA: one real matrix, and one complex matrix for each pair
/// of stages. Equations (4) to (8) of docs/theory-radau.md.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/solver/complex_solver_for.hpp>
#include <ancf/solver/dense_lu.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <utility>

namespace ancf::detail {

/// The coefficients of a method of s stages, made at set-up.
struct RadauTableau {
    List<double> nodes;       ///< c, ascending, the last one 1
    MatrixX inverse;          ///< W = A^-1, s x s
    MatrixX square;           ///< W^2
    MatrixX double_integral;  ///< A^2
    /// mu: the real eigenvalue of W, then one of each conjugate pair.
    List<std::complex<double>> eigenvalues;
    /// The real part of T^-1, s x s: a row of the real eigenvalue, then of each pair the real and
    /// the imaginary part of one row.
    MatrixX to_modes;
    MatrixX from_modes;  ///< the inverse of to_modes
};

/// A vector of each stage.
using Stages = List<VectorX>;

/// Returns W: differentiation on the points 0 and c_i, by their barycentric weights.
[[nodiscard]] inline MatrixX differentiation(const List<double>& nodes) {
    const std::size_t stages = nodes.size();
    List<double> points = {0.0};
    points.insert(points.end(), nodes.begin(), nodes.end());
    List<double> weights(stages + 1, 1.0);
    for (std::size_t i = 0; i <= stages; ++i)
        for (std::size_t j = 0; j <= stages; ++j)
            if (i != j) weights[i] /= points[i] - points[j];
    MatrixX W = MatrixX::Zero(stages, stages);
    for (std::size_t i = 0; i < stages; ++i)
        for (std::size_t j = 0; j <= stages; ++j) {
            if (j == i + 1) continue;
            const double entry = weights[j] / weights[i + 1] / (points[i + 1] - points[j]);
            if (j > 0) W(i, j - 1) = entry;
            W(i, i) -= entry;
        }
    return W;
}

/// Returns the columns of T for the eigenvalues, their conjugates included.
[[nodiscard]] inline List<std::complex<double>> radau_column(
    const List<double>& nodes, const std::complex<double>& eigenvalue) {
    const std::size_t stages = nodes.size();
    List<std::complex<double>> column;
    for (const double x : nodes) {
        // Taylor coefficients of N at x, the product of all (x - c) + d in powers of d
        List<double> taylor = {1.0};
        for (const double node : nodes) {
            taylor.push_back(0.0);
            for (std::size_t k = taylor.size() - 1; k > 0; --k)
                taylor[k] = taylor[k] * (x - node) + taylor[k - 1];
            taylor[0] *= x - node;
        }
        std::complex<double> sum = 0.0, power = 1.0;
        for (std::size_t k = 1; k <= stages; ++k) {
            power *= static_cast<double>(k) / eigenvalue;
            sum += taylor[k] * power;
        }
        column.push_back(sum);
    }
    return column;
}

/// Returns the method of three or five stages.
[[nodiscard]] inline RadauTableau radau_tableau(int stages) {
    using Complex = std::complex<double>;
    RadauTableau tableau;
    if (stages == 3) {
        tableau.nodes = {0.155051025721682190, 0.644948974278317810, 1.0};
        tableau.eigenvalues = {3.63783425274449573, {2.68108287362775213, 3.05043019924741057}};
    } else {
        tableau.nodes = {0.0571041961145176822, 0.276843013638123828, 0.583590432368916820,
                         0.860240135656219448, 1.0};
        tableau.eigenvalues = {6.28670475172927665,
                               {3.65569432546357226, 6.54373689936007729},
                               {5.70095329867178942, 3.21026560030854988}};
    }
    const auto inverse_of = [](auto matrix) {
        DenseLu<typename decltype(matrix)::Scalar> lu{std::move(matrix), {}};
        static_cast<void>(lu.factorize());  // the matrices of a method are regular
        return lu.inverse();
    };
    const auto squared = [&](const MatrixX& a) {
        MatrixX result = MatrixX::Zero(stages, stages);
        for (int i = 0; i < stages; ++i)
            for (int j = 0; j < stages; ++j)
                for (int k = 0; k < stages; ++k) result(i, j) += a(i, k) * a(k, j);
        return result;
    };
    tableau.inverse = differentiation(tableau.nodes);
    tableau.square = squared(tableau.inverse);
    tableau.double_integral = squared(inverse_of(tableau.inverse));

    tableau.to_modes.resize(stages, stages);
    tableau.from_modes.resize(stages, stages);
    DynamicMatrix<Complex> T(stages, stages);  // the kept columns, each before its conjugate
    int at = 0;
    for (const Complex& eigenvalue : tableau.eigenvalues) {
        const bool real = eigenvalue.imag() == 0.0;
        const List<Complex> column = radau_column(tableau.nodes, eigenvalue);
        for (int i = 0; i < stages; ++i) {
            // of a pair the sum of both is twice the real part
            tableau.from_modes(i, at) = (real ? 1.0 : 2.0) * column[i].real();
            T(i, at) = column[i];
            if (real) continue;
            tableau.from_modes(i, at + 1) = -2.0 * column[i].imag();
            T(i, at + 1) = std::conj(column[i]);
        }
        at += real ? 1 : 2;
    }
    const auto inverse = inverse_of(T);
    for (int j = 0; j < stages; ++j) {
        tableau.to_modes(0, j) = inverse(0, j).real();
        for (int row = 1; row < stages; row += 2) {
            tableau.to_modes(row, j) = inverse(row, j).real();
            tableau.to_modes(row + 1, j) = inverse(row, j).imag();
        }
    }
    return tableau;
}

/// Sums Width entries from k over the stages.
template <int Count, int Width>
inline void sum_part(const double (&weights)[Count][Count], const double* const (&in)[Count],
                     double* const (&out)[Count], Eigen::Index k) {
    using Part = Vector<double, Width>;
    Part sums[Count];
    for (int i = 0; i < Count; ++i) sums[i].setZero();
    for (int j = 0; j < Count; ++j) {
        const Part part = Eigen::Map<const Part>(in[j] + k);
        for (int i = 0; i < Count; ++i) sums[i] += weights[i][j] * part;
    }
    for (int i = 0; i < Count; ++i) Eigen::Map<Part>(out[i] + k) = sums[i];
}

/// Sums over so many stages.
template <int Count>
void sum_all(const MatrixX& weights, double scale, const Stages& in, Stages& out) {
    constexpr int width = 8;
    double scaled[Count][Count];
    const double* from[Count];
    double* to[Count];
    for (int i = 0; i < Count; ++i) {
        for (int j = 0; j < Count; ++j) scaled[i][j] = scale * weights(i, j);
        from[i] = in[i].data();
        to[i] = out[i].data();
    }
    const Eigen::Index size = in[0].size();
    Eigen::Index k = 0;
    for (; k + width <= size; k += width) sum_part<Count, width>(scaled, from, to, k);
    for (; k < size; ++k) sum_part<Count, 1>(scaled, from, to, k);
}

/// Sums over the stages, three or five: out_i = scale sum_j weights(i, j) in_j, all of one size.
inline void sum_stages(const MatrixX& weights, double scale, const Stages& in, Stages& out) {
    in.size() == 3 ? sum_all<3>(weights, scale, in, out) : sum_all<5>(weights, scale, in, out);
}

/// Returns the values at x of the Lagrange polynomials on the nodes, one of each; the nodes differ.
[[nodiscard]] inline List<double> lagrange_weights(const List<double>& nodes, double x) {
    List<double> weights(nodes.size(), 1.0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j)
            if (i != j) weights[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
    return weights;
}

/// The matrices [M + (h/mu) D + (h/mu)^2 K, G^T; G, 0] for all mu, and their factors; of n free
/// coordinates and m multipliers.
class RadauSystem {
public:
    /// Analyses the pattern for all solvers.
    ANCF_LAZY RadauSystem(const DynamicProblem& problem, LinearSolver& solver,
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
        for (std::size_t k = 1; k < tableau.eigenvalues.size(); ++k)
            complex_solvers_.push_back(complex_solver_for(solver, system_));
        rhs_.resize(problem.size() + problem.multipliers());
        modal_.resize(tableau.nodes.size());
        modal_lengths_.resize(tableau.nodes.size());
        complex_.resize(rhs_.size());
    }

    /// Factorises all matrices for a step, with K, G and D of the problem's last evaluation, of
    /// tangent and damping; adds to a count how many.
    [[nodiscard]] Status factorise(double h, long& count) {
        width_ = 0.0;
        const double* mass = problem_.mass().valuePtr();
        const double* tangent = problem_.tangent().valuePtr();
        const double* damping = problem_.damping().valuePtr();
        std::copy_n(damping, entries(damping_), damping_.valuePtr());
        damped_ = std::any_of(damping, damping + entries(damping_),
                              [](double value) { return value != 0.0; });
        double* system = system_.valuePtr();
        const double tau = h / tableau_.eigenvalues.front().real();
        for (std::size_t k = 0; k < stiff_.size(); ++k)
            system[k] =
                mass[k] + (stiff_[k] != 0 ? tau * tau : 1.0) * tangent[k] + tau * damping[k];
        ++count;
        if (const Status status = solver_.factorize(system_).status; status != Status::converged)
            return status;
        for (std::size_t mode = 1; mode < tableau_.eigenvalues.size(); ++mode) {
            const std::complex<double> t = h / tableau_.eigenvalues[mode];
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

    /// The step that is factorised, s; 0 where there is none.
    [[nodiscard]] double width() const noexcept { return width_; }

    /// Solves for the corrections of Y and of the multipliers.
    /// @param h       the step of the equations, s; those of another step than width() are solved
    ///                by its matrices.
    /// @param force   of each stage the residual of the equation of motion, n entries, of the units
    ///                of generalised forces.
    /// @param lengths of each stage g, m entries, of the units of the constraints.
    /// @param Y       of each stage (2), n entries, of the units of accelerations.
    /// @param lambda  of each stage the multipliers, m entries.
    void solve(double h, const Stages& force, const Stages& lengths, Stages& Y, Stages& lambda) {
        const Eigen::Index n = problem_.size(), m = problem_.multipliers();
        for (std::size_t i = 0; i < force.size(); ++i) {
            modal_[i].resize(n);
            modal_lengths_[i].resize(m);
            Y[i].resize(n);
            lambda[i].resize(m);
        }
        sum_stages(tableau_.to_modes, -1.0, force, modal_);
        sum_stages(tableau_.to_modes, -1.0, lengths, modal_lengths_);
        const double mu = tableau_.eigenvalues.front().real(), scale = mu * mu / (h * h);
        for (Eigen::Index k = 0; k < n; ++k) rhs_[k] = modal_[0][k];
        for (Eigen::Index k = 0; k < m; ++k) rhs_[n + k] = scale * modal_lengths_[0][k];
        solve_with(solver_, rhs_, solution_);
        for (Eigen::Index k = 0; k < n; ++k) modal_[0][k] = solution_[k] / (mu * mu);
        for (Eigen::Index k = 0; k < m; ++k) modal_lengths_[0][k] = solution_[n + k];
        for (std::size_t mode = 1; mode < tableau_.eigenvalues.size(); ++mode)
            solve_pair(mode, h, modal_[2 * mode - 1], modal_[2 * mode],
                       modal_lengths_[2 * mode - 1], modal_lengths_[2 * mode]);
        sum_stages(tableau_.from_modes, 1.0, modal_, Y);
        sum_stages(tableau_.from_modes, 1.0, modal_lengths_, lambda);
    }

    /// Solves [M + tau D + tau^2 K, G^T; G, 0] (e, nu) = ((M + tau D) a + M b, 0), tau = h/mu_0, h
    /// that of width().
    /// @param a, b  n entries each, of the units of coordinates.
    /// @return e, until the next call.
    [[nodiscard]] const VectorX& filter(const VectorX& a, const VectorX& b) {
        const double tau = width_ / tableau_.eigenvalues.front().real();
        error_.setZero(a.size());
        add_product(problem_.compact_mass(), Storage::full, 1.0, a + b, error_);
        if (damped_) add_product(damping_, solver_.storage(), tau, a, error_);
        rhs_.setZero();
        std::copy_n(error_.data(), error_.size(), rhs_.data());
        solve_with(solver_, rhs_, solution_);
        std::copy_n(solution_.data(), error_.size(), error_.data());
        return error_;
    }

private:
    /// Solves for one pair, real and imaginary parts apart.
    void solve_pair(std::size_t mode, double h, VectorX& real, VectorX& imaginary,
                    VectorX& real_lengths, VectorX& imaginary_lengths) {
        const Eigen::Index n = real.size(), m = real_lengths.size();
        const std::complex<double> square = tableau_.eigenvalues[mode] * tableau_.eigenvalues[mode];
        const std::complex<double> inverse = 1.0 / square, scale = square / (h * h);
        for (Eigen::Index k = 0; k < n; ++k) complex_[k] = {real[k], imaginary[k]};
        for (Eigen::Index k = 0; k < m; ++k)
            complex_[n + k] = scale * std::complex<double>(real_lengths[k], imaginary_lengths[k]);
        complex_solvers_[mode - 1]->solve(complex_);
        require(complex_.size() == n + m, solver_.name(), ": the complex solver gave ",
                complex_.size(), " entries for ", n + m);
        // by parts: the product of complex numbers looks for infinities
        const auto* pairs = reinterpret_cast<const double*>(complex_.data());
        for (Eigen::Index k = 0; k < n; ++k) {
            real[k] = inverse.real() * pairs[2 * k] - inverse.imag() * pairs[2 * k + 1];
            imaginary[k] = inverse.real() * pairs[2 * k + 1] + inverse.imag() * pairs[2 * k];
        }
        for (Eigen::Index k = 0; k < m; ++k) {
            real_lengths[k] = complex_[n + k].real();
            imaginary_lengths[k] = complex_[n + k].imag();
        }
    }

    const DynamicProblem& problem_;
    LinearSolver& solver_;
    const RadauTableau& tableau_;
    List<std::unique_ptr<ComplexSolver>> complex_solvers_;  // of modes 1, 2, ...
    SparseMatrix damping_, system_;
    bool damped_ = false;
    List<char> stiff_;  // per value: 1 in the block of coordinates, 0 elsewhere
    List<std::complex<double>> values_;
    double width_ = 0.0;
    VectorX rhs_, solution_, error_;
    Stages modal_, modal_lengths_;  // right-hand sides and solutions by modes, real
    ComplexVectorX complex_;
};

}  // namespace ancf::detail
