// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>

#include <cmath>

namespace ancf {

ANCF_INLINE void AnyConstraint::evaluate(const ConstraintState& state,
                                         ConstraintResult& out) const {
    check_equations();
    const Eigen::Index size = state.q.size();
    out.reset(state.multipliers.size(), size, parted_ ? 0 : size);
    held_->evaluate(state, out);
    check_sizes(state, out, false);
}

ANCF_INLINE void AnyConstraint::terms(const ConstraintState& state, ConstraintResult& out) const {
    check_equations();
    out.ConstraintTerms::reset(state.multipliers.size(), state.q.size());
    out.active.clear();
    held_->terms(state, out);
    check_sizes(state, out, true);
}

ANCF_INLINE List<Coupling> AnyConstraint::whole(const Coupling& all) { return {all}; }

ANCF_INLINE void AnyConstraint::check_equations() const {
    const int now = held_->equations();
    if (now == equations_) return;
    detail::reject("constraint ", name(), " had ", equations_, " equations when it was added and ",
                   now, " now: its number must stay");
}

ANCF_INLINE void AnyConstraint::check_sizes(const ConstraintState& state,
                                            const ConstraintResult& out, bool terms_alone) const {
    const Eigen::Index size = state.q.size(), equations = state.multipliers.size();
    const auto stiff = out.active.empty() ? size : static_cast<Eigen::Index>(out.active.size());
    bool inside = true;
    for (const int coordinate : out.active) inside = inside && coordinate >= 0 && coordinate < size;
    if (inside && out.violation.size() == equations && out.rate.size() == equations &&
        out.jacobian.rows() == equations && out.jacobian.cols() == size &&
        (terms_alone || (out.stiffness.rows() == stiff && out.stiffness.cols() == stiff &&
                         out.convection.size() == equations)))
        return;
    detail::reject("constraint ", name(), " of ", equations, " equations on ", size,
                   " coordinates changed the size of its results; its violation has ",
                   out.violation.size(), " entries, its rate ", out.rate.size(),
                   ", its convection ", out.convection.size(), ", its jacobian is ",
                   out.jacobian.rows(), " x ", out.jacobian.cols(), ", its stiffness ",
                   out.stiffness.rows(), " x ", out.stiffness.cols());
}

namespace detail {

ANCF_INLINE DrivenTurn driven_turn(const List<AnyConstraint>& constraints, double from, double to) {
    DrivenTurn most;
    for (std::size_t k = 0; k < constraints.size(); ++k) {
        const double turn =
            std::abs(constraints[k].driven_angle(to) - constraints[k].driven_angle(from));
        if (turn > most.angle) most = {turn, k};
    }
    return most;
}

ANCF_INLINE int parts_for_turns(const List<AnyConstraint>& constraints, double from, double to) {
    constexpr double largest_turn = 0.25 * largest_driven_turn;
    constexpr int most = 1024;
    for (int parts = 1; parts <= most; parts *= 2) {
        const double width = (to - from) / parts;
        bool fits = true;
        for (int k = 0; k < parts && fits; ++k) {
            const double begin = from + k * width;
            fits = !(driven_turn(constraints, begin, begin + width).angle > largest_turn);
        }
        if (fits) return parts;
    }
    return 1;
}

ANCF_INLINE std::string driven_turn_text(const List<AnyConstraint>& constraints,
                                         const DrivenTurn& turn, double from, double to) {
    return joined({"constraint ", turn.constraint, " (", constraints[turn.constraint].name(),
                   ") is driven by ", turn.angle, " rad between ", from, " and ", to,
                   ", one step takes ", largest_driven_turn, " rad"});
}

}  // namespace detail
}  // namespace ancf
