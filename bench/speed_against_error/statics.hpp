// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The static cases, for any element: Model II, semicircle, 45-degree bend, twist.
///
/// References are the limits that fine meshes of an element converge to. A beam of Green's strain
/// converges to another limit than one of engineering strain, by the order of the strain squared;
/// where no independent value of an element's own limit is known, a mesh of 256 of it stands in.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section_options.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/statics.hpp>

#include <rows.hpp>
#include <solvers.hpp>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace speed {

using ancf::pi;

/// A beam along X (or an arc from it), what it is made of and how it is loaded.
struct StaticCase {
    std::string name;
    double length, width, height;  ///< m; width along Z, height along Y
    double young, shear;           ///< Pa
    double correction;             ///< factor k of the shear modulus
    double load;                   ///< N or N m
};

inline const std::array<StaticCase, 4>& static_cases() {
    static const std::array<StaticCase, 4> cases = {{
        {"model2", 2.0, 0.01, 0.01, 2.07e11, 7.9615e10, 5.0 / 6.0,
         1.5 * 2.07e11 * (1e-8 / 12.0) / 4.0},
        {"semicircle", 1.0, 0.035, 0.035, 2e8, 1e8, 5.0 / 6.0,
         pi * 2e8 * (0.035 * 0.035 * 0.035 * 0.035 / 12.0)},
        {"bend45", 25.0 * pi, 1.0, 1.0, 1e7, 5e6, 1.0, 600.0},
        {"twist", 0.254, 0.00254, 0.00635, 8.27371e10, 3.17159e10, 5.0 / 6.0, 20.605},
    }};
    return cases;
}

/// Whether an element with both directors can be made stress-free on a curve.
template <class Element>
inline constexpr bool can_curve =
    Element::fields.contains(ancf::Field::r_z) &&
    std::is_constructible_v<Element, const ancf::Material&, const ancf::Section&,
                            typename Element::Coordinates, double, typename Element::Options>;

template <class Element>
inline constexpr bool is_cable = !Element::fields.contains(ancf::Field::r_y);

/// Whether an element takes part: cables do not twist, and planar ones stay in their plane.
template <class Element>
constexpr bool takes_part(const std::string_view name) {
    if (name == "bend45") return can_curve<Element>;
    if (name == "twist") return Element::fields.contains(ancf::Field::r_z);
    return true;
}

/// Whether Newton's method of mixed integration points differs from the plain one.
template <class Element>
inline constexpr bool has_mixed_newton =
    ancf::detail::offers<ancf::detail::MixedEvaluationOf, Element>;

/// What the tables add to a solver's name.
inline const char* newton_suffix(ancf::NewtonKind newton) {
    switch (newton) {
        case ancf::NewtonKind::mixed: return "+mixed-newton";
        case ancf::NewtonKind::automatic: return "+automatic-newton";
        case ancf::NewtonKind::plain: break;
    }
    return "";
}

/// Loads the end of a beam as the case has it.
template <class Element>
void add_load(ancf::BasicModel<Element::dimension>& model, const StaticCase& scene,
              ancf::NodeId end) {
    using Point = ancf::Vector<double, Element::dimension>;
    using ancf::Field;
    if (scene.name == "model2") {
        model.add(ancf::Force<Element::dimension>(end, Point(Point::Unit(1) * scene.load)));
    } else if (scene.name == "semicircle") {
        const Field slope = is_cable<Element> ? Field::r_x : Field::r_y;
        if constexpr (Element::dimension == 2)
            model.add(ancf::PlanarSlopeMoment(end, slope, scene.load));
        else
            model.add(ancf::SlopeMoment(end, slope, Point(0.0, 0.0, 1.0), scene.load));
    } else if constexpr (Element::dimension == 3 && !is_cable<Element>) {
        if (scene.name == "bend45") {
            model.add(ancf::Force<3>(end, Point(0.0, 0.0, scene.load)));
        } else {
            // divided as torsion is: the section keeps its shape
            const double height = scene.height * scene.height;
            const double share = height / (height + scene.width * scene.width);
            const Point axis = Point::UnitX();
            model.add(ancf::SlopeMoment(end, Field::r_y, axis, scene.load * share));
            model.add(ancf::SlopeMoment(end, Field::r_z, axis, scene.load * (1.0 - share)));
        }
    }
}

