// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/model/model.hpp>

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>

#include <support/bar.hpp>
#include <support/catch.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <limits>
#include <utility>

namespace model_test {

using ancf::Field;
using ancf::InvalidArgument;
using Bar = ancf::test::Bar<3>;
using Beam = ancf::ContinuumBeam<3>;
using Scene = ancf::Model;
using Vector3 = ancf::Vector<double, 3>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
const auto material = ancf::Material::from_moduli(1e6, 4e5, 1000.0);
const auto section = ancf::rectangle(0.1, 0.2);

TEST_CASE("straight_beam: any direction gives unit slopes and equal elements", "[model]") {
    const Vector3 to = GENERATE(Vector3(2, 0, 0), Vector3(-2, 0, 0), Vector3(0, 0, 3),
                                Vector3(-1, 1e-9, 0), Vector3(1, -2, 0.5));
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, to, 4);
    REQUIRE(beam.nodes.size() == 5);
    CHECK(beam.prototypes.size() == 1);
    CHECK(scene.group<Beam>().prototypes.size() == 1);
    CHECK(scene.group<Beam>().element(3).length() == Approx(to.norm() / 4.0));
    CHECK((scene.position(beam.last()) - to).norm() <= 1e-15 * to.norm());
    ancf::Matrix<double, 3> slopes;
    slopes << scene.value(beam.node(2), Field::r_x), scene.value(beam.node(2), Field::r_y),
        scene.value(beam.node(2), Field::r_z);
    CHECK((slopes.transpose() * slopes - ancf::Matrix<double, 3>::Identity()).norm() <= 1e-14);
    CHECK(slopes.determinant() == Approx(1.0));
    CHECK((slopes.col(0) - to.normalized()).norm() <= 1e-14);
}

TEST_CASE("reference_slopes: along X the section axes are Y and Z", "[model]") {
    CHECK(ancf::reference_slopes(Vector3(3, 0, 0)) == ancf::Matrix<double, 3>::Identity());
    const auto turned = ancf::reference_slopes(Vector3(0, 1, 0), Vector3(0, 5, 2));
    CHECK((turned.col(1) - Vector3(0, 0, 1)).norm() <= 1e-15);
    const auto plane = ancf::reference_slopes(ancf::Vector<double, 2>(0, 2));
    CHECK(plane.col(1) == ancf::Vector<double, 2>(-1, 0));
}

TEST_CASE("Model: a state of another model is refused before it is read", "[model][bad-input]") {
    const auto chain = [](int elements) {
        Scene scene;
        static_cast<void>(
            ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {1, 0, 0}, elements));
        return scene;
    };
    for (const int elements : {1, 3}) {
        Scene scene = chain(2);
        scene.state() = chain(elements).state();
        CHECK_THROWS_AS(scene.position({1}), InvalidArgument);
        CHECK_THROWS_AS(scene.velocity({1}), InvalidArgument);
        CHECK_THROWS_AS(scene.set_value({1}, Field::r, {1, 1, 1}), InvalidArgument);
        scene.connect<Beam>(0, {0}, scene.add_node({0, 1, 0}));  // lays the state out anew
        CHECK_THROWS_AS(scene.state(), InvalidArgument);
        CHECK(scene.position({1})[0] == 0.5);  // where it was added
    }
}

TEST_CASE("Model: adding elements keeps the state of nodes that stand", "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {1, 0, 0}, 1);
    scene.set_value(beam.last(), Field::r, {1.0, 0.5, 0.0});
    scene.set_rate(beam.last(), Field::r_y, {0.0, 0.0, 7.0});
    const auto far = scene.add_node({3, 0, 0});
    CHECK(scene.layout().size(far.index) == 0);
    CHECK_THROWS_AS(scene.position(far), InvalidArgument);
    scene.connect<Bar>(scene.add_prototype(Bar(1, 1, 1)), beam.last(), far);
    CHECK(scene.position(beam.last()) == Vector3(1.0, 0.5, 0.0));
    CHECK(scene.position(far) == Vector3(3, 0, 0));
    CHECK(scene.state().v[scene.coordinate(beam.last(), Field::r_y) + 2] == 7.0);
    CHECK(scene.velocity(far).norm() == 0.0);
}

