// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam at one station: strains, resultants, energy and force.
///
/// The strains are dot products of the local vectors V, so the energy's gradient is V S with S the
/// symmetric matrix of the resultants: docs/theory-continuum.md, "Force".
/// Nothing here compares, divides or takes a root: any Scalar with +, -, * will do. Few types of
/// expression and vectors of six keep the compiler fast and its vector instructions in use.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/continuum/law.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/types.hpp>

namespace ancf::detail::continuum {

/// The local vectors of a station as columns: v_0 = r0', v_1 and v_2 (r_y' and r_z' times the law's
/// unit), a_0 = r_y, a_1 = r_z.
template <class Scalar, int Dimension>
struct Vectors {
    Matrix<Scalar, Dimension, 2 * Dimension - 1> columns;

    [[nodiscard]] auto col(int i) const noexcept { return columns.col(i); }
};

/// The strain coefficients of ContinuumLaw, or the resultants conjugate to them.
template <class Scalar, int Dimension>
struct Strain {
    static constexpr int slopes = Dimension - 1;
    static constexpr int pairs = Dimension * (Dimension + 1) / 2;

    Vector<Scalar, pairs> axial;
    Matrix<Scalar, Dimension, slopes> shear;
    Vector<Scalar, slopes> normal;
    Scalar transverse{0.0};  ///< three dimensions only
};

/// A station and all that is known about it beforehand.
template <int Dimension>
struct Station {
    double xi = 0.0;            ///< place on the axis, 0 to 1
    Vector<double, 3> tangent;  ///< r0' = tangent . (r_j - r_i, r_x at i, r_x at j)
    ContinuumLaw<Dimension>
        law;  ///< times the quadrature weight in m; y and z in units of the element's length
    Strain<double, Dimension> reference;  ///< the strain coefficients of the undeformed beam
};

/// A station that integrates E A eps^2/2 alone.
struct AxialStation {
    Vector<double, 3> tangent;  ///< as Station's
    double stiffness;           ///< E A times the quadrature weight, N m
    double reference;           ///< r0' . r0'/2 of the undeformed beam
};

/// Sums over the stations in the vectors (r_j - r_i, r_x i, r_x j; a at node i; difference of a).
template <class Scalar, int Dimension>
struct Force {
    static constexpr int slopes = Dimension - 1;

