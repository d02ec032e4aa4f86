// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam's tangent at one station: B^T C B + S (x) I, summed to the nodes.
///
/// docs/theory-continuum.md, "Tangent". Symmetric 3 x 3 blocks are packed into six numbers, in the
/// order of the law's pairs: half the work, and vector instructions fit.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/continuum/kernel.hpp>
#include <ancf/element/continuum/law.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cstddef>

namespace ancf::detail::continuum {

/// As Force, second derivatives. Symmetric D x D blocks are packed in the order of the law's pairs.
template <class Scalar, int Dimension>
struct Tangent {
    static constexpr int slopes = Dimension - 1;
    static constexpr int pairs = Dimension * (Dimension + 1) / 2;
    static constexpr int all = Dimension * slopes;
    using Column = Matrix<Scalar, all, Dimension>;
    using Square = Matrix<Scalar, all>;

    Matrix<Scalar, pairs, 6> tangent_tangent =
        Matrix<Scalar, pairs, 6>::Zero();  ///< by pairs of the three
    std::array<Column, 3> slope_tangent{Column::Zero(), Column::Zero(), Column::Zero()};
    std::array<Column, 3> difference_tangent{Column::Zero(), Column::Zero(), Column::Zero()};
    Square slope_slope = Square::Zero();
    Square slope_difference = Square::Zero();
    Square difference_difference = Square::Zero();  ///< its symmetric part is meant
    Matrix<Scalar, pairs, pairs - Dimension> difference_packed =
        Matrix<Scalar, pairs, pairs - Dimension>::Zero();
};

/// Writes x y^T + y x^T, packed.
template <int Dimension, class Scalar>
inline void packed_product(const Scalar* x, const Scalar* y, Scalar* packed) noexcept {
    each_pair<Dimension>([&](int i, int j, int p) { packed[p] = x[i] * y[j] + x[j] * y[i]; });
}

/// Writes x x^T, packed.
template <int Dimension, class Scalar>
inline void packed_square(const Scalar* x, Scalar* packed) noexcept {
    each_pair<Dimension>([&](int i, int j, int p) { packed[p] = x[i] * x[j]; });
}

/// Writes a packed block to the D x D block at `full`, of a column-major matrix of so many rows.
template <int Dimension, int Rows, class Scalar>
inline void write_packed(const Scalar* packed, Scalar* full) noexcept {
    full[0] = packed[0];
    full[1] = full[Rows] = packed[1];
    full[Rows + 1] = packed[Dimension];
    if constexpr (Dimension == 3) {
        full[2] = full[2 * Rows] = packed[2];
        full[Rows + 2] = full[2 * Rows + 1] = packed[4];
        full[2 * Rows + 2] = packed[5];
    }
}

/// Adds a packed block to the D x D block at `full`, of a column-major matrix of so many rows.
template <int Dimension, int Rows, class Scalar>
inline void add_packed(const Scalar* packed, Scalar* full) noexcept {
    full[0] += packed[0];
    full[1] += packed[1];
    full[Rows] += packed[1];
    full[Rows + 1] += packed[Dimension];
    if constexpr (Dimension == 3) {
        full[2] += packed[2];
        full[Rows + 2] += packed[4];
        full[2 * Rows] += packed[2];
        full[2 * Rows + 1] += packed[4];
        full[2 * Rows + 2] += packed[5];
    }
}

/// Adds a number to the diagonal of a packed block.
template <int Dimension, class Scalar>
inline void add_to_diagonal(Scalar* packed, const Scalar& value) noexcept {
    ANCF_UNROLL
    for (int i = 0; i < Dimension; ++i) packed[ContinuumLaw<Dimension>::pair(i, i)] += value;
}

/// What the Hessian is made of: packed products of the local vectors.
template <class Scalar, int Dimension>
struct Products {
    static constexpr int slopes = Dimension - 1;
    static constexpr int pairs = Dimension * (Dimension + 1) / 2;

    Matrix<Scalar, pairs> gradient;       ///< by pairs: v_i v_j^T + v_j v_i^T (i < j), v_i v_i^T
    Matrix<Scalar, pairs, slopes> slope;  ///< a_c a_c^T

