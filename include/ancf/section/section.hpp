// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the cross-section is: its moments, shear correction factors and torsion constant.
///
/// y and z are the section's own axes, carried by the directors d_y and d_z. A section says nothing
/// of material and nothing of the element; section_stiffness() joins it with a Material.
/// Shear correction factors: Cowper, The shear coefficient in Timoshenko's beam theory, J. Appl.
/// Mech. 33 (1966) 335-340, at Poisson's ratio zero, so that one section serves every material.

#pragma once

#include <ancf/list.hpp>
#include <ancf/section/moments.hpp>

#include <utility>

namespace ancf {

/// How the section resists torsion (section_stiffness() has the formulas).
enum class SectionModel {
    paper,        ///< [Dufva2006, Eq. 29]: polar moment times shear correction
    saint_venant  ///< the torsion constant of a section that is free to warp
};

/// A point of the section's plane.
struct SectionPoint {
    double y;  ///< m
    double z;  ///< m
};

/// A cross-section, immutable: moments about the reference axis, shear correction factors, torsion
/// constant, shear centre.
///
///     const auto plain = ancf::rectangle(0.1, 0.5);  // width, height, m; k = 5/6, J by series
///     const auto paper = plain.with_shear_correction(0.85, 0.85);
class Section {
public:
    /// Returns the section of given moments; shear correction and torsion constant are unset, use
    /// with_...().
    ///
    /// With third and fourth moments all zero the section is known to second order only: the strain
    /// terms quadratic in y and z about the centroid then carry no stiffness (a beam given by E A,
    /// E I, G A and G J).
    /// @throws InvalidArgument unless the moments can belong to an area, see validate().
    [[nodiscard]] static Section from_moments(const Moments& moments);

    /// Returns the moments about the reference axis.
    [[nodiscard]] const Moments& moments() const noexcept { return moments_; }

    /// Returns the moments that the density multiplies: moments() unless with_mass_moments() gave
    /// others.
    [[nodiscard]] const Moments& mass_moments() const noexcept { return mass_moments_; }

    /// Returns k_y, which multiplies the stress of 2 e_xy, 1.
    /// @throws InvalidArgument if it is unset.
    [[nodiscard]] double shear_correction_y() const { return shear_correction()[0]; }

    /// Returns k_z, which multiplies the stress of 2 e_xz, 1.
    /// @throws InvalidArgument if it is unset.
    [[nodiscard]] double shear_correction_z() const { return shear_correction()[1]; }

    /// Returns the Saint-Venant torsion constant J, m^4.
    /// @throws InvalidArgument if it is unset.
    [[nodiscard]] double torsion_constant() const;

    /// Whether with_shear_centre() gave a point.
    [[nodiscard]] bool has_shear_centre() const noexcept { return has_shear_centre_; }

    /// Returns the shear centre from the reference axis, m: the centroid where none was given.
    [[nodiscard]] SectionPoint shear_centre() const noexcept {
        if (has_shear_centre_) return shear_centre_;
        return {moments_.y / moments_.area, moments_.z / moments_.area};
    }

    /// Returns the outer boundary, counter-clockwise (y towards z), as a polygon for pictures; a
    /// section given by moments has the parallelogram of the same radii of gyration.
    [[nodiscard]] const List<SectionPoint>& outline() const noexcept { return outline_; }

    /// Returns the same section with other shear correction factors, 1.
    /// @throws InvalidArgument unless both are positive and finite.
    [[nodiscard]] Section with_shear_correction(double k_y, double k_z) const;

    /// Returns the same section with another torsion constant, m^4.
    /// @throws InvalidArgument unless it is positive and finite.
    [[nodiscard]] Section with_torsion_constant(double torsion_constant) const;

    /// Returns the same section with the shear centre at a point, from the reference axis, m. A
    /// transverse force through it does not twist the section. Angles and channels have it beside
    /// the centroid. CrossSectionBeam<3> takes it with SectionModel::saint_venant and LinearShear,
    /// refuses it otherwise; TorsionBeam refuses it; other elements do not ask for it.
    /// @throws InvalidArgument unless it is finite.
    [[nodiscard]] Section with_shear_centre(SectionPoint point) const;

