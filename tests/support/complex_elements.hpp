// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Energy and force of complex coordinates, compiled once for tests that step into the complex
/// plane with several elements.

#pragma once

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/compiled_element.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/types.hpp>

#include <complex>

/// Declares (`extern`) or defines (nothing) energy and force of complex coordinates.
#define ANCF_COMPLEX_INSTANCE(linkage, ...)                                                       \
    linkage template std::complex<double> detail::Evaluator<__VA_ARGS__>::energy(                 \
        const Vector<std::complex<double>, __VA_ARGS__::dofs>&) const noexcept;                   \
    linkage template Vector<std::complex<double>, __VA_ARGS__::dofs>                              \
    detail::Evaluator<__VA_ARGS__>::force(const Vector<std::complex<double>, __VA_ARGS__::dofs>&) \
        const noexcept

namespace ancf {

ANCF_COMPLEX_INSTANCE(extern, CrossSectionBeam<3>);
ANCF_COMPLEX_INSTANCE(extern, CrossSectionBeam<3, Geodesic>);
ANCF_COMPLEX_INSTANCE(extern, CrossSectionBeam<3, Projected, PointwiseShear>);
ANCF_COMPLEX_INSTANCE(extern, CrossSectionBeam<2>);
ANCF_COMPLEX_INSTANCE(extern, ContinuumBeam<3>);
ANCF_COMPLEX_INSTANCE(extern, ContinuumBeam<2>);
ANCF_COMPLEX_INSTANCE(extern, TorsionBeam);
ANCF_COMPLEX_INSTANCE(extern, Cable<3>);

}  // namespace ancf
