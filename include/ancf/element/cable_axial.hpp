// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Axial strain of a cable, as a policy: Green or engineering; with a softer law in compression on
/// request.
///
/// Both are functions of A = r'.r', the square of the stretch. A measure gives the strain and, of
/// the energy U = EA eps^2/2, what dU/dr' = n r' and d2U/dr'2 = n I + k r' r'^T need.

#pragma once

#include <ancf/element/pack.hpp>
#include <ancf/element/rate.hpp>

#include <cmath>
#include <complex>

namespace ancf {

namespace detail {

/// Below this strain a bar counts as compressed: the round-off of a strain at rest is not
/// compression.
inline constexpr double slack_strain = -1e-14;

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

}  // namespace detail

/// Green's strain (r'.r' - 1)/2: a polynomial, no root.
struct GreenAxial {
    static constexpr const char* name = "green";  ///< the word that tables print

    /// Returns the strain of a squared stretch, 1.
    template <class S>
    [[nodiscard]] static S strain(const S& square) noexcept {
        return 0.5 * (square - 1.0);
    }

    /// Returns (n, k) of the stiffness c = EA.
    template <class S>
    static void resultants(const S& c, const S& /*square*/, const S& strain, S& n, S& k) noexcept {
        using detail::deformation;  // or that of the scalar
        n = c * deformation(strain, 0.0);
        k = c;
    }
};

/// The engineering strain |r'| - 1, linear in the stretch: the bar of the geometrically exact
/// theories.
struct EngineeringAxial {
    static constexpr const char* name = "engineering";  ///< the word that tables print

    /// Returns the strain of a squared stretch, 1.
    template <class S>
    [[nodiscard]] static S strain(const S& square) noexcept {
        using std::sqrt;
        const S root = sqrt(square);
        return (square - 1.0) /
               (root + 1.0);  // the difference of squares keeps the digits of small strains
    }

    /// Returns (n, k) of the stiffness c = EA: n = c eps/|r'|, k = (c - n)/|r'|^2.
    template <class S>
    static void resultants(const S& c, const S& square, const S& strain, S& n, S& k) noexcept {
        using detail::deformation;
        n = c * deformation(strain, 0.0) / (strain + 1.0);
        k = (c - n) / square;
    }
};

}  // namespace ancf
