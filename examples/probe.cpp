// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// One element at given nodal coordinates: energy, elastic force and tangent with 17 digits.
///
/// Reads 24 numbers from stdin, r, r_x, r_y, r_z of the first node and then of the second, so that
/// anyone can check the element against another code:
///
///     echo "0 0 0  1 0 0  0 1 0  0 0 1   2.1 0 0  1 0 0  0 1 0  0 0 1" | probe
///
/// Prints `energy U`, `force` and 24 numbers, then `tangent` and 24 rows of 24 numbers. The
/// defaults are those of Model II of [Dufva2006]: L 2, 0.01 x 0.01, E 2.07e11, G 7.9615e10.

#include <ancf/error.hpp>
#include <ancf/model/element_group.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/types.hpp>

#include <support/beam.hpp>
#include <support/command_line.hpp>
#include <support/files.hpp>
#include <support/named_beam.hpp>

#include <cmath>
#include <iostream>
#include <string>

namespace {

struct Probe {
    examples::BeamOptions beam;
    examples::OutputOptions output;

    void parse(int argc, char** argv);
};

void Probe::parse(int argc, char** argv) {
    examples::CommandLine line(
        "Energy, elastic force and tangent of one element at the 24 nodal coordinates on stdin.");
    beam.geometry = {2.0, 0.01, 0.01, 2.07e11, 7.9615e10};
    line.set_group("Beam");
    beam.add_geometry_to(line);
    beam.add_element_to(line, examples::spatial_beams);
    output.add_files_to(line);
    line.parse(argc, argv);
    beam.settle(line);
    output.check();
    examples::check(beam);
}

/// Reads as many numbers as there are coordinates.
/// @throws InvalidArgument for missing, surplus or wrong ones.
ancf::VectorX read_coordinates(std::istream& in, int size) {
    ancf::VectorX e(size);
    std::string word;
    for (int k = 0; k < size; ++k) {
        ancf::detail::require(static_cast<bool>(in >> word), "stdin: expected ", size,
                              " coordinates, got ", k);
        try {
            e[k] = examples::number(word, examples::Range::finite);
        } catch (const ancf::InvalidArgument& error) {
            ancf::detail::reject("stdin: coordinate ", k + 1, ": ", error.what());
        }
    }
    ancf::detail::require(!(in >> word), "stdin: expected ", size,
                          " coordinates, got more: ", word);
    return e;
}

template <class Row>
void print_numbers(const Row& row) {
    for (Eigen::Index k = 0; k < row.size(); ++k)
        std::cout << (k == 0 ? "" : " ") << ancf::number_text(row[k] + 0.0);  // no -0
    std::cout << '\n';
}

void evaluate(const Probe& probe) {
    ancf::Model model;
    const auto beam = examples::straight_beam(model, probe.beam, 1);
    const ancf::ElementGroup& element = *model.groups().front();
    const int size = element.dofs();
    const ancf::VectorX e = read_coordinates(std::cin, size);
    ancf::detail::require(element.admissible(0, e.data()),
                          "stdin: the coordinates are degenerate: somewhere "
                          "along the element a slope has no length or is parallel to the tangent, "
                          "the section is inside out, or a length overflows");
    ancf::VectorX force(size);
    ancf::MatrixX tangent(size, size);
    const double energy = element.evaluate(0, e.data(), force.data(), tangent.data());
    ancf::detail::require(
        std::isfinite(energy) && force.allFinite() && tangent.allFinite(),
        "the result is not finite: the coordinates or the stiffness are too large");
    model.state().q = e;
    probe.output.write(model, beam, probe.beam.section());
    std::cout << "energy " << ancf::number_text(energy) << "\nforce ";
    print_numbers(force);
    std::cout << "tangent\n";
    for (Eigen::Index i = 0; i < tangent.rows(); ++i) print_numbers(tangent.row(i));
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        Probe probe;
        probe.parse(argc, argv);
        evaluate(probe);
        return examples::exit_done;
    });
}
