// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cable element: a line that stretches and bends, without shear and without torsion.
///
/// Source: Berzeri, Shabana, J. Sound Vib. 235 (2000) 539-565, with the exact curvature; the
/// tangent, the rules and the curved references are derived in docs/theory-cable.md.

#pragma once

#include <ancf/element/cable/axial.hpp>
#include <ancf/element/cable/evaluation.hpp>
#include <ancf/element/cable/kernel.hpp>
#include <ancf/element/cable/natural.hpp>
#include <ancf/element/compiled_element.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/line_element.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/element/reference_line.hpp>
#include <ancf/error.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cmath>
#include <cstddef>

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
class Cable : public LineElement<Cable<Dimension, Measure>, detail::CableKernel<Dimension, Measure>,
                                 CableOptions> {
    using Base = typename Cable::LineElement;
    using Base::line_, Base::reference_, Base::options_, Base::kernel_, Base::mass_weights_;
    static_assert(Dimension == 2 || Dimension == 3, "a cable lives in the plane or in space");
    static_assert(detail::offers<detail::AxialStrain, Measure>,
                  "a cable takes GreenAxial or EngineeringAxial; GreenMeasure and "
                  "EngineeringMeasure are of beams");

public:
    static constexpr int dimension = Dimension;      ///< of space
    static constexpr int node_dofs = 2 * Dimension;  ///< number of coordinates of a node
    static constexpr int dofs = 2 * node_dofs;       ///< number of nodal coordinates of an element
    /// 1 in the plane, 3 in space.
    static constexpr int curvature_components = Dimension == 3 ? 3 : 1;
    static constexpr Fields fields = Field::r | Field::r_x;  ///< vectors that each node carries
    using typename Base::Coordinates;
    using typename Base::Options;
    using typename Base::Point;
    using Jacobian = Matrix<double, Dimension, dofs>;  ///< derivative of a vector of space by e
    using Curvature = Vector<double, curvature_components>;  ///< curvature components

    /// Makes the element of a straight cable.
    /// @param section  in the plane bending meets int y^2 dA; in space it must equal int z^2 dA
    /// @param length   l, m, > 0
    /// @throws InvalidArgument for bad values; for a section that is not centred on the line, or
    ///         whose mass is not; in space, for one not equally stiff in all directions; for a rule
    ///         that leaves the element a mechanism (three axial and two bending points are needed).
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

    /// Tells whether e is a line: finite, with a stretch over 1e-6 at the nodes and stations, and
    /// turning by less than 90 degrees by the control points of every seventh of the element.
    [[nodiscard]] bool admissible(const Coordinates& e) const noexcept;

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

    /// Returns the unit tangent t.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> tangent(const Vector<Scalar, dofs>& e,
                                                    double xi) const noexcept {
        using std::sqrt;
        const Vector<Scalar, Dimension> p = along(station(xi).p, e);
        return p / sqrt(detail::product(p, p));
    }

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

    void set_up(const Material& material, const Section& section);
    [[nodiscard]] Station station(double xi) const noexcept;
    /// Returns the vector of the line with these weights.
    template <class Scalar>
    [[nodiscard]] static Vector<Scalar, Dimension> along(const detail::LineWeights<double>& weights,
                                                         const Vector<Scalar, dofs>& e) noexcept {
        return detail::interpolated<Dimension>(weights, detail::line_of<Dimension>(e));
    }
    /// Returns the derivative (I - t t^T)/|p| of t = p/|p|.
    [[nodiscard]] static Matrix<double, Dimension> tangent_by_slope(const Point& p) noexcept;
    void add_pair(std::size_t first, std::size_t second);
    [[nodiscard]] Curvature natural_curvature(const Coordinates& e, double xi) const noexcept;
    [[nodiscard]] static Curvature curvature(const Point& p, const Point& v) noexcept;
    template <class Scalar>
    [[nodiscard]] static auto section_frame(const Vector<Scalar, Dimension>& t) noexcept
        -> std::array<Vector<Scalar, Dimension>, Dimension>;

    double young_;              ///< E, Pa
    double axial_stiffness_;    ///< EA, N
    double bending_stiffness_;  ///< EI, N m^2
};

namespace detail {

/// Returns EI of a section that a line of centroids may have; in space it must be the same about
/// every axis.
/// @throws InvalidArgument else.
template <int Dimension>
[[nodiscard]] double line_bending_stiffness(const Material& material, const Section& section) {
    material.validate();
    const Moments& m = section.moments();
    const double radius = std::sqrt(m.polar() / m.area);
    const double offset = (Dimension == 3 ? std::hypot(m.y, m.z) : std::abs(m.y)) / m.area;
    require(offset <= 1e-9 * radius,
            "a cable runs through the centroid of its section, got one at a distance of ", offset,
            " m");
    if constexpr (Dimension == 2) return material.young * m.yy;
    const double most = 1e-6 * m.polar();
    require(std::abs(m.yy - m.zz) <= most && std::abs(m.yz) <= most,
            "a cable in space has no directors and needs a section that bends equally in all "
            "directions, got int y^2 dA ",
            m.yy, ", int z^2 dA ", m.zz, " and int y z dA ", m.yz, " m^4");
    return 0.5 * material.young * m.polar();
}

/// Returns the unit vector normal to two tangents; where they are parallel, that along `kappa`.
[[nodiscard]] inline Vector<double, 3> common_normal(const Vector<double, 3>& first,
                                                     const Vector<double, 3>& second,
                                                     const Vector<double, 3>& kappa) {
    constexpr double nearly_parallel = 1e-8;  // so that the product keeps half of its digits
    const Vector<double, 3> n = cross(first, second);
    if (n.norm() > nearly_parallel) return n.normalized();
    const Vector<double, 3> sum = first + second, t = sum.normalized();
    return (kappa - kappa.dot(t) * t).normalized();
}

}  // namespace detail

