// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cross-section beam in the plane: the two-dimensional element that [Dufva2006] extends (its
/// Ref. 10).
///
/// Nodal coordinates are r, r_x, r_y of both nodes, 12 in all. It is the spatial element with every
/// z slope held at the plane's normal: no e_zz, no 2e_yz, no torsion; the section stays as wide as
/// it is. With a quintic centre line nodes have r_xx besides, and r_xy where shear is cubic:
/// docs/theory-quintic.md, "In the plane".

#pragma once

#include <ancf/element/compiled_element.hpp>
#include <ancf/element/cross_section_options.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/hermite.hpp>
#include <ancf/element/line_element.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/element/planar/kernel.hpp>
#include <ancf/element/planar/nodal.hpp>
#include <ancf/element/planar/section.hpp>
#include <ancf/element/planar/station.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/element/reference_line.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/error.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/section/stiffness.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <type_traits>

namespace ancf {

/// Shear, and the slopes across, cubic along the element: a node has the rate r_xy of its slope
/// beside it. Goes with a quintic centre line in the plane.
struct CubicShear {};

/// The cross-section beam in the plane. Directors of every kind coincide there.
///
/// Section moments about y alone count: area, y, yy, yyy, yyyy.
/// @tparam Shear  LinearShear, or CubicShear that goes with QuinticLine: PlanarQuinticBeam
/// @tparam Line   CubicLine or QuinticLine
template <class Directors, class Shear, class Measure, class Line>
class CrossSectionBeam<2, Directors, Shear, Measure, Line>
    : public LineElement<
          CrossSectionBeam<2, Directors, Shear, Measure, Line>,
          detail::PlanarKernel<
              detail::PlanarMeasure<Measure>,
              detail::PlanarLayout<Line::vectors, std::is_same_v<Shear, CubicShear>>>,
          detail::CrossSectionOptionsOf<Shear, Line>, Line, std::is_same_v<Shear, CubicShear>> {
    using Base = typename CrossSectionBeam::LineElement;
    using Base::line_, Base::reference_, Base::options_, Base::kernel_, Base::mass_weights_;
    static_assert(std::is_same_v<Shear, LinearShear> || std::is_same_v<Shear, CubicShear>,
                  "in the plane shear is LinearShear or CubicShear");
    static constexpr bool quintic = std::is_same_v<Line, QuinticLine>;
    static constexpr bool cubic_shear = std::is_same_v<Shear, CubicShear>;
    using Layout = detail::PlanarLayout<Line::vectors, cubic_shear>;

public:
    static constexpr int dimension = 2;  ///< of space
    /// Number of nodal coordinates of an element: 12, with a quintic centre line 16, with cubic
    /// shear 20.
    static constexpr int dofs = Layout::dofs;
    /// The assembler may hand it several sets of coordinates at once.
    static constexpr bool evaluates_packs = true;
    /// Vectors that each node carries.
    static constexpr Fields fields = Field::r | Field::r_x | Field::r_y |
                                     (cubic_shear ? Fields(Field::r_xy) : Fields()) |
                                     (quintic ? Fields(Field::r_xx) : Fields());

    using typename Base::Coordinates;
    using typename Base::Options;

    /// Makes a straight element.
    /// @param length  l, m, > 0
    /// @throws InvalidArgument if a value is out of range, or the rule leaves the element a
    ///         mechanism.
    CrossSectionBeam(const Material& material, const Section& section, double length,
                     const Options& options = {});

    /// Makes an element whose stress-free state is given: its strains are subtracted, integrals run
    /// over its arc length.
    /// @param reference  nodal coordinates, dofs x 1
    /// @param length     range of the parameter x of r_x = dr/dx, m, > 0; with unit slopes r_x the
    ///                   arc length
    /// @throws InvalidArgument as above, and for a reference that is not admissible.
    CrossSectionBeam(const Material& material, const Section& section, const Coordinates& reference,
                     double length, const Options& options = {});

    /// Tells whether e is a beam whose strains are defined: finite, the tangent longer than 1e-6
    /// and the shear's sine less than 1 at every station, and all along r_y to its left by more
    /// than an angle of 1e-6, turning by less than 120 degrees from node to node.
    [[nodiscard]] bool admissible(const Coordinates& e) const noexcept;

    /// Tells whether the centre line is shorter than softening_stretch of its length, at an end or
    /// at one of six places between them: its stress falls as it shortens further, and equilibria
    /// are no longer unique. Never so with engineering strains.
    [[nodiscard]] bool softened(const Coordinates& e) const noexcept {
        return !PlanarMeasure::engineering && line_.least_stretch(e) < softening_stretch;
    }

    // Results at a place: xi in [0, 1] along the element, y in the section, m; z has no effect. ---

    /// Returns the generalised strains (eps, b_y, a_yy/2, g_y, h_yy) of e_xx = e1 + y e2 + y^2 e3
    /// and 2e_xy = e4 + y e5.
    [[nodiscard]] Vector<double, 5> strains(const Coordinates& e, double xi) const noexcept {
        return this->beyond_reference(e, [&](const Coordinates& state) {
            double strains[detail::planar_strain_count];
            PlanarMeasure::strains(frame(state, xi).w, strains);
            return Vector<double, 5>(Eigen::Map<const Vector<double, 5>>(strains));
        });
    }

    /// Returns the strains of a point [e_xx, e_yy, 2e_xy], 1.
    [[nodiscard]] Vector<double, 3> green_strain(const Coordinates& e, double xi, double y = 0.0,
                                                 double z = 0.0) const noexcept;

    /// Returns the second Piola-Kirchhoff stress of a point in the order of green_strain(), Pa.
    [[nodiscard]] Vector<double, 3> stress(const Coordinates& e, double xi, double y = 0.0,
                                           double z = 0.0) const noexcept {
        return moduli_.cwiseProduct(green_strain(e, xi, y, z));
    }

    /// Returns what the section transmits along the tangent and its normal: axial, shear_y and
    /// moment_z.
    [[nodiscard]] SectionForces section_forces(const Coordinates& e, double xi) const noexcept;

    /// Returns the director d_y, 1: the normal of the centre line plus the shear along the tangent.
    [[nodiscard]] Vector<double, 2> directors(const Coordinates& e, double xi) const noexcept {
        const detail::PlanarFrame<double> f = frame(e, xi);
        const double cosine = director_cosine(f);
        return {cosine * f.n[0] + f.w.s * f.t[0], cosine * f.n[1] + f.w.s * f.t[1]};
    }

    /// Returns the position r0 + y d_y of a point of the body, m.
    [[nodiscard]] Vector<double, 2> position(const Coordinates& e, double xi, double y = 0.0,
                                             double /*z*/ = 0.0) const noexcept {
        Vector<double, 2> r = line_.point(e, xi);
        if (y != 0.0) r += y * directors(e, xi);
        return r;
    }

    /// Returns the derivative of position() by e.
    [[nodiscard]] Matrix<double, 2, dofs> position_jacobian(const Coordinates& e, double xi,
                                                            double y = 0.0,
                                                            double z = 0.0) const noexcept;

private:
    using PlanarMeasure = detail::PlanarMeasure<Measure>;

    using Shape = detail::PlanarShape<Layout>;
    [[nodiscard]] Shape shape(double xi) const noexcept {
        return Shape::of(line_.shape(xi), line_.parameter_length());
    }
    [[nodiscard]] detail::PlanarFrame<double> frame(const Coordinates& e,
                                                    double xi) const noexcept {
        detail::PlanarFrame<double> f;
        detail::planar_frame(shape(xi), detail::PlanarNodes<double, Layout>(e), f);
        return f;
    }
    /// Returns the factor of the normal in the director: 1, or what makes it a unit vector.
    [[nodiscard]] static double director_cosine(const detail::PlanarFrame<double>& f) noexcept {
        return PlanarMeasure::engineering ? std::sqrt(1.0 - f.w.s * f.w.s) : 1.0;
    }
    void set_up(const Material& material, const Section& section);

    SectionStiffness section_;
    Vector<double, 3> moduli_;  // of green_strain(), Pa
};

namespace detail {

/// Returns the part of a section matrix that the plane sees.
[[nodiscard]] inline PlanarStiffness planar_stiffness(const SectionMatrix<double>& C) noexcept {
    constexpr int axial[3] = {0, 1, 3}, shear[2] = {0, 1};
    PlanarStiffness result;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) result.axial[i][j] = C.axial[axial[i]][axial[j]];
    }
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) result.shear[i][j] = C.shear_y[shear[i]][shear[j]];
    }
    return result;
}

}  // namespace detail