TEST_CASE("Model: value() reads a node out of any coordinates", "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {1, 0, 0}, 2);
    const ancf::VectorX all = ancf::VectorX::LinSpaced(scene.layout().size(), 0.0, 35.0);
    CHECK(scene.value(beam.nodes[1], Field::r_x, all) == Vector3(15, 16, 17));
    CHECK(scene.value(beam.last(), Field::r, scene.state().q) == Vector3(1, 0, 0));
    CHECK_THROWS_AS(scene.value(beam.last(), Field::r_xx, all), InvalidArgument);
    CHECK_THROWS_AS(scene.value(beam.last(), Field::r, all.head(35)), InvalidArgument);
}

TEST_CASE("tabular_amplitude: lines between points, constant outside", "[model][bad-input]") {
    const ancf::Amplitude table = ancf::tabular_amplitude({{1.0, 4.0}, {2.0, 6.0}, {4.0, 5.0}});
    for (const auto& [time, value] : {std::pair(-1.0, 4.0),
                                      {1.0, 4.0},
                                      {1.25, 4.5},
                                      {2.0, 6.0},
                                      {3.0, 5.5},
                                      {4.0, 5.0},
                                      {9.0, 5.0}})
        CHECK(table(time) == value);
    CHECK(ancf::tabular_amplitude({{3.0, 7.0}})(0.0) == 7.0);
    CHECK_THROWS_AS(ancf::tabular_amplitude({}), InvalidArgument);
    CHECK_THROWS_AS(ancf::tabular_amplitude({{1.0, 0.0}, {1.0, 1.0}}), InvalidArgument);
    CHECK_THROWS_AS(ancf::tabular_amplitude({{1.0, std::nan("")}}), InvalidArgument);
}

/// A beam that counts how often it is asked for its torsion.
struct CountedBeam : Beam {
    using Beam::Beam;
    static inline int asked = 0;
    [[nodiscard]] ancf::Vector<double, 2> torsion_stiffness() const {
        ++asked;
        return {3.0, 1.0};
    }
};

TEST_CASE("Model: beams and joints by turns are laid out once each, at the places of beams alone",
          "[model]") {
    constexpr int beams = 40;
    Scene alone, by_turns;
    ancf::NodeId end;
    CountedBeam::asked = 0;
    for (int k = 0; k < beams; ++k) {
        const auto add = [&](Scene& scene) {
            return ancf::straight_beam<CountedBeam>(scene, material, section, {1.0 * k, 0, 0},
                                                    {k + 1.0, 0, 0}, 1);
        };
        static_cast<void>(add(alone));
        const auto beam = add(by_turns);
        if (k > 0) {
            by_turns.add(ancf::Revolute(by_turns, end, beam.first(), {0, 0, 1}));
            by_turns.add(ancf::Weld(by_turns, end, beam.first()));
        }
        by_turns.add(ancf::Moment(beam.last(), {1, 0, 0}));
        end = beam.last();
    }
    CHECK(CountedBeam::asked == beams);  // each of one element
    CHECK(by_turns.state().q == alone.state().q);
    CHECK(by_turns.state().v == alone.state().v);
    CHECK(by_turns.state().multipliers.size() == 11 * (beams - 1));
    CHECK(by_turns.layout().torsion_share(end) == 0.75);
    CHECK(CountedBeam::asked == 2 * beams);
}

