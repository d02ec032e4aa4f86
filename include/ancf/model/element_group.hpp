// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Elements of one type, as the rest of the library sees them: without their type; and where they
/// read coordinates and add forces and tangents.
///
/// ElementGroup is what a scene keeps and an assembly works with; group_of.hpp implements it for
/// each type of element.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

#include <array>
#include <memory>
#include <string_view>
#include <typeinfo>

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
}  // namespace detail

/// What an assembly hands to a group of elements. Vectors are of all coordinates of the scene.
///
/// The tangent's values of a pair of nodes (a, b) stand at slots.base[a][b] + column + row, with
/// the row within the node's block and the column's place from column_offset().
struct GroupTarget {
    const ElementSlots* slots;                ///< of each element of the group
    const Layout& layout;                     ///< of the scene
    const int* equation;                      ///< of each coordinate, -1 where a support holds it
    const int* first_row;                     ///< of each block
    const int* height;                        ///< stored rows in the first column of each block
    Storage storage;                          ///< of the tangent
    double* values;                           ///< of the tangent, to add to
    const detail::AttachedElement* attached;  ///< those of the group's elements, or null

    const double* q = nullptr;          ///< coordinates
    const double* increment = nullptr;  ///< their change whose linear effect is wanted, or null
    const double* before = nullptr;     ///< where the last correction began, or null
    const double* change = nullptr;     ///< the last correction, or null
    bool tangent = false;               ///< wanted beside the force
    double* internal_force = nullptr;   ///< to add to
    double* predicted_force = nullptr;  ///< that of the tangent's stresses, to add to, or null

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

/// An element of a group: which prototype, between which nodes.
struct Connection {
    int prototype;  ///< index in the group
    NodeId first;   ///< node at x = 0
    NodeId second;  ///< node at x = l
};

/// All elements of one type. Coordinates, forces and matrices of one element are passed as pointers
/// to dofs() or dofs() x dofs() doubles, matrices by columns.
class ElementGroup {
public:
    static constexpr int max_dofs = 2 * 3 * field_count;  ///< no element has more

    virtual ~ElementGroup() = default;

    /// Returns a copy with all prototypes and connections.
    [[nodiscard]] virtual std::unique_ptr<ElementGroup> clone() const = 0;

    /// Returns the name of the element's type.
    [[nodiscard]] std::string_view name() const noexcept { return type_.name; }
    /// Returns the vectors that a node of such an element carries.
    [[nodiscard]] Fields fields() const noexcept { return type_.fields; }
    /// Returns the number of nodal coordinates.
    [[nodiscard]] int dofs() const noexcept { return type_.dofs; }
    /// Tells whether the element has the tangent of mixed integration points.
    [[nodiscard]] bool evaluates_mixed() const noexcept { return type_.evaluates_mixed; }
    /// Tells whether an element has one node, which is then its first and its second one.
    [[nodiscard]] bool one_node() const noexcept { return type_.one_node; }
    /// Tells whether the group holds elements of a type.
    template <class Element>
    [[nodiscard]] bool holds() const noexcept {
        return type_.id == type_id<Element>() || is_of_type(*type_id<Element>());
    }

    List<Connection> connections;  ///< one for each element

    /// Returns the number of elements.
    [[nodiscard]] int size() const noexcept { return static_cast<int>(connections.size()); }
    /// Returns which prototype an element has and its nodes.
    /// @throws InvalidArgument for an index of no element.
    [[nodiscard]] const Connection& connection(int index) const {
        detail::require(index >= 0 && index < size(), "Model: there are ", connections.size(),
                        " elements of the type ", name(), ", got index ", index);
        return connections[index];
    }
    /// Returns the prototype of an element of the group.
    [[nodiscard]] int prototype_of(int index) const noexcept {
        return connections[index].prototype;
    }
    /// Returns the number of prototypes.
    [[nodiscard]] virtual int prototype_count() const noexcept = 0;

    /// Returns the reference length, m.
    [[nodiscard]] virtual double length(int prototype) const = 0;
    /// Returns the strain energy, J.
    [[nodiscard]] virtual double energy(int prototype, const double* e) const = 0;
    /// Writes the elastic force.
    virtual void force(int prototype, const double* e, double* out) const = 0;
    /// Writes the elastic force and the tangent; returns the strain energy, J.
    virtual double evaluate(int prototype, const double* e, double* force,
                            double* tangent) const = 0;
    /// Tells whether the strains are defined.
    [[nodiscard]] virtual bool admissible(int prototype, const double* e) const = 0;
    /// Tells whether the element is so short that its law softens; false where it does not say.
    [[nodiscard]] virtual bool softened(int prototype, const double* e) const = 0;
    /// Writes the mass matrix.
    virtual void mass(int prototype, double* out) const = 0;
    /// Writes the force of gravity.
    /// @param acceleration  as many components as space has, m/s^2
    virtual void gravity(int prototype, const double* acceleration, double* out) const = 0;
    /// Writes what its torsion puts on r_y and on r_z; zero where the element does not say.
    virtual void torsion_stiffness(int prototype, double (&out)[2]) const = 0;

    /// Evaluates elements of a run and adds their forces and, where wanted, their tangents.
    /// @return their strain energy, J; 0 where the force alone is wanted.
    virtual double add(const ElementRun& run, const GroupTarget& target) const = 0;

    /// Adds a matrix of one element, by its index, to the values of a tangent.
    virtual void add_block(int index, const GroupTarget& target, const double* block) const = 0;

protected:
    /// What tells a type from others: by its address, and in several shared libraries, which may
    /// have one address each, by the run-time type information, where there is such.
    struct TypeId {
        const std::type_info* run_time;  ///< null without
    };

    /// What a type of element is.
    struct Type {
        const TypeId* id;       ///< type_id() of it
        std::string_view name;  ///< as the compiler writes it
        Fields fields;          ///< of a node
        int dofs;               ///< of an element
        bool evaluates_mixed;   ///< has the tangent of mixed integration points
        bool one_node;          ///< stands at one node
    };

    /// @param type  what derived classes know
    explicit ElementGroup(const Type& type) noexcept : type_(type) {}
    ElementGroup(const ElementGroup&) = default;             ///< by clone() alone
    ElementGroup& operator=(const ElementGroup&) = default;  ///< by derived classes alone

    /// Returns what tells a type from others.
    template <class Element>
    [[nodiscard]] static const TypeId* type_id() noexcept {
        // not constant: linkers may fold constants that are alike
#if defined(__cpp_rtti)
        static TypeId id = {&typeid(Tag<Element>)};
#else
        static TypeId id = {nullptr};
#endif
        return &id;
    }

private:
    /// Has run-time type information without that of an element's bases.
    template <class Element>
    struct Tag {};

    /// Compares by run-time type information, where addresses differ.
    [[nodiscard, gnu::cold, gnu::noinline]] bool is_of_type(const TypeId& id) const noexcept {
        return id.run_time != nullptr && type_.id->run_time != nullptr &&
               *id.run_time == *type_.id->run_time;
    }

    Type type_;
};

}  // namespace ancf
