// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of solver.hpp.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/error.hpp>
#include <ancf/petsc/condensation.hpp>
#include <ancf/petsc/partition.hpp>
#include <ancf/petsc/solver.hpp>

#include <petscksp.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ancf::petsc {

ANCF_INLINE Session::Session(int* argc, char*** argv) : own_(!detail::petsc_runs()) {
    if (own_) detail::check(PetscInitialize(argc, argv, nullptr, nullptr));
}

ANCF_INLINE Session::~Session() {
    if (own_) static_cast<void>(PetscFinalize());
}

ANCF_INLINE SolverOptions SolverOptions::direct(std::string prefix) {
    SolverOptions options;
    options.prefix = std::move(prefix);
    return options;
}

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
        std::istringstream words(text);
        std::string word, name;
        const auto is_name = [](const std::string& w) {
            return w.size() > 1 && w[0] == '-' && std::isalpha(static_cast<unsigned char>(w[1]));
        };
        const auto set = [&](const std::string& value) {
            if (name.empty()) return;
            const bool again = std::find(names_.begin(), names_.end(), name) != names_.end();
            PetscBool given = PETSC_FALSE;  // on the command line
            if (!again) check(PetscOptionsHasName(nullptr, nullptr, name.c_str(), &given));
            if (given == PETSC_FALSE) {
                check(PetscOptionsSetValue(nullptr, name.c_str(), value.c_str()));
                if (!again) names_.push_back(name);
            }
            name.clear();
        };
        while (words >> word) {
            if (is_name(word)) {
                set("");
                name = "-" + prefix + word.substr(1);
            } else {
                ancf::detail::require(!name.empty(), "petsc::SolverOptions: \"", word,
                                      "\" follows no name of an option in \"", text, "\"");
                set(word);
            }
        }
        set("");
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

/// Returns a prefix that no other solver of this process has.
[[nodiscard]] ANCF_INLINE std::string fresh_prefix() {
    static long count = 0;
    return "ancf_" + std::to_string(++count) + "_";
}

/// The objects of PETSc, and how a matrix becomes theirs.
struct SolverRun {
    SolverRun(const Scene* of, SolverOptions wanted);
    SolverRun(const SolverRun&) = delete;
    SolverRun& operator=(const SolverRun&) = delete;
    ~SolverRun() = default;

    void analyze(const SparseMatrix& pattern);
    void set_values(const SparseMatrix& matrix);
    void set_rigid_motions();
    [[nodiscard]] std::string refusal();
    FactorReport factorize(const SparseMatrix& matrix);
    void solve(const VectorX& right, VectorX& x);

    const Scene* scene;
    SolverOptions options;
    MPI_Comm comm = PETSC_COMM_SELF;
    std::unique_ptr<OptionsInTable> table;
    const Partition* partition = nullptr;
    std::unique_ptr<Partition> alone;  // of a whole scene
    Partition::Rows rows;
    Condensation condensation;
    Numbering numbering;
    bool symmetric = false;
    PetscInt size = 0;           // rows of all processes
    std::vector<double> values;  // handed over
    VectorX local, shifted;
    Handle<KSP> ksp;
    Handle<Mat> matrix;
    Handle<Vec> b, x;
    Handle<Vec> part;  // entries of this process's equations
    Handle<VecScatter> scatter;
    std::string failure;
    int iterations = 0, most = 0;
    bool factorises = false;
};

ANCF_INLINE SolverRun::SolverRun(const Scene* of, SolverOptions wanted)
    : scene(of), options(std::move(wanted)) {
    require_session();
    const QuietErrors quiet;
    if (options.prefix.empty()) options.prefix = fresh_prefix();
    table = std::make_unique<OptionsInTable>(options.options, options.prefix);
    if (scene != nullptr) partition = static_cast<const Partition*>(scene->exchange());
    if (partition != nullptr) comm = partition->comm();
    try {
        check(KSPCreate(comm, ksp.fresh()));
        check(KSPSetOptionsPrefix(ksp, options.prefix.c_str()));
        check(KSPSetErrorIfNotConverged(ksp, PETSC_FALSE));
        check(KSPSetFromOptions(ksp));
    } catch (const PetscFailure& failed) {
        ksp.reset();
        ancf::detail::reject("petsc::SolverOptions \"", options.options, "\": ", failed.what());
    }
    PC pc = nullptr;
    check(KSPGetPC(ksp, &pc));
    PetscBool lu = PETSC_FALSE, cholesky = PETSC_FALSE;
    check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), PCLU, &lu));
    check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), PCCHOLESKY, &cholesky));
    factorises = lu != PETSC_FALSE || cholesky != PETSC_FALSE;
}