template <class Directors, class Shear, class Measure, class Line>
CrossSectionBeam<2, Directors, Shear, Measure, Line>::CrossSectionBeam(const Material& material,
                                                                       const Section& section,
                                                                       double length,
                                                                       const Options& options)
    : Base(length, options) {
    set_up(material, section);
}

template <class Directors, class Shear, class Measure, class Line>
CrossSectionBeam<2, Directors, Shear, Measure, Line>::CrossSectionBeam(const Material& material,
                                                                       const Section& section,
                                                                       const Coordinates& reference,
                                                                       double length,
                                                                       const Options& options)
    : Base(reference, length, options) {
    set_up(material, section);
    this->require_admissible(
        "slopes of some length, r_y to the left of r_x, turning by less than 120 degrees from node "
        "to node");
    kernel_.set_reference(reference);
}

template <class Directors, class Shear, class Measure, class Line>
void CrossSectionBeam<2, Directors, Shear, Measure, Line>::set_up(const Material& material,
                                                                  const Section& section) {
    detail::require_points(options_.rule, StrainGroup::axial, "axial", quintic ? 5 : 3);
    detail::require_points(options_.rule, StrainGroup::bending, "bending", quintic ? 4 : 2);
    detail::require_points(options_.rule, StrainGroup::shear, "shear", Layout::shears);
    detail::require(!cubic_shear || options_.rotary_inertia == RotaryInertia::consistent,
                    "an element of cubic shear takes RotaryInertia::consistent alone: at the nodes "
                    "the rates of its slopes would have no mass");
    // nothing twists in the plane: any value serves, so the section need not have one
    section_ =
        section_stiffness(material, section.with_torsion_constant(1.0), options_.section_model);
    moduli_ << material.young, material.young, section.shear_correction_y() * material.shear;
    const auto table = line_.stations(options_.rule, section_, !PlanarMeasure::engineering);
    for (const auto& station : table.full)
        kernel_.stations.push_back({Shape::of(station.shape, line_.parameter_length()),
                                    {},
                                    detail::planar_stiffness(station.stiffness)});
    kernel_.axial = table.axial;
    kernel_.transverse_stiffness = section_.transverse_yy * line_.length();
    kernel_.transverse_length = line_.parameter_length();
    for (double& reference : kernel_.transverse_reference) reference = 0.0;
    kernel_.transverse_measure = options_.transverse;
    mass_weights_ = line_.template mass<3, cubic_shear>(material.density, section.mass_moments());
    if (options_.rotary_inertia == RotaryInertia::lumped) lump_rotary_inertia<3>(mass_weights_);
}

