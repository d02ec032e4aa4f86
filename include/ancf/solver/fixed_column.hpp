// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Columns of a fixed length in registers, for the inner loops of the solver for chains.
///
/// Made of the compiler's own vectors: an expression library costs a program more to compile than
/// all else in a solution.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/solver/dense_lu.hpp>

#include <complex>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__GNUC__) && !defined(__clang__)
#define ANCF_UNROLL_COLUMN _Pragma("GCC unroll 16")
#define ANCF_UNROLL_BLOCK _Pragma("GCC unroll 24")
#else
#define ANCF_UNROLL_COLUMN
#define ANCF_UNROLL_BLOCK
#endif

namespace ancf::detail {

/// Returns 1 / a; of a complex number without a look for infinities where its square has none.
inline double reciprocal(double a) noexcept { return 1.0 / a; }
inline std::complex<double> reciprocal(const std::complex<double>& a) noexcept {
    const double square = a.real() * a.real() + a.imag() * a.imag();
    if (!(square > 1e-250 && square < 1e250)) return 1.0 / a;
    const double inverse = 1.0 / square;
    return {a.real() * inverse, -a.imag() * inverse};
}

/// Returns how many of N doubles stand in one register.
constexpr int column_lanes(int n, int lanes = register_lanes) {
    return n % lanes == 0 ? lanes : column_lanes(n, lanes / 2);
}

/// Real and imaginary parts, each in the other's place.
template <class Vector, std::size_t... K>
inline Vector swapped_pairs(const Vector& a, std::index_sequence<K...>) noexcept {
    return Vector{a[K ^ 1U]...};
}

/// Real numbers to multiply imaginary parts by: -b, b, -b, b and so on.
template <class Vector, std::size_t... K>
inline Vector alternating(double b, std::index_sequence<K...>) noexcept {
    return Vector{(K % 2 == 0 ? -b : b)...};
}

/// A column of N scalars, double or complex; complex ones stand in registers as pairs of doubles.
template <class Scalar, int N>
struct FixedColumn {
    static constexpr bool real = std::is_same_v<Scalar, double>;
    static constexpr int doubles = column_lanes(real ? N : 2 * N);  // in a register
    static constexpr bool paired = !real && doubles > 1;
    static constexpr int lanes = real ? doubles : paired ? doubles / 2 : 1;  // scalars in one
    static constexpr int parts = N / lanes;
    using Part = std::conditional_t<real || paired, PackType<doubles>, Scalar>;

    Part part[parts];

    static FixedColumn zero() noexcept { return FixedColumn{}; }
    static FixedColumn at(const Scalar* first) noexcept {
        FixedColumn out;
        ANCF_UNROLL_COLUMN
        for (int k = 0; k < parts; ++k) out.part[k] = load(first + k * lanes);
        return out;
    }
    void store(Scalar* first) const noexcept {
        ANCF_UNROLL_COLUMN
        for (int k = 0; k < parts; ++k) {
            std::memcpy(static_cast<void*>(first + k * lanes), &part[k], sizeof(Part));
        }
    }

    Scalar operator[](int k) const noexcept {
        if constexpr (lanes == 1 && !paired) {
            return part[k];
        } else if constexpr (real) {
            return part[k / lanes][k % lanes];
        } else {
            return {part[k / lanes][2 * (k % lanes)], part[k / lanes][2 * (k % lanes) + 1]};
        }
    }
    void set(int k, const Scalar& value) noexcept {
        if constexpr (lanes == 1 && !paired) {
            part[k] = value;
        } else if constexpr (real) {
            part[k / lanes][k % lanes] = value;
        } else {
            part[k / lanes][2 * (k % lanes)] = value.real();
            part[k / lanes][2 * (k % lanes) + 1] = value.imag();
        }
    }

    FixedColumn& operator+=(const FixedColumn& b) noexcept {
        ANCF_UNROLL_COLUMN
        for (int k = 0; k < parts; ++k) part[k] += b.part[k];
        return *this;
    }

    /// Subtracts the column that starts there times a factor.
    void subtract(const Scalar* first, const Scalar& factor) noexcept {
        const Factor by(factor);
        ANCF_UNROLL_COLUMN
        for (int k = 0; k < parts; ++k) part[k] -= by.times(load(first + k * lanes));
    }

    friend FixedColumn operator*(const FixedColumn& a, const Scalar& factor) noexcept {
        FixedColumn out;
        const Factor by(factor);
        ANCF_UNROLL_COLUMN
        for (int k = 0; k < parts; ++k) out.part[k] = by.times(a.part[k]);
        return out;
    }

    /// Returns a.b, folded to two registers first.
    friend Scalar dot(const FixedColumn& a, const FixedColumn& b) noexcept {
        if constexpr (paired) {
            Part same = a.part[0] * b.part[0], across = a.part[0] * swapped(b.part[0]);
            ANCF_UNROLL_COLUMN
            for (int k = 1; k < parts; ++k) {
                same += a.part[k] * b.part[k];
                across += a.part[k] * swapped(b.part[k]);
            }
            double real_part = 0.0, imaginary = 0.0;
            ANCF_UNROLL_COLUMN
            for (int k = 0; k < doubles; k += 2) {
                real_part += same[k] - same[k + 1];
                imaginary += across[k] + across[k + 1];
            }
            return {real_part, imaginary};
        } else {
            const auto product = [](const Part& x, const Part& y) {
                if constexpr (real)
                    return x * y;
                else
                    return Factor(y).times(x);
            };
            Part sum[2] = {product(a.part[0], b.part[0]),
                           parts > 1 ? product(a.part[1 % parts], b.part[1 % parts]) : Part{}};
            ANCF_UNROLL_COLUMN
            for (int k = 2; k < parts; ++k) sum[k % 2] += product(a.part[k], b.part[k]);
            const Part both = sum[0] + sum[1];
            if constexpr (lanes == 1) {
                return both;
            } else {
                Scalar total = both[0];
                ANCF_UNROLL_COLUMN
                for (int k = 1; k < lanes; ++k) total += both[k];
                return total;
            }
        }
    }

private:
    using Lanes = std::make_index_sequence<static_cast<std::size_t>(doubles)>;

    static Part swapped(const Part& a) noexcept { return swapped_pairs(a, Lanes()); }

    // What a column is multiplied by. Of complex numbers by its parts: the compiler's own product
    // looks for infinities.
    struct Factor {
        struct Pair {
            Part real, imaginary;
        };
        std::conditional_t<paired, Pair, Scalar> value;

        explicit Factor(const Scalar& b) noexcept : value(of(b)) {}
        static auto of(const Scalar& b) noexcept {
            if constexpr (paired)
                return Pair{broadcast<doubles>(b.real()), alternating<Part>(b.imag(), Lanes())};
            else
                return b;
        }
        [[nodiscard]] Part times(const Part& a) const noexcept {
            if constexpr (real)
                return a * value;
            else if constexpr (paired)
                return a * value.real + swapped(a) * value.imaginary;
            else
                return detail::product(a, value);
        }
    };
    static Part load(const Scalar* first) noexcept {
        Part out;
        std::memcpy(&out, first, sizeof out);
        return out;
    }
};

}  // namespace ancf::detail
