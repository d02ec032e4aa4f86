// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/output/vtk.hpp>

#include <ios>
#include <locale>
#include <ostream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace ancf {

namespace detail {

/// Writes values separated by blanks, a line break after every `per_line`.
template <class Values, class Text>
void write_list(std::ostream& out, const Values& values, std::size_t per_line, Text&& text) {
    std::size_t count = 0;
    for (const auto& value : values) {
        ++count;
        out << text(value) << (count % per_line == 0 || count == values.size() ? '\n' : ' ');
    }
}

/// Writes the points, components separated by blanks, one point a line.
ANCF_INLINE void write_points(std::ostream& out, const Surface& surface) {
    for (const Vector<double, 3>& point : surface.points())
        out << number_text(point[0]) << ' ' << number_text(point[1]) << ' ' << number_text(point[2])
            << '\n';
}

/// Writes the values of an array, one point a line.
ANCF_INLINE void write_values(std::ostream& out, const PointArray& array) {
    write_list(out, array.values, array.components.size(),
               [](double value) { return number_text(value); });
}

/// Writes one XML array of integers.
ANCF_INLINE void write_integers(std::ostream& out, std::string_view type, std::string_view name,
                                const std::vector<int>& values) {
    out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">\n";
    write_list(out, values, 12, [](int value) { return std::to_string(value); });
    out << "</DataArray>\n";
}

/// Opens the element of an array without its end.
ANCF_INLINE void begin_array(std::ostream& out, std::string_view element, const PointArray& array) {
    out << '<' << element << " type=\"Float64\" Name=\"" << array.name << "\" NumberOfComponents=\""
        << array.components.size() << '"';
    for (std::size_t k = 0; k < array.components.size(); ++k)
        out << " ComponentName" << k << "=\"" << array.components[k] << '"';
}

ANCF_INLINE void write_xml_arrays(std::ostream& out, const Surface& surface) {
    out << "<PointData>\n";
    for (const PointArray& array : surface.arrays()) {
        begin_array(out, "DataArray", array);
        out << " format=\"ascii\">\n";
        write_values(out, array);
        out << "</DataArray>\n";
    }
    out << "</PointData>\n"
        << "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    write_points(out, surface);
    out << "</DataArray>\n</Points>\n";
}

ANCF_INLINE void write_xml(std::ostream& out, const Surface& surface, VtkFormat format,
                           double time) {
    const bool polygons = format == VtkFormat::vtp;
    const char* const type = polygons ? "PolyData" : "UnstructuredGrid";
    const char* const cells = polygons ? "Polys" : "Cells";
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
        << "\" version=\"0.1\" byte_order=\"LittleEndian\">\n<" << type << ">\n"
        << "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
        << "format=\"ascii\">\n"
        << number_text(time) << "\n</DataArray>\n</FieldData>\n"
        << "<Piece NumberOfPoints=\"" << surface.points().size() << '"';
    if (polygons)
        out << " NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"";
    else
        out << " NumberOfCells=\"";
    out << surface.ends().size() << "\">\n";
    write_xml_arrays(out, surface);
    out << '<' << cells << ">\n";
    write_integers(out, "Int32", "connectivity", surface.corners());
    write_integers(out, "Int32", "offsets", surface.ends());
    constexpr int polygon_cell = 7;
    if (!polygons)
        write_integers(out, "UInt8", "types",
                       std::vector<int>(surface.ends().size(), polygon_cell));
    out << "</" << cells << ">\n</Piece>\n</" << type << ">\n</VTKFile>\n";
}

ANCF_INLINE void write_legacy(std::ostream& out, const Surface& surface, double time) {
    out << "# vtk DataFile Version 3.0\nancf\nASCII\nDATASET POLYDATA\n"
        << "FIELD FieldData 1\nTimeValue 1 1 double\n"
        << number_text(time) << '\n'
        << "POINTS " << surface.points().size() << " double\n";
    write_points(out, surface);
    const std::vector<int>& ends = surface.ends();
    out << "POLYGONS " << ends.size() << ' ' << ends.size() + surface.corners().size() << '\n';
    int first = 0;
    for (const int end : ends) {
        out << end - first;
        for (; first < end; ++first) out << ' ' << surface.corners()[first];
        out << '\n';
    }
    out << "POINT_DATA " << surface.points().size() << "\nFIELD results " << surface.arrays().size()
        << '\n';
    for (const PointArray& array : surface.arrays()) {
        out << array.name << ' ' << array.components.size() << ' ' << surface.points().size()
            << " double\n";
        write_values(out, array);
    }
}

ANCF_INLINE std::ofstream opened(const std::filesystem::path& file) {
    std::ofstream out(file);
    out.imbue(std::locale::classic());
    require(out.is_open(), "cannot write ", file.string());
    return out;
}

ANCF_INLINE void finish(std::ofstream& out, const std::filesystem::path& file) {
    out.close();
    require(!out.fail(), "could not write all of ", file.string());
}

}  // namespace detail

