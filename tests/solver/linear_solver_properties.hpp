// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What every linear solver must do, as functions that the tests of each solver call.

#pragma once

#include <ancf/solver/linear_solver.hpp>

#include <solver/linear_solver_cases.hpp>
#include <support/catch.hpp>
#include <support/dense.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf::test {

/// Makes a new solver.
using MakeSolver = std::function<std::unique_ptr<LinearSolver>()>;

/// Makes a solver of a class that needs no options.
template <class Solver>
std::unique_ptr<LinearSolver> made() {
    return std::make_unique<Solver>();
}

/// Chains of several layouts: planar nodes, full nodes, clamped ends, three-node elements.
inline const std::vector<std::vector<int>>& chain_layouts() {
    static const std::vector<std::vector<int>> layouts = {
        {1},
        {12},
        {12, 12},
        std::vector<int>(50, 12),
        {6, 12, 12, 12, 12, 12, 6},
        {12, 6, 9, 7, 12, 11, 10, 8, 6, 12, 3},
        std::vector<int>(40, 6),
        std::vector<int>(30, 4),
        std::vector<int>(20, 9),
        std::vector<int>(20, 1),
        {24, 12, 24, 12, 24, 12},
        {2, 12, 12, 0, 12, 12},
    };
    return layouts;
}

/// Factorises and solves; returns the report and checks the backward error where it converged.
inline FactorReport solve_and_check(LinearSolver& solver, const SparseMatrix& lower,
                                    double tolerance) {
    const SparseMatrix matrix = stored(lower, solver.storage());
    solver.analyze(matrix);
    const FactorReport report = solver.factorize(matrix);
    if (report.status != Status::converged) return report;
    const VectorX b = random_vector(static_cast<int>(matrix.cols()), 7);
    VectorX x;
    solver.solve(b, x);
    REQUIRE(x.size() == b.size());
    CHECK(backward_error(matrix, solver.storage(), x, b) <= tolerance);
    return report;
}

inline void solves_every_layout_of_a_chain(const MakeSolver& make) {
    constexpr double tolerance = 4e-15;  // a few eps; measured 4e-16
    int solved = 0;
    for (const auto& layout : chain_layouts()) {
        const SparseMatrix lower = random_chain(layout, 100 + layout.size());
        INFO("nodes " << layout.size() << ", unknowns " << lower.cols());
        const auto solver = make();
        const FactorReport report = solve_and_check(*solver, lower, tolerance);
        CHECK(report.status == Status::converged);
        CHECK(report.failed_column == -1);
        CHECK(report.rcond > 0.0);
        CHECK(report.rcond <= 1.0);
        if (report.negative_pivots != -1) CHECK(report.negative_pivots == 0);
        ++solved;
    }
    CHECK(solved == static_cast<int>(chain_layouts().size()));
}

inline void solves_an_empty_system(const MakeSolver& make) {
    const auto solver = make();
    const SparseMatrix empty(0, 0);
    solver->analyze(empty);
    CHECK(solver->factorize(empty).status == Status::converged);
    VectorX x = VectorX::Ones(3);
    solver->solve(VectorX(0), x);
    CHECK(x.size() == 0);
}

inline void takes_new_values_in_the_same_pattern(const MakeSolver& make) {
    const std::vector<int> nodes(10, 12);
    const auto solver = make();
    solver->analyze(stored(random_chain(nodes, 1), make()->storage()));
    for (std::uint64_t seed = 2; seed < 7; ++seed) {
        const SparseMatrix matrix = stored(random_chain(nodes, seed), make()->storage());
        REQUIRE(solver->factorize(matrix).status == Status::converged);
        const VectorX b = random_vector(120, seed);
        VectorX x;
        solver->solve(b, x);
        CHECK(backward_error(matrix, make()->storage(), x, b) <= 4e-15);
    }
}

inline void repeats_bit_for_bit(const MakeSolver& make) {
    const SparseMatrix matrix =
        stored(random_chain(std::vector<int>(20, 12), 5), make()->storage());
    const VectorX b = random_vector(240, 5);
    VectorX first;
    VectorX second;
    for (VectorX* x : {&first, &second}) {
        const auto solver = make();
        solver->analyze(matrix);
        REQUIRE(solver->factorize(matrix).status == Status::converged);
        solver->solve(b, *x);
    }
    CHECK((first.array() == second.array()).all());
}

inline void solves_in_place(const MakeSolver& make) {
    const SparseMatrix matrix = stored(random_chain(std::vector<int>(4, 12), 6), make()->storage());
    const auto solver = make();
    solver->analyze(matrix);
    REQUIRE(solver->factorize(matrix).status == Status::converged);
    const VectorX b = random_vector(48, 6);
    VectorX apart;
    VectorX same = b;
    solver->solve(b, apart);
    solver->solve(same, same);
    CHECK((apart.array() == same.array()).all());
}

