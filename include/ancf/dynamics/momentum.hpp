// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Linear and angular momentum of a scene: what a free body keeps.

#pragma once

#include <ancf/assembly/resultant.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/model/state.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// Momenta about the origin of space; in the plane only the third angular one is not zero.
struct Momentum {
    Vector<double, 3> linear = Vector<double, 3>::Zero();   ///< kg m/s
    Vector<double, 3> angular = Vector<double, 3>::Zero();  ///< kg m^2/s
};

/// Returns the momenta of a state: the resultant of M v.
/// @throws InvalidArgument for a state of another size than the problem's model.
[[nodiscard]] inline Momentum momentum(const DynamicProblem& problem, const State& state) {
    const Resultant sum =
        resultant(problem.model(), state.q, problem.assembly().mass_product(state.v));
    return {sum.force, sum.moment};
}

}  // namespace ancf
