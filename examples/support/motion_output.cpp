// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/output/surface.hpp>

#include <support/files.hpp>
#include <support/motion_output.hpp>

#include <cstddef>
#include <utility>

namespace examples {

void MotionOutputOptions::add_to(CommandLine& line) {
    line.set_group("Output");
    line.add_flag("--csv", csv, "comma-separated values on stdout instead of a table");
    line.add_file("--vtk", vtk, "folder of a series for ParaView, one file per output time");
    line.add_file("--shapes", shapes, "centre lines and outlines at every output time, as CSV");
}

void MotionOutputOptions::check(const MotionOptions& motion) const {
    require_apart("--shapes", shapes, "--save", motion.save);
    require_apart("--shapes", shapes, "--restart", motion.restart);
}

MotionWriter::MotionWriter(const ancf::Scene& model, std::vector<NamedBeam> beams,
                           ancf::Section section, ancf::NodeId tip,
                           const MotionOutputOptions& options, const std::string& name)
    : shown_(model),
      beams_(std::move(beams)),
      section_(std::move(section)),
      tip_(model.coordinate(tip, ancf::Field::r)),
      options_(options),
      sheet_(options.csv,
             {"t", "x", "y", "z", "kinetic", "strain", "potential", "total", "constraint",
              "constraint_rate"},
             {"t", "x", "y", "z", "kinetic", "strain", "potential", "total", "constraint",
              "its rate"}) {
    if (!options.vtk.empty()) series_.emplace(options.vtk, name);
    if (options.shapes.empty()) return;
    shapes_.open(options.shapes);
    ancf::detail::require(shapes_.is_open(), "cannot write ", options.shapes);
    shapes_ << "t,beam,s,x,y,z";
    for (std::size_t k = 0; k < section_.outline().size(); ++k)
        for (const char* axis : {"x", "y", "z"}) shapes_ << ',' << axis << k;
    shapes_ << '\n';
}

void MotionWriter::write(const ancf::Snapshot& seen) {
    const double time = seen.state.time;
    const double* place = seen.state.q.data() + tip_;
    const ancf::Energies& energies = seen.energies;
    const double z = shown_.dimension() == 3 ? place[2] : 0.0;
    sheet_.add_csv(time, place[0], place[1], z, energies.kinetic, energies.strain,
                   energies.potential, energies.total(), seen.violation, seen.violation_rate);
    sheet_.add_table({fixed(time, 3), fixed(place[0], 6), fixed(place[1], 6), fixed(z, 6),
                      fixed(energies.kinetic, 4), fixed(energies.strain, 4),
                      fixed(energies.potential + 0.0, 4), scientific(energies.total()),
                      scientific(seen.violation), scientific(seen.violation_rate)});
    if (!series_ && !shapes_.is_open()) return;
    shown_.state() = seen.state;
    if (shapes_.is_open()) write_shapes(time);
    if (!series_) return;
    ancf::Surface surface;
    for (const NamedBeam& beam : beams_) beam.draw(shown_, section_, surface);
    series_->add(time, surface);
}

void MotionWriter::write_shapes(double time) {
    for (std::size_t k = 0; k < beams_.size(); ++k)
        for (const auto& station : beams_[k].shape(shown_, section_, NamedBeam::stations)) {
            shapes_ << ancf::number_text(time) << ',' << k << ',' << ancf::number_text(station.s);
            for (const double value : station.centre) shapes_ << ',' << ancf::number_text(value);
            for (const auto& corner : station.outline)
                for (const double value : corner) shapes_ << ',' << ancf::number_text(value);
            shapes_ << '\n';
        }
}

void MotionWriter::finish(const std::string& title) {
    sheet_.finish(title);
    if (!shapes_.is_open()) return;
    shapes_.close();
    ancf::detail::require(!shapes_.fail(), "cannot write ", options_.shapes);
}

}  // namespace examples
