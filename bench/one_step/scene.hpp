// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The scenes of one_step and the calls that make them. The elements are divided among units: all
/// of them in one take 800 MB to compile.

#pragma once

#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <functional>
#include <string>
#include <vector>

namespace ancf::bench::one_step {

using Point = Vector<double, 3>;

/// A scene that waits for its solution, and its loaded end.
struct Problem {
    Model scene;
    NodeId end;
};

/// A row of the table.
struct Row {
    std::string name;
    int steps;
    std::function<Problem()> make;
    bool has_theory = false;
    Point theory = Point::Zero();
    double length = 1.0;
};

/// Scenes of cross-section beams.
std::vector<Row> cross_section_rows();

/// Scenes of torsion beams, continuum beams and cables.
std::vector<Row> other_rows();

/// A cantilever that a seed draws: straight or an arc, under a force, a moment or both. A cable is
/// straight, since a curved one spins freely, has a square section and takes a force. A rope is a
/// cable between two pins, under a force somewhere or a force per length.
/// @param element  "continuum", "cable", "rope", or else either measure of beams with sections
Problem random_problem(unsigned seed, const std::string& element, std::string& name);

/// Prints strains and pivots of the iterates of one load step, by every way of correcting.
void print_iterates();

}  // namespace ancf::bench::one_step
