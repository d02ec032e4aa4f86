// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Evaluations of elements take nothing from the heap.

#include <ancf/compiler.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/pack.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};

}  // namespace

// The whole program counts; over-aligned allocations come from the default operators. Inlined, they
// would look mismatched to the compiler.
ANCF_NOINLINE void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}

ANCF_NOINLINE void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}

ANCF_NOINLINE void operator delete(void* memory) noexcept { std::free(memory); }
ANCF_NOINLINE void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

TEMPLATE_TEST_CASE("CrossSectionBeam: evaluation does not allocate", "[element][cross-section]",
                   ancf::test::Paper, ancf::test::Pointwise, ancf::test::Carried) {
    using namespace ancf;
    const auto element = test::element_of<TestType>(test::variants[0]);
    test::Random random(1);
    const auto e = test::random_state(element, random);
    const Vector<Pack<4>, 24> lanes = e.template cast<Pack<4>>();
    const long before = allocations;
    const double energy = element.energy(e);
    const auto force = element.force(e);
    const auto evaluation = element.evaluate(e);
    const auto packed = element.evaluate(lanes);
    const bool admissible = element.admissible(e);
    const auto forces = element.section_forces(e, 0.5);
    const long after = allocations;
    CHECK(after == before);
    CHECK(before > 0);  // the counter counts
    CHECK(admissible);
    CHECK(energy == Approx(evaluation.energy));
    CHECK(force.norm() == Approx(evaluation.force.norm()));
    CHECK(packed.energy[3] == Approx(energy));
    CHECK(forces.axial != 0.0);
}
