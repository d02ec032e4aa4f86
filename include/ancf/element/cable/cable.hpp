// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cable element: a line that stretches and bends, without shear and without torsion.
///
/// Source: Berzeri, Shabana, J. Sound Vib. 235 (2000) 539-565, with the exact curvature; the
/// tangent, the rules and the curved references are derived in docs/theory-cable.md.

#pragma once

#include <ancf/element/cable/axial.hpp>
#include <ancf/element/cable/kernel.hpp>
#include <ancf/element/cable/natural.hpp>
#include <ancf/element/cable/nodes.hpp>
#include <ancf/element/compiled_element.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/hermite.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/element/reference_line.hpp>
#include <ancf/error.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace ancf {

/// Returns the default rule of cables: three Lobatto points for the axial term, three Gauss points
/// for bending.
///
/// Of the rules tried the most accurate for its cost. Rule::mixed(), with two points for bending,
/// has up to four times its error in bending and the same in catenaries; more axial points lock:
/// docs/theory-cable.md, "Rules".
[[nodiscard]] inline Rule cable_rule() {
    const Quadrature rest = gauss_quadrature(3);
    return Rule::grouped("cable", lobatto_quadrature(3), rest, rest, rest);
}

/// What may be chosen for a Cable.
struct CableOptions {
    /// Stations of the axial and of the bending term; the other groups do not apply.
    Rule rule = cable_rule();

    /// Axial stiffness in compression relative to that in tension, in [0, 1]; 0: a rope only pulls.
    /// It holds to a strain of -0.01 and rises to 1 at -0.05, so that a slack line keeps its length
    /// and bends instead.
    double compression = 1.0;
};

/// The cable of two nodes with position and slope r_x; 12 coordinates in space, 8 in the plane.
///
///     U = int 1/2 EA eps^2 + 1/2 EI (kappa - kappa0)^2 ds,    kappa = |r' x r''|/|r'|^3
///
/// over the reference length; eps is Green's strain or, with EngineeringAxial, |r'| - 1. The line
/// is that of the centroids. There are no directors, so that in space the section must bend equally
/// in all directions; rotary inertia is neglected. In small compression the axial stiffness may be
/// lower: the force is continuous, its derivative jumps at zero strain.
///
///     const ancf::Cable<3> rope(steel, ancf::circle(0.01), length, {ancf::cable_rule(), 0.0});
///     const auto [energy, force, tangent] = rope.evaluate(e);
template <int Dimension = 3, class Measure = GreenAxial>
class Cable {
    static_assert(Dimension == 2 || Dimension == 3, "a cable lives in the plane or in space");

public:
    static constexpr int dimension = Dimension;      ///< of space
    static constexpr int node_dofs = 2 * Dimension;  ///< number of coordinates of a node
    static constexpr int dofs = 2 * node_dofs;       ///< number of nodal coordinates of an element
    /// 1 in the plane, 3 in space.
    static constexpr int curvature_components = Dimension == 3 ? 3 : 1;
    static constexpr Fields fields = Field::r | Field::r_x;  ///< vectors that each node carries
    /// Nodal coordinates e, those of the first node first.
    using Coordinates = Vector<double, dofs>;
    using Point = Vector<double, Dimension>;           ///< a vector of space
    using Jacobian = Matrix<double, Dimension, dofs>;  ///< derivative of a vector of space by e
    using Curvature = Vector<double, curvature_components>;  ///< curvature components
    using Options = CableOptions;                            ///< choices that are values

    /// Makes the element of a straight cable.
    /// @param section  in the plane bending meets int y^2 dA; in space it must equal int z^2 dA
    /// @param length   l, m, > 0
    /// @throws InvalidArgument for bad values; for a section that is not centred on the line or, in
    ///         space, not equally stiff in all directions; for a rule that leaves the element a
    ///         mechanism (three axial and two bending points are needed).
    Cable(const Material& material, const Section& section, double length,
          const CableOptions& options = {});

