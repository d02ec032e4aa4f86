// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The pendulum of [Dufva2006, section 5.1], 0 to 1.2 s, and the same on a massless link of 0.4 m,
/// 0 to 0.8 s, for any element and every integrator. Near 1 s the beam on the link whips, and fine
/// meshes fold.
///
/// The error is the largest distance of the tip from the reference at 0.3, 0.5, 0.7 and, where the
/// run gets there, 1 s: mesh and time together. Reference of the pendulum: the limit of the
/// element's beam theory, known to 1e-6 m. Else: 64 elements of the same kind by steps of 50 us; no
/// error below the distance of 32 elements and 100 us from it is told.

#pragma once

#include <ancf/element/cross_section_options.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <integrators.hpp>
#include <rows.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace speed {

inline constexpr std::array<double, 4> pendulum_times = {0.3, 0.5, 0.7, 1.0};  // s
using Tips = std::array<std::array<double, 2>, pendulum_times.size()>;

/// The limit of the paper's element: x, y, m.
inline constexpr Tips pendulum_limit = {
    {{1.082058, -0.446681}, {0.337547, -1.301135}, {-0.696049, -1.011694}, {-1.188550, -0.128545}}};

/// What a run gave.
struct Motion {
    ancf::Status status = ancf::Status::converged;
    int iterations = 0;
    Tips tips{};
};

template <class Element>
Motion run_pendulum(const std::string& name, const ancf::Rule& rule, int elements,
                    const ancf::bench::Integrator& integrator, double setting) {
    constexpr int dimension = Element::dimension;
    using Point = ancf::Vector<double, dimension>;
    ancf::BasicModel<Element::dimension> model;
    typename Element::Options options;
    options.rule = rule;
    if constexpr (std::is_base_of_v<ancf::CrossSectionOptions, typename Element::Options>)
        options.rotary_inertia = ancf::RotaryInertia::lumped;
    const auto material = ancf::Material::from_moduli(0.7e6, 2.6923e5, 5540.0);
    const auto section = ancf::rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    const auto beam = ancf::straight_beam<Element>(model, material, section, Point(Point::Zero()),
                                                   Point(Point::Unit(0) * 1.2), elements, options);
    if (name == "link")
        model.add(ancf::Distance<dimension>(beam.first(), Point(Point::Unit(1) * 0.4), 0.4));
    else
        model.pin(beam.first());
    model.set_gravity(Point(Point::Unit(1) * -9.81));
    const int tip = model.coordinate(beam.last(), ancf::Field::r);

    Motion motion;
    ancf::Schedule schedule = ancf::equal_intervals(0.0, name == "link" ? 0.8 : 1.2, 0.1);
    schedule.observe = [&](const ancf::Snapshot& seen) {
        for (std::size_t k = 0; k < pendulum_times.size(); ++k)
            if (std::abs(seen.state.time - pendulum_times[k]) < 1e-6)
                motion.tips[k] = {seen.state.q[tip], seen.state.q[tip + 1]};
    };
    const ancf::DynamicsReport report = integrator.integrate(model, schedule, setting);
    motion.status = report.status;
    motion.iterations = static_cast<int>(report.iterations);
    return motion;
}

inline double tip_error(const Motion& motion, const Tips& limit) {
    if (motion.status != ancf::Status::converged) return std::numeric_limits<double>::quiet_NaN();
    double largest = 0.0;
    for (std::size_t k = 0; k < limit.size(); ++k)
        largest = std::max(
            largest, std::hypot(motion.tips[k][0] - limit[k][0], motion.tips[k][1] - limit[k][1]));
    return largest;
}

/// An integrator and the values of its setting.
struct Series {
    ancf::bench::Integrator integrator;
    std::vector<double> values;
};

