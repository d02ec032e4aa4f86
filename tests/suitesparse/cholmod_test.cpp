// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/suitesparse/cholmod.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <unistd.h>

#include <cstdio>
#include <limits>
#include <vector>

namespace cholmod_test {

using namespace ancf;
using namespace ancf::suitesparse;
using namespace ancf::test;

/// Counts what is written to stdout and stderr while it lives.
class Silence {
public:
    Silence() : file_(std::tmpfile()) {
        std::fflush(nullptr);
        out_ = dup(1);
        err_ = dup(2);
        dup2(fileno(file_), 1);
        dup2(fileno(file_), 2);
    }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;
    ~Silence() {
        restore();
        std::fclose(file_);
    }
    long written() {
        restore();
        std::fseek(file_, 0, SEEK_END);
        return std::ftell(file_);
    }

private:
    void restore() {
        if (out_ < 0) return;
        std::fflush(nullptr);
        dup2(out_, 1);
        dup2(err_, 2);
        close(out_);
        close(err_);
        out_ = -1;
    }

    std::FILE* file_;
    int out_ = -1;
    int err_ = -1;
};

/// A positive definite chain but for one diagonal entry.
SparseMatrix indefinite_at(int column) {
    SparseMatrix matrix = random_chain(std::vector<int>(8, 12), 1);
    matrix.coeffRef(column, column) = -40.0;
    return matrix;
}

TEST_CASE("Cholmod: supernodal, a matrix that is not positive definite fails at its column",
          "[suitesparse]") {
    for (const CholmodOrdering ordering :
         {CholmodOrdering::natural, CholmodOrdering::amd, CholmodOrdering::automatic})
        for (const int column : {0, 1, 50, 95}) {
            Cholmod solver({CholmodMode::supernodal, ordering});
            const SparseMatrix matrix = indefinite_at(column);
            solver.analyze(matrix);
            CHECK(solver.supernodal());
            const FactorReport report = solver.factorize(matrix);
            CHECK(report.status == Status::singular);
            CHECK(report.failed_column == column);
        }
}

TEST_CASE("Cholmod: simplicial, the same matrix is factorised", "[suitesparse]") {
    for (const CholmodOrdering ordering : {CholmodOrdering::natural, CholmodOrdering::amd}) {
        Cholmod solver({CholmodMode::simplicial, ordering});
        const FactorReport report = solve_and_check(solver, indefinite_at(50), 1e-14);
        CHECK_FALSE(solver.supernodal());
        CHECK(report.status == Status::converged);
        CHECK(report.negative_pivots == 1);
    }
}

TEST_CASE("Cholmod: in natural order multipliers that stand last make a saddle point solvable",
          "[suitesparse]") {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Cholmod solver({CholmodMode::simplicial, CholmodOrdering::natural});
        const SaddlePoint saddle = saddle_point(6, 5, seed);
        const FactorReport report = solve_and_check(solver, saddle.lower, 1e-13);
        CHECK(report.status == Status::converged);
        CHECK(report.negative_pivots == saddle.constraints);
    }
}

TEST_CASE("Cholmod: it is silent, whatever fails", "[suitesparse]") {
    Silence silence;
    for (const CholmodMode mode :
         {CholmodMode::automatic, CholmodMode::simplicial, CholmodMode::supernodal}) {
        Cholmod solver({mode});
        const SparseMatrix matrix = indefinite_at(50);
        solver.analyze(matrix);
        (void)solver.factorize(matrix);
        (void)solver.factorize(0.0 * matrix);
        (void)solver.factorize(std::numeric_limits<double>::quiet_NaN() * matrix);
    }
    CHECK(silence.written() == 0);
}

TEST_CASE("Cholmod: a limit that is no reciprocal condition number is refused", "[suitesparse]") {
    CholmodOptions options;
    options.singular_rcond = -1.0;
    CHECK_THROWS_WITH(Cholmod(options), ContainsSubstring("singular_rcond"));
}

}  // namespace cholmod_test