/// A free beam (six rigid motions), one on a ball joint (three), a zero row, twice the same row.
inline void calls_a_singular_matrix_singular(const MakeSolver& make) {
    const auto solver = make();
    int seen = 0;
    for (const int elements : {1, 4, 16, 64, 256})
        for (const int clamped : {0, 3}) {
            const SampleBeam beam{elements, 1.0, 0.01, clamped};
            INFO("elements " << elements << ", clamped " << clamped);
            CHECK(solve_and_check(*solver, beam.tangent(), 0.0).status == Status::singular);
            ++seen;
        }
    CHECK(seen == 10);

    MatrixX dense = MatrixX::Identity(8, 8) * 3.0;
    dense(4, 4) = 0.0;
    Triplets triplets;  // the diagonal entry stays in the pattern
    for (int i = 0; i < 8; ++i) triplets.emplace_back(i, i, dense(i, i));
    const FactorReport zero_row = solve_and_check(*solver, sparse(8, triplets), 0.0);
    CHECK(zero_row.status == Status::singular);
    if (zero_row.failed_column != -1) CHECK(zero_row.failed_column == 4);

    const SparseMatrix twice = sparse_lower(MatrixX::Ones(2, 2));
    CHECK(solve_and_check(*solver, twice, 0.0).status == Status::singular);

    const SparseMatrix zero = 0.0 * random_chain({5, 5}, 1);
    CHECK(solve_and_check(*solver, zero, 0.0).status == Status::singular);
}

inline void refuses_to_solve_after_a_failure(const MakeSolver& make) {
    const SparseMatrix good = stored(random_chain({12, 12}, 1), make()->storage());
    SparseMatrix bad = 0.0 * good;
    const auto solver = make();
    solver->analyze(good);
    REQUIRE(solver->factorize(good).status == Status::converged);
    REQUIRE(solver->factorize(bad).status == Status::singular);
    VectorX x;
    CHECK_THROWS_AS(solver->solve(VectorX::Ones(24), x), InvalidArgument);
    REQUIRE(solver->factorize(good).status == Status::converged);
    CHECK_NOTHROW(solver->solve(VectorX::Ones(24), x));
}

inline void calls_a_matrix_with_nan_or_infinity_not_finite(const MakeSolver& make) {
    const SparseMatrix good = stored(random_chain(std::vector<int>(5, 12), 3), make()->storage());
    const auto solver = make();
    solver->analyze(good);
    int seen = 0;
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()})
        for (int slot = 0; slot < good.nonZeros(); slot += 17) {
            SparseMatrix bad = good;
            bad.valuePtr()[slot] = value;
            CHECK(solver->factorize(bad).status == Status::not_finite);
            ++seen;
        }
    CHECK(seen > 30);
}

/// The same system in other units: u = D v with D of powers of ten over 24 decades.
inline void does_not_depend_on_units(const MakeSolver& make) {
    const SparseMatrix lower = random_chain(std::vector<int>(6, 12), 9);
    VectorX unit(lower.cols());
    for (Eigen::Index i = 0; i < unit.size(); ++i)
        unit[i] = std::pow(10.0, static_cast<double>(i % 25) - 12.0);
    const SparseMatrix scaled = unit.asDiagonal() * lower * unit.asDiagonal();
    const SparseMatrix matrix = stored(scaled, make()->storage());
    const auto solver = make();
    solver->analyze(matrix);
    REQUIRE(solver->factorize(matrix).status == Status::converged);
    const VectorX expected = random_vector(static_cast<int>(unit.size()), 9);
    const VectorX b = unit.cwiseProduct(product(lower, Storage::lower, expected));
    VectorX x;
    solver->solve(b, x);
    const VectorX back = unit.cwiseProduct(x);
    CHECK((back - expected).norm() / expected.norm() <= 1e-12);  // measured 1e-15
}

