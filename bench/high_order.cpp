// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Radau IIA beside the other integrators at equal error, on pendulums of one mesh.
///
/// The rubber pendulum of [Dufva2006, section 5.1], in the plane and in space, a hundred and ten
/// thousand times as stiff, and on a massless link of 0.4 m. The error is the largest distance of
/// the tip from a reference at 12 times in 1.2 s, of the link in 0.8 s. The reference is the
/// Runge-Kutta method of fourth order with short steps, on the link IDA's second form with a
/// tolerance of 1e-11. Times are the least of several rounds in which all runs take turns. Of each
/// integrator the cheapest run below each level is printed, or of --csv all runs.

#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <integrators.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr int outputs = 12;

/// Returns for how long a scene is followed, s: near 1 s the beam on the link whips.
double duration_of(bool link) { return link ? 0.8 : 1.2; }

/// What a run gave: tips at the times of output, counts, processor time in s.
struct Run {
    ancf::DynamicsReport report;
    std::vector<double> tips;
    double seconds = 0.0;
};

template <int Dimension>
struct Pendulum {
    using Element = ancf::CrossSectionBeam<Dimension>;
    using Scene = ancf::BasicModel<Dimension>;
    using Point = ancf::Vector<double, Dimension>;

    Scene model;
    int tip = 0;
    bool link;

    Pendulum(bool on_link, double stiffness, int elements) : link(on_link) {
        typename Element::Options options;
        options.rule = ancf::Rule::mixed();
        options.rotary_inertia = ancf::RotaryInertia::lumped;
        const auto material =
            ancf::Material::from_moduli(0.7e6 * stiffness, 2.6923e5 * stiffness, 5540.0);
        const auto section =
            ancf::rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
        const auto beam =
            ancf::straight_beam<Element>(model, material, section, Point(Point::Zero()),
                                         Point(Point::Unit(0) * 1.2), elements, options);
        if (link)
            model.add(ancf::Distance<Dimension>(beam.first(), Point(Point::Unit(1) * 0.4), 0.4));
        else
            model.pin(beam.first());
        model.set_gravity(Point(Point::Unit(1) * -9.81));
        tip = model.coordinate(beam.last(), ancf::Field::r);
    }
};

/// One setting of one integrator on one scene.
struct Trial {
    std::string integrator;
    double setting = 0.0;
    std::function<Run()> run;
    Run result;
    double error = 0.0;
};

/// Integrates a scene and keeps its tips.
template <int Dimension>
Run run(const ancf::bench::Integrator& integrator, double setting, Pendulum<Dimension> pendulum) {
    Run result;
    const double duration = duration_of(pendulum.link);
    ancf::Schedule schedule = ancf::equal_intervals(0.0, duration, duration / outputs);
    schedule.observe = [&](const ancf::Snapshot& seen) {
        for (int i = 0; i < Dimension; ++i) result.tips.push_back(seen.state.q[pendulum.tip + i]);
    };
    const std::clock_t began = std::clock();
    result.report = integrator.integrate(pendulum.model, schedule, setting);
    result.seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    return result;
}

