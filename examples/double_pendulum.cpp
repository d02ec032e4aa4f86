// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A double pendulum of two flexible beams that moves in space.
///
///     Y
///     |     first beam      hinge, axis (1, 1, 0)
///     o=====================o        gravity along -Y
///     pin                  /
///     at the origin       /  second beam, along Z: out of the plane
///                        /
///
/// Horizontal and at rest at first; each beam 0.8 m, 0.05 x 0.05, E 5e6, G 1.923e6, rho 5540. The
/// hinge carries moments, so that the first beam is twisted. The tip of four elements per beam
/// passes the places below, on which the integrators agree to the digits shown as their tolerance
/// falls.

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

using Point = ancf::Vector<double, 3>;

constexpr examples::Geometry own = {0.8, 0.05, 0.05, 5.0e6, 1.923e6};
constexpr double own_density = 5540.0;  // kg/m^3
constexpr double earth = 9.81;          // m/s^2
constexpr int own_elements = 4;

/// Place of the tip, m.
struct Passage {
    double time;
    double place[3];
};
constexpr Passage passages[] = {{0.5, {0.7452981, -1.3293977, 0.2009476}},
                                {1.0, {-1.1387598, -0.7665264, -0.4330744}}};

struct DoublePendulum {
    int elements = own_elements;
    double density = own_density;
    double gravity = earth;
    examples::BeamOptions beam;
    examples::MotionOptions motion{1.0, 0.05};
    examples::MotionOutputOptions output;

    void parse(int argc, char** argv);
    [[nodiscard]] std::string title() const;
    [[nodiscard]] bool is_known() const;
};

void DoublePendulum::parse(int argc, char** argv) {
    examples::CommandLine line("A double pendulum of two flexible beams that moves in space.");
    beam.geometry = own;
    beam.add_geometry_to(line);
    line.add_number("--density", density, examples::Range::positive, "kg/m^3");
    line.add_number("--gravity", gravity, examples::Range::finite, "m/s^2, downwards");
    beam.add_element_to(line, examples::spatial_beams);
    beam.add_inertia_to(line);
    line.add_count("--elements", elements, 1, examples::most_elements,
                   "number of elements per beam");
    motion.add_to(line);
    output.add_to(line);
    line.parse(argc, argv);
    beam.settle(line);
    examples::check(beam);
    output.check(motion);
    motion.check(line);
}

std::string DoublePendulum::title() const {
    std::ostringstream text;
    text << "Double pendulum, " << elements << (elements == 1 ? " element" : " elements")
         << " per beam, " << beam.description();
    return text.str();
}

bool DoublePendulum::is_known() const {
    return elements == own_elements && density == own_density && gravity == earth &&
           beam.geometry.values() == own.values() && beam.as_paper() &&
           beam.element == "cross-section" && motion.restart.empty() &&
           motion.as_accurate_as_default();
}

/// Compares the tip with the known places as it passes them.
class Comparison {
public:
    explicit Comparison(bool wanted) : wanted_(wanted) {}

    void see(double time, const Point& place) {
        constexpr double tolerance = 1e-5;  // m
        for (const Passage& passage : passages) {
            if (!wanted_ || std::abs(time - passage.time) > 1e-9) continue;
            const double deviation = (place - Point(passage.place)).norm();
            if (!(deviation <= tolerance)) good_ = false;
            std::cerr << "known place at " << passage.time << " s: deviation "
                      << examples::scientific(deviation)
                      << (deviation <= tolerance ? " m (" : " m: missed (") << "tolerance "
                      << examples::scientific(tolerance) << ")\n";
        }
    }

    [[nodiscard]] bool good() const { return good_; }

private:
    bool wanted_;
    bool good_ = true;
};

/// Integrates the motion and writes it; returns whether it is as known.
bool swing(const DoublePendulum& problem) {
    ancf::Model model;
    const auto& geometry = problem.beam.geometry;
    const auto material =
        ancf::Material::from_moduli(geometry.young, geometry.shear, problem.density);
    const auto section = problem.beam.section();
    const auto add_beam = [&](const Point& from, const Point& to) {
        return examples::straight_beam(model, problem.beam, material, section, from, to,
                                       problem.elements);
    };
    const Point elbow(geometry.length, 0.0, 0.0);
    const auto first = add_beam(Point::Zero(), elbow);
    const auto second = add_beam(elbow, elbow + Point(0.0, 0.0, geometry.length));
    model.add(ancf::Pin<3>(first.first(), Point::Zero()));
    model.add(ancf::Revolute(model, first.last(), second.first(), Point(1.0, 1.0, 0.0)));
    model.set_gravity({0.0, -problem.gravity, 0.0});

    examples::MotionWriter writer(model, {first, second}, section, second.last(), problem.output,
                                  "double-pendulum");
    Comparison comparison(problem.is_known());
    auto schedule = ancf::equal_intervals(0.0, problem.motion.duration, problem.motion.interval);
    schedule.observe = [&](const ancf::Snapshot& seen) {
        writer.write(seen);
        comparison.see(seen.state.time, model.value(second.last(), ancf::Field::r, seen.state.q));
    };
    const auto motion = examples::integrate(model, problem.motion, schedule);
    writer.finish(problem.title());
    examples::summarise(std::cerr, problem.motion, motion);
    return motion.good() && comparison.good();
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        DoublePendulum problem;
        problem.parse(argc, argv);
        return swing(problem) ? examples::exit_done : examples::exit_missed;
    });
}
