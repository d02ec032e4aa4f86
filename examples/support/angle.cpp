// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/angle.hpp>

#include <cmath>
#include <cstddef>

namespace examples {

namespace {

/// Sums the turns from one direction to the next in a plane; each is taken as less than half a
/// turn.
class TurnCounter {
public:
    void add(double first, double second) {
        const double angle = std::atan2(second, first);
        if (seen_) sum_ += std::remainder(angle - last_, 8.0 * std::atan(1.0));
        last_ = angle;
        seen_ = true;
    }

    /// Returns the angle between the first direction and the last, in degrees.
    [[nodiscard]] double degrees() const { return sum_ * 45.0 / std::atan(1.0); }

private:
    bool seen_ = false;
    double last_ = 0.0;
    double sum_ = 0.0;
};

/// Returns where the components of a node's vector stand.
const double* vector_of(const ancf::Scene& scene, ancf::NodeId node, ancf::Field field) {
    return scene.state().q.data() + scene.coordinate(node, field);
}

}  // namespace

double bending_angle(const ancf::Scene& scene, const NamedBeam& beam,
                     const ancf::Section& section) {
    constexpr std::size_t stations = 33;  // per element
    const auto line = beam.shape(scene, section, stations);
    TurnCounter turns;
    turns.add(1.0, 0.0);
    for (std::size_t k = 1; k < line.size(); ++k) {
        if (k % stations == 0) continue;  // an element begins where the last one ended
        const auto &before = line[k - 1].centre, &after = line[k].centre;
        turns.add(after[0] - before[0], after[1] - before[1]);
    }
    const double* tangent = vector_of(scene, beam.last(), ancf::Field::r_x);
    turns.add(tangent[0], tangent[1]);
    return turns.degrees();
}

double twist_angle(const ancf::Scene& scene, const ancf::Chain& beam) {
    TurnCounter turns;
    turns.add(1.0, 0.0);
    for (const ancf::NodeId node : beam.nodes) {
        const double* slope = vector_of(scene, node, ancf::Field::r_y);
        turns.add(slope[1], slope[2]);
    }
    return turns.degrees();
}

}  // namespace examples
