// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/output/surface.hpp>

namespace ancf {

ANCF_INLINE Surface::Surface() {
    arrays_[place] = {"place", {"s"}, {}};
    arrays_[velocity] = {"velocity", {"x", "y", "z"}, {}};
    arrays_[force] = {"section_force", {"N", "Q_y", "Q_z"}, {}};
    arrays_[moment] = {"section_moment", {"T", "M_y", "M_z"}, {}};
    arrays_[axial_stress] = {"axial_stress", {"S_xx"}, {}};
}

ANCF_INLINE void Surface::begin_beam(const Chain& beam, const Section& section) {
    count_ = static_cast<int>(section.outline().size());
    detail::require(count_ >= 3, "Surface::add: an outline needs at least 3 corners, got ", count_);
    detail::require(!beam.elements.empty(), "Surface::add: the beam has no elements");
    first_ = static_cast<int>(points_.size());
}

ANCF_INLINE void Surface::add_station(double s, const SectionForces& forces,
                                      const std::vector<Corner>& corners, bool joined) {
    for (const Corner& corner : corners) {
        points_.push_back(corner.position);
        append(place, {s, 0.0, 0.0});
        append(velocity, corner.velocity);
        append(force, {forces.axial, forces.shear_y, forces.shear_z});
        append(moment, {forces.torque, forces.moment_y, forces.moment_z});
        append(axial_stress, {corner.stress, 0.0, 0.0});
    }
    if (!joined) return;
    const int before = static_cast<int>(points_.size()) - 2 * count_;
    for (int k = 0; k < count_; ++k) {
        const int next = (k + 1) % count_;
        add_polygon({before + k, before + next, before + count_ + next, before + count_ + k});
    }
}

ANCF_INLINE void Surface::end_beam() {
    const int last = static_cast<int>(points_.size()) - count_;
    std::vector<int> start;
    std::vector<int> end;
    for (int k = 0; k < count_; ++k) {
        start.push_back(first_ + count_ - 1 - k);
        end.push_back(last + k);
    }
    add_polygon(start);
    add_polygon(end);
}

}  // namespace ancf