    /// Returns the same section with other moments of its mass: of a coated, filled or composite
    /// section, or of rotary inertia of its own. The density multiplies them; those up to second
    /// order are used. Cable and TorsionBeam refuse a centre of mass beside the axis.
    /// @throws InvalidArgument unless the moments can belong to an area, see validate().
    [[nodiscard]] Section with_mass_moments(const Moments& moments) const;

    /// Returns the same section with another outline, for pictures only.
    /// @throws InvalidArgument unless every point is finite.
    [[nodiscard]] Section with_outline(List<SectionPoint> outline) const;

private:
    friend Section polygon(const List<SectionPoint>& points, SectionPoint origin);
    friend Section rectangle(double width, double height);
    friend Section offset(const Section& section, double dy, double dz);

    Section(const Moments& moments, List<SectionPoint> outline)
        : moments_(moments), mass_moments_(moments), outline_(std::move(outline)) {}

    // Returns k_y and k_z.
    [[nodiscard]] const double* shear_correction() const;

    Moments moments_;
    Moments mass_moments_;
    double shear_correction_[2] = {};  // k_y, k_z; 0: unset
    double torsion_constant_ = 0.0;    // 0: unset
    bool has_shear_centre_ = false;
    SectionPoint shear_centre_ = {};
    List<SectionPoint> outline_;
};

/// Returns the torsion constant of a solid rectangle, m^4.
///
/// Saint-Venant: a torque T twists a free-to-warp bar by T/(G J) per length. The classical series
/// (Timoshenko and Goodier, Theory of Elasticity, article on torsion of rectangular bars), summed
/// to round-off.
///
/// With sides a >= b:  J = a b^3 (1/3 - 64 b/(pi^5 a) sum_{n odd} tanh(n pi a/(2 b))/n^5). The sum
/// of 1/n^5 is taken exactly (31 zeta(5)/32), what remains falls as exp(-n pi a/b): relative error
/// below 1e-15 at any aspect ratio.
/// @param width, height  sides, m, > 0; the order does not matter.
/// @throws InvalidArgument naming a side that is not positive or not finite.
[[nodiscard]] double rectangle_torsion_constant(double width, double height);

/// Returns a solid rectangle, centred: k = 5/6, J by rectangle_torsion_constant().
/// @param width   extent along z, m, > 0
/// @param height  extent along y, m, > 0: a load along y meets int y^2 dA = width height^3/12.
/// @throws InvalidArgument naming the value that is not positive or not finite.
[[nodiscard]] Section rectangle(double width, double height);

/// Returns a solid circle, centred: k = 6/7 (Cowper 1966, nu = 0), J = pi r^4/2.
/// @param radius  m, > 0
/// @throws InvalidArgument unless the radius is positive and finite.
[[nodiscard]] Section circle(double radius);

/// Returns a circular tube, centred: k = 6 (1 + m^2)^2/(7 (1 + m^2)^2 + 20 m^2) with m =
/// inner/outer radius (Cowper 1966, nu = 0; 1/2 for a thin wall), J = pi (R^4 - r^4)/2.
/// @param outer_radius  R, m, > 0
/// @param inner_radius  r, m, 0 < r < R
/// @throws InvalidArgument naming the value that is out of range or not finite.
[[nodiscard]] Section tube(double outer_radius, double inner_radius);

/// Returns the section moved by (dy, dz), m, in its plane: what was at the reference axis lies at
/// (dy, dz) from it, a shear centre too. Odd moments appear; the torsion constant and the shear
/// correction factors belong to the shape and stay.
/// @throws InvalidArgument unless both are finite.
[[nodiscard]] Section offset(const Section& section, double dy, double dz);

namespace detail {

[[nodiscard]] List<SectionPoint> rectangle_outline(double width, double height);

/// Returns the moments of a centred rectangle, sides in m.
[[nodiscard]] Moments rectangle_moments(double width, double height) noexcept;

/// Returns the moments of a centred doubly symmetric area with a hole of the same centre.
[[nodiscard]] Moments hollowed(Moments outer, const Moments& hole) noexcept;

}  // namespace detail
}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/section/section.ipp>  // IWYU pragma: export
#endif