inline void refuses_wrong_calls(const MakeSolver& make) {
    const SparseMatrix matrix = stored(random_chain({12, 12, 12}, 1), make()->storage());
    VectorX x;
    const auto solver = make();
    CHECK_THROWS_AS(solver->factorize(matrix), InvalidArgument);
    CHECK_THROWS_AS(solver->solve(VectorX::Ones(36), x), InvalidArgument);
    CHECK_THROWS_AS(solver->analyze(SparseMatrix(3, 4)), InvalidArgument);

    SparseMatrix loose = matrix;
    loose.uncompress();
    CHECK_THROWS_AS(solver->analyze(loose), InvalidArgument);

    solver->analyze(matrix);
    CHECK_THROWS_AS(solver->solve(VectorX::Ones(36), x), InvalidArgument);
    const SparseMatrix smaller = stored(random_chain({12, 12}, 1), make()->storage());
    CHECK_THROWS_WITH(solver->factorize(smaller), ContainsSubstring("24 x 24"));
    SparseMatrix sparser(36, 36);
    sparser.setIdentity();
    CHECK_THROWS_WITH(solver->factorize(sparser), ContainsSubstring("entries"));
    CHECK_THROWS_AS(solver->factorize(loose), InvalidArgument);
    MatrixX moved = MatrixX(matrix);  // as many entries, one of them elsewhere
    moved(35, 0) = moved(0, 35) = moved(1, 0);
    moved(1, 0) = moved(0, 1) = 0.0;
    moved(13, 0) = moved(0, 13) = 0.0;
    moved(34, 1) = moved(1, 34) = 1.0;
    SparseMatrix other = moved.sparseView();
    if (make()->storage() == Storage::lower) other = other.triangularView<Eigen::Lower>();
    other.makeCompressed();
    REQUIRE(other.nonZeros() == matrix.nonZeros());
    CHECK_THROWS_WITH(solver->factorize(other), ContainsSubstring("another pattern"));

    REQUIRE(solver->factorize(matrix).status == Status::converged);
    CHECK_THROWS_WITH(solver->solve(VectorX::Ones(35), x), ContainsSubstring("35"));
    CHECK_THROWS_AS(solver->solve(VectorX(0), x), InvalidArgument);

    if (make()->storage() == Storage::lower) {
        Triplets triplets = {{0, 0, 1.0}, {1, 1, 1.0}, {0, 1, 0.5}};
        CHECK_THROWS_WITH(solver->analyze(sparse(2, triplets)), ContainsSubstring("lower half"));
    }
}

/// Solvers that hold another one are left without it; others start again.
template <class Solver>
void keeps_its_factorisation_when_moved(Solver solver, Solver assigned) {
    const SparseMatrix matrix = stored(random_chain({12, 12}, 4), solver.storage());
    const VectorX b = random_vector(24, 4);
    VectorX expected;
    VectorX x;
    solver.analyze(matrix);
    REQUIRE(solver.factorize(matrix).status == Status::converged);
    solver.solve(b, expected);

    Solver moved(std::move(solver));
    moved.solve(b, x);
    CHECK((x.array() == expected.array()).all());
    const SparseMatrix other = stored(random_chain({3, 3}, 1), moved.storage());
    assigned.analyze(other);
    REQUIRE(assigned.factorize(other).status == Status::converged);
    assigned = std::move(moved);
    assigned.solve(b, x);
    CHECK((x.array() == expected.array()).all());

    CHECK_THROWS_AS(solver.solve(b, x), InvalidArgument);  // NOLINT: moved from, starts again
    CHECK_THROWS_AS(solver.factorize(matrix), InvalidArgument);
    if (!std::is_default_constructible_v<Solver>) {
        CHECK_THROWS_AS(solver.analyze(matrix), InvalidArgument);
        return;
    }
    solver.analyze(matrix);
    REQUIRE(solver.factorize(matrix).status == Status::converged);
    solver.solve(b, x);
    CHECK((x.array() == expected.array()).all());
}

/// A clamped beam's tip against beam theory: condition number 1e13 after the best scaling.
inline void bends_a_long_cantilever(const MakeSolver& make, double tolerance) {
    const SampleBeam beam{1000, 1.0, 0.01};
    const SparseMatrix matrix = stored(beam.tangent(), make()->storage());
    const auto solver = make();
    solver->analyze(matrix);
    REQUIRE(solver->factorize(matrix).status == Status::converged);
    VectorX x;
    solver->solve(beam.tip_load(), x);
    CHECK(beam.tip(x) == Approx(beam.tip_deflection()).epsilon(tolerance));
}

/// Indefinite chains; the true number of negative eigenvalues from a dense decomposition.
inline void counts_negative_eigenvalues(const MakeSolver& make) {
    int total = 0;
    const auto check = [&](const SparseMatrix& lower) {
        const MatrixX dense = stored(lower, Storage::full);
        const int expected = static_cast<int>((eigenvalues(dense).array() < 0.0).count());
        const auto solver = make();
        const FactorReport report = solve_and_check(*solver, lower, 1e-12);  // measured 1e-14
        CHECK(report.status == Status::converged);
        CHECK(report.negative_pivots == expected);
        total += expected;
    };
    for (const int flip : {1, 2, 3, 5, 7, 50})
        check(random_chain({12, 12, 6, 12, 9, 12}, 40, 40.0, flip));
    const SampleBeam beam{12, 1.0, 0.1};
    const SparseMatrix tangent = beam.tangent();
    for (const double shift :
         {1.1e-5, 1.3e-3, 1.7e-2, 0.13, 0.57}) {  // past so many natural frequencies
        SparseMatrix shifted = tangent;
        for (int i = 0; i < shifted.cols(); ++i)
            shifted.coeffRef(i, i) -= shift * SampleBeam::young * 0.01;
        check(shifted);
    }
    CHECK(total > 100);
}

