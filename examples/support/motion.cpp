// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>

#include <support/files.hpp>
#include <support/motion.hpp>
#include <support/report.hpp>

#include <ostream>

namespace examples {

MotionOptions::MotionOptions(double for_seconds, double output_interval)
    : integrator(ANCF_WITH_SUNDIALS ? "ida-index3" : "generalized-alpha"),
      duration(for_seconds),
      interval(output_interval) {}

void MotionOptions::add_to(CommandLine& line) {
    line.set_group("Integration");
    line.add_choice("--integrator", integrator,
                    {"ida-index3", "ida-ggl", "explicit", "generalized-alpha", "leapfrog", "radau",
                     "radau9", "energy"},
                    "integrator");
    line.add_number("--tolerance", tolerance, Range::positive,
                    "relative, of IDA, Radau and the explicit method");
    line.add_number("--step", step, Range::positive, "of the other integrators, s");
    line.add_number("--rho", rho, Range::finite,
                    "of generalized-alpha: spectral radius at infinity, from 0 to 1");
    line.add_number("--duration", duration, Range::positive, "s");
    line.add_flag("--pass-degenerate", pass_degenerate, "go on where an element is no beam");
    line.set_group("Output");
    line.add_number("--output-interval", interval, Range::positive, "s");
    line.add_file("--save", save, "state file to write at the end");
    line.add_file("--restart", restart, "state file to go on from");
}

void MotionOptions::check(const CommandLine& line) const {
    const std::string other = "--integrator " + integrator;
    line.note_unused(by_tolerance() ? "--step" : "--tolerance", other);
    if (integrator != "generalized-alpha") line.note_unused("--rho", other);
    ancf::detail::require(rho >= 0.0 && rho <= 1.0, "--rho: expected a number from 0 to 1, got ",
                          rho);
    ancf::detail::require(tolerance >= 1e-14 && tolerance < 1.0,
                          "--tolerance: expected a number from 1e-14 to 1, got ", tolerance);
    ancf::detail::require(ANCF_WITH_SUNDIALS || !by_sundials(), "--integrator ", integrator,
                          " needs SUNDIALS, and this program was built without it");
    require_countable("--output-interval", interval, duration);
    if (!save.empty()) require_writable(save);
}

void require_countable(const std::string& option, double interval, double duration) {
    constexpr double most = 1e7;
    ancf::detail::require(duration / interval <= most, option, ": ", interval,
                          " s is too short for ", duration, " s");
}

void summarise(std::ostream& out, const MotionOptions& options, const Motion& motion) {
    const ancf::DynamicsReport& report = motion.report;
    out << options.integrator << ": " << to_string(report.status) << " at t = " << report.time
        << " s, " << report.steps << " steps (" << report.smallest_step << " to "
        << report.largest_step << " s), " << report.rejected << " rejected, "
        << report.convergence_failures << " convergence failures, " << report.jacobians
        << " Jacobians, " << report.factorisations << " factorisations, " << report.iterations
        << " linear solves, " << fixed(report.seconds, 3) << " s";
    if (!motion.detail.empty()) out << "; " << motion.detail;
    out << "\nbefore projection: constraint " << scientific(report.violation) << " m, its rate "
        << scientific(report.violation_rate) << " m/s; energy drift "
        << scientific(report.energy_drift) << " J, largest kinetic energy "
        << fixed(report.kinetic_largest, 3) << " J\n";
    if (!report.message.empty()) out << report.message << '\n';
}

}  // namespace examples