TEST_CASE("Model: a vector is read at any time between additions as the state has it", "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {2, 0, 0}, 2);
    scene.set_value(beam.last(), Field::r, {2.0, 0.5, 0.0});
    const auto side = ancf::straight_beam<Beam>(scene, material, section, {2, 0, 0}, {2, 3, 0}, 1);
    CHECK(scene.position(beam.last()) == Vector3(2.0, 0.5, 0.0));
    CHECK(scene.position(side.last()) == Vector3(2.0, 3.0, 0.0));
    SECTION("an attached one follows its node") {
        scene.attach(side.first(), beam.last());
        CHECK(scene.position(side.first()) == Vector3(2.0, 0.5, 0.0));
    }
    SECTION("one that gets more vectors stays") {
        scene.connect<Bar>(scene.add_prototype(Bar(1, 1, 1)), beam.last(), side.last());
        const auto far = scene.add_node({5, 0, 0});
        CHECK(scene.layout().size(far.index) == 0);
        scene.connect<Bar>(0, side.last(), far);
        CHECK(scene.position(far) == Vector3(5.0, 0.0, 0.0));
        CHECK(scene.position(beam.last()) == Vector3(2.0, 0.5, 0.0));
    }
    SECTION("so do multipliers and a copy made meanwhile") {
        scene.add(ancf::Pin<3>(beam.last(), side.first()));
        scene.state().multipliers.setConstant(7.0);
        scene.add(ancf::Weld(scene, side.last()));
        const Scene copy = scene;
        CHECK(copy.position(side.last()) == Vector3(2.0, 3.0, 0.0));
        CHECK(copy.state().multipliers.size() == 9);
        CHECK(copy.state().multipliers.head(3) == Vector3(7.0, 7.0, 7.0));
        CHECK(copy.state().multipliers.tail(6).norm() == 0.0);
    }
    const ancf::VectorX q = scene.state().q;
    CHECK(scene.position(beam.last()) == q.segment(scene.coordinate(beam.last(), Field::r), 3));
    CHECK(scene.position(side.last()) == q.segment(scene.coordinate(side.last(), Field::r), 3));
}

TEST_CASE("Model: element coordinates are the fields of both nodes in order", "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {2, 0, 0}, 2);
    const Beam::Coordinates e = scene.element_coordinates<Beam>(1);
    Beam::Coordinates expected;
    expected << 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    CHECK(e == expected);
    CHECK_THROWS_AS(scene.element_coordinates<Beam>(2), InvalidArgument);
}

TEST_CASE("Model: an element's own prototype changes it and no other", "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {2, 0, 0}, 4);
    const int own = scene.make_own_prototype<Beam>(beam.elements[2]);
    CHECK(own == 1);
    CHECK(scene.make_own_prototype<Beam>(beam.elements[2]) == own);  // nothing left to copy
    REQUIRE(scene.group<Beam>().prototypes.size() == 2);
    CHECK(scene.group<Beam>().element(2).length() == 0.5);
    scene.prototype<Beam>(own) = Beam(material, section, 0.4);
    for (int k = 0; k < 4; ++k)
        CHECK(scene.group<Beam>().element(k).length() == (k == 2 ? 0.4 : 0.5));
    scene.prototype<Beam>(beam.prototypes[0]) =
        Beam(material, section, 0.6);  // what still share it
    for (int k = 0; k < 4; ++k)
        CHECK(scene.group<Beam>().element(k).length() == (k == 2 ? 0.4 : 0.6));
    for (const int element : {0, 1, 3}) CHECK(scene.make_own_prototype<Beam>(element) < 4);
    CHECK(scene.group<Beam>().prototypes.size() == 4);  // the last one had its own by then
    CHECK_THROWS_AS(scene.make_own_prototype<Beam>(4), InvalidArgument);
    CHECK_THROWS_AS(scene.make_own_prototype<Beam>(-1), InvalidArgument);
}

