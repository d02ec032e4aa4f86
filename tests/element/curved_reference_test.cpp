// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Beams whose stress-free state is curved, twisted or both.

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/element/planar/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_elements.hpp>
#include <support/complex_step.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace curved_reference_test {

using namespace ancf;
using test::Carried;
using test::Paper;
using test::Pointwise;
using Planar = CrossSectionBeam<2>;
using Solid = ContinuumBeam<3>;
using PlanarSolid = ContinuumBeam<2>;

template <class Element>
constexpr bool is_solid = std::is_same_v<typename Element::Options, ContinuumOptions>;

constexpr double range = 0.7;  // of the parameter x, m

/// One node of a reference: position and orthonormal slopes.
struct Frame {
    Vector<double, 3> position;
    Matrix<double, 3> slopes;
};

/// Returns nodal coordinates; in the plane the z slopes and components are left out.
template <class Element>
typename Element::Coordinates coordinates(const Frame& first, const Frame& second) {
    constexpr int dimension = Element::dimension;
    typename Element::Coordinates e;
    test::for_each_vector<Element>([&](int node, Field field, int at) {
        const Frame& frame = node == 0 ? first : second;
        const Vector<double, 3> v =
            field == Field::r ? frame.position
                              : Vector<double, 3>(frame.slopes.col(static_cast<int>(field) - 1));
        e.template segment<dimension>(at) = v.template head<dimension>();
    });
    return e;
}

Frame start() { return {Vector<double, 3>::Zero(), Matrix<double, 3>::Identity()}; }

/// The end of an arc of the given curvature in the plane.
Frame arc_end(double curvature, double length = range) {
    const double angle = curvature * length;
    return {{std::sin(angle) / curvature, (1.0 - std::cos(angle)) / curvature, 0.0},
            test::rotation(Vector<double, 3>(0.0, 0.0, angle))};
}

/// The end of a straight line whose section turns by an angle.
Frame twisted_end(double angle) {
    return {{range, 0.0, 0.0}, test::rotation(Vector<double, 3>(angle, 0.0, 0.0))};
}

/// The end of a line that leaves the plane, its section turned.
Frame skew_end() {
    return {{0.8 * range, 0.3 * range, -0.35 * range},
            test::rotation(Vector<double, 3>(0.5, 0.6, 0.4))};
}

/// A line with an inflection: shifted aside, the slopes parallel.
Frame shifted_end() { return {{0.95 * range, 0.25 * range, 0.0}, Matrix<double, 3>::Identity()}; }

/// References of one element; a sheared and stretched one stands for any coordinates.
template <class Element>
std::vector<typename Element::Coordinates> references() {
    std::vector<typename Element::Coordinates> all{coordinates<Element>(start(), arc_end(0.05)),
                                                   coordinates<Element>(start(), arc_end(-1.0)),
                                                   coordinates<Element>(start(), shifted_end())};
    if constexpr (Element::dimension == 3) {
        all.push_back(coordinates<Element>(start(), twisted_end(0.7)));
        all.push_back(coordinates<Element>(start(), skew_end()));
    }
    test::Random random(3);
    all.push_back(all[1] + 0.1 * random.vector<Element::dofs>());
    return all;
}

/// Returns options of every kind of element; a continuum beam takes another law, not another
/// transverse strain.
template <class Element>
typename Element::Options options(const char* rule, TransverseStrain transverse) {
    if constexpr (is_solid<Element>)
        return {Rule::named(rule), transverse == TransverseStrain::green
                                       ? ContinuumMaterial::diagonal
                                       : ContinuumMaterial::hooke};
    else
        return {Rule::named(rule), transverse, SectionModel::saint_venant};
}

/// A rule that suits every kind of element.
template <class Element>
constexpr const char* usual_rule = is_solid<Element> ? "paper" : "mixed";

template <class Element>
Element curved(const typename Element::Coordinates& reference,
               const char* rule = usual_rule<Element>,
               TransverseStrain transverse = TransverseStrain::stretch) {
    return {test::sample_material(), test::sample_odd_section(), reference, range,
            options<Element>(rule, transverse)};
}

