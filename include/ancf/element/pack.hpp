// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A pack of doubles that behaves as one scalar: kernels evaluate several stations or elements at
/// once.
///
/// On GCC and Clang it is made of vectors of the compiler's own, as wide as the target's registers;
/// elsewhere of doubles. Lanes never mix: each holds what a double would.

#pragma once

#include <ancf/compiler.hpp>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#if defined(__GNUC__) && defined(__AVX__)
#include <immintrin.h>
#elif defined(__GNUC__) && defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace ancf {

/// How many doubles a register of the target holds: the best number of elements side by side.
inline constexpr int register_lanes = ANCF_REGISTER_LANES;

/// How many stations of one element stand side by side: rules have few more than four.
inline constexpr int native_lanes = register_lanes < 4 ? register_lanes : 4;

/// How many equal elements are worth evaluating at once. Registers of two lanes gain nothing over
/// the stations of one element side by side, and cost a second instantiation.
inline constexpr int wide_lanes = register_lanes < 4 ? 1 : register_lanes;

namespace detail {

template <int Lanes, bool Fits = (Lanes <= register_lanes)>
struct PackStorage;

template <>
struct PackStorage<1, true> {
    using type = double;
};

#if defined(__GNUC__)
template <int Lanes>
struct PackStorage<Lanes, true> {
    typedef double type __attribute__((vector_size(Lanes * sizeof(double))));
};
#endif

/// What does not fit a register: two halves.
template <int Lanes>
struct PackPair {
    using Half = typename PackStorage<Lanes / 2>::type;
    Half low, high;

    friend PackPair operator+(const PackPair& a, const PackPair& b) noexcept {
        return {a.low + b.low, a.high + b.high};
    }
    friend PackPair operator-(const PackPair& a, const PackPair& b) noexcept {
        return {a.low - b.low, a.high - b.high};
    }
    friend PackPair operator*(const PackPair& a, const PackPair& b) noexcept {
        return {a.low * b.low, a.high * b.high};
    }
    friend PackPair operator/(const PackPair& a, const PackPair& b) noexcept {
        return {a.low / b.low, a.high / b.high};
    }
    friend PackPair operator-(const PackPair& a) noexcept { return {-a.low, -a.high}; }
};

template <int Lanes>
struct PackStorage<Lanes, false> {
    using type = PackPair<Lanes>;
};

template <int Lanes>
using PackType = typename PackStorage<Lanes>::type;

template <int Lanes>
inline double lane(const PackType<Lanes>& v, int k) noexcept {
    if constexpr (Lanes == 1) {
        return v;
    } else if constexpr (Lanes <= register_lanes) {
        return v[k];
    } else {
        return k < Lanes / 2 ? lane<Lanes / 2>(v.low, k) : lane<Lanes / 2>(v.high, k - Lanes / 2);
    }
}

template <int Lanes>
inline void set_lane(PackType<Lanes>& v, int k, double value) noexcept {
    if constexpr (Lanes == 1) {
        v = value;
    } else if constexpr (Lanes <= register_lanes) {
        v[k] = value;
    } else if (k < Lanes / 2) {
        set_lane<Lanes / 2>(v.low, k, value);
    } else {
        set_lane<Lanes / 2>(v.high, k - Lanes / 2, value);
    }
}

template <class Vector, std::size_t... K>
inline Vector broadcast_vector(double value, std::index_sequence<K...>) noexcept {
    return Vector{(static_cast<void>(K), value)...};
}

template <int Lanes>
inline PackType<Lanes> broadcast(double value) noexcept {
    if constexpr (Lanes == 1) {
        return value;
    } else if constexpr (Lanes <= register_lanes) {
        return broadcast_vector<PackType<Lanes>>(value, std::make_index_sequence<Lanes>());
    } else {
        return {broadcast<Lanes / 2>(value), broadcast<Lanes / 2>(value)};
    }
}

/// The compiler's vectors have no square root of their own, and one per lane would set errno in
/// each.
template <int Lanes>
inline PackType<Lanes> square_root(const PackType<Lanes>& v) noexcept {
    using Type = PackType<Lanes>;
    if constexpr (Lanes == 1) {
        return std::sqrt(v);
    } else if constexpr (Lanes > register_lanes) {
        return {square_root<Lanes / 2>(v.low), square_root<Lanes / 2>(v.high)};
    } else {
#if defined(__GNUC__) && defined(__AVX512F__)
        // masked by all lanes: the plain form trips GCC 12 over an uninitialised operand
        if constexpr (Lanes == 8) return _mm512_maskz_sqrt_pd(0xFF, v);
#endif
#if defined(__GNUC__) && defined(__AVX__)
        if constexpr (Lanes == 4) return _mm256_sqrt_pd(v);
#endif
#if defined(__GNUC__) && defined(__SSE2__)
        if constexpr (Lanes == 2) return _mm_sqrt_pd(v);
#endif
        Type root = v;
        for (int k = 0; k < Lanes; ++k) set_lane<Lanes>(root, k, std::sqrt(lane<Lanes>(v, k)));
        return root;
    }
}

}  // namespace detail

