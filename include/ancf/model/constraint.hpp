// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a constraint must offer, and the holder that lets a model keep constraints of any type.
///
/// A constraint is g(q, t) = 0 on a few nodal vectors. It gives g, its Jacobian G = dg/dq, the
/// stiffness d(G^T lambda)/dq at fixed multipliers and what its time derivatives need:
///
///     dg/dt = G v + g_t,    d2g/dt2 = G a + c,    c = (G v)_q v + 2 (g_t)_q v + g_tt.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/list.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace ancf {

/// Where a constraint is evaluated; local coordinates in the order of its coupling.
struct ConstraintState {
    VectorX q;            ///< local coordinates, m and 1
    VectorX v;            ///< their rates
    VectorX multipliers;  ///< lambda, one per equation
    double time = 0.0;    ///< s; the load factor in statics
};

/// What a constraint tells of its equations by itself; every array arrives sized and zero.
template <class Scalar>
struct ConstraintTerms {
    DynamicVector<Scalar> violation;  ///< g
    DynamicMatrix<Scalar> jacobian;   ///< G, equations x local coordinates
    DynamicVector<Scalar> rate;       ///< g_t, zero unless the constraint moves in time

    /// Makes everything zero, for so many equations in so many local coordinates.
    void reset(Eigen::Index equations, Eigen::Index coordinates) {
        violation.setZero(equations);
        jacobian.setZero(equations, coordinates);
        rate.setZero(equations);
    }
};

/// What a constraint gives; every array arrives sized and zero.
struct ConstraintResult : ConstraintTerms<double> {
    MatrixX stiffness;   ///< d(G^T lambda)/dq; without a size where there are stiffness_parts
    List<int> active;    ///< local coordinates of its rows and columns; empty: all
    VectorX convection;  ///< c, the part of d2g/dt2 that is free of accelerations

    /// Makes everything zero, for so many equations in so many local coordinates, of which as many
    /// as told have a stiffness.
    void reset(Eigen::Index equations, Eigen::Index coordinates, Eigen::Index stiff) {
        ConstraintTerms::reset(equations, coordinates);
        stiffness.setZero(stiff, stiff);
        active.clear();
        convection.setZero(equations);
    }
};

namespace detail {

template <class T>
using ConstraintMembers =
    std::void_t<decltype(Coupling(some<T>().coupling())), decltype(int(some<T>().equations())),
                decltype(std::string(some<T>().name())),
                decltype(some<T>().evaluate(some<ConstraintState>(),
                                            std::declval<ConstraintResult&>()))>;

/// Of a constraint that tells the angle that it is driven to.
template <class T>
using DrivenAngle = decltype(double(some<T>().driven_angle(0.0)));

/// Of a constraint whose stiffness couples some of its vectors.
template <class T>
using StiffnessParts = decltype(List<Coupling>(some<T>().stiffness_parts()));

/// Of a constraint that tells g, G and g_t alone.
template <class T>
using TermsMember = decltype(some<T>().terms(some<VectorX>(), some<double>(),
                                             std::declval<ConstraintTerms<double>&>()));

/// Returns the angle that a constraint is driven to at a time, rad; 0 where it tells none.
template <class T>
[[nodiscard]] double driven_angle(const T& constraint, double time) {
    if constexpr (offers<DrivenAngle, T>)
        return constraint.driven_angle(time);
    else
        return 0.0 * time;
}

}  // namespace detail

/// True if `T` offers what a constraint must.
template <class T>
inline constexpr bool is_constraint_v = detail::offers<detail::ConstraintMembers, T>;

/// A constraint of any type.
///
/// Optional members: `static constexpr int dimension`, of the models it belongs to.
/// `double driven_angle(double time) const`, rad: the angle that it drives, whole turns included;
/// no step then changes the angle by more than a sixth of a turn.
/// `List<Coupling> stiffness_parts() const`: lists of its vectors; its stiffness is zero but
/// between vectors of one list. evaluate() then gives `stiffness` its size and lists in `active`
/// the local coordinates of its rows. Without it there is one list of all.
/// `terms(q, time, ConstraintTerms<double>&)`: g, G and g_t alone, cheaper where no more is needed.
class AnyConstraint {
public:
    /// Holds a copy of the constraint.
    template <class Constraint>
    explicit AnyConstraint(Constraint constraint)
        : held_(new Holder<Constraint>(std::move(constraint))),
          equations_(held_->equations()),
          parted_(detail::offers<detail::StiffnessParts, Constraint>) {
        static_assert(is_constraint_v<Constraint>,
                      "a constraint offers `Coupling coupling() const`, `int equations() const`, "
                      "`std::string name() const` and "
                      "`void evaluate(const ConstraintState&, ConstraintResult&) const`");
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return held_->coupling(); }
    /// Returns the lists of vectors that its stiffness couples.
    [[nodiscard]] List<Coupling> stiffness_parts() const { return held_->stiffness_parts(); }
    /// Returns the number of equations, as it was when the holder was made.
    [[nodiscard]] int equations() const noexcept { return equations_; }
    /// Returns the word that messages use.
    [[nodiscard]] std::string name() const { return held_->name(); }
    /// Evaluates it into `out` of any size.
    /// @throws InvalidArgument where it changes the size of a result or its number of equations.
    void evaluate(const ConstraintState& state, ConstraintResult& out) const;
    /// Evaluates g, G and g_t into `out` of any size; what else stands in it has no meaning then.
    /// @throws InvalidArgument where it changes the size of a result or its number of equations.
    void terms(const ConstraintState& state, ConstraintResult& out) const;
    /// Returns the angle that it is driven to, rad; 0 where it drives none.
    [[nodiscard]] double driven_angle(double time) const { return held_->driven_angle(time); }

private:
    struct Interface {
        virtual ~Interface() = default;
        [[nodiscard]] virtual Coupling coupling() const = 0;
        [[nodiscard]] virtual List<Coupling> stiffness_parts() const = 0;
        [[nodiscard]] virtual int equations() const = 0;
        [[nodiscard]] virtual std::string name() const = 0;
        virtual void evaluate(const ConstraintState&, ConstraintResult&) const = 0;
        virtual void terms(const ConstraintState&, ConstraintResult&) const = 0;
        [[nodiscard]] virtual double driven_angle(double time) const = 0;
    };

