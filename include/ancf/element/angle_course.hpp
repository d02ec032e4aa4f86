// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How a director turns from one node's carried director to the other's.
///
/// With phi the angle from the first to the second, the director at xi has turned by psi(xi, phi):
///
///     LinearAngle   psi = xi phi                                       the angle is interpolated
///     ChordAngle    tan psi = xi sin phi/(1 - xi + xi cos phi)         the vectors are
///
/// Derivation: docs/theory-directors.md, "The course of the angle".

#pragma once

#include <cmath>
#include <complex>

namespace ancf::detail {

/// The angle is linear between the nodes.
struct LinearAngle {
    static constexpr bool linear = true;  ///< whether psi is in proportion to phi
};

/// The angle is that of the vectors' linear interpolation.
struct ChordAngle {
    static constexpr bool linear = false;  ///< whether psi is in proportion to phi
};

/// psi at a station with its derivatives.
template <class S>
struct AngleCourse {
    S value;    ///< psi
    S rate;     ///< psi_x at a fixed phi
    S share;    ///< psi_phi
    S share_x;  ///< psi_phi,x
    S bend;     ///< psi_phi,phi
    S bend_x;   ///< psi_phi,phi,x
    S change;   ///< psi_phi,phi,phi
};

/// Returns psi of ChordAngle with its derivatives.
/// @param part,part_x  xi and its derivative along x
/// @param turn         phi
template <class S>
inline AngleCourse<S> chord_course(const S& part, const S& part_x, const S& turn) noexcept {
    using std::atan;
    using std::cos;
    using std::sin;
    using std::sqrt;
    const S cosine = cos(turn), sine = sin(turn), rest = 1.0 - part;
    const S along = rest + part * cosine, across = part * sine;
    const S square = along * along + across * across, inverse = 1.0 / square;
    const S skew = part * rest * inverse, k = skew * sine, slant = (2.0 * part - 1.0) * inverse;
    AngleCourse<S> psi;
    psi.value = 2.0 * atan(S(across / (sqrt(square) + along)));
    psi.rate = part_x * inverse * sine;
    psi.share = part * inverse * (part + rest * cosine);
    psi.share_x = part_x * inverse * (cosine + 2.0 * k * sine);
    psi.bend = slant * k;
    psi.bend_x = part_x * inverse * ((8.0 * k * k - 1.0) * sine + 6.0 * k * cosine);
    psi.change = slant * skew * (cosine + 4.0 * k * sine);
    return psi;
}

}  // namespace ancf::detail
