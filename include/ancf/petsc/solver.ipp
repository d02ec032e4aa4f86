// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/numbering.hpp>
#include <ancf/assembly/resultant.hpp>
#include <ancf/error.hpp>
#include <ancf/petsc/partition.hpp>
#include <ancf/petsc/solver.hpp>
#include <ancf/solver/condensation.hpp>

#include <petscksp.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace ancf::petsc {

ANCF_INLINE SolverOptions SolverOptions::iterative(std::string prefix) {
    return {
        "-ksp_type cg -ksp_rtol 1e-8 -ksp_max_it 2000 -pc_type gamg "
        "-pc_gamg_aggressive_coarsening 0 -mg_levels_pc_type pbjacobi "
        "-mg_levels_esteig_ksp_max_it 20 -mg_levels_ksp_chebyshev_esteig 0,0.1,0,1.2 "
        "-pc_mg_cycle_type w",
        std::move(prefix)};
}

namespace detail {

/// Options that stand in PETSc's table while a solver needs them.
class OptionsInTable {
public:
    /// @throws InvalidArgument for a text that is no list of options.
    OptionsInTable(const std::string& text, const std::string& prefix) {
        std::map<std::string, std::string> values;
        std::string* value = nullptr;  // of the last name
        std::istringstream words(text);
        for (std::string word; words >> word;) {
            PetscBool is_name = PETSC_FALSE;  // PETSc takes two dashes for one
            check(PetscOptionsValidKey(word.c_str(), &is_name));
            const bool doubled = word.compare(0, 2, "--") == 0;
            if (is_name != PETSC_FALSE && !doubled) {
                value = &values["-" + prefix + word.substr(1)];
                value->clear();
                continue;
            }
            ancf::detail::require(!doubled && value != nullptr && value->empty(),
                                  "petsc::SolverOptions: \"", word,
                                  "\" is no name of an option, nor follows one, in \"", text, "\"");
            *value = word;
        }
        for (const auto& option : values) {
            PetscBool given = PETSC_FALSE;  // on the command line
            check(PetscOptionsHasName(nullptr, nullptr, option.first.c_str(), &given));
            if (given != PETSC_FALSE) continue;
            check(PetscOptionsSetValue(nullptr, option.first.c_str(), option.second.c_str()));
            names_.push_back(option.first);
        }
    }
    OptionsInTable(const OptionsInTable&) = delete;
    OptionsInTable& operator=(const OptionsInTable&) = delete;
    ~OptionsInTable() {
        for (const std::string& name : names_)
            static_cast<void>(PetscOptionsClearValue(nullptr, name.c_str()));
    }

private:
    std::vector<std::string> names_;
};

/// The objects of PETSc, and how a matrix becomes theirs.
struct SolverRun {
    const Scene* scene;
    SolverOptions options;
    MPI_Comm comm = PETSC_COMM_SELF;
    std::unique_ptr<OptionsInTable> table;
    const Partition* partition = nullptr;
    std::unique_ptr<Partition> alone;  // of a whole scene
    Numbering numbering;
    Rows rows;
    ancf::detail::Condensation condensation;
    bool symmetric = false, factorises = false;
    PetscInt size = 0;           // rows of all processes
    std::vector<double> values;  // handed over
    Handle<KSP> ksp;
    Handle<Mat> matrix;
    Handle<Vec> b, x;
    std::string failure;
    int iterations = 0, most = 0;