ANCF_INLINE void SolverRun::analyze(const SparseMatrix& pattern) {
    check(KSPReset(ksp));
    PetscInt first = 0, last = static_cast<PetscInt>(pattern.rows());
    symmetric = false;
    int block = 1;
    if (scene == nullptr) {
        rows = {};
        for (PetscInt k = 0; k < last; ++k) rows.row.push_back(k);
        rows.own.assign(rows.row.size(), 1);
    } else {
        numbering = Numbering(*scene);
        ancf::detail::require(pattern.rows() == numbering.unknowns(),
                              "petsc::Solver: the scene has ", numbering.unknowns(),
                              " unknowns, the matrix ", pattern.rows());
        if (scene->exchange() == nullptr) {  // it may have changed
            alone.reset();
            alone = std::make_unique<Partition>(*scene, PETSC_COMM_SELF);
            partition = alone.get();
        }
        rows = partition->rows(*scene, numbering);
        first = partition->first_row();
        last = partition->last_row();
        block = partition->block_size();
        const auto& loads = partition->whole().loads();
        symmetric = std::all_of(loads.begin(), loads.end(),
                                [](const ScaledLoad& load) { return load.load.symmetric(); });
    }
    condensation = Condensation(pattern, std::move(rows.sets), symmetric);

    std::vector<PetscInt> is, js;  // of each value
    is.reserve(condensation.entries() + rows.idle.size());
    js.reserve(is.capacity());
    for (int j = 0; j < pattern.cols(); ++j) {
        if (!condensation.keeps(j)) continue;
        for (int k = pattern.outerIndexPtr()[j]; k < pattern.outerIndexPtr()[j + 1]; ++k) {
            const int i = pattern.innerIndexPtr()[k];
            if (!condensation.keeps(i)) continue;
            is.push_back(rows.row[at(i)]);
            js.push_back(rows.row[at(j)]);
        }
    }
    is.insert(is.end(), rows.idle.begin(), rows.idle.end());
    js.insert(js.end(), rows.idle.begin(), rows.idle.end());
    values.resize(is.size());

    check(MatCreate(comm, matrix.fresh()));
    check(MatSetSizes(matrix, last - first, last - first, PETSC_DETERMINE, PETSC_DETERMINE));
    check(MatSetType(matrix, MATAIJ));
    check(MatSetBlockSize(matrix, block));
    check(MatSetPreallocationCOO(matrix, static_cast<PetscCount>(is.size()), is.data(), js.data()));
    Mat own = nullptr;  // PETSc 3.18 forgets the blocks of this process's part
    check(MatGetDiagonalBlock(matrix, &own));
    check(MatSetBlockSize(own, block));
    if (symmetric) {
        check(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
        check(MatSetOption(matrix, MAT_SYMMETRY_ETERNAL, PETSC_TRUE));
    }
    check(MatGetSize(matrix, &size, nullptr));
    check(MatCreateVecs(matrix, x.fresh(), b.fresh()));

    std::vector<PetscInt> to, from;  // rows, and the equations that have them
    for (std::size_t k = 0; k < rows.row.size(); ++k)
        if (rows.row[k] >= 0) {
            to.push_back(rows.row[k]);
            from.push_back(static_cast<PetscInt>(k));
        }
    check(VecCreateSeq(PETSC_COMM_SELF, static_cast<PetscInt>(rows.row.size()), part.fresh()));
    Handle<IS> is_rows, is_equations;
    const auto count = static_cast<PetscInt>(to.size());
    check(ISCreateGeneral(comm, count, to.data(), PETSC_COPY_VALUES, is_rows.fresh()));
    check(ISCreateGeneral(PETSC_COMM_SELF, count, from.data(), PETSC_COPY_VALUES,
                          is_equations.fresh()));
    check(VecScatterCreate(x, is_rows, part, is_equations, scatter.fresh()));
}

ANCF_INLINE void SolverRun::set_values(const SparseMatrix& from) {
    double failed = condensation.reduce(from, values.data()) ? 0.0 : 1.0;
    double mean[2] = {0.0, 0.0};  // of the diagonal: what rows without an equation get
    if (!rows.idle.empty() || partition != nullptr) {
        for (int j = 0; j < from.cols(); ++j) {
            if (!condensation.keeps(j)) continue;
            const double entry = std::abs(from.coeff(j, j));
            if (!std::isfinite(entry)) continue;
            mean[0] += entry;
            mean[1] += 1.0;
        }
        if (partition != nullptr) {
            partition->sum(mean, 2);
            failed = partition->largest(failed);
        }
        const double idle = mean[0] > 0.0 ? mean[0] / mean[1] : 1.0;
        std::fill(values.end() - static_cast<std::ptrdiff_t>(rows.idle.size()), values.end(), idle);
    }
    if (failed > 0.0) throw std::domain_error("the slope r_x of a member's end has no stiffness");
    check(MatSetValuesCOO(matrix, values.data(), INSERT_VALUES));
}

// Translations of positions, and w x v of positions and slopes, where the scene stands now. Where
// nodes differ, or have positions alone, a few of them cannot hold six motions: PETSc's own choice
// of three, a constant in each direction, stays.
ANCF_INLINE void SolverRun::set_rigid_motions() {
    if (scene == nullptr || size == 0 || !partition->blocks_are_nodes()) return;
    const Layout& layout = scene->layout();
    const VectorX& q = scene->state().q;
    const int dimension = layout.dimension(), turns = dimension == 3 ? 3 : 1;
    std::vector<Handle<Vec>> modes;
    for (int m = 0; m < dimension + turns; ++m) {
        check(VecDuplicate(x, modes.emplace_back().fresh()));
        const Vec mode = modes.back();
        PetscScalar* entry = nullptr;
        check(VecGetArray(mode, &entry));
        for (int node = 0; node < layout.nodes(); ++node)
            for (int k = layout.first(node); k < layout.first(node + 1); k += dimension) {
                double v[3] = {};
                if (m < dimension) {
                    v[m] = k == layout.first(node) ? 1.0 : 0.0;  // a node's position comes first
                } else {
                    const int a = dimension == 3 ? (m - dimension + 1) % 3 : 0;
                    const int c = dimension == 3 ? (m - dimension + 2) % 3 : 1;
                    v[a] = -q[k + c];
                    v[c] = q[k + a];
                }
                for (int i = 0; i < dimension; ++i) {
                    const int equation = numbering.equation(k + i);
                    if (equation < 0 || rows.own[at(equation)] == 0) continue;
                    entry[rows.row[at(equation)] - partition->first_row()] = v[i];
                }
            }
        check(VecRestoreArray(mode, &entry));
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

/// Says why a kind of solver does not suit the scene; empty where it does.
ANCF_INLINE std::string SolverRun::refusal() {
    if (scene == nullptr || factorises) return {};
    if (!partition->whole().constraints().empty())
        return "a scene with multipliers needs a direct solver: -pc_type lu "
               "-pc_factor_mat_solver_type mumps";
    KSPType type = nullptr;
    check(KSPGetType(ksp, &type));
    const std::string name = type != nullptr ? type : "";
    const bool needs_symmetry = name.find("cg") != std::string::npos && name.find("bcgs") != 0 &&
                                name != "cgs" && name != "cgne";
    if (!symmetric && (needs_symmetry || name == "minres" || name == "symmlq"))
        return "a load has an unsymmetric stiffness, which " + name +
               " cannot solve: take gmres or a direct solver";
    return {};
}

ANCF_INLINE FactorReport SolverRun::factorize(const SparseMatrix& from) {
    failure.clear();
    iterations = 0;
    FactorReport report;
    if (size == 0) {
        report.status =
            condensation.reduce(from, values.data()) ? Status::converged : Status::singular;
        return report;
    }
    double finite = 1.0;
    for (Eigen::Index k = 0; k < from.nonZeros() && finite > 0.0; ++k)
        finite = std::isfinite(from.valuePtr()[k]) ? 1.0 : 0.0;
    if (partition != nullptr) finite = -partition->largest(-finite);
    if (finite == 0.0) {
        report.status = Status::not_finite;
        return report;
    }
    failure = refusal();
    if (!failure.empty()) {
        report.status = Status::diverged;
        return report;
    }
    try {
        set_values(from);
        if (!factorises) set_rigid_motions();
        check(KSPSetOperators(ksp, matrix, matrix));
        check(KSPSetUp(ksp));
        PC pc = nullptr;
        PCFailedReason reason = PC_NOERROR;
        check(KSPGetPC(ksp, &pc));
        check(PCGetFailedReason(pc, &reason));
        double worst = static_cast<double>(reason);
        if (partition != nullptr) worst = partition->largest(worst);
        if (worst != 0.0) {
            const auto code = static_cast<PCFailedReason>(static_cast<int>(worst));
            const bool pivot =
                code == PC_FACTOR_NUMERIC_ZEROPIVOT || code == PC_FACTOR_STRUCT_ZEROPIVOT;
            report.status = pivot ? Status::singular : Status::diverged;
            failure = std::string("PETSc: the preconditioner failed: ") + PCFailedReasons[code];
        }
    } catch (const std::domain_error& singular) {
        report.status = Status::singular;
        failure = singular.what();
    } catch (const PetscFailure& failed) {
        report.status = Status::diverged;
        failure = failed.what();
    }
    return report;
}

ANCF_INLINE void SolverRun::solve(const VectorX& right, VectorX& out) {
    const auto count = static_cast<std::size_t>(right.size());
    failure.clear();
    condensation.shift(right, shifted);
    local = right;  // b and x may be the same vector
    out.resize(right.size());
    if (size == 0) {
        condensation.complete(local, out);
        return;
    }
    try {
        PetscScalar* entry = nullptr;
        check(VecGetArray(part, &entry));
        for (std::size_t k = 0; k < count; ++k) {
            const auto i = static_cast<Eigen::Index>(k);
            entry[k] = (rows.own[k] != 0 ? local[i] : 0.0) + shifted[i];
        }
        check(VecRestoreArray(part, &entry));
        check(VecSet(b, 0.0));
        check(VecScatterBegin(scatter, part, b, ADD_VALUES, SCATTER_REVERSE));
        check(VecScatterEnd(scatter, part, b, ADD_VALUES, SCATTER_REVERSE));
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
        } else {
            check(VecScatterBegin(scatter, x, part, INSERT_VALUES, SCATTER_FORWARD));
            check(VecScatterEnd(scatter, x, part, INSERT_VALUES, SCATTER_FORWARD));
            const PetscScalar* solved = nullptr;
            check(VecGetArrayRead(part, &solved));
            std::copy_n(solved, count, out.data());
            check(VecRestoreArrayRead(part, &solved));
            condensation.complete(local, out);
        }
    } catch (const PetscFailure& failed) {
        failure = failed.what();
    }
    if (!failure.empty()) out.setConstant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace detail

ANCF_INLINE void Solver::Finish::operator()(detail::SolverRun* run) const noexcept { delete run; }

ANCF_INLINE Solver::Solver(SolverOptions options)
    : run_(new detail::SolverRun(nullptr, std::move(options))) {}

ANCF_INLINE Solver::Solver(const Scene& scene, SolverOptions options)
    : run_(new detail::SolverRun(&scene, std::move(options))) {}

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
ANCF_INLINE int Solver::block_size() const noexcept {
    return run_->partition != nullptr ? run_->partition->block_size() : 1;
}

}  // namespace ancf::petsc
