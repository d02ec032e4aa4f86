// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Work against precision of every integrator on pendulums: CSV on stdout.
///
/// The rubber pendulum of [Dufva2006, section 5.1], the same on a massless link of 0.4 m, a steel
/// one (2 m, 10 mm square), and on demand the first with a support as its pin, in space and in the
/// plane: those have no multipliers, so explicit methods take them. The error is the largest
/// distance of the tip from a reference solution at 24 times in 1.2 s; the reference is a run of
/// the same mesh with a far smaller tolerance or step.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
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

using Point = ancf::Vector<double, 3>;

struct Pendulum {
    std::unique_ptr<ancf::Scene> scene;
    int tip = 0;        // index of the tip's position in the coordinates
    int dimension = 3;  // of that position
};

/// Builds the rubber pendulum whose pin is a support.
template <int Dimension>
Pendulum build_supported(int elements) {
    using Place = ancf::Vector<double, Dimension>;
    const auto material = ancf::Material::from_moduli(0.7e6, 2.6923e5, 5540.0);
    const auto section = ancf::rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    auto model = std::make_unique<ancf::BasicModel<Dimension>>();
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<Dimension>>(
        *model, material, section, Place::Zero(), 1.2 * Place::UnitX(), elements,
        ancf::CrossSectionOptions::paper());
    model->pin(beam.first());
    model->set_gravity(-9.81 * Place::UnitY());
    const int tip = model->coordinate(beam.last(), ancf::Field::r);
    return {std::move(model), tip, Dimension};
}

/// Builds a case by its name.
Pendulum build(const std::string& name, int elements) {
    if (name == "support") return build_supported<3>(elements);
    if (name == "planar") return build_supported<2>(elements);
    const bool steel = name == "steel";
    const double depth = steel ? 0.01 : 0.05;
    const auto material = steel ? ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0)
                                : ancf::Material::from_moduli(0.7e6, 2.6923e5, 5540.0);
    const auto section = ancf::rectangle(depth, depth).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    auto model = std::make_unique<ancf::Model>();
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        *model, material, section, Point::Zero(), {steel ? 2.0 : 1.2, 0.0, 0.0}, elements,
        ancf::CrossSectionOptions::paper());
    if (name == "link")
        model->add(ancf::Distance<3>(beam.first(), Point(0.0, 0.4, 0.0), 0.4));
    else
        model->add(ancf::Pin<3>(beam.first(), Point::Zero()));
    model->set_gravity({0.0, -9.81, 0.0});
    const int tip = model->coordinate(beam.last(), ancf::Field::r);
    return {std::move(model), tip};
}

using ancf::bench::Integrator;

/// An integrator and the values of its setting.
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

std::vector<double> halves(double from, int count) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k) values.push_back(std::ldexp(from, -k));
    return values;
}

std::vector<Series> all_series([[maybe_unused]] const std::string& name) {
    std::vector<Series> all;
#if ANCF_WITH_SUNDIALS
    using ancf::sundials::Form;
    const bool steel = name == "steel";
    all.push_back({ancf::bench::ida("IDA index 3", Form::index3), tolerances(4, steel ? 9 : 11)});
    // the rates of a stiff scene are in the error test of this form: it follows every vibration
    all.push_back(
        {ancf::bench::ida("IDA GGL", Form::gear_gupta_leimkuhler), tolerances(3, steel ? 6 : 9)});
    if (name == "support" || name == "planar") {
        using ancf::sundials::Table;
        const std::pair<const char*, Table> tables[] = {
            {"explicit Bogacki-Shampine", Table::bogacki_shampine},
            {"explicit Zonneveld", Table::zonneveld},
            {"explicit ARK436", Table::ark436},
            {"explicit ARK437", Table::ark437},
            {"explicit Dormand-Prince", Table::dormand_prince},
            {"explicit Verner", Table::verner},
            {"explicit Fehlberg", Table::fehlberg}};
        for (const auto& [title, table] : tables)
            all.push_back({ancf::bench::explicit_method(title, table), tolerances(2, 9)});
    }
#endif
    all.push_back({ancf::bench::generalized_alpha("generalized-alpha 0.8", 0.8), halves(4e-3, 9)});
    all.push_back(
        {ancf::bench::adaptive_generalized_alpha("generalized-alpha adaptive"), tolerances(3, 8)});
    all.push_back({ancf::bench::radau("Radau IIA 3", 3), tolerances(2, 8)});
    all.push_back({ancf::bench::radau("Radau IIA 5", 5), tolerances(2, 8)});
    all.push_back({ancf::bench::energy_momentum("energy-momentum"), halves(4e-3, 8)});
    return all;
}

