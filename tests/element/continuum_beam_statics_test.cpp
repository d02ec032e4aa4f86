// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cantilevers of continuum beams: the comparison column of [Dufva2006], and Poisson locking.

#include <ancf/element/continuum/beam.hpp>

#include <support/catch.hpp>
#include <support/dense.hpp>

#include <cmath>
#include <functional>
#include <vector>

namespace continuum_beam_statics_test {

using namespace ancf;

/// Nodal force at the tip and its derivative by the tip's 12 coordinates.
struct TipLoad {
    Vector<double, 12> force = Vector<double, 12>::Zero();
    Matrix<double, 12> derivative = Matrix<double, 12>::Zero();
};

/// A chain along x of equal elements, its first node held in r, r_y, r_z (r_x free), solved
/// densely.
class Cantilever {
public:
    Cantilever(const ContinuumBeam<3>& element, int elements)
        : element_(element), elements_(elements), q_(VectorX::Zero(12 * (elements + 1))) {
        for (int node = 0; node <= elements; ++node) {
            q_(12 * node) = node * element.length();
            q_(12 * node + 3) = q_(12 * node + 7) = q_(12 * node + 11) = 1.0;
        }
        for (int i = 0; i < q_.size(); ++i)
            if (i > 11 || (i >= 3 && i < 6)) free_.push_back(i);
    }

    /// Returns the iterations of Newton's method to 1e-9 of the load, or -1 after 200.
    int solve(const std::function<TipLoad(const Vector<double, 12>&)>& load) {
        for (int iteration = 0; iteration < 200; ++iteration) {
            assemble();
            const TipLoad tip = load(q_.tail<12>());
            force_.tail<12>() -= tip.force;
            tangent_.bottomRightCorner<12, 12>() -= tip.derivative;
            const VectorX residual = force_(free_);
            if (residual.norm() <= 1e-9 * tip.force.norm()) return iteration;
            const VectorX step = test::solved(tangent_(free_, free_), residual);
            q_(free_) -= step;
        }
        return -1;
    }

    /// Returns the linear displacement of the tip under a nodal force on it.
    Vector<double, 3> linear_displacement(const Vector<double, 12>& load) {
        assemble();
        VectorX f = VectorX::Zero(q_.size());
        f.tail<12>() = load;
        const VectorX right = f(free_);
        const VectorX u = test::solved(tangent_(free_, free_), right);
        return u.segment<3>(u.size() - 12);
    }

    Vector<double, 3> tip() const { return q_.segment<3>(q_.size() - 12); }
    Vector<double, 24> coordinates(int index) const { return q_.segment<24>(12 * index); }

private:
    void assemble() {
        force_ = VectorX::Zero(q_.size());
        tangent_ = MatrixX::Zero(q_.size(), q_.size());
        for (int k = 0; k < elements_; ++k) {
            const auto evaluation = element_.evaluate(coordinates(k));
            force_.segment<24>(12 * k) += evaluation.force;
            tangent_.block<24, 24>(12 * k, 12 * k) += evaluation.tangent;
        }
    }

