// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The compiler extensions that kernels need.

#pragma once

/// Keeps a stage of a kernel a function of its own: costs nothing at run time, and inlining the
/// stages into each other is what makes translation units slow to compile.
#if defined(__GNUC__)
#define ANCF_NOINLINE __attribute__((noinline))
#else
#define ANCF_NOINLINE
#endif

/// Unrolls the loop that follows, which g++ does by itself at -O3 only.
#if defined(__GNUC__) && !defined(__clang__)
#define ANCF_UNROLL _Pragma("GCC unroll 8")
#else
#define ANCF_UNROLL
#endif

/// Before the definition of a function in a file *.ipp: inline where headers bring the definitions,
/// nothing in a unit of the compiled library.
#if defined(ANCF_SOURCE)
#define ANCF_INLINE
#else
#define ANCF_INLINE inline
#endif

/// How many doubles a register of the target holds.
#if defined(__GNUC__) && defined(__AVX512F__)
#define ANCF_REGISTER_LANES 8
#elif defined(__GNUC__) && defined(__AVX__)
#define ANCF_REGISTER_LANES 4
#elif defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
#define ANCF_REGISTER_LANES 2
#else
#define ANCF_REGISTER_LANES 1
#endif
