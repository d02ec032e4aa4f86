// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/output/surface.hpp>
#include <ancf/output/vtk.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <support/bar.hpp>
#include <support/catch.hpp>
#include <support/grouped.hpp>
#include <support/random_state.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace surface_test {

using Point = ancf::Vector<double, 3>;

const ancf::Material steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);

/// A straight beam of three elements in any direction.
template <class Element>
struct Scene {
    explicit Scene(const ancf::Section& shape = ancf::rectangle(0.2, 0.1))
        : section(shape), beam(ancf::straight_beam<Element>(model, steel, section, from, to, 3)) {}

    /// Turns every vector of every node and moves the nodes.
    void move(const ancf::Matrix<double, 3>& rotation, const Point& shift) {
        for (int node = 0; node < model.nodes(); ++node)
            for (const auto field :
                 {ancf::Field::r, ancf::Field::r_x, ancf::Field::r_y, ancf::Field::r_z}) {
                Point value = rotation * model.value({node}, field);
                if (field == ancf::Field::r) value += shift;
                model.set_value({node}, field, value);
            }
    }

    Point from{0.5, -0.25, 1.0};
    Point to{1.5, 0.75, 3.0};
    ancf::Section section;
    ancf::Model model;
    ancf::Beam<Element> beam;
};