    /// Makes the element whose stress-free state is a given curve.
    ///
    /// Strains are subtracted and integrals taken over the arc length of this curve. In space the
    /// natural curvature spins freely about the tangent, as one in each element:
    /// docs/theory-cable.md, "Curved references".
    /// @param reference  nodal coordinates of the curve
    /// @param length     range of the parameter x of r_x = dr/dx, m, > 0; for unit slopes the arc
    ///                   length between the nodes
    /// @throws InvalidArgument as above, and for coordinates that are not admissible.
    Cable(const Material& material, const Section& section, const Coordinates& reference,
          double length, const CableOptions& options = {});

    /// Returns the strain energy U, J.
    /// @param e  nodal coordinates, [r r_x] per node; m and 1
    /// @note     noexcept, no heap allocation; so are all functions of e.
    template <class Scalar>
    [[nodiscard]] Scalar energy(const Vector<Scalar, dofs>& e) const noexcept;

    /// Returns the elastic force Q = dU/de; N for positions, N m for slopes.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, dofs> force(const Vector<Scalar, dofs>& e) const noexcept;

    /// Returns energy, force and tangent K = dQ/de in one pass.
    template <class Scalar>
    [[nodiscard]] Evaluation<Scalar, dofs> evaluate(const Vector<Scalar, dofs>& e) const noexcept;

    /// Returns energy, force, a tangent whose stresses are those of `before`, linearised along
    /// `change`, and the force of these stresses: docs/theory-statics.md, "Stresses as unknowns".
    /// @param before  where the last tangent was taken
    /// @param change  the correction that it gave
    template <class Scalar>
    [[nodiscard]] MixedEvaluation<Scalar, dofs> evaluate(
        const Vector<Scalar, dofs>& e, const Vector<Scalar, dofs>& before,
        const Vector<Scalar, dofs>& change) const noexcept;

    /// Returns the constant mass matrix int rho A s^T s ds, kg, kg m and kg m^2 by block; no rotary
    /// inertia.
    [[nodiscard]] Matrix<double, dofs> mass() const {
        return mass_matrix<Dimension, 4>(mass_weights_);
    }

    /// Returns the nodal force of gravity.
    /// @param g  acceleration, m/s^2
    [[nodiscard]] Vector<double, dofs> gravity(const Point& g) const {
        return gravity_force<Dimension, 4>(mass_weights_, g);
    }

    /// Returns the nodal force of a dead force per length of the reference.
    /// @param force  N/m
    [[nodiscard]] Vector<double, dofs> line_load(const Point& force) const {
        return line_.template line_load<2>(force);
    }

    /// Tells whether e is a line: finite, with a stretch over 1e-6 at the nodes and stations, and
    /// turning by less than 90 degrees by the control points of every seventh of the element.
    [[nodiscard]] bool admissible(const Coordinates& e) const noexcept;

    /// Returns the reference length, along the curve, m.
    [[nodiscard]] double length() const noexcept { return line_.length(); }
    /// Returns the range of the parameter x of r_x = dr/dx, m: length() of a straight element.
    [[nodiscard]] double parameter_length() const noexcept { return line_.parameter_length(); }
    /// Returns the options it was made with.
    [[nodiscard]] const Options& options() const noexcept { return options_; }

    /// Returns the position of a point of the body, m: r + y n + z c with (t, n, c) the section's
    /// frame.
    ///
    /// In the plane n is t turned counterclockwise. In space, where nothing holds the section's
    /// spin, the frame is (X, Y, Z) turned by the smallest rotation that brings X to t; where t
    /// comes within 26 degrees of -X it is (-X, -Y, Z), brought from -X.
    /// @param xi    place along the element, 0 to 1
    /// @param y, z  place in the section, m; in the plane z has no effect
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> position(const Vector<Scalar, dofs>& e, double xi,
                                                     double y = 0.0, double z = 0.0) const noexcept;

    /// Returns the derivative of position() by e.
    [[nodiscard]] Jacobian position_jacobian(const Coordinates& e, double xi, double y = 0.0,
                                             double z = 0.0) const noexcept;

    /// Returns the velocity of a point of the body, m/s: position_jacobian() times the rate.
    /// @param rate  time derivative of e
    [[nodiscard]] Point velocity(const Coordinates& e, const Coordinates& rate, double xi,
                                 double y = 0.0, double z = 0.0) const noexcept;