/// Integrates by the Runge-Kutta method of fourth order.
template <int Dimension>
std::vector<double> explicit_reference(Pendulum<Dimension> pendulum, int steps) {
    ancf::DynamicProblem problem(pendulum.model);
    const ancf::Start start = problem.start();
    ancf::VectorX q = start.q, v = start.v, acceleration;
    std::vector<double> tips;
    const ancf::VectorX none;
    const auto accelerate = [&](double t, const ancf::VectorX& at, const ancf::VectorX& rate) {
        ancf::detail::require(!problem.evaluate(t, at, rate, none, ancf::Request::force),
                              "the reference failed");
        problem.solve_mass(-problem.force(), acceleration);
        return acceleration;
    };
    const double h = duration_of(pendulum.link) / steps;
    for (int k = 0; k <= steps; ++k) {
        if (k % (steps / outputs) == 0) {
            const ancf::State state = problem.raw_state(k * h, q, v);
            for (int i = 0; i < Dimension; ++i) tips.push_back(state.q[pendulum.tip + i]);
        }
        const double t = k * h;
        const ancf::VectorX a1 = accelerate(t, q, v);
        const ancf::VectorX v2 = v + 0.5 * h * a1;
        const ancf::VectorX a2 = accelerate(t + 0.5 * h, q + 0.5 * h * v, v2);
        const ancf::VectorX v3 = v + 0.5 * h * a2;
        const ancf::VectorX a3 = accelerate(t + 0.5 * h, q + 0.5 * h * v2, v3);
        const ancf::VectorX v4 = v + h * a3;
        const ancf::VectorX a4 = accelerate(t + h, q + h * v3, v4);
        q += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
        v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    return tips;
}

double distance(const std::vector<double>& a, const std::vector<double>& b, int dimension) {
    if (a.size() != b.size()) return std::numeric_limits<double>::quiet_NaN();
    double largest = 0.0;
    for (std::size_t k = 0; k < a.size(); k += static_cast<std::size_t>(dimension)) {
        double square = 0.0;
        for (std::size_t i = k; i < k + static_cast<std::size_t>(dimension); ++i)
            square += (a[i] - b[i]) * (a[i] - b[i]);
        largest = std::max(largest, std::sqrt(square));
    }
    return largest;
}

std::vector<double> decades(double from, double to) {
    std::vector<double> values;
    for (double value = from; value > 0.9 * to; value *= 0.1) {
        values.push_back(value);
        values.push_back(0.3 * value);
    }
    return values;
}

template <int Dimension>
std::vector<Trial> trials(bool link, double stiffness, int elements) {
    std::vector<Trial> all;
    const auto add = [&](const ancf::bench::Integrator& integrator,
                         const std::vector<double>& settings) {
        for (const double setting : settings)
            all.push_back({integrator.name,
                           setting,
                           [=] {
                               return run<Dimension>(
                                   integrator, setting,
                                   Pendulum<Dimension>(link, stiffness, elements));
                           },
                           {},
                           0.0});
    };
    add(ancf::bench::radau("Radau 3", 3), decades(1e-2, 1e-8));
    add(ancf::bench::radau("Radau 5", 5), decades(1e-2, 1e-8));
    std::vector<double> steps;
    for (double step = 8e-3; step > 1e-5; step *= 0.7071067811865476) steps.push_back(step);
    add(ancf::bench::generalized_alpha("generalized-alpha fixed", 0.8), steps);
    add(ancf::bench::adaptive_generalized_alpha("generalized-alpha adaptive"), decades(1e-3, 1e-7));
#if ANCF_WITH_SUNDIALS
    add(ancf::bench::ida("IDA index 3", ancf::sundials::Form::index3), decades(1e-3, 1e-7));
#endif
    return all;
}

template <int Dimension>
void measure(const std::string& name, bool link, double stiffness, int elements, int rounds,
             bool csv, const std::string& only) {
    std::vector<double> exact;
    if (!link) {
        const int steps = stiffness > 1.0 ? 120000 : 60000;  // 10 and 20 us
        exact = explicit_reference(Pendulum<Dimension>(link, stiffness, elements), steps);
    } else {
#if ANCF_WITH_SUNDIALS
        const auto best = ancf::bench::ida("", ancf::sundials::Form::gear_gupta_leimkuhler);
        exact = run<Dimension>(best, 1e-11, Pendulum<Dimension>(link, stiffness, elements)).tips;
#else
        const auto best = ancf::bench::generalized_alpha("", 1.0);
        exact = run<Dimension>(best, 5e-6, Pendulum<Dimension>(link, stiffness, elements)).tips;
#endif
    }
    std::vector<Trial> all = trials<Dimension>(link, stiffness, elements);
    all.erase(
        std::remove_if(all.begin(), all.end(),
                       [&](const Trial& trial) { return trial.integrator.rfind(only, 0) != 0; }),
        all.end());
    for (Trial& trial : all) {
        trial.result = trial.run();
        trial.error = trial.result.report.status == ancf::Status::converged
                          ? distance(trial.result.tips, exact, Dimension)
                          : std::numeric_limits<double>::quiet_NaN();
    }
    for (int round = 1; round < rounds; ++round)
        for (Trial& trial : all) {
            if (trial.result.seconds > 0.5) continue;
            trial.result.seconds = std::min(trial.result.seconds, trial.run().seconds);
        }
    if (csv) {
        for (const Trial& trial : all)
            std::printf("%s,%s,%g,%.3e,%.4g,%ld,%ld,%ld,%ld,%ld,%ld\n", name.c_str(),
                        trial.integrator.c_str(), trial.setting, trial.error,
                        1e3 * trial.result.seconds, trial.result.report.steps,
                        trial.result.report.rejected, trial.result.report.convergence_failures,
                        trial.result.report.evaluations, trial.result.report.jacobians,
                        trial.result.report.factorisations);
        return;
    }
    std::printf("\n%s\n", name.c_str());
    double alpha_ms[4], radau_ms[4];
    std::fill_n(alpha_ms, 4, std::numeric_limits<double>::infinity());
    std::fill_n(radau_ms, 4, std::numeric_limits<double>::infinity());
    std::vector<std::string> integrators;
    for (const Trial& trial : all)
        if (integrators.empty() || integrators.back() != trial.integrator)
            integrators.push_back(trial.integrator);
    for (const std::string& integrator : integrators) {
        std::printf("  %-27s", integrator.c_str());
        for (int level = 0; level < 4; ++level) {
            const Trial* best = nullptr;
            for (const Trial& trial : all)
                if (trial.integrator == integrator &&
                    trial.error <= 1.1 * std::pow(10.0, -3 - level) &&
                    (best == nullptr || trial.result.seconds < best->result.seconds))
                    best = &trial;
            if (best == nullptr) {
                std::printf(" | %-25s", "-");
                continue;
            }
            const double ms = 1e3 * best->result.seconds;
            std::printf(" | %7.2f/%5ld/%4ld %6.0e", ms, best->result.report.evaluations,
                        best->result.report.factorisations, best->setting);
            if (integrator.rfind("Radau", 0) == 0) radau_ms[level] = std::min(radau_ms[level], ms);
            if (integrator.rfind("generalized", 0) == 0)
                alpha_ms[level] = std::min(alpha_ms[level], ms);
        }
        std::printf("\n");
    }
    std::printf("  %-27s", "times faster");
    for (int level = 0; level < 4; ++level)
        std::printf(" | %-25.1f", alpha_ms[level] / radau_ms[level]);
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names = {"plane", "stiff", "hard", "space", "link"};
    int elements = 8, rounds = 5;
    bool csv = false;
    std::string only;
    CLI::App app("Radau IIA beside the other integrators at equal error, on pendulums.");
    app.add_option("--cases", names, "plane, stiff, hard, space, link")->delimiter(',');
    app.add_option("--elements", elements, "number of elements")->check(CLI::Range(1, 1000));
    app.add_option("--rounds", rounds, "how often each run is timed")->check(CLI::Range(1, 100));
    app.add_option("--only", only, "integrators whose name begins so");
    app.add_flag("--csv", csv, "all runs: case, integrator, setting, error (m), cpu (ms), counts");
    CLI11_PARSE(app, argc, argv);
    try {
        if (!csv)
            std::puts("cpu ms / evaluations / factorisations and setting, error of the tip below");
        if (!csv) std::puts("                              | 1e-3 m | 1e-4 m | 1e-5 m | 1e-6 m");
        for (const std::string& name : names) {
            if (name == "plane") measure<2>(name, false, 1.0, elements, rounds, csv, only);
            if (name == "stiff") measure<2>(name, false, 100.0, elements, rounds, csv, only);
            if (name == "hard") measure<2>(name, false, 1e4, elements, rounds, csv, only);
            if (name == "space") measure<3>(name, false, 1.0, elements, rounds, csv, only);
            if (name == "link") measure<2>(name, true, 1.0, elements, rounds, csv, only);
        }
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
