// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/output/surface.hpp>
#include <ancf/output/vtk.hpp>

#include <support/files.hpp>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace examples {

void require_writable(const std::string& file) {
    std::error_code ignored;
    const bool there = std::filesystem::exists(file, ignored);
    const bool open = std::ofstream(file, std::ios::app).is_open();
    if (!there) std::filesystem::remove(file, ignored);
    ancf::detail::require(open, "cannot write ", file);
}

void require_apart(const char* one, const std::string& file, const char* other,
                   const std::string& other_file) {
    const auto place = [](const std::string& name) {  // also of a file that is not there yet
        std::error_code ignored;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(name, ignored), ignored);
    };
    const bool both = !file.empty() && !other_file.empty();
    ancf::detail::require(!both || place(file) != place(other_file), one, " and ", other,
                          " name the same file ", file);
}

void OutputOptions::add_to(CommandLine& line) {
    line.set_group("Output");
    line.add_flag("--csv", csv, "comma-separated values on stdout instead of a table");
    add_files_to(line);
}

void OutputOptions::add_files_to(CommandLine& line) {
    line.set_group("Output");
    line.add_file(
        "--vtk", vtk,
        "the deformed beam, of the last of several meshes or loads, for ParaView: .vtp, .vtu or "
        ".vtk");
    line.add_file("--shape", shape, "its centre line and the outline of its sections, as CSV");
}

void OutputOptions::check() const {
    require_apart("--vtk", vtk, "--shape", shape);
    if (!vtk.empty()) {
        static_cast<void>(ancf::vtk_format(vtk));
        require_writable(vtk);
    }
    if (!shape.empty()) require_writable(shape);
}

void OutputOptions::write(const ancf::Scene& model, const NamedBeam& beam,
                          const ancf::Section& section) const {
    if (!vtk.empty()) {
        ancf::Surface surface;
        beam.draw(model, section, surface);
        ancf::write_vtk(vtk, surface);
    }
    if (!shape.empty()) {
        std::ofstream out(shape);
        ancf::write_shape(out, beam.shape(model, section, NamedBeam::stations));
        out.close();
        ancf::detail::require(!out.fail(), "cannot write ", shape);
    }
}

}  // namespace examples
