// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam's energy, force and tangent: from nodal coordinates to the stations, the walk
/// over them, and back.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/continuum/kernel.hpp>
#include <ancf/element/continuum/tangent.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <cstddef>

namespace ancf::detail::continuum {

/// What an element of nodal coordinates has at all stations: differences, and slopes at node i.
template <class Scalar, int Dimension>
struct Nodes {
    static constexpr int slopes = Dimension - 1;
    static constexpr int node_dofs = Dimension * (2 + slopes);

    Matrix<Scalar, Dimension, 3> tangent;          ///< r_j - r_i, r_x i, r_x j
    Matrix<Scalar, Dimension, slopes> slope;       ///< r_y, r_z at node i
    Matrix<Scalar, Dimension, slopes> difference;  ///< at node j less at node i

    explicit Nodes(const Vector<Scalar, 2 * node_dofs>& e) noexcept {
        for (int s = 0; s < Dimension; ++s) {
            tangent(s, 0) = e(node_dofs + s) - e(s);
            tangent(s, 1) = e(Dimension + s);
            tangent(s, 2) = e(node_dofs + Dimension + s);
            for (int c = 0; c < slopes; ++c) {
                slope(s, c) = e(Dimension * (2 + c) + s);
                difference(s, c) = e(node_dofs + Dimension * (2 + c) + s) - slope(s, c);
            }
        }
    }

    [[nodiscard]] Vector<Scalar, Dimension> tangent_at(
        const Vector<double, 3>& weights) const noexcept {
        return Scalar(weights(0)) * tangent.col(0) + Scalar(weights(1)) * tangent.col(1) +
               Scalar(weights(2)) * tangent.col(2);
    }

    [[nodiscard]] Vectors<Scalar, Dimension> at(double xi,
                                                const Vector<double, 3>& weights) const noexcept {
        Vectors<Scalar, Dimension> v;
        v.columns.col(0) = tangent_at(weights);
        for (int c = 0; c < slopes; ++c) {
            v.columns.col(1 + c) = difference.col(c);
            v.columns.col(Dimension + c) = slope.col(c) + Scalar(xi) * difference.col(c);
        }
        return v;
    }
};

/// Returns the nodal force of the sums.
template <class Scalar, int Dimension>
[[nodiscard]] inline Vector<Scalar, 2 * Dimension*(Dimension + 1)> nodal_force(
    const Force<Scalar, Dimension>& sum) noexcept {
    constexpr int node_dofs = Dimension * (Dimension + 1);
    Vector<Scalar, 2 * node_dofs> force;
    for (int s = 0; s < Dimension; ++s) {
        force(s) = -sum.tangent(s, 0);
        force(Dimension + s) = sum.tangent(s, 1);
        force(node_dofs + s) = sum.tangent(s, 0);
        force(node_dofs + Dimension + s) = sum.tangent(s, 2);
        for (int c = 0; c < Dimension - 1; ++c) {
            force(Dimension * (2 + c) + s) = sum.slope(s, c) - sum.difference(s, c);
            force(node_dofs + Dimension * (2 + c) + s) = sum.difference(s, c);
        }
    }
    return force;
}

/// Writes a block of a symmetric matrix at (row, column), and its transpose at (column, row).
template <class Block, class Square>
inline void write_twice(const Block& block, int row, int column, Square& k) noexcept {
    ANCF_UNROLL
    for (int j = 0; j < Block::ColsAtCompileTime; ++j) {
        ANCF_UNROLL
        for (int i = 0; i < Block::RowsAtCompileTime; ++i)
            k(row + i, column + j) = k(column + j, row + i) = block(i, j);
    }
}

/// Writes a nodal tangent's rows and columns of r and r_x.
template <class Scalar, int Dimension>
ANCF_NOINLINE void write_tangent_rows(const Tangent<Scalar, Dimension>& sum,
                                      Matrix<Scalar, 2 * Dimension*(Dimension + 1)>& k) noexcept {
    constexpr int node_dofs = Dimension * (Dimension + 1);
    constexpr int all = Dimension * (Dimension - 1);
    constexpr int pairs = Dimension * (Dimension + 1) / 2;
    constexpr int rows[4] = {0, Dimension, node_dofs, node_dofs + Dimension};
    constexpr int from[4] = {0, 1, 0, 2};
    constexpr int pair[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    for (int m = 0; m < 4; ++m) {
        const Scalar sign(m == 0 ? -1.0 : 1.0);
        for (int n = 0; n < 4; ++n) {
            Vector<Scalar, pairs> block = sum.tangent_tangent.col(pair[from[m]][from[n]]);
            if ((m == 0) != (n == 0)) block = -block;
            write_packed<Dimension, 2 * node_dofs>(block.data(),
                                                   k.data() + 2 * node_dofs * rows[n] + rows[m]);
        }
        const auto place = static_cast<std::size_t>(from[m]);
        const Matrix<Scalar, all, Dimension> at_j = sign * sum.difference_tangent[place];
        const Matrix<Scalar, all, Dimension> at_i = sign * sum.slope_tangent[place] - at_j;
        write_twice(at_i, 2 * Dimension, rows[m], k);
        write_twice(at_j, node_dofs + 2 * Dimension, rows[m], k);
    }
}

/// Writes the nodal tangent of the sums.
template <class Scalar, int Dimension>
ANCF_NOINLINE void write_tangent(const Tangent<Scalar, Dimension>& sum,
                                 Matrix<Scalar, 2 * Dimension*(Dimension + 1)>& k) noexcept {
    constexpr int node_dofs = Dimension * (Dimension + 1);
    constexpr int slopes = Dimension - 1;
    constexpr int all = Dimension * slopes;
    write_tangent_rows(sum, k);
    Matrix<Scalar, all> jj =
        Scalar(0.5) * (sum.difference_difference + sum.difference_difference.transpose());
    for (int c = 0, p = 0; c < slopes; ++c)
        for (int d = c; d < slopes; ++d, ++p) {
            const Scalar* packed =
                sum.difference_packed.data() + Dimension * (Dimension + 1) / 2 * p;
            add_packed<Dimension, all>(packed, jj.data() + Dimension * (all * d + c));
            if (c != d) add_packed<Dimension, all>(packed, jj.data() + Dimension * (all * c + d));
        }
    const Matrix<Scalar, all> ij = sum.slope_difference - jj;
    const Matrix<Scalar, all> cross = sum.slope_difference + sum.slope_difference.transpose();
    const Matrix<Scalar, all> ii = (sum.slope_slope + jj) - cross;
    write_twice(ij, 2 * Dimension, node_dofs + 2 * Dimension, k);
    k.template block<all, all>(2 * Dimension, 2 * Dimension) = ii;
    k.template block<all, all>(node_dofs + 2 * Dimension, node_dofs + 2 * Dimension) = jj;
}

/// The stations of an element, and what they add up to.
template <int Dimension>
struct Kernel {
    static constexpr int dimension = Dimension, dofs = 2 * Dimension * (Dimension + 1);

    List<Station<Dimension>> stations;
    List<AxialStation> axial;  ///< of a rule that treats E A eps^2/2 apart

    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& e) const noexcept;

    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e) const noexcept;

