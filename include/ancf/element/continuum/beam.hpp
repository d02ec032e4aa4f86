// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The beam element of solid mechanics: position r0 + y r_y + z r_z, Green strain at every point.
///
/// Source: Yakoub, Shabana, J. Mech. Des. 123 (2001) 606-621; here integrated over the section in
/// closed form (docs/theory-continuum.md). It locks in bending: compare CrossSectionBeam.

#pragma once

#include <ancf/element/compiled_element.hpp>
#include <ancf/element/continuum/evaluation.hpp>
#include <ancf/element/continuum/kernel.hpp>
#include <ancf/element/continuum/law.hpp>
#include <ancf/element/continuum/tangent.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/line_element.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/element/reference_line.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/error.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// What may be chosen for a ContinuumBeam.
struct ContinuumOptions {
    Rule rule = Rule::paper();                                 ///< stations along the element
    ContinuumMaterial material = ContinuumMaterial::diagonal;  ///< how stress follows from strain
};

/// The continuum beam: two nodes with position and all slopes; 24 coordinates, in the plane 12.
///
/// F = [r0' + y r_y' + z r_z', r_y, r_z], Green strain (F^T F - F0^T F0)/2, F0 of the undeformed
/// beam.
/// In the plane (r, r_x, r_y) the diagonal material means a rigid width: the spatial element held
/// at r_z = e_z. Hooke's law means plane stress there: e_zz follows from S_zz = 0.
/// The torsional stiffness is G int (k_y z^2 + k_z y^2) dA, of a section that does not warp; the
/// torsion constant is not used.
///
///     const ancf::ContinuumBeam<3> element(steel, section, length,
///                                          {ancf::Rule::paper(), ancf::ContinuumMaterial::hooke});
///     const auto [energy, force, tangent] = element.evaluate(e);
template <int Dimension = 3>
class ContinuumBeam : public LineElement<ContinuumBeam<Dimension>,
                                         detail::continuum::Kernel<Dimension>, ContinuumOptions> {
    using Base = typename ContinuumBeam::LineElement;
    using Base::line_, Base::reference_, Base::options_, Base::kernel_, Base::mass_weights_;
    static_assert(Dimension == 2 || Dimension == 3, "a beam lives in the plane or in space");

public:
    static constexpr int dimension = Dimension;                 ///< of space
    static constexpr int slopes = Dimension - 1;                ///< slopes across
    static constexpr int node_dofs = Dimension * (2 + slopes);  ///< number of coordinates of a node
    static constexpr int dofs = 2 * node_dofs;  ///< number of nodal coordinates of an element
    /// The assembler may hand it several sets of coordinates at once.
    static constexpr bool evaluates_packs = true;
    static constexpr int strains = Dimension == 3 ? 6 : 3;  ///< components of strain and stress
    /// Vectors that each node carries.
    static constexpr Fields fields = Dimension == 3
                                         ? Field::r | Field::r_x | Field::r_y | Field::r_z
                                         : Field::r | Field::r_x | Field::r_y;
    using typename Base::Coordinates;
    using typename Base::Options;
    using typename Base::Point;
    using Jacobian = Matrix<double, Dimension, dofs>;  ///< derivative of a vector of space by e

    /// Makes the element of a straight, prismatic beam.
    /// @param length  l, m, > 0
    /// @throws InvalidArgument for bad values, a section without fourth moments or shear correction
    ///         factors, a rule of fewer than 3 points for axial strain and shear or 2 for the rest
    ///         (modes without energy) or, with Hooke's law, Poisson's ratio outside (-1, 1/2).
    ContinuumBeam(const Material& material, const Section& section, double length,
                  const Options& options = {});

    /// Makes the element of a beam whose stress-free state is given: curved, twisted, or both.
    ///
    /// The strains of that state are subtracted; integrals run over the arc length of its axis.
    /// @param reference  nodal coordinates, 24 x 1, in the plane 12 x 1
    /// @param length     range of the parameter x of r_x = dr/dx, m, > 0; with unit slopes r_x the
    ///                   arc length
    /// @throws InvalidArgument as above, and for a reference that is not admissible.
    ContinuumBeam(const Material& material, const Section& section, const Coordinates& reference,
                  double length, const Options& options = {});

    /// Returns evaluate() of the rates of e + t v, for KelvinVoigt: the rate of the tangent is the
    /// derivative of B^T C B v by e. A template: compiled where it is used.
    /// @param e,v  nodal coordinates and their rates
    template <int...>
    [[nodiscard]] Evaluation<detail::Rate<double>, dofs> viscous(
        const Coordinates& e, const Coordinates& v) const noexcept {
        using Both = Pack<2>;
        const auto place = detail::moving<Both>(e, Coordinates(Coordinates::Zero()));
        return detail::damped(*this, e, v, detail::columns<Dimension, dofs>([&](const auto& unit) {
            // B is linear in e, so that dB/dt is B(v)
            return detail::rates(1.0, kernel_.force(place, detail::moving<Both>(v, unit)));
        }));
    }

    /// Returns what a rate of twist meets through r_y and through r_z where no shear force acts,
    /// N m^2: a torque divides between the slopes in this proportion.
    ///
    /// G (k_z int y^2 dA, k_y int z^2 dA) about the centroid; in the plane zero.
    [[nodiscard]] Vector<double, 2> torsion_stiffness() const noexcept;

    /// Tells whether e is a beam: finite and, all along, neither flattened nor turned inside out:
    /// det [r0', r_y, r_z] > 1e-6 of the product of the three lengths, the slopes turning by less
    /// than 120 degrees from node to node. The energy is smooth at any finite e, admissible or not.
    [[nodiscard]] bool admissible(const Coordinates& e) const noexcept {
        return detail::all_finite(e) && detail::upright<Dimension>(e, line_.parameter_length());
    }

    /// Returns the position r0 + y r_y + z r_z of a point of the body, m.
    /// @param xi    place along the element, 0 to 1
    /// @param y, z  place in the section, m; in the plane z has no effect
    [[nodiscard]] Point position(const Coordinates& e, double xi, double y = 0.0,
                                 double z = 0.0) const noexcept {
        return position_jacobian(e, xi, y, z) * e;
    }

    /// Returns the derivative of position() by e: the constant matrix of shape functions.
    [[nodiscard]] Jacobian position_jacobian(const Coordinates& e, double xi, double y = 0.0,
                                             double z = 0.0) const noexcept;

    /// Returns the directors r_y, r_z (columns), 1.
    [[nodiscard]] Matrix<double, Dimension, slopes> directors(const Coordinates& e,
                                                              double xi) const noexcept {
        return vectors_at(e, xi).columns.template rightCols<slopes>();
    }

    /// Returns the Green strain [e_xx, e_yy, e_zz, 2e_yz, 2e_xz, 2e_xy] at a point of the body; in
    /// the plane [e_xx, e_yy, 2e_xy].
    [[nodiscard]] Vector<double, strains> green_strain(const Coordinates& e, double xi,
                                                       double y = 0.0,
                                                       double z = 0.0) const noexcept;

    /// Returns the second Piola-Kirchhoff stress, Pa, in the order of green_strain(), as the energy
    /// has it: shear stresses with their correction factor, and in the enhanced form the diagonal
    /// law's stress plus what Hooke's law adds to it on the line of centroids.
    [[nodiscard]] Vector<double, strains> stress(const Coordinates& e, double xi, double y = 0.0,
                                                 double z = 0.0) const noexcept;

    /// Returns what the section transmits: resultants of the traction F S e_x (first
    /// Piola-Kirchhoff).
    [[nodiscard]] SectionForces section_forces(const Coordinates& e, double xi) const noexcept;

private:
    using Law = detail::ContinuumLaw<Dimension>;
    using Station = detail::continuum::Station<Dimension>;
    using Vectors = detail::continuum::Vectors<double, Dimension>;
    using Strain = detail::continuum::Strain<double, Dimension>;

    void set_up(const Material& material, const Section& section);
    /// Returns the weights of (r_j - r_i, r_x at i, r_x at j) in r0', by the arc length.
    [[nodiscard]] Vector<double, 3> tangent_weights(double xi) const noexcept {
        const StationShape<double> shape = line_.shape(xi);
        return {shape.p[0], shape.p[1], shape.p[2]};
    }
    /// Returns ds/dxi, m: the unit in which the stations measure y and z.
    [[nodiscard]] double unit(double xi) const noexcept {
        return line_.parameter_length() * line_.metric(xi);
    }
    [[nodiscard]] Station station(const RuleStation& place, double axial_stiffness) const;
    [[nodiscard]] Vectors vectors_at(const Coordinates& e, double xi) const noexcept {
        Vectors v = detail::continuum::Nodes<double, Dimension>(e).at(xi, tangent_weights(xi));
        v.columns.template middleCols<slopes>(1) /= unit(xi);
        return v;
    }
    [[nodiscard]] Strain strain_at(const Coordinates& e, double xi) const noexcept;

    Law law_;                         ///< of the section, per length
    detail::PointStiffness point_;    ///< on the strain of a point
    detail::PointStiffness axis_;     ///< on the strain of the centroid, added to it
    double centroid_y_, centroid_z_;  ///< m
};

