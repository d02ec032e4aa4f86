// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A chain that hangs between two pins of equal height, against the catenary.
///
///     o<------------- span ------------->o      Y
///      \                                /       |
///       \_                            _/        +-- X
///         `-__                    __-'          weight w per length along -Y
///             ``--..________..--''
///
/// A line without stiffness of length L takes the shape a cosh(x/a) with 2 a sinh(span/2a) = L; its
/// sag is a (cosh(span/2a) - 1). The chain has E A/(w L) = 1e8 and E I/(w L^3) = 1e-8, which moves
/// the sag by 2e-8 (L = 1.05) and 3e-7 (L = 2). With 16 cables it is within 2e-6 and 5e-5.
///
/// How the equilibrium is found: without tension a chain resists by E I alone, so that a start at
/// rest is singular but for round-off. The start is an arc of the chain's length, stretched as a
/// tension of w L stretches a soft chain; then E A grows by large factors, each solution the start
/// of the next.

#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/error.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/types.hpp>

#include <support/beam.hpp>
#include <support/command_line.hpp>
#include <support/files.hpp>
#include <support/named_beam.hpp>
#include <support/report.hpp>
#include <support/solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using ancf::pi;

constexpr double gravity = 9.81;     // m/s^2
constexpr double area = 1e-4;        // m^2
constexpr double line_weight = 1.0;  // w, N/m

/// A published sag: the closed form, and how near this mesh of cables comes to it.
struct Target {
    double length;
    int elements;
    double tolerance;  // m
};
constexpr Target targets[] = {{1.05, 16, 2e-6}, {2.0, 16, 5e-5}};

struct HangingChain {
    double span = 1.0;
    double stiffness = 1e8;  ///< E A/(w L)
    double bending = 1e-8;   ///< E I/(w L^3)
    std::vector<double> lengths;
    examples::BeamOptions beam{};  ///< element and rule alone
    std::vector<int> elements = {4, 8, 16, 32};
    examples::SolverOptions solver;
    examples::OutputOptions output;

    void parse(int argc, char** argv);
    [[nodiscard]] std::string title() const;

    [[nodiscard]] ancf::CableOptions options() const {
        return {beam.rule == "cable" ? ancf::cable_rule() : ancf::Rule::named(beam.rule), 1.0};
    }

    /// Returns the target of a length and a mesh, nullptr where this is another problem.
    [[nodiscard]] const Target* target(double length, int mesh) const;
};

void HangingChain::parse(int argc, char** argv) {
    examples::CommandLine line("A chain between two pins of equal height, against the catenary.");
    double length = 1.05;
    line.set_group("Chain");
    line.add_number("--span", span, examples::Range::positive, "distance of the pins, m");
    line.add_number(
        "--length", length, examples::Range::positive,
        "of the chain, m, more than the span; not given, 1.05 and 2 one after the other");
    line.add_number("--stiffness", stiffness, examples::Range::positive,
                    "E A/(w L), w the weight per length");
    line.add_number("--bending", bending, examples::Range::positive, "E I/(w L^3)");
    line.set_group("Element");
    beam.element = "cable-2d";
    beam.rule = "cable";
    line.add_choice("--element", beam.element, {"cable-2d", "cable"}, "element");
    std::vector<std::string> rules = {"cable"};
    for (const auto name : ancf::Rule::names()) rules.emplace_back(name);
    line.add_choice("--rule", beam.rule, rules, "integration along the element");
    line.add_counts("--elements", elements, 1, examples::most_elements, "meshes");
    solver.add_to(line);
    output.add_to(line);
    line.parse(argc, argv);
    lengths = line.given("--length") ? std::vector<double>{length} : std::vector<double>{1.05, 2.0};
    for (const double each : lengths)
        ancf::detail::require(each > span && each < 1e6 * span,
                              "--length: expected more than the span of ", span,
                              " m and less than a million spans, got ", each);
    output.check();
}

std::string HangingChain::title() const {
    std::ostringstream text;
    text << "Hanging chain, span " << span << " m, " << beam.element << " element, rule "
         << beam.rule << ", E A/(w L) " << stiffness << ", E I/(w L^3) " << bending;
    return text.str();
}

