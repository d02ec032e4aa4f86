// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Elements of one type, as the rest of the library sees them: without their type.
///
/// ElementGroup is what a scene keeps and an assembly works with. GroupOf<Element> is the one place
/// above an element that knows its type: it gathers coordinates, evaluates one element or several
/// side by side, and adds force and tangent where the assembly wants them.

#pragma once

#include <ancf/element/compiled_element.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/error.hpp>
#include <ancf/model/group_target.hpp>
#include <ancf/model/node.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

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

    // What the type is -------------------------------------------------------------------------

    /// Returns the name of the element's type.
    [[nodiscard]] std::string_view name() const noexcept { return type_.name; }
    /// Returns the vectors that a node of such an element carries.
    [[nodiscard]] Fields fields() const noexcept { return type_.fields; }
    /// Returns the number of nodal coordinates.
    [[nodiscard]] int dofs() const noexcept { return type_.dofs; }
    /// Tells whether the element has the tangent of mixed integration points.
    [[nodiscard]] bool evaluates_mixed() const noexcept { return type_.evaluates_mixed; }
    /// Tells whether the group holds elements of a type.
    template <class Element>
    [[nodiscard]] bool holds() const noexcept {
        return type_.id == type_id<Element>();
    }

    // What it holds ----------------------------------------------------------------------------

    std::vector<Connection> connections;  ///< one for each element

    /// Returns the number of elements.
    [[nodiscard]] int size() const noexcept { return static_cast<int>(connections.size()); }
    /// Returns which prototype an element has and its nodes.
    /// @throws InvalidArgument for an index of no element.
    [[nodiscard]] const Connection& connection(int index) const {
        detail::require(index >= 0 && index < size(), "Model: there are ", connections.size(),
                        " elements of the type ", name(), ", got index ", index);
        return connections[static_cast<std::size_t>(index)];
    }
    /// Returns the prototype of an element of the group.
    [[nodiscard]] int prototype_of(int index) const noexcept {
        return connections[static_cast<std::size_t>(index)].prototype;
    }
    /// Returns the number of prototypes.
    [[nodiscard]] virtual int prototype_count() const noexcept = 0;

    // One element, given by its prototype ------------------------------------------------------

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

    // All that an assembly asks for at every iteration -----------------------------------------

    /// Evaluates elements of a run and adds their forces and, where wanted, their tangents.
    /// @return their strain energy, J; 0 where the force alone is wanted.
    virtual double add(const ElementRun& run, const GroupTarget& target) const = 0;

protected:
    struct Type {
        const void* id;
        std::string_view name;
        Fields fields;
        int dofs;
        bool evaluates_mixed;
    };

    explicit ElementGroup(const Type& type) noexcept : type_(type) {}
    ElementGroup(const ElementGroup&) = default;
    ElementGroup& operator=(const ElementGroup&) = default;

    /// Returns what tells a type from others, without run-time type information.
    template <class Element>
    [[nodiscard]] static const void* type_id() noexcept {
        static const char id = 0;
        return &id;
    }

private:
    Type type_;
};

namespace detail {

/// Returns the name of a type as the compiler writes it, without the library's namespace.
template <class T>
[[nodiscard]] constexpr std::string_view type_name() noexcept {
#if defined(__GNUC__)
    std::string_view text = __PRETTY_FUNCTION__;
    text.remove_prefix(text.find("T = ") + 4);
    text = text.substr(0, text.find_first_of(";]"));
#elif defined(_MSC_VER)
    std::string_view text = __FUNCSIG__;
    text.remove_prefix(text.find("type_name<") + 10);
    text = text.substr(0, text.rfind(">(void)"));
    text.remove_prefix(text.find(' ') + 1);
#else
    std::string_view text = "element";
#endif
    constexpr std::string_view own = "ancf::";
    if (text.substr(0, own.size()) == own) text.remove_prefix(own.size());
    return text;
}

/// Whether an element tells where its law softens.
template <class Element, class = void>
struct TellsSoftened : std::false_type {};
template <class Element>
struct TellsSoftened<Element, std::void_t<decltype(std::declval<const Element&>().softened(
                                  std::declval<const typename Element::Coordinates&>()))>>
    : std::true_type {};

/// Whether an element has the tangent of mixed integration points.
template <class Element, class = void>
struct EvaluatesMixed : std::false_type {};
template <class Element>
struct EvaluatesMixed<Element, std::void_t<decltype(std::declval<const Element&>().evaluate(
                                   std::declval<const typename Element::Coordinates&>(),
                                   std::declval<const typename Element::Coordinates&>(),
                                   std::declval<const typename Element::Coordinates&>()))>>
    : std::true_type {};

/// Whether an element tells how its torsion divides between the slopes of a section.
template <class Element, class = void>
struct HasTorsionStiffness : std::false_type {};
template <class Element>
struct HasTorsionStiffness<Element, std::void_t<decltype(Vector<double, 2>(
                                        std::declval<const Element&>().torsion_stiffness()))>>
    : std::true_type {};

}  // namespace detail