template <int Dimension>
ContinuumBeam<Dimension>::ContinuumBeam(const Material& material, const Section& section,
                                        double length, const Options& options)
    : Base(length, options) {
    set_up(material, section);
}

template <int Dimension>
ContinuumBeam<Dimension>::ContinuumBeam(const Material& material, const Section& section,
                                        const Coordinates& reference, double length,
                                        const Options& options)
    : Base(reference, length, options) {
    set_up(material, section);
    this->require_admissible(
        "slopes of some length, right-handed and turning by less than 120 degrees from node to "
        "node");
}

template <int Dimension>
void ContinuumBeam<Dimension>::set_up(const Material& material, const Section& section) {
    law_ = detail::continuum_law<Dimension>(material, section, options_.material);
    point_ = options_.material == ContinuumMaterial::hooke
                 ? detail::hooke_stiffness<Dimension>(material, section)
                 : detail::diagonal_stiffness(material, section);
    axis_ = {0.0, 0.0, {0.0, 0.0}, 0.0};
    if (options_.material == ContinuumMaterial::enhanced) {
        const detail::PointStiffness hooke = detail::hooke_stiffness<Dimension>(material, section);
        axis_ = {hooke.normal - point_.normal,
                 hooke.coupling,
                 {0.0, 0.0},
                 hooke.transverse_shear - point_.transverse_shear};
    }
    centroid_y_ = section.moments().y / section.moments().area;
    centroid_z_ = section.moments().z / section.moments().area;
    mass_weights_ = line_.template mass<2 + slopes>(material.density, section.mass_moments());
    detail::require_points(options_.rule, StrainGroup::axial, "axial", 3);
    detail::require_points(options_.rule, StrainGroup::shear, "shear", 3);
    detail::require_points(options_.rule, StrainGroup::bending, "bending", 2);
    detail::require_points(options_.rule, StrainGroup::torsion, "torsion", 2);
    const double axial_stiffness = material.young * section.moments().area;
    for (const RuleStation& place : options_.rule.stations()) {
        const double weight = place.weight(StrainGroup::axial) * unit(place.xi);
        if (place.axial_only())
            kernel_.axial.push_back({tangent_weights(place.xi), weight * axial_stiffness, 0.5});
        else
            kernel_.stations.push_back(station(place, axial_stiffness));
    }
}