/// Clamps the start of a beam along X: slender elements may stretch there, those of sections shear
/// as well.
template <class Element>
void clamp(ancf::BasicModel<Element::dimension>& model, const StaticCase& scene,
           ancf::NodeId start) {
    using ancf::Field;
    if (scene.name == "bend45") return model.clamp(start);
    model.clamp(start, ancf::Clamp::free_slope);
    if (!is_cable<Element> && !std::is_same_v<Element, ancf::TorsionBeam>) return;
    for (int across = 1; across < Element::dimension; ++across)
        model.fix(start, Field::r_x, across);
}

/// The tip after loading: its position, and the angle of r_y about X where the case is the twist.
struct Tip {
    ancf::Status status = ancf::Status::converged;
    int iterations = 0;
    ancf::Vector<double, 3> place = ancf::Vector<double, 3>::Zero();
    double angle = 0.0;
};

template <class Element>
Tip solve(const StaticCase& scene, const ancf::Rule& rule, const std::string& solver_name,
          int elements, const ancf::StaticsOptions& options) {
    using Point = ancf::Vector<double, Element::dimension>;
    ancf::BasicModel<Element::dimension> model;
    typename Element::Options element_options;
    element_options.rule = rule;
    if constexpr (std::is_same_v<typename Element::Options, ancf::QuinticOptions>)
        element_options.section_model = ancf::SectionModel::paper;  // as of the others
    const auto material = ancf::Material::from_moduli(scene.young, scene.shear, 7850.0);
    const auto section = ancf::rectangle(scene.width, scene.height)
                             .with_shear_correction(scene.correction, scene.correction);
    ancf::Beam<Element> beam;
    if (scene.name == "bend45") {
        if constexpr (can_curve<Element>)
            beam = ancf::arc<Element>(model, material, section, Point(0, 0, 0), Point(1, 0, 0),
                                      Point(0, 1, 0), scene.length / (pi / 4.0), pi / 4.0, elements,
                                      element_options);
    } else {
        beam = ancf::straight_beam<Element>(model, material, section, Point(Point::Zero()),
                                            Point(Point::Unit(0) * scene.length), elements,
                                            element_options);
    }
    clamp<Element>(model, scene, beam.first());
    add_load<Element>(model, scene, beam.last());
    const std::unique_ptr<ancf::LinearSolver> solver = ancf::bench::solver_named(solver_name);
    const ancf::StaticsReport report = ancf::solve_statics(model, *solver, options);
    Tip tip;
    tip.status = report.status;
    tip.iterations = report.iterations();
    tip.place.template head<Element::dimension>() = model.position(beam.last());
    if constexpr (Element::dimension == 3 && !is_cable<Element>) {
        const int at = model.coordinate(beam.last(), ancf::Field::r_y);
        tip.angle = std::atan2(model.state().q[at + 2], model.state().q[at + 1]);
    }
    return tip;
}

/// Returns the angle of uniform twist of a rigid section of Green's strain, free to shorten.
///
/// The torque is k G I_p w + E (I_rr - I_p^2/A) w^3/2, w the twist per length, I_rr the integral of
/// r^4.
inline double uniform_twist(const StaticCase& scene) {
    const double b = scene.width, h = scene.height, area = b * h;
    const double polar = area * (b * b + h * h) / 12.0;
    const double fourth = area * ((b * b * b * b + h * h * h * h) / 80.0 + b * b * h * h / 72.0);
    const double linear = scene.correction * scene.shear * polar;
    const double cubic = 0.5 * scene.young * (fourth - polar * polar / area);
    double rate = scene.load / linear;
    for (int k = 0; k < 50; ++k)
        rate -= (linear * rate + cubic * rate * rate * rate - scene.load) /
                (linear + 3.0 * cubic * rate * rate);
    return rate * scene.length;
}

/// Returns the end of an arc of circle from the origin along X.
inline ancf::Vector<double, 3> arc_end(double length, double angle) {
    return {length / angle * std::sin(angle), length / angle * (1.0 - std::cos(angle)), 0.0};
}