    ContinuumBeam<3> element_;
    int elements_;
    VectorX q_, force_;
    MatrixX tangent_;
    std::vector<int> free_;
};

/// A dead force along y at the tip.
TipLoad dead(double force) {
    TipLoad load;
    load.force(1) = force;
    return load;
}

/// A moment about z that turns the tip's r_y: Q = m e_z x a/|a|^2, a the part of r_y in the plane.
TipLoad moment_on_slope(const Vector<double, 12>& tip, double moment) {
    const Vector<double, 2> a = tip.segment<2>(6);
    const Vector<double, 2> turned(-a(1), a(0));
    Matrix<double, 2> turn;
    turn << 0.0, -1.0, 1.0, 0.0;
    const double square = a.squaredNorm();
    TipLoad load;
    load.force.segment<2>(6) = moment / square * turned;
    load.derivative.block<2, 2>(6, 6) =
        moment / square * (turn - 2.0 / square * turned * a.transpose());
    return load;
}

TEST_CASE("ContinuumBeam: a slender cantilever reproduces the comparison column of Table 1",
          "[element][continuum][verification]") {
    struct Row {
        int elements;
        double x, y;
    };
    const auto row =
        GENERATE(Row{1, 1.9988, 0.0612}, Row{2, 1.9915, 0.1596}, Row{4, 1.9516, 0.3847},
                 Row{8, 1.8515, 0.6777}, Row{16, 1.7924, 0.8052});
    const double length = 2.0;
    const double load = 1.5 * 2.07e11 * (1e-8 / 12.0) / (length * length);
    const ContinuumBeam<3> element(
        Material::from_moduli(2.07e11, 7.9615e10, 7850.0),
        rectangle(0.01, 0.01).with_shear_correction(5.0 / 6.0, 5.0 / 6.0), length / row.elements);
    Cantilever beam(element, row.elements);
    const int iterations = beam.solve([&](const auto&) { return dead(load); });
    INFO(row.elements << " elements, " << iterations << " iterations");
    REQUIRE(iterations > 0);
    CHECK(std::abs(beam.tip()(0) - row.x) <= 6e-5);  // the published column has four decimals
    CHECK(std::abs(beam.tip()(1) - row.y) <= 6e-5);
    CHECK(std::abs(beam.tip()(2)) <= 1e-12);
}

TEST_CASE(
    "ContinuumBeam: bent by a moment towards a semicircle it ends where the published elements do",
    "[element][continuum][verification]") {
    struct Row {
        int elements;
        double x, y;
    };
    const auto row =
        GENERATE(Row{3, 0.67914, 0.59826}, Row{6, 0.19380, 0.70187}, Row{16, 0.00155, 0.63643});
    const double side = 0.035, young = 2e8;
    const double moment = 3.14159265358979323846 * young * side * side * side * side / 12.0;
    const ContinuumBeam<3> element(Material::isotropic(young, 0.0, 7850.0), rectangle(side, side),
                                   1.0 / row.elements);
    Cantilever beam(element, row.elements);
    const int steps = 4;
    for (int step = 1; step <= steps; ++step)
        REQUIRE(beam.solve([&](const auto& tip) {
            return moment_on_slope(tip, moment * step / steps);
        }) >= 0);
    CHECK(std::abs(beam.tip()(0) - row.x) <= 1e-5);  // five published decimals
    CHECK(std::abs(beam.tip()(1) - row.y) <= 1e-5);
}

TEST_CASE("ContinuumBeam: Hooke's law locks in bending, the enhanced form does not",
          "[element][continuum][verification]") {
    const double length = 1.0, side = 0.02, young = 2e11, nu = 0.3, force = 1.0;
    const Material material = Material::isotropic(young, nu, 7850.0);
    const double inertia = side * side * side * side / 12.0;
    const double bending = force * length * length * length / (3.0 * young * inertia);
    const double beam = bending + force * length / (5.0 / 6.0 * material.shear * side * side);
    const Section centred = rectangle(side, side);
    // The tip's deflection over the beam's; then extrapolated from 16 and 32 elements.
    const auto ratio = [&](ContinuumMaterial law, const Section& section, int elements) {
        const ContinuumBeam<3> element(material, section, length / elements, {Rule::paper(), law});
        return Cantilever(element, elements).linear_displacement(dead(force).force)(1) / beam;
    };
    const auto limit = [&](ContinuumMaterial law, const Section& section) {
        return (4.0 * ratio(law, section, 32) - ratio(law, section, 16)) / 3.0;
    };
    // Bending leaves the sides without stress only if e_yy and e_zz vary with y; they cannot, and
    // the stiffness is then lambda + 2 mu instead of E.
    const double locked = (1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu);  // 0.742857
    CHECK(limit(ContinuumMaterial::hooke, centred) ==
          Approx(locked).epsilon(2e-4));  // shear; 1.1e-4
    CHECK(limit(ContinuumMaterial::enhanced, centred) == Approx(1.0).epsilon(1e-6));
    CHECK(limit(ContinuumMaterial::diagonal, centred) == Approx(1.0).epsilon(1e-6));
    CHECK(ratio(ContinuumMaterial::enhanced, centred, 4) == Approx(1.0).epsilon(0.02));  // 1 - 1/64
    CHECK(ratio(ContinuumMaterial::hooke, centred, 4) < 0.75);

    // Off its axis the section converges more slowly, to the same limits.
    const Section moved = offset(centred, 0.01, 0.0);
    CHECK(limit(ContinuumMaterial::enhanced, moved) == Approx(1.0).epsilon(1e-3));
    CHECK(limit(ContinuumMaterial::hooke, moved) == Approx(locked).epsilon(1e-3));
}

TEST_CASE("ContinuumBeam: section forces balance a load on the tip",
          "[element][continuum][verification]") {
    const double length = 1.0, side = 0.02, force = 1000.0;
    const int elements = 16;
    const auto law = GENERATE(ContinuumMaterial::diagonal, ContinuumMaterial::enhanced);
    const ContinuumBeam<3> element(Material::isotropic(2e11, 0.3, 7850.0), rectangle(side, side),
                                   length / elements, {Rule::paper(), law});
    Cantilever beam(element, elements);
    const Vector<double, 3> load = Vector<double, 3>(0.5, 1.0, -2.0) * force;
    REQUIRE(beam.solve([&](const auto&) {
        TipLoad tip;
        tip.force.head<3>() = load;
        return tip;
    }) >= 0);
    const Vector<double, 3> tip = beam.tip();
    for (int k = 0; k < elements; ++k) {
        const Vector<double, 24> e = beam.coordinates(k);
        const SectionForces at = element.section_forces(e, 0.5);
        const Vector<double, 3> t =
            (element.position(e, 0.501) - element.position(e, 0.499)).normalized();
        const Vector<double, 3> arm = tip - element.position(e, 0.5);
        const Vector<double, 3> moment(arm(1) * load(2) - arm(2) * load(1),
                                       arm(2) * load(0) - arm(0) * load(2),
                                       arm(0) * load(1) - arm(1) * load(0));
        INFO("element " << k);
        const double end = k == 0 ? 10.0 : 1.0;  // r_x is free at the clamp: a boundary layer
        CHECK(at.axial == Approx(t.dot(load)).epsilon(1e-2 * end));  // 16 elements; measured 5e-3
        CHECK(std::hypot(at.shear_y, at.shear_z) ==
              Approx((load - t.dot(load) * t).norm()).epsilon(3e-3 * end));
        CHECK(std::hypot(at.moment_y, at.moment_z) ==
              Approx((moment - t.dot(moment) * t).norm()).epsilon(1e-3 * end));
        CHECK(std::abs(at.torque - t.dot(moment)) <= 1e-4 * end * force * length);
    }
}

}  // namespace continuum_beam_statics_test
