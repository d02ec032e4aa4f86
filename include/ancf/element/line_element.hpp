// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What every element along a line from node to node has: its stress-free line, its mass, and the
/// way to its kernel; and whether coordinates make a beam at all.
///
/// The class of a family says how an element is made and what its results are. Its kernel has
/// energy, force and tangent.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/hermite.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/element/reference_line.hpp>
#include <ancf/error.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <cmath>

namespace ancf::detail {

/// Returns the determinant of the columns [p, r_y] or [p, r_y, r_z].
[[nodiscard]] inline double orientation(const Vector<double, 2> (&v)[2]) noexcept {
    return v[0][0] * v[1][1] - v[0][1] * v[1][0];
}
[[nodiscard]] inline double orientation(const Vector<double, 3> (&v)[3]) noexcept {
    return product(v[2], cross(v[0], v[1]));
}

/// Tells whether an element is upright all along: its slopes turn by less than 120 degrees from
/// node to node (their linear interpolation then keeps half of their length), its tangent by less
/// than 90 degrees from seventh to seventh of the element, and there tangent and slopes are longer
/// than 1e-6 and right-handed, det > 1e-6 of the product of their lengths.
///
/// The energy is an integral by stations; it cannot see what happens between them. A slope that
/// turns over inside an element leaves no strain at the stations, and Newton's method finds such
/// states.
///
/// @tparam Line   CubicLine or QuinticLine
/// @param e       finite; [r, r_x, r_y] of both nodes in the plane, with r_z in space; r_xx of a
///                quintic line is the last of a node
/// @param length  m, that the parameter of the slopes r_x runs through
template <int Dimension, class Line = CubicLine, int Dofs>
[[nodiscard]] bool upright(const Vector<double, Dofs>& e, double length) noexcept {
    static_assert(Dofs >= 2 * Dimension * (Dimension - 1 + Line::fields));
    using Point = Vector<double, Dimension>;
    constexpr double least = 1e-6;
    constexpr int node = Dofs / 2;
    const auto at = [&](int place) { return Point(e.template segment<Dimension>(place)); };
    const auto size = [](const Point& a) { return std::sqrt(product(a, a)); };
    for (int slope = 2; slope <= Dimension; ++slope) {
        const Point first = at(Dimension * slope), last = at(node + Dimension * slope);
        if (!(product(first, last) > -0.5 * size(first) * size(last))) return false;
    }
    Point before = Point::Zero();
    for (int k = 0; k <= line_parts; ++k) {
        const double xi = static_cast<double>(k) / line_parts;
        const auto weights = Line::first(xi, length);
        Point triad[Dimension];
        triad[0] = weights[0] * (at(node) - at(0)) + weights[1] * at(Dimension) +
                   weights[2] * at(node + Dimension);
        if constexpr (Line::fields > CubicLine::fields)
            triad[0] += weights[3] * at(node - Dimension) + weights[4] * at(2 * node - Dimension);
        for (int slope = 2; slope <= Dimension; ++slope)
            triad[slope - 1] =
                (1.0 - xi) * at(Dimension * slope) + xi * at(node + Dimension * slope);
        double lengths = 1.0;
        for (const Point& vector : triad) {
            const double norm = size(vector);
            if (!(norm > least)) return false;
            lengths *= norm;
        }
        if (!(orientation(triad) > least * lengths)) return false;
        if (k > 0 && !(product(triad[0], before) > 0.0)) return false;
        before = triad[0];
    }
    return true;
}

/// Returns the moments of a section's mass where an element has its mass on its line alone.
/// @tparam Dimension  in the plane a mass beside it along z does not count
/// @throws InvalidArgument for a centre of mass beside the line.
template <int Dimension>
[[nodiscard]] const Moments& mass_on_line(const Section& section) {
    const Moments& m = section.mass_moments();
    const double distance = (Dimension == 3 ? std::hypot(m.y, m.z) : std::abs(m.y)) / m.area;
    require(distance <= 1e-9 * std::sqrt(m.polar() / m.area),
            "the element has its mass on its line, got mass moments with their centre at a "
            "distance of ",
            distance, " m");
    return m;
}

}  // namespace ancf::detail

namespace ancf {

/// An element along a line from node to node; base of the classes of all families.
///
/// @tparam Element  the class of the family, which derives from this
/// @tparam Kernel   constant data of its stations, with energy, force and tangent
/// @tparam Choices  of an element, as values
/// @tparam Line     CubicLine or QuinticLine
/// @tparam Rates    whether nodes have r_xy besides r_y
template <class Element, class Kernel, class Choices, class Line = CubicLine, bool Rates = false>
class LineElement {
    static constexpr int dimension = Kernel::dimension, dofs = Kernel::dofs;
    /// Vectors of a node, r_xx and r_xy not counted.
    static constexpr int fields =
        dofs / (2 * dimension) - (Line::fields - CubicLine::fields) - (Rates ? 1 : 0);

public:
    /// Nodal coordinates e, those of the first node first.
    using Coordinates = Vector<double, dofs>;
    using Options = Choices;                  ///< choices that are values
    using Point = Vector<double, dimension>;  ///< a vector of space
    using Evaluator = Kernel;  ///< whose functions of doubles the compiled library holds