    Scalar energy{0.0};
    Matrix<Scalar, Dimension, 3> tangent = Matrix<Scalar, Dimension, 3>::Zero();
    Matrix<Scalar, Dimension, slopes> slope = Matrix<Scalar, Dimension, slopes>::Zero();
    Matrix<Scalar, Dimension, slopes> difference = Matrix<Scalar, Dimension, slopes>::Zero();
};

/// Calls visit(i, j, p) for the pairs i <= j of the law, in their order; p is their place.
template <int Dimension, class Visit>
inline void each_pair(const Visit& visit) noexcept {
    ANCF_UNROLL
    for (int i = 0, p = 0; i < Dimension; ++i) {
        ANCF_UNROLL
        for (int j = i; j < Dimension; ++j, ++p) visit(i, j, p);
    }
}

/// Returns the strain coefficients of local vectors, before the reference is subtracted.
template <class Scalar, int Dimension>
[[nodiscard]] inline Strain<Scalar, Dimension> strain_coefficients(
    const Vectors<Scalar, Dimension>& v) noexcept {
    const auto dot = [&](int i, int j) noexcept {
        const Scalar* x = v.columns.data() + Dimension * i;
        const Scalar* y = v.columns.data() + Dimension * j;
        if constexpr (Dimension == 3)
            return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
        else
            return x[0] * y[0] + x[1] * y[1];
    };
    const Scalar half(0.5);
    Strain<Scalar, Dimension> s;
    each_pair<Dimension>(
        [&](int i, int j, int p) { s.axial(p) = i == j ? Scalar(half * dot(i, j)) : dot(i, j); });
    ANCF_UNROLL
    for (int c = 0; c < Dimension - 1; ++c) {
        const int a = Dimension + c;
        ANCF_UNROLL
        for (int i = 0; i < Dimension; ++i) s.shear(i, c) = dot(i, a);
        s.normal(c) = half * dot(a, a);
    }
    if constexpr (Dimension == 3) s.transverse = dot(3, 4);
    return s;
}

/// Returns M x of a packed symmetric matrix.
template <int Dimension, class Packed, class Scalar>
[[nodiscard]] inline Vector<Scalar, Dimension> packed_times(const Packed& m,
                                                            const Scalar* x) noexcept {
    const auto at = [&](int p) noexcept { return Scalar(m(p)); };
    Vector<Scalar, Dimension> result;
    if constexpr (Dimension == 3) {
        result(0) = at(0) * x[0] + at(1) * x[1] + at(2) * x[2];
        result(1) = at(1) * x[0] + at(3) * x[1] + at(4) * x[2];
        result(2) = at(2) * x[0] + at(4) * x[1] + at(5) * x[2];
    } else {
        result(0) = at(0) * x[0] + at(1) * x[1];
        result(1) = at(1) * x[0] + at(2) * x[1];
    }
    return result;
}

/// Returns the resultants C s, per length or times the weight, as the law is.
template <class Scalar, int Dimension>
[[nodiscard]] inline Strain<Scalar, Dimension> resultants(
    const ContinuumLaw<Dimension>& law, const Strain<Scalar, Dimension>& strain) noexcept {
    constexpr int slopes = Dimension - 1;
    Scalar across = strain.normal(0);
    if constexpr (Dimension == 3) across += strain.normal(1);
    Strain<Scalar, Dimension> stress;
    stress.axial = law.axial.template cast<Scalar>().lazyProduct(strain.axial) +
                   across * law.coupling.template cast<Scalar>();
    Scalar axial(0.0);
    for (int p = 0; p < ContinuumLaw<Dimension>::pairs; ++p)
        axial += Scalar(law.coupling(p)) * strain.axial(p);
    for (int c = 0; c < slopes; ++c) {
        stress.shear.col(c) =
            packed_times<Dimension>(law.shear.col(c), strain.shear.data() + Dimension * c);
        stress.normal(c) = axial + Scalar(law.normal_coupling) * across +
                           Scalar(law.normal - law.normal_coupling) * strain.normal(c);
    }
    if constexpr (Dimension == 3)
        stress.transverse = Scalar(law.transverse_shear) * strain.transverse;
    return stress;
}

/// Returns S: the resultants as the symmetric matrix of the local vectors.
template <class Scalar, int Dimension>
[[nodiscard]] inline Matrix<Scalar, 2 * Dimension - 1> resultant_matrix(
    const Strain<Scalar, Dimension>& stress) noexcept {
    Matrix<Scalar, 2 * Dimension - 1> s;
    each_pair<Dimension>([&](int i, int j, int p) { s(i, j) = s(j, i) = stress.axial(p); });
    ANCF_UNROLL
    for (int c = 0; c < Dimension - 1; ++c) {
        ANCF_UNROLL
        for (int i = 0; i < Dimension; ++i)
            s(i, Dimension + c) = s(Dimension + c, i) = stress.shear(i, c);
        s(Dimension + c, Dimension + c) = stress.normal(c);
    }
    if constexpr (Dimension == 3) s(3, 4) = s(4, 3) = stress.transverse;
    return s;
}

/// Returns the gradient V S of the energy by the local vectors.
template <class Scalar, int Dimension>
[[nodiscard]] inline Vectors<Scalar, Dimension> local_force(
    const Strain<Scalar, Dimension>& stress, const Vectors<Scalar, Dimension>& v) noexcept {
    const Matrix<Scalar, 2 * Dimension - 1> s = resultant_matrix(stress);
    Vectors<Scalar, Dimension> force;
    ANCF_UNROLL
    for (int i = 0; i < 2 * Dimension - 1; ++i)
        force.columns.col(i) = v.columns.lazyProduct(s.col(i));
    return force;
}

/// Returns the strain coefficients less those of the reference.
template <class Scalar, int Dimension>
[[nodiscard]] inline Strain<Scalar, Dimension> station_strain(
    const Station<Dimension>& station, const Vectors<Scalar, Dimension>& v) noexcept {
    Strain<Scalar, Dimension> strain = strain_coefficients(v);
    const Strain<double, Dimension>& reference = station.reference;
    for (int p = 0; p < strain.axial.size(); ++p)
        strain.axial(p) = deformation(strain.axial(p), reference.axial(p));
    for (int p = 0; p < strain.shear.size(); ++p)
        strain.shear(p) = deformation(strain.shear(p), reference.shear(p));
    for (int c = 0; c < Dimension - 1; ++c)
        strain.normal(c) = deformation(strain.normal(c), reference.normal(c));
    if constexpr (Dimension == 3)
        strain.transverse = deformation(strain.transverse, reference.transverse);
    return strain;
}

/// Returns half the product of stress and strain.
template <class Scalar, int Dimension>
[[nodiscard]] inline Scalar half_product(const Strain<Scalar, Dimension>& stress,
                                         const Strain<Scalar, Dimension>& strain) noexcept {
    Scalar sum = stress.transverse * strain.transverse;
    for (int p = 0; p < ContinuumLaw<Dimension>::pairs; ++p)
        sum += stress.axial(p) * strain.axial(p);
    for (int c = 0; c < Dimension - 1; ++c) {
        sum += stress.normal(c) * strain.normal(c);
        for (int i = 0; i < Dimension; ++i) sum += stress.shear(i, c) * strain.shear(i, c);
    }
    return Scalar(0.5) * sum;
}

/// Returns a station's energy, J.
template <class Scalar, int Dimension>
[[nodiscard]] ANCF_NOINLINE Scalar station_energy(const Station<Dimension>& station,
                                                  const Vectors<Scalar, Dimension>& v) noexcept {
    const Strain<Scalar, Dimension> strain = station_strain(station, v);
    return half_product(resultants(station.law, strain), strain);
}

/// Adds the force B(v)^T S of a station's resultants.
template <class Scalar, int Dimension>
inline void add_stress(const Station<Dimension>& station, const Vectors<Scalar, Dimension>& v,
                       const Strain<Scalar, Dimension>& stress,
                       Force<Scalar, Dimension>& sum) noexcept {
    const Vectors<Scalar, Dimension> force = local_force(stress, v);
    const Scalar xi(station.xi);
    ANCF_UNROLL
    for (int m = 0; m < 3; ++m) sum.tangent.col(m) += Scalar(station.tangent(m)) * force.col(0);
    ANCF_UNROLL
    for (int c = 0; c < Dimension - 1; ++c) {
        sum.slope.col(c) += force.col(Dimension + c);
        sum.difference.col(c) += xi * force.col(Dimension + c) + force.col(1 + c);
    }
}

/// Adds a station's energy and force; returns its resultants.
/// @param strained  v, or the vectors that the strains are taken from in their place
template <class Scalar, int Dimension>
ANCF_NOINLINE Strain<Scalar, Dimension> add_force(const Station<Dimension>& station,
                                                  const Vectors<Scalar, Dimension>& v,
                                                  const Vectors<Scalar, Dimension>& strained,
                                                  Force<Scalar, Dimension>& sum) noexcept {
    const Strain<Scalar, Dimension> strain = station_strain(station, strained);
    const Strain<Scalar, Dimension> stress = resultants(station.law, strain);
    sum.energy += half_product(stress, strain);
    add_stress(station, v, stress, sum);
    return stress;
}

/// Returns a station's resultants of the strains of an earlier state, linearised along the
/// correction that followed: docs/theory-statics.md, "Stresses as unknowns".
/// @param earlier  its vectors plus eps times those of the correction
template <class Scalar, int Dimension>
[[nodiscard]] ANCF_NOINLINE Strain<Scalar, Dimension> foreseen(
    const Station<Dimension>& station, const Vectors<Dual<Scalar>, Dimension>& earlier) noexcept {
    const Strain<Dual<Scalar>, Dimension> strain = station_strain(station, earlier);
    Strain<Scalar, Dimension> linear;
    const auto copy = [](const auto& from, auto& to) {
        for (int k = 0; k < to.size(); ++k) to.data()[k] = arrived(from.data()[k]);
    };
    copy(strain.axial, linear.axial);
    copy(strain.shear, linear.shear);
    copy(strain.normal, linear.normal);
    linear.transverse = arrived(strain.transverse);
    return resultants(station.law, linear);
}

/// Returns an axial station's strain; p is r0'.
template <class Scalar, int Dimension>
[[nodiscard]] inline Scalar axial_strain(const AxialStation& station,
                                         const Vector<Scalar, Dimension>& p) noexcept {
    return deformation(Scalar(Scalar(0.5) * product(p, p)), station.reference);
}

/// Adds the force of an axial station's normal force, which has the weight in it.
template <class Scalar, int Dimension>
inline void add_normal(const AxialStation& station, const Vector<Scalar, Dimension>& p,
                       const Scalar& normal, Force<Scalar, Dimension>& sum) noexcept {
    for (int m = 0; m < 3; ++m) sum.tangent.col(m) += (Scalar(station.tangent(m)) * normal) * p;
}

/// Adds an axial station's energy and force; p is r0'. Returns its normal force times the weight.
/// @param strained  p, or the vector that the strain is taken from in its place
template <class Scalar, int Dimension>
inline Scalar add_axial_force(const AxialStation& station, const Vector<Scalar, Dimension>& p,
                              const Vector<Scalar, Dimension>& strained,
                              Force<Scalar, Dimension>& sum) noexcept {
    const Scalar strain = axial_strain(station, strained);
    const Scalar normal = Scalar(station.stiffness) * strain;
    sum.energy += Scalar(0.5) * normal * strain;
    add_normal(station, p, normal, sum);
    return normal;
}

}  // namespace ancf::detail::continuum
