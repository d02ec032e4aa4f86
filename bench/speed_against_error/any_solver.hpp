// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A linear solver of symmetric matrices chosen when the program runs: a scene is compiled once.

#pragma once

#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#if ANCF_WITH_SUITESPARSE
#include <ancf/suitesparse/cholmod.hpp>
#endif

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace speed {

class AnySolver {
public:
    static constexpr ancf::Storage storage = ancf::Storage::lower;

    /// @param name  one of names()
    explicit AnySolver(const std::string& name) {
        if (name == ancf::EigenLdlt::name()) solver_ = std::make_unique<Held<ancf::EigenLdlt>>();
#if ANCF_WITH_SUITESPARSE
        if (name == ancf::suitesparse::Cholmod::name())
            solver_ = std::make_unique<Held<ancf::suitesparse::Cholmod>>();
#endif
        if (!solver_) solver_ = std::make_unique<Held<ancf::BlockTridiagonal>>();
    }

    [[nodiscard]] static std::vector<std::string> names() {
        return {
            std::string(ancf::BlockTridiagonal::name()), std::string(ancf::EigenLdlt::name()),
#if ANCF_WITH_SUITESPARSE
                std::string(ancf::suitesparse::Cholmod::name())
#endif
        };
    }

    void analyze(const ancf::SparseMatrix& lower) { solver_->analyze(lower); }
    [[nodiscard]] ancf::FactorReport factorize(const ancf::SparseMatrix& lower) {
        return solver_->factorize(lower);
    }
    void solve(const ancf::VectorX& b, ancf::VectorX& x) const { solver_->solve(b, x); }
    [[nodiscard]] std::string_view name() const { return solver_->name(); }

private:
    struct Base {
        virtual ~Base() = default;
        virtual void analyze(const ancf::SparseMatrix& lower) = 0;
        virtual ancf::FactorReport factorize(const ancf::SparseMatrix& lower) = 0;
        virtual void solve(const ancf::VectorX& b, ancf::VectorX& x) const = 0;
        [[nodiscard]] virtual std::string_view name() const = 0;
    };
    template <class Solver>
    struct Held final : Base {
        Solver solver;
        void analyze(const ancf::SparseMatrix& lower) override { solver.analyze(lower); }
        ancf::FactorReport factorize(const ancf::SparseMatrix& lower) override {
            return solver.factorize(lower);
        }
        void solve(const ancf::VectorX& b, ancf::VectorX& x) const override { solver.solve(b, x); }
        [[nodiscard]] std::string_view name() const override { return solver.name(); }
    };

    std::unique_ptr<Base> solver_;
};

}  // namespace speed