/// Returns the volume within a closed surface of outward polygons, by the divergence theorem.
double volume(const ancf::Surface& surface) {
    double sum = 0.0;
    int first = 0;
    const auto point = [&](int k) {
        return surface
            .points()[static_cast<std::size_t>(surface.corners()[static_cast<std::size_t>(k)])];
    };
    for (const int end : surface.ends()) {
        for (int k = first + 1; k + 1 < end; ++k)
            sum += point(first).dot(Point(point(k).cross(Point(point(k + 1))))) / 6.0;
        first = end;
    }
    return sum;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns the numbers between an opening tag that contains `name` and the next closing tag.
std::vector<double> numbers(const std::string& text, const std::string& name) {
    const std::size_t tag = text.find(name);
    REQUIRE(tag != std::string::npos);
    const std::size_t first = text.find('>', tag + name.size()) + 1;
    std::istringstream in(text.substr(first, text.find('<', first) - first));
    return {std::istream_iterator<double>(in), {}};
}

/// A folder of its own that goes with the test.
struct Folder {
    Folder() : path(std::filesystem::temp_directory_path() / "ancf_output_test") {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::filesystem::path path;
};

TEMPLATE_TEST_CASE("deformed_shape: the outline stands where the element's position says",
                   "[output]", ancf::CrossSectionBeam<3>, ancf::ContinuumBeam<3>) {
    Scene<TestType> scene;
    const auto shape = ancf::deformed_shape(scene.model, scene.beam, scene.section, 5);
    REQUIRE(shape.size() == 15);
    const Point along = scene.to - scene.from;
    CHECK((shape.front().centre - scene.from).norm() <= 1e-15);
    CHECK((shape.back().centre - scene.to).norm() <= 1e-15);
    CHECK(shape.back().s == Approx(along.norm()).epsilon(1e-14));
    for (const auto& station : shape) {
        REQUIRE(station.outline.size() == 4);
        CHECK((station.centre - scene.from - station.s / along.norm() * along).norm() <= 1e-14);
        for (const Point& corner : station.outline) {
            const Point arm = corner - station.centre;
            CHECK(arm.norm() == Approx(std::hypot(0.1, 0.05)).epsilon(1e-13));
            CHECK(std::abs(arm.dot(along)) <= 1e-14);
        }
    }
    CHECK_THROWS_WITH(ancf::deformed_shape(scene.model, scene.beam, scene.section, 1),
                      ContainsSubstring("got 1"));
}

TEST_CASE(
    "deformed_shape, Surface: a station's s is the way along the line, whatever its parameter",
    "[output]") {
    // a straight line whose slope r_x grows from 1 to 3, so that s is the distance from its start
    const Point from(0.5, -0.25, 1.0);
    ancf::Model model;
    std::vector<ancf::CurvePoint<3>> points(3);
    for (int k = 0; k < 3; ++k) {
        points[k].position = from + (k + 0.5 * k * k) * Point::UnitX();
        points[k].slopes.setIdentity();
        points[k].slopes(0, 0) = 1.0 + k;
    }
    const ancf::Section section = ancf::rectangle(0.2, 0.1);
    const auto beam =
        ancf::beam_through<ancf::CrossSectionBeam<3>>(model, steel, section, points, {1.0, 1.0});
    const auto shape = ancf::deformed_shape(model, beam, section, 5);
    REQUIRE(shape.size() == 10);
    for (const auto& station : shape)  // round-off, 4e-16 measured; 0.13 by the parameter
        CHECK(std::abs((station.centre - from).norm() - station.s) <= 1e-14);
    ancf::Surface surface;
    surface.add(model, beam, section, 5);
    const auto& place = surface.arrays()[ancf::Surface::place].values;
    REQUIRE(place.size() == 40);
    for (std::size_t k = 0; k < place.size(); ++k) CHECK(place[k] == shape[k / 4].s);
}

TEST_CASE("write_shape: one column per coordinate of the outline", "[output]") {
    const Scene<ancf::ContinuumBeam<3>> scene;
    std::ostringstream out;
    ancf::write_shape(out, ancf::deformed_shape(scene.model, scene.beam, scene.section, 2));
    std::istringstream lines(out.str());
    std::string line;
    std::getline(lines, line);
    CHECK(line == "s,x,y,z,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3");
    std::getline(lines, line);
    CHECK(line.rfind("0,0.5,-0.25,1,", 0) == 0);
    CHECK_THROWS_AS(ancf::write_shape(out, {}), ancf::InvalidArgument);
}

TEMPLATE_TEST_CASE("Surface: closed, outward, and of the beam's volume in any position", "[output]",
                   ancf::CrossSectionBeam<3>, ancf::ContinuumBeam<3>) {
    ancf::test::Random random(7);
    for (const auto& section : {ancf::rectangle(0.2, 0.1), ancf::circle(0.1)}) {
        Scene<TestType> scene(section);
        double area = 0.0;  // of the outline: a circle is drawn as a polygon
        const auto& outline = section.outline();
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const auto& a = outline[k];
            const auto& b = outline[(k + 1) % outline.size()];
            area += (a.y * b.z - b.y * a.z) / 2.0;
        }
        for (int motion = 0; motion < 3; ++motion) {
            if (motion > 0)
                scene.move(ancf::test::rotation(3.0 * random.vector<3>()), random.vector<3>());
            ancf::Surface surface;
            surface.add(scene.model, scene.beam, section, 4);
            CHECK(volume(surface) == Approx(area * std::sqrt(6.0)).epsilon(1e-12));
        }
    }
}

TEMPLATE_TEST_CASE("Surface: section results are those of a bar under tension", "[output]",
                   ancf::CrossSectionBeam<3>, ancf::ContinuumBeam<3>) {
    Scene<TestType> scene;
    const double stretch = 1.0 + 1e-6;
    for (int node = 0; node < scene.model.nodes(); ++node) {
        const Point place = scene.model.position({node}) - scene.from;
        scene.model.set_value({node}, ancf::Field::r, scene.from + stretch * place);
        scene.model.set_value({node}, ancf::Field::r_x,
                              stretch * scene.model.value({node}, ancf::Field::r_x));
    }
    ancf::Surface surface;
    surface.add(scene.model, scene.beam, scene.section, 3);
    const auto& arrays = surface.arrays();
    const double stress = 2.07e11 * (stretch * stretch - 1.0) / 2.0;
    const std::size_t points = surface.points().size();
    REQUIRE(points == 3 * 3 * 4);
    REQUIRE(arrays[ancf::Surface::force].values.size() == 3 * points);
    for (std::size_t k = 0; k < points; ++k) {
        CHECK(arrays[ancf::Surface::axial_stress].values[k] == Approx(stress).epsilon(1e-8));
        const double* force = &arrays[ancf::Surface::force].values[3 * k];
        CHECK(force[0] == Approx(0.02 * stress * stretch).epsilon(1e-8));
        CHECK(std::abs(force[1]) + std::abs(force[2]) <= 1e-8 * force[0]);
        const double* moment = &arrays[ancf::Surface::moment].values[3 * k];
        CHECK(std::abs(moment[0]) + std::abs(moment[1]) + std::abs(moment[2]) <= 1e-8 * force[0]);
    }
}

TEST_CASE("Surface: velocities are those of a rigid rotation", "[output]") {
    using Element = ancf::CrossSectionBeam<3>;
    Scene<Element> scene;
    const Point spin(0.3, -0.2, 0.9);
    scene.model.set_rigid_rates(Point(Point::Zero()), spin);
    ancf::Surface surface;
    surface.add(scene.model, scene.beam, scene.section, 3);
    const auto& values = surface.arrays()[ancf::Surface::velocity].values;
    REQUIRE(values.size() == 3 * surface.points().size());
    for (std::size_t k = 0; k < surface.points().size(); ++k) {
        const Point expected = spin.cross(surface.points()[k]);
        CHECK((Eigen::Map<const Point>(&values[3 * k]) - expected).norm() <= 1e-14);
    }
}

TEST_CASE("Surface: two beams of one scene stand side by side", "[output]") {
    using Element = ancf::ContinuumBeam<3>;
    ancf::Model model;
    const auto section = ancf::rectangle(0.1, 0.1);
    const auto first = ancf::straight_beam<Element>(model, steel, section, {0, 0, 0}, {1, 0, 0}, 1);
    const auto second =
        ancf::straight_beam<Element>(model, steel, section, {0, 5, 0}, {2, 5, 0}, 2);
    ancf::Surface surface;
    surface.add(model, first, section, 2);
    surface.add(model, second, section, 2);
    CHECK(volume(surface) == Approx(0.03).epsilon(1e-12));
    CHECK(surface.ends().size() == 3 * 4 + 2 * 2);
    CHECK_THROWS_WITH(surface.add(model, first, section.with_outline({{0, 0}, {1, 0}})),
                      ContainsSubstring("got 2"));
    CHECK_THROWS_WITH(surface.add(model, ancf::Beam<Element>(), section),
                      ContainsSubstring("no elements"));
}

/// A bar that offers its place and nothing else.
struct PlacedBar : ancf::test::Bar<3> {
    using Bar::Bar;
    static Point position(const Coordinates& e, double xi, double y, double z) {
        return (1.0 - xi) * e.head<3>() + xi * e.tail<3>() + Point(0.0, y, z);
    }
};

TEST_CASE("Surface: what an element does not offer is zero", "[output]") {
    ancf::Model model;
    ancf::Beam<PlacedBar> beam;
    beam.nodes = {model.add_node({0.0, 0.0, 0.0}), model.add_node({2.0, 0.0, 0.0})};
    beam.elements = {model.connect<PlacedBar>(model.add_prototype(PlacedBar(1.0, 1.0, 2.0)),
                                              beam.first(), beam.last())};
    model.set_rate(beam.last(), ancf::Field::r, {1.0, 1.0, 1.0});
    ancf::Surface surface;
    surface.add(model, beam, ancf::rectangle(0.5, 0.25), 2);
    CHECK(volume(surface) == Approx(0.25).epsilon(1e-12));
    for (const auto array : {ancf::Surface::velocity, ancf::Surface::axial_stress})
        for (const double value : surface.arrays()[array].values) CHECK(value == 0.0);
}

TEMPLATE_TEST_CASE("Surface: a planar beam is drawn with its width normal to the plane", "[output]",
                   ancf::ContinuumBeam<2>, ancf::CrossSectionBeam<2>) {
    using Element = TestType;
    ancf::PlanarModel model;
    const auto section = ancf::rectangle(0.2, 0.1);
    const auto beam = ancf::straight_beam<Element>(model, steel, section, {0, 0}, {3, 4}, 2);
    model.state().v.setConstant(1.0);
    ancf::Surface surface;
    surface.add(model, beam, section, 3);
    CHECK(volume(surface) == Approx(5.0 * 0.02).epsilon(1e-12));
    CHECK(surface.arrays()[ancf::Surface::velocity].values[2] == 0.0);
}

TEST_CASE("write_vtk: the XML files hold every point, polygon and array", "[output]") {
    Scene<ancf::CrossSectionBeam<3>> scene;
    ancf::Surface surface;
    surface.add(scene.model, scene.beam, scene.section, 3);
    const Folder folder;
    for (const char* name : {"beam.vtp", "beam.vtu"}) {
        ancf::write_vtk(folder.path / name, surface, 0.25);
        const std::string text = text_of(folder.path / name);
        INFO(name);
        const std::size_t points = surface.points().size();
        CHECK(text.find("NumberOfPoints=\"" + std::to_string(points) + "\"") != std::string::npos);
        const auto coordinates = numbers(text, "<Points>\n<DataArray");
        REQUIRE(coordinates.size() == 3 * points);
        for (std::size_t k = 0; k < coordinates.size(); ++k)
            CHECK(coordinates[k] == surface.points()[k / 3][static_cast<Eigen::Index>(k % 3)]);
        CHECK(numbers(text, "Name=\"connectivity\"").size() == surface.corners().size());
        CHECK(numbers(text, "Name=\"offsets\"").back() ==
              static_cast<double>(surface.corners().size()));
        CHECK(numbers(text, "Name=\"TimeValue\"") == std::vector<double>{0.25});
        for (const auto& array : surface.arrays())
            CHECK(numbers(text, "Name=\"" + array.name + "\"") == array.values);
        // every tag that opens closes, in order
        std::vector<std::string> open;
        const std::regex tag("<(/?)([A-Za-z]+)[^>]*?(/?)>");
        int tags = 0;
        for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it, ++tags) {
            if ((*it)[1] == "/") {
                REQUIRE(!open.empty());
                CHECK(open.back() == (*it)[2]);
                open.pop_back();
            } else if ((*it)[3] != "/") {
                open.push_back((*it)[2]);
            }
        }
        CHECK(open.empty());
        CHECK(tags >= 30);
    }
    CHECK(numbers(text_of(folder.path / "beam.vtu"), "Name=\"types\"") ==
          std::vector<double>(surface.ends().size(), 7.0));
}

