// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How the kernels of one element are timed and counted. Each element has a unit of its own: with
/// counting scalars and packs of four and eight one takes as long to compile as a small library.

#pragma once

#include <ancf/element/quadrature.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/types.hpp>

#include <benchmark/benchmark.h>

#include <counting.hpp>
#include <peak.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace ancf::bench::kernels {

struct Settings {
    bool csv = false;
    bool damping = false;
    int repeats = 400;
    std::string only;
    double peak = 0.0;
};

/// A bent, twisted and sheared state of an element of length 1.
template <class Element>
typename Element::Coordinates bent_state() {
    constexpr double vectors[2][4][3] = {
        {{0.1, -0.2, 0.3}, {0.9, 0.1, -0.1}, {-0.05, 1.02, 0.03}, {0.02, 0.01, 0.97}},
        {{1.0, 0.1, 0.25}, {0.8, 0.5, -0.2}, {-0.5, 0.9, 0.1}, {0.1, -0.2, 1.05}}};
    constexpr Field fields[4] = {Field::r, Field::r_x, Field::r_y, Field::r_z};
    typename Element::Coordinates e;
    int at = 0;
    for (const auto& node : vectors)
        for (int k = 0; k < 4; ++k)
            if (Element::fields.contains(fields[k]))
                for (int i = 0; i < Element::dimension; ++i) e[at++] = node[k][i];
    return e;
}

/// Returns nanoseconds of one call: the least of many runs of a few microseconds to tens of them.
template <class Call>
double nanoseconds(const Call& call, int repeats) {
    constexpr int calls = 20;
    double best = 1e9;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const double start = detail::now();
        for (int k = 0; k < calls; ++k) call();
        best = std::min(best, detail::now() - start);
    }
    return best / calls * 1e9;
}

inline void report(const Settings& settings, const char* element, const std::string& rule,
                   int lanes, const char* what, double time, long flops) {
    const double fraction = static_cast<double>(flops) / (time * 1e-9) / settings.peak;
    std::printf(
        settings.csv ? "%s,%s,%d,%s,%.1f,%ld,%.4f\n" : "%-22s %-9s %5d  %-5s %9.1f %8ld %8.3f\n",
        element, rule.c_str(), lanes, what, time, flops, fraction);
    std::fflush(stdout);
}

template <class S, class Element>
void measure(const Settings& settings, const char* name, const std::string& rule,
             const Element& element, int lanes, long force_flops, long all_flops) {
    Vector<S, Element::dofs> e = bent_state<Element>().template cast<S>();
    const auto touch = [&e] { e(0) += S(1e-13); };  // no call is like the one before
    const double force = nanoseconds(
        [&] {
            touch();
            auto result = element.force(e);
            benchmark::DoNotOptimize(result.data());
            benchmark::ClobberMemory();
        },
        settings.repeats);
    report(settings, name, rule, lanes, "force", force / lanes, force_flops);
    const double all = nanoseconds(
        [&] {
            touch();
            auto evaluation = element.evaluate(e);
            benchmark::DoNotOptimize(&evaluation);
            benchmark::ClobberMemory();
        },
        settings.repeats);
    report(settings, name, rule, lanes, "all", all / lanes, all_flops);
}

/// Measures a damper's force with both derivatives.
template <class Element>
void measure_damping(const Settings& settings, const char* name, const std::string& rule,
                     const Element& element) {
    constexpr int n = Element::dofs;
    const KelvinVoigt<Element> damper(std::make_shared<const Element>(element), {}, 1e-3);
    LoadState state{bent_state<Element>(), VectorX::LinSpaced(n, -1.0, 1.0), 0.0};
    LoadResult out{VectorX::Zero(n), MatrixX::Zero(n, n), MatrixX::Zero(n, n), 0.0};
    const double time = nanoseconds(
        [&] {
            state.q[0] += 1e-13;
            damper.evaluate(state, out);
            benchmark::ClobberMemory();
        },
        settings.repeats);
    report(settings, name, rule, 1, "damp", time, 0);
}

/// Measures single elements and, where asked for, packs of four and eight.
template <class Element, bool Packs = true>
void run(const Settings& settings, const char* name, const std::vector<Rule>& rules) {
    if (!settings.only.empty() && settings.only != name) return;
    const Material material = Material::isotropic(2.07e11, 0.3, 7850.0);
    const bool cable = !Element::fields.contains(Field::r_y);  // bends equally in all directions
    const Section section = cable ? circle(0.1) : rectangle(0.1, 0.2);
    for (const Rule& rule : rules) {
        const Element element(material, section, 1.0, {rule});
        if (settings.damping) {
            measure_damping(settings, name, rule.name(), element);
            continue;
        }
        const Vector<Counting, Element::dofs> e = bent_state<Element>().template cast<Counting>();
        Counting::reset();
        benchmark::DoNotOptimize(element.force(e)(3).value());
        const long force = Counting::operations();
        Counting::reset();
        benchmark::DoNotOptimize(element.evaluate(e).tangent(3, 4).value());
        const long all = Counting::operations();
        measure<double>(settings, name, rule.name(), element, 1, force, all);
        if constexpr (Packs) {
            measure<Pack<4>>(settings, name, rule.name(), element, 4, force, all);
            measure<Pack<8>>(settings, name, rule.name(), element, 8, force, all);
        }
    }
}

// Elements --------------------------------------------------------------------------------------

void cross_section(const Settings& settings);
void transported(const Settings& settings);
void geodesic(const Settings& settings);
void quintic(const Settings& settings);
void continuum(const Settings& settings);
void torsion(const Settings& settings);
void planar(const Settings& settings);
void planar_continuum(const Settings& settings);
void cable(const Settings& settings);
void planar_cable(const Settings& settings);

}  // namespace ancf::bench::kernels
