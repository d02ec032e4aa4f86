// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Scenes that the tests of this folder share, and a record of what a run reported.

#pragma once

#include <ancf/dynamics/problem.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/sundials/ida.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace ancf_test {

using Element = ancf::CrossSectionBeam<3>;
using Scene = ancf::Model;
using Point = ancf::Vector<double, 3>;

/// A beam in a scene of its own; the scene's address stays.
struct Hanging {
    std::unique_ptr<Scene> model = std::make_unique<Scene>();
    ancf::Beam<Element> beam;

    [[nodiscard]] int tip() const { return model->coordinate(beam.last(), ancf::Field::r); }
};

/// The paper's pendulum without its support: horizontal, at rest, under gravity.
inline Hanging soft_beam(int elements, const Point& direction = Point::UnitX()) {
    Hanging scene;
    const auto rubber = ancf::Material::from_moduli(0.7e6, 2.6923e5, 5540.0);
    const auto section = ancf::rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    scene.beam = ancf::straight_beam<Element>(*scene.model, rubber, section, Point::Zero(),
                                              Point(1.2 * direction.normalized()), elements,
                                              ancf::CrossSectionOptions::paper());
    scene.model->set_gravity({0.0, -9.81, 0.0});
    return scene;
}

/// The same of steel: 2 m, 10 mm square.
inline Hanging steel_beam(int elements) {
    Hanging scene;
    const auto steel = ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0);
    const auto section = ancf::rectangle(0.01, 0.01).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    scene.beam =
        ancf::straight_beam<Element>(*scene.model, steel, section, Point::Zero(), {2.0, 0.0, 0.0},
                                     elements, ancf::CrossSectionOptions::paper());
    scene.model->set_gravity({0.0, -9.81, 0.0});
    return scene;
}

/// The paper's pendulum, its pin by multipliers.
inline Hanging pendulum(int elements) {
    Hanging scene = soft_beam(elements);
    scene.model->add(ancf::Pin<3>(scene.beam.first(), Point::Zero()));
    return scene;
}

/// The pendulum on a massless link of 0.4 m, its pivot above the beam's end.
inline Hanging link_pendulum(int elements) {
    Hanging scene = soft_beam(elements);
    scene.model->add(ancf::Distance<3>(scene.beam.first(), Point(0.0, 0.4, 0.0), 0.4));
    return scene;
}

/// A load whose value after a time is the user's trouble.
struct Trouble {
    ancf::NodeId node;
    double after;
    double value;  // returned then; NaN or a number
    bool throws;

    struct Code {
        int number;
    };

    [[nodiscard]] ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
    void evaluate(const ancf::LoadState& state, ancf::LoadResult& out) const {
        if (state.time <= after) return;
        if (throws) throw Code{42};
        out.force[1] = value;
    }
};

/// Returns the schedule of a run that is observed at these times.
inline ancf::Schedule until(double end, std::vector<double> times = {}) {
    ancf::Schedule schedule;
    schedule.end = end;
    schedule.times = std::move(times);
    return schedule;
}

/// What an observer saw at one time.
struct Row {
    ancf::State state;
    ancf::Energies energies;
    double violation, violation_rate;
};

/// A run with what was seen on the way.
struct Run {
    ancf::sundials::IdaReport report;
    std::vector<Row> rows;
};

inline Run run(ancf::DynamicProblem& problem, ancf::Schedule schedule,
               const ancf::sundials::IdaOptions& options = {}) {
    Run result;
    schedule.observe = [&](const ancf::Snapshot& seen) {
        result.rows.push_back({seen.state, seen.energies, seen.violation, seen.violation_rate});
    };
    result.report = ancf::sundials::Ida(options).integrate(problem, schedule);
    return result;
}

inline Run run(Hanging& scene, const ancf::Schedule& schedule,
               const ancf::sundials::IdaOptions& options = {}) {
    ancf::DynamicProblem problem(*scene.model);
    return run(problem, schedule, options);
}

}  // namespace ancf_test
