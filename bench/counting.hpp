// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A scalar that counts what is done with it.

#pragma once

#include <ancf/compiler.hpp>

#include <Eigen/Core>

#include <cmath>

namespace ancf::bench {

/// A double that counts additions, multiplications, divisions and roots, one each.
class Counting {
public:
    Counting() = default;
    Counting(double value) noexcept : value_(value) {}  // NOLINT: stands for a double

    [[nodiscard]] double value() const noexcept { return value_; }

    static long operations() noexcept { return count; }
    static void reset() noexcept { count = 0; }

    friend Counting operator+(const Counting& a, const Counting& b) noexcept {
        return counted(a.value_ + b.value_);
    }
    friend Counting operator-(const Counting& a, const Counting& b) noexcept {
        return counted(a.value_ - b.value_);
    }
    friend Counting operator*(const Counting& a, const Counting& b) noexcept {
        return counted(a.value_ * b.value_);
    }
    friend Counting operator/(const Counting& a, const Counting& b) noexcept {
        return counted(a.value_ / b.value_);
    }
    friend Counting operator-(const Counting& a) noexcept { return {-a.value_}; }
    Counting& operator+=(const Counting& b) noexcept { return *this = *this + b; }
    Counting& operator-=(const Counting& b) noexcept { return *this = *this - b; }
    Counting& operator*=(const Counting& b) noexcept { return *this = *this * b; }
    Counting& operator/=(const Counting& b) noexcept { return *this = *this / b; }
    friend Counting sqrt(const Counting& a) noexcept { return counted(std::sqrt(a.value_)); }
    friend Counting sin(const Counting& a) noexcept { return counted(std::sin(a.value_)); }
    friend Counting cos(const Counting& a) noexcept { return counted(std::cos(a.value_)); }
    friend Counting atan(const Counting& a) noexcept { return counted(std::atan(a.value_)); }

    /// The cable's question whether a strain pulls.
    friend Counting taut(const Counting& strain) noexcept {
        return {strain.value_ >= 0.0 ? 1.0 : 0.0};
    }

private:
    // Not inlined: millions of increments in a row are slow to compile.
    ANCF_NOINLINE static Counting counted(double value) noexcept {
        ++count;
        return {value};
    }

    inline static long count = 0;
    double value_ = 0.0;
};

}  // namespace ancf::bench

template <>
struct Eigen::NumTraits<ancf::bench::Counting> : Eigen::GenericNumTraits<ancf::bench::Counting> {
    using Real = ancf::bench::Counting;
    using NonInteger = ancf::bench::Counting;
    using Nested = ancf::bench::Counting;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 1,
        AddCost = 1,
        MulCost = 1
    };
};

// Eigen expressions of a double and a count.
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<double, ancf::bench::Counting, Operation> {
    using ReturnType = ancf::bench::Counting;
};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<ancf::bench::Counting, double, Operation> {
    using ReturnType = ancf::bench::Counting;
};
