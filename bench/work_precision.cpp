// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Work against precision of every integrator on swinging scenes, each of one mesh.
///
/// The rubber pendulum of [Dufva2006, section 5.1], its pin a support, in the plane and in space, a
/// hundred and ten thousand times as stiff, on a massless link of 0.4 m; a double pendulum with a
/// hinge; a frame of three members. The error is the largest distance of the tip from a reference
/// at twelve times. The reference is the Runge-Kutta method of fourth order with short steps, of
/// index 1 where there are multipliers. Another method on the same mesh tells how good it is, and
/// has to agree to 1e-9 m: IDA's second form with a tolerance of 1e-11, of stiff scenes Verner's
/// explicit method of sixth order; without SUNDIALS, Runge-Kutta with twice the step.
/// Times are of the processor, medians of several rounds in which all runs take turns. A run far
/// from the cheapest of its integrator at every level takes part in the first round alone. Of each
/// integrator the cheapest run below each level is printed, or of --csv all runs.

#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints/joints.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/csv.hpp>
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
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using ancf::bench::Integrator;

constexpr int outputs = 12;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A scene at its start.
struct Swing {
    std::unique_ptr<ancf::Scene> scene;
    int tip = 0;        // index of the tip's position in the coordinates
    int dimension = 3;  // of that position
    double duration = 1.2;
    double step = 5e-5;  // of the reference, s
    bool stiff = false;
};

ancf::CrossSectionOptions element_options() {
    ancf::CrossSectionOptions options;
    options.rule = ancf::Rule::mixed();
    options.rotary_inertia = ancf::RotaryInertia::lumped;
    return options;
}

ancf::Material rubber(double stiffness) {
    return ancf::Material::from_moduli(0.7e6 * stiffness, 2.6923e5 * stiffness, 5540.0);
}

ancf::Section square() {
    return ancf::rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
}

template <int Dimension>
Swing pendulum(double stiffness, bool link, int elements) {
    using Point = ancf::Vector<double, Dimension>;
    auto model = std::make_unique<ancf::BasicModel<Dimension>>();
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<Dimension>>(
        *model, rubber(stiffness), square(), Point(Point::Zero()), Point(Point::Unit(0) * 1.2),
        elements, element_options());
    if (link)
        model->add(ancf::Distance<Dimension>(beam.first(), Point(Point::Unit(1) * 0.4), 0.4));
    else
        model->pin(beam.first());
    model->set_gravity(Point(Point::Unit(1) * -9.81));
    const int tip = model->coordinate(beam.last(), ancf::Field::r);
    Swing swing{std::move(model), tip, Dimension};
    if (link) {
        swing.duration = 0.8;  // near 1 s the beam on the link whips
        swing.step = 2.5e-5;
    }
    swing.stiff = stiffness > 1.0;
    if (swing.stiff) swing.step = stiffness > 100.0 ? 1e-6 : 1e-5;
    return swing;
}

Swing double_pendulum(int elements) {
    using Point = ancf::Vector<double, 3>;
    auto model = std::make_unique<ancf::Model>();
    const auto material = ancf::Material::from_moduli(5.0e6, 1.923e6, 5540.0);
    const Point elbow(0.8, 0.0, 0.0);
    const auto add = [&](const Point& from, const Point& to) {
        return ancf::straight_beam<ancf::CrossSectionBeam<3>>(
            *model, material, square(), from, to, (elements + 1) / 2, element_options());
    };
    const auto first = add(Point::Zero(), elbow);
    const auto second = add(elbow, elbow + Point(0.0, 0.0, 0.8));
    model->pin(first.first());
    model->add(ancf::Revolute(*model, first.last(), second.first(), Point(1.0, 1.0, 0.0)));
    model->set_gravity({0.0, -9.81, 0.0});
    const int tip = model->coordinate(second.last(), ancf::Field::r);
    return {std::move(model), tip, 3, 0.9, 3e-5};
}

