// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How the kernels of one element are timed and counted. Each element has a unit of its own and one
/// for its damping; those that take much memory to compile have one for packs of four and eight.

#pragma once

#include <ancf/element/quadrature.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/types.hpp>

#include <benchmark/benchmark.h>

#include <counting.hpp>
#include <peak.hpp>

#include <cstdio>
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

constexpr int calls = 20;  // of a run: a few microseconds to tens of them

/// What is measured: an element under a rule, and its operations as counted.
struct Subject {
    const Settings& settings;
    const char* element;
    std::string rule;
    long force_flops, all_flops;
};

inline void report(const Subject& subject, int lanes, const char* what, double time, long flops) {
    const double fraction = static_cast<double>(flops) / (time * 1e-9) / subject.settings.peak;
    std::printf(subject.settings.csv ? "%s,%s,%d,%s,%.1f,%ld,%.4f\n"
                                     : "%-22s %-9s %5d  %-5s %9.1f %8ld %8.3f\n",
                subject.element, subject.rule.c_str(), lanes, what, time, flops, fraction);
    std::fflush(stdout);
}

/// Measures as many elements at once as S has lanes.
template <class S, class Element>
void measure(const Subject& subject, const Element& element) {
    constexpr int lanes = sizeof(S) / sizeof(double);
    Vector<S, Element::dofs> e = bent_state<Element>().template cast<S>();
    const auto touch = [&e] { e(0) += S(1e-13); };  // no call is like the one before
    const double force = nanoseconds(
        [&] {
            touch();
            auto result = element.force(e);
            benchmark::DoNotOptimize(result.data());
            benchmark::ClobberMemory();
        },
        calls, subject.settings.repeats);
    report(subject, lanes, "force", force / lanes, subject.force_flops);
    const double all = nanoseconds(
        [&] {
            touch();
            auto evaluation = element.evaluate(e);
            benchmark::DoNotOptimize(&evaluation);
            benchmark::ClobberMemory();
        },
        calls, subject.settings.repeats);
    report(subject, lanes, "all", all / lanes, subject.all_flops);
}

/// Measures a damper's force with both derivatives. Defined in damping.hpp, instantiated in units
/// of their own.
template <class Element>
void measure_damping(const Subject& subject, const Element& element);

/// Measures single elements and, where asked for, packs of four and eight.
template <class Element, bool Packs = true>
void run(const Settings& settings, const char* name, const std::vector<Rule>& rules) {
    if (!settings.only.empty() && settings.only != name) return;
    const Material material = Material::isotropic(2.07e11, 0.3, 7850.0);
    const bool cable = !Element::fields.contains(Field::r_y);  // bends equally in all directions
    const Section section = cable ? circle(0.1) : rectangle(0.1, 0.2);
    for (const Rule& rule : rules) {
        const Element element(material, section, 1.0, {rule});
        Subject subject{settings, name, rule.name(), 0, 0};
        if (settings.damping) {
            measure_damping(subject, element);
            continue;
        }
        const Vector<Counting, Element::dofs> e = bent_state<Element>().template cast<Counting>();
        Counting::reset();
        benchmark::DoNotOptimize(element.force(e)(3).value());
        subject.force_flops = Counting::operations();
        Counting::reset();
        benchmark::DoNotOptimize(element.evaluate(e).tangent(3, 4).value());
        subject.all_flops = Counting::operations();
        measure<double>(subject, element);
        if constexpr (Packs) {
            measure<Pack<4>>(subject, element);
            measure<Pack<8>>(subject, element);
        }
    }
}

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