TEST_CASE("Model: its revision tells changes of properties from those of the scene", "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {2, 0, 0}, 2);
    ancf::Revision before = scene.revision();
    const auto changed = [&] {
        const ancf::Revision now = scene.revision();
        const std::pair<bool, bool> result{now.scene != before.scene,
                                           now.properties != before.properties};
        before = now;
        return result;
    };
    const std::pair<bool, bool> nothing{false, false}, the_scene{true, false},
        properties{false, true};
    scene.set_value(beam.last(), Field::r, {2.0, 0.1, 0.0});
    static_cast<void>(scene.group<Beam>().element(0).length());
    CHECK(changed() == nothing);
    static_cast<void>(scene.prototype<Beam>(0));
    CHECK(changed() == properties);
    scene.set_gravity({0, 0, -9.81});
    CHECK(changed() == properties);
    scene.add_mass(beam.last(), 1.0);
    CHECK(changed() == properties);
    scene.pin(beam.first());
    CHECK(changed() == the_scene);
    scene.release(beam.first(), Field::r);
    CHECK(changed() == the_scene);
    scene.add(ancf::Force<3>(beam.last(), {1, 0, 0}));
    CHECK(changed() == the_scene);
    const auto far = scene.add_node({3, 0, 0});
    CHECK(changed() == the_scene);
    scene.connect<Beam>(0, beam.last(), far);
    CHECK(changed() == the_scene);
}

TEST_CASE("Model: supports replace one another and can be released", "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {2, 0, 0}, 1);
    scene.clamp(beam.first());
    CHECK(scene.supports().size() == 12);
    scene.clamp(beam.first());
    CHECK(scene.supports().size() == 12);
    scene.release(beam.first(), Field::r_x);
    CHECK(scene.supports().size() == 9);
    scene.clamp(beam.last(), ancf::Clamp::free_slope);
    CHECK(scene.supports().size() == 18);
    scene.prescribe(beam.last(), Field::r_y, 1, [](double t) { return t; });
    CHECK(scene.supports().size() == 18);
    int driven = 0;
    for (const ancf::Support& support : scene.supports()) {
        if (!support.value) continue;
        ++driven;
        CHECK(support.node == beam.last());
        CHECK(support.field == Field::r_y);
        CHECK(support.component == 1);
    }
    CHECK(driven == 1);
}

TEST_CASE("add_line_load: its resultant is the force per length times the length", "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {2, 1, 0}, 3);
    ancf::add_line_load(scene, beam, {0.0, -3.0, 1.0});
    REQUIRE(scene.loads().size() == 3);
    Vector3 sum = Vector3::Zero();
    for (const auto& load : scene.loads()) {
        ancf::LoadResult out;
        out.force.setZero(24);
        out.stiffness.setZero(24, 24);
        load.load.evaluate({ancf::VectorX::Zero(24), ancf::VectorX::Zero(24), 0.0}, out);
        sum += out.force.segment<3>(0) + out.force.segment<3>(12);
        // Hermite: l^2/12 on the slope, l the element's length
        const double length = std::sqrt(5.0) / 3.0;
        CHECK(out.force[4] == Approx(-3.0 * length * length / 12.0));
    }
    CHECK((sum - std::sqrt(5.0) * Vector3(0, -3, 1)).norm() <= 1e-14);
}

TEST_CASE("Model: rigid rates are those of a body that spins about a point", "[model]") {
    Scene scene;
    const auto turning =
        ancf::straight_beam<Beam>(scene, material, section, {0, 1, 0}, {1, 1, 2}, 2);
    const auto still = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {1, 0, 0}, 1);
    const Vector3 velocity(0.5, -1.0, 2.0), spin(0.3, 2.0, -1.0), about(0.1, 0.2, 0.3);
    scene.set_rigid_rates(turning.nodes, velocity, spin, about);
    constexpr double step = 1e-7;  // s
    const auto before = scene.state();
    const ancf::Matrix<double, 3> turn(Eigen::AngleAxisd(step * spin.norm(), spin.normalized()));
    for (const ancf::NodeId node : turning.nodes) {
        const Vector3 place = scene.position(node);
        const Vector3 moved = about + turn * (place - about) + step * velocity;
        CHECK((moved - place - step * scene.velocity(node)).norm() < 1e-12);
        for (const Field field : {Field::r_x, Field::r_y, Field::r_z}) {
            const Vector3 slope = scene.value(node, field);
            const int first = scene.layout().index({node, field});
            const Vector3 rate = before.v.segment<3>(first);
            CHECK((turn * slope - slope - step * rate).norm() < 1e-12);
        }
    }
    CHECK(scene.velocity(still.last()) == Vector3(0, 0, 0));
}

