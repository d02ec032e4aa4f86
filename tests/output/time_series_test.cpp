// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Results over time: a cantilever held by joints, whose section forces and reactions are statics.

#include <ancf/element/cable.hpp>
#include <ancf/element/planar_beam.hpp>
#include <ancf/model/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/output/time_series.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/instances/cable.hpp>
#include <support/instances/planar.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace time_series_test {

using namespace ancf;
using Element = CrossSectionBeam<2>;
using Point = Vector<double, 2>;

constexpr double side = 0.1, pull = 800.0, lift = 30.0, length = 2.0;

/// A cantilever welded to space at its first node, under a force at its tip.
struct Cantilever {
    Model<Element> model;
    Beam<Element> beam;

    Cantilever()
        : beam(straight_beam(model, Material::isotropic(2e9, 0.3, 7800.0), rectangle(side, side),
                             Point(0, 0), Point(length, 0), 4)) {
        model.add(PlanarWeld(model, beam.first()));
        model.add(Force<2>(beam.last(), Point(pull, lift)));
    }

    [[nodiscard]] bool settle() {
        EigenLu solver;
        return solve_statics(model, solver, {}).status == Status::converged;
    }
};

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
    return result;
}

TEST_CASE("TimeSeries: section forces, stress and reactions of a cantilever are those of statics",
          "[output][time-series]") {
    Cantilever scene;
    std::ostringstream out;
    TimeSeries series(out, scene.model);
    series.add_section_forces("tip", 3, 1.0);
    series.add_stress("axis", 0, 0.5);
    series.add_reaction("weld", 0, scene.beam.first());
    REQUIRE(scene.settle());
    State state = scene.model.state();
    state.time = 0.25;
    Energies energies;
    energies.strain = 7.5;
    series.write({state, energies, 0.0, 0.0});
    series.write({state, energies, 0.0, 0.0});

    std::istringstream in(out.str());
    std::string header, first, second;
    std::getline(in, header);
    std::getline(in, first);
    std::getline(in, second);
    CHECK(header ==
          "t,kinetic,strain,potential,load_power,constraint_power,tip_N,tip_Q_y,tip_Q_z,tip_T,"
          "tip_M_y,tip_M_z,axis_S_xx,axis_S_yy,axis_S_xy,weld_F_x,weld_F_y,weld_F_z,weld_M_x,"
          "weld_M_y,weld_M_z");
    CHECK(first == second);
    const auto names = cells(header), values = cells(first);
    REQUIRE(values.size() == names.size());
    const auto value = [&](const std::string& name) {
        for (std::size_t k = 0; k < names.size(); ++k)
            if (names[k] == name) return std::stod(values[k]);
        FAIL("no column " << name);
        return 0.0;
    };
    CHECK(value("t") == 0.25);
    CHECK(value("strain") == 7.5);
    // the tip turns by lift L^2/(2 E I) = 4e-3: the axial force is the pull but for its square
    CHECK(value("tip_N") == Approx(pull).epsilon(2e-3));
    CHECK(value("axis_S_xx") == Approx(pull / (side * side)).epsilon(2e-2));
    const Point tip = scene.model.position(scene.beam.last());
    CHECK(value("weld_F_x") == Approx(-pull).epsilon(1e-9));
    CHECK(value("weld_F_y") == Approx(-lift).epsilon(1e-9));
    CHECK(value("weld_M_z") == Approx(-(tip[0] * lift - tip[1] * pull)).epsilon(1e-9));
    CHECK(value("weld_M_x") == 0.0);
}

TEST_CASE("TimeSeries: a cable shows its axial force and stress", "[output][time-series]") {
    Model<Cable<3>> model;
    const auto cable = straight_beam(model, Material::isotropic(2e9, 0.3, 7800.0), circle(0.01),
                                     {0, 0, 0}, {1, 0, 0}, 1);
    std::ostringstream out;
    TimeSeries series(out, model);
    series.add_section_forces("middle", 0, 0.5);
    series.add_stress("middle", 0, 0.5);
    const State& state = model.state();
    series.write({state, {}, 0.0, 0.0});
    const std::string header = out.str().substr(0, out.str().find('\n'));
    CHECK(cells(header).back() == "middle_S_xx");
    CHECK(cells(header).size() == 6 + 6 + 1);
    CHECK(cable.elements.size() == 1);
}

TEST_CASE("TimeSeries: what does not exist is refused", "[output][time-series][bad-input]") {
    Cantilever scene;
    std::ostringstream out;
    TimeSeries series(out, scene.model);
    CHECK_THROWS_AS(series.add_section_forces("a", 4, 0.5), InvalidArgument);
    CHECK_THROWS_AS(series.add_stress("a", -1, 0.5), InvalidArgument);
    CHECK_THROWS_AS(series.add_stress("a", 0, 1.5), InvalidArgument);
    CHECK_THROWS_AS(series.add_reaction("a", 1, scene.beam.first()), InvalidArgument);
    CHECK_THROWS_AS(series.add_reaction("a", 0, scene.beam.last()), InvalidArgument);
    const State& state = scene.model.state();
    series.write({state, {}, 0.0, 0.0});
    CHECK_THROWS_AS(series.add_section_forces("late", 0, 0.5), InvalidArgument);
}

}  // namespace time_series_test
