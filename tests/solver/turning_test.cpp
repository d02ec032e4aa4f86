// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What turning makes of the tangent, against differences of turned coordinates.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/turning.hpp>

#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace turning_test {

using namespace ancf;

/// A clamped beam of three elements, bent, twisted and strained at random.
template <class Element>
struct Bent {
    static constexpr int dimension = Element::dimension;
    BasicModel<dimension> model;
    VectorX q;

    explicit Bent(test::Random& random) {
        const Vector<double, 3> end(1.5, 0.6, -0.3);
        const auto beam = straight_beam<Element>(
            model, Material::isotropic(2e7, 0.3, 1000.0), rectangle(0.2, 0.2),
            Vector<double, dimension>::Zero(), end.template head<dimension>(), 3);
        model.clamp(beam.first());
        q = model.state().q + 0.1 * random.vector(static_cast<int>(model.state().q.size()));
    }
};

TEMPLATE_TEST_CASE("Turning: its curvature is the second derivative of the turned coordinates",
                   "[solver][turning]", CrossSectionBeam<3>, TorsionBeam, CrossSectionBeam<2>,
                   ContinuumBeam<2>, Cable<2>, Cable<3>, QuinticBeam<>, PlanarQuinticBeam<>) {
    const bool chords = GENERATE(true, false);
    const Storage storage = GENERATE(Storage::full, Storage::lower);
    double worst = 0.0, largest = 0.0;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        test::Random random(seed);
        Bent<TestType> scene(random);
        // of three nodes one turns slopes alone
        const bool quintic = scene.model.layout().fields(2).contains(Field::r_xx);
        scene.model.fix(NodeId{2}, quintic ? Field::r_y : Field::r_x, 1);
        const Assembly assembly(scene.model, storage);
        const Numbering& numbering = assembly.numbering();
        Turning turning(scene.model, numbering);
        const int size = numbering.free_coordinates();
        VectorX residual = random.vector(size), x = random.vector(size);
        if (!chords)  // positions follow chords: without these slopes alone are curved
            for (int node = 0; node < scene.model.nodes(); ++node)
                for (int k = 0; k < TestType::dimension; ++k)
                    if (const int equation =
                            numbering.equation(scene.model.coordinate({node}, Field::r) + k);
                        equation >= 0)
                        residual[equation] = 0.0;
        SparseMatrix curvature = assembly.tangent();
        std::fill_n(curvature.valuePtr(), curvature.nonZeros(), 0.0);
        turning.add_curvature(scene.q, residual, curvature, curvature.valuePtr(), chords);
        const MatrixX dense = curvature;
        const MatrixX lower = dense.triangularView<Eigen::StrictlyLower>();
        const MatrixX whole = storage == Storage::full ? dense : MatrixX(dense + lower.transpose());

        VectorX change = VectorX::Zero(scene.q.size());
        numbering.add_free(x, 1.0, change);
        const auto work = [&](double h) {  // residual . q(h x)
            const VectorX step = h * change;
            VectorX turned = scene.q + step, free;
            turning.turn(scene.q, step, turned);
            numbering.gather_free(turned, free);
            return residual.dot(free);
        };
        constexpr double h = 1e-3;
        const double found = x.dot(whole * x);
        const double expected = (work(h) - 2.0 * work(0.0) + work(-h)) / (h * h);
        worst = std::max(worst, std::abs(found - expected));
        largest = std::max(largest, std::abs(expected));
    }
    CAPTURE(chords, worst, largest);
    CHECK(largest > 0.5);
    CHECK(worst <= 1e-4 * largest);  // 1.4e-6: differences err by second order in h
}

TEST_CASE("Turning: rates of slopes turn with the tangent, and agree with the sum to first order",
          "[solver][turning]") {
    test::Random random(6);
    const Bent<QuinticBeam<>> scene(random);
    const Assembly assembly(scene.model, Storage::full);
    Turning turning(scene.model, assembly.numbering());
    VectorX change = VectorX::Zero(scene.q.size());
    assembly.numbering().add_free(random.vector(assembly.numbering().free_coordinates()), 1.0,
                                  change);
    const auto off = [&](double h) {  // from the sum
        VectorX turned = scene.q + h * change;
        turning.turn(scene.q, h * change, turned);
        return (turned - scene.q - h * change).norm();
    };
    CHECK(off(1e-3) / off(5e-4) == Approx(4.0).epsilon(0.01));

    // a correction that turns all about Z by 1 rad: r_xx keeps its length and its angle with r_x
    const VectorX& q = scene.q;
    for (int k = 0; k < q.size(); k += 3) {
        change[k] = -q[k + 1];
        change[k + 1] = q[k];
        change[k + 2] = 0.0;
    }
    VectorX turned = q + change;
    turning.turn(q, change, turned);
    for (const int node : {1, 2, 3}) {
        const int tangent = scene.model.coordinate({node}, Field::r_x),
                  rate = scene.model.coordinate({node}, Field::r_xx);
        const Vector<double, 3> before = q.segment<3>(rate), after = turned.segment<3>(rate);
        CHECK(after.norm() == Approx(before.norm()).epsilon(0.1));  // the sum makes 1.41 of it
        CHECK(std::abs(after.dot(turned.segment<3>(tangent)) - before.dot(q.segment<3>(tangent))) <=
              1e-12);
    }
}

}  // namespace turning_test
