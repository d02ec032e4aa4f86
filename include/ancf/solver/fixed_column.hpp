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

#include <cstring>
#include <type_traits>

#if defined(__GNUC__) && !defined(__clang__)
#define ANCF_UNROLL_COLUMN _Pragma("GCC unroll 16")
#else
#define ANCF_UNROLL_COLUMN
#endif

namespace ancf::detail {

/// Returns how many of N doubles stand in one register.
constexpr int column_lanes(int n, int lanes = register_lanes) {
    return n % lanes == 0 ? lanes : column_lanes(n, lanes / 2);
}

/// A column of N scalars, double or complex.
template <class Scalar, int N>
struct FixedColumn {
    static constexpr int lanes = std::is_same_v<Scalar, double> ? column_lanes(N) : 1;
    static constexpr int parts = N / lanes;
    using Part = std::conditional_t<std::is_same_v<Scalar, double>, PackType<lanes>, Scalar>;

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
        for (int k = 0; k < parts; ++k) std::memcpy(first + k * lanes, &part[k], sizeof(Part));
    }

    Scalar& operator[](int k) noexcept { return reinterpret_cast<Scalar*>(part)[k]; }
    const Scalar& operator[](int k) const noexcept {
        return reinterpret_cast<const Scalar*>(part)[k];
    }

    FixedColumn& operator+=(const FixedColumn& b) noexcept {
        ANCF_UNROLL_COLUMN
        for (int k = 0; k < parts; ++k) part[k] += b.part[k];
        return *this;
    }

    /// Subtracts the column that starts there times a factor.
    void subtract(const Scalar* first, const Scalar& factor) noexcept {
        ANCF_UNROLL_COLUMN
        for (int k = 0; k < parts; ++k) part[k] -= times(load(first + k * lanes), factor);
    }

    friend FixedColumn operator*(const FixedColumn& a, const Scalar& factor) noexcept {
        FixedColumn out;
        ANCF_UNROLL_COLUMN
        for (int k = 0; k < parts; ++k) out.part[k] = times(a.part[k], factor);
        return out;
    }

    /// Returns a.b, folded to two registers first.
    friend Scalar dot(const FixedColumn& a, const FixedColumn& b) noexcept {
        Part sum[2] = {times(a.part[0], b.part[0]),
                       parts > 1 ? times(a.part[1 % parts], b.part[1 % parts]) : Part{}};
        ANCF_UNROLL_COLUMN
        for (int k = 2; k < parts; ++k) sum[k % 2] += times(a.part[k], b.part[k]);
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

private:
    // Of complex numbers by its parts: the compiler's own product looks for infinities.
    template <class Factor>
    static Part times(const Part& a, const Factor& b) noexcept {
        if constexpr (std::is_same_v<Scalar, double>)
            return a * b;
        else
            return {a.real() * b.real() - a.imag() * b.imag(),
                    a.real() * b.imag() + a.imag() * b.real()};
    }
    static Part load(const Scalar* first) noexcept {
        Part out;
        std::memcpy(&out, first, sizeof out);
        return out;
    }
};

}  // namespace ancf::detail
