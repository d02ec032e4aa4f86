// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/dynamics/report.hpp>

#include <algorithm>
#include <cmath>

namespace ancf {

ANCF_INLINE void Schedule::check(double start) const {
    const char* const state_time = " s (State::time; statics leaves its load factor there)";
    detail::require(std::isfinite(end) && end >= start, "Schedule: the end must not be before ",
                    "the start at ", start, state_time, ", got ", end);
    double before = start;
    for (const double time : times) {
        detail::require(time >= before && time <= end, "Schedule: times must ascend from ", start,
                        state_time, " to ", end, " s, got ", time, " after ", before);
        before = time;
    }
}

ANCF_INLINE Schedule equal_intervals(double start, double duration, double interval) {
    detail::require(std::isfinite(duration) && duration >= 0.0,
                    "equal_intervals: duration must be at least 0 and finite, got ", duration);
    detail::require_positive("equal_intervals: interval", interval);
    detail::require(std::isfinite(start), "equal_intervals: start must be finite, got ", start);
    constexpr double most = 1e7;
    detail::require(duration / interval <= most, "equal_intervals: interval ", interval,
                    " s makes more than ", most, " outputs of ", duration, " s");
    Schedule schedule;
    schedule.end = start + duration;
    const double last = schedule.end - 1e-9 * std::min(interval, duration);
    for (int k = 0; start + k * interval < last; ++k)
        schedule.times.push_back(start + k * interval);
    schedule.times.push_back(schedule.end);
    return schedule;
}

}  // namespace ancf
