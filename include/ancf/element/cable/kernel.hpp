// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cable at its stations: energy, gradient and Hessian in the three nodal vectors of a line,
/// and the way from nodal coordinates (r, r_x)_i, (r, r_x)_j and back.
///
/// With the line vector (r_j - r_i, r_x at i, r_x at j), p = r' and v = r'' are weighted sums of
/// its parts. A station's Hessian is a few products of line vectors plus scalars times I:
/// docs/theory-cable.md, "Tangent". S is the scalar; nothing here compares one.

#pragma once

#include <ancf/element/cable/axial.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// Number of nodal vectors: r_j - r_i, r_x of node i, r_x of node j.
inline constexpr int line_vectors = 3;

/// Three vectors, one below the other.
template <class S, int D>
using LineVector = Vector<S, line_vectors * D>;

/// Their weights in a vector of a station.
template <class T>
struct LineWeights {
    T of[line_vectors];

    const T& operator[](int a) const noexcept { return of[a]; }
    T& operator[](int a) noexcept { return of[a]; }
};

/// A station that integrates EA eps^2/2.
struct CableAxialStation {
    LineWeights<double> p;  ///< in p = r', per arc length of the reference
    double stiffness;       ///< EA times weight and length, N m
};

/// A station that integrates EI kappa^2/2.
struct CableBendingStation {
    LineWeights<double> p;  ///< in p = r'
    LineWeights<double> v;  ///< in v = r'', 1/m
    double stiffness;       ///< EI times weight and length, N m^3
};

/// Energy and its first derivatives.
template <class S, int D>
struct LineGradient {
    S energy{0.0};
    LineVector<S, D> vector = LineVector<S, D>::Zero();
};

/// Second derivatives. Of the 3 x 3 blocks those on and below the diagonal count.
template <class S, int D>
class LineHessian {
public:
    /// Adds a b^T + b a^T - c c^T, times a factor.
    void add(const S& factor, const LineVector<S, D>& a, const LineVector<S, D>& b,
             const LineVector<S, D>& c) noexcept {
        add_columns<0>(factor, a, b, c);
        add_columns<1>(factor, a, b, c);
        add_columns<2>(factor, a, b, c);
    }

    /// Adds a b^T + b a^T.
    void add(const LineVector<S, D>& a, const LineVector<S, D>& b) noexcept {
        add_columns<0>(a, b);
        add_columns<1>(a, b);
        add_columns<2>(a, b);
    }

    /// Adds factor a a^T.
    void add(const S& factor, const LineVector<S, D>& a) noexcept {
        add_columns<0>(factor, a);
        add_columns<1>(factor, a);
        add_columns<2>(factor, a);
    }

    /// Adds factor a_i b_j I to block (i, j).
    template <class A, class B>
    void add_identity(const S& factor, const LineWeights<A>& a, const LineWeights<B>& b) noexcept {
        const S first = factor * a[0], second = factor * a[1], third = factor * a[2];
        identity_[0] += first * b[0];
        identity_[1] += second * b[0];
        identity_[2] += second * b[1];
        identity_[3] += third * b[0];
        identity_[4] += third * b[1];
        identity_[5] += third * b[2];
    }

    /// Adds m to block (i, j), i >= j.
    void add_block(int i, int j, const Matrix<S, D>& m) noexcept {
        outer_.template block<D, D>(D * i, D * j) += m;
    }

    /// Returns block (i, j), i >= j.
    [[nodiscard]] Matrix<S, D> block(int i, int j) const noexcept {
        Matrix<S, D> result = outer_.template block<D, D>(D * i, D * j);
        for (int k = 0; k < D; ++k) result(k, k) += identity_[i * (i + 1) / 2 + j];
        return result;
    }

private:
    template <int First>
    void add_columns(const S& factor, const LineVector<S, D>& a, const LineVector<S, D>& b,
                     const LineVector<S, D>& c) noexcept {
        constexpr int rows = D * (line_vectors - First);
        for (int j = D * First; j < D * (First + 1); ++j) {
            const S by_a = factor * b[j], by_b = factor * a[j], by_c = factor * c[j];
            outer_.template block<rows, 1>(D * First, j) += a.template tail<rows>() * by_a +
                                                            b.template tail<rows>() * by_b -
                                                            c.template tail<rows>() * by_c;
        }
    }