    /// Returns the unit tangent t.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> tangent(const Vector<Scalar, dofs>& e,
                                                    double xi) const noexcept;

    /// Returns the derivative of the unit tangent by e.
    [[nodiscard]] Jacobian tangent_jacobian(const Coordinates& e, double xi) const noexcept;

    /// Returns the axial strain in the element's measure.
    [[nodiscard]] double axial_strain(const Coordinates& e, double xi) const noexcept;

    /// Returns the curvature r' x r''/|r'|^3, 1/m; in the plane its only component, positive
    /// counterclockwise.
    [[nodiscard]] Curvature curvature(const Coordinates& e, double xi) const noexcept;

    /// Returns the bending moment EI (kappa - kappa0)/|r'| in global axes, N m, conjugate to the
    /// angle of the tangent; in the plane its only component. kappa0 is turned into the present
    /// state with the element.
    [[nodiscard]] Curvature moment(const Coordinates& e, double xi) const noexcept;

    /// Returns what the section transmits: N, M_y and M_z in the frame of position(). N holds the
    /// axial and the bending term. The line has no shear strain: its shear force follows from
    /// equilibrium alone and is left zero here.
    [[nodiscard]] SectionForces section_forces(const Coordinates& e, double xi) const noexcept;

    /// Returns the axial stress E (eps - y k_c + z k_n) at a point of the section, Pa, k the change
    /// of curvature.
    [[nodiscard]] Vector<double, 1> stress(const Coordinates& e, double xi, double y = 0.0,
                                           double z = 0.0) const noexcept;

private:
    using Station = detail::CableBendingStation;
    template <class Scalar>
    using Gradient = detail::LineGradient<Scalar, Dimension>;

    Cable(const Material& material, const Section& section, const ReferenceLine<Dimension>& line,
          const Coordinates& reference, const CableOptions& options);

    [[nodiscard]] static Coordinates straight(double length);
    [[nodiscard]] Station station(double xi) const noexcept;
    void set_stations();
    void set_natural();
    void add_pair(std::size_t first, std::size_t second);
    [[nodiscard]] Curvature natural_curvature(const Coordinates& e, double xi) const noexcept;
    [[nodiscard]] static Curvature curvature(const Point& p, const Point& v) noexcept;
    template <class Scalar>
    [[nodiscard]] static Matrix<Scalar, Dimension> section_frame(
        const Vector<Scalar, Dimension>& t) noexcept;
    template <class Scalar>
    [[nodiscard]] Gradient<Scalar> gradient(
        const detail::LineVector<Scalar, Dimension>& line) const noexcept;
    template <class Scalar>
    [[nodiscard]] Gradient<Scalar> gradient(
        const detail::LineVector<Scalar, Dimension>& line,
        detail::LineHessian<Scalar, Dimension>& hessian) const noexcept;

    ReferenceLine<Dimension> line_;
    Coordinates reference_;
    Options options_;
    double young_;                 ///< E, Pa
    double axial_stiffness_;       ///< EA, N
    double bending_stiffness_;     ///< EI, N m^2
    double natural_energy_ = 0.0;  ///< int EI kappa0^2/2 ds, J
    std::vector<detail::CableAxialStation> axial_;
    std::vector<Station> bending_;
    std::vector<detail::NaturalCurvature> natural_;
    Matrix<double, 4> mass_weights_;
};

}  // namespace ancf

#include <ancf/element/cable/evaluation.hpp>  // IWYU pragma: export
#include <ancf/element/cable/results.hpp>     // IWYU pragma: export

#if defined(ANCF_COMPILED)
namespace ancf {

extern template class Cable<2>;
ANCF_COMPILED_ELEMENT(Cable<2>);
extern template class Cable<3>;
ANCF_COMPILED_ELEMENT(Cable<3>);
extern template class Cable<2, EngineeringAxial>;
ANCF_COMPILED_ELEMENT(Cable<2, EngineeringAxial>);
extern template class Cable<3, EngineeringAxial>;
ANCF_COMPILED_ELEMENT(Cable<3, EngineeringAxial>);

}  // namespace ancf
#endif
