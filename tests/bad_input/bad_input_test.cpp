// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A table of calls and files that cannot be meant. Each must throw InvalidArgument with a message
/// that names what is wrong, the value and what was expected; none may pass, crash or hang.

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/polygon.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/section/section.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace bad_input_test {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A call, and what its message must hold: the argument's name, the value, what was expected.
struct WrongCall {
    std::function<void()> call;
    std::vector<std::string> words;
};

std::string text(double value) {
    std::ostringstream out;
    out.precision(17);
    out << value;
    return out.str();
}

/// The calls that one argument makes wrong.
class Table {
public:
    void add(std::function<void()> call, std::vector<std::string> words) {
        calls.push_back({std::move(call), std::move(words)});
    }

    /// Every value that is not positive and finite.
    template <class Call>
    void positive(const std::string& name, Call call) {
        for (const double value : {nan, infinity, -infinity, 0.0, -0.0, -1.0, -1e-300})
            add([=] { static_cast<void>(call(value)); }, {name, text(value), "positive"});
    }

    /// Every value that is not finite.
    template <class Call>
    void finite(const std::string& name, Call call) {
        for (const double value : {nan, infinity, -infinity})
            add([=] { static_cast<void>(call(value)); }, {name, "finite", text(value)});
    }

    /// Whole numbers below a limit.
    template <class Call>
    void counts(const std::string& name, const std::vector<int>& values, Call call) {
        for (const int value : values)
            add([=] { static_cast<void>(call(value)); }, {name, std::to_string(value)});
    }

    std::vector<WrongCall> calls;
};

void add_materials(Table& table) {
    using ancf::Material;
    table.positive("young", [](double x) { return Material::isotropic(x, 0.3, 1.0); });
    table.positive("density", [](double x) { return Material::isotropic(1.0, 0.3, x); });
    for (const double x : {nan, infinity, -infinity, -1.0, -2.0, 0.6, 1.0})
        table.add([x] { static_cast<void>(Material::isotropic(1.0, x, 1.0)); },
                  {"poisson", text(x), "(-1, 0.5]"});
    table.positive("young", [](double x) { return Material::from_moduli(x, 1.0, 1.0); });
    table.positive("shear", [](double x) { return Material::from_moduli(1.0, x, 1.0); });
    table.positive("density", [](double x) { return Material::from_moduli(1.0, 1.0, x); });
}

void add_sections(Table& table) {
    using namespace ancf;
    table.add([] { static_cast<void>(hollow_rectangle(1.0, 0.2, 0.6, 0.12)); },
              {"no thicker than 1/4", "0.2"});
    table.positive("width", [](double x) { return rectangle(x, 1.0); });
    table.positive("height", [](double x) { return rectangle(1.0, x); });
    table.positive("radius", [](double x) { return circle(x); });
    table.positive("outer_radius", [](double x) { return tube(x, 0.5); });
    table.positive("inner_radius", [](double x) { return tube(1.0, x); });
    table.positive("width", [](double x) { return hollow_rectangle(x, 1.0, 0.5, 0.5); });
    table.positive("height", [](double x) { return hollow_rectangle(1.0, x, 0.5, 0.5); });
    table.positive("inner_width", [](double x) { return hollow_rectangle(1.0, 1.0, x, 0.5); });
    table.positive("inner_height", [](double x) { return hollow_rectangle(1.0, 1.0, 0.5, x); });
    table.positive("width", [](double x) { return i_section(x, 1.0, 0.1, 0.1); });
    table.positive("height", [](double x) { return i_section(1.0, x, 0.1, 0.1); });
    table.positive("web_thickness", [](double x) { return i_section(1.0, 1.0, x, 0.1); });
    table.positive("flange_thickness", [](double x) { return i_section(1.0, 1.0, 0.1, x); });
    const Section whole = rectangle(1.0, 1.0);
    table.positive("shear_correction_y",
                   [=](double x) { return whole.with_shear_correction(x, 1.0); });
    table.positive("shear_correction_z",
                   [=](double x) { return whole.with_shear_correction(1.0, x); });
    table.positive("torsion_constant", [=](double x) { return whole.with_torsion_constant(x); });
    table.finite("offset dy", [=](double x) { return offset(whole, x, 0.0); });
    table.finite("offset dz", [=](double x) { return offset(whole, 0.0, x); });
    for (const double x : {1.0, 2.0})
        table.add([x] { static_cast<void>(tube(1.0, x)); }, {"inner_radius", text(x), "less than"});
    for (const double x : {1.0, 2.0})
        table.add([x] { static_cast<void>(hollow_rectangle(1.0, 1.0, x, 0.5)); },
                  {"inner_width", text(x), "less than"});
    using Points = std::vector<SectionPoint>;
    for (const Points& points :
         {Points{}, Points{{0, 0}}, Points{{0, 0}, {1, 0}}, Points{{0, 0}, {0, 0}, {1, 1}},
          Points{{0, 0}, {1, 0}, {nan, 1}}, Points{{0, 0}, {1, 0}, {1, infinity}},
          Points{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, Points{{0, 0}, {2, 0}, {1, 0}}})
        table.add([points] { static_cast<void>(polygon(points, {})); }, {"polygon"});
}

void add_rules(Table& table) {
    using ancf::Rule;
    table.counts("[1, 16]", {-1, 0, 17, 1000}, [](int n) { return ancf::gauss_quadrature(n); });
    table.counts("[2, 5]", {-1, 0, 1, 6, 100}, [](int n) { return ancf::lobatto_quadrature(n); });
    table.counts("[1, 16]", {-1, 0, 17}, [](int n) { return Rule::gauss(n); });
    for (const char* name : {"", "Paper", "gauss", "gauss2 ", "lobatto", "mixed\n", "paper,mixed"})
        table.add([name] { static_cast<void>(Rule::named(name)); }, {name, "paper", "mixed"});
}

void add_loads(Table& table) {
    using namespace ancf;
    const NodeId node{0};
    for (int k = 0; k < 3; ++k) {
        const auto vector = [k](double x) {
            Vector<double, 3> v = Vector<double, 3>::Zero();
            v[k] = x;
            return v;
        };
        table.finite("Force", [=](double x) { return Force<3>(node, vector(x)); });
        table.finite("Moment", [=](double x) { return Moment(node, vector(x)); });
        table.finite("FollowerForce", [=](double x) { return FollowerForce(node, vector(x)); });
        table.finite("TangentMoment", [=](double x) { return TangentMoment(node, vector(x)); });
        for (const double x : {nan, infinity, -infinity})
            table.add([=] { SlopeMoment(node, Field::r_y, vector(x), 1.0); },
                      {"SlopeMoment", "axis", "length", text(x)});
        table.finite("GeneralisedForce", [=](double x) {
            return GeneralisedForce({{node, Field::r}}, vector(x));
        });
    }
    const Vector<double, 3> axis(1.0, 0.0, 0.0);
    table.finite("moment", [=](double x) { return SlopeMoment(node, Field::r_y, axis, x); });
    table.finite("moment", [=](double x) { return PlanarSlopeMoment(node, Field::r_y, x); });
    table.finite("PlanarFollowerForce", [=](double x) {
        return PlanarFollowerForce(node, {1.0, x});
    });
    table.add([=] { PlanarSlopeMoment(node, Field::r_z, 1.0); },
              {"PlanarSlopeMoment", "slope r_x or r_y", "got r_z"});
    const std::string few = "expected a vector of 3 components, got 2";
    table.add([=] { Force<3>(node, {0, -10}); }, {few + ": 0 -10"});
    table.add([=] { Moment(node, {0, 1}); }, {few});
    table.add([=] { FollowerForce(node, {0, 1}); }, {few});
    table.add([=] { Pin<3>(node, {0, 0}); }, {few});
    table.add([=] { Distance<3>(node, {0, 0}, 1.0); }, {few});
    table.add([=] { Model().add_node({0, 0}); }, {few});
    table.add([=] { Model().set_gravity({0, -10}); }, {few});
    table.add(
        [=] {
            Model model;
            straight_beam<Cable<3>>(model, Material::isotropic(1.0, 0.3, 1.0), rectangle(0.1, 0.1),
                                    {0, 0}, {1, 0}, 2);
        },
        {few});
    table.add([=] { SlopeMoment(node, Field::r_y, {0, 1}, 1.0); }, {few});
    table.add([=] { TangentMoment(node, {0, 1}); }, {few});
    for (const Field field : {Field::r, Field::r_xx}) {
        const std::string got = std::string("got ") + to_string(field);
        table.add([=] { SlopeMoment(node, field, axis, 1.0); }, {"SlopeMoment", "slope", got});
        table.add([=] { PlanarSlopeMoment(node, field, 1.0); },
                  {"PlanarSlopeMoment", "slope", got});
        table.add([=] { FrameAt(node, field, Field::r_y); }, {"FrameAt", "slope", got});
        table.add([=] { FrameAt(node, Field::r_y, field); }, {"FrameAt", "slope", got});
    }
}

/// A scene of two nodes, a new one for every call.
void add_scenes(Table& table) {
    using namespace ancf;
    const auto scene = [](const auto& call) {
        return [call](double x) {
            PlanarModel model;
            const NodeId first = model.add_node({0.0, 0.0}), second = model.add_node({1.0, 0.0});
            model.connect<Cable<2>>(model.add_prototype(Cable<2>(Material::isotropic(1.0, 0.3, 1.0),
                                                                 rectangle(0.1, 0.1), 1.0)),
                                    first, second);
            call(model, second, x);
            return 0;
        };
    };
    for (const Field field : {Field::r, Field::r_x})
        for (int k = 0; k < 2; ++k) {
            const auto vector = [k](double x) {
                Vector<double, 2> v = Vector<double, 2>::Zero();
                v[k] = x;
                return v;
            };
            table.finite("set_value", scene([=](auto& model, NodeId node, double x) {
                             model.set_value(node, field, vector(x));
                         }));
            table.finite("set_rate", scene([=](auto& model, NodeId node, double x) {
                             model.set_rate(node, field, vector(x));
                         }));
            table.finite("set_gravity", scene([=](auto& model, NodeId, double x) {
                             model.set_gravity(vector(x));
                         }));
        }
    for (const Field field : {Field::r, Field::r_z, Field::r_xx}) {
        const auto weld = scene(
            [=](auto& model, NodeId node, double) { PlanarWeld(model, NodeId{0}, node, field); });
        table.add([=] { weld(0.0); }, {"PlanarWeld", "slope", to_string(field)});
    }
    table.add(
        [] {
            Model model;
            model.add(Moment(model.add_node({0.0, 0.0, 0.0}), {0.0, 0.0, 1.0}));
        },
        {"Moment", "node 0", "connect its elements"});
    table.finite("Distance: the place must be finite", [=](double x) {
        return Distance<2>(NodeId{0}, {x, 0.0}, Motion{});
    });
    table.positive("mass",
                   scene([](auto& model, NodeId node, double x) { model.add_mass(node, x); }));
    table.counts("got node", {-1, 2, 1000},
                 scene([](auto& model, NodeId, double x) { model.pin({static_cast<int>(x)}); }));
    table.counts("GeneralisedForce", {0, 1, 3, 5}, scene([](auto& model, NodeId node, double x) {
                     const VectorX force = VectorX::Ones(static_cast<int>(x));
                     model.add(GeneralisedForce({{node, Field::r}}, force));
                 }));
}

void add_output(Table& table) {
    for (const int digits : {-1, 0, 18, 1000})
        table.add([digits] { static_cast<void>(ancf::number_text(1.0, digits)); },
                  {"digits", std::to_string(digits), "[1, 17]"});
    for (const char* name : {"a,b", "a\"b", "a\nb", "\r"})
        table.add(
            [name] {
                std::ostringstream out;
                ancf::CsvWriter(out, {"x", name});
            },
            {"CsvWriter", "comma"});
    table.add(
        [] {
            std::ostringstream out;
            ancf::CsvWriter(out, {});
        },
        {"CsvWriter", "none"});
}

/// A state file, each time with one line taken away, doubled or changed.
void add_files(Table& table) {
    ancf::SavedState saved;
    saved.state.q = ancf::VectorX::LinSpaced(4, 0.0, 1.0);
    saved.state.v = ancf::VectorX::LinSpaced(4, -1.0, 1.0);
    saved.state.multipliers = ancf::VectorX::Ones(1);
    saved.memory.integrator = "method";
    saved.memory.put("acceleration", saved.state.v);
    std::ostringstream out;
    ancf::write_state(out, saved);
    std::vector<std::string> lines;
    std::istringstream in(out.str());
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    const auto reading = [&table](const std::vector<std::string>& file) {
        std::string whole;
        for (const std::string& line : file) whole += line + "\n";
        table.add(
            [whole] {
                std::istringstream from(whole);
                static_cast<void>(ancf::read_state(from));
            },
            {"state file, line "});
    };
    for (std::size_t k = 0; k < lines.size(); ++k) {
        std::vector<std::string> file(lines.begin(), lines.begin() + static_cast<long>(k));
        reading(file);  // cut off
        for (const char* wrong : {"nan", "inf", "1e999", "word", "", "1 2", "0x1p0 ", "q -1",
                                  "q 99999999999", "\x01\xff"}) {
            file = lines;
            if (file[k] == wrong) continue;
            file[k] = wrong;
            reading(file);
        }
    }
    table.add([] { static_cast<void>(ancf::load_state("/no/such/folder/state")); },
              {"cannot read", "/no/such/folder/state"});
    table.add([=] { ancf::save_state("/no/such/folder/state", saved); },
              {"cannot write", "/no/such/folder/state"});
}

/// What is wrong with a call's answer; empty: nothing.
std::string fault(const WrongCall& wrong) {
    try {
        wrong.call();
    } catch (const ancf::InvalidArgument& error) {
        const std::string message = error.what();
        for (const std::string& word : wrong.words)
            if (message.find(word) == std::string::npos)
                return "the message lacks \"" + word + "\": " + message;
        return "";
    } catch (const std::exception& error) {
        return std::string("another exception: ") + error.what();
    }
    return "accepted; expected a message with \"" + wrong.words.front() + "\"";
}

TEST_CASE("bad input: every wrong call and file is refused with the value and what was expected",
          "[bad-input]") {
    Table table;
    add_materials(table);
    add_sections(table);
    add_rules(table);
    add_loads(table);
    add_scenes(table);
    add_output(table);
    add_files(table);
    std::size_t refused = 0;
    for (std::size_t k = 0; k < table.calls.size(); ++k) {
        const std::string found = fault(table.calls[k]);
        INFO("call " << k << ": " << found);
        CHECK(found.empty());
        refused += found.empty() ? 1 : 0;
    }
    WARN(refused << " wrong calls and files refused");
    CHECK(refused == 573);  // docs/bad-input.md states it
}

}  // namespace bad_input_test
