// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static solution with a linear solver chosen when the program runs, for scenes of any elements.
///
/// A scene is compiled once for each storage, not once for each linear solver.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/types.hpp>

#if ANCF_WITH_SUITESPARSE
#include <ancf/suitesparse/cholmod.hpp>
#include <ancf/suitesparse/umfpack.hpp>
#endif

#include <support/solver.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace examples {

/// Any linear solver of one storage.
template <ancf::Storage Stored>
class AnySolver {
public:
    static constexpr ancf::Storage storage = Stored;

    template <class Solver>
    explicit AnySolver(std::unique_ptr<Solver> solver)
        : held_(std::make_unique<Holder<Solver>>(std::move(solver))) {
        static_assert(Solver::storage == Stored);
    }

    void analyze(const ancf::SparseMatrix& matrix) { held_->analyze(matrix); }
    [[nodiscard]] ancf::FactorReport factorize(const ancf::SparseMatrix& matrix) {
        return held_->factorize(matrix);
    }
    void solve(const ancf::VectorX& b, ancf::VectorX& x) const { held_->solve(b, x); }
    [[nodiscard]] std::string_view name() const { return held_->name(); }

private:
    struct Interface {
        virtual ~Interface() = default;
        virtual void analyze(const ancf::SparseMatrix&) = 0;
        virtual ancf::FactorReport factorize(const ancf::SparseMatrix&) = 0;
        virtual void solve(const ancf::VectorX&, ancf::VectorX&) const = 0;
        [[nodiscard]] virtual std::string_view name() const = 0;
    };

    template <class Solver>
    struct Holder final : Interface {
        explicit Holder(std::unique_ptr<Solver> held) : solver(std::move(held)) {}
        void analyze(const ancf::SparseMatrix& matrix) override { solver->analyze(matrix); }
        ancf::FactorReport factorize(const ancf::SparseMatrix& matrix) override {
            return solver->factorize(matrix);
        }
        void solve(const ancf::VectorX& b, ancf::VectorX& x) const override { solver->solve(b, x); }
        [[nodiscard]] std::string_view name() const override { return solver->name(); }
        std::unique_ptr<Solver> solver;
    };

    std::unique_ptr<Interface> held_;
};

/// Calls visit(solver) with the linear solver of a name.
template <class Visit>
decltype(auto) with_solver(const std::string& name, Visit&& visit) {
    using ancf::Storage;
#if ANCF_WITH_SUITESPARSE
    if (name == "cholmod") {
        // L D L^T: a tangent on the way to equilibrium need not be positive definite
        ancf::suitesparse::CholmodOptions simplicial;
        simplicial.mode = ancf::suitesparse::CholmodMode::simplicial;
        AnySolver<Storage::lower> solver(std::make_unique<ancf::suitesparse::Cholmod>(simplicial));
        return visit(solver);
    }
    if (name == "umfpack") {
        AnySolver<Storage::full> solver(std::make_unique<ancf::suitesparse::Umfpack>());
        return visit(solver);
    }
#endif
    ancf::detail::require(name == "eigen", "--solver ", name,
                          " needs SuiteSparse, and this program was built without it");
    AnySolver<Storage::full> solver(std::make_unique<ancf::EigenLu>());
    return visit(solver);
}

/// Brings a model to equilibrium.
template <class Scene>
[[nodiscard]] ancf::StaticsReport solve_scene(Scene& model, const SolverOptions& options) {
    ancf::StaticsOptions statics = options.statics;
    statics.newton = options.newton == "plain"   ? ancf::NewtonKind::plain
                     : options.newton == "mixed" ? ancf::NewtonKind::mixed
                                                 : ancf::NewtonKind::turned;
    return with_solver(options.solver,
                       [&](auto& solver) { return ancf::solve_statics(model, solver, statics); });
}

template <class Element>
ancf::StaticsReport solve(ancf::Model<Element>& model, const SolverOptions& options) {
    return solve_scene(model, options);
}

}  // namespace examples
