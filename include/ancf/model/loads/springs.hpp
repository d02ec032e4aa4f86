// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A spring and a damper between two points, or a point and a place.
///
/// Points are nodes or lie along elements (point_along). docs/theory-damping.md derives both.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <utility>

namespace ancf {

/// A linear spring: it pulls its points together by k (l - l0), l their distance.
///
/// With l0 = 0 the force is k times the difference of the points, in every direction. Otherwise it
/// is no number where the points meet, and the run ends as `not_finite`.
template <int Dimension = 3>
class Spring {
public:
    static constexpr int dimension = Dimension;        ///< of the model it belongs to
    static constexpr bool symmetric_stiffness = true;  ///< its stiffness is symmetric
    static constexpr bool in_full = true;              ///< it does not grow with a load factor

    /// @param stiffness  k >= 0, N/m  @param length  l0 >= 0, m
    /// @throws InvalidArgument for a value that is negative or not finite, or if both are the same
    ///         node.
    Spring(MaterialPoint a, MaterialPoint b, double stiffness, double length)
        : Spring(Points(std::move(a), std::move(b)), stiffness, length) {}

    /// @throws InvalidArgument for a value that is negative or not finite.
    Spring(MaterialPoint a, const VectorArgument<Dimension>& place, double stiffness, double length)
        : Spring(Points(std::move(a), place, "Spring"), stiffness, length) {}

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return points_.coupling(); }

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    using Points = detail::PointPair<Dimension>;

    Spring(Points points, double stiffness, double length)
        : points_(std::move(points)), stiffness_(stiffness), length_(length) {
        detail::require_not_negative("Spring: the stiffness", stiffness);
        detail::require_not_negative("Spring: the length", length);
    }

    Points points_;
    double stiffness_;
    double length_;
};

/// A linear damper: it resists the rate of the distance of its points, by c dl/dt.
///
/// Its stiffness is not symmetric: a run with it needs a linear solver of full storage. Where the
/// points meet it is no number, and the run ends as `not_finite`.
template <int Dimension = 3>
class Damper {
public:
    static constexpr int dimension = Dimension;  ///< of the model it belongs to
    static constexpr bool in_full = true;        ///< it does not grow with a load factor

    /// @param damping  c >= 0, N s/m
    /// @throws InvalidArgument for a value that is negative or not finite, or if both are the same
    ///         node.
    Damper(MaterialPoint a, MaterialPoint b, double damping)
        : Damper(Points(std::move(a), std::move(b)), damping) {}

    /// @throws InvalidArgument for a value that is negative or not finite.
    Damper(MaterialPoint a, const VectorArgument<Dimension>& place, double damping)
        : Damper(Points(std::move(a), place, "Damper"), damping) {}

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return points_.coupling(); }

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    using Points = detail::PointPair<Dimension>;

    Damper(Points points, double damping) : points_(std::move(points)), damping_(damping) {
        detail::require_not_negative("Damper: the damping", damping);
    }

    Points points_;
    double damping_;
};

#if defined(ANCF_COMPILED)
extern template class Spring<2>;
extern template class Spring<3>;
extern template class Damper<2>;
extern template class Damper<3>;
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/loads/springs.ipp>  // IWYU pragma: export
#endif
