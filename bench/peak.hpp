// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How many floating-point operations one core can do, fused multiply-adds on registers alone, and
/// how long a call takes.

#pragma once

#include <ancf/element/pack.hpp>

#include <algorithm>
#include <chrono>

#if defined(__GNUC__) && defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ancf::bench {

namespace detail {

/// Seconds since some time in the past.
inline double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

inline constexpr int chains = 12;  ///< independent sums: as many as hide the latency of two units
inline constexpr int steps = 4000;

/// Multiplies and adds in what the translation unit's own flags allow.
inline double plain_chains(double seed) {
    using Wide = Pack<register_lanes>;
    Wide sum[chains];
    for (int k = 0; k < chains; ++k) sum[k] = Wide(seed + k);
    const Wide factor(1.0 - 1e-9), shift(1e-9);
    for (int step = 0; step < steps; ++step) {
        for (int k = 0; k < chains; ++k) sum[k] = sum[k] * factor + shift;
    }
    Wide total(0.0);
    for (const Wide& each : sum) total += each;
    return lane_sum(total);
}

#if defined(__GNUC__) && defined(__x86_64__)

// The machine's best, whatever the flags: one function per instruction set, written out so that
// sums stay in registers.
#define ANCF_BENCH_CHAINS(TARGET, TYPE, SET, FMA, ADD, SUM)                                  \
    __attribute__((target(TARGET))) inline double SUM(double seed) {                         \
        TYPE a = SET(seed), b = SET(seed + 1), c = SET(seed + 2), d = SET(seed + 3);         \
        TYPE e = SET(seed + 4), f = SET(seed + 5), g = SET(seed + 6), h = SET(seed + 7);     \
        TYPE i = SET(seed + 8), j = SET(seed + 9), k = SET(seed + 10), l = SET(seed + 11);   \
        const TYPE factor = SET(1.0 - 1e-9), shift = SET(1e-9);                              \
        for (int step = 0; step < steps; ++step) {                                           \
            a = FMA(a, factor, shift), b = FMA(b, factor, shift), c = FMA(c, factor, shift); \
            d = FMA(d, factor, shift), e = FMA(e, factor, shift), f = FMA(f, factor, shift); \
            g = FMA(g, factor, shift), h = FMA(h, factor, shift), i = FMA(i, factor, shift); \
            j = FMA(j, factor, shift), k = FMA(k, factor, shift), l = FMA(l, factor, shift); \
        }                                                                                    \
        const TYPE sum = ADD(ADD(ADD(a, b), ADD(c, d)), ADD(ADD(e, f), ADD(g, h)));          \
        const TYPE all = ADD(sum, ADD(ADD(i, j), ADD(k, l)));                                \
        return reinterpret_cast<const double*>(&all)[0];                                     \
    }

ANCF_BENCH_CHAINS("avx2,fma", __m256d, _mm256_set1_pd, _mm256_fmadd_pd, _mm256_add_pd, avx2_chains)
ANCF_BENCH_CHAINS("avx512f", __m512d, _mm512_set1_pd, _mm512_fmadd_pd, _mm512_add_pd, avx512_chains)
#undef ANCF_BENCH_CHAINS

#endif

/// Returns operations per second of a loop of `chains` sums of `lanes` doubles: two operations
/// each.
template <class Function>
double rate(Function function, int lanes) {
    double best = 1e9;
    volatile double sink = 0.0;
    for (int repeat = 0; repeat < 400; ++repeat) {
        const double start = now();
        sink = function(1.0 + repeat);
        best = std::min(best, now() - start);
    }
    (void)sink;
    return 2.0 * chains * steps * lanes / best;
}

}  // namespace detail

/// Returns the measured peak of one core, operations per second.
inline double peak_rate() {
    double best = detail::rate(detail::plain_chains, register_lanes);
#if defined(__GNUC__) && defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        best = std::max(best, detail::rate(detail::avx2_chains, 4));
    }
    if (__builtin_cpu_supports("avx512f"))
        best = std::max(best, detail::rate(detail::avx512_chains, 8));
#endif
    return best;
}

/// Returns nanoseconds of one call: the least of many runs.
template <class Call>
double nanoseconds(const Call& call, int calls, int repeats) {
    double best = 1e9;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const double start = detail::now();
        for (int k = 0; k < calls; ++k) call();
        best = std::min(best, detail::now() - start);
    }
    return best / calls * 1e9;
}

}  // namespace ancf::bench