template <class Directors, class Shear, class Measure, class Line>
bool CrossSectionBeam<2, Directors, Shear, Measure, Line>::admissible(
    const Coordinates& e) const noexcept {
    if (!detail::all_finite(e) || !detail::upright<2, Line>(e, line_.parameter_length()))
        return false;
    constexpr double smallest = 1e-6;
    const detail::PlanarNodes<double, Layout> nodes(e);
    for (const auto& station : kernel_.stations) {
        detail::PlanarFrame<double> f;
        detail::planar_frame(station.shape, nodes, f);
        if (!(f.w.lam > smallest && std::abs(f.w.s) < 1.0)) return false;
    }
    return true;
}

template <class Directors, class Shear, class Measure, class Line>
Vector<double, 3> CrossSectionBeam<2, Directors, Shear, Measure, Line>::green_strain(
    const Coordinates& e, double xi, double y, double /*z*/) const noexcept {
    const Vector<double, 5> s = strains(e, xi);
    const Shape at = shape(xi);
    const auto transverse = this->beyond_reference(e, [&](const Coordinates& state) {
        double nodal[Layout::shears];
        kernel_.transverse(state, nodal);
        Vector<double, 1> strain(0.0);
        for (int m = 0; m < Layout::shears; ++m) strain[0] += at.n[m] * nodal[m];
        return strain;
    });
    return {s[0] + y * s[1] + y * y * s[2], transverse[0], s[3] + y * s[4]};
}

