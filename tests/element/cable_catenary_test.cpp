// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A chain that hangs between two pins against the catenary.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

#include <element/cable_scenes.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cable_catenary_test {

using namespace ancf;

/// Returns the root of an increasing function between two numbers.
template <class Function>
double root(const Function& f, double low, double high) {
    for (int k = 0; k < 200; ++k) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return low;
}

/// Returns the sag of a catenary of unit span: 2 a sinh(1/2a) = length, a (cosh(1/2a) - 1).
double catenary_sag(double length) {
    const double half = root([&](double x) { return std::sinh(x) / x - length; }, 1e-9, 50.0);
    return (std::cosh(half) - 1.0) / (2.0 * half);
}

/// A chain of unit span with weight 1 per length, axial stiffness by a factor of the weight, E I/(w
/// L^3) = 1e-8.
template <class Element>
class Chain {
public:
    static constexpr int dimension = Element::dimension;
    using Point = typename BasicModel<Element::dimension>::Point;

    /// The start is an arc, stretched as a tension of one weight would: without tension, nothing
    /// but E I holds it.
    Chain(double length, int elements, const CableOptions& options,
          const Matrix<double, dimension>& turn)
        : length_(length), elements_(elements), options_(options) {
        const double long_arc = length * (1.0 + 1.0 / start_);
        const double half =
            root([&](double x) { return 1.0 / long_arc - std::sin(x) / x; }, 1e-9, test::pi);
        prototype_ = model.add_prototype(cable(start_));
        std::vector<NodeId> nodes;
        for (int k = 0; k <= elements; ++k) {
            const double angle = half * (2.0 * k / elements - 1.0), radius = 0.5 * long_arc / half;
            Point r = Point::Zero(), slope = Point::Zero();
            r[0] = radius * std::sin(angle);
            r[1] = radius * (std::cos(half) - std::cos(angle));
            slope[0] = std::cos(angle);
            slope[1] = std::sin(angle);
            typename BasicModel<Element::dimension>::Slopes slopes =
                BasicModel<Element::dimension>::Slopes::Identity();
            slopes.col(0) = turn * slope * (1.0 + 1.0 / start_);
            nodes.push_back(model.add_node(turn * r, slopes));
            if (k > 0)
                model.template connect<Element>(prototype_, nodes[nodes.size() - 2], nodes.back());
        }
        model.pin(nodes.front());
        model.pin(nodes.back());
        model.set_gravity(turn * (-Point::Unit(1)));
        middle_ = nodes[nodes.size() / 2];
        down_ = turn * (-Point::Unit(1));
    }

    /// Raises the axial stiffness to 1e8 weights, each solution the start of the next.
    void settle() {
        EigenLdlt solver;
        for (double stiffness = start_; stiffness <= 1e8; stiffness *= 100.0) {
            model.template prototype<Element>(prototype_) = cable(stiffness);
            const StaticsReport report = solve_statics(model, solver);
            iterations += report.iterations();
            REQUIRE(report.status == Status::converged);
        }
    }

    [[nodiscard]] double sag() const { return model.position(middle_).dot(down_); }

    BasicModel<Element::dimension> model;
    int iterations = 0;

private:
    static constexpr double start_ = 100.0;

    [[nodiscard]] Element cable(double stiffness) const {
        Moments moments;
        moments.area = 1.0;
        moments.yy = moments.zz = 1e-8 * std::pow(length_, 3) / (stiffness * length_);
        const double young = stiffness * length_;
        return {Material::isotropic(young, 0.3, 1.0), Section::from_moments(moments),
                length_ / elements_, options_};
    }

    double length_;
    int elements_;
    CableOptions options_;
    int prototype_ = 0;
    NodeId middle_;
    Point down_;
};

template <int Dimension>
double sag_error(double length, int elements, const CableOptions& options = {}) {
    Chain<Cable<Dimension>> chain(length, elements, options, Matrix<double, Dimension>::Identity());
    chain.settle();
    CHECK(chain.iterations <= 40);
    return chain.sag() - catenary_sag(length);
}

