// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Header-only or compiled: which of the two this unit is, and guards against mixing them.
///
/// A unit that links the CMake target ancf::compiled has ANCF_COMPILED defined. Headers then only
/// declare, and the library holds the definitions and the usual elements. Two mistakes are caught
/// by the linker, whose message names one of the symbols below:
///
/// - `compiled_for_alignment_...`: undefined where a unit has other flags (-march) or another Eigen
///   than the library, so that objects would have another layout in memory.
/// - `compiled_for_matrix_and_list<...>`: undefined where these have another size than in the
///   library, as by _GLIBCXX_DEBUG or EIGEN_DEFAULT_DENSE_INDEX_TYPE.
/// - `header_only_and_compiled_units_do_not_mix`: a mismatch of thread-local storage where one
///   program has units of both kinds.

#pragma once

#include <ancf/compiler.hpp>

#include <Eigen/Core>

#if defined(ANCF_COMPILED)
#include <cstddef>
#include <vector>

/// Helpers of ANCF_LAYOUT.
#define ANCF_PASTE_LAYOUT(heap, fixed, lanes, world, major) \
    compiled_for_alignment_##heap##_##fixed##_lanes_##lanes##_eigen_##world##_##major
/// Helpers of ANCF_LAYOUT.
#define ANCF_LAYOUT_OF(heap, fixed, lanes, world, major) \
    ANCF_PASTE_LAYOUT(heap, fixed, lanes, world, major)
/// The name of the layout that the flags of this unit lead to.
#define ANCF_LAYOUT                                                                          \
    ANCF_LAYOUT_OF(EIGEN_MAX_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES, ANCF_REGISTER_LANES, \
                   EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION)

namespace ancf::detail {

extern const char ANCF_LAYOUT;
extern const char header_only_and_compiled_units_do_not_mix;
/// The library defines the one of its own sizes, in bytes.
template <std::size_t Matrix, std::size_t List>
void compiled_for_matrix_and_list();

#if defined(__GNUC__) && !defined(ANCF_SOURCE)
[[gnu::used]] static const char* const layout_guard[] = {
    &ANCF_LAYOUT, &header_only_and_compiled_units_do_not_mix};
[[gnu::used]] static void (*const size_guard)() =
    &compiled_for_matrix_and_list<sizeof(Eigen::MatrixXd), sizeof(std::vector<int>)>;
#endif

}  // namespace ancf::detail
#elif defined(__GNUC__)
namespace ancf::detail {

[[gnu::used]] inline thread_local char header_only_and_compiled_units_do_not_mix = 0;

}  // namespace ancf::detail
#endif
