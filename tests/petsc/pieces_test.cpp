// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/output/surface.hpp>
#include <ancf/petsc/distributed_scene.hpp>

#include <petsc/scenes.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace pieces_test {

using namespace ancf;
using namespace petsc_test;

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    REQUIRE(in.is_open());
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns the value of an attribute of the first element of a name, from a place on.
std::string attribute(const std::string& text, const std::string& element, const std::string& name,
                      std::size_t from = 0) {
    const std::size_t at = text.find('<' + element + ' ', from), end = text.find('>', at);
    REQUIRE(end != std::string::npos);
    const std::size_t value = text.find(' ' + name + "=\"", at) + name.size() + 3;
    REQUIRE(value < end);
    return text.substr(value, text.find('"', value) - value);
}

/// Returns the numbers of the first array after a place.
std::vector<double> numbers(const std::string& text, std::size_t from) {
    const std::size_t begin = text.find('>', text.find("<DataArray", from)) + 1;
    std::istringstream in(text.substr(begin, text.find('<', begin) - begin));
    std::vector<double> result;
    for (double value = 0.0; in >> value;) result.push_back(value);
    return result;
}

/// A point with its reference length along the beam.
using Row = std::array<double, 4>;

/// Returns all points of a file of cells, and adds its polygons to a count.
std::vector<Row> rows_of(const std::string& text, std::size_t& polygons) {
    const std::vector<double> points = numbers(text, text.find("<Points>"));
    const std::vector<double> places = numbers(text, text.find("<PointData>"));
    REQUIRE(points.size() == 3 * places.size());
    REQUIRE(std::to_string(places.size()) == attribute(text, "Piece", "NumberOfPoints"));
    polygons += std::stoul(attribute(text, "Piece", "NumberOfCells"));
    std::vector<Row> rows;
    for (std::size_t k = 0; k < places.size(); ++k)
        rows.push_back({points[3 * k], points[3 * k + 1], points[3 * k + 2], places[k]});
    return rows;
}

TEST_CASE("DistributedScene: the pieces of a surface together are the surface of the whole scene",
          "[petsc]") {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("ancf_pieces_of_" + std::to_string(petsc::Session::ranks()));
    std::filesystem::create_directories(folder);
    const int elements = GENERATE(1, 12);  // one alone leaves processes without
    Model model;
    const auto beam = straight_beam<petsc_test::Beam>(model, steel, bar(), Point(0, 0, 0),
                                                      Point(1, 0, 0), elements);
    model.clamp(beam.first());
    model.add(Force<3>(beam.last(), Point(0, 10, -20)));
    petsc::DistributedScene statics(model);
    REQUIRE(statics.solve().status == Status::converged);
    Surface own;
    for (const auto& run : statics.runs(beam))
        own.add(statics.part(), run.beam, bar(), 3, run.start);
    statics.write_vtk(folder / "beam.pvtu", own, 0.25);
    MPI_Barrier(PETSC_COMM_WORLD);

    statics.gather();
    Surface whole;
    whole.add(model, beam, bar(), 3);
    std::vector<Row> expected, found;
    for (std::size_t k = 0; k < whole.points().size(); ++k)
        expected.push_back({whole.points()[k][0], whole.points()[k][1], whole.points()[k][2],
                            whole.arrays()[Surface::place].values[k]});
    const std::string list = text_of(folder / "beam.pvtu");
    CHECK(attribute(list, "VTKFile", "type") == "PUnstructuredGrid");
    std::size_t pieces = 0, polygons = 0;
    for (std::size_t at = 0; (at = list.find("<Piece ", at)) != std::string::npos; ++at, ++pieces) {
        const std::string piece = text_of(folder / attribute(list, "Piece", "Source", at));
        CHECK(numbers(piece, piece.find("<FieldData>")) == std::vector<double>{0.25});
        for (const PointArray& array : whole.arrays()) {  // in both of them
            const std::string name = "Name=\"" + array.name + "\" NumberOfComponents=\"" +
                                     std::to_string(array.components.size()) + '"';
            CHECK_THAT(list, ContainsSubstring("<PDataArray type=\"Float64\" " + name));
            CHECK_THAT(piece, ContainsSubstring("<DataArray type=\"Float64\" " + name));
        }
        for (const Row& row : rows_of(piece, polygons)) found.push_back(row);
    }
    const auto ranks = static_cast<std::size_t>(petsc::Session::ranks());
    CHECK(pieces == (elements == 1 ? 1 : ranks));
    // each cut closes both of its sides, by a polygon each
    CHECK(polygons == whole.ends().size() + 2 * (pieces - 1));
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    REQUIRE(found.size() == expected.size());
    double worst = 0.0;
    for (std::size_t k = 0; k < found.size(); ++k)
        for (std::size_t i = 0; i < 4; ++i)
            worst = std::max(worst, std::abs(found[k][i] - expected[k][i]));
    CHECK(worst < 1e-12);
    MPI_Barrier(PETSC_COMM_WORLD);
    if (petsc::Session::rank() == 0) std::filesystem::remove_all(folder);
    MPI_Barrier(PETSC_COMM_WORLD);
}

TEST_CASE("DistributedScene: a type of element that came after the division is refused",
          "[petsc][refused]") {
    Model model = chain(4, 4);
    const petsc::DistributedScene statics(model);
    const auto later = straight_beam<Rope>(model, steel, bar(), {0, 0, 0}, {0, 1, 0}, 2);
    CHECK_THROWS_WITH(statics.runs(later), ContainsSubstring("divided"));
}

TEST_CASE("DistributedScene: a file that one process cannot write is an error in all", "[petsc]") {
    Model model = chain(2, 2);
    const petsc::DistributedScene statics(model);
    CHECK_THROWS_AS(statics.write_vtk("nowhere.vtu", Surface()), InvalidArgument);
    CHECK_THROWS_AS(statics.write_vtk("/no/such/folder/frame.pvtu", Surface()), std::exception);
}

}  // namespace pieces_test