/// Visits every reference with the rules and transverse strains; nodal shears need no third point.
template <class Element, class Visit>
int for_each_curved(const Visit& visit) {
    int count = 0;
    const std::vector<const char*> rules = is_solid<Element> || std::is_same_v<Element, Pointwise>
                                               ? std::vector<const char*>{"paper", "lobatto3"}
                                               : std::vector<const char*>{"paper", "mixed"};
    for (const auto& reference : references<Element>()) {
        for (const char* rule : rules) {
            for (const auto transverse : {TransverseStrain::green, TransverseStrain::stretch}) {
                INFO("reference " << reference.transpose() << ", rule " << rule);
                visit(curved<Element>(reference, rule, transverse), reference);
                ++count;
            }
        }
    }
    return count;
}

double axial_stiffness() {
    return test::sample_material().young * test::sample_odd_section().moments().area;
}

TEMPLATE_TEST_CASE("curved references: no force in the reference, however moved",
                   "[element][curved]", Paper, Carried, Pointwise, Planar, Solid, PlanarSolid) {
    constexpr int dimension = TestType::dimension;
    double force = 0.0, energy = 0.0;
    const int count = for_each_curved<TestType>([&](const auto& element, const auto& reference) {
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            test::Random random(seed);
            const auto turn = test::random_rotation<dimension>(random);
            const auto e =
                test::moved<TestType>(reference, turn, range * random.vector<dimension>());
            force = std::max(force, element.force(e).norm() / axial_stiffness());
            energy = std::max(energy, std::abs(element.energy(e)) / (axial_stiffness() * range));
        }
    });
    CHECK(count >= 16);
    CHECK(force <= 1e-13);   // asked for 1e-12
    CHECK(energy <= 1e-26);  // of second order in the rounding of e
}

TEMPLATE_TEST_CASE("curved references: exactly the rigid motions cost nothing", "[element][curved]",
                   Paper, Carried, Pointwise, Planar, Solid, PlanarSolid) {
    constexpr int dimension = TestType::dimension;
    constexpr int motions = dimension == 3 ? 6 : 3;
    double largest_rigid = 0.0, least_elastic = 1.0;
    const int count = for_each_curved<TestType>([&](const auto& element, const auto& reference) {
        typename TestType::Coordinates scale = TestType::Coordinates::Constant(1.0 / range);
        test::for_each_vector<TestType>([&](int, Field field, int first) {
            if (field == Field::r) scale.template segment<dimension>(first).setOnes();
        });
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            test::Random random(seed);
            const auto turn = test::random_rotation<dimension>(random);
            const auto e = test::moved<TestType>(reference, turn, random.vector<dimension>());
            const Matrix<double, TestType::dofs> tangent =
                scale.asDiagonal() * element.evaluate(e).tangent * scale.asDiagonal();
            VectorX values = test::eigenvalues(tangent);
            values /= values.maxCoeff();
            largest_rigid = std::max(largest_rigid, values.head(motions).cwiseAbs().maxCoeff());
            least_elastic = std::min(least_elastic, values(motions));
        }
    });
    CHECK(count >= 16);
    CHECK(largest_rigid <= 1e-13);
    CHECK(least_elastic >= 1e-5);  // the slopes' stretch and bending, (depth/length)^2
}

TEMPLATE_TEST_CASE("curved references: force and tangent equal the complex-step derivatives",
                   "[element][curved]", Paper, Carried, Pointwise, Planar, Solid, PlanarSolid) {
    constexpr int dimension = TestType::dimension;
    test::DerivativeErrors worst;
    const int count = for_each_curved<TestType>([&](const auto& element, const auto& reference) {
        const test::ComplexElement stepped(element);
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            test::Random random(seed);
            const auto turn = test::random_rotation<dimension>(random);
            const typename TestType::Coordinates bent =
                reference + 0.15 * random.vector<TestType::dofs>();
            const auto e = test::moved<TestType>(bent, turn, random.vector<dimension>());
            const auto [energy, force, tangent] = element.evaluate(e);
            test::raise(worst, {energy, force, tangent}, element.energy(e), element.force(e),
                        stepped, e);
        }
    });
    CHECK(count >= 16);
    CHECK(worst.force <= 1e-12);
    CHECK(worst.tangent <= 1e-12);
    CHECK(worst.symmetry <= 1e-14);
    CHECK(worst.pass <= 1e-12);
}