/// The elements of one type, with their type.
template <class Element>
class GroupOf final : public ElementGroup {
    static_assert(require_element<Element>());

public:
    using Coordinates = typename Element::Coordinates;  ///< of one element

    GroupOf()
        : ElementGroup({type_id<Element>(), detail::type_name<Element>(), Element::fields,
                        Element::dofs, detail::EvaluatesMixed<Element>::value}) {}

    std::vector<Element> prototypes;  ///< constant data, shared by equal elements

    /// Returns the prototype of an element.
    /// @throws InvalidArgument for an index of no element.
    [[nodiscard]] const Element& element(int index) const {
        return prototype(connection(index).prototype);
    }

    [[nodiscard]] std::unique_ptr<ElementGroup> clone() const override {
        return std::make_unique<GroupOf>(*this);
    }
    [[nodiscard]] int prototype_count() const noexcept override {
        return static_cast<int>(prototypes.size());
    }
    [[nodiscard]] double length(int k) const override { return prototype(k).length(); }
    [[nodiscard]] double energy(int k, const double* e) const override {
        return prototype(k).energy(copied(e));
    }
    void force(int k, const double* e, double* out) const override {
        Eigen::Map<Coordinates>{out} = prototype(k).force(copied(e));
    }
    double evaluate(int k, const double* e, double* force, double* tangent) const override {
        const auto result = prototype(k).evaluate(copied(e));
        Eigen::Map<Coordinates>{force} = result.force;
        Eigen::Map<Matrix<double, Element::dofs>>{tangent} = result.tangent;
        return result.energy;
    }
    [[nodiscard]] bool admissible(int k, const double* e) const override {
        return prototype(k).admissible(copied(e));
    }
    [[nodiscard]] bool softened(int k, const double* e) const override {
        if constexpr (detail::TellsSoftened<Element>::value) {
            return prototype(k).softened(copied(e));
        } else {
            static_cast<void>(k);
            static_cast<void>(e);
            return false;
        }
    }
    void mass(int k, double* out) const override {
        Eigen::Map<Matrix<double, Element::dofs>>{out} = prototype(k).mass();
    }
    void gravity(int k, const double* acceleration, double* out) const override {
        const Vector<double, Element::dimension> g =
            Eigen::Map<const Vector<double, Element::dimension>>{acceleration};
        Eigen::Map<Coordinates>{out} = prototype(k).gravity(g);
    }
    void torsion_stiffness(int k, double (&out)[2]) const override {
        out[0] = out[1] = 0.0;
        if constexpr (detail::HasTorsionStiffness<Element>::value) {
            const Vector<double, 2> own = prototype(k).torsion_stiffness();
            out[0] = own[0];
            out[1] = own[1];
        } else {
            static_cast<void>(k);
        }
    }
    double add(const ElementRun& run, const GroupTarget& target) const override;

private:
    [[nodiscard]] const Element& prototype(int k) const {
        return prototypes[static_cast<std::size_t>(k)];
    }
    [[nodiscard]] static Coordinates copied(const double* e) {
        return Eigen::Map<const Coordinates>{e};
    }

    double add_element(int index, const GroupTarget& target) const;
    template <int Lanes>
    double add_pack(int first, const GroupTarget& target) const;
};

}  // namespace ancf

#include <ancf/model/element_group.ipp>