    // Returns one part of all vectors.
    [[nodiscard]] static List<Coupling> whole(const Coupling& all);

    // Throws where the constraint has another number of equations than it had.
    void check_equations() const;

    // Throws where results have another size than was asked for; `terms_alone`: g, G, g_t.
    void check_sizes(const ConstraintState& state, const ConstraintResult& out,
                     bool terms_alone) const;

    template <class Constraint>
    struct Holder final : Interface {
        explicit Holder(Constraint held) : constraint(std::move(held)) {}
        [[nodiscard]] Coupling coupling() const override { return constraint.coupling(); }
        [[nodiscard]] List<Coupling> stiffness_parts() const override {
            if constexpr (detail::offers<detail::StiffnessParts, Constraint>)
                return constraint.stiffness_parts();
            else
                return whole(constraint.coupling());
        }
        [[nodiscard]] int equations() const override { return constraint.equations(); }
        [[nodiscard]] std::string name() const override { return constraint.name(); }
        void evaluate(const ConstraintState& state, ConstraintResult& out) const override {
            constraint.evaluate(state, out);
        }
        void terms(const ConstraintState& state, ConstraintResult& out) const override {
            if constexpr (detail::offers<detail::TermsMember, Constraint>) {
                constraint.terms(state.q, state.time, out);
            } else {
                const bool parted = detail::offers<detail::StiffnessParts, Constraint>;
                const Eigen::Index stiff = parted ? 0 : state.q.size();
                out.stiffness.setZero(stiff, stiff);
                out.convection.setZero(state.multipliers.size());
                constraint.evaluate(state, out);
            }
        }
        [[nodiscard]] double driven_angle(double time) const override {
            return detail::driven_angle(constraint, time);
        }
        Constraint constraint;
    };

    std::shared_ptr<const Interface> held_;
    int equations_;
    bool parted_;  // it has stiffness_parts
};

namespace detail {

/// The most that a driven angle may change in one step, rad. A joint knows its angle but for whole
/// turns, so below half a turn a step can only end in the right one. Up to pi/3 its equations are
/// sines (constraints/frames.hpp), of which one correction finds the turn of a slope: it adds
/// tan(angle).
inline constexpr double largest_driven_turn = pi / 3.0;

/// The constraint that is driven furthest between two times.
struct DrivenTurn {
    double angle = 0.0;  ///< rad, not negative
    std::size_t constraint = 0;

    /// Whether one step may take it.
    [[nodiscard]] bool fits() const noexcept {
        return !(angle > largest_driven_turn * (1.0 + 1e-9));
    }
};

/// Returns the constraint that is driven furthest between two times.
[[nodiscard]] DrivenTurn driven_turn(const List<AnyConstraint>& constraints, double from,
                                     double to);

/// Returns into how many equal parts, a power of two, a step is cut so that no joint is driven by
/// more than pi/12 in one. 1 where no number of parts is enough: the angle jumps.
[[nodiscard]] int parts_for_turns(const List<AnyConstraint>& constraints, double from, double to);

/// Returns why no step from one time or load factor to another can be taken.
[[nodiscard]] std::string driven_turn_text(const List<AnyConstraint>& constraints,
                                           const DrivenTurn& turn, double from, double to);

}  // namespace detail
}  // namespace ancf

#if defined(ANCF_SOURCE)
/// In the compiled library: the terms of a constraint for the scalars that motions are given in.
#define ANCF_CONSTRAINT_INSTANCES(...)                                            \
    template void __VA_ARGS__::terms(const DynamicVector<double>&, const double&, \
                                     ConstraintTerms<double>&) const;             \
    template void __VA_ARGS__::terms(const DynamicVector<std::complex<double>>&,  \
                                     const std::complex<double>&,                 \
                                     ConstraintTerms<std::complex<double>>&) const;
#endif

#if !defined(ANCF_COMPILED)
#include <ancf/model/constraint.ipp>  // IWYU pragma: export
#endif
