// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The part of a cable's bending energy that comes from a curved reference.
///
/// In the plane EI (kappa - kappa0)^2/2 = EI kappa^2/2 - EI kappa0 kappa + const. In space a
/// section without torsional stiffness spins freely, so the natural curvature has no direction of
/// its own: two stations at a time share one spin, the one of least energy. docs/theory-cable.md,
/// "Curved references".

#pragma once

#include <ancf/element/cable/kernel.hpp>
#include <ancf/list.hpp>

#include <cmath>
#include <cstddef>

namespace ancf::detail {

/// An element in space whose curvature times length is below this counts as straight.
inline constexpr double straight_curvature = 1e-7;

/// Stations whose natural curvature turns together: one in the plane, up to two in space.
struct NaturalCurvature {
    int count;
    std::size_t station[2];  ///< indices of the bending stations
    double along[2];   ///< alpha: EI kappa0 times weight and length, along the common normal n
    double across[2];  ///< beta: its part along n x t; zero in the plane
    double floor;      ///< keeps the root smooth where the resultant vanishes; zero in the plane
};

/// Returns n x a, n the normal of the plane (which is not used) or a vector in space.
template <class S>
[[nodiscard]] inline Vector<S, 2> turned(const Vector<S, 2>& /*n*/,
                                         const Vector<S, 2>& a) noexcept {
    return {-a[1], a[0]};
}
template <class S>
[[nodiscard]] inline Vector<S, 3> turned(const Vector<S, 3>& n, const Vector<S, 3>& a) noexcept {
    return cross(n, a);
}

/// Returns the matrix [n]x of turned(), times a factor.
template <class S>
[[nodiscard]] inline Matrix<S, 2> turning(const S& factor, const Vector<S, 2>& /*n*/) noexcept {
    Matrix<S, 2> result;
    result << S(0.0), -factor, factor, S(0.0);
    return result;
}
template <class S>
[[nodiscard]] inline Matrix<S, 3> turning(const S& factor, const Vector<S, 3>& n) noexcept {
    const S x = factor * n[0], y = factor * n[1], z = factor * n[2], zero(0.0);
    Matrix<S, 3> result;
    result << zero, -z, y, z, zero, -x, -y, x, zero;
    return result;
}

/// Sums of blocks that are multiples of one matrix [n]x, below the diagonal.
template <class S>
class SkewBlocks {
public:
    /// Adds factor (a_i b_j - b_i a_j) to block (i, j).
    void add(const S& factor, const LineWeights<double>& a, const LineWeights<double>& b) noexcept {
        of_10_ += factor * (a[1] * b[0] - b[1] * a[0]);
        of_20_ += factor * (a[2] * b[0] - b[2] * a[0]);
        of_21_ += factor * (a[2] * b[1] - b[2] * a[1]);
    }

    /// Adds the sums times [n]x.
    template <int D>
    void write(const Vector<S, D>& n, LineHessian<S, D>& hessian) const noexcept {
        hessian.add_block(1, 0, turning(of_10_, n));
        hessian.add_block(2, 0, turning(of_20_, n));
        hessian.add_block(2, 1, turning(of_21_, n));
    }

private:
    S of_10_{0.0}, of_20_{0.0}, of_21_{0.0};
};

/// A station's curvatures and what their derivatives need; names as in add_bending().
template <class S, int D>
struct CurvedStation {
    const CableBendingStation& station;
    Vector<S, D> p, k;
    S inverse, eta, cube;  ///< 1/A, p.v/A, A^(-3/2)
    LineWeights<S> c;
    LineVector<S, D> u, y;

    CurvedStation(const CableBendingStation& station_, const LineVector<S, D>& line) noexcept
        : station(station_), p(interpolated<D>(station.p, line)) {
        using std::sqrt;
        const Vector<S, D> v = interpolated<D>(station.v, line);
        inverse = 1.0 / product(p, p);
        eta = product(p, v) * inverse;
        cube = inverse * sqrt(inverse);
        k = v - eta * p;
        c = {{station.v[0] - eta * station.p[0], station.v[1] - eta * station.p[1],
              station.v[2] - eta * station.p[2]}};
        u = spread(station.p, p);
        y = spread(c, p) + spread(station.p, k);
    }

