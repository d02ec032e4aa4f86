// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse factorisation of any complex square matrix.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <Eigen/OrderingMethods>

#include <complex>
#include <string_view>
#include <vector>

namespace ancf {

/// L U with partial pivoting, columns ordered by COLAMD, rows scaled as those of EigenLu.
///
/// A template so that only a program that makes one compiles Eigen's factorisation.
/// @tparam Ordering  Eigen's, of the columns
template <class Ordering>
class BasicEigenComplexLu final : public ComplexSolver {
public:
    /// @param storage  of the matrices to come; of the lower half the other one is filled in.
    explicit BasicEigenComplexLu(Storage storage) : storage_(storage) {}

    /// @throws InvalidArgument unless square, compressed and of the storage.
    void analyze(const SparseMatrix& pattern) override;

    /// Factorises in the pattern analysed. @throws InvalidArgument for another number of values.
    [[nodiscard]] Status factorize(const std::vector<std::complex<double>>& values) override;

    /// Solves A x = b in place.
    void solve(ComplexVectorX& b) const override;

    /// The word that tables print.
    [[nodiscard]] std::string_view name() const noexcept override { return "complex eigen-lu"; }

private:
    struct Factors;  // Eigen's class and its matrix

    Storage storage_;
    detail::Hidden<Factors> factors_{nullptr, nullptr};
};

/// The factorisation of any complex square matrix, columns ordered by COLAMD.
using EigenComplexLu = BasicEigenComplexLu<Eigen::COLAMDOrdering<int>>;

#if defined(ANCF_COMPILED)
extern template class BasicEigenComplexLu<Eigen::COLAMDOrdering<int>>;
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/eigen_complex_lu.ipp>  // IWYU pragma: export
#endif
