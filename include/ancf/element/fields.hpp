// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The vectors that a node carries: position, slopes, the curvature of a quintic centre line and
/// the rate of a slope.
///
/// A node stores the union of what its elements need, in the order of Field; an element's nodal
/// coordinates are the fields of its first node, then those of its second.

#pragma once

namespace ancf {

/// A vector of nodal coordinates, of as many components as the space has dimensions.
enum class Field : unsigned {
    r,     ///< position, m
    r_x,   ///< slope along the axis, 1
    r_y,   ///< slope across, 1
    r_z,   ///< slope across, 1 (three dimensions only)
    r_xy,  ///< rate of r_y along the axis, 1/m (two dimensions only)
    r_xx   ///< second derivative along the axis, 1/m
};

/// Returns the word for a field that messages use.
[[nodiscard]] constexpr const char* to_string(Field field) noexcept {
    switch (field) {
        case Field::r: return "r";
        case Field::r_x: return "r_x";
        case Field::r_y: return "r_y";
        case Field::r_z: return "r_z";
        case Field::r_xy: return "r_xy";
        case Field::r_xx: return "r_xx";
    }
    return "unknown";
}

inline constexpr int field_count = 6;  ///< number of vectors that there are

/// Returns the power of a length in the unit of a field: 1 of r, 0 of slopes, -1 of their rates.
constexpr int length_power(Field field) noexcept {
    return field == Field::r ? 1 : field == Field::r_xx || field == Field::r_xy ? -1 : 0;
}

/// A set of fields.
struct Fields {
    unsigned bits = 0;  ///< bit k stands for Field k

    constexpr Fields() = default;
    /// The set of one field; by default the empty set.
    constexpr Fields(Field field)
        : bits(1U << static_cast<unsigned>(field)) {}  // NOLINT: a field is a set of one

    /// Tells whether the set holds all of these.
    [[nodiscard]] constexpr bool contains(Field field) const noexcept {
        return (bits & (1U << static_cast<unsigned>(field))) != 0;
    }

    /// Tells whether the set holds all of these.
    [[nodiscard]] constexpr bool contains(Fields other) const noexcept {
        return (bits & other.bits) == other.bits;
    }

    /// Returns the number of fields in the set.
    [[nodiscard]] constexpr int count() const noexcept {
        int sum = 0;
        for (unsigned rest = bits; rest != 0; rest &= rest - 1) ++sum;
        return sum;
    }

    /// Returns how many fields of the set stand before this one: its place in a node's coordinates.
    [[nodiscard]] constexpr int rank(Field field) const noexcept {
        return Fields(bits & ((1U << static_cast<unsigned>(field)) - 1U)).count();
    }

    /// Returns the field of a rank, 0 <= rank < count().
    [[nodiscard]] constexpr Field at(int rank) const noexcept {
        int k = 0;
        for (; rank > 0 || !contains(static_cast<Field>(k)); ++k)
            if (contains(static_cast<Field>(k))) --rank;
        return static_cast<Field>(k);
    }

    /// Returns the union.
    friend constexpr Fields operator|(Fields a, Fields b) noexcept {
        return Fields(a.bits | b.bits);
    }
    /// Compares two sets.
    friend constexpr bool operator==(Fields a, Fields b) noexcept { return a.bits == b.bits; }
    /// Compares two sets.
    friend constexpr bool operator!=(Fields a, Fields b) noexcept { return a.bits != b.bits; }

private:
    constexpr explicit Fields(unsigned set) : bits(set) {}
};

/// Returns the set of both.
constexpr Fields operator|(Field a, Field b) noexcept { return Fields(a) | Fields(b); }

}  // namespace ancf