    template <int First>
    void add_columns(const LineVector<S, D>& a, const LineVector<S, D>& b) noexcept {
        constexpr int rows = D * (line_vectors - First);
        for (int j = D * First; j < D * (First + 1); ++j)
            outer_.template block<rows, 1>(D * First, j) +=
                a.template tail<rows>() * b[j] + b.template tail<rows>() * a[j];
    }

    template <int First>
    void add_columns(const S& factor, const LineVector<S, D>& a) noexcept {
        constexpr int rows = D * (line_vectors - First);
        for (int j = D * First; j < D * (First + 1); ++j) {
            const S by_a = factor * a[j];
            outer_.template block<rows, 1>(D * First, j) += a.template tail<rows>() * by_a;
        }
    }

    Matrix<S, line_vectors* D> outer_ = Matrix<S, line_vectors * D>::Zero();
    S identity_[line_vectors * (line_vectors + 1) / 2] = {S(0.0), S(0.0), S(0.0),
                                                          S(0.0), S(0.0), S(0.0)};
};

/// Returns the weighted sum of the nodal vectors.
template <int D, class T, class S>
[[nodiscard]] inline Vector<S, D> interpolated(const LineWeights<T>& weights,
                                               const Vector<S, 3 * D>& line) noexcept {
    return S(weights[0]) * line.template head<D>() + S(weights[1]) * line.template segment<D>(D) +
           S(weights[2]) * line.template tail<D>();
}

/// Returns a vector times each of the weights.
template <class T, class S, int D>
[[nodiscard]] inline LineVector<S, D> spread(const LineWeights<T>& weights,
                                             const Vector<S, D>& a) noexcept {
    LineVector<S, D> result;
    result.template head<D>() = S(weights[0]) * a;
    result.template segment<D>(D) = S(weights[1]) * a;
    result.template tail<D>() = S(weights[2]) * a;
    return result;
}

/// Adds the energy of the axial strain at a station: gradient n u, Hessian k u u^T + n P P^T (x) I,
/// P the weights of p and u = P (x) p.
/// @param soft  1 less the ratio of the stiffness in compression to that in tension
template <bool Tangent, class Measure, int D, class S>
inline void add_axial(const CableAxialStation& station, double soft, const Vector<S, 3 * D>& line,
                      LineGradient<S, D>& sum, LineHessian<S, D>* hessian) noexcept {
    const Vector<S, D> p = interpolated<D>(station.p, line);
    const S square = product(p, p);
    const S strain = Measure::strain(square);
    const AxialResponse<S> axial = axial_response(S(station.stiffness), soft, strain);
    S n, k;
    Measure::resultants(axial.force, axial.stiffness, square, strain, n, k);
    sum.energy += axial.energy;
    const LineVector<S, D> u = spread(station.p, p);
    sum.vector += n * u;
    if constexpr (Tangent) {
        hessian->add(k, u);
        hessian->add_identity(n, station.p, station.p);
    }
}

/// A line before a correction, and the correction.
template <class S, int D>
struct EarlierLine {
    LineVector<S, D> at, change;
};

/// Replaces a station's axial force in the Hessian by the one of an earlier line, linearised along
/// the correction that followed: docs/theory-statics.md, "Stresses as unknowns".
/// @param gain  change of the gradient by these forces, to add to
template <class Measure, int D, class S>
inline void foresee_axial(const CableAxialStation& station, double soft,
                          const LineVector<S, D>& line, const EarlierLine<S, D>& earlier,
                          LineGradient<S, D>& gain, LineHessian<S, D>& hessian) noexcept {
    const Vector<S, D> p = interpolated<D>(station.p, line);
    const Vector<S, D> before = interpolated<D>(station.p, earlier.at);
    const Vector<S, D> change = interpolated<D>(station.p, earlier.change);
    const S square = product(p, p), strain = Measure::strain(square), stiffness(station.stiffness);
    const Dual<S> foreseen =
        Measure::strain(Dual<S>(product(before, before), 2.0 * product(before, change)));
    const AxialResponse<S> now = axial_response(stiffness, soft, strain);
    const AxialResponse<S> then = axial_response(stiffness, soft, arrived(foreseen));
    S n, k, n_then, k_then;
    Measure::resultants(now.force, now.stiffness, square, strain, n, k);
    Measure::resultants(then.force, now.stiffness, square, strain, n_then, k_then);
    const LineVector<S, D> u = spread(station.p, p);
    gain.vector += (n_then - n) * u;
    hessian.add(k_then - k, u);
    hessian.add_identity(n_then - n, station.p, station.p);
}

