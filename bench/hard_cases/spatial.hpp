// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Hard cases of spatial beams, for any element type.
///
/// Reference values are those of beam theory by independent solvers: inextensible elastica,
/// Green-strain and Reissner's limits, Saint-Venant's torsion.

#pragma once

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/constraints/joints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <hard_cases/cases.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace hard_cases {

using Point = ancf::Vector<double, 3>;

/// Whether bending off the section's axes is of the same order as about them.
template <class Element>
inline constexpr bool keeps_order = false;
template <class Directors, class Measure, class Line>
inline constexpr bool
    keeps_order<ancf::CrossSectionBeam<3, Directors, ancf::LinearShear, Measure, Line>> =
        !std::is_same_v<Directors, ancf::Projected>;

/// Whether an element converges to Reissner's beam.
template <class Element>
inline constexpr bool is_reissner = false;
template <class Directors, class Line>
inline constexpr bool is_reissner<
    ancf::CrossSectionBeam<3, Directors, ancf::LinearShear, ancf::EngineeringMeasure, Line>> = true;

/// What the cases of one element type and rule share.
template <class Element>
class Spatial {
public:
    using Scene = ancf::BasicModel<Element::dimension>;
    using Options = typename Element::Options;
    /// Whether torsion follows the section's torsion constant on request.
    static constexpr bool warps = std::is_base_of_v<ancf::CrossSectionOptions, Options>;

    /// @param tip  limit of the slender cantilever: that of the element's measure of strain
    Spatial(std::string element, Options options, ancf::Vector<double, 2> tip)
        : element_(std::move(element)), options_(std::move(options)), tip_(std::move(tip)) {}

    /// Returns the cases of bending alone.
    [[nodiscard]] std::vector<Case> bending_cases() const {
        const Spatial self = *this;
        const std::vector<Case> all = {
            {"slender_cantilever",
             [self](Rows& rows, bool quick) { self.cantilever(rows, quick, 0.0); }},
            {"slender_cantilever_45",
             [self](Rows& rows, bool quick) { self.cantilever(rows, quick, 0.25 * pi); }},
            {"elastica", [self](Rows& rows, bool quick) { self.elastica(rows, quick); }},
            {"small_load", [self](Rows& rows, bool quick) { self.small_load(rows, quick); }},
            {"deep_cantilever", [self](Rows& rows, bool quick) { self.deep(rows, quick); }},
            {"slenderness", [self](Rows& rows, bool quick) { self.slenderness(rows, quick); }},
            {"random_mesh", [self](Rows& rows, bool quick) { self.random_mesh(rows, quick); }},
            {"semicircle", [self](Rows& rows, bool quick) { self.rolled(rows, quick, 0.5); }},
            {"two_circles", [self](Rows& rows, bool quick) { self.rolled(rows, quick, 2.0); }},
            {"four_circles", [self](Rows& rows, bool quick) { self.rolled(rows, quick, 4.0); }},
            {"poisson", [self](Rows& rows, bool quick) { self.poisson(rows, quick); }},
        };
        return of_element(element_, all);
    }

    /// Returns the cases of straight beams.
    [[nodiscard]] std::vector<Case> straight_cases() const {
        const Spatial self = *this;
        std::vector<Case> all = bending_cases();
        const std::vector<Case> others = {
            {"twist_180", [self](Rows& rows, bool quick) { self.twisted(rows, quick, 0.5); }},
            {"twist_720", [self](Rows& rows, bool quick) { self.twisted(rows, quick, 2.0); }},
            {"lateral_buckling", [self](Rows& rows, bool quick) { self.lateral(rows, quick); }},
            {"frequencies", [self](Rows& rows, bool quick) { self.frequencies(rows, quick); }},
            {"end_thrust", [self](Rows& rows, bool quick) { self.end_thrust(rows, quick); }},
        };
        all.insert(all.end(), others.begin(), others.end());
        return of_element(element_, all);
    }

    /// Returns the cases of curved, twisted and narrow beams.
    [[nodiscard]] std::vector<Case> curved_cases() const {
        const Spatial self = *this;
        const std::vector<Case> all = {
            {"bend_45", [self](Rows& rows, bool quick) { self.bend(rows, quick); }},
            {"princeton", [self](Rows& rows, bool quick) { self.princeton(rows, quick); }},
            {"pretwisted", [self](Rows& rows, bool quick) { self.pretwisted(rows, quick); }},
            {"twist_180_torques", [self](Rows& rows, bool quick) { self.half_turn(rows, quick); }},
            {"lateral_buckling_path",
             [self](Rows& rows, bool quick) { self.lateral_path(rows, quick); }},
        };
        return of_element(element_, all);
    }

    /// Returns all of these.
    [[nodiscard]] std::vector<Case> cases() const {
        std::vector<Case> all = straight_cases();
        for (Case& one : curved_cases()) all.push_back(std::move(one));
        return all;
    }

    /// Ibrahimbegovic's helix: ten turns by an end moment and a force fixed in space.
    ///
    /// The radius of curvature falls below half the depth of the section, which Reissner's beam has
    /// rigid: so have the nodes here. Bending takes three points there: with two the work of the
    /// moment on uneven |r_x| makes the mesh buckle at M = sqrt(EA EI)/2, which is eight turns.
    void helix(Rows& rows, bool quick) const {
        for (const double load : {0.05, 1.0}) {
            if (quick && load == 1.0) continue;
            const bool whole = load == 1.0;
            Row row = make(whole ? "helix_ten_turns" : "helix", 100, whole ? 2e-4 : 1e-6);
            const double start = now();
            Scene scene;
            ancf::Moments moments;
            moments.area = 1.0;
            moments.yy = moments.zz = 0.01;
            const auto section = ancf::Section::from_moments(moments)
                                     .with_shear_correction(1.0, 1.0)
                                     .with_torsion_constant(0.01);
            const auto beam = ancf::straight_beam<Element>(
                scene, ancf::Material::from_moduli(1e4, 1e4, 1.0), section, {0, 0, 0}, {10, 0, 0},
                row.elements, options(ancf::SectionModel::saint_venant));
            scene.clamp(beam.first(), ancf::Clamp::free_slope);
            for (const ancf::NodeId node : beam.nodes)
                if (node != beam.first()) scene.add(ancf::RigidSection(node));
            scene.add(ancf::Moment(beam.last(), {0, 0, 200.0 * pi * load}));
            scene.add(ancf::Force<3>(beam.last(), {0, 0, 50.0 * load}));
            solve(scene, row, false);
            // Reissner's beam by shooting; the tip tells more than the turns
            const Point theory = whole ? Point(0.004803250, 0.000072497, -0.076441742)
                                       : Point(0.711481028872, 6.285664430813, 2.750736205012);
            row.error = (scene.position(beam.last()) - theory).norm() / 10.0;
            finish(rows, row, start);
        }
    }

private:
    [[nodiscard]] Options options(ancf::SectionModel model = ancf::SectionModel::paper) const {
        Options result = options_;
        if constexpr (warps)
            result.section_model = model;
        else
            static_cast<void>(model);
        return result;
    }

    [[nodiscard]] Row make(std::string name, int elements, double limit) const {
        return make_row(element_, options_.rule.name(), std::move(name), elements, limit);
    }

    /// Returns what the element makes of E I of a square: with Hooke's law the continuum beam is as
    /// stiff as if its sides were held.
    [[nodiscard]] double bending(const ancf::Material& material, double height) const {
        double young = material.young;
        if constexpr (!warps)
            if (options_.material == ancf::ContinuumMaterial::hooke) {
                const double nu = 0.5 * material.young / material.shear - 1.0;
                young *= (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
            }
        return young * std::pow(height, 4) / 12.0;
    }

    /// Whether errors fall with the fourth power of the element's length.
    [[nodiscard]] bool fourth_order(double angle) const {
        return options_.rule.name() == "mixed" && (angle == 0.0 || keeps_order<Element>);
    }

    static void finish(Rows& rows, Row& row, double start) {
        row.seconds = now() - start;
        if (!warps && row.status == "converged" && row.error > row.limit) row.status = "locked";
        rows.push_back(row);
    }

    /// Solves in one load step; a moment fixed in space has an unsymmetric stiffness.
    static void solve(Scene& scene, Row& row, bool symmetric = true) {
        ancf::StaticsOptions how;
        how.adaptive = true;
        ancf::EigenLdlt lower;
        ancf::EigenLu full;
        set(row, symmetric ? ancf::solve_statics(scene, lower, how)
                           : ancf::solve_statics(scene, full, how));
    }

    /// Follows the path to its first critical point, which theory has at the full load.
    static ancf::PathReport follow(Scene& scene, Row& row) {
        ancf::PathOptions how;
        how.first_step = 0.5;
        how.max_points = 50;
        how.progress = [](const ancf::PathPoint& point, const ancf::State&) {
            return point.negative_pivots == 0;
        };
        ancf::EigenLdlt solver;
        auto report = ancf::follow_path(scene, solver, how);
        set(row, report);
        row.error = report.critical.empty() ? 1.0 : std::abs(report.critical.front().factor - 1.0);
        return report;
    }

    /// Returns a section without fourth moments, to which Wagner's term is proportional.
    static ancf::Section to_second_order(const ancf::Section& section) {
        ancf::Moments moments = section.moments();
        moments.yyyy = moments.yyzz = moments.zzzz = 0.0;
        return ancf::Section::from_moments(moments)
            .with_shear_correction(section.shear_correction_y(), section.shear_correction_z())
            .with_torsion_constant(section.torsion_constant());
    }

    /// Returns the turns of a slope from node to node, summed along the beam.
    template <class Beam>
    static double turns(const Scene& scene, const Beam& beam, ancf::Field slope) {
        double sum = 0.0;
        for (int k = beam.first().index; k < beam.last().index; ++k) {
            const Point a = value(scene, {k}, slope), b = value(scene, {k + 1}, slope);
            sum += std::atan2(ancf::cross<double>(a, b).norm(), a.dot(b));
        }
        return sum / (2.0 * pi);
    }

    static Point value(const Scene& scene, ancf::NodeId node, ancf::Field field) {
        return scene.state().q.template segment<3>(scene.coordinate(node, field));
    }

    /// The paper's slender cantilever, its load turned against the section.
    void cantilever(Rows& rows, bool quick, double angle) const {
        const double length = 2.0, height = 0.01;
        const auto material = ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0);
        const double force = 1.5 * bending(material, height) / (length * length);
        for (const int elements : {1, 2, 4, 8, 16}) {
            if (quick && elements > 4) break;
            // the paper's rule, or projected directors off the axes
            Row row =
                make(angle == 0.0 ? "slender_cantilever" : "slender_cantilever_45", elements,
                     fourth_order(angle) ? 0.05 / std::pow(elements, 4) + (angle > 0.0 ? 1e-6 : 0.0)
                                         : 0.12 / (elements * elements));
            const double start = now();
            Scene scene;
            const auto beam =
                ancf::straight_beam<Element>(scene, material, ancf::rectangle(height, height),
                                             {0, 0, 0}, {length, 0, 0}, elements, options());
            scene.clamp(beam.first(), ancf::Clamp::free_slope);
            const Point across(0.0, std::cos(angle), std::sin(angle));
            scene.add(ancf::Force<3>(beam.last(), force * across));
            solve(scene, row);
            const Point tip = scene.position(beam.last());
            row.error = std::hypot(tip[0] - tip_[0], tip.dot(across) - tip_[1]) / length;
            finish(rows, row, start);
        }
    }

    /// Returns the tip of a cantilever along X under a dead force along Y.
    Point loaded_tip(Row& row, const ancf::Material& material, const ancf::Section& section,
                     double length, double force) const {
        Scene scene;
        const auto beam = ancf::straight_beam<Element>(scene, material, section, {0, 0, 0},
                                                       {length, 0, 0}, row.elements, options());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        scene.add(ancf::Force<3>(beam.last(), {0, force, 0}));
        solve(scene, row);
        return scene.position(beam.last());
    }

    /// The elastica of P L^2/E I = 1, 2 and 5.
    void elastica(Rows& rows, bool quick) const {
        const std::array<std::pair<int, Point>, 3> theory{{
            {1, {0.943566763717, 0.301720773800, 0}},
            {2, {0.839358279175, 0.493457480397, 0}},
            {5, {0.612371639276, 0.713791523612, 0}},
        }};
        const double height = 1e-3;
        const auto material = ancf::Material::from_moduli(1e9, 4e8, 1000.0);
        for (const auto& [load, tip] : theory) {
            const int elements = quick ? 8 : 16;
            Row row = make("elastica_" + std::to_string(load), elements,
                           (fourth_order(0.0) ? 0.5 : 50.0) / std::pow(elements, 4) + 2e-6);
            const double start = now();
            row.error = (loaded_tip(row, material, ancf::rectangle(height, height), 1.0,
                                    load * bending(material, height)) -
                         tip)
                            .norm();
            finish(rows, row, start);
        }
    }

    /// Nachbagauer's cantilever under a small load: deflection and shortening of the linear theory
    /// and its first correction, relative to the deflection.
    void small_load(Rows& rows, bool) const {
        Row row = make("small_load", 8, 2e-5);
        const double start = now();
        const double nu = 0.3, k = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
        const Point tip =
            loaded_tip(row, ancf::Material::isotropic(2.07e11, nu, 7850.0),
                       ancf::rectangle(0.1, 0.5).with_shear_correction(k, k), 2.0, 62500.0);
        const double deflection = 8.0990325397694e-4;
        row.error = std::hypot(tip[0] - 2.0 + 1.8884916405833e-7, tip[1] - deflection) / deflection;
        finish(rows, row, start);
    }

    /// The paper's deep cantilever.
    void deep(Rows& rows, bool) const {
        Row row = make("deep_cantilever", 8, 1e-8);
        const double start = now();
        const Point tip = loaded_tip(
            row, ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0),
            ancf::rectangle(0.1, 0.5).with_shear_correction(5.0 / 6.0, 5.0 / 6.0), 2.0, 2.5e6);
        const Point theory = is_reissner<Element> ? Point(1.999697522945, 0.032416944776, 0)
                                                  : Point(1.999685750816, 0.032417241810, 0);
        row.error = (tip - theory).norm() / 2.0;
        finish(rows, row, start);
    }

    /// The elastica of P L^2/E I = 10 for sections of 1/10 to 1/10^6 of the length.
    void slenderness(Rows& rows, bool quick) const {
        for (const double height : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
            if (quick && height < 1e-3) break;
            // the beam's own extension and shear, and the mesh
            Row row =
                make("slenderness_" + std::to_string(std::lround(1.0 / height)), quick ? 8 : 64,
                     2.0 * height * height + (quick               ? 2e-2
                                              : fourth_order(0.0) ? 2e-7
                                                                  : 1e-4));
            const double start = now();
            Scene scene;
            const auto material = ancf::Material::from_moduli(1e9, 4e8, 1000.0);
            const auto beam =
                ancf::straight_beam<Element>(scene, material, ancf::rectangle(height, height),
                                             {0, 0, 0}, {1, 0, 0}, row.elements, options());
            scene.clamp(beam.first(), ancf::Clamp::free_slope);
            scene.add(ancf::Force<3>(beam.last(), {0, 10.0 * bending(material, height), 0}));
            solve(scene, row);
            row.error =
                (scene.position(beam.last()) - Point(0.445004402246, 0.810609024880, 0)).norm();
            finish(rows, row, start);
        }
    }

    /// The paper's slender cantilever of a nearly incompressible material, which must not lock.
    void poisson(Rows& rows, bool quick) const {
        for (const double nu : {0.49, 0.4999}) {
            Row row = make(nu == 0.49 ? "poisson_0.49" : "poisson_0.4999", quick ? 4 : 8,
                           quick ? 6e-3 : 1e-3);
            const double start = now();
            Scene scene;
            const double length = 2.0, height = 0.01;
            const auto material = ancf::Material::isotropic(2.07e11, nu, 7850.0);
            const auto beam =
                ancf::straight_beam<Element>(scene, material, ancf::rectangle(height, height),
                                             {0, 0, 0}, {length, 0, 0}, row.elements, options());
            scene.clamp(beam.first(), ancf::Clamp::free_slope);
            const double force = 1.5 * bending(material, height) / (length * length);
            scene.add(ancf::Force<3>(beam.last(), {0, force, 0}));
            solve(scene, row);
            // its softer shear moves the tip by 1e-5 of the length
            row.error = (scene.position(beam.last()) - Point(tip_[0], tip_[1], 0)).norm() / length;
            finish(rows, row, start);
        }
    }

    /// The slender cantilever of elements whose lengths differ by up to 1e4.
    void random_mesh(Rows& rows, bool quick) const {
        for (std::uint64_t seed = 1; seed <= (quick ? 1U : 3U); ++seed) {
            constexpr int elements = 32;  // the longest a third of the beam
            Row row = make("random_mesh_" + std::to_string(seed), elements,
                           fourth_order(0.0) ? 1.5e-3 : 0.01);
            const double start = now();
            std::vector<double> lengths;
            double sum = 0.0;
            std::uint64_t state = 0x9e3779b97f4a7c15ULL * seed;
            for (int k = 0; k < elements; ++k) {
                state = 6364136223846793005ULL * state + 1442695040888963407ULL;
                const double uniform = static_cast<double>(state >> 11) * 0x1p-53;
                // both ends of the range are there
                const double exponent = k == 0 ? -4.0 : k == 1 ? 0.0 : -4.0 * uniform;
                lengths.push_back(std::pow(10.0, exponent));
                sum += lengths.back();
            }
            Scene scene;
            const double length = 2.0, height = 0.01;
            const auto material = ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0);
            double x = 0.0;
            const ancf::NodeId root = scene.add_node({0, 0, 0});
            ancf::NodeId last = root;
            for (const double part : lengths) {
                const double own = part / sum * length;
                const ancf::NodeId next = scene.add_node({x += own, 0, 0});
                scene.template connect<Element>(
                    scene.add_prototype(
                        Element(material, ancf::rectangle(height, height), own, options())),
                    last, next);
                last = next;
            }
            scene.clamp(root, ancf::Clamp::free_slope);
            const double force = 1.5 * bending(material, height) / (length * length);
            scene.add(ancf::Force<3>(last, {0, force, 0}));
            solve(scene, row);
            row.error = (scene.position(last) - Point(tip_[0], tip_[1], 0)).norm() / length;
            finish(rows, row, start);
        }
    }

    /// An end moment that rolls the beam up.
    void rolled(Rows& rows, bool quick, double circles) const {
        const bool semicircle = circles == 0.5;
        const int elements = semicircle ? 8 : static_cast<int>(10.0 * circles);
        if (quick && circles > 2.0) return;
        Row row = make(semicircle       ? "semicircle"
                       : circles == 2.0 ? "two_circles"
                                        : "four_circles",
                       elements,
                       semicircle             ? 5e-4
                       : is_reissner<Element> ? 2e-3
                                              : 0.01);
        const double start = now();
        Scene scene;
        const double height = semicircle ? 0.035 : 0.005;
        const auto material = ancf::Material::from_moduli(2e8, 1e8, 1000.0);
        const auto beam =
            ancf::straight_beam<Element>(scene, material, ancf::rectangle(height, height),
                                         {0, 0, 0}, {1, 0, 0}, elements, options());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        const double moment = 2.0 * pi * circles * bending(material, height);
        scene.add(ancf::Moment(beam.last(), {0, 0, moment}));
        solve(scene, row, false);
        Point theory(0, semicircle ? 2.0 / pi : 0.0, 0);
        if (semicircle && !is_reissner<Element>) theory = {-0.003648082997, 0.633306343961, 0};
        row.error = (scene.position(beam.last()) - theory).norm();
        finish(rows, row, start);
    }

    /// The paper's twisted bar; angle against k G Ip.
    void twisted(Rows& rows, bool quick, double revolutions) const {
        (void)quick;
        const int elements = revolutions < 1.0 ? 5 : 20;
        Row row = make(revolutions < 1.0 ? "twist_180" : "twist_720", elements,
                       revolutions < 1.0 ? 0.01 : 0.015);
        const double start = now();
        Scene scene;
        const double length = 0.254, width = 0.00254, height = 0.00635, shear = 3.17159e10;
        const auto beam = ancf::straight_beam<Element>(
            scene, ancf::Material::from_moduli(8.27371e10, shear, 2700.0),
            ancf::rectangle(width, height), {0, 0, 0}, {length, 0, 0}, elements, options());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        const double polar = width * height * (width * width + height * height) / 12.0;
        const double torque = 5.0 / 6.0 * shear * polar * 2.0 * pi * revolutions / length;
        scene.add(ancf::Moment(beam.last(), {torque, 0, 0}));
        solve(scene, row, false);
        row.error = std::abs(turns(scene, beam, ancf::Field::r_y) / revolutions - 1.0);
        finish(rows, row, start);
    }

    /// The paper's bar under the torque of half a turn: k G Ip with Wagner's term, the end free to
    /// move along the axis or held, and Saint-Venant's G J.
    ///
    /// The section at the end keeps its shape, as the torque's shares of r_y and r_z would else
    /// turn them apart. Engineering strains have no Wagner term.
    void half_turn(Rows& rows, bool) const {
        struct Torque {
            const char* name;
            double value;
            bool wagner, held;
        };
        const std::array<Torque, 3> torques{{
            {"twist_180_wagner", 20.5631985582, true, false},
            {"twist_180_wagner_held", 20.5823797062, true, true},
            {"twist_180_saint_venant", 10.1789668163, false, false},
        }};
        for (const Torque& torque : torques) {
            if (torque.wagner && is_reissner<Element>) continue;
            Row row = make(torque.name, 20, 5e-5);
            const double start = now();
            Scene scene;
            const double length = 0.254;
            const auto section = ancf::rectangle(0.00254, 0.00635);
            const auto beam = ancf::straight_beam<Element>(
                scene, ancf::Material::from_moduli(8.27371e10, 3.17159e10, 2700.0),
                torque.wagner ? section : to_second_order(section), {0, 0, 0}, {length, 0, 0},
                row.elements,
                options(torque.wagner ? ancf::SectionModel::paper
                                      : ancf::SectionModel::saint_venant));
            scene.clamp(beam.first(), ancf::Clamp::free_slope);
            if (torque.held) scene.fix(beam.last(), ancf::Field::r, 0);
            scene.add(ancf::RigidSection(beam.last()));
            scene.add(ancf::Moment(beam.last(), {torque.value, 0, 0}));
            solve(scene, row, false);
            row.error = std::abs(turns(scene, beam, ancf::Field::r_y) / 0.5 - 1.0);
            finish(rows, row, start);
        }
    }

    /// Bathe and Bolourchi's bend of 45 degrees, with G J of 2 G I, of Saint-Venant's torsion and
    /// of k G Ip; the last two differ by 2.5e-4.
    void bend(Rows& rows, bool quick) const {
        struct Torsion {
            const char* name;
            double correction;
            ancf::SectionModel model;
            Point tip;
        };
        const std::array<Torsion, 3> torsions{{
            {"bend_45",
             1.0,
             ancf::SectionModel::paper,
             {47.150438573629, 15.684800534039, 53.474858791825}},
            {"bend_45_saint_venant",
             1.0,
             ancf::SectionModel::saint_venant,
             {46.89192495, 15.55778591, 53.60736918}},
            {"bend_45_polar",
             5.0 / 6.0,
             ancf::SectionModel::paper,
             {46.87200246, 15.54734743, 53.61814655}},
        }};
        for (const Torsion& torsion : torsions)
            for (const int elements : {8, 16, 32}) {
                if (quick && elements > 8) break;
                // the mesh, and Green's strain
                Row row = make(torsion.name, elements, 0.12 / (elements * elements) + 3e-5);
                const double start = now();
                Scene scene;
                const auto section = ancf::rectangle(1.0, 1.0).with_shear_correction(
                    torsion.correction, torsion.correction);
                const auto beam = ancf::arc<Element>(
                    scene, ancf::Material::from_moduli(1e7, 5e6, 1.0), section, {0, 0, 0},
                    {1, 0, 0}, {0, 1, 0}, 100.0, 0.25 * pi, elements, options(torsion.model));
                scene.clamp(beam.first(), ancf::Clamp::free_slope);
                scene.add(ancf::Force<3>(beam.last(), {0, 0, 600}));
                solve(scene, row);
                row.error = (scene.position(beam.last()) - torsion.tip).norm() / 100.0;
                finish(rows, row, start);
            }
    }

    /// The Princeton beam, load and degrees from the chord in the name; torsion by Saint-Venant.
    void princeton(Rows& rows, bool quick) const {
        struct Load {
            const char* name;
            double force, degrees, chordwise, flapwise;
        };
        const std::array<Load, 5> loads{{
            {"princeton_4.448_30", 4.448, 30.0, 0.00475107, 0.03994940},
            {"princeton_8.896_0", 8.896, 0.0, 0.01071541, 0.0},
            {"princeton_8.896_45", 8.896, 45.0, 0.00888886, 0.10904157},
            {"princeton_8.896_90", 8.896, 90.0, 0.0, 0.14625998},
            {"princeton_13.345_60", 13.345, 60.0, 0.01171642, 0.18192119},
        }};
        for (const Load& load : loads) {
            const int elements = quick ? 8 : 16;
            Row row = make(load.name, elements, quick ? 2e-3 : 5e-4);
            const double start = now();
            Scene scene;
            const double length = 0.508, thin = 3.2024e-3, high = 12.377e-3;
            const auto beam = ancf::straight_beam<Element>(
                scene, ancf::Material::isotropic(71.7e9, 0.31, 2700.0), ancf::rectangle(thin, high),
                {0, 0, 0}, {length, 0, 0}, elements, options(ancf::SectionModel::saint_venant));
            scene.clamp(beam.first(), ancf::Clamp::free_slope);
            const double angle = load.degrees * pi / 180.0;
            scene.add(ancf::Force<3>(beam.last(),
                                     load.force * Point(0.0, std::cos(angle), std::sin(angle))));
            solve(scene, row);
            const Point tip = scene.position(beam.last());
            row.error = std::hypot(tip[1] - load.chordwise, tip[2] - load.flapwise) /
                        std::hypot(load.chordwise, load.flapwise);
            finish(rows, row, start);
        }
    }

    /// MacNeal and Harder's beam with 90 degrees of twist, loads along the root's width and
    /// thickness.
    void pretwisted(Rows& rows, bool quick) const {
        pretwisted(rows, quick, 1, 1.74962334e-3);
        pretwisted(rows, quick, 2, 5.42932148e-3);
    }

    void pretwisted(Rows& rows, bool quick, int along, double deflection) const {
        const int elements = quick ? 12 : 24;
        Row row =
            make(along == 1 ? "pretwisted" : "pretwisted_thickness", elements, quick ? 0.01 : 3e-3);
        const double start = now();
        Scene scene;
        std::vector<ancf::CurvePoint<3>> points;
        for (int k = 0; k <= elements; ++k) {
            const double part = static_cast<double>(k) / elements, angle = 0.5 * pi * part;
            ancf::Matrix<double, 3> slopes = ancf::Matrix<double, 3>::Identity();
            slopes.col(1) << 0.0, std::cos(angle), std::sin(angle);
            slopes.col(2) << 0.0, -std::sin(angle), std::cos(angle);
            points.push_back({{12.0 * part, 0.0, 0.0}, slopes});
        }
        const auto beam = ancf::beam_through<Element>(
            scene, ancf::Material::isotropic(29e6, 0.22, 1.0), ancf::rectangle(0.32, 1.1), points,
            std::vector<double>{12.0 / elements}, options());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        scene.add(ancf::Force<3>(beam.last(), Point::Unit(along)));
        solve(scene, row);
        row.error = std::abs(scene.position(beam.last())[along] / deflection - 1.0);
        finish(rows, row, start);
    }

    /// Lateral buckling of a narrow cantilever, both torsion constants, against the theory without
    /// deflection before buckling.
    void lateral(Rows& rows, bool quick) const {
        for (const bool saint_venant : {true, false}) {
            if (saint_venant && !warps) continue;
            const int elements = quick ? 8 : 32;
            Row row = make(saint_venant ? "lateral_buckling" : "lateral_buckling_polar", elements,
                           quick ? 1e-2 : 1e-3);
            const double start = now();
            Scene scene;
            const auto material = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);
            const auto section = ancf::rectangle(0.002, 0.1);
            const auto beam = ancf::straight_beam<Element>(
                scene, material, section, {0, 0, 0}, {1, 0, 0}, elements,
                options(saint_venant ? ancf::SectionModel::saint_venant
                                     : ancf::SectionModel::paper));
            scene.clamp(beam.first(), ancf::Clamp::free_slope);
            scene.add(ancf::Force<3>(beam.last(), {0, -1, 0}));
            ancf::ModalOptions how;
            how.count = 2;
            ancf::EigenLdlt solver;
            const auto report = ancf::buckling_modes(scene, solver, how);
            row.iterations = report.iterations;
            row.steps = 1;
            row.status = std::string(to_string(report.status));
            const double bent = material.young * section.moments().zz;
            const double torsion = material.shear * (saint_venant ? section.torsion_constant()
                                                                  : section.shear_correction_y() *
                                                                        section.moments().polar());
            const double theory = 4.012599343579 * std::sqrt(bent * torsion);
            row.error = report.modes.empty()
                            ? 1.0
                            : std::abs(std::abs(report.modes[0].value) / theory - 1.0);
            finish(rows, row, start);
        }
    }

    /// The same cantilever on its path: the load at which it really buckles, deflected by then,
    /// with every stiffness and Saint-Venant's torsion.
    void lateral_path(Rows& rows, bool quick) const {
        Row row = make("lateral_buckling_path", quick ? 32 : 64, quick ? 4e-4 : 1e-4);
        const double start = now();
        Scene scene;
        const auto beam = ancf::straight_beam<Element>(
            scene, ancf::Material::isotropic(2.07e11, 0.3, 7850.0), ancf::rectangle(0.002, 0.1),
            {0, 0, 0}, {1, 0, 0}, row.elements, options(ancf::SectionModel::saint_venant));
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        scene.add(ancf::Force<3>(beam.last(), {0, -68.28893, 0}));
        follow(scene, row);
        finish(rows, row, start);
    }

    /// A bar under end thrust, guided so that it stays straight: the larger error of load and
    /// stretch where it gives way.
    ///
    /// Green's strain has the force E A s (s^2 - 1)/2 at the stretch s, least at 1/sqrt(3). Every
    /// part of the bar gives way at once there, on any mesh. Engineering strains never do.
    void end_thrust(Rows& rows, bool) const {
        if (is_reissner<Element>) return;
        Row row = make("end_thrust", 4, 1e-6);
        const double start = now();
        Scene scene;
        const auto section = ancf::rectangle(0.1, 0.1);
        const auto material = ancf::Material::isotropic(1e9, 0.3, 1000.0);
        const auto beam = ancf::straight_beam<Element>(scene, material, section, {0, 0, 0},
                                                       {1, 0, 0}, row.elements, options());
        const std::array<std::pair<ancf::Field, int>, 4> free{{{ancf::Field::r, 0},
                                                               {ancf::Field::r_x, 0},
                                                               {ancf::Field::r_y, 1},
                                                               {ancf::Field::r_z, 2}}};
        for (const ancf::NodeId node : beam.nodes) {
            for (const auto& [field, own] : free)
                for (int k = 0; k < 3; ++k)
                    if (k != own) scene.fix(node, field, k);
            if constexpr (Element::fields.contains(ancf::Field::r_xx))
                for (const int across : {1, 2}) scene.fix(node, ancf::Field::r_xx, across);
        }
        scene.fix(beam.first(), ancf::Field::r, 0);
        const double load = material.young * section.moments().area / std::sqrt(27.0);
        scene.add(ancf::Force<3>(beam.last(), {-load, 0, 0}));
        const auto report = follow(scene, row);
        if (!report.critical.empty()) {
            const int end = scene.coordinate(beam.last(), ancf::Field::r);
            const double stretch = report.critical.front().state.q[end];
            worsen(row.error, std::abs(std::sqrt(3.0) * stretch - 1.0));
        }
        finish(rows, row, start);
    }

    /// The first three pairs of bending frequencies of a slender cantilever.
    void frequencies(Rows& rows, bool quick) const {
        (void)quick;
        Row row = make("frequencies", 8, 1e-3);
        const double start = now();
        Scene scene;
        const double height = 0.005, young = 2.07e11, density = 7850.0;
        const auto beam = ancf::straight_beam<Element>(
            scene, ancf::Material::isotropic(young, 0.3, density), ancf::rectangle(height, height),
            {0, 0, 0}, {1, 0, 0}, 8, options());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        ancf::EigenLdlt solver;
        const auto report = ancf::natural_modes(scene, solver);
        row.iterations = report.iterations;
        row.steps = 1;
        row.status = std::string(to_string(report.status));
        // Euler's beam; rotary inertia and shear take 3e-4 of the third at this slenderness
        const double unit = height * std::sqrt(young / (12.0 * density)) / (2.0 * pi);
        const double theory[] = {1.87510407, 4.69409113, 7.85475744};
        if (report.modes.size() != 6) row.error = 1.0;
        for (std::size_t k = 0; k < std::min<std::size_t>(report.modes.size(), 6); ++k)
            worsen(row.error,
                   std::abs(report.modes[k].frequency() / (theory[k / 2] * theory[k / 2] * unit) -
                            1.0));
        finish(rows, row, start);
    }

    std::string element_;
    Options options_;
    ancf::Vector<double, 2> tip_;
};

/// The slender cantilever's tip in the limits of Green's and of engineering strains, m.
inline const ancf::Vector<double, 2> green_tip(1.784108719196, 0.821973318973);
inline const ancf::Vector<double, 2> engineering_tip(1.784113323480, 0.821971481194);

/// Returns the options of a rule of integration.
[[nodiscard]] inline ancf::CrossSectionOptions with_rule(ancf::Rule rule) {
    ancf::CrossSectionOptions options;
    options.rule = std::move(rule);
    return options;
}

}  // namespace hard_cases
