// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builders of frames, lattices, nets and lines with corners: members between joints, without
/// multipliers.
///
/// The ends of members are attached to the joints' nodes (Scene::attach). A joint of a frame has a
/// stiff affine body of its own: docs/theory-frames.md says why.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/element/joint/affine_joint.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace ancf {

/// What a member is made of.
struct Profile {
    Material material;  ///< of the member
    Section section;    ///< its cross-section
};

/// A straight member of a frame or a net.
struct Member {
    int first;         ///< index of the point where it starts
    int second;        ///< index of the point where it ends
    int profile = 0;   ///< index in the profiles
    int elements = 1;  ///< number of elements
};

/// How a frame is built.
template <int Dimension = 3>
struct FrameOptions {
    /// How much stiffer a joint is than a block of the members' material and size.
    double joint_stiffness = 100.0;
    /// The direction that the sections' y axes follow. Where it is zero, or within 1e-6 rad of a
    /// member such as a column, the member takes reference_slopes() of its own direction. Of no
    /// effect in the plane.
    Vector<double, Dimension> y_axis = Vector<double, Dimension>::Zero();

    /// @throws InvalidArgument for a stiffness that is not positive or an axis that is not finite.
    void check() const {
        detail::require_positive("FrameOptions: joint_stiffness", joint_stiffness);
        detail::require_finite("FrameOptions: y_axis", detail::components(y_axis));
    }
};

/// How a net is built.
struct NetOptions {
    double strain = 0.0;  ///< initial strain of the ropes; a flat net without has no stiffness

    /// @throws InvalidArgument for a strain that is not finite or not above -1.
    void check() const {
        detail::require(std::isfinite(strain) && strain > -1.0,
                        "NetOptions: strain must be finite and above -1, got ", strain);
    }
};

/// A frame or a net as a builder added it to a model.
template <class Element>
struct Frame {
    List<NodeId> joints;          ///< a node for each point: hold, load and drive these
    List<Beam<Element>> members;  ///< with ends of their own, attached to the joints
};

namespace detail {

/// The largest block A h of the members at a joint, h the height of a section.
struct JointBlock {
    double volume = 0.0;  ///< m^3
    double size = 0.0;    ///< its edge, m
    Material material{};  ///< of its stiffest member

    /// Takes one more member into account.
    void add(const Profile& profile);
};

/// The prototypes of joints' bodies that were made, by volume, Young's and shear modulus, density.
using BodyPrototypes = std::map<std::array<double, 4>, int>;

/// Gives a joint its body.
ANCF_LAZY void add_joint_body(Scene& model, NodeId joint, const JointBlock& block, double stiffness,
                              BodyPrototypes& made);

/// The prototypes of members that were made, by profile and length of an element.
using MemberPrototypes = std::map<std::pair<int, double>, int>;

/// Returns the prototype of a length equal to 1e-12, -1 where there is none.
[[nodiscard]] int find_prototype(const MemberPrototypes& made, int profile, double length);

/// @throws InvalidArgument unless all components of all points are finite.
void check_points(const char* name, const double* components, std::size_t count, int dimension);

/// @throws InvalidArgument unless both ends are there and differ, and so is the profile.
/// @param place  of the member, for the message
void check_member(const char* name, std::size_t place, const Member& member, std::size_t points,
                  std::size_t profiles);

/// @throws InvalidArgument unless the ends of a member are apart.
/// @return their distance, m
[[nodiscard]] double member_length(const char* name, std::size_t place, const Member& member,
                                   double distance);

/// Returns the slopes of a member: along `y_axis` as FrameOptions says.
[[nodiscard]] Matrix<double, 3> member_slopes(const Vector<double, 3>& direction,
                                              const Vector<double, 3>& y_axis);
[[nodiscard]] Matrix<double, 2> member_slopes(const Vector<double, 2>& direction,
                                              const Vector<double, 2>& y_axis);

/// Adds members, equal ones of one prototype, and attaches their ends to joints.
template <class Element, int Dimension, class... Options>
Frame<Element> add_members(const char* name, BasicModel<Dimension>& model,
                           const List<Profile>& profiles,
                           const List<typename BasicModel<Dimension>::Point>& points,
                           const List<Member>& members, const Vector<double, Dimension>& y_axis,
                           double strain, const Options&... options) {
    MemberPrototypes made;
    List<Element> prototypes;
    List<int> prototype_of;
    // all that may be refused comes before the model changes
    check_points(name, points.empty() ? nullptr : points.front().data(), points.size(), Dimension);
    for (std::size_t k = 0; k < members.size(); ++k) {
        const Member& member = members[k];
        check_member(name, k, member, points.size(), profiles.size());
        const auto& from = points[member.first];
        const auto& to = points[member.second];
        const double apart = member_length(name, k, member, span(between<Dimension>(from, to)));
        const double length = apart / member.elements / (1.0 + strain);
        int prototype = find_prototype(made, member.profile, length);
        if (prototype < 0) {
            const Profile& profile = profiles[member.profile];
            prototype = static_cast<int>(prototypes.size());
            prototypes.push_back(
                made_element<Element>(profile.material, profile.section, length, options...));
            made[{member.profile, length}] = prototype;
        }
        prototype_of.push_back(prototype);
    }
    Frame<Element> frame;
    for (const auto& point : points) frame.joints.push_back(model.add_node(point));
    int first = 0;  // index of the first prototype in the model
    for (std::size_t k = 0; k < prototypes.size(); ++k)
        first = model.add_prototype(std::move(prototypes[k])) - static_cast<int>(k);
    for (std::size_t k = 0; k < members.size(); ++k) {
        const Member& member = members[k];
        const auto& from = points[member.first];
        const auto& to = points[member.second];
        Beam<Element>& beam = frame.members.emplace_back();
        beam.prototypes.push_back(first + prototype_of[k]);
        auto slopes = member_slopes(Vector<double, Dimension>(to - from), y_axis);
        for (int i = 0; i < Dimension; ++i) slopes(i, 0) *= 1.0 + strain;
        beam.nodes = add_nodes_between<Dimension>(model, from, to, slopes, member.elements);
        for (int i = 0; i < member.elements; ++i) connect_next(model, beam);
        model.attach(beam.first(), frame.joints[member.first]);
        model.attach(beam.last(), frame.joints[member.second]);
    }
    return frame;
}

}  // namespace detail