/// Returns the limit of fine meshes where it is known independently.
template <class Element>
std::optional<Tip> known_limit(const StaticCase& scene) {
    constexpr bool torsion = std::is_same_v<Element, ancf::TorsionBeam>;
    Tip limit;
    if (scene.name == "twist") {
        limit.angle = uniform_twist(scene);
        return limit;
    }
    if (scene.name == "semicircle") {
        const double area = scene.width * scene.height;
        const double axial = scene.young * area;
        const double bending = axial * scene.height * scene.height / 12.0;
        if (torsion) {
            limit.place = arc_end(scene.length, scene.load * scene.length / bending);
        } else if (is_cable<Element>) {
            // EA (l^2 - 1)/2 = EI k^2/l^2, k = M l/EI: bending by the true curvature k stretches it
            const double square = 1.0 + 2.0 * scene.load * scene.load / (axial * bending);
            limit.place = arc_end(scene.length * std::sqrt(square),
                                  scene.load * scene.length * square / bending);
        } else {
            limit.place = {-0.003648082997, 0.633306343961, 0.0};
        }
        return limit;
    }
    if (scene.name != "model2" || torsion || is_cable<Element>) return std::nullopt;
    limit.place = {1.784108719196, 0.821973318973, 0.0};
    return limit;
}

/// Returns the limit: the known one, or a fine mesh that is loaded in ten steps.
template <class Element>
Tip limit_of(const StaticCase& scene, const ancf::Rule& rule, int elements) {
    if (const auto known = known_limit<Element>(scene)) return *known;
    ancf::StaticsOptions options;
    options.adaptive = true;
    options.steps = 10;
    return solve<Element>(scene, rule, "block-tridiagonal", elements, options);
}

/// Returns how far a tip is from its limit, relative to the length; radians for the twist.
inline double tip_error(const StaticCase& scene, const Tip& tip, const Tip& limit) {
    if (tip.status != ancf::Status::converged) return std::numeric_limits<double>::quiet_NaN();
    if (scene.name == "twist") return std::abs(std::remainder(tip.angle - limit.angle, 2.0 * pi));
    return (tip.place - limit.place).norm() / scene.length;
}

/// Runs every static case with one element: rules, linear solvers, meshes.
/// @param fine  the rule of the fine mesh that stands in for a limit
template <class Element>
void run_statics(const Plan& plan, const Report& report, const std::string& name,
                 const std::vector<ancf::Rule>& rules, const ancf::Rule& fine) {
    ancf::StaticsOptions options;
    options.adaptive = true;
    const std::vector<int> meshes =
        plan.quick ? std::vector<int>{4, 16} : std::vector<int>{1, 2, 3, 4, 6, 8, 12, 16, 32, 64};
    const std::string usual = "block-tridiagonal";
    std::vector<std::string> solvers = {usual};
    if (!plan.quick) solvers.emplace_back("eigen-ldlt");
    if (!plan.quick && ANCF_WITH_SUITESPARSE) solvers.emplace_back("cholmod");
    for (const StaticCase& scene : static_cases()) {
        if (!takes_part<Element>(scene.name) || !plan.wants(scene.name)) continue;
        const Tip limit = limit_of<Element>(scene, fine, plan.quick ? 64 : 256);
        if (limit.status != ancf::Status::converged) {
            std::cerr << scene.name << ", " << name << ": the reference mesh did not converge\n";
            continue;
        }
        const auto run = [&](const ancf::Rule& rule, const std::string& solver, int mesh) {
            Tip tip;
            const double ms =
                least_cpu_ms([&] { tip = solve<Element>(scene, rule, solver, mesh, options); },
                             plan.quick ? 0.0 : 20.0, 30);
            report({scene.name, name, rule.name(), solver + newton_suffix(options.newton), mesh,
                    options.residual_tolerance, tip_error(scene, tip, limit), ms, tip.iterations});
        };
        for (const ancf::Rule& rule : rules)
            for (const int mesh : meshes) {
                options.newton = ancf::NewtonKind::plain;
                for (const std::string& solver : solvers) run(rule, solver, mesh);
                for (const auto newton : {ancf::NewtonKind::mixed, ancf::NewtonKind::automatic}) {
                    options.newton = newton;
                    if (has_mixed_newton<Element>) run(rule, usual, mesh);
                }
            }
    }
}

}  // namespace speed
