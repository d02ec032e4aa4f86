// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Vectors of nodes that are constant linear combinations of vectors of another node: joints
/// without multipliers. docs/theory-frames.md derives them.
///
/// A state holds all vectors. Those that are attached are no unknowns: they follow the vectors that
/// they are attached to, and what acts on them acts on those.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/model/element_group.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cstddef>

namespace ancf {

/// One attached vector: a = f_0 r + f_1 r_x + f_2 r_y + f_3 r_z of another node.
struct AttachedVector {
    NodeField vector;               ///< what is attached
    NodeId to;                      ///< to which node
    std::array<double, 4> factors;  ///< of r, r_x, r_y, r_z there; m for a slope's part in an r
};

/// All attached vectors of a scene, each by the free-standing vectors that it follows.
class Dependence {
public:
    /// A part of an attached vector.
    struct Part {
        int first;      ///< the first coordinate of a vector that is not attached
        double factor;  ///< what multiplies it
    };

    Dependence() = default;

    /// Resolves chains of attachments, which form no circle.
    [[gnu::cold]] Dependence(const Layout& layout, const List<AttachedVector>& attachments);

    /// Tells whether nothing is attached.
    [[nodiscard]] bool empty() const noexcept { return firsts_.empty(); }

    /// Tells whether a coordinate belongs to an attached vector.
    [[nodiscard]] bool attached(int coordinate) const noexcept {
        return !empty() && vector_of_[coordinate] >= 0;
    }

    /// Returns the parts of the vector that starts at a coordinate: itself unless it is attached.
    [[nodiscard]] List<Part> parts(int first) const;

    /// Sets the attached vectors of coordinates, or of their rates or changes, by the others.
    void complete(VectorX& coordinates) const {
        for (std::size_t k = 0; k < firsts_.size(); ++k) complete_one(coordinates, k);
    }

    /// Sets those attached vectors that follow the vector that starts at a coordinate.
    void complete(VectorX& coordinates, int first) const;

    /// Moves forces from attached vectors to those that they follow.
    void carry(VectorX& forces) const;

private:
    void complete_one(VectorX& coordinates, std::size_t attached) const;
    bool resolve();
    void list_followers(int coordinates);

    int dimension_ = 0;
    List<int> firsts_;          // first coordinate of each attached vector
    List<Part> parts_;          // of all attached vectors, one after the other
    List<int> first_part_;      // of each attached vector, and the end
    List<int> vector_of_;       // place in firsts_ of each coordinate, -1
    List<int> followers_;       // places in firsts_, by the coordinate that they follow
    List<int> first_follower_;  // of each coordinate, and the end
};

namespace detail {

/// The vectors that a list of vectors follows: itself where none of them is attached.
struct FollowedVectors {
    /// A part of one vector of the list.
    struct Part {
        int vector;     ///< place in `firsts`
        double factor;  ///< what multiplies that vector
    };

    List<int> firsts;      ///< first coordinates of those that are not attached, once each
    List<Part> parts;      ///< of all vectors of the list, one after the other
    List<int> first_part;  ///< of each vector of the list, and the end

    FollowedVectors() = default;
    /// @param list  first coordinates
    [[gnu::cold]] FollowedVectors(const Dependence& dependence, const List<int>& list);
};

/// The coordinates that a load or a constraint reads, and those that it acts on: the same unless
/// one of its vectors is attached.
class LocalCoordinates {
public:
    /// @param what  the word for its owner in the message
    /// @throws InvalidArgument for a vector that its node does not carry.
    [[gnu::cold]] LocalCoordinates(const Layout& layout, const Dependence& dependence,
                                   const Coupling& coupling, const char* what);

    /// Returns the coordinates in the order of its coupling.
    [[nodiscard]] const List<int>& read() const noexcept { return read_; }
    /// Returns the coordinates that it acts on.
    [[nodiscard]] const List<int>& acted() const noexcept { return acted_; }

    /// Replaces a force on what is read by the force on what it acts on.
    void carry(VectorX& force) const;
    /// Replaces derivatives by what is read, columns, likewise.
    void carry_columns(MatrixX& derivatives) const;
    /// Replaces derivatives of a force by what is read likewise.
    void carry(MatrixX& stiffness) const;
    /// Replaces the stiffness of some of what is read likewise.
    /// @param active  places in read() of its rows and columns; empty: all.
    /// @return the coordinates of its rows and columns then; they may stand in `active`.
    [[nodiscard]] const List<int>& carry(MatrixX& stiffness, List<int>& active) const;

private:
    int dimension_;
    List<int> read_, acted_;
    FollowedVectors followed_;  // without parts where nothing is attached
};

/// An element with attached vectors: where its tangent goes.
struct AttachedElement {
    static constexpr int most_vectors = 16;  ///< that one element can act on

    FollowedVectors vectors;  ///< what its own vectors follow
    List<int> block_of;       ///< place in `blocks` of each of those that are followed
    List<int> blocks;         ///< of the system: their nodes
    List<int> base;  ///< where the values of each pair of `blocks` stand, by rows; -1: none

    /// Lists all but `base`, which is the assembly's.
    /// @throws InvalidArgument for more vectors than there is room for.
    [[gnu::cold]] AttachedElement(const Layout& layout, const Dependence& dependence, Fields fields,
                                  const std::array<int, 2>& nodes);
};

}  // namespace detail

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/attachment.ipp>
#endif