template <int Dimension>
typename ContinuumBeam<Dimension>::Station ContinuumBeam<Dimension>::station(
    const RuleStation& place, double axial_stiffness) const {
    Station result;
    result.xi = place.xi;
    result.tangent = tangent_weights(place.xi);
    // E A eps^2/2 is the group `axial`; what Hooke's law adds to it goes with the transverse
    // strains.
    const double length = unit(place.xi);
    Law law = law_.scaled(place.weight(StrainGroup::bending) * length, length);
    law.axial(0, 0) += (place.weight(StrainGroup::axial) - place.weight(StrainGroup::bending)) *
                       length * axial_stiffness;
    law.shear = law_.scaled(place.weight(StrainGroup::torsion) * length, length).shear;
    law.shear.row(0) = place.weight(StrainGroup::shear) * length * law_.shear.row(0);
    result.law = law;
    Vectors reference;
    if (line_.curved()) {
        reference =
            detail::continuum::Nodes<double, Dimension>(reference_).at(place.xi, result.tangent);
    } else {
        reference.columns.setZero();
        reference.columns(0, 0) = 1.0;
        for (int c = 0; c < slopes; ++c) reference.columns(1 + c, Dimension + c) = 1.0;
    }
    result.reference = detail::continuum::strain_coefficients(reference);
    return result;
}

template <int Dimension>
Vector<double, 2> ContinuumBeam<Dimension>::torsion_stiffness() const noexcept {
    Vector<double, 2> stiffness(0.0, 0.0);
    if constexpr (Dimension == 3)
        for (int k = 0; k < 2; ++k) {  // of r_y by 2 e_xz, of r_z by 2 e_xy
            const auto of = law_.shear.col(1 - k);
            const double coupled = of[Law::pair(0, 1 + k)];
            stiffness[k] = of[Law::pair(1 + k, 1 + k)] - coupled * coupled / of[0];
        }
    return stiffness;
}

#if defined(ANCF_COMPILED)
ANCF_COMPILED_TEMPLATE(ContinuumBeam<2>);
ANCF_COMPILED_TEMPLATE(ContinuumBeam<3>);
#endif

}  // namespace ancf

#include <ancf/element/continuum/results.hpp>  // IWYU pragma: export
