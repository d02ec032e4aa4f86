// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a program writes: CSV instead of a table, and the deformed beam for ParaView and gnuplot.

#pragma once

#include <ancf/model/builders/beam.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/output/surface.hpp>
#include <ancf/section/section.hpp>

#include <support/command_line.hpp>

#include <string>
#include <vector>

namespace examples {

/// Throws unless a file can be written; one that is there stays as it is.
/// @throws ancf::InvalidArgument naming the file.
void require_writable(const std::string& file);

/// Where a program writes its results.
struct OutputOptions {
    bool csv = false;
    std::string vtk;
    std::string shape;

    /// Adds --csv and the files.
    void add_to(CommandLine& line);

    /// Adds the files alone.
    void add_files_to(CommandLine& line);

    /// Refuses a file of unknown format, or that cannot be written, before any work is done.
    /// @throws InvalidArgument naming the file.
    void check() const;

    /// Writes the files that were asked for.
    /// @throws InvalidArgument for a file that cannot be written.
    template <class Element>
    void write(const ancf::Scene& model, const ancf::Beam<Element>& beam,
               const ancf::Section& section) const {
        if (vtk.empty() && shape.empty()) return;
        ancf::Surface surface;
        surface.add(model, beam, section, stations);
        write_files(surface, ancf::deformed_shape(model, beam, section, stations));
    }

private:
    static constexpr int stations = 17;  // per element

    void write_files(const ancf::Surface& surface,
                     const std::vector<ancf::ShapeStation>& line) const;
};

}  // namespace examples