template <int Dimension, class Measure>
Cable<Dimension, Measure>::Cable(const Material& material, const Section& section, double length,
                                 const CableOptions& options)
    : Base(length, options) {
    set_up(material, section);
}

template <int Dimension, class Measure>
Cable<Dimension, Measure>::Cable(const Material& material, const Section& section,
                                 const Coordinates& reference, double length,
                                 const CableOptions& options)
    : Base(reference, length, options) {
    set_up(material, section);
    this->require_admissible("slopes r_x of about 1");
    const std::size_t count = kernel_.bending.size();
    if constexpr (Dimension == 3) {
        for (std::size_t k = 0; 2 * k < count; ++k) add_pair(k, count - 1 - k);
    } else {
        for (std::size_t k = 0; k < count; ++k) add_pair(k, k);
    }
}

template <int Dimension, class Measure>
void Cable<Dimension, Measure>::set_up(const Material& material, const Section& section) {
    young_ = material.young;
    axial_stiffness_ = material.young * section.moments().area;
    bending_stiffness_ = detail::line_bending_stiffness<Dimension>(material, section);
    mass_weights_ =
        line_.template mass<2>(material.density, detail::mass_on_line<Dimension>(section));
    detail::require(options_.compression >= 0.0 && options_.compression <= 1.0,
                    "compression must lie in [0, 1], got ", options_.compression);
    detail::require_points(options_.rule, StrainGroup::axial, "axial", 3);
    detail::require_points(options_.rule, StrainGroup::bending, "bending", 2);
    kernel_.softening = 1.0 - options_.compression;
    kernel_.straight = detail::straight_curvature / line_.length();
    for (const RuleStation& place : options_.rule.stations()) {
        const double axial = place.weight(StrainGroup::axial);
        const double bending = place.weight(StrainGroup::bending);
        Station here = station(place.xi);
        const double arc = here.stiffness;
        detail::require(std::isfinite(arc) && arc > 1e-6 * line_.parameter_length(),
                        "the reference coordinates of a cable must be a line of slope r_x about 1, "
                        "got |r_x| = ",
                        arc / line_.parameter_length(), " at xi = ", place.xi);
        if (axial != 0.0) kernel_.axial.push_back({here.p, axial_stiffness_ * axial * arc});
        here.stiffness = bending_stiffness_ * bending * arc;
        if (bending != 0.0) kernel_.bending.push_back(here);
    }
}

/// The weights of r' and r'' per arc length s of the reference; `stiffness` is ds/dxi.
template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Station Cable<Dimension, Measure>::station(
    double xi) const noexcept {
    const StationShape<double> shape = line_.shape(xi);
    return {{{shape.p[0], shape.p[1], shape.p[2]}},
            {{shape.p1[0], shape.p1[1], shape.p1[2]}},
            line_.metric(xi) * line_.parameter_length()};
}

/// Lets the natural curvatures of two stations (or of one, first = second) turn together.
template <int Dimension, class Measure>
void Cable<Dimension, Measure>::add_pair(std::size_t first, std::size_t second) {
    // kappa0 l below this is the round-off of a straight reference; in space, where the spin of a
    // curved line costs nothing, that of coordinates from a table
    constexpr double straight = Dimension == 2 ? 1e-13 : detail::straight_curvature;
    const auto line = detail::line_of<Dimension>(reference_);
    detail::NaturalCurvature natural{first == second ? 1 : 2, {first, second}, {}, {}, 0.0};
    Point tangent[2];
    Curvature kappa[2];
    for (int g = 0; g < 2; ++g) {
        const Station& at = kernel_.bending[natural.station[g]];
        tangent[g] = detail::interpolated<Dimension>(at.p, line);
        kappa[g] = curvature(tangent[g], detail::interpolated<Dimension>(at.v, line));
    }
    const Curvature larger = kappa[kappa[0].norm() >= kappa[1].norm() ? 0 : 1];
    if (!(larger.norm() * line_.parameter_length() > straight)) return;
    for (int g = 0; g < natural.count; ++g) {
        const double stiffness = kernel_.bending[natural.station[g]].stiffness;
        kernel_.natural_energy += 0.5 * stiffness * kappa[g].squaredNorm();
        if constexpr (Dimension == 2) {
            natural.along[g] = stiffness * kappa[g][0];
        } else {
            const Point n = detail::common_normal(tangent[0], tangent[1], larger);
            natural.along[g] = stiffness * kappa[g].dot(n);
            natural.across[g] = stiffness * kappa[g].dot(cross(n, tangent[g]));
            natural.floor += 1e-8 * stiffness * kappa[g].squaredNorm();
        }
    }
    kernel_.natural.push_back(natural);
}

#if defined(ANCF_COMPILED)
ANCF_COMPILED_TEMPLATE(Cable<2>);
ANCF_COMPILED_TEMPLATE(Cable<3>);
ANCF_COMPILED_TEMPLATE(Cable<2, EngineeringAxial>);
ANCF_COMPILED_TEMPLATE(Cable<3, EngineeringAxial>);
#endif

}  // namespace ancf

#include <ancf/element/cable/results.hpp>  // IWYU pragma: export
