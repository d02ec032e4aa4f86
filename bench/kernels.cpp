// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Time of one element: force alone, and energy, force and tangent together.
///
/// For each element, rule and number of elements side by side (lanes) the least time over many
/// short runs; operations as counted by a scalar that counts; and the share of the peak that the
/// core reaches in a loop of fused multiply-adds. kernels is compiled for this machine,
/// kernels_baseline is the same source at plain -O2.
///
///     kernels --csv > kernels.csv
///
/// With --damping it is KelvinVoigt's force with both derivatives, of single elements alone, in
/// place of energy, force and tangent; operations are not counted.

#include <CLI/CLI.hpp>

#include <kernels/measure.hpp>
#include <peak.hpp>

#include <cstdio>

int main(int argc, char** argv) {
    using namespace ancf::bench;
    kernels::Settings settings;
    CLI::App app("Time of one element: force, and energy, force and tangent");
    app.add_flag("--csv", settings.csv, "comma-separated values");
    app.add_flag("--damping", settings.damping, "KelvinVoigt with its derivatives instead");
    app.add_option("--repeats", settings.repeats, "runs of which the fastest counts")
        ->check(CLI::PositiveNumber);
    app.add_option("--element", settings.only, "one element alone");
    CLI11_PARSE(app, argc, argv);

    settings.peak = peak_rate();
    std::fprintf(stderr, "peak of one core: %.1f GFlop/s\n", settings.peak * 1e-9);
    std::printf(settings.csv ? "%s,%s,%s,%s,%s,%s,%s\n" : "%-22s %-9s %5s  %-5s %9s %8s %8s\n",
                "element", "rule", "lanes", "what", "ns_per_element", "flops", "peak_fraction");
    kernels::cross_section(settings);
    kernels::transported(settings);
    kernels::geodesic(settings);
    kernels::quintic(settings);
    kernels::continuum(settings);
    kernels::torsion(settings);
    kernels::cable(settings);
    kernels::planar(settings);
    kernels::planar_continuum(settings);
    kernels::planar_cable(settings);
    return 0;
}
