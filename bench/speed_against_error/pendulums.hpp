// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The pendulum of [Dufva2006, section 5.1] and the same on a massless link of 0.4 m, 0 to 1.2 s,
/// for any element and every integrator.
///
/// The error is the largest distance of the tip from the reference at 0.3, 0.5, 0.7 and 1 s: mesh
/// and time together. Reference of the pendulum: the limit of the element's beam theory, known to
/// 1e-6 m. Else: 16 elements of the same kind at a far smaller tolerance.

#pragma once

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/model/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#if ANCF_WITH_SUITESPARSE
#include <ancf/suitesparse/umfpack.hpp>
#else
#include <ancf/solver/eigen_solver.hpp>
#endif
#if ANCF_WITH_SUNDIALS
#include <ancf/sundials/ida.hpp>
#endif

#include <rows.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace speed {

#if ANCF_WITH_SUITESPARSE
using GeneralSolver = ancf::suitesparse::Umfpack;
#else
using GeneralSolver = ancf::EigenLu;
#endif

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

/// One integrator, with the values of its one setting.
template <class Scene>
struct Integrator {
    std::string name;
    std::vector<double> settings;  // tolerances, or steps in s
    std::function<ancf::DynamicsReport(ancf::DynamicProblem<Scene>&, const ancf::Schedule&, double)>
        integrate;
};

