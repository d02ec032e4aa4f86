// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Where a group of elements reads coordinates and adds forces and tangents.

#pragma once

#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cstddef>

namespace ancf {

/// Consecutive elements [first, last) of a group.
struct ElementRun {
    int first;  ///< index of its first element
    int last;   ///< one past its last
};

/// The place of one element in a system.
struct ElementSlots {
    std::array<int, 2> node;                 ///< its nodes
    std::array<std::array<int, 2>, 2> base;  ///< [row node][column node], -1 if not stored
    bool plain;    ///< both nodes carry just the element's vectors and all of them are free
    int attached;  ///< place in GroupTarget::attached of one with attached vectors, else -1
};

namespace detail {
struct AttachedElement;
}

/// What an assembly hands to a group of elements. Vectors are of all coordinates of the scene.
///
/// The tangent's values of a pair of nodes (a, b) stand at slots.base[a][b] + column + row, with
/// the row within the node's block and the column's place from column_offset().
struct GroupTarget {
    const ElementSlots* slots;  ///< of each element of the group
    const Layout& layout;       ///< of the scene
    const int* equation;        ///< of each coordinate, -1 where a support holds it
    const int* first_row;       ///< of each block
    const int* height;          ///< stored rows in the first column of each block
    Storage storage;            ///< of the tangent
    const double* q;            ///< coordinates
    const double* increment;    ///< their change whose linear effect is wanted, or null
    const double* before;       ///< where the last correction began, or null
    const double* change;       ///< the last correction, or null
    bool tangent;               ///< wanted beside the force
    double* internal_force;     ///< to add to
    double* predicted_force;    ///< that of the tangent's stresses, to add to, or null
    double* values;             ///< of the tangent, to add to
    const detail::AttachedElement* attached;  ///< those of the group's elements, or null

    /// Returns how far the values of a column of a block lie from its first column's.
    [[nodiscard]] int column_offset(int block, int column) const noexcept {
        const int rows = height[block];
        return storage == Storage::full ? column * rows
                                        : column * (rows - 1) - column * (column - 1) / 2;
    }
};

namespace detail {

/// Adds the tangent, by columns, of the attached element of this place.
void add_attached(const GroupTarget& target, int place, const double* tangent);

/// Writes the indices of an element's nodal coordinates.
inline void element_coordinates(const Layout& layout, int dimension, Fields fields,
                                const ElementSlots& slots, int* out) {
    if (slots.plain) {
        const int half = dimension * fields.count();
        for (const int node : slots.node)
            for (int i = 0; i < half; ++i) *out++ = layout.first(node) + i;
        return;
    }
    for (const int node : slots.node)
        for (int k = 0; k < field_count; ++k) {
            const auto field = static_cast<Field>(k);
            if (!fields.contains(field)) continue;
            const int first = layout.index({{node}, field});
            for (int i = 0; i < dimension; ++i) *out++ = first + i;
        }
}

}  // namespace detail

}  // namespace ancf
