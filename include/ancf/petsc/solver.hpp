// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// PETSc's linear solvers: direct ones such as MUMPS, iterative ones with a preconditioner.
///
///     const ancf::petsc::Session session(&argc, &argv);
///     ancf::petsc::Solver solver(model, ancf::petsc::SolverOptions::iterative());
///     const auto report = ancf::solve_statics(model, solver);

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/petsc/session.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace ancf::petsc {

/// What PETSc is asked for.
struct SolverOptions {
    /// Options as on PETSc's command line, without the prefix. What the command line says of the
    /// same option with the prefix goes before.
    std::string options = "-ksp_type preonly -pc_type lu -pc_factor_mat_solver_type mumps";
    /// What the names of the solver's options begin with on the command line, such as "frame_".
    /// Empty: one of its own, which no command line knows.
    std::string prefix{};

    /// MUMPS, for every scene: the default.
    [[nodiscard]] static SolverOptions direct(std::string prefix = {}) {
        return {SolverOptions().options, std::move(prefix)};
    }
    /// Conjugate gradients with algebraic multigrid, for scenes without multipliers whose loads are
    /// symmetric; docs/petsc.md says how the rest is chosen.
    [[nodiscard]] static SolverOptions iterative(std::string prefix = {});
};

namespace detail {
struct SolverRun;
}

/// Solves by a KSP of PETSc.
///
/// With a scene the solver knows blocks, rigid motions and which slopes of member ends it can
/// eliminate beforehand, so that multigrid works. A part of a scene is solved by all parts
/// together, each with the entries of its own elements.
class Solver final : public LinearSolver {
public:
    /// A solver of any matrix, in this process alone.
    /// @throws InvalidArgument for options that PETSc refuses, or where PETSc does not run.
    explicit Solver(SolverOptions options = {});
    /// A solver of the tangents of one scene, or of the part that this process holds. The scene
    /// outlives it.
    /// @throws InvalidArgument as above.
    explicit Solver(const Scene& scene, SolverOptions options = {});
    ANCF_INLINE_VIRTUAL ~Solver() override;
    Solver(Solver&&) = delete;

    /// All of a matrix is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::full; }

    /// @throws InvalidArgument unless square, compressed and, with a scene, of its size.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& matrix) override;

    /// Sets up the preconditioner. Status singular where a factorisation finds it so, diverged with
    /// the reason in failure() for anything else that PETSc, or the choice of solver, refuses.
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport factorize(const SparseMatrix& matrix) override;

    /// Solves A x = b; entries of x are NaN where the KSP diverges, and failure() has its reason.
    ANCF_INLINE_VIRTUAL void solve(const VectorX& b, VectorX& x) const override;

    [[nodiscard]] std::string_view name() const noexcept override { return "petsc"; }
    [[nodiscard]] ANCF_INLINE_VIRTUAL std::string failure() const override;
    /// True unless the preconditioner is a factorisation.
    [[nodiscard]] ANCF_INLINE_VIRTUAL bool iterative() const noexcept override;

    /// Returns the iterations of the last solution.
    [[nodiscard]] int iterations() const noexcept;
    /// Returns the most iterations that a solution took so far.
    [[nodiscard]] int most_iterations() const noexcept;
    /// Returns the number of rows that PETSc sees, over all processes; 0 before analyze.
    [[nodiscard]] long rows() const noexcept;
    /// Returns the number of rows of a block; 1 before analyze.
    [[nodiscard]] int block_size() const noexcept;

private:
    std::unique_ptr<detail::SolverRun> run_;
    ancf::detail::SolverStage stage_;
};

}  // namespace ancf::petsc

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/solver.ipp>  // IWYU pragma: export
#endif
