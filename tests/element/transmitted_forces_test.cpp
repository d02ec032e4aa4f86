// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Section forces by equilibrium with the nodal forces, and reactions at a node: exact on any mesh,
/// at clamps and beside point loads.

#include <ancf/element/transmitted_forces.hpp>

#include <ancf/assembly/resultant.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace transmitted_forces_test {

using Vector3 = ancf::Vector<double, 3>;

double norm(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }

TEMPLATE_TEST_CASE("section forces: they balance loads at nodes beside a clamp and a point load",
                   "[element][section-forces]", ancf::CrossSectionBeam<3>, ancf::QuinticBeam<>,
                   ancf::CrossSectionBeam<2>, ancf::ContinuumBeam<3>, ancf::ContinuumBeam<2>,
                   ancf::Cable<3>, ancf::Cable<2>) {
    using Element = TestType;
    constexpr int dimension = Element::dimension;
    using Point = ancf::Vector<double, dimension>;
    ancf::BasicModel<Element::dimension> model;
    Point end = Point::Zero();
    end[0] = 1.0;
    const auto beam =
        ancf::straight_beam<Element>(model, ancf::Material::isotropic(2.1e11, 0.3, 7850.0),
                                     ancf::rectangle(0.02, 0.02), Point(Point::Zero()), end, 4);
    model.clamp(beam.first());
    std::vector<std::pair<ancf::NodeId, Vector3>> loads = {{beam.node(2), {40.0, -90.0, 60.0}},
                                                           {beam.last(), {30.0, 500.0, -200.0}}};
    for (auto& [node, force] : loads) {
        if (dimension == 2) force[2] = 0.0;
        model.add(ancf::Force<dimension>(node, force.template head<dimension>()));
    }
    ancf::EigenLu solver;
    ancf::StaticsOptions options;
    options.residual_tolerance = 1e-12;
    const auto report = ancf::solve_statics(model, solver, options);
    REQUIRE(report.status == ancf::Status::converged);

    const auto place = [&](ancf::NodeId node) {
        return ancf::detail::in_space<dimension>(model.position(node));
    };
    // what the loads beyond a place amount to there
    const auto beyond = [&](const Vector3& from, std::size_t first) {
        ancf::Resultant sum;
        for (std::size_t k = first; k < loads.size(); ++k) {
            sum.force += loads[k].second;
            sum.moment += ancf::cross(Vector3(place(loads[k].first) - from), loads[k].second);
        }
        return sum;
    };
    for (std::size_t k = 0; k < beam.elements.size(); ++k) {
        const Element& element = model.template group<Element>().element(beam.elements[k]);
        const auto e = model.template element_coordinates<Element>(beam.elements[k]);
        for (const double xi : {0.0, 0.3, 1.0}) {
            INFO("element " << k << ", xi " << xi);
            const Vector3 from =
                ancf::detail::in_space<dimension>(Point(element.position(e, xi, 0.0, 0.0)));
            const ancf::Resultant expected = beyond(from, k < 2 ? 0 : 1);
            const ancf::SectionForces at = ancf::transmitted_forces(element, e, xi);
            const double size = expected.force.norm();
            CHECK(norm(at.axial, at.shear_y, at.shear_z) == Approx(size).epsilon(1e-7));
            CHECK(norm(at.torque, at.moment_y, at.moment_z) ==
                  Approx(expected.moment.norm()).epsilon(1e-7).margin(1e-7 * size));
            // the beam turns by less than 0.1
            CHECK(at.shear_y == Approx(expected.force[1]).margin(0.1 * size));
            CHECK(at.shear_z == Approx(expected.force[2]).margin(0.1 * size));
            CHECK(at.moment_y == Approx(expected.moment[1]).margin(0.1 * size));
            CHECK(at.moment_z == Approx(expected.moment[2]).margin(0.1 * size));
        }
    }
    const ancf::Resultant foot =
        ancf::nodal_resultant(model, model.state().q, report.reactions, beam.first());
    const ancf::Resultant all = beyond(place(beam.first()), 0);
    CHECK((foot.force + all.force).norm() <= 1e-7 * all.force.norm());
    CHECK((foot.moment + all.moment).norm() <= 1e-7 * all.force.norm());
    CHECK_THROWS_AS(
        ancf::nodal_resultant(model, model.state().q, report.reactions, ancf::NodeId{5}),
        ancf::InvalidArgument);
}

TEMPLATE_TEST_CASE("section forces: of a load along a beam the moment is right at Gauss points",
                   "[element][section-forces]", ancf::CrossSectionBeam<3>,
                   ancf::CrossSectionBeam<2>) {
    using Element = TestType;
    constexpr int dimension = Element::dimension, elements = 4;
    using Point = ancf::Vector<double, dimension>;
    const double load = 10.0, length = 2.0, l = length / elements;  // N/m, m
    ancf::BasicModel<dimension> model;
    const auto beam = ancf::straight_beam<Element>(
        model, ancf::Material::isotropic(2.1e11, 0.3, 7850.0), ancf::rectangle(0.05, 0.05),
        Point(Point::Zero()), Point(length * Point::Unit(0)), elements);
    model.clamp(beam.first());
    ancf::add_line_load(model, beam, Point(-load * Point::Unit(1)));
    ancf::EigenLu solver;
    const auto report = ancf::solve_statics(model, solver);
    REQUIRE(report.status == ancf::Status::converged);

    double worst = 0.0;
    const double gauss = 0.5 / std::sqrt(3.0);
    for (int k = 0; k < elements; ++k) {
        const Element& element = model.template group<Element>().element(beam.elements[k]);
        const auto e = model.template element_coordinates<Element>(beam.elements[k]);
        for (const double xi : {0.0, 0.5 - gauss, 0.5, 0.5 + gauss, 1.0}) {
            INFO("element " << k << ", xi " << xi);
            const double beyond = length - (k + xi) * l;  // m
            const double lacks = xi * (1.0 - xi) / 2.0 - 1.0 / 12.0;
            const auto at = ancf::transmitted_forces(element, e, xi);
            const double expected = -load * (beyond * beyond / 2.0 + lacks * l * l);
            worst = std::max(worst, std::abs(at.moment_z - expected) / (load * l * l));
            CHECK(at.shear_y ==
                  Approx(-load * (length - (k + 0.5) * l)).margin(1e-6 * load * length));
        }
    }
    CHECK(worst <= 1e-6);  // of q l^2; the beam bends by 1e-4 of its length; measured 3e-8
    const ancf::Resultant foot =
        ancf::nodal_resultant(model, model.state().q, report.reactions, beam.first());
    CHECK(foot.moment[2] == Approx(load * length * length / 2.0).epsilon(1e-4));
}

}  // namespace transmitted_forces_test