/// Saddle points with constraints in units from 1e-9 to 1e9 times those of the rest.
inline void solves_saddle_points(const MakeSolver& make) {
    int solved = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        for (const double unit : {1e-9, 1.0, 1e9}) {
            const SaddlePoint saddle = saddle_point(6, 5, seed);
            VectorX units = VectorX::Ones(saddle.lower.cols());
            units.tail(saddle.constraints).setConstant(unit);
            const SparseMatrix scaled = units.asDiagonal() * saddle.lower * units.asDiagonal();
            const auto solver = make();
            const FactorReport report = solve_and_check(*solver, scaled, 1e-13);  // measured 1e-15
            CHECK(report.status == Status::converged);
            CHECK(report.rcond > 1e-4);
            ++solved;
        }
    CHECK(solved == 30);
}

inline void solves_unsymmetric_systems(const MakeSolver& make) {
    REQUIRE(make()->storage() == Storage::full);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Random random(seed);
        SparseMatrix matrix = stored(random_chain({12, 12, 12}, seed), Storage::full);
        for (int slot = 0; slot < matrix.nonZeros(); ++slot)
            matrix.valuePtr()[slot] += random.uniform(-1.0, 1.0);
        const VectorX expected = random_vector(36, seed);
        const VectorX b = matrix * expected;
        const auto solver = make();
        solver->analyze(matrix);
        REQUIRE(solver->factorize(matrix).status == Status::converged);
        VectorX x;
        solver->solve(b, x);
        CHECK((x - expected).norm() <= 1e-13 * expected.norm());
        CHECK((matrix.transpose() * x - b).norm() > 1e-2 * b.norm());
    }
}

/// The values at the analysis do not count, stored zeros are places as well.
inline void serves_any_values_of_a_pattern(const MakeSolver& make) {
    const SparseMatrix matrix = stored(random_chain({12, 12, 12}, 1), make()->storage());
    const auto solver = make();
    solver->analyze(0.0 * matrix);
    REQUIRE(solver->factorize(matrix).status == Status::converged);
    const VectorX b = random_vector(36, 1);
    VectorX x;
    solver->solve(b, x);
    CHECK(backward_error(matrix, make()->storage(), x, b) <= 4e-15);
}

/// A factorisation stands when its matrix has changed since.
inline void outlives_its_matrix(const MakeSolver& make) {
    SparseMatrix matrix = stored(random_chain({12, 12}, 1), make()->storage());
    const auto solver = make();
    solver->analyze(matrix);
    REQUIRE(solver->factorize(matrix).status == Status::converged);
    const VectorX b = random_vector(24, 1);
    VectorX expected;
    VectorX x;
    solver->solve(b, expected);
    matrix *= 0.0;
    solver->solve(b, x);
    CHECK(x == expected);
}

/// One constraint twice, and once more three times as large.
inline void calls_redundant_constraints_singular(const MakeSolver& make) {
    const SaddlePoint saddle = saddle_point(4, 2, 1);
    Triplets triplets;
    const int last = saddle.unknowns + saddle.constraints;
    for (int j = 0; j < saddle.lower.cols(); ++j)
        for (SparseMatrix::InnerIterator entry(saddle.lower, j); entry; ++entry) {
            const int row = static_cast<int>(entry.row());
            triplets.emplace_back(row, j, entry.value());
            if (row == last - 1) triplets.emplace_back(last, j, 3.0 * entry.value());
        }
    const auto solver = make();
    const FactorReport report = solve_and_check(*solver, sparse(last + 1, triplets), 0.0);
    CHECK(report.status == Status::singular);
    if (report.failed_column != -1) CHECK(report.failed_column >= last - 1);
}

/// Runs the whole list.
inline void check_linear_solver(const MakeSolver& make) {
    SECTION("solves every layout of a chain") { solves_every_layout_of_a_chain(make); }
    SECTION("solves an empty system") { solves_an_empty_system(make); }
    SECTION("takes new values") { takes_new_values_in_the_same_pattern(make); }
    SECTION("repeats bit for bit") { repeats_bit_for_bit(make); }
    SECTION("solves in place") { solves_in_place(make); }
    SECTION("calls singular singular") { calls_a_singular_matrix_singular(make); }
    SECTION("no solve after a failure") { refuses_to_solve_after_a_failure(make); }
    SECTION("not finite") { calls_a_matrix_with_nan_or_infinity_not_finite(make); }
    SECTION("does not depend on units") { does_not_depend_on_units(make); }
    SECTION("refuses wrong calls") { refuses_wrong_calls(make); }
}

}  // namespace ancf::test