    /// Adds n . (alpha kappa - beta k/A), kappa = p x k/|p|^3 and k/A = dt/ds, for a fixed n; what
    /// stands with [n]x in the Hessian is added to the coefficients of `skew`.
    template <bool Tangent, class Factor>
    void add(const Factor& alpha, double beta, const Vector<S, D>& n, LineGradient<S, D>& sum,
             LineHessian<S, D>* hessian, SkewBlocks<S>& skew) const noexcept {
        const S scale = alpha * cube;
        const S value = scale * product(turned(n, p), k) * inverse;
        LineVector<S, D> g = scale * (spread(c, turned(n, p)) - spread(station.p, turned(n, k)));
        S by_u = 3.0 * value, by_uu = 7.5 * value, by_g = 3.0 * inverse;
        LineVector<S, D> half;
        if constexpr (Tangent) half = -by_g * g;
        if (beta != 0.0) {
            const S minus = -(beta * inverse), along = product(n, p) * inverse;
            const S bend = minus * product(n, k) * inverse;
            const LineVector<S, D> across = minus * (spread(c, n) - along * y);
            g += across;
            by_u += 2.0 * bend;
            by_uu += 4.0 * bend;
            if constexpr (Tangent) {
                half -= (2.0 * inverse) * across;
                hessian->add(y, LineVector<S, D>((minus * inverse) *
                                                 ((2.0 * along) * u - spread(station.p, n))));
                hessian->add_identity(-(minus * along), c, station.p);
                hessian->add_identity(-(minus * along), station.p, c);
            }
        }
        sum.vector += g - by_u * u;
        if constexpr (Tangent) {
            hessian->add(u, LineVector<S, D>(half + (by_uu * inverse) * u));
            hessian->add_identity(-by_u, station.p, station.p);
            skew.add(scale, station.v, station.p);
        }
    }

