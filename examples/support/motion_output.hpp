// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a program writes of a motion: rows of the tip and of energies, shapes, and a VTK series.

#pragma once

#include <ancf/dynamics/report.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/output/vtk.hpp>
#include <ancf/section/section.hpp>

#include <support/command_line.hpp>
#include <support/motion.hpp>
#include <support/named_beam.hpp>
#include <support/report.hpp>

#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace examples {

/// Where a program writes its motion.
struct MotionOutputOptions {
    bool csv = false;
    std::string vtk;     ///< folder
    std::string shapes;  ///< file

    void add_to(CommandLine& line);

    /// Refuses a file of shapes that is a state file too.
    /// @throws ancf::InvalidArgument naming the file.
    void check(const MotionOptions& motion) const;
};

/// Writes what an observer sees; the model serves as the description of the scene.
class MotionWriter {
public:
    /// @param beams    what is drawn.
    /// @param section  whose outline is drawn.
    /// @param tip      the node whose position stands in the rows.
    /// @param name     of the VTK series.
    /// @throws InvalidArgument for a file or folder that cannot be written.
    MotionWriter(const ancf::Scene& model, std::vector<NamedBeam> beams, ancf::Section section,
                 ancf::NodeId tip, const MotionOutputOptions& options, const std::string& name);

    void write(const ancf::Snapshot& seen);

    /// Prints the table, unless CSV was asked for, and closes the files.
    /// @throws InvalidArgument where a file could not be written.
    void finish(const std::string& title);

private:
    void write_shapes(double time);

    ancf::Scene shown_;
    std::vector<NamedBeam> beams_;
    ancf::Section section_;
    int tip_;
    const MotionOutputOptions& options_;
    Sheet sheet_;
    std::optional<ancf::VtkSeries> series_;
    std::ofstream shapes_;
};

}  // namespace examples
