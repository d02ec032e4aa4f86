// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The compiler extensions that kernels need, and how functions of files of definitions are marked.

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

/// Marks each function that a file of definitions (*.ipp) defines and that is no template: `inline`
/// where headers include their definitions, nothing where these are compiled once.
///
/// A unit of the compiled library defines ANCF_SOURCE and includes files of definitions; one that
/// uses the library defines ANCF_COMPILED, and headers leave them out. A virtual function has the
/// mark where its class declares it as well: g++ would otherwise emit the class in every unit.
#if defined(ANCF_SOURCE) || defined(ANCF_COMPILED)
#define ANCF_INLINE
#else
#define ANCF_INLINE inline
#endif
