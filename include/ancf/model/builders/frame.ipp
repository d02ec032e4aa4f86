// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/model/builders/frame.hpp>

#include <algorithm>
#include <tuple>

namespace ancf::detail {

ANCF_INLINE void JointBlock::add(const Profile& profile) {
    const Moments about = centroidal(profile.section.moments());
    const double edge = std::sqrt(12.0 * std::max(about.yy, about.zz) / about.area);
    if (edge * about.area > volume) {
        volume = edge * about.area;
        size = std::cbrt(volume);
    }
    // of equal ones by what is left, so that the order of members does not count
    const auto rank = [](const Material& of) {
        return std::make_tuple(of.young, of.shear, of.density);
    };
    if (rank(profile.material) > rank(material)) material = profile.material;
}

ANCF_LAZY void add_joint_body(Scene& model, NodeId joint, const JointBlock& block, double stiffness,
                              BodyPrototypes& made) {
    const auto add = [&](auto body) {
        using Body = decltype(body);
        const Material& of = block.material;
        const auto [place, fresh] =
            made.try_emplace({block.volume, of.young, of.shear, of.density}, -1);
        if (fresh) place->second = model.add_prototype(body);
        model.connect<Body>(place->second, joint, joint);
    };
    const double volume = stiffness * block.volume;
    if (model.dimension() == 2)
        add(AffineJoint<2>(block.material, volume, block.size));
    else
        add(AffineJoint<3>(block.material, volume, block.size));
}

ANCF_INLINE int find_prototype(const MemberPrototypes& made, int profile, double length) {
    const auto next = made.lower_bound({profile, (1.0 - 1e-12) * length});
    const bool equal = next != made.end() && next->first.first == profile &&
                       next->first.second <= (1.0 + 1e-12) * length;
    return equal ? next->second : -1;
}

ANCF_INLINE void check_points(const char* name, const double* components, std::size_t count,
                              int dimension) {
    for (std::size_t k = 0; k < count; ++k)
        for (int i = 0; i < dimension; ++i, ++components)
            require(std::isfinite(*components), name, ": point ", k, " must be finite, component ",
                    i, " is ", *components);
}

/// Requires something of a member; the message says which one it is.
template <class... Message>
void require_of_member(bool good, const char* name, std::size_t place, const Member& member,
                       const Message&... message) {
    require(good, name, ": member ", place, ", points ", member.first, " and ", member.second, ": ",
            message...);
}

ANCF_INLINE void check_member(const char* name, std::size_t place, const Member& member,
                              std::size_t points, std::size_t profiles) {
    const auto check = [&](bool good, const auto&... message) {
        require_of_member(good, name, place, member, message...);
    };
    for (const int joint : {member.first, member.second})
        check(joint >= 0 && joint < static_cast<int>(points), "there are ", points,
              " points, counted from 0, got point ", joint);
    check(member.first != member.second, "a member joins two points, got one twice");
    check(member.profile >= 0 && member.profile < static_cast<int>(profiles), "there are ",
          profiles, " profiles, counted from 0, got profile ", member.profile);
    check(member.elements >= 1, "at least one element is needed, got ", member.elements);
}

ANCF_INLINE double member_length(const char* name, std::size_t place, const Member& member,
                                 double distance) {
    require_of_member(std::isfinite(distance) && distance > 0.0, name, place, member,
                      "the points must be apart, got a distance of ", distance);
    return distance;
}

ANCF_INLINE Matrix<double, 3> member_slopes(const Vector<double, 3>& direction,
                                            const Vector<double, 3>& y_axis) {
    constexpr double parallel = 1e-6;
    const double sine = span(cross(direction, y_axis));  // times both lengths
    if (sine <= parallel * span(direction) * span(y_axis)) return reference_slopes(direction);
    return reference_slopes(direction, y_axis);
}

ANCF_INLINE Matrix<double, 2> member_slopes(const Vector<double, 2>& direction,
                                            const Vector<double, 2>& /*y_axis*/) {
    return reference_slopes(direction);
}

}  // namespace ancf::detail
