// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The lattices of the benchmark, and the clock of its stages.

#pragma once

#include <ancf/model/builders/frame.hpp>
#include <ancf/section/profiles.hpp>

#include <cstddef>
#include <ctime>
#include <vector>

namespace ancf::bench {

/// Returns the processor time of all threads, s: what else a machine does stays out of it.
inline double seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A lattice of cubes of 0.25 m: where its joints stand, and the members between them.
struct Lattice {
    static constexpr double cell = 0.25;  ///< m
    int nx, ny, nz;                       ///< joints along the axes

    /// Steel bars 10 mm square.
    [[nodiscard]] static Profile bar() {
        return {Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.01, 0.01)};
    }

    [[nodiscard]] int place(int i, int j, int k) const { return i + nx * (j + ny * k); }

    [[nodiscard]] std::vector<Vector<double, 3>> points() const {
        std::vector<Vector<double, 3>> all;
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) all.emplace_back(cell * i, cell * j, cell * k);
        return all;
    }

    [[nodiscard]] std::vector<Member> members(int elements) const {
        std::vector<Member> all;
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) {
                    const int here = place(i, j, k);
                    if (k > 0) all.push_back({place(i, j, k - 1), here, 0, elements});
                    if (i > 0) all.push_back({place(i - 1, j, k), here, 0, elements});
                    if (j > 0) all.push_back({place(i, j - 1, k), here, 0, elements});
                }
        return all;
    }
};

/// Lets a lattice of a thousand members swing by each integrator and computes 20 of its modes.
/// @param duration  of the motion, s
/// @return whether all ran to their end.
bool run_motion(double duration, bool csv);

}  // namespace ancf::bench