/// Doubles side by side.
/// @tparam Lanes  1, 2, 4 or 8
template <int Lanes>
class Pack {
    static_assert(Lanes == 1 || Lanes == 2 || Lanes == 4 || Lanes == 8,
                  "a pack has 1, 2, 4 or 8 lanes");

public:
    static constexpr int lanes = Lanes;  ///< how many numbers it holds

    Pack() = default;
    /// The same value in every lane.
    Pack(double value) noexcept
        : v_(detail::broadcast<Lanes>(value)) {}  // NOLINT: meant for every lane

    /// Returns the value of a lane.
    [[nodiscard]] double operator[](int k) const noexcept { return detail::lane<Lanes>(v_, k); }
    /// Sets the value of a lane.
    void set(int k, double value) noexcept { detail::set_lane<Lanes>(v_, k, value); }

    /// @{
    /// Lane by lane.
    friend Pack operator+(const Pack& a, const Pack& b) noexcept {
        return Pack(Stored{a.v_ + b.v_});
    }
    friend Pack operator-(const Pack& a, const Pack& b) noexcept {
        return Pack(Stored{a.v_ - b.v_});
    }
    friend Pack operator*(const Pack& a, const Pack& b) noexcept {
        return Pack(Stored{a.v_ * b.v_});
    }
    friend Pack operator/(const Pack& a, const Pack& b) noexcept {
        return Pack(Stored{a.v_ / b.v_});
    }
    friend Pack operator-(const Pack& a) noexcept { return Pack(Stored{-a.v_}); }
    Pack& operator+=(const Pack& b) noexcept { return *this = *this + b; }
    Pack& operator-=(const Pack& b) noexcept { return *this = *this - b; }
    Pack& operator*=(const Pack& b) noexcept { return *this = *this * b; }
    Pack& operator/=(const Pack& b) noexcept { return *this = *this / b; }
    /// @}

    /// Returns the square root of every lane.
    friend Pack sqrt(const Pack& a) noexcept {
        return Pack(Stored{detail::square_root<Lanes>(a.v_)});
    }

private:
    // Keeps a storage of one lane apart from a double.
    struct Stored {
        detail::PackType<Lanes> v;
    };
    explicit Pack(const Stored& stored) noexcept : v_(stored.v) {}

    detail::PackType<Lanes> v_;
};

namespace detail {

template <class S, int Cost>
struct ScalarTraits;

template <int Lanes, class Function>
[[nodiscard]] inline Pack<Lanes> lane_by_lane(const Pack<Lanes>& a, Function function) noexcept {
    Pack<Lanes> result;
    for (int k = 0; k < Lanes; ++k) result.set(k, function(a[k]));
    return result;
}

}  // namespace detail

/// Return the cosine, the sine and the arc tangent of every lane.
template <int Lanes>
[[nodiscard]] inline Pack<Lanes> cos(const Pack<Lanes>& a) noexcept {
    return detail::lane_by_lane(a, [](double x) { return std::cos(x); });
}
/// Lane by lane.
template <int Lanes>
[[nodiscard]] inline Pack<Lanes> sin(const Pack<Lanes>& a) noexcept {
    return detail::lane_by_lane(a, [](double x) { return std::sin(x); });
}
/// Lane by lane.
template <int Lanes>
[[nodiscard]] inline Pack<Lanes> atan(const Pack<Lanes>& a) noexcept {
    return detail::lane_by_lane(a, [](double x) { return std::atan(x); });
}

/// Returns the sum of all lanes.
template <int Lanes>
[[nodiscard]] inline double lane_sum(const Pack<Lanes>& a) noexcept {
    if constexpr (Lanes == 1) {
        return a[0];
    } else {
        double sum = a[0] + a[1];
        for (int k = 2; k < Lanes; k += 2) sum += a[k] + a[k + 1];
        return sum;
    }
}

/// Returns a as the scalar S: itself, or the sum of its lanes where S is a double and they are
/// parts of one number.
template <class S, class P>
[[nodiscard]] inline S collapsed(const P& a) noexcept {
    if constexpr (std::is_same_v<S, P>) {
        return a;
    } else {
        return lane_sum(a);
    }
}

}  // namespace ancf

/// @cond
/// What Eigen asks of a scalar of the library's own, so many times as dear as a double to add.
template <class S, int Cost>
struct ancf::detail::ScalarTraits : Eigen::GenericNumTraits<S> {
    using Real = S;
    using NonInteger = S;
    using Nested = S;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = Cost > 1,
        ReadCost = Cost,
        AddCost = Cost,
        MulCost = Cost * Cost
    };
};
template <int Lanes>
struct Eigen::NumTraits<ancf::Pack<Lanes>> : ancf::detail::ScalarTraits<ancf::Pack<Lanes>, 1> {};
/// @endcond
