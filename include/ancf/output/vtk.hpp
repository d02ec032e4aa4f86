// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Files for ParaView: a surface with its arrays, and series of them in time.
///
/// The file's extension chooses the format: .vtp (XML polygons), .vtu (XML cells) or .vtk (the
/// legacy text format), all in ASCII with 17 digits. A .pvd file lists the surfaces of a series.

#pragma once

#include <ancf/output/surface.hpp>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

namespace ancf {

/// The formats of a VTK file.
enum class VtkFormat { vtp, vtu, legacy };

/// Returns the format of a file name's extension.
/// @throws InvalidArgument naming the file, for another extension than .vtp, .vtu and .vtk.
[[nodiscard]] VtkFormat vtk_format(const std::filesystem::path& file);

/// Writes a surface to a stream, whose locale does not count and stays.
/// @param time  s; stored with the surface.
void write_vtk(std::ostream& out, const Surface& surface, VtkFormat format, double time = 0.0);

/// Writes a surface to a file, in the format of its extension.
/// @throws InvalidArgument for an extension that is not known or a file that cannot be written.
void write_vtk(const std::filesystem::path& file, const Surface& surface, double time = 0.0);

/// Writes the file that lists pieces of a surface, each an XML file of cells (.vtu) that one of
/// several processes wrote.
/// @param file    ends in .pvtu
/// @param like    any of the pieces: all have its arrays.
/// @param pieces  names of files in the same folder.
/// @throws InvalidArgument for another extension, a name that XML cannot hold as it is, or a file
///         that cannot be written.
void write_vtk_pieces(const std::filesystem::path& file, const Surface& like,
                      const std::vector<std::string>& pieces);

/// Surfaces in time: FOLDER/NAME_000000.vtp and so on, with their times in FOLDER/NAME.pvd.
///
/// The index is complete after every call of add, so that a run that stops leaves a readable
/// series.
class VtkSeries {
public:
    /// Makes the folder where it does not exist.
    /// @throws InvalidArgument where that fails, or for a name that is empty or has a slash.
    VtkSeries(std::filesystem::path folder, std::string name);

    /// Writes the surface of one time.
    /// @param time  s.
    /// @throws InvalidArgument for a file that cannot be written.
    void add(double time, const Surface& surface);

    /// Returns the file that lists all times, for ParaView.
    [[nodiscard]] std::filesystem::path index() const { return folder_ / (name_ + ".pvd"); }
    /// Returns the number of times.
    [[nodiscard]] std::size_t size() const noexcept { return frames_; }

private:
    std::filesystem::path folder_;
    std::string name_;
    std::ofstream list_;  // the index, complete after every frame
    std::size_t frames_ = 0;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/output/vtk.ipp>  // IWYU pragma: export
#endif
