// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Nodal vectors and nodal scalars of a planar element.
///
/// The scalars of a node are its shear sine and its transverse strain; where shear is cubic, their
/// rates along the element too. A scalar f(a, g) of slope and tangent has the rate
/// f_a.b + f_g.k with b = r_xy and k = r_xx: the dual part of f(a + eps b, g + eps k). So one piece
/// of code in a number type, plain or dual, has values, gradients and second derivatives of both.
/// docs/theory-quintic.md, "In the plane".

#pragma once

#include <ancf/element/cross_section_options.hpp>
#include <ancf/element/hermite.hpp>
#include <ancf/element/rate.hpp>

#include <cmath>
#include <complex>
#include <type_traits>

namespace ancf::detail {

/// The nodal vectors of a planar element in the order of its kernel: D = r_j - r_i, g = r_x, of a
/// quintic line k = r_xx, then a = r_y, and where slopes have rates b = r_xy; of D there is one,
/// of the others one a node.
/// @tparam Line   vectors of the centre line: 3, of a quintic 5
/// @tparam Rates  whether nodal scalars have rates
template <int Line, bool Rates>
struct PlanarLayout {
    static_assert(!Rates || Line == QuinticLine::vectors, "CubicShear goes with QuinticLine");
    static constexpr bool rates = Rates;           ///< whether nodal scalars have rates
    static constexpr int line = Line;              ///< vectors of the centre line
    static constexpr int shears = Rates ? 4 : 2;   ///< s_i, s_j and their rates
    static constexpr int D = 0, g = 1, a = Line;   ///< places, of the first node
    static constexpr int vectors = Line + shears;  ///< all of them
    static constexpr int size = 2 * vectors;       ///< their components
    static constexpr int node = vectors + 1;       ///< coordinates of a node
    static constexpr int dofs = 2 * node;          ///< coordinates of an element

    /// First coordinate of each vector in [r r_x r_y (r_xy) (r_xx)] per node; that of D is r_j's,
    /// and r_i has its negatives.
    static constexpr int start[9] = {
        node,     2, node + 2, Line == 3 ? 4 : node - 2, Line == 3 ? node + 4 : 2 * node - 2, 4,
        node + 4, 6, node + 6};
};

/// How far behind a vector, in components, its rate stands: k behind g, b behind a.
inline constexpr int planar_rate = 4;

/// A nodal scalar: a number, or a number with its rate.
template <class S, bool Rates>
using NodalScalar = std::conditional_t<Rates, Dual<S>, S>;

/// Returns what multiplies a nodal scalar, or its derivatives, to give their share in the energy's:
/// the conjugates f of the scalar and f' of its rate as f' + eps f.
template <bool Rates, class S>
[[nodiscard]] inline NodalScalar<S, Rates> nodal_conjugate(const S* f, int node) noexcept {
    if constexpr (Rates)
        return Dual<S>(f[2 + node], f[node]);
    else
        return f[node];
}

/// Adds an entry of a product with nodal_conjugate(), f dq + f' dq', to a vector over components.
template <class S>
inline void add_nodal(const S& entry, S* to) noexcept {
    *to += entry;
}
template <class S>
inline void add_nodal(const Dual<S>& entry, S* to) noexcept {
    to[0] += entry.rate;
    to[planar_rate] += entry.value;
}

/// Adds an entry of a product with nodal_conjugate(), f d2q + f' d2q', to the upper triangle of a
/// matrix over components; row <= column.
/// @param within  whether row and column belong to one vector
template <int Size, class S>
inline void add_nodal(const S& entry, int row, int column, bool /*within*/,
                      S (&K)[Size][Size]) noexcept {
    K[row][column] += entry;
}
template <int Size, class S>
inline void add_nodal(const Dual<S>& entry, int row, int column, bool within,
                      S (&K)[Size][Size]) noexcept {
    K[row][column] += entry.rate;
    K[row][column + planar_rate] += entry.value;
    if (!within)
        K[row + planar_rate][column] += entry.value;
    else if (row != column)
        K[column][row + planar_rate] += entry.value;
}

/// Sets a component of the gradients of a node's scalars.
template <int Count, int Size, class S>
inline void set_nodal(const S& entry, int node, int place, S (&rows)[Count][Size]) noexcept {
    rows[node][place] = entry;
}
template <int Count, int Size, class S>
inline void set_nodal(const Dual<S>& entry, int node, int place, S (&rows)[Count][Size]) noexcept {
    rows[node][place] = entry.value;
    rows[2 + node][place] = entry.rate;
    rows[2 + node][place + planar_rate] = entry.value;
}

/// The shear sine s = a.g/(|a| |g|) of a node.
template <class S>
struct PlanarSine {
    S value;
    S a[2], g[2];    ///< ds/da, ds/dg
    S u[2], t[2];    ///< unit slope, unit tangent
    S inv_a, inv_g;  ///< 1/|a|, 1/|g|
};

template <class S>
inline PlanarSine<S> planar_sine(const S* a, const S* g) noexcept {
    using std::sqrt;
    PlanarSine<S> s;
    s.inv_a = 1.0 / sqrt(a[0] * a[0] + a[1] * a[1]);
    s.inv_g = 1.0 / sqrt(g[0] * g[0] + g[1] * g[1]);
    for (int k = 0; k < 2; ++k) {
        s.u[k] = s.inv_a * a[k];
        s.t[k] = s.inv_g * g[k];
    }
    s.value = s.u[0] * s.t[0] + s.u[1] * s.t[1];
    for (int k = 0; k < 2; ++k) {
        s.a[k] = s.inv_a * (s.t[k] - s.value * s.u[k]);
        s.g[k] = s.inv_g * (s.u[k] - s.value * s.t[k]);
    }
    return s;
}

/// Adds f d2s; g and a are places of components.
/// @param f  nodal_conjugate() of the sine
template <int Size, class S, class C>
inline void add_sine_second(const PlanarSine<C>& s, const C& f, int g, int a,
                            S (&K)[Size][Size]) noexcept {
    const C aa = f * s.inv_a, gg = f * s.inv_g, ga = f * s.inv_a * s.inv_g;
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            const double delta = i == j ? 1.0 : 0.0;
            if (i <= j) {
                add_nodal(C(-(aa * (s.u[i] * s.a[j] + s.a[i] * s.u[j] +
                                    s.value * s.inv_a * (delta - s.u[i] * s.u[j])))),
                          a + i, a + j, true, K);
                add_nodal(C(-(gg * (s.t[i] * s.g[j] + s.g[i] * s.t[j] +
                                    s.value * s.inv_g * (delta - s.t[i] * s.t[j])))),
                          g + i, g + j, true, K);
            }
            add_nodal(
                C(ga * (delta - s.u[i] * s.u[j] - s.t[i] * s.t[j] + s.value * s.t[i] * s.u[j])),
                g + i, a + j, false, K);
        }
    }
}