/// Adds a frame of straight members that are joined rigidly at points.
///
///     const auto portal = ancf::frame<ancf::CrossSectionBeam<3>>(
///         model, {{steel, tube}}, {{0, 0, 0}, {0, 3, 0}, {4, 3, 0}, {4, 0, 0}},
///         {{0, 1}, {1, 2}, {2, 3}});
///     model.clamp(portal.joints[0]);
///
/// Members of equal profile, length and number of elements share a prototype.
/// @param profiles  what members are made of.
/// @param points    the joints, m.
/// @param members   each between two points.
/// @param element   handed to the element's constructor after material, section and length.
/// @return          the joints and the members, in the order given.
/// @throws InvalidArgument for a point that is not finite, with its place; a member whose points
///         coincide or do not exist, one of no elements or of no profile, with its place and
///         points; and what the element's constructor refuses. The model is then as it was.
template <class Element = void, int Dimension, class... Options>
auto frame(BasicModel<Dimension>& model, const List<Profile>& profiles,
           const List<typename BasicModel<Dimension>::Point>& points, const List<Member>& members,
           const FrameOptions<Dimension>& frame_options = {}, const Options&... element) {
    using Chosen = detail::named_element_t<Element, Dimension>;
    static_assert(Chosen::fields.contains(Field::r_y),
                  "frame joins sections: cables have none, take net");
    frame_options.check();
    auto built = detail::add_members<Chosen>("frame", model, profiles, points, members,
                                             frame_options.y_axis, 0.0, element...);
    List<detail::JointBlock> blocks(points.size());
    for (const Member& member : members)
        for (const int joint : {member.first, member.second})
            blocks[joint].add(profiles[member.profile]);
    detail::BodyPrototypes made;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (blocks[k].volume > 0.0)
            detail::add_joint_body(model, built.joints[k], blocks[k], frame_options.joint_stiffness,
                                   made);
    return built;
}

/// Adds a net of cables that are pinned to each other at points.
///
/// A flat net without stress has no stiffness across its ropes, and load steps do not help: give it
/// a strain.
/// @param profiles, points, members, element  as of frame().
/// @return  the knots and the cables, in the order given.
/// @throws InvalidArgument as frame().
template <class Element = void, int Dimension, class... Options>
auto net(BasicModel<Dimension>& model, const List<Profile>& profiles,
         const List<typename BasicModel<Dimension>::Point>& points, const List<Member>& members,
         const NetOptions& net_options = {}, const Options&... element) {
    using Chosen = detail::named_element_t<Element, Dimension>;
    static_assert(!Chosen::fields.contains(Field::r_y),
                  "net pins cables: beams have sections, take frame");
    net_options.check();
    return detail::add_members<Chosen>("net", model, profiles, points, members,
                                       Vector<double, Dimension>(Vector<double, Dimension>::Zero()),
                                       net_options.strain, element...);
}

/// Adds straight beams through points, each of `elements` elements, joined rigidly at the corners
/// as frame() does.
///
/// The section's y axis of each piece follows reference_slopes() of its direction. The ends of the
/// line are attached to joints as well: hold and load `joints`.
/// @return the points' joints, and a member for each two neighbouring points, in order.
/// @throws InvalidArgument for fewer than two points, points that coincide or no elements.
template <class Element = void, int Dimension, class... Options>
auto polyline(BasicModel<Dimension>& model, const Material& material, const Section& section,
              const List<typename BasicModel<Dimension>::Point>& through, int elements,
              const Options&... options) {
    detail::require(through.size() >= 2, "polyline: at least two points are needed, got ",
                    through.size());
    List<Member> members;
    for (int k = 0; k + 1 < static_cast<int>(through.size()); ++k)
        members.push_back({k, k + 1, 0, elements});
    return frame<Element>(model, {{material, section}}, through, members, {}, options...);
}

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/builders/frame.ipp>  // IWYU pragma: export
#endif
