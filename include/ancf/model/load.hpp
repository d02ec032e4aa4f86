// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a load must offer, and the holder that lets a model keep loads of any type.
///
/// A load acts on a few nodal vectors. It gives its generalised force and the derivatives of that
/// force; the model multiplies all of them by the load's amplitude. The smallest one:
///
///     struct Weight {
///         ancf::NodeId node;
///         static constexpr bool constant_force = true;
///         ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
///         void evaluate(const ancf::LoadState&, ancf::LoadResult& out) const {
///             out.force[1] = -1.0;
///         }
///     };

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <type_traits>
#include <utility>

namespace ancf {

/// Where a load is evaluated; local coordinates in the order of its coupling.
struct LoadState {
    VectorX q;                ///< local coordinates, m and 1
    VectorX v;                ///< their rates
    double time = 0.0;        ///< s; the load factor in statics
    bool derivatives = true;  ///< whether a load's stiffness and damping are asked for
};

/// What a load gives; every array arrives sized and zero, and keeps its size.
struct LoadResult {
    VectorX force;           ///< generalised force Q, N and N m
    MatrixX stiffness;       ///< dQ/dq; empty for a load of constant force
    MatrixX damping;         ///< dQ/dv; empty for a load of constant force
    double potential = 0.0;  ///< V with Q = -dV/dq, J; 0 where there is none
    double period = 0.0;     ///< J; of a V of an angle, its jump after a turn; else 0
};

namespace detail {

template <class T>
using LoadMembers =
    std::void_t<decltype(Coupling(some<T>().coupling())),
                decltype(some<T>().evaluate(some<LoadState>(), std::declval<LoadResult&>()))>;

// What a load may declare besides.
template <class T>
using SymmetricStiffness = std::enable_if_t<T::symmetric_stiffness>;
template <class T>
using ConstantForce = std::enable_if_t<T::constant_force>;
template <class T>
using ActsInFull = std::enable_if_t<T::in_full>;
template <class T>
using Settles = decltype(std::declval<T&>().settle(some<Layout>()));

}  // namespace detail

/// True if `T` offers what a load must.
template <class T>
inline constexpr bool is_load_v = detail::offers<detail::LoadMembers, T>;

/// A load of any type.
///
/// Optional members: `static constexpr bool symmetric_stiffness = true`, or `constant_force = true`
/// where the force depends neither on coordinates nor on rates; without either the tangent counts
/// as unsymmetric and needs a solver of full storage. `static constexpr bool in_full = true`, for a
/// spring: without an amplitude it does not grow with the load factor of statics. `static constexpr
/// int dimension`, of the models it belongs to. `void settle(const Layout&)`, for a load that
/// depends on the vectors that its node has: the model calls it once, before it keeps the load.
class AnyLoad {
public:
    /// Holds a copy of the load.
    template <class Load>
    explicit AnyLoad(Load load)
        : held_(new Holder<Load>(std::move(load))),
          constant_(detail::offers<detail::ConstantForce, Load>),
          symmetric_(constant_ || detail::offers<detail::SymmetricStiffness, Load>),
          settles_(detail::offers<detail::Settles, Load>) {
        static_assert(is_load_v<Load>,
                      "a load offers `Coupling coupling() const` and "
                      "`void evaluate(const LoadState&, LoadResult&) const`");
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return held_->coupling(); }
    /// Tells whether its stiffness is symmetric.
    [[nodiscard]] bool symmetric() const noexcept { return symmetric_; }
    /// Tells whether its force depends neither on coordinates nor on rates.
    [[nodiscard]] bool constant() const noexcept { return constant_; }
    /// Tells whether it acts on what its node carries.
    [[nodiscard]] bool settles() const noexcept { return settles_; }
    /// Settles on what its node carries.
    void settle(const Layout& layout) { held_ = held_->settled(layout); }
    /// Evaluates it.
    /// @throws InvalidArgument where it changes the size of a result.
    void evaluate(const LoadState& state, LoadResult& out) const {
        const Eigen::Index size = state.q.size();
        const Eigen::Index stiffness = out.stiffness.rows(), damping = out.damping.rows();
        held_->evaluate(state, out);
        const auto sized = [](const MatrixX& m, Eigen::Index rows) {
            return m.rows() == rows && m.cols() == rows;
        };
        detail::require(
            out.force.size() == size && sized(out.stiffness, stiffness) &&
                sized(out.damping, damping),
            "a load on ", size, " coordinates changed the size of its results; its force has ",
            out.force.size(), " entries, its stiffness is ", out.stiffness.rows(), " x ",
            out.stiffness.cols(), ", its damping ", out.damping.rows(), " x ", out.damping.cols());
    }

private:
    struct Interface {
        virtual ~Interface() = default;
        [[nodiscard]] virtual std::shared_ptr<const Interface> settled(const Layout&) const = 0;
        [[nodiscard]] virtual Coupling coupling() const = 0;
        virtual void evaluate(const LoadState&, LoadResult&) const = 0;
    };

    template <class Load>
    struct Holder final : Interface {
        explicit Holder(Load held) : load(std::move(held)) {}
        [[nodiscard]] Coupling coupling() const override { return load.coupling(); }
        [[nodiscard]] std::shared_ptr<const Interface> settled(
            const Layout& layout) const override {
            Holder* const copy = new Holder(load);
            std::shared_ptr<const Interface> held(copy);
            if constexpr (detail::offers<detail::Settles, Load>) copy->load.settle(layout);
            return held;
        }
        void evaluate(const LoadState& state, LoadResult& out) const override {
            load.evaluate(state, out);
        }
        Load load;
    };

    std::shared_ptr<const Interface> held_;
    bool constant_, symmetric_, settles_;
};

}  // namespace ancf