TEST_CASE("write_vtk: the legacy file counts what it holds", "[output]") {
    Scene<ancf::CrossSectionBeam<3>> scene;
    ancf::Surface surface;
    surface.add(scene.model, scene.beam, scene.section, 2);
    std::ostringstream out;
    ancf::write_vtk(out, surface, ancf::VtkFormat::legacy, 1.5);
    std::istringstream in(out.str());
    std::string word;
    std::map<std::string, std::size_t> counts;
    while (in >> word)
        if (word == "POINTS" || word == "POLYGONS" || word == "POINT_DATA") in >> counts[word];
    CHECK(out.str().rfind("# vtk DataFile Version 3.0\n", 0) == 0);
    CHECK(counts["POINTS"] == surface.points().size());
    CHECK(counts["POLYGONS"] == surface.ends().size());
    CHECK(counts["POINT_DATA"] == surface.points().size());
}

TEST_CASE("write_vtk: the stream's locale changes nothing and stays", "[output]") {
    Scene<ancf::CrossSectionBeam<3>> scene;
    ancf::Surface surface;
    surface.add(scene.model, scene.beam, scene.section, 2);
    for (const auto format :
         {ancf::VtkFormat::legacy, ancf::VtkFormat::vtp, ancf::VtkFormat::vtu}) {
        std::ostringstream plain, grouped;
        grouped.imbue(ancf::test::grouped());
        ancf::write_vtk(plain, surface, format, 1.5);
        ancf::write_vtk(grouped, surface, format, 1.5);
        CHECK(grouped.str() == plain.str());
        CHECK(std::use_facet<std::numpunct<char>>(grouped.getloc()).grouping() == "\1");
    }
}

