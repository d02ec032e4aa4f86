// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Axial strain of a cable, as a policy: Green or engineering; with a softer law in compression on
/// request.
///
/// Both are functions of A = r'.r', the square of the stretch. A measure gives the strain and, of
/// an energy W(eps), what dW/dr' = n r' and d2W/dr'2 = n I + k r' r'^T need.

#pragma once

#include <ancf/element/pack.hpp>
#include <ancf/element/rate.hpp>

#include <cmath>
#include <complex>

namespace ancf {

namespace detail {

/// Below this strain a bar counts as compressed. The round-off of a strain at rest is above it, as
/// of elements of 0.1 m at positions of 1e5 m. A slack bar bears up to 1e-9 E A.
inline constexpr double slack_strain = -1e-9;

/// Between these strains the stiffness of a rope in compression rises to that in tension: what
/// shortens further is not slack but a line that collapses.
inline constexpr double rising_strain = -0.01;
inline constexpr double risen_strain = -0.05;

/// Returns 1 where the strain is not compressive and 0 elsewhere. A pack decides lane by lane, a
/// complex number by its real part, so that kernels need no comparison.
[[nodiscard]] inline double taut(double strain) noexcept {
    return strain >= slack_strain ? 1.0 : 0.0;
}

[[nodiscard]] inline std::complex<double> taut(const std::complex<double>& strain) noexcept {
    return taut(strain.real());
}

template <int Lanes>
[[nodiscard]] inline Pack<Lanes> taut(const Pack<Lanes>& strain) noexcept {
    Pack<Lanes> result;
    for (int k = 0; k < Lanes; ++k) result.set(k, taut(strain[k]));
    return result;
}

/// Whether a bar pulls depends on its strain, not on how that changes.
template <class S>
[[nodiscard]] inline Rate<S> taut(const Rate<S>& strain) noexcept {
    return {taut(strain.value), S(0.0)};
}

/// What an axial strain eps meets.
template <class S>
struct AxialResponse {
    S energy;     ///< W
    S force;      ///< N = dW/deps
    S stiffness;  ///< dN/deps
};

/// Returns the response of a bar or, docs/theory-cable.md, "Compression", of a rope.
/// @param stiffness  in tension; the response has its unit
/// @param soft       1 less the ratio of the stiffness in compression to that in tension; 0: a bar
template <class S>
[[nodiscard]] inline AxialResponse<S> axial_response(const S& stiffness, double soft,
                                                     const S& strain) noexcept {
    if (soft == 0.0)
        return {0.5 * stiffness * strain * strain, stiffness * deformation(strain, 0.0), stiffness};
    constexpr double width = risen_strain - rising_strain;
    const S c = stiffness * (1.0 - soft * (1.0 - taut(strain)));
    const S start = strain - rising_strain, end = strain - risen_strain;
    const S rising = (soft / width) * stiffness * (1.0 - taut(start));
    const S risen = (soft / width) * stiffness * (1.0 - taut(end));
    const S first = rising * start, last = risen * end;
    const S force = c * strain + 0.5 * (first * start - last * end);
    return {0.5 * c * strain * strain + (1.0 / 6.0) * (first * start * start - last * end * end),
            deformation(force, 0.0), c + (first - last)};
}

/// What a measure of cables has.
template <class Measure>
using AxialStrain = decltype(Measure::strain(1.0));

}  // namespace detail

/// Green's strain (r'.r' - 1)/2: a polynomial, no root.
struct GreenAxial {
    /// Returns the strain of a squared stretch, 1.
    template <class S>
    [[nodiscard]] static S strain(const S& square) noexcept {
        return 0.5 * (square - 1.0);
    }

    /// Returns (n, k) of the force N(eps) and its derivative c.
    template <class S>
    static void resultants(const S& force, const S& c, const S& /*square*/, const S& /*strain*/,
                           S& n, S& k) noexcept {
        n = force;
        k = c;
    }
};

/// The engineering strain |r'| - 1, linear in the stretch: the bar of the geometrically exact
/// theories.
struct EngineeringAxial {
    /// Returns the strain of a squared stretch, 1.
    template <class S>
    [[nodiscard]] static S strain(const S& square) noexcept {
        using std::sqrt;
        const S root = sqrt(square);
        return (square - 1.0) /
               (root + 1.0);  // the difference of squares keeps the digits of small strains
    }

    /// Returns (n, k) of the force N(eps) and its derivative c: n = N/|r'|, k = (c - n)/|r'|^2.
    template <class S>
    static void resultants(const S& force, const S& c, const S& square, const S& strain, S& n,
                           S& k) noexcept {
        n = force / (strain + 1.0);
        k = (c - n) / square;
    }
};

}  // namespace ancf