const Target* HangingChain::target(double length, int mesh) const {
    const HangingChain usual;
    if (span != usual.span || stiffness != usual.stiffness || bending != usual.bending ||
        beam.rule != "cable")
        return nullptr;
    for (const Target& each : targets)
        if (each.length == length && each.elements == mesh) return &each;
    return nullptr;
}

/// Returns the root of an increasing function between two numbers.
template <class Function>
double root(const Function& f, double low, double high) {
    for (int k = 0; k < 200; ++k) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return low;
}

/// Returns the sag of the catenary.
double catenary_sag(double span, double length) {
    const double x = root([&](double y) { return std::sinh(y) / y - length / span; }, 1e-9, 100.0);
    const double half = std::sinh(0.5 * x);
    return span * half * half / x;  // a (cosh x - 1), x = span/2a
}

/// One chain: its scene, and the way to its equilibrium.
template <int Dimension>
class Chain {
public:
    using Element = ancf::Cable<Dimension>;
    using Point = ancf::Vector<double, Dimension>;

    Chain(const HangingChain& problem, double length, int elements)
        : problem_(problem),
          length_(length),
          elements_(elements),
          beam_(examples::straight_beam<Dimension>(
              model_, problem.beam, material(problem.stiffness), section(problem.stiffness),
              Point::Zero(), length * Point::UnitX(), elements)) {
        model_.set_gravity(-gravity * Point::Unit(1));
        start(1.0);
        model_.pin(beam_.first());
        model_.pin(beam_.last());
    }

    /// Finds the equilibrium; reports all its load steps.
    [[nodiscard]] ancf::StaticsReport settle();

    /// Returns the depth of the middle of the chain below its pins, m.
    [[nodiscard]] double sag() const {
        const auto ends_and_middles = beam_.shape(model_, section(problem_.stiffness), 3);
        const int place = 3 * (elements_ / 2) + elements_ % 2;
        return -ends_and_middles[static_cast<std::size_t>(place)].centre[1];
    }

    [[nodiscard]] const ancf::BasicModel<Dimension>& model() const { return model_; }
    [[nodiscard]] const examples::NamedBeam& beam() const { return beam_; }

private:
    /// Returns E for E A/(w L) as given, Pa.
    [[nodiscard]] double young(double stiffness) const {
        return stiffness * line_weight * length_ / area;
    }
    [[nodiscard]] ancf::Material material(double stiffness) const {
        return ancf::Material::isotropic(young(stiffness), 0.3, line_weight / (gravity * area));
    }
    /// Returns the section by which E I is as the problem has it.
    [[nodiscard]] ancf::Section section(double stiffness) const {
        ancf::Moments moments;
        moments.area = area;
        moments.yy = moments.zz =
            problem_.bending * line_weight * std::pow(length_, 3) / young(stiffness);
        return ancf::Section::from_moments(moments);
    }

    /// Puts the nodes on the arc between the pins that is `stretch` times as long as the chain.
    void start(double stretch) {
        const double whole = length_ * stretch;
        const double half =
            root([&](double x) { return problem_.span / whole - std::sin(x) / x; }, 1e-9, pi);
        const double radius = 0.5 * whole / half;
        for (int k = 0; k <= elements_; ++k) {
            const double angle = half * (2.0 * k / elements_ - 1.0);
            Point position = Point::Zero(), slope = Point::Zero();
            position[0] = k == 0           ? 0.0
                          : k == elements_ ? problem_.span
                                           : 0.5 * problem_.span + radius * std::sin(angle);
            position[1] =
                k == 0 || k == elements_ ? 0.0 : radius * (std::cos(half) - std::cos(angle));
            slope[0] = stretch * std::cos(angle);
            slope[1] = stretch * std::sin(angle);
            model_.set_value(beam_.node(k), ancf::Field::r, position);
            model_.set_value(beam_.node(k), ancf::Field::r_x, slope);
        }
    }