TEMPLATE_TEST_CASE_SIG("Cable: a hanging chain has the sag of a catenary",
                       "[element][cable][statics][catenary]", ((int Dimension), Dimension), 2, 3) {
    CHECK(std::abs(sag_error<Dimension>(1.05, 16)) <= 2e-6);  // measured 8e-8
    CHECK(std::abs(sag_error<Dimension>(2.0, 16)) <= 5e-5);   // measured 2.4e-5
}

TEST_CASE("Cable: the sag converges with fourth order", "[element][cable][statics][catenary]") {
    const double coarse = sag_error<2>(1.05, 4), middle = sag_error<2>(1.05, 8),
                 fine = sag_error<2>(1.05, 16);
    const double limit = sag_error<2>(1.05, 64);  // what E A and E I leave; measured 1.8e-8
    CHECK(std::abs(limit) <= 3e-8);
    CHECK(test::order(coarse - limit, middle - limit) >= 3.9);
    CHECK(test::order(middle - limit, fine - limit) >= 3.9);
}

TEST_CASE("Cable: chains from taut to deep are found from an arc",
          "[element][cable][statics][catenary]") {
    const double length = GENERATE(1.001, 1.01, 1.2, 3.0, 5.0);
    const double tolerance = length < 2.0 ? 1e-5 : 3e-3;  // of 16 elements
    CHECK(std::abs(sag_error<2>(length, 16)) <= tolerance);
}

TEST_CASE("Cable: a straight rope bent by its weight first hangs when its end comes nearer",
          "[element][cable][statics][catenary]") {
    // docs/recipes.md: without the first solution it is compressed as a bar, up to a length of 1.5
    const double length = GENERATE(1.001, 1.05, 1.2, 1.5, 2.0, 5.0);
    CAPTURE(length);
    Model model;
    const auto rope = straight_beam<Cable<3>>(model, Material::isotropic(2.07e11, 0.3, 7850.0),
                                              circle(0.002), {0, 0, 0}, {length, 0, 0}, 16);
    model.pin(rope.first());
    model.pin(rope.last());
    model.prescribe(rope.last(), Field::r, 0,
                    [length](double factor) { return length + factor * (1.0 - length); });
    model.set_gravity({0, 0, -9.81}, [](double) { return 1.0; });
    EigenLdlt solver;
    StaticsOptions weight_alone;
    weight_alone.first_factor = 1.0;
    weight_alone.last_factor = 0.0;
    REQUIRE(solve_statics(model, solver, weight_alone).status == Status::converged);
    const StaticsReport report = solve_statics(model, solver);
    REQUIRE(report.status == Status::converged);
    CHECK(report.stability == Stability::stable);
    double chords = 0.0;
    for (int k = 0; k < 16; ++k)
        chords += (model.position(rope.node(k + 1)) - model.position(rope.node(k))).norm();
    CHECK(chords >= 0.99 * length);  // measured 0.9967 at least
    CHECK(model.position(rope.node(8))[2] < -0.01);
}

TEST_CASE("Cable: a rope that only pulls hangs as the chain",
          "[element][cable][statics][catenary][rope]") {
    CHECK(std::abs(sag_error<2>(1.05, 16, {cable_rule(), 0.0}) - sag_error<2>(1.05, 16)) <= 1e-9);
}

TEST_CASE("Cable: a chain hangs alike whatever way is down",
          "[element][cable][statics][catenary]") {
    test::Random random(4);
    const auto turn = test::random_rotation<3>(random);
    Chain<Cable<3>> chain(1.05, 16, {}, turn), upright(1.05, 16, {}, Matrix<double, 3>::Identity());
    chain.settle();
    upright.settle();
    CHECK(std::abs(chain.sag() - upright.sag()) <= 1e-9);
}

}  // namespace cable_catenary_test
