// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A progress bar on stderr, only where stderr is a terminal.

#pragma once

#include <chrono>

namespace examples {

/// One line that grows with the time of a motion.
class ProgressBar {
public:
    /// @param start  s, of the motion.
    explicit ProgressBar(double start);

    /// Shows how far the motion is, at most ten times a second.
    void show(double time, double end);

    /// Removes the line.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    double start_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point last_;
};

}  // namespace examples