    SolverRun(const Scene* of, SolverOptions wanted) : scene(of), options(std::move(wanted)) {
        const QuietErrors quiet;
        static long count = 0;
        if (options.prefix.empty()) options.prefix = "ancf_" + std::to_string(++count) + "_";
        table = std::make_unique<OptionsInTable>(options.options, options.prefix);
        if (scene != nullptr) partition = static_cast<const Partition*>(scene->exchange());
        if (partition != nullptr) comm = partition->comm();
        try {
            check(KSPCreate(comm, ksp.fresh()));
            check(KSPSetOptionsPrefix(ksp, options.prefix.c_str()));
            check(KSPSetErrorIfNotConverged(ksp, PETSC_FALSE));
            check(KSPSetFromOptions(ksp));
        } catch (const std::runtime_error& failed) {
            static_cast<void>(ksp.fresh());  // while errors are quiet
            ancf::detail::reject("petsc::SolverOptions \"", options.options, "\": ", failed.what());
        }
        PC pc = nullptr;
        PetscBool direct = PETSC_FALSE;
        check(KSPGetPC(ksp, &pc));
        check(PetscObjectTypeCompareAny(reinterpret_cast<PetscObject>(pc), &direct, PCLU,
                                        PCCHOLESKY, ""));
        factorises = direct != PETSC_FALSE;
    }

    void analyze(const SparseMatrix& pattern) {
        check(KSPReset(ksp));
        rows = {};
        if (scene == nullptr) {
            rows.last = static_cast<PetscInt>(pattern.rows());
            for (PetscInt k = 0; k < rows.last; ++k) rows.of_equation.push_back(k);
        } else {
            numbering = Numbering(*scene);
            ancf::detail::require(pattern.rows() == numbering.unknowns(),
                                  "petsc::Solver: the scene has ", numbering.unknowns(),
                                  " unknowns, the matrix ", pattern.rows());
            if (scene->exchange() == nullptr) {  // it may have changed
                alone = std::make_unique<Partition>(*scene, PETSC_COMM_SELF);
                partition = alone.get();
            }
            rows = partition->rows(*scene, numbering);
            symmetric = partition->whole().has_symmetric_loads();
        }
        condensation = ancf::detail::Condensation(pattern, rows.sets, symmetric);

        std::vector<PetscInt> is, js;  // PETSc leaves out entries in rows of -1
        for (int j = 0; j < pattern.cols(); ++j) {
            if (!condensation.keeps(j)) continue;
            for (int k = pattern.outerIndexPtr()[j]; k < pattern.outerIndexPtr()[j + 1]; ++k) {
                is.push_back(rows.of_equation[pattern.innerIndexPtr()[k]]);
                js.push_back(rows.of_equation[j]);
            }
        }
        for (const auto& entry : condensation.filled()) {
            is.push_back(rows.of_equation[entry.first]);
            js.push_back(rows.of_equation[entry.second]);
        }
        is.insert(is.end(), rows.idle.begin(), rows.idle.end());
        js.insert(js.end(), rows.idle.begin(), rows.idle.end());
        values.assign(is.size(), 1.0);  // of rows without an equation it stays

        const PetscInt own = rows.last - rows.first;
        check(MatCreate(comm, matrix.fresh()));
        check(MatSetSizes(matrix, own, own, PETSC_DETERMINE, PETSC_DETERMINE));
        check(MatSetType(matrix, MATAIJ));
        check(MatSetBlockSize(matrix, rows.block));
        check(MatSetPreallocationCOO(matrix, is.size(), is.data(), js.data()));
        Mat diagonal = nullptr;  // PETSc 3.18 forgets the blocks of this process's part
        check(MatGetDiagonalBlock(matrix, &diagonal));
        check(MatSetBlockSize(diagonal, rows.block));
        if (symmetric) {
            check(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
            check(MatSetOption(matrix, MAT_SYMMETRY_ETERNAL, PETSC_TRUE));
        }
        check(MatGetSize(matrix, &size, nullptr));
        check(MatCreateVecs(matrix, x.fresh(), b.fresh()));
    }

    FactorReport factorize(const SparseMatrix& from) {
        failure.clear();
        iterations = 0;
        FactorReport report;
        try {
            report.status = prepare(from);
        } catch (const std::runtime_error& failed) {
            report.status = Status::diverged;
            failure = failed.what();
        }
        return report;
    }

    Status prepare(const SparseMatrix& from) {
        if (largest(ancf::detail::all_finite(from) ? 0 : 1) > 0) return Status::not_finite;
        if (size > 0) failure = refusal();
        if (!failure.empty()) return Status::diverged;
        if (largest(condensation.reduce(from, values.data()) ? 0 : 1) > 0) {
            failure = "the slope r_x of a member's end has no stiffness";
            return Status::singular;
        }
        if (size == 0) return Status::converged;
        check(MatSetValuesCOO(matrix, values.data(), INSERT_VALUES));
        if (!factorises) set_rigid_motions();
        check(KSPSetOperators(ksp, matrix, matrix));
        check(KSPSetUp(ksp));
        PC pc = nullptr;
        PCFailedReason reason = PC_NOERROR;
        check(KSPGetPC(ksp, &pc));
        check(PCGetFailedReason(pc, &reason));
        const int error =
            std::numeric_limits<int>::max();  // PC_SETUP_ERROR is less than PC_NOERROR
        const int worst = largest(reason < 0 ? error : reason);
        if (worst == PC_NOERROR) return Status::converged;
        reason = worst == error ? PC_SETUP_ERROR : static_cast<PCFailedReason>(worst);
        failure = std::string("PETSc: the preconditioner failed: ") + PCFailedReasons[reason];
        check(KSPReset(ksp));  // MUMPS would not recover
        const bool pivot =
            reason == PC_FACTOR_NUMERIC_ZEROPIVOT || reason == PC_FACTOR_STRUCT_ZEROPIVOT;
        return pivot ? Status::singular : Status::diverged;
    }

    /// Returns the largest of the numbers that the processes give.
    [[nodiscard]] int largest(int value) const {
        MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MAX, comm);
        return value;
    }