TEST_CASE("Model: rigid rates move what is attached with what it follows", "[model]") {
    ancf::PlanarModel model;
    const auto built = ancf::frame<ancf::CrossSectionBeam<2>>(
        model, {{material, section}}, {{0, 0}, {1, 0}, {0, 1}}, {{0, 1}, {1, 2}});
    model.set_rigid_rates({1.0, 2.0}, 3.0);
    const auto& state = model.state();
    for (int first = 0; first < model.layout().size(); first += 2) {
        const double still = model.layout().field_of(first) == Field::r ? 1.0 : 0.0;
        CHECK(state.v[first] == Approx(still - 3.0 * state.q[first + 1]).margin(1e-14));
        CHECK(state.v[first + 1] == Approx(2.0 * still + 3.0 * state.q[first]).margin(1e-14));
    }
}

TEST_CASE("Model: no element widens a node that was clamped or attached", "[model][bad-input]") {
    using Element = ancf::CrossSectionBeam<2>;
    const auto build = [](auto&& hold, bool release) {
        ancf::PlanarModel model;
        const auto beam = model.add_prototype(Element(material, section, 1.0));
        const auto first = model.add_node({0, 0}), second = model.add_node({1, 0});
        const auto wall = ancf::straight_beam<Element>(model, material, section, {0, 0}, {0, 1}, 1);
        model.add_mass(first, 1.0);
        hold(model, first, wall.first());
        if (release) model.release(first, Field::r);
        model.connect<Element>(beam, first, second);
    };
    const auto clamps = [](auto& model, auto node, auto) { model.clamp(node); };
    const auto attaches = [](auto& model, auto node, auto joint) { model.attach(node, joint); };
    const auto pins = [](auto& model, auto node, auto) { model.pin(node); };
    constexpr const char* message = "node 0 would carry more vectors than when it was clamped";
    CHECK_THROWS_WITH(build(clamps, false), ContainsSubstring(message));
    CHECK_THROWS_WITH(build(attaches, false), ContainsSubstring(message));
    CHECK_NOTHROW(build(clamps, true));
    CHECK_NOTHROW(build(pins, false));
}