ANCF_INLINE VtkFormat vtk_format(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".vtp") return VtkFormat::vtp;
    if (extension == ".vtu") return VtkFormat::vtu;
    if (extension == ".vtk") return VtkFormat::legacy;
    detail::reject("a VTK file's name ends in .vtp, .vtu or .vtk, got ", file.string());
}

ANCF_INLINE void write_vtk(std::ostream& out, const Surface& surface, VtkFormat format,
                           double time) {
    std::ostringstream text;  // a file on a full disk takes no other locale
    text.imbue(std::locale::classic());
    if (format == VtkFormat::legacy)
        detail::write_legacy(text, surface, time);
    else
        detail::write_xml(text, surface, format, time);
    const std::string all = text.str();
    out.write(all.data(), static_cast<std::streamsize>(all.size()));
}

ANCF_INLINE void write_vtk(const std::filesystem::path& file, const Surface& surface, double time) {
    const VtkFormat format = vtk_format(file);
    std::ofstream out = detail::opened(file);
    write_vtk(out, surface, format, time);
    detail::finish(out, file);
}

ANCF_INLINE void write_vtk_pieces(const std::filesystem::path& file, const Surface& like,
                                  const std::vector<std::string>& pieces) {
    detail::require(file.extension() == ".pvtu",
                    "the file that lists the pieces of a surface ends in .pvtu, got ",
                    file.string());
    for (const std::string& piece : pieces)
        detail::require(piece.find_first_of("\"<>&") == std::string::npos,
                        "write_vtk_pieces: the name of a piece must have none of \"<>&, got ",
                        piece);
    std::ofstream out = detail::opened(file);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\" "
        << "byte_order=\"LittleEndian\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPointData>\n";
    for (const PointArray& array : like.arrays()) {
        detail::begin_array(out, "PDataArray", array);
        out << "/>\n";
    }
    out << "</PPointData>\n<PPoints>\n"
        << "<PDataArray type=\"Float64\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
    for (const std::string& piece : pieces) out << "<Piece Source=\"" << piece << "\"/>\n";
    out << "</PUnstructuredGrid>\n</VTKFile>\n";
    detail::finish(out, file);
}

ANCF_INLINE VtkSeries::VtkSeries(std::filesystem::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {
    detail::require(!name_.empty() && name_.find_first_of("/\\\"<>&") == std::string::npos,
                    "VtkSeries: the name must be a plain file name, got \"", name_, "\"");
    std::error_code failure;
    std::filesystem::create_directories(folder_, failure);
    detail::require(std::filesystem::is_directory(folder_, failure), "cannot make the folder ",
                    folder_.string());
}

ANCF_INLINE void VtkSeries::add(double time, const Surface& surface) {
    std::string number = std::to_string(frames_);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    const std::string file = name_ + '_' + number + ".vtp";
    write_vtk(folder_ / file, surface, time);

    if (!list_.is_open()) {
        list_ = detail::opened(index());
        list_ << "<?xml version=\"1.0\"?>\n"
              << "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
              << "<Collection>\n";
    }
    list_ << "<DataSet timestep=\"" << number_text(time) << "\" part=\"0\" file=\"" << file
          << "\"/>\n";
    const auto next = list_.tellp();
    list_ << "</Collection>\n</VTKFile>\n" << std::flush;
    list_.seekp(next);
    detail::require(!list_.fail(), "could not write all of ", index().string());
    ++frames_;
}

}  // namespace ancf