template <class Directors, class Shear, class Measure, class Line>
SectionForces CrossSectionBeam<2, Directors, Shear, Measure, Line>::section_forces(
    const Coordinates& e, double xi) const noexcept {
    const detail::PlanarFrame<double> f = frame(e, xi);
    const Vector<double, 5> s = strains(e, xi);
    const SectionMatrix<double> C = station_stiffness(section_, {xi, {1.0, 1.0, 1.0, 1.0}}, 1.0);
    double stress[detail::planar_strain_count];
    detail::planar_stress(detail::planar_stiffness(C), s.data(), stress);
    // r0' = (lam, 0), d = (s, 1), d' = (s' - kap, s kap) in (t, n)
    const double rate_t = f.w.s1 - f.w.kap, rate_n = f.w.s * f.w.kap;
    if constexpr (PlanarMeasure::engineering) {
        // along the unit director (s, cosine) and the section's normal (cosine, -s)
        const double cosine = director_cosine(f);
        const double axial = stress[0] * cosine + stress[3] * f.w.s;
        return {axial, stress[3] * cosine - stress[0] * f.w.s, 0.0, 0.0, 0.0, -stress[1]};
    }
    const double axial = stress[0] * f.w.lam + stress[1] * rate_t + stress[3] * f.w.s;
    const double moment_t = stress[1] * f.w.lam + stress[2] * rate_t, moment_n = stress[2] * rate_n;
    return {axial, stress[1] * rate_n + stress[3], 0.0, 0.0, 0.0, f.w.s * moment_n - moment_t};
}

template <class Directors, class Shear, class Measure, class Line>
auto CrossSectionBeam<2, Directors, Shear, Measure, Line>::position_jacobian(
    const Coordinates& e, double xi, double y, double /*z*/) const noexcept
    -> Matrix<double, 2, dofs> {
    Matrix<double, 2, dofs> jacobian = Matrix<double, 2, dofs>::Zero();
    line_.add_point_jacobian(xi, jacobian);
    if (y == 0.0) return jacobian;
    const Shape at = shape(xi);
    const detail::PlanarNodes<double, Layout> nodes(e);
    detail::PlanarFrame<double> f;
    detail::planar_frame(at, nodes, f);
    double by_nodes[Layout::shears][Layout::size];
    nodes.gradients(by_nodes);
    // d n = -u_n t, d t = u_n n with u_n = n.dp/lam
    const double cosine = director_cosine(f);
    const double normal_part = PlanarMeasure::engineering ? f.w.s / cosine : 0.0;
    for (int i = 0; i < 2; ++i) {
        const double by_turn = y * f.inv_lam * (f.w.s * f.n[i] - cosine * f.t[i]);
        const double by_shear = y * (f.t[i] - normal_part * f.n[i]);
        for (int k = 0; k < 2; ++k) {
            const double by_p = by_turn * f.n[k];
            jacobian(i, k) -= at.p[0] * by_p;
            for (int x = 0; x < Layout::line; ++x)
                jacobian(i, Layout::start[x] + k) += at.p[x] * by_p;
            for (int x = Layout::g; x < Layout::vectors; ++x) {
                for (int m = 0; m < Layout::shears; ++m)
                    jacobian(i, Layout::start[x] + k) +=
                        at.n[m] * by_shear * by_nodes[m][2 * x + k];
            }
        }
    }
    return jacobian;
}

#if defined(ANCF_COMPILED)
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<2>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<2, Projected, CubicShear, GreenMeasure, QuinticLine>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<2, Projected, CubicShear, EngineeringMeasure, QuinticLine>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<2, Projected, LinearShear, EngineeringMeasure>);
#endif

}  // namespace ancf