    const HangingChain& problem_;
    double length_;
    int elements_;
    ancf::BasicModel<Dimension> model_;
    examples::NamedBeam beam_;
};

template <int Dimension>
ancf::StaticsReport Chain<Dimension>::settle() {
    ancf::StaticsReport all;
    const auto solve = [&](double stiffness) {
        model_.template prototype<Element>(beam_.prototypes.front()) = {
            material(stiffness), section(stiffness), length_ / elements_, problem_.options()};
        ancf::StaticsReport report = examples::solve(model_, problem_.solver);
        report.steps.insert(report.steps.begin(), all.steps.begin(), all.steps.end());
        all = std::move(report);
        return all.status == ancf::Status::converged;
    };
    // a soft chain, softer yet where that fails
    double reached = std::min(100.0, problem_.stiffness);
    for (int trial = 0; trial < 3; ++trial, reached *= 0.1) {
        start(1.0 + 1.0 / reached);
        if (solve(reached)) break;
    }
    // then stiffer, by smaller factors where that fails
    double factor = 100.0;
    while (reached < problem_.stiffness && factor > 1.1) {
        const double next = std::min(problem_.stiffness, reached * factor);
        if (solve(next))
            reached = next;
        else
            factor = std::sqrt(factor);
    }
    return all;
}

struct Result {
    ancf::StaticsReport report;
    int unknowns;
    double sag;
};

template <int Dimension>
Result solve(const HangingChain& problem, double length, int mesh) {
    Chain<Dimension> chain(problem, length, mesh);
    auto report = chain.settle();
    if (mesh == problem.elements.back() && length == problem.lengths.back())
        problem.output.write(chain.model(), chain.beam(),
                             ancf::circle(0.005 * problem.span));  // drawn so thick
    return {std::move(report), examples::free_coordinates(chain.model()), chain.sag()};
}

/// Solves every length and mesh, prints a row for each; returns whether all is as it should be.
bool study(const HangingChain& problem) {
    using examples::fixed, examples::scientific;
    examples::Verdict verdict;
    examples::Sheet sheet(problem.output.csv,
                          {"element", "rule", "span", "length", "elements", "dofs", "steps",
                           "iterations", "status", "sag", "closed_form", "error"},
                          {"length", "elements", "iterations", "status", "sag", "closed form",
                           "error", "order", "tolerance"});
    for (const double length : problem.lengths) {
        const double expected = catenary_sag(problem.span, length);
        double last_error = 0.0;
        int last_mesh = 0;
        for (const int mesh : problem.elements) {
            const auto [report, unknowns, sag] = problem.beam.is_planar()
                                                     ? solve<2>(problem, length, mesh)
                                                     : solve<3>(problem, length, mesh);
            verdict.add(mesh, report);
            const std::string status(to_string(report.status));
            const double error = sag - expected;
            sheet.add_csv(problem.beam.element, problem.beam.rule, problem.span, length, mesh,
                          unknowns, static_cast<int>(report.steps.size()), report.iterations(),
                          status, sag, expected, error);
            const bool finer = last_mesh > 0 && mesh > last_mesh;
            const double order = finer ? std::log(std::abs(last_error / error)) /
                                             std::log(static_cast<double>(mesh) / last_mesh)
                                       : 0.0;
            std::vector<std::string> row = {ancf::number_text(length, 6),
                                            std::to_string(mesh),
                                            std::to_string(report.iterations()),
                                            status,
                                            ancf::number_text(sag, 10),
                                            ancf::number_text(expected, 10),
                                            scientific(error),
                                            finer ? fixed(order, 1) : "",
                                            ""};
            if (const Target* target = problem.target(length, mesh)) {
                verdict.deviation({"cable", mesh, expected, expected}, sag, sag, target->tolerance);
                row.back() = scientific(target->tolerance);
            }
            sheet.add_table(std::move(row));
            last_error = error;
            last_mesh = mesh;
        }
    }
    sheet.finish(problem.title());
    return verdict.good();
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        HangingChain problem;
        problem.parse(argc, argv);
        return study(problem) ? examples::exit_done : examples::exit_missed;
    });
}