TEMPLATE_TEST_CASE(
    "curved references: a straight reference, however placed, is the straight element",
    "[element][curved]", Paper, Carried, Pointwise, Planar, Solid, PlanarSolid) {
    constexpr int dimension = TestType::dimension;
    const TestType straight(test::sample_material(), test::sample_odd_section(), range,
                            options<TestType>("paper", TransverseStrain::green));
    test::Random random(11);
    const auto turn = test::random_rotation<dimension>(random);
    const auto reference = test::moved<TestType>(test::reference_coordinates(straight), turn,
                                                 random.vector<dimension>());
    const auto given = curved<TestType>(reference, "paper", TransverseStrain::green);
    CHECK(given.length() == Approx(range).epsilon(1e-15));
    CHECK(test::relative_error(given.mass(), straight.mass()) <= 1e-14);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random state(seed);
        const auto e = test::random_state(straight, state);
        CHECK(test::relative_error(given.force(e), straight.force(e)) <= 1e-13);
        CHECK(test::relative_error(given.evaluate(e).tangent, straight.evaluate(e).tangent) <=
              1e-13);
    }
}

TEMPLATE_TEST_CASE("curved references: a parameter of another speed leaves the element as it is",
                   "[element][curved]", Paper, Carried, Planar, Solid, PlanarSolid) {
    // the same curve, its parameter twice as fast: r_x is halved and the range doubled
    constexpr int dimension = TestType::dimension;
    const auto halved = [](typename TestType::Coordinates e) {
        test::for_each_vector<TestType>([&](int, Field field, int first) {
            if (field == Field::r_x) e.template segment<dimension>(first) *= 0.5;
        });
        return e;
    };
    for (const auto& reference : references<TestType>()) {
        const auto slow = curved<TestType>(reference);
        const TestType fast(test::sample_material(), test::sample_odd_section(), halved(reference),
                            2.0 * range, slow.options());
        CHECK(fast.length() == Approx(slow.length()).epsilon(1e-14));
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            test::Random random(seed);
            const typename TestType::Coordinates e =
                reference + 0.1 * random.vector<TestType::dofs>();
            CHECK(fast.energy(halved(e)) == Approx(slow.energy(e)).epsilon(1e-12));
            const auto strain = slow.green_strain(e, 0.3, 0.01, 0.02);
            CHECK((fast.green_strain(halved(e), 0.3, 0.01, 0.02) - strain).norm() <= 1e-12);
        }
    }
}