/// The nodal vectors and shear sines of an element.
template <class S, class Layout>
struct PlanarNodes {
    using Scalar = NodalScalar<S, Layout::rates>;  ///< a nodal scalar

    S v[Layout::vectors][2];     ///< nodal vectors
    PlanarSine<Scalar> sine[2];  ///< of the two nodes
    S values[Layout::shears];    ///< s_i, s_j and their rates

    template <class Coordinates>
    explicit PlanarNodes(const Coordinates& e) noexcept {
        for (int k = 0; k < 2; ++k) {
            v[Layout::D][k] = e[Layout::node + k] - e[k];
            for (int x = Layout::g; x < Layout::vectors; ++x) v[x][k] = e[Layout::start[x] + k];
        }
        for (int node = 0; node < 2; ++node) {
            const Scalar a[2] = {slope(node, 0), slope(node, 1)};
            const Scalar g[2] = {carried(Layout::g + node, 0), carried(Layout::g + node, 1)};
            sine[node] = planar_sine(a, g);
            if constexpr (Layout::rates) {
                values[node] = sine[node].value.value;
                values[2 + node] = sine[node].value.rate;
            } else {
                values[node] = sine[node].value;
            }
        }
    }

    /// Returns a component of a node's slope r_y, with its rate where there is one.
    [[nodiscard]] Scalar slope(int node, int k) const noexcept {
        return carried(Layout::a + node, k);
    }

    /// Writes the gradients of values by the components of v.
    void gradients(S (&rows)[Layout::shears][Layout::size]) const noexcept {
        for (auto& row : rows)
            for (S& entry : row) entry = S(0.0);
        for (int node = 0; node < 2; ++node) {
            for (int k = 0; k < 2; ++k) {
                set_nodal(sine[node].g[k], node, 2 * (Layout::g + node) + k, rows);
                set_nodal(sine[node].a[k], node, 2 * (Layout::a + node) + k, rows);
            }
        }
    }

private:
    [[nodiscard]] Scalar carried(int vector, int k) const noexcept {
        if constexpr (Layout::rates)
            return Scalar(v[vector][k], v[vector + planar_rate / 2][k]);
        else
            return v[vector][k];
    }
};

}  // namespace ancf::detail