/// Adds EI kappa^2/2 = s k.k/2 at a station, s = EI/A^2, A = p.p, k = v - eta p, eta = p.v/A, q =
/// k.k/A.
///
/// With the weights c = V - eta P of k: gradient s (c (x) k - 2 q u), Hessian s (c c^T - 2 q P P^T)
/// (x) I + (s/A) (u h^T + h u^T - y y^T), u = P (x) p, y = c (x) p + P (x) k, h = 6 q u - 4 c (x)
/// k.
template <bool Tangent, int D, class S>
inline void add_bending(const CableBendingStation& station, const Vector<S, 3 * D>& line,
                        LineGradient<S, D>& sum, LineHessian<S, D>* hessian) noexcept {
    const Vector<S, D> p = interpolated<D>(station.p, line);
    const Vector<S, D> v = interpolated<D>(station.v, line);
    const S inverse = 1.0 / product(p, p);
    const S eta = product(p, v) * inverse;
    const LineWeights<S> c{{station.v[0] - eta * station.p[0], station.v[1] - eta * station.p[1],
                            station.v[2] - eta * station.p[2]}};
    const Vector<S, D> k = v - eta * p;
    const S square = product(k, k);
    const S q = square * inverse;
    const S s = station.stiffness * inverse * inverse;
    sum.energy += 0.5 * s * square;
    const LineVector<S, D> u = spread(station.p, p), ck = spread(c, k);
    const S minus_2q = -2.0 * q;
    sum.vector += s * (ck + minus_2q * u);
    if constexpr (Tangent) {
        const LineVector<S, D> y = spread(c, p) + spread(station.p, k);
        const S six_q = 6.0 * q, four(4.0);
        const LineVector<S, D> h = six_q * u - four * ck;
        hessian->add(s * inverse, u, h, y);
        hessian->add_identity(s, c, c);
        hessian->add_identity(s * minus_2q, station.p, station.p);
    }
}

/// Returns the nodal vectors r_j - r_i and both r_x.
template <int D, class S>
[[nodiscard]] inline LineVector<S, D> line_of(const Vector<S, 4 * D>& e) noexcept {
    LineVector<S, D> line;
    for (int k = 0; k < D; ++k) {
        line[k] = e[2 * D + k] - e[k];
        line[D + k] = e[D + k];
        line[2 * D + k] = e[3 * D + k];
    }
    return line;
}

/// Returns derivatives by the nodal vectors as a nodal force.
template <int D, class S>
[[nodiscard]] inline Vector<S, 4 * D> nodal_force(const LineVector<S, D>& line) noexcept {
    Vector<S, 4 * D> force;
    for (int k = 0; k < D; ++k) {
        force[k] = -line[k];
        force[D + k] = line[D + k];
        force[2 * D + k] = line[k];
        force[3 * D + k] = line[2 * D + k];
    }
    return force;
}

/// Writes second derivatives by the nodal vectors as a nodal tangent.
template <int D, class S>
inline void write_tangent(const LineHessian<S, D>& line, Matrix<S, 4 * D>& tangent) noexcept {
    constexpr int r_i = 0, g_i = D, r_j = 2 * D, g_j = 3 * D;
    const Matrix<S, D> rr = line.block(0, 0), ri = line.block(1, 0), ij = line.block(2, 1),
                       rj = line.block(2, 0);
    const Matrix<S, D> ii = line.block(1, 1), jj = line.block(2, 2);
    for (int j = 0; j < D; ++j) {
        for (int i = 0; i < D; ++i) {
            tangent(r_i + i, r_i + j) = tangent(r_j + i, r_j + j) = rr(i, j);
            tangent(r_i + i, r_j + j) = tangent(r_j + i, r_i + j) = -rr(i, j);
            tangent(g_i + i, r_i + j) = tangent(r_i + j, g_i + i) = -ri(i, j);
            tangent(g_i + i, r_j + j) = tangent(r_j + j, g_i + i) = ri(i, j);
            tangent(g_j + i, r_i + j) = tangent(r_i + j, g_j + i) = -rj(i, j);
            tangent(g_j + i, r_j + j) = tangent(r_j + j, g_j + i) = rj(i, j);
            tangent(g_i + i, g_i + j) = ii(i, j);
            tangent(g_j + i, g_i + j) = tangent(g_i + j, g_j + i) = ij(i, j);
            tangent(g_j + i, g_j + j) = jj(i, j);
        }
    }
}

}  // namespace ancf::detail