TEMPLATE_TEST_CASE("curved references: mass and weight are those of the arc", "[element][curved]",
                   Paper, Planar, Solid, PlanarSolid) {
    constexpr int dimension = TestType::dimension;
    const double curvature = 1.0 / 3.0, angle = curvature * range;
    const auto reference = coordinates<TestType>(start(), arc_end(curvature));
    const TestType element(test::sample_material(), test::sample_rectangle(), reference, range);
    const Moments moments = test::sample_rectangle().moments();
    const double mass = test::sample_material().density * moments.area * element.length();
    // the Hermite line runs inside the arc and is shorter by angle^4/720, 4e-6 of it
    CHECK(1.0 - element.length() / range == Approx(std::pow(angle, 4) / 720.0).epsilon(0.01));

    const Vector<double, dimension> g = 9.81 * Vector<double, dimension>::Unit(1);
    const auto weight = element.gravity(g);
    Vector<double, dimension> sum = Vector<double, dimension>::Zero();
    test::for_each_vector<TestType>([&](int, Field field, int first) {
        if (field == Field::r) sum += weight.template segment<dimension>(first);
    });
    CHECK((sum - mass * g).norm() <= 1e-13 * mass * g.norm());
    const double height = (1.0 - std::sin(angle) / angle) / curvature;
    CHECK(weight.dot(reference) == Approx(9.81 * mass * height).epsilon(1e-3));

    // rotary inertia about the centre of the circle, the section's own included
    const Vector<double, 2> centre(0.0, 1.0 / curvature);
    typename TestType::Coordinates rate = TestType::Coordinates::Zero();
    test::for_each_vector<TestType>([&](int, Field field, int first) {
        Vector<double, 2> r = reference.template segment<2>(first);
        if (field == Field::r) r -= centre;
        rate.template segment<2>(first) << -r[1], r[0];
    });
    const double inertia = mass * (1.0 / (curvature * curvature) + moments.yy / moments.area);
    CHECK(rate.dot(element.mass() * rate) == Approx(inertia).epsilon(2e-5));
    CHECK(test::eigenvalues(element.mass()).minCoeff() > 0.0);
    // a force per length of the arc sums to the force on its length
    const auto line = element.line_load(g);
    Vector<double, dimension> total = Vector<double, dimension>::Zero();
    test::for_each_vector<TestType>([&](int, Field field, int first) {
        if (field == Field::r) total += line.template segment<dimension>(first);
    });
    CHECK((total - element.length() * g).norm() <= 1e-13 * g.norm());
}

TEMPLATE_TEST_CASE("curved references: an arc softens where it is short, not where it is bent",
                   "[element][curved]", Paper, Carried, Planar) {
    const auto reference = coordinates<TestType>(start(), arc_end(1.0));
    const TestType element(test::sample_material(), test::sample_rectangle(), reference, range);
    test::check_softened(element, reference, true);
    CHECK_FALSE(element.softened(coordinates<TestType>(start(), arc_end(1e-3))));
}

TEMPLATE_TEST_CASE("curved references: rotary inertia at the nodes is the whole of it",
                   "[element][curved]", Paper, Planar) {
    constexpr int dimension = TestType::dimension;
    const auto reference = coordinates<TestType>(start(), arc_end(1.0));
    const auto mass_of = [&](RotaryInertia inertia) {
        CrossSectionOptions options;
        options.rotary_inertia = inertia;
        return TestType(test::sample_material(), test::sample_rectangle(), reference, range,
                        options)
            .mass();
    };
    // sections that all turn alike
    typename TestType::Coordinates rate = TestType::Coordinates::Zero();
    test::for_each_vector<TestType>([&](int, Field field, int first) {
        if (field == Field::r_y) rate.template segment<dimension>(first).setOnes();
    });
    const auto lumped = mass_of(RotaryInertia::lumped),
               consistent = mass_of(RotaryInertia::consistent);
    const double energy = rate.dot(consistent * rate);
    CHECK(energy > 0.0);
    CHECK(rate.dot(lumped * rate) == Approx(energy).epsilon(1e-14));
    CHECK((lumped - consistent).norm() > 1e-3 * energy);
}

TEST_CASE("curved references: untwisting a twisted bar costs its torsional energy",
          "[element][curved]") {
    // directors turn uniformly when carried, so the energy is closed: G J om^2/2 and the fibres'
    // stretch
    const double angle = 0.7, om = angle / range;
    const Section section = test::sample_rectangle();
    const auto reference = coordinates<Carried>(start(), twisted_end(angle));
    const Carried element(test::sample_material(), section, reference, range,
                          {Rule::paper(), TransverseStrain::stretch, SectionModel::saint_venant});
    const auto straight = test::reference_coordinates(element);
    const Moments m = section.moments();
    const double twist = 0.5 * test::sample_material().shear * section.torsion_constant() * om * om;
    const double fibres =
        0.125 * test::sample_material().young * (m.yyyy + 2.0 * m.yyzz + m.zzzz) * std::pow(om, 4);
    CHECK(element.energy(straight) == Approx((twist + fibres) * range).epsilon(1e-12));
    CHECK(element.strains(reference, 0.4).norm() == 0.0);
    CHECK(element.section_forces(straight, 0.4).torque ==
          Approx(-test::sample_material().shear * section.torsion_constant() * om).epsilon(1e-2));
}