    /// Says why a kind of solver does not suit the scene; empty where it does.
    [[nodiscard]] std::string refusal() const {
        if (scene == nullptr || factorises) return {};
        if (!partition->whole().constraints().empty())
            return "a scene with multipliers needs a direct solver: -pc_type lu "
                   "-pc_factor_mat_solver_type mumps";
        KSPType type = nullptr;
        check(KSPGetType(ksp, &type));
        const std::string name = type != nullptr ? type : "";
        const bool needs_symmetry = name.find("cg") != std::string::npos &&
                                    name.find("bcgs") != 0 && name != "cgs" && name != "cgne";
        if (!symmetric && (needs_symmetry || name == "minres" || name == "symmlq"))
            return "a load has an unsymmetric stiffness, which " + name +
                   " cannot solve: take gmres or a direct solver";
        return {};
    }

    /// Gives PETSc translations of positions, and w x v of positions and slopes, where the scene
    /// stands now. Where nodes differ, or have positions alone, a few of them cannot hold six
    /// motions: PETSc's own choice of three, a constant in each direction, stays.
    void set_rigid_motions() {
        if (scene == nullptr || rows.block <= scene->dimension()) return;
        VectorX free;
        std::vector<Handle<Vec>> modes;
        for (int motion = 0; motion < (scene->dimension() == 3 ? 6 : 3); ++motion) {
            numbering.gather_free(rigid_motion(*scene, scene->state().q, motion), free);
            check(VecDuplicate(x, modes.emplace_back().fresh()));
            const Vec mode = modes.back();
            write(free, mode);
            for (int sweep = 0; sweep < 2; ++sweep)
                for (std::size_t k = 0; k + 1 < modes.size(); ++k) {
                    PetscScalar share = 0.0;
                    check(VecDot(mode, modes[k], &share));
                    check(VecAXPY(mode, -share, modes[k]));
                }
            PetscReal length = 0.0;
            check(VecNormalize(mode, &length));
            if (length <= 1e-12) modes.pop_back();
        }
        const std::vector<Vec> all(modes.begin(), modes.end());
        Handle<MatNullSpace> space;
        check(MatNullSpaceCreate(comm, PETSC_FALSE, static_cast<PetscInt>(all.size()), all.data(),
                                 space.fresh()));
        check(MatSetNearNullSpace(matrix, space));
    }