inline std::vector<Series> all_series(bool quick, bool constrained) {
    std::vector<Series> all;
    const auto add = [&](ancf::bench::Integrator integrator, std::vector<double> values) {
        if (quick) values = {values[1]};
        all.push_back({std::move(integrator), std::move(values)});
    };
#if ANCF_WITH_SUNDIALS
    using ancf::sundials::Form;
    add(ancf::bench::ida("ida-index3", Form::index3), {1e-4, 1e-5, 1e-6, 1e-7, 1e-8});
    add(ancf::bench::ida("ida-ggl", Form::gear_gupta_leimkuhler), {1e-4, 1e-5, 1e-6, 1e-7});
#endif
    add(ancf::bench::generalized_alpha("generalized-alpha", 0.8),
        {1.6e-2, 8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 1e-4});
    if (quick) return all;
    add(ancf::bench::adaptive_generalized_alpha("generalized-alpha-adaptive"),
        {1e-2, 1e-3, 1e-4, 1e-5, 1e-6});
    for (const int stages : {3, 5})
        add(ancf::bench::radau("radau-" + std::to_string(stages), stages),
            {1e-2, 1e-3, 1e-4, 1e-5, 1e-6});
    if (!constrained)
        add(ancf::bench::leapfrog("leapfrog"),
            {8e-3, 4e-3, 2.8e-3, 2e-3, 1.4e-3, 1e-3, 5e-4, 2.5e-4});
    add(ancf::bench::energy_momentum("energy-momentum"), {1.6e-2, 8e-3, 4e-3, 2e-3, 1e-3, 5e-4});
    return all;
}

/// Where the tip of a fine mesh goes, and how far it is known.
struct Reference {
    Tips tips;
    double doubt = 0.0;  // m
};

/// Integrates two fine meshes.
template <class Element>
Reference fine_reference(const std::string& scene, const ancf::Rule& rule, bool quick) {
    const auto best = ancf::bench::generalized_alpha("", 0.8);
    const double step = quick ? 1e-3 : 5e-5;  // s
    const int mesh = quick ? 16 : 64;
    const Motion fine = run_pendulum<Element>(scene, rule, mesh, best, step);
    const Motion coarse = run_pendulum<Element>(scene, rule, mesh / 2, best, 2.0 * step);
    ancf::detail::require(
        fine.status == ancf::Status::converged && coarse.status == ancf::Status::converged, scene,
        ": the reference did not converge");
    return {fine.tips, tip_error(coarse, fine.tips)};
}

/// Runs both pendulums with one element.
/// @param limit  whether pendulum_limit is the limit of the element's beam theory
template <class Element>
void run_pendulums(const Plan& plan, const Report& report, const std::string& name,
                   const std::vector<ancf::Rule>& rules, const ancf::Rule& fine, bool limit) {
    const std::vector<int> meshes =
        plan.quick ? std::vector<int>{8} : std::vector<int>{2, 4, 8, 16, 32};
    for (const std::string& scene : {std::string("pendulum"), std::string("link")}) {
        if (!plan.wants(scene) || (plan.quick && scene == "link")) continue;
        const Reference reference = limit && scene == "pendulum"
                                        ? Reference{pendulum_limit, 1e-6}
                                        : fine_reference<Element>(scene, fine, plan.quick);
        for (const auto& [integrator, values] : all_series(plan.quick, scene == "link"))
            for (const ancf::Rule& rule : rules)
                for (const int mesh : meshes)
                    for (const double setting : values) {
                        Motion motion;
                        const double ms = least_cpu_ms(
                            [&] {
                                motion =
                                    run_pendulum<Element>(scene, rule, mesh, integrator, setting);
                            },
                            plan.quick ? 0.0 : 60.0, 3);
                        // a step that the leapfrog refuses for this mesh is no run
                        if (integrator.name == "leapfrog" &&
                            motion.status == ancf::Status::diverged)
                            continue;
                        report({scene, name, rule.name(), integrator.name, mesh, setting,
                                std::max(tip_error(motion, reference.tips), reference.doubt), ms,
                                motion.iterations});
                    }
    }
}

}  // namespace speed
