// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// State files: where a motion stands, to go on from later.
///
///     ancf::save_state("half.txt", {model.state(), report.memory});  // of the first run
///     // later: build the model as for the first run, joints and springs too; then
///     const auto saved = ancf::load_state("half.txt");
///     model.state() = saved.state;
///     ancf::DynamicProblem problem(model);
///     integrator.integrate(problem, solver, schedule, saved.memory);
///
/// Text, exact to the last bit:
///
///     ancf-state 1
///     time 0.6
///     q 60              then that many numbers, one a line; v and multipliers likewise
///     memory NAME       of the integrator, where it carries something
///     value NAME 60     then that many numbers; any number of these
///     end

#pragma once

#include <ancf/dynamics/report.hpp>
#include <ancf/model/state.hpp>

#include <filesystem>
#include <iosfwd>

namespace ancf {

/// A state with what an integrator needs to continue it bit for bit.
struct SavedState {
    State state;    ///< coordinates, rates, multipliers and time
    Memory memory;  ///< empty: a consistent start is made
};

/// Writes a state.
/// @throws InvalidArgument for a value that is not finite or a name with a blank or a line break.
void write_state(std::ostream& out, const SavedState& saved);

/// Reads a state that write_state wrote.
/// @throws InvalidArgument naming the line that is not as expected.
[[nodiscard]] SavedState read_state(std::istream& in);

/// Writes a state to a file; one that is there stays as it is until the new one is complete.
/// @throws InvalidArgument also for a file that cannot be written.
void save_state(const std::filesystem::path& file, const SavedState& saved);

/// Reads a state from a file.
/// @throws InvalidArgument naming the file, and the line that is not as expected.
[[nodiscard]] SavedState load_state(const std::filesystem::path& file);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/output/state_file.ipp>  // IWYU pragma: export
#endif
