// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/progress.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace examples {

ProgressBar::ProgressBar(double start)
    : start_(start), terminal_(isatty(STDERR_FILENO) == 1), last_(Clock::now()) {}

void ProgressBar::show(double time, double end) {
    if (!terminal_) return;
    const Clock::time_point now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    constexpr int width = 40;
    const double part = end > start_ ? std::clamp((time - start_) / (end - start_), 0.0, 1.0) : 1.0;
    const auto filled = static_cast<std::size_t>(std::lround(part * width));
    const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
    std::fprintf(stderr, "\r[%s] %5.1f %%  t = %.4g s ", bar.c_str(), 100.0 * part, time);
    std::fflush(stderr);
    shown_ = true;
}

void ProgressBar::clear() {
    if (shown_) std::fprintf(stderr, "\r%*s\r", 72, "");
    shown_ = false;
}

}  // namespace examples