Swing swinging_frame(int elements) {
    auto model = std::make_unique<ancf::Model>();
    const int each = (elements + 3) / 4;
    const auto built = ancf::frame<ancf::CrossSectionBeam<3>>(
        *model, {{rubber(10.0), square()}},
        {{0.0, 0.0, 0.0}, {0.6, 0.0, 0.0}, {0.6, 0.6, 0.0}, {0.6, 0.0, 0.4}},
        {{0, 1, 0, each}, {1, 2, 0, each}, {1, 3, 0, each}}, {}, element_options());
    model->pin(built.joints[0]);
    model->set_gravity({0.0, -9.81, 0.0});
    const int tip = model->coordinate(built.joints[2], ancf::Field::r);
    return {std::move(model), tip, 3, 0.9, 2e-5, true};
}

/// Builds a scene by its name.
Swing build(const std::string& name, int elements) {
    if (name == "plane") return pendulum<2>(1.0, false, elements);
    if (name == "stiff") return pendulum<2>(100.0, false, elements);
    if (name == "hard") return pendulum<2>(1e4, false, elements);
    if (name == "link") return pendulum<2>(1.0, true, elements);
    if (name == "space") return pendulum<3>(1.0, false, elements);
    if (name == "double") return double_pendulum(elements);
    return swinging_frame(elements);
}

/// What a run gave: tips at the times of output, processor time in s.
struct Run {
    ancf::DynamicsReport report;
    std::vector<double> tips;
    double seconds = 0.0;
};

/// Integrates a scene and keeps its tips.
Run run(const std::string& name, int elements, const Integrator& integrator, double value) {
    const Swing swing = build(name, elements);
    Run result;
    ancf::Schedule schedule = ancf::equal_intervals(0.0, swing.duration, swing.duration / outputs);
    schedule.observe = [&](const ancf::Snapshot& seen) {
        for (int i = 0; i < swing.dimension; ++i)
            result.tips.push_back(seen.state.q[swing.tip + i]);
    };
    const std::clock_t began = std::clock();
    result.report = integrator.integrate(*swing.scene, schedule, value);
    result.seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    return result;
}