    /// Returns B(e)^T C s, s the strains of other coordinates.
    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e,
                                        const Vector<S, dofs>& strained) const noexcept;

    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept;

    /// As LineElement::evaluate() of a state and the correction that led to it.
    template <class S>
    [[nodiscard]] MixedEvaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                                    const Vector<S, dofs>& before,
                                                    const Vector<S, dofs>& change) const noexcept {
        const Nodes<S, Dimension> nodes(e);
        const Nodes<Dual<S>, Dimension> earlier(course(before, change));
        Force<S, Dimension> sum, predicted;
        Tangent<S, Dimension> tangent;
        for (const AxialStation& station : axial) {
            const Vector<S, Dimension> p = nodes.tangent_at(station.tangent);
            const S normal = station.stiffness *
                             arrived(axial_strain(station, earlier.tangent_at(station.tangent)));
            add_axial_force(station, p, p, sum);
            add_normal(station, p, normal, predicted);
            add_axial_tangent(station, p, normal, tangent);
        }
        for (const Station<Dimension>& station : stations) {
            const Vectors<S, Dimension> v = nodes.at(station.xi, station.tangent);
            const auto stress = foreseen(station, earlier.at(station.xi, station.tangent));
            add_force(station, v, v, sum);
            add_stress(station, v, stress, predicted);
            add_tangent(station, v, stress, tangent);
        }
        MixedEvaluation<S, dofs> result;
        result.energy = sum.energy;
        result.force = nodal_force(sum);
        result.predicted = nodal_force(predicted);
        write_tangent(tangent, result.tangent);
        return result;
    }
};

template <int Dimension>
template <class S>
auto Kernel<Dimension>::energy(const Vector<S, dofs>& e) const noexcept -> S {
    const Nodes<S, Dimension> nodes(e);
    Force<S, Dimension> sum;
    for (const AxialStation& station : axial) {
        const Vector<S, Dimension> p = nodes.tangent_at(station.tangent);
        add_axial_force(station, p, p, sum);
    }
    for (const Station<Dimension>& station : stations)
        sum.energy += station_energy(station, nodes.at(station.xi, station.tangent));
    return sum.energy;
}

template <int Dimension>
template <class S>
auto Kernel<Dimension>::force(const Vector<S, dofs>& e) const noexcept -> Vector<S, dofs> {
    return force(e, e);
}

template <int Dimension>
template <class S>
auto Kernel<Dimension>::force(const Vector<S, dofs>& e,
                              const Vector<S, dofs>& strained) const noexcept -> Vector<S, dofs> {
    const Nodes<S, Dimension> nodes(e), of(strained);
    Force<S, Dimension> sum;
    for (const AxialStation& station : axial)
        add_axial_force(station, nodes.tangent_at(station.tangent), of.tangent_at(station.tangent),
                        sum);
    for (const Station<Dimension>& station : stations)
        add_force(station, nodes.at(station.xi, station.tangent),
                  of.at(station.xi, station.tangent), sum);
    return nodal_force(sum);
}

template <int Dimension>
template <class S>
auto Kernel<Dimension>::evaluate(const Vector<S, dofs>& e) const noexcept -> Evaluation<S, dofs> {
    const Nodes<S, Dimension> nodes(e);
    Force<S, Dimension> sum;
    Tangent<S, Dimension> tangent;
    for (const AxialStation& station : axial) {
        const Vector<S, Dimension> p = nodes.tangent_at(station.tangent);
        add_axial_tangent(station, p, add_axial_force(station, p, p, sum), tangent);
    }
    for (const Station<Dimension>& station : stations) {
        const Vectors<S, Dimension> v = nodes.at(station.xi, station.tangent);
        add_tangent(station, v, add_force(station, v, v, sum), tangent);
    }
    Evaluation<S, dofs> result;
    result.energy = sum.energy;
    result.force = nodal_force(sum);
    write_tangent(tangent, result.tangent);
    return result;
}

}  // namespace ancf::detail::continuum