    void solve(const VectorX& right, VectorX& out) {
        failure.clear();
        const VectorX given = right;  // b and x may be the same vector
        out.resize(given.size());
        try {
            if (size == 0 || solve_rows(given, out)) condensation.complete(given, out);
        } catch (const std::runtime_error& failed) {
            failure = failed.what();
        }
        if (!failure.empty()) out.setConstant(std::numeric_limits<double>::quiet_NaN());
    }

    /// Sets the entries of all equations that are left.
    [[nodiscard]] bool solve_rows(const VectorX& right, VectorX& out) {
        out = condensation.shift(right);
        for_own([&](auto k, auto) { out[k] += right[k]; });
        sum(out);
        write(out, b);
        check(KSPSolve(ksp, b, x));
        KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
        PetscInt taken = 0;
        check(KSPGetConvergedReason(ksp, &reason));
        check(KSPGetIterationNumber(ksp, &taken));
        iterations = static_cast<int>(taken);
        most = std::max(most, iterations);
        if (reason < 0) {
            failure = std::string("PETSc: ") + KSPConvergedReasons[reason] + " after " +
                      std::to_string(taken) + " iterations";
            return false;
        }
        const PetscScalar* entry = nullptr;
        check(VecGetArrayRead(x, &entry));
        out.setZero();
        for_own([&](auto k, auto row) { out[k] = entry[row]; });
        check(VecRestoreArrayRead(x, &entry));
        sum(out);
        return true;
    }

    /// Calls visit(equation, row) for the own rows, which it counts from 0.
    template <class Visitor>
    void for_own(const Visitor& visit) const {
        for (std::size_t k = 0; k < rows.of_equation.size(); ++k)
            if (rows.own(rows.of_equation[k])) visit(k, rows.of_equation[k] - rows.first);
    }

    /// Writes entries of equations to a vector of PETSc.
    void write(const VectorX& from, Vec to) const {
        PetscScalar* entry = nullptr;
        check(VecSet(to, 0.0));
        check(VecGetArray(to, &entry));
        for_own([&](auto k, auto row) { entry[row] = from[k]; });
        check(VecRestoreArray(to, &entry));
    }

    /// Replaces entries of equations by their sums over all processes.
    void sum(VectorX& entries) const {
        if (Session::ranks(comm) == 1) return;
        VectorX all = VectorX::Zero(numbering.coordinates()), free;
        numbering.add_free_force(entries, 1.0, all);
        partition->add(all);
        numbering.gather_free(all, free);
        entries.head(free.size()) = free;
    }
};

}  // namespace detail

ANCF_INLINE Solver::Solver(SolverOptions options)
    : run_(std::make_unique<detail::SolverRun>(nullptr, std::move(options))) {}

ANCF_INLINE Solver::Solver(const Scene& scene, SolverOptions options)
    : run_(std::make_unique<detail::SolverRun>(&scene, std::move(options))) {}

ANCF_INLINE Solver::~Solver() = default;

ANCF_INLINE void Solver::analyze(const SparseMatrix& matrix) {
    ancf::detail::require_storage(name(), matrix, storage());
    stage_.reset();
    const detail::QuietErrors quiet;
    run_->analyze(matrix);
    stage_.analysed(matrix);
}

ANCF_INLINE FactorReport Solver::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    const detail::QuietErrors quiet;
    return stage_.finished(run_->factorize(matrix));
}

ANCF_INLINE void Solver::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    const detail::QuietErrors quiet;
    run_->solve(b, x);
}

ANCF_INLINE std::string Solver::failure() const { return run_->failure; }
ANCF_INLINE bool Solver::iterative() const noexcept { return !run_->factorises; }
ANCF_INLINE int Solver::iterations() const noexcept { return run_->iterations; }
ANCF_INLINE int Solver::most_iterations() const noexcept { return run_->most; }
ANCF_INLINE long Solver::rows() const noexcept { return static_cast<long>(run_->size); }
ANCF_INLINE int Solver::block_size() const noexcept { return run_->rows.block; }

}  // namespace ancf::petsc