    /// Returns the strain energy U, J.
    /// @param e  nodal coordinates; m for positions, 1 for slopes, 1/m for r_xx and r_xy
    /// @note     noexcept, no heap allocation; so are all functions of e.
    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& e) const noexcept {
        return kernel_.energy(e);
    }

    /// Returns the elastic force Q = dU/de; N for positions, N m for slopes.
    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e) const noexcept {
        return kernel_.force(e);
    }

    /// Returns energy, elastic force and tangent K = dQ/de in one pass.
    ///
    /// K = sum_g w_g (B^T C B + sum_i sigma_i d2 s_i/de2) in the generalised strains s.
    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept {
        return kernel_.evaluate(e);
    }

    /// Returns the same with the tangent of mixed integration points: its geometric part has the
    /// stresses C (s + B change) of an earlier state.
    ///
    /// Energy and force are those of e. Source: Magisano, Leonetti, Garcea 2017;
    /// docs/theory-statics.md, "Stresses as unknowns".
    /// @param before  where the last tangent was taken, dofs x 1
    /// @param change  the correction that it gave, dofs x 1
    template <class S>
    [[nodiscard]] MixedEvaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                                    const Vector<S, dofs>& before,
                                                    const Vector<S, dofs>& change) const noexcept {
        return kernel_.evaluate(e, before, change);
    }

    /// Returns the constant mass matrix, dofs x dofs; kg, kg m and kg m^2 by block, to kg m^4 of
    /// r_xx and r_xy.
    [[nodiscard]] Matrix<double, dofs> mass() const {
        return mass_matrix<dimension>(mass_weights_);
    }

    /// Returns the nodal force of gravity.
    /// @param g  acceleration, m/s^2
    [[nodiscard]] Coordinates gravity(const Point& g) const {
        return gravity_force<dimension>(mass_weights_, g);
    }

    /// Returns the nodal force of a dead force per length of the stress-free line.
    /// @param force  N/m
    [[nodiscard]] Coordinates line_load(const Point& force) const {
        return line_.template line_load<fields, Rates>(force);
    }

    /// Returns the length of the stress-free element, m.
    [[nodiscard]] double length() const noexcept { return line_.length(); }
    /// Returns the length of the stress-free element from its first node to xi, m.
    [[nodiscard]] double length(double xi) const { return line_.length(xi); }
    /// Returns the range of the parameter x of r_x = dr/dx, m: length() of a straight element.
    [[nodiscard]] double parameter_length() const noexcept { return line_.parameter_length(); }
    /// Returns the options it was made with; the rule is the one that it takes.
    [[nodiscard]] const Options& options() const noexcept { return options_; }

    /// Returns the velocity of a point of the body, m/s.
    /// @param rate  time derivative of e
    /// @param xi    place along the element, 0 to 1
    /// @param y, z  place in the section, m; in the plane z has no effect
    [[nodiscard]] Point velocity(const Coordinates& e, const Coordinates& rate, double xi,
                                 double y = 0.0, double z = 0.0) const noexcept {
        return self().position_jacobian(e, xi, y, z) * rate;
    }

protected:
    /// Moves member by member; one function, for a vector of elements moves them in many places.
    ANCF_NOINLINE LineElement(LineElement&&) = default;
    LineElement(const LineElement&) = default;             ///< member by member
    LineElement& operator=(LineElement&&) = default;       ///< member by member
    LineElement& operator=(const LineElement&) = default;  ///< member by member
    ~LineElement() = default;                              ///< of the derived class alone

    /// A straight element.
    /// @throws InvalidArgument unless the length is positive.
    LineElement(double length, const Options& options)
        : line_((detail::require_positive("length", length), length)), options_(options) {}

    /// An element whose stress-free state is given.
    /// @throws InvalidArgument unless the length is positive and the coordinates finite.
    LineElement(const Coordinates& reference, double length, const Options& options)
        : line_((detail::require_positive("length", length), length), reference),
          reference_(reference),
          options_(options) {
        detail::require_finite("the reference coordinates of an element",
                               detail::components(reference));
    }

    /// @throws InvalidArgument unless the stress-free state is admissible.
    /// @param needs  what it must have then
    void require_admissible(const char* needs) const {
        detail::require(self().admissible(reference_),
                        "the reference coordinates of an element need ", needs,
                        " (where a curve turns far in an element, take more elements), got ",
                        detail::components(reference_));
    }

    /// Returns a function of the coordinates, less that of a stress-free state that is curved.
    template <class S, class Function>
    [[nodiscard]] auto beyond_reference(const Vector<S, dofs>& e,
                                        const Function& function) const noexcept {
        auto result = function(e);
        if (line_.curved()) result -= function(reference_).template cast<S>();
        return result;
    }

    ReferenceLine<dimension, Line> line_;            ///< of the stress-free state
    Coordinates reference_;                          ///< of that state; set where it is curved
    Options options_;                                ///< the rule among them
    Kernel kernel_;                                  ///< energy, force and tangent
    Matrix<double, dofs / dimension> mass_weights_;  ///< of pairs of nodal vectors

private:
    [[nodiscard]] const Element& self() const noexcept {
        return static_cast<const Element&>(*this);
    }
};

}  // namespace ancf