TEST_CASE("curved references: in the plane the spatial element agrees with the planar one",
          "[element][curved][planar]") {
    constexpr int place[12] = {0, 1, 3, 4, 6, 7, 12, 13, 15, 16, 18, 19};
    const Section section = test::sample_rectangle();
    const CrossSectionOptions options{Rule::mixed(), TransverseStrain::stretch,
                                      SectionModel::saint_venant};
    const auto lifted = [&](const Planar::Coordinates& e) {
        Paper::Coordinates result = Paper::Coordinates::Zero();
        for (int k = 0; k < 12; ++k) result[place[k]] = e[k];
        result[11] = result[23] = 1.0;
        return result;
    };
    int count = 0;
    for (const auto& reference : references<Planar>()) {
        const Planar flat(test::sample_material(), section, reference, range, options);
        const Paper full(test::sample_material(), section, lifted(reference), range, options);
        CHECK(flat.length() == Approx(full.length()).epsilon(1e-14));
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            test::Random random(seed);
            const Planar::Coordinates e = reference + 0.1 * random.vector<12>();
            const auto q = full.force(lifted(e));
            Planar::Coordinates expected;
            for (int k = 0; k < 12; ++k) expected[k] = q[place[k]];
            CHECK(flat.energy(e) == Approx(full.energy(lifted(e))).epsilon(1e-12));
            CHECK(test::relative_error(flat.force(e), expected) <= 1e-12);
            ++count;
        }
    }
    CHECK(count == 80);
}

TEST_CASE("curved references: elements side by side in a pack keep their own references",
          "[element][curved][pack]") {
    const auto all = references<Carried>();
    const auto bent = curved<Carried>(all[1]), twisted = curved<Carried>(all[3]);
    const auto both = Carried::together<2>({&bent, &twisted});
    test::Random random(8);
    const Carried::Coordinates e = all[1] + 0.1 * random.vector<24>();
    Vector<Pack<2>, 24> packed;
    for (int k = 0; k < 24; ++k) {
        packed[k] = Pack<2>(e[k]);
    }
    const auto force = both.force(packed);
    const auto first = bent.force(e), second = twisted.force(e);
    double worst = 0.0;
    for (int k = 0; k < 24; ++k) {
        worst = std::max(worst, std::abs(force[k][0] - first[k]) / first.norm());
        worst = std::max(worst, std::abs(force[k][1] - second[k]) / second.norm());
    }
    CHECK(worst <= 1e-14);
}

TEMPLATE_TEST_CASE("curved references: what is no reference is refused",
                   "[element][curved][bad-input]", Paper, Carried, Pointwise, Planar, Solid,
                   PlanarSolid) {
    constexpr int dimension = TestType::dimension;
    const auto good = coordinates<TestType>(start(), arc_end(1.0));
    const auto make = [](const typename TestType::Coordinates& reference, double length) {
        return TestType(test::sample_material(), test::sample_rectangle(), reference, length);
    };
    CHECK_NOTHROW(make(good, range));
    for (const double length : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity()})
        CHECK_THROWS_AS(make(good, length), InvalidArgument);
    int refused = 0;
    for (int k = 0; k < TestType::dofs; ++k) {
        auto broken = good;
        broken[k] = std::numeric_limits<double>::quiet_NaN();
        CHECK_THROWS_AS(make(broken, range), InvalidArgument);
        ++refused;
    }
    test::for_each_vector<TestType>([&](int node, Field field, int first) {
        if (field == Field::r) return;
        auto broken = good;
        broken.template segment<dimension>(first).setZero();
        CHECK_THROWS_AS(make(broken, range), InvalidArgument);
        ++refused;
        if (field == Field::r_x) return;
        const int tangent = dimension * (node * TestType::fields.count() + 1);
        broken.template segment<dimension>(first) = good.template segment<dimension>(tangent);
        CHECK_THROWS_AS(make(broken, range), InvalidArgument);
    });
    CHECK(refused >= TestType::dofs + 4);
}

}  // namespace curved_reference_test
