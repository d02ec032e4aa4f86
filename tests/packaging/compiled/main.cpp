// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cantilever of an element that the compiled library holds, and of a combination that it does
/// not. A shared library looks at the model of the first, where there is one.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/statics.hpp>

#include <cmath>
#include <iostream>

double height_of_tip(const ancf::Scene& model, ancf::NodeId tip);
int beams_in(const ancf::Model& model);
void refuse_node(const ancf::Model& model);

#if defined(WITH_PLUGIN)
/// Returns whether the shared library finds the beams of a model made here, and its exception is
/// known here.
bool shared_with_plugin() {
    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        model, ancf::Material::isotropic(2.07e11, 0.3, 7850.0), ancf::rectangle(0.01, 0.01),
        {0, 0, 0}, {2, 0, 0}, 8);
    if (beams_in(model) != static_cast<int>(beam.elements.size())) return false;
    try {
        refuse_node(model);
    } catch (const ancf::InvalidArgument&) {
        return true;
    }
    return false;
}
#endif

template <class Element>
double deflection() {
    constexpr int dimension = Element::dimension;
    using Point = ancf::Vector<double, dimension>;
    ancf::BasicModel<dimension> model;
    const auto beam = ancf::straight_beam<Element>(
        model, ancf::Material::isotropic(2.07e11, 0.3, 7850.0), ancf::rectangle(0.01, 0.01),
        Point(Point::Zero()), Point(2.0 * Point::UnitX()), 8);
    model.clamp(beam.first(), ancf::Clamp::free_slope);
    model.add(ancf::Force<dimension>(beam.last(), Point(10.0 * Point::Unit(1))));
    ancf::BlockTridiagonal solver;
    const ancf::StaticsReport report = ancf::solve_statics(model, solver);
    std::cout << to_string(report.status) << ' ' << height_of_tip(model, beam.last()) << '\n';
    return report.status == ancf::Status::converged ? height_of_tip(model, beam.last()) : 0.0;
}

int main() {
    // F l^3/(3 E I), within 1 %
    const double expected = 10.0 * 8.0 / (3.0 * 2.07e11 * 1e-8 / 12.0);
    using Usual = ancf::CrossSectionBeam<3>;
    using Own =
        ancf::CrossSectionBeam<3, ancf::Transported, ancf::LinearShear, ancf::EngineeringMeasure>;
    for (const double found : {deflection<Usual>(), deflection<Own>()})
        if (!(std::abs(found - expected) <= 0.01 * expected)) return 1;
#if defined(WITH_PLUGIN)
    if (!shared_with_plugin()) return 1;
#endif
    return 0;
}
