// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A very flexible pendulum: [Dufva2006, section 5.1, Figs. 5 to 7].
///
///     Y                       gravity
///     |                          |
///     o==================--- X   v      L 1.2, 0.05 x 0.05, E 0.7e6, G 2.6923e5, rho 5540
///     pin at the origin
///
/// Horizontal and at rest at first. The tip of four elements passes y = -0.194023, -1.303027,
/// -0.766241 and 0.170784 m at 0.2, 0.5, 0.8 and 1.2 s; the total energy stays zero. --link hangs
/// the beam on a massless link instead: a constraint that is not linear.

#include <ancf/dynamics/report.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>

#include <support/beam.hpp>
#include <support/command_line.hpp>
#include <support/motion.hpp>
#include <support/motion_output.hpp>
#include <support/named_beam.hpp>
#include <support/report.hpp>

#include <cmath>
#include <iostream>
#include <sstream>
#include <string>

namespace {

constexpr examples::Geometry paper = {1.2, 0.05, 0.05, 0.7e6, 2.6923e5};
constexpr double paper_density = 5540.0;  // kg/m^3
constexpr double earth = 9.81;            // m/s^2
constexpr int paper_elements = 4;

/// Height of the tip, m.
struct Passage {
    double time, height;
};
constexpr Passage passages[] = {
    {0.2, -0.194023}, {0.5, -1.303027}, {0.8, -0.766241}, {1.2, 0.170784}};

struct Pendulum {
    int elements = paper_elements;
    double density = paper_density;
    double gravity = earth;
    double link = 0.0;  // m; 0: pinned
    examples::BeamOptions beam;
    examples::MotionOptions motion{1.2, 0.05};
    examples::MotionOutputOptions output;

    void parse(int argc, char** argv);
    [[nodiscard]] std::string title() const;
    [[nodiscard]] bool is_published() const;

    /// Returns how far the tip may be from the published heights, m.
    [[nodiscard]] double tolerance() const { return motion.by_sundials() ? 2e-5 : 2e-4; }
};

void Pendulum::parse(int argc, char** argv) {
    examples::CommandLine line("A very flexible pendulum (section 5.1, Figs. 5 to 7).");
    beam.geometry = paper;
    beam.add_geometry_to(line);
    line.add_number("--density", density, examples::Range::positive, "kg/m^3");
    line.add_number("--gravity", gravity, examples::Range::finite, "m/s^2, downwards");
    line.add_number(
        "--link", link, examples::Range::positive,
        "length of a massless link from a pivot above the beam's end, m; without it the end "
        "is pinned");
    beam.add_element_to(line, examples::all_elements);
    beam.add_inertia_to(line);
    line.add_count("--elements", elements, 1, examples::most_elements, "number of elements");
    motion.add_to(line);
    output.add_to(line);
    line.parse(argc, argv);
    beam.settle(line);
    examples::check(beam);
    output.check(motion);
    motion.check(line);
}

std::string Pendulum::title() const {
    std::ostringstream text;
    text << "Pendulum, " << elements << (elements == 1 ? " element" : " elements") << ", "
         << beam.description();
    if (link > 0.0) text << ", on a link of " << link << " m";
    return text.str();
}

bool Pendulum::is_published() const {
    return elements == paper_elements && density == paper_density && gravity == earth &&
           link == 0.0 && beam.geometry.values() == paper.values() && beam.as_paper() &&
           beam.is_cross_section() && beam.element != "cross-section-pointwise" &&
           motion.restart.empty() && motion.as_accurate_as_default();
}

/// Compares the tip with the published heights as it passes them.
class Comparison {
public:
    explicit Comparison(const Pendulum& problem)
        : tolerance_(problem.tolerance()), wanted_(problem.is_published()) {}

    void see(double time, double height) {
        for (const Passage& passage : passages) {
            if (!wanted_ || std::abs(time - passage.time) > 1e-9) continue;
            const double deviation = std::abs(height - passage.height);
            if (deviation > tolerance_ || !std::isfinite(deviation)) good_ = false;
            std::cerr << "published height at " << passage.time << " s: " << passage.height
                      << " m, deviation " << examples::scientific(deviation)
                      << (deviation <= tolerance_ ? " (" : ": missed (") << "tolerance "
                      << examples::scientific(tolerance_) << ")\n";
        }
    }

    [[nodiscard]] bool good() const { return good_; }

private:
    double tolerance_;
    bool wanted_;
    bool good_ = true;
};

/// Integrates the motion and writes it; returns whether it is as published.
template <int Dimension>
bool swing(const Pendulum& problem) {
    using Point = ancf::Vector<double, Dimension>;
    ancf::BasicModel<Dimension> model;
    const auto& geometry = problem.beam.geometry;
    const auto material =
        ancf::Material::from_moduli(geometry.young, geometry.shear, problem.density);
    const auto section = problem.beam.section();
    const auto beam =
        examples::straight_beam<Dimension>(model, problem.beam, material, section, Point::Zero(),
                                           geometry.length * Point::UnitX(), problem.elements);
    if (problem.link > 0.0)
        model.add(
            ancf::Distance<Dimension>(beam.first(), problem.link * Point::Unit(1), problem.link));
    else if (problem.motion.is_explicit())
        model.pin(beam.first());  // a support, without multipliers
    else
        model.add(ancf::Pin<Dimension>(beam.first(), Point::Zero()));
    model.set_gravity(-problem.gravity * Point::Unit(1));

    examples::MotionWriter writer(model, {beam}, section, beam.last(), problem.output, "pendulum");
    Comparison comparison(problem);
    auto schedule = ancf::equal_intervals(0.0, problem.motion.duration, problem.motion.interval);
    schedule.observe = [&](const ancf::Snapshot& seen) {
        writer.write(seen);
        comparison.see(seen.state.time, model.value(beam.last(), ancf::Field::r, seen.state.q)[1]);
    };
    const auto motion = examples::integrate(model, problem.motion, schedule);
    writer.finish(problem.title());
    examples::summarise(std::cerr, problem.motion, motion);
    return motion.good() && comparison.good();
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        Pendulum problem;
        problem.parse(argc, argv);
        const bool good = problem.beam.is_planar() ? swing<2>(problem) : swing<3>(problem);
        return good ? examples::exit_done : examples::exit_missed;
    });
}