TEST_CASE("Model: calls that cannot be meant are refused", "[model][bad-input]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {1, 0, 0}, 1);
    const ancf::NodeId absent{7};
    const int bar = scene.add_prototype(Bar(1, 1, 1));
    CHECK_THROWS_AS(scene.add_node({0, not_a_number, 0}), InvalidArgument);
    CHECK_THROWS_AS(scene.connect<Bar>(bar, beam.first(), beam.first()), InvalidArgument);
    CHECK_THROWS_AS(scene.connect<Bar>(bar, beam.first(), absent), InvalidArgument);
    CHECK_THROWS_AS(scene.connect<Bar>(bar + 1, beam.first(), beam.last()), InvalidArgument);
    CHECK_THROWS_AS(scene.connect<Bar>(-1, beam.first(), beam.last()), InvalidArgument);
    CHECK_THROWS_AS(scene.clamp(absent), InvalidArgument);
    CHECK_THROWS_WITH(scene.clamp(scene.add_node({0, 0, 0})),
                      ContainsSubstring("carries no vectors yet"));
    CHECK_THROWS_AS(scene.pin({-1}), InvalidArgument);
    CHECK_THROWS_AS(scene.fix(beam.first(), Field::r, 3), InvalidArgument);
    CHECK_THROWS_AS(scene.fix(beam.first(), Field::r, -1), InvalidArgument);
    const ancf::Amplitude rate = [](double t) { return t; };
    for (const bool first : {true, false})
        CHECK_THROWS_WITH(
            scene.prescribe(beam.last(), Field::r, 1, {}, first ? rate : nullptr,
                            first ? nullptr : rate),
            ContainsSubstring("r, component 1, of node 1") && ContainsSubstring("no value"));
    CHECK_THROWS_AS(scene.release(absent, Field::r), InvalidArgument);
    CHECK_THROWS_AS(scene.add(ancf::Force(absent, {1, 0, 0})), InvalidArgument);
    CHECK_THROWS_AS(scene.add_mass(beam.last(), 0.0), InvalidArgument);
    CHECK_THROWS_AS(scene.add_mass(beam.last(), not_a_number), InvalidArgument);
    CHECK_THROWS_AS(scene.add_mass(absent, 1.0), InvalidArgument);
    CHECK_THROWS_AS(scene.set_gravity({0, 0, not_a_number}), InvalidArgument);
    CHECK_THROWS_AS(scene.position(absent), InvalidArgument);
    CHECK_THROWS_AS(scene.set_rigid_rates({beam.last(), absent}, {1, 0, 0}, {0, 0, 1}),
                    InvalidArgument);
    CHECK(scene.state().v.isZero(0.0));
    CHECK_THROWS_WITH(scene.set_rigid_rates({0, 0, 0}, {0, 0, not_a_number}),
                      ContainsSubstring("must be finite"));
    CHECK_THROWS_AS(scene.prototype<Bar>(1), InvalidArgument);
    CHECK_THROWS_AS(beam.node(2), InvalidArgument);
    CHECK_THROWS_AS(ancf::add_line_load(scene, beam, {0, not_a_number, 0}), InvalidArgument);
    CHECK_THROWS_AS(ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {0, 0, 0}, 1),
                    InvalidArgument);
    CHECK_THROWS_AS(ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {1, 0, 0}, 0),
                    InvalidArgument);
    CHECK_THROWS_AS(
        ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {not_a_number, 0, 0}, 1),
        InvalidArgument);
    CHECK_THROWS_AS(ancf::reference_slopes(Vector3(1, 0, 0), Vector3(2, 0, 0)), InvalidArgument);
    CHECK_THROWS_AS(ancf::reference_slopes(Vector3(0, 0, 0)), InvalidArgument);
}

TEST_CASE("Model: one that is assigned counts as changed, one that was moved from too and is empty",
          "[model]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, material, section, {0, 0, 0}, {1, 0, 0}, 2);
    const Scene saved = scene;
    const ancf::Revision before = scene.revision();
    scene = saved;
    CHECK(scene.revision().scene > before.scene);
    CHECK(scene.revision().properties > before.properties);
    CHECK(scene.state().q == saved.state().q);
    CHECK(&scene.group<Beam>() != &saved.group<Beam>());

    const Scene moved = std::move(scene);
    CHECK(moved.position(beam.last()) == Vector3(1, 0, 0));
    CHECK(scene.nodes() == 0);
    CHECK(scene.layout().size() == 0);
    CHECK(scene.groups().empty());
    CHECK(scene.revision().scene > before.scene + 1);
    CHECK(scene.revision().properties > before.properties + 1);
    scene = moved;
    CHECK(scene.position(beam.last()) == Vector3(1, 0, 0));

    ancf::PlanarModel plane;
    ancf::Scene& any = plane;
    CHECK_THROWS_AS(any = moved, InvalidArgument);
    CHECK(any.dimension() == 2);
}

TEST_CASE("Model: elements, loads and constraints of another dimension are refused", "[model]") {
    Scene scene;
    ancf::Scene& any = scene;
    const ancf::NodeId node = scene.add_node({0, 0, 0});
    CHECK_THROWS_WITH(any.add(ancf::Force<2>(node, {0, 1})),
                      ContainsSubstring("a load of dimension 2 in a model of dimension 3"));
    CHECK_THROWS_WITH(any.add_prototype(ancf::ContinuumBeam<2>(material, section, 1.0)),
                      ContainsSubstring("an element of dimension 2 in a model of dimension 3"));
    CHECK_THROWS_WITH(scene.group<Beam>(), ContainsSubstring("ContinuumBeam<3"));
}

}  // namespace model_test