    /// Adds the derivatives of the components of alpha kappa - beta k/A by the line.
    void add_gradients(double alpha, double beta, LineVector<S, 3> (&gradients)[3]) const noexcept {
        const S along = alpha * cube, across = beta * inverse;
        const Vector<S, 3> curvature = turned(p, k);
        const S by_y = across * inverse, by_u = -3.0 * along * inverse;
        for (int j = 0; j < 3; ++j)
            gradients[j] += (by_y * p[j]) * y + (2.0 * by_y * k[j] + by_u * curvature[j]) * u;
        for (int i = 0; i < line_vectors; ++i) {
            const Vector<S, 3> d = along * (S(station.p[i]) * k - c[i] * p);
            const S own = across * c[i];
            for (int j = 0; j < 3; ++j) {
                gradients[j][3 * i + j] -= own;
                gradients[j][3 * i + (j + 1) % 3] += d[(j + 2) % 3];
                gradients[j][3 * i + (j + 2) % 3] -= d[(j + 1) % 3];
            }
        }
    }
};

/// Adds -EI kappa0 kappa of a station in the plane.
template <bool Tangent, class S>
ANCF_NOINLINE void add_natural(const NaturalCurvature& natural,
                               const List<CableBendingStation>& stations,
                               const LineVector<S, 2>& line, LineGradient<S, 2>& sum,
                               LineHessian<S, 2>* hessian) noexcept {
    const CurvedStation<S, 2> at(stations[natural.station[0]], line);
    SkewBlocks<S> skew;
    sum.energy -= natural.along[0] * at.cube * product(turned(at.p, at.p), at.k);
    at.template add<Tangent>(-natural.along[0], 0.0, at.p, sum, hessian, skew);
    if constexpr (Tangent) skew.write(at.p, *hessian);
}

/// Replaces a station's moment in the Hessian as foresee_axial() does its axial force; in space as
/// if no reference were curved, since the natural curvature turns. Of kappa = p x v/A^(3/2) the
/// change is (dp x v + p x dv)/A^(3/2) - 3 (p.dp) kappa/A.
template <int D, class S>
void foresee_bending(const CableBendingStation& station, const LineVector<S, D>& line,
                     const EarlierLine<S, D>& earlier, LineGradient<S, D>& gain,
                     LineHessian<S, D>& hessian) noexcept {
    const CurvedStation<S, D> at(station, line), then(station, earlier.at);
    const Vector<S, D> v = interpolated<D>(station.v, earlier.at);
    const Vector<S, D> dp = interpolated<D>(station.p, earlier.change);
    const Vector<S, D> dv = interpolated<D>(station.v, earlier.change);
    const S stiffness(station.stiffness);
    const S stays = 1.0 - 3.0 * product(then.p, dp) * then.inverse;
    SkewBlocks<S> skew;
    if constexpr (D == 2) {
        const auto across = [](const Vector<S, 2>& a, const Vector<S, 2>& b) {
            return a[0] * b[1] - a[1] * b[0];
        };
        const S foreseen =
            then.cube * (stays * across(then.p, v) + across(dp, v) + across(then.p, dv));
        const S moment = stiffness * (foreseen - at.cube * across(at.p, at.k));
        at.template add<true>(moment, 0.0, at.p, gain, &hessian, skew);
        skew.write(at.p, hessian);
    } else {
        const Vector<S, 3> foreseen =
            then.cube * (stays * turned(then.p, v) + turned(dp, v) + turned(then.p, dv));
        const Vector<S, 3> moment = stiffness * (foreseen - at.cube * turned(at.p, at.k));
        at.template add<true>(S(1.0), 0.0, moment, gain, &hessian, skew);
        skew.write(moment, hessian);
    }
}

/// Adds EI kappa' times the gradient of kappa, kappa' its rate, at a station in the plane.
template <class S>
void add_curvature_rate(const CableBendingStation& station, const LineVector<S, 2>& line,
                        LineGradient<S, 2>& sum) noexcept {
    LineHessian<S, 2>* const none = nullptr;
    const CurvedStation<S, 2> at(station, line);
    const S kappa = at.cube * product(turned(at.p, at.p), at.k);
    SkewBlocks<S> skew;
    at.template add<false>(S(station.stiffness * deformation(kappa, 0.0)), 0.0, at.p, sum, none,
                           skew);
}

/// Adds EI D kappa' times the gradient of kappa at a station in space, kappa' its rate:
///
///     D = I - t t^T - b b^T/(kappa.kappa + d^2),    b = t x kappa,
///
/// what the spin of least dissipation about t leaves: docs/theory-damping.md, "Cables".
/// @param floor  d, 1/m: keeps the spin finite where the line is straight
template <class S>
void add_curvature_rate(const CableBendingStation& station, double floor,
                        const LineVector<S, 3>& line, LineGradient<S, 3>& sum) noexcept {
    LineHessian<S, 3>* const none = nullptr;
    const CurvedStation<S, 3> at(station, line);
    const Vector<S, 3> kappa = at.cube * turned(at.p, at.k), across = turned(at.p, kappa);
    Vector<S, 3> rate;
    for (int i = 0; i < 3; ++i) rate[i] = deformation(kappa[i], 0.0);
    const S along = product(at.p, rate) * at.inverse;
    const S spin = product(across, rate) * at.inverse / (product(kappa, kappa) + S(floor * floor));
    SkewBlocks<S> skew;
    at.template add<false>(S(station.stiffness), 0.0,
                           Vector<S, 3>(rate - along * at.p - spin * across), sum, none, skew);
}

/// Returns the resultant Z of the stations that turn together.
template <class S>
[[nodiscard]] inline Vector<S, 3> natural_resultant(const NaturalCurvature& natural,
                                                    const List<CableBendingStation>& stations,
                                                    const LineVector<S, 3>& line) noexcept {
    Vector<S, 3> z = Vector<S, 3>::Zero();
    for (int g = 0; g < natural.count; ++g) {
        const CurvedStation<S, 3> at(stations[natural.station[g]], line);
        z += (natural.along[g] * at.cube) * turned(at.p, at.k) -
             (natural.across[g] * at.inverse) * at.k;
    }
    return z;
}

/// Adds -|Z|, Z = sum (alpha kappa - beta k/A) over the stations that turn together.
template <bool Tangent, class S>
ANCF_NOINLINE void add_natural(const NaturalCurvature& natural,
                               const List<CableBendingStation>& stations,
                               const LineVector<S, 3>& line, LineGradient<S, 3>& sum,
                               LineHessian<S, 3>* hessian) noexcept {
    using std::sqrt;
    const Vector<S, 3> z = natural_resultant(natural, stations, line);
    const S length = sqrt(product(z, z) + natural.floor * natural.floor);
    const S inverse = 1.0 / length;
    const Vector<S, 3> n = inverse * z;
    sum.energy -= length;
    SkewBlocks<S> skew;
    LineVector<S, 3> gradients[3];  // of Z
    if constexpr (Tangent)
        for (auto& gradient : gradients) gradient.setZero();
    for (int g = 0; g < natural.count; ++g) {
        const CurvedStation<S, 3> at(stations[natural.station[g]], line);
        at.template add<Tangent>(-natural.along[g], -natural.across[g], n, sum, hessian, skew);
        if constexpr (Tangent) at.add_gradients(natural.along[g], natural.across[g], gradients);
    }
    if constexpr (Tangent) {  // -(dZ^T dZ - (n.dZ)^T (n.dZ))/|Z|
        skew.write(n, *hessian);
        const auto& [of_x, of_y, of_z] = gradients;
        const LineVector<S, 3> along = n[0] * of_x + n[1] * of_y + n[2] * of_z;
        const S half(0.5);
        hessian->add(inverse, LineVector<S, 3>(-half * of_x), of_x, of_y);
        hessian->add(inverse, LineVector<S, 3>(half * along), along, of_z);
    }
}

}  // namespace ancf::detail