template <class Element>
Motion run_pendulum(const std::string& name, const ancf::Rule& rule, int elements,
                    const Integrator<ancf::Model<Element>>& integrator, double setting) {
    constexpr int dimension = Element::dimension;
    using Point = ancf::Vector<double, dimension>;
    ancf::Model<Element> model;
    typename Element::Options options;
    options.rule = rule;
    const auto material = ancf::Material::from_moduli(0.7e6, 2.6923e5, 5540.0);
    const auto section = ancf::rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    const auto beam = ancf::straight_beam(model, material, section, Point(Point::Zero()),
                                          Point(Point::Unit(0) * 1.2), elements, options);
    if (name == "link")
        model.add(ancf::Distance<dimension>(beam.first(), Point(Point::Unit(1) * 0.4), 0.4));
    else
        model.add(ancf::Pin<dimension>(beam.first(), Point(Point::Zero())));
    model.set_gravity(Point(Point::Unit(1) * -9.81));
    const int tip = model.coordinate(beam.last(), ancf::Field::r);

    ancf::DynamicProblem<ancf::Model<Element>> problem(model);
    Motion motion;
    ancf::Schedule schedule = ancf::equal_intervals(0.0, 1.2, 0.1);
    schedule.observe = [&](const ancf::Snapshot& seen) {
        for (std::size_t k = 0; k < pendulum_times.size(); ++k)
            if (std::abs(seen.state.time - pendulum_times[k]) < 1e-6)
                motion.tips[k] = {seen.state.q[tip], seen.state.q[tip + 1]};
    };
    const ancf::DynamicsReport report = integrator.integrate(problem, schedule, setting);
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

#if ANCF_WITH_SUNDIALS
template <class Scene>
Integrator<Scene> ida(std::string name, ancf::sundials::Form form, std::vector<double> settings) {
    return {std::move(name), std::move(settings),
            [form](ancf::DynamicProblem<Scene>& problem, const ancf::Schedule& schedule,
                   double tolerance) {
                ancf::sundials::IdaOptions options;
                options.form = form;
                options.tolerance = tolerance;
                options.follow_energy = false;
                return ancf::sundials::Ida(options).integrate(problem, schedule);
            }};
}
#endif

template <class Scene>
Integrator<Scene> generalized_alpha(std::vector<double> steps) {
    return {"generalized-alpha", std::move(steps),
            [](ancf::DynamicProblem<Scene>& problem, const ancf::Schedule& schedule, double step) {
                ancf::GeneralizedAlphaOptions options;
                options.rho = 0.8;
                options.step = step;
                options.follow_energy = false;
                GeneralSolver solver;
                return ancf::GeneralizedAlpha(options).integrate(problem, solver, schedule);
            }};
}

template <class Scene>
Integrator<Scene> adaptive_generalized_alpha(std::vector<double> tolerances) {
    return {
        "generalized-alpha-adaptive", std::move(tolerances),
        [](ancf::DynamicProblem<Scene>& problem, const ancf::Schedule& schedule, double tolerance) {
            ancf::GeneralizedAlphaOptions options;
            options.tolerance = tolerance;
            options.step = 1e-4;
            options.follow_energy = false;
            GeneralSolver solver;
            return ancf::GeneralizedAlpha(options).integrate(problem, solver, schedule);
        }};
}

template <class Scene>
Integrator<Scene> energy_momentum(std::vector<double> steps) {
    return {"energy-momentum", std::move(steps),
            [](ancf::DynamicProblem<Scene>& problem, const ancf::Schedule& schedule, double step) {
                ancf::EnergyMomentumOptions options;
                options.step = step;
                options.follow_energy = false;
                GeneralSolver solver;
                return ancf::EnergyMomentum(options).integrate(problem, solver, schedule);
            }};
}

template <class Scene>
std::vector<Integrator<Scene>> integrators(bool quick) {
    std::vector<Integrator<Scene>> all;
#if ANCF_WITH_SUNDIALS
    using ancf::sundials::Form;
    const std::vector<double> loose = {1e-4};
    all.push_back(ida<Scene>("ida-index3", Form::index3,
                             quick ? loose : std::vector<double>{1e-4, 1e-5, 1e-6, 1e-7, 1e-8}));
    all.push_back(ida<Scene>("ida-ggl", Form::gear_gupta_leimkuhler,
                             quick ? loose : std::vector<double>{1e-3, 1e-4, 1e-5, 1e-6, 1e-7}));
#endif
    all.push_back(
        generalized_alpha<Scene>(quick ? std::vector<double>{8e-3}
                                       : std::vector<double>{8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 1e-4}));
    if (quick) return all;
    all.push_back(adaptive_generalized_alpha<Scene>({1e-3, 1e-4, 1e-5, 1e-6}));
    all.push_back(energy_momentum<Scene>({8e-3, 4e-3, 2e-3, 1e-3, 5e-4}));
    return all;
}

/// Runs both pendulums with one element.
/// @param limit  whether pendulum_limit is the limit of the element's beam theory
template <class Element>
void run_pendulums(const Plan& plan, const Report& report, const std::string& name,
                   const std::vector<ancf::Rule>& rules, const ancf::Rule& fine, bool limit) {
    using Scene = ancf::Model<Element>;
    const std::vector<int> meshes =
        plan.quick ? std::vector<int>{8} : std::vector<int>{2, 4, 8, 16};
    for (const std::string& scene : {std::string("pendulum"), std::string("link")}) {
        if (!plan.wants(scene) || (plan.quick && scene == "link")) continue;
        Tips exact = pendulum_limit;
        if (!limit || scene == "link") {
#if ANCF_WITH_SUNDIALS
            const auto best = ida<Scene>("", ancf::sundials::Form::gear_gupta_leimkuhler, {});
            const double setting = plan.quick ? 1e-5 : 1e-8;
#else
            const auto best = generalized_alpha<Scene>({});
            const double setting = plan.quick ? 1e-3 : 1e-4;
#endif
            exact = run_pendulum<Element>(scene, fine, plan.quick ? 8 : 16, best, setting).tips;
        }
        for (const auto& integrator : integrators<Scene>(plan.quick))
            for (const ancf::Rule& rule : rules)
                for (const int mesh : meshes)
                    for (const double setting : integrator.settings) {
                        Motion motion;
                        const double ms = least_cpu_ms(
                            [&] {
                                motion =
                                    run_pendulum<Element>(scene, rule, mesh, integrator, setting);
                            },
                            plan.quick ? 0.0 : 60.0, 3);
                        report({scene, name, rule.name(), integrator.name, mesh, setting,
                                tip_error(motion, exact), ms, motion.iterations});
                    }
    }
}

}  // namespace speed
