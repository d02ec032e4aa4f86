// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The compiler extensions that kernels need, and how functions of files of definitions are marked.

#pragma once

// Numbers that are not finite end a run. Where the compiler takes every number for finite they
// would pass as results, or a run would never end.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "ancf: add -fno-finite-math-only: -ffast-math and -Ofast hide numbers that are not finite"
#endif

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

/// Marks each function that a file of definitions (*.ipp) defines and that is no template:
/// `inline`, or nothing in a unit of the compiled library.
///
/// Headers include their definitions at their end. A unit that uses the compiled library defines
/// ANCF_COMPILED, and they leave them out. A unit of that library defines ANCF_SOURCE, which
/// implies ANCF_COMPILED, and includes the files of definitions that it holds.
#if defined(ANCF_SOURCE)
#define ANCF_INLINE
#if !defined(ANCF_COMPILED)
#define ANCF_COMPILED
#endif
#else
#define ANCF_INLINE inline
#endif

/// Marks functions and constructors, declared and defined, whose definitions are heavy: a unit that
/// includes them and does not call them does not compile what they call. A template without
/// arguments, or a plain function with the compiled library.
#if defined(ANCF_COMPILED)
#define ANCF_LAZY
#else
#define ANCF_LAZY template <int...>
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

/// Marks virtual functions in their class where a file of definitions defines them: `inline`, or
/// nothing with the compiled library. Without it g++ would emit the class in every unit that
/// includes its header, used or not, as the ABI has it for the first function that is not inline.
#if defined(ANCF_COMPILED)
#define ANCF_INLINE_VIRTUAL
#else
#define ANCF_INLINE_VIRTUAL inline
#endif
