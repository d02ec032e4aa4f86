// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Ends of statics under a following force: whether their motions decay, by all eigenvalues.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace decay_test {

using namespace ancf;

using Engineering = CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>;

/// Returns the least real part of the motions D dx/dt = -K x about a state at load factor 1.
double slowest_decay(const Model& scene) {
    Assembly assembly(scene, Storage::full);
    const State& state = scene.state();
    const VectorX rest = VectorX::Zero(state.q.size());
    REQUIRE_FALSE(
        assembly.evaluate({state.q, rest, state.multipliers, {1.0, 1.0}}, Request::tangent));
    const MatrixX K = assembly.tangent();
    const VectorX root = K.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    const MatrixX scaled = root.asDiagonal() * K * root.asDiagonal();
    return Eigen::EigenSolver<Eigen::MatrixXd>(scaled, false).eigenvalues().real().minCoeff();
}

TEST_CASE("statics: an end whose motions decay is not taken again where a pair of them is complex",
          "[statics][turning]") {
    // a tip force that follows a strip; of the slowest motions a complex pair is the third and
    // fourth, or the fourth and fifth
    int checked = 0;
    for (double load = 8.0; load <= 15.0; load += 0.5) {
        Model scene;
        const double height = 1e-3, width = 1.5e-3;
        const auto beam = straight_beam<Engineering>(
            scene, Material::isotropic(12.0 / (width * std::pow(height, 3)), 0.3, 1.0),
            rectangle(width, height), {0, 0, 0}, {1, 0, 0}, 16, Engineering::Options::best());
        scene.clamp(beam.first(), Clamp::free_slope);
        scene.add(FollowerForce(beam.last(), {0.0, load, 0.0}));
        EigenLu solver;
        const auto report = solve_statics(scene, solver);
        CAPTURE(load, report.iterations());
        REQUIRE(report.status == Status::converged);
        CHECK(slowest_decay(scene) > 0.0);
        CHECK(report.iterations() <= 25);  // 17 to 20 measured; up to 165 with ends taken again
        for (const auto& step : report.steps) CHECK(step.status != Status::diverged);
        ++checked;
    }
    CHECK(checked == 15);
}

}  // namespace decay_test