TEST_CASE("write_vtk: files that cannot be written are refused by name", "[output]") {
    const ancf::Surface surface;
    CHECK_THROWS_WITH(ancf::write_vtk("beam.stl", surface), ContainsSubstring("beam.stl"));
    CHECK_THROWS_WITH(ancf::write_vtk("beam", surface), ContainsSubstring(".vtp, .vtu or .vtk"));
    CHECK_THROWS_WITH(ancf::write_vtk("/no/such/folder/beam.vtp", surface),
                      ContainsSubstring("/no/such/folder/beam.vtp"));
    CHECK_THROWS_WITH(ancf::write_vtk_pieces("beam.vtu", surface, {}), ContainsSubstring(".pvtu"));
    CHECK_THROWS_WITH(ancf::write_vtk_pieces("beam.pvtu", surface, {"a&b_0.vtu"}),
                      ContainsSubstring("a&b_0.vtu"));
}

TEST_CASE("write_vtk: a full disk is refused", "[output]") {
    Scene<ancf::CrossSectionBeam<3>> scene;
    ancf::Surface surface;
    surface.add(scene.model, scene.beam, scene.section);
    const Folder folder;
    for (const char* name : {"full.vtp", "full.vtu", "full.vtk"}) {
        std::filesystem::create_symlink("/dev/full", folder.path / name);
        CHECK_THROWS_WITH(ancf::write_vtk(folder.path / name, surface),
                          ContainsSubstring("could not write all of") && ContainsSubstring(name));
    }
}