/// Integrates by the Runge-Kutta method of fourth order, with steps as long as a reference's, times
/// a factor.
std::vector<double> by_runge_kutta(const std::string& name, int elements, double factor) {
    const Swing swing = build(name, elements);
    ancf::DynamicProblem problem(*swing.scene);
    const ancf::Start start = problem.start();
    ancf::VectorX q = start.q, v = start.v, acceleration, multipliers;
    const ancf::VectorX none;
    const auto accelerate = [&](double t, const ancf::VectorX& at, const ancf::VectorX& rate) {
        bool good = true;
        if (problem.multipliers() > 0) {
            good = problem.accelerations(t, at, rate, acceleration, multipliers) ==
                   ancf::Status::converged;
        } else {
            good = !problem.evaluate(t, at, rate, none, ancf::Request::force);
            problem.solve_mass(-problem.force(), acceleration);
        }
        ancf::detail::require(good, "the reference failed");
        return acceleration;
    };
    std::vector<double> tips;
    const int part = static_cast<int>(std::ceil(swing.duration / outputs / (factor * swing.step)));
    const double h = swing.duration / outputs / part;
    for (int k = 0; k <= part * outputs; ++k) {
        const double t = k * h;
        if (k % part == 0) {
            ancf::VectorX place = q, rate = v;
            (void)problem.project(t, place, rate);
            const ancf::State state = problem.raw_state(t, place, rate);
            for (int i = 0; i < swing.dimension; ++i) tips.push_back(state.q[swing.tip + i]);
        }
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

std::vector<double> reference(const std::string& name, int elements) {
    const Swing swing = build(name, elements);
    std::vector<double> tips = by_runge_kutta(name, elements, 1.0);
    std::vector<double> again;
#if ANCF_WITH_SUNDIALS
    const std::string other = swing.stiff ? "Verner's method" : "IDA";
    const auto method = swing.stiff
                            ? ancf::bench::explicit_method("", ancf::sundials::Table::verner)
                            : ancf::bench::ida("", ancf::sundials::Form::gear_gupta_leimkuhler);
    again = run(name, elements, method, 1e-11).tips;
    constexpr double most = 1e-9;  // m
#else
    const std::string other = "twice the step";
    again = by_runge_kutta(name, elements, 2.0);
    constexpr double most = 15e-9;  // m: of the fourth order, 15 times the reference's error
#endif
    const double apart = distance(tips, again, swing.dimension);
    std::fprintf(stderr, "%s: the reference and that by %s differ by %.1e m\n", name.c_str(),
                 other.c_str(), apart);
    ancf::detail::require(apart <= most, name, ": the reference and that by ", other, " differ by ",
                          apart, " m, expected at most ", most);
    return tips;
}

/// One setting of one integrator.
struct Trial {
    const Integrator* integrator;
    double value;
    Run result;
    double error;
    std::vector<double> times;  // s, of every round; their median stands in result

    [[nodiscard]] bool reaches(int level) const {
        return error <= 1.1 * std::pow(10.0, -3 - level);
    }
};

constexpr int levels = 4;  // errors of 1e-3 to 1e-6 m

/// An integrator and the values of its setting, from coarse to fine.
struct Series {
    Integrator integrator;
    std::vector<double> values;
};

/// Returns 1e-first, 3e-(first + 1), 1e-(first + 1) and so on down to 1e-last.
std::vector<double> tolerances(int first, int last) {
    std::vector<double> values;
    for (int k = first; k <= last; ++k) {
        if (k > first) values.push_back(std::stod("3e-" + std::to_string(k)));
        values.push_back(std::stod("1e-" + std::to_string(k)));
    }
    return values;
}

std::vector<double> steps(double from, double to) {
    std::vector<double> values;
    for (double step = from; step > to; step *= 0.7071067811865476) values.push_back(step);
    return values;
}

std::vector<Series> all_series(bool constrained, [[maybe_unused]] bool tables) {
    std::vector<Series> all;
    all.push_back({ancf::bench::radau("Radau 3", 3), tolerances(2, 9)});
    all.push_back({ancf::bench::radau("Radau 5", 5), tolerances(2, 9)});
    all.push_back(
        {ancf::bench::generalized_alpha("generalized-alpha fixed", 0.8), steps(8e-3, 8e-6)});
    all.push_back(
        {ancf::bench::adaptive_generalized_alpha("generalized-alpha adaptive"), tolerances(3, 8)});
    all.push_back({ancf::bench::energy_momentum("energy-momentum"), steps(8e-3, 8e-6)});
    all.push_back({ancf::bench::leapfrog("leapfrog"), steps(8e-3, 8e-6)});
#if ANCF_WITH_SUNDIALS
    using ancf::sundials::Form;
    using ancf::sundials::Table;
    all.push_back({ancf::bench::ida("IDA index 3", Form::index3), tolerances(3, 10)});
    all.push_back({ancf::bench::ida("IDA GGL", Form::gear_gupta_leimkuhler), tolerances(3, 10)});
    if (constrained) return all;
    all.push_back({ancf::bench::explicit_method("explicit fixed ARK436", Table::ark436, true),
                   steps(8e-3, 8e-6)});
    const std::pair<const char*, Table> known[] = {
        {"explicit ARK436", Table::ark436},
        {"explicit Fehlberg", Table::fehlberg},
        {"explicit Bogacki-Shampine", Table::bogacki_shampine},
        {"explicit Zonneveld", Table::zonneveld},
        {"explicit ARK437", Table::ark437},
        {"explicit Dormand-Prince", Table::dormand_prince},
        {"explicit Verner", Table::verner}};
    for (int k = 0; k < (tables ? 7 : 2); ++k)
        all.push_back(
            {ancf::bench::explicit_method(known[k].first, known[k].second), tolerances(2, 9)});
#endif
    return all;
}

/// What is measured, and for how long.
struct Request {
    int elements = 8, rounds = 5;
    bool csv = false, tables = false;
    std::string only;
    double finest = 1e-8;  // m: an integrator ends with its first run of such an error
    double longest = 4.0;  // s: or with one that converges and takes so long
};

/// Runs an integrator, finer and finer.
void add_trials(const std::string& name, const Request& request, const Series& series,
                const std::vector<double>& exact, int dimension, std::vector<Trial>& all) {
    for (const double value : series.values) {
        Trial trial{&series.integrator,
                    value,
                    run(name, request.elements, series.integrator, value),
                    0.0,
                    {}};
        trial.times = {trial.result.seconds};
        trial.error = trial.result.report.status == ancf::Status::converged
                          ? distance(trial.result.tips, exact, dimension)
                          : infinity;
        all.push_back(std::move(trial));
        const Trial& done = all.back();
        if (done.error <= request.finest) return;
        if (std::isfinite(done.error) && done.result.seconds > request.longest) return;
    }
}

/// Returns the cheapest run of an integrator at a level, or null.
const Trial* cheapest(const std::vector<Trial>& all, const Integrator& integrator, int level) {
    const Trial* best = nullptr;
    for (const Trial& trial : all)
        if (trial.integrator == &integrator && trial.reaches(level) &&
            (best == nullptr || trial.result.seconds < best->result.seconds))
            best = &trial;
    return best;
}

/// Returns the runs that take at most half as long again as the cheapest of their integrator at a
/// level, one below those of the tables too.
std::vector<Trial*> near_the_cheapest(std::vector<Trial>& all) {
    std::vector<Trial*> near;
    for (Trial& trial : all)
        for (int level = 0; level <= levels; ++level) {
            if (!trial.reaches(level)) continue;
            const double least = cheapest(all, *trial.integrator, level)->result.seconds;
            if (trial.result.seconds > 1.5 * least) continue;
            near.push_back(&trial);
            break;
        }
    return near;
}

/// Times runs in further rounds.
void time_again(const std::string& name, const Request& request, std::vector<Trial>& all) {
    const std::vector<Trial*> near = near_the_cheapest(all);
    for (int round = 1; round < request.rounds; ++round)
        for (Trial* trial : near)
            trial->times.push_back(
                run(name, request.elements, *trial->integrator, trial->value).seconds);
    for (Trial* trial : near) {
        const auto middle = trial->times.begin() + static_cast<long>(trial->times.size() / 2);
        std::nth_element(trial->times.begin(), middle, trial->times.end());
        trial->result.seconds = *middle;
    }
}

void print_rows(const std::string& name, const Request& request, const std::vector<Trial>& all,
                ancf::CsvWriter& csv) {
    for (const Trial& trial : all) {
        const ancf::DynamicsReport& report = trial.result.report;
        csv.row(name, request.elements, trial.integrator->name, trial.integrator->setting,
                trial.value, trial.error, 1e3 * trial.result.seconds, report.steps, report.rejected,
                report.convergence_failures, report.iterations, report.evaluations,
                report.jacobians, report.factorisations, to_string(report.status));
    }
    std::cout.flush();
}

/// Forces and factorisations that a prototype of Radau IIA took for the planar rubber pendulum, at
/// the four levels: counts that the library's integrators are held against.
struct Counts {
    const char* integrator;
    double forces[levels], factorisations[levels];
};

constexpr Counts prototype[] = {{"Radau 3", {660, 843, 1248, 3981}, {130, 188, 176, 984}},
                                {"Radau 5", {1230, 1230, 1345, 2950}, {153, 153, 144, 171}},
                                {"explicit fixed ARK436", {2400, 2400, 2400, 9600}, {0, 0, 0, 0}}};

/// Prints how many times as many an integrator took.
void print_counts(const std::string& integrator, const Trial* const (&best)[levels]) {
    for (const Counts& theirs : prototype) {
        if (integrator != theirs.integrator) continue;
        std::printf("    %-25s", "of a prototype's counts");
        for (int level = 0; level < levels; ++level) {
            if (best[level] == nullptr) {
                std::printf(" | %-26s", "-");
                continue;
            }
            const ancf::DynamicsReport& report = best[level]->result.report;
            const auto forces = static_cast<double>(report.evaluations) / theirs.forces[level];
            if (theirs.factorisations[level] > 0.0)
                std::printf(
                    " | %7s/%6.2f/%4.2f %6s", "", forces,
                    static_cast<double>(report.factorisations) / theirs.factorisations[level], "");
            else
                std::printf(" | %7s/%6.2f/%4s %6s", "", forces, "", "");
        }
        std::printf("\n");
    }
}

void print_table(const std::string& name, const std::vector<Series>& series,
                 const std::vector<Trial>& all) {
    std::printf("\n%s\n", name.c_str());
    double alpha[levels], radau[levels];
    std::fill_n(alpha, levels, infinity);
    std::fill_n(radau, levels, infinity);
    for (const Series& one : series) {
        std::printf("  %-27s", one.integrator.name.c_str());
        const Trial* all_best[levels] = {};
        for (int level = 0; level < levels; ++level) {
            const Trial* const best = all_best[level] = cheapest(all, one.integrator, level);
            if (best == nullptr) {
                std::printf(" | %-26s", "-");
                continue;
            }
            const double ms = 1e3 * best->result.seconds;
            std::printf(" | %7.2f/%6ld/%4ld %6.0e", ms, best->result.report.evaluations,
                        best->result.report.factorisations, best->value);
            if (one.integrator.name.rfind("Radau", 0) == 0)
                radau[level] = std::min(radau[level], ms);
            if (one.integrator.name.rfind("generalized", 0) == 0)
                alpha[level] = std::min(alpha[level], ms);
        }
        std::printf("\n");
        if (name == "plane") print_counts(one.integrator.name, all_best);
    }
    std::printf("  %-27s", "times faster");
    for (int level = 0; level < levels; ++level)
        if (std::isfinite(alpha[level]) && std::isfinite(radau[level]))
            std::printf(" | %-26.1f", alpha[level] / radau[level]);
        else
            std::printf(" | %-26s", "-");
    std::printf("\n");
    std::fflush(stdout);
}

void measure(const std::string& name, const Request& request, ancf::CsvWriter* csv) {
    const std::vector<double> exact = reference(name, request.elements);
    const Swing swing = build(name, request.elements);
    std::vector<Series> series = all_series(!swing.scene->constraints().empty(), request.tables);
    series.erase(std::remove_if(series.begin(), series.end(),
                                [&](const Series& one) {
                                    return one.integrator.name.rfind(request.only, 0) != 0;
                                }),
                 series.end());
    std::vector<Trial> all;
    for (const Series& one : series) add_trials(name, request, one, exact, swing.dimension, all);
    time_again(name, request, all);
    if (csv != nullptr)
        print_rows(name, request, all, *csv);
    else
        print_table(name, series, all);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> known = {"plane", "space",  "stiff", "hard",
                                            "link",  "double", "frame"};
    std::vector<std::string> names = {"plane", "space", "stiff", "link", "double", "frame"};
    Request request;
    CLI::App app("Work against precision of every integrator on swinging scenes.");
    app.add_option("--scenes", names, "plane, space, stiff, hard, link, double, frame")
        ->delimiter(',')
        ->check(CLI::IsMember(known));
    app.add_option("--elements", request.elements, "number of elements")
        ->check(CLI::Range(1, 1000));
    app.add_option("--rounds", request.rounds, "how often a run is timed")
        ->check(CLI::Range(1, 100));
    app.add_option("--only", request.only, "integrators whose name begins so");
    app.add_option("--finest", request.finest, "m, error at which an integrator ends");
    app.add_option("--longest", request.longest, "s, time of a run at which an integrator ends");
    app.add_flag("--tables", request.tables, "all tables of the explicit integrator");
    app.add_flag("--csv", request.csv, "all runs as comma-separated values");
    CLI11_PARSE(app, argc, argv);
    try {
        std::unique_ptr<ancf::CsvWriter> csv;
        if (request.csv) {
            csv = std::make_unique<ancf::CsvWriter>(
                std::cout, std::vector<std::string>{"scene", "elements", "integrator", "setting",
                                                    "value", "error", "cpu_ms", "steps", "rejected",
                                                    "failures", "solves", "evaluations",
                                                    "jacobians", "factorisations", "status"});
        } else {
            std::puts("cpu ms / evaluations / factorisations and setting, error of the tip below");
            std::puts("                              | 1e-3 m | 1e-4 m | 1e-5 m | 1e-6 m");
        }
        for (const std::string& name : names) measure(name, request, csv.get());
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
