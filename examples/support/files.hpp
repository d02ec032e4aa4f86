// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a program writes: CSV instead of a table, and the deformed beam for ParaView and gnuplot.

#pragma once

#include <ancf/model/scene.hpp>
#include <ancf/section/section.hpp>

#include <support/command_line.hpp>
#include <support/named_beam.hpp>

#include <string>

namespace examples {

/// Throws unless a file can be written; one that is there stays as it is.
/// @throws ancf::InvalidArgument naming the file.
void require_writable(const std::string& file);

/// Throws where two options name one file.
/// @throws ancf::InvalidArgument naming the options and the file.
void require_apart(const char* one, const std::string& file, const char* other,
                   const std::string& other_file);

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
    void write(const ancf::Scene& model, const NamedBeam& beam, const ancf::Section& section) const;
};

}  // namespace examples