TEST_CASE("VtkSeries: the index lists every frame with its time and is complete at once",
          "[output]") {
    Scene<ancf::CrossSectionBeam<3>> scene;
    const Folder folder;
    ancf::VtkSeries series(folder.path / "deep" / "er", "pendulum");
    for (int frame = 0; frame < 3; ++frame) {
        ancf::Surface surface;
        surface.add(scene.model, scene.beam, scene.section, 2);
        series.add(0.05 * frame, surface);
        const std::string text = text_of(series.index());
        const std::regex entry("timestep=\"([^\"]+)\" part=\"0\" file=\"([^\"]+)\"");
        int count = 0;
        for (std::sregex_iterator it(text.begin(), text.end(), entry), end; it != end;
             ++it, ++count) {
            CHECK(std::stod((*it)[1]) == 0.05 * count);
            CHECK(std::filesystem::exists(series.index().parent_path() / (*it)[2].str()));
        }
        CHECK(count == frame + 1);
        CHECK(text.find("</VTKFile>") != std::string::npos);
    }
    CHECK(series.size() == 3);
    CHECK_THROWS_WITH(ancf::VtkSeries(folder.path, "a/b"), ContainsSubstring("a/b"));
    CHECK_THROWS_AS(ancf::VtkSeries(folder.path, ""), ancf::InvalidArgument);
    std::ofstream(folder.path / "file") << "x";
    CHECK_THROWS_WITH(ancf::VtkSeries(folder.path / "file", "a"), ContainsSubstring("file"));
}

TEST_CASE("VtkSeries: an index that cannot be written at first can be later", "[output]") {
    const Folder folder;
    ancf::VtkSeries series(folder.path, "a");
    std::filesystem::create_directory(series.index());
    CHECK_THROWS_WITH(series.add(0.0, ancf::Surface()), ContainsSubstring("a.pvd"));
    CHECK(series.size() == 0);
    std::filesystem::remove(series.index());
    series.add(0.0, ancf::Surface());
    CHECK(series.size() == 1);
    CHECK_THAT(text_of(series.index()), ContainsSubstring("a_000000.vtp"));
}

}  // namespace surface_test