    explicit Products(const Vectors<Scalar, Dimension>& v) noexcept {
        const auto at = [&](int i) noexcept { return v.columns.data() + Dimension * i; };
        packed_square<Dimension>(at(0), gradient.data());
        packed_product<Dimension>(at(0), at(1), gradient.data() + pairs);
        packed_square<Dimension>(at(1), gradient.data() + Dimension * pairs);
        packed_square<Dimension>(at(Dimension), slope.data());
        if constexpr (Dimension == 3) {
            packed_product<Dimension>(at(0), at(2), gradient.data() + 2 * pairs);
            packed_product<Dimension>(at(1), at(2), gradient.data() + 4 * pairs);
            packed_square<Dimension>(at(2), gradient.data() + 5 * pairs);
            packed_square<Dimension>(at(4), slope.data() + pairs);
        }
    }
};

/// Returns the Hessian of v_i with v_j for each pair, packed.
template <class Scalar, int Dimension>
[[nodiscard]] ANCF_NOINLINE Matrix<Scalar, Dimension*(Dimension + 1) / 2> gradient_hessian(
    const ContinuumLaw<Dimension>& law, const Strain<Scalar, Dimension>& stress,
    const Products<Scalar, Dimension>& products) noexcept {
    constexpr int pairs = Dimension * (Dimension + 1) / 2;
    Matrix<Scalar, pairs> hessian;
    for (int p = 0; p < pairs; ++p) {
        auto block = hessian.col(p);
        block = products.gradient.lazyProduct(law.axial.col(p).template cast<Scalar>());
        for (int c = 0; c < Dimension - 1; ++c)
            block += Scalar(law.shear(p, c)) * products.slope.col(c);
        add_to_diagonal<Dimension>(hessian.data() + pairs * p, stress.axial(p));
    }
    return hessian;
}

/// Returns the Hessian of the slopes, one below the other, with themselves.
template <class Scalar, int Dimension>
[[nodiscard]] ANCF_NOINLINE Matrix<Scalar, Dimension*(Dimension - 1)> slope_hessian(
    const ContinuumLaw<Dimension>& law, const Vectors<Scalar, Dimension>& v,
    const Strain<Scalar, Dimension>& stress, const Products<Scalar, Dimension>& products) noexcept {
    constexpr int all = Dimension * (Dimension - 1);
    Matrix<Scalar, all> hessian;
    for (int c = 0; c < Dimension - 1; ++c) {
        Vector<Scalar, Dimension*(Dimension + 1) / 2> block =
            products.gradient.lazyProduct(law.shear.col(c).template cast<Scalar>());
        block += Scalar(law.normal) * products.slope.col(c);
        if constexpr (Dimension == 3)
            block += Scalar(law.transverse_shear) * products.slope.col(1 - c);
        add_to_diagonal<Dimension>(block.data(), stress.normal(c));
        write_packed<Dimension, all>(block.data(), hessian.data() + (all + 1) * Dimension * c);
    }
    if constexpr (Dimension == 3) {
        const Scalar coupling(law.normal_coupling), shear(law.transverse_shear);
        for (int s = 0; s < 3; ++s) {
            for (int r = 0; r < 3; ++r)
                hessian(r, 3 + s) = coupling * v.columns(r, 3) * v.columns(s, 4) +
                                    shear * v.columns(r, 4) * v.columns(s, 3);
            hessian(s, 3 + s) += stress.transverse;
        }
        hessian.template bottomLeftCorner<3, 3>() =
            hessian.template topRightCorner<3, 3>().transpose();
    }
    return hessian;
}

/// Returns the Hessian of the slopes, one below the other (rows), with the vectors v_i (columns).
template <class Scalar, int Dimension>
[[nodiscard]] ANCF_NOINLINE Matrix<Scalar, Dimension*(Dimension - 1), Dimension * Dimension>
mixed_hessian(const ContinuumLaw<Dimension>& law, const Vectors<Scalar, Dimension>& v,
              const Strain<Scalar, Dimension>& stress) noexcept {
    constexpr int slopes = Dimension - 1;
    constexpr int all = Dimension * slopes;
    using Column = Vector<Scalar, all>;
    // The block of a_c and v_i is u_ci a_c^T + a_c g_i^T + shear(i, c) I with
    // u_ci = sum_k shear_c(ik) v_k (`sheared`), g_i = sum_k coupling(ik) v_k (`coupled`).
    const Column slope = Eigen::Map<const Column>(v.columns.data() + Dimension * Dimension);
    Matrix<Scalar, all, Dimension> repeated, sheared = Matrix<Scalar, all, Dimension>::Zero();
    Matrix<Scalar, Dimension> coupled = Matrix<Scalar, Dimension>::Zero();
    for (int r = 0; r < Dimension; ++r)
        for (int c = 0; c < slopes; ++c)
            for (int s = 0; s < Dimension; ++s)
                repeated(Dimension * c + s, r) = v.columns(r, Dimension + c);
    ANCF_UNROLL
    for (int i = 0; i < Dimension; ++i) {
        ANCF_UNROLL
        for (int k = 0; k < Dimension; ++k) {
            const int p =
                i < k ? ContinuumLaw<Dimension>::pair(i, k) : ContinuumLaw<Dimension>::pair(k, i);
            coupled.col(i) += Scalar(law.coupling(p)) * v.col(k);
            ANCF_UNROLL
            for (int c = 0; c < slopes; ++c)
                sheared.col(i).template segment<Dimension>(Dimension * c) +=
                    Scalar(law.shear(p, c)) * v.col(k);
        }
    }
    Matrix<Scalar, all, Dimension * Dimension> hessian;
    ANCF_UNROLL
    for (int i = 0; i < Dimension; ++i) {
        ANCF_UNROLL
        for (int r = 0; r < Dimension; ++r) {
            auto column = hessian.col(Dimension * i + r);
            column = repeated.col(r).cwiseProduct(sheared.col(i)) + coupled(r, i) * slope;
            for (int c = 0; c < slopes; ++c) column(Dimension * c + r) += stress.shear(i, c);
        }
    }
    return hessian;
}

/// Adds a station's tangent.
template <class Scalar, int Dimension>
ANCF_NOINLINE void add_tangent(const Station<Dimension>& station,
                               const Vectors<Scalar, Dimension>& v,
                               const Strain<Scalar, Dimension>& stress,
                               Tangent<Scalar, Dimension>& sum) noexcept {
    constexpr int slopes = Dimension - 1;
    constexpr int pairs = ContinuumLaw<Dimension>::pairs;
    constexpr int all = Dimension * slopes;
    constexpr int square = Dimension * Dimension;
    const Scalar xi(station.xi);
    const Products<Scalar, Dimension> products(v);
    const Matrix<Scalar, pairs> along = gradient_hessian(station.law, stress, products);
    const Matrix<Scalar, all> across = slope_hessian(station.law, v, stress, products);
    const Matrix<Scalar, all, square> mixed = mixed_hessian(station.law, v, stress);

    ANCF_UNROLL
    for (int m = 0, p = 0; m < 3; ++m) {
        ANCF_UNROLL
        for (int n = m; n < 3; ++n, ++p)
            sum.tangent_tangent.col(p) +=
                Scalar(station.tangent(m) * station.tangent(n)) * along.col(0);
    }

    const Matrix<Scalar, all, Dimension> slope = mixed.template leftCols<Dimension>();
    Matrix<Scalar, all, Dimension> difference = xi * slope;
    for (int c = 0; c < slopes; ++c)
        add_packed<Dimension, all>(along.data() + pairs * (1 + c),
                                   difference.data() + Dimension * c);
    for (std::size_t m = 0; m < 3; ++m) {
        const Scalar weight(station.tangent(static_cast<int>(m)));
        sum.slope_tangent[m] += weight * slope;
        sum.difference_tangent[m] += weight * difference;
    }

    const Matrix<Scalar, all> turned = mixed.template rightCols<all>();
    const Matrix<Scalar, all> whole = turned + xi * across;
    sum.slope_slope += across;
    sum.slope_difference += whole;
    sum.difference_difference += xi * (whole + turned);
    sum.difference_packed += along.template rightCols<pairs - Dimension>();
}

/// Adds an axial station's tangent.
template <class Scalar, int Dimension>
inline void add_axial_tangent(const AxialStation& station, const Vector<Scalar, Dimension>& p,
                              const Scalar& normal, Tangent<Scalar, Dimension>& sum) noexcept {
    Vector<Scalar, Dimension*(Dimension + 1) / 2> block;
    packed_square<Dimension>(p.data(), block.data());
    block *= Scalar(station.stiffness);
    add_to_diagonal<Dimension>(block.data(), normal);
    for (int m = 0, q = 0; m < 3; ++m)
        for (int n = m; n < 3; ++n, ++q)
            sum.tangent_tangent.col(q) += Scalar(station.tangent(m) * station.tangent(n)) * block;
}

}  // namespace ancf::detail::continuum