/// What a run gave.
struct Run {
    ancf::DynamicsReport report;
    std::vector<Point> tips;  // at the times of the schedule
    double energy = 0.0;      // largest change of the total energy at those times, J
    double seconds = 0.0;     // of one processor
};

Run run(const std::string& name, int elements, const Integrator& integrator, double value) {
    Pendulum pendulum = build(name, elements);
    Run result;
    ancf::Schedule schedule = ancf::equal_intervals(0.0, 1.2, 0.05);
    double before = 0.0;
    schedule.observe = [&](const ancf::Snapshot& seen) {
        if (result.tips.empty()) before = seen.energies.total();
        Point tip = Point::Zero();
        for (int k = 0; k < pendulum.dimension; ++k) tip[k] = seen.state.q[pendulum.tip + k];
        result.tips.push_back(tip);
        result.energy = std::max(result.energy, std::abs(seen.energies.total() - before));
    };
    const std::clock_t began = std::clock();
    result.report = integrator.integrate(*pendulum.scene, schedule, value);
    result.seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    return result;
}

/// Repeats a short run and keeps the shortest time.
Run timed_run(const std::string& name, int elements, const Integrator& integrator, double value) {
    constexpr double enough = 0.3;  // s
    Run best = run(name, elements, integrator, value);
    double spent = best.seconds;
    for (int k = 0; k < 4 && spent < enough; ++k) {
        Run again = run(name, elements, integrator, value);
        spent += again.seconds;
        if (again.seconds < best.seconds) best = std::move(again);
    }
    return best;
}

/// Integrates with a far smaller tolerance or step than any that is measured.
Run reference(const std::string& name, int elements) {
#if ANCF_WITH_SUNDIALS
    if (name != "steel")
        return run(name, elements,
                   ancf::bench::ida("", ancf::sundials::Form::gear_gupta_leimkuhler), 1e-11);
#endif
    return run(name, elements, ancf::bench::generalized_alpha("", 1.0),
               name == "steel" ? 2.5e-6 : 1e-5);
}

double error(const Run& got, const Run& exact) {
    if (got.tips.size() != exact.tips.size()) return std::numeric_limits<double>::quiet_NaN();
    double largest = 0.0;
    for (std::size_t k = 0; k < got.tips.size(); ++k)
        largest = std::max(largest, (got.tips[k] - exact.tips[k]).norm());
    return largest;
}

void measure(const std::vector<std::string>& names, int elements) {
    ancf::CsvWriter csv(
        std::cout, {"case", "elements", "integrator", "setting", "value", "error", "energy_error",
                    "steps", "linear_solves", "factorisations", "cpu_seconds", "status", "forces"});
    for (const std::string& name : names) {
        const Run exact = reference(name, elements);
        ancf::detail::require(exact.report.status == ancf::Status::converged, name,
                              ": the reference failed: ", exact.report.message);
        for (const auto& [integrator, values] : all_series(name))
            for (const double value : values) {
                const Run got = timed_run(name, elements, integrator, value);
                csv.row(name, elements, integrator.name, integrator.setting, value,
                        error(got, exact), got.energy, got.report.steps, got.report.iterations,
                        got.report.factorisations, got.seconds, to_string(got.report.status),
                        got.report.evaluations);
                std::cout.flush();
            }
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names = {"pendulum", "link", "steel"};
    int elements = 4;
    CLI::App app("Work against precision of every integrator on pendulums: CSV on stdout.");
    app.add_option("--cases", names, "pendulum, link, steel, support, planar")
        ->delimiter(',')
        ->check(CLI::IsMember({"pendulum", "link", "steel", "support", "planar"}));
    app.add_flag("--csv", "comma-separated values, which it always prints");
    app.add_option("--elements", elements, "number of elements")->check(CLI::Range(1, 1000));
    CLI11_PARSE(app, argc, argv);
    try {
        measure(names, elements);
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
