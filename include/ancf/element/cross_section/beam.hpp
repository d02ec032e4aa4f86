// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The beam element in a cross-sectional coordinate system: [Dufva2006, section 3].
///
/// Two nodes of position and three slopes; directors that stay perpendicular to the tangent but for
/// a shear that is interpolated linearly; strains of a rigid section plus linear transverse
/// strains. The section is integrated in closed form, see docs/theory.md.

#pragma once

#include <ancf/element/compiled_element.hpp>
#include <ancf/element/cross_section/carried_formulation.hpp>
#include <ancf/element/cross_section/engineering_measure.hpp>
#include <ancf/element/cross_section/green_measure.hpp>
#include <ancf/element/cross_section/kernel.hpp>
#include <ancf/element/cross_section/projected.hpp>
#include <ancf/element/cross_section/shear.hpp>
#include <ancf/element/cross_section_options.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/line_element.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/element/reference_line.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/section/section.hpp>
#include <ancf/section/stiffness.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace ancf {

namespace detail {

template <class Directors, class Shear, class Measure, class Line>
struct FormulationOf {
    using type = LocalFormulation<Shear, Measure>;
};
template <class Measure, class Line>
struct FormulationOf<Geodesic, LinearShear, Measure, Line> {
    using type = CarriedFormulation<Measure, LinearAngle, Line::vectors>;
};
template <class Measure, class Line>
struct FormulationOf<Transported, LinearShear, Measure, Line> {
    using type = CarriedFormulation<Measure, ChordAngle, Line::vectors>;
};

template <class T, class Directors, class Shear, class Measure, class Line>
using CrossSectionKernelOf =
    CrossSectionKernel<T, typename FormulationOf<Directors, Shear, Measure, Line>::type>;

/// Whether directors are carried from the nodes.
template <class Directors>
inline constexpr bool carries_directors =
    std::is_same_v<Directors, Geodesic> || std::is_same_v<Directors, Transported>;

}  // namespace detail

/// The beam element of Dufva, Sopanen and Mikkola.
///
/// @tparam Dimension  3; in two dimensions it is the specialisation of planar/beam.hpp
/// @tparam Directors  how the directors follow from the slopes: Projected (the paper),
///                    Transported or Geodesic; the last two with LinearShear alone
/// @tparam Shear      LinearShear (the paper's element) or PointwiseShear (Table 1, footnote a)
/// @tparam Measure    strains of the section as functions of its invariants: GreenMeasure (the
///                    paper) or EngineeringMeasure (Reissner's beam)
/// @tparam Line       CubicLine (the paper) or QuinticLine, which goes with carried directors; its
///                    nodes have r_xx besides, as QuinticBeam
template <int Dimension, class Directors, class Shear, class Measure, class Line>
class CrossSectionBeam
    : public LineElement<CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>,
                         detail::CrossSectionKernelOf<double, Directors, Shear, Measure, Line>,
                         detail::CrossSectionOptionsOf<Shear, Line>, Line> {
    using Base = typename CrossSectionBeam::LineElement;
    using Base::line_, Base::reference_, Base::options_, Base::kernel_, Base::mass_weights_;
    static_assert(Dimension == 3, "for two dimensions include <ancf/element/planar/beam.hpp>");
    static_assert(detail::carries_directors<Directors> || std::is_same_v<Directors, Projected>,
                  "directors are Projected, Transported or Geodesic");
    static_assert(!detail::carries_directors<Directors> || Shear::nodal,
                  "Geodesic and Transported directors go with LinearShear");
    static constexpr bool quintic = std::is_same_v<Line, QuinticLine>;
    static_assert(!quintic || detail::carries_directors<Directors>,
                  "QuinticLine goes with Geodesic or Transported directors");

public:
    static constexpr int dimension = Dimension;  ///< of space
    /// Number of nodal coordinates of an element: 24, or 30 with a quintic centre line.
    static constexpr int dofs = detail::dofs_with<Line::vectors>;
    /// The assembler may hand it several sets of coordinates at once.
    static constexpr bool evaluates_packs = true;
    /// Vectors that each node carries.
    static constexpr Fields fields = Field::r | Field::r_x | Field::r_y | Field::r_z |
                                     (quintic ? Fields(Field::r_xx) : Fields());

    using typename Base::Coordinates;
    using typename Base::Options;

    /// Makes a straight element.
    /// @param length  l, m, > 0
    /// @throws InvalidArgument if a value is out of range, or the rule leaves the element a
    ///         mechanism.
    CrossSectionBeam(const Material& material, const Section& section, double length,
                     const Options& options = {});

    /// Makes an element whose stress-free state is given: curved, twisted, or both.
    ///
    /// The strains of that state are subtracted; integrals run over the arc length of its centre
    /// line.
    /// @param reference  nodal coordinates, 24 x 1 or 30 x 1
    /// @param length     range of the parameter x of r_x = dr/dx, m, > 0; with unit slopes r_x the
    ///           arc length
    /// @throws InvalidArgument as above, and for a reference that is not admissible.
    CrossSectionBeam(const Material& material, const Section& section, const Coordinates& reference,
                     double length, const Options& options = {});

    /// Returns evaluate() of the rates of e + t v, for KelvinVoigt: the rate of the tangent is the
    /// derivative of B^T C B v by e. A template: compiled where it is used.
    /// @param e,v  nodal coordinates and their rates
    template <int...>
    [[nodiscard]] Evaluation<detail::Rate<double>, dofs> viscous(
        const Coordinates& e, const Coordinates& v) const noexcept {
        return detail::damped(*this, e, v, kernel_.rate_coupling(e, v));
    }

    /// Several elements evaluated at once, one in each lane: `energy`, `force` and `evaluate` of
    /// Vector<Pack<Lanes>, dofs>.
    template <int Lanes>
    using Together = detail::CrossSectionKernelOf<Pack<Lanes>, Directors, Shear, Measure, Line>;

    /// Puts elements side by side; each keeps its own length, section and material. Equal elements
    /// need not be put together: evaluate() of any of them takes packs as well.
    /// @throws InvalidArgument if rules or transverse strain measures differ.
    template <int Lanes>
    [[nodiscard]] static Together<Lanes> together(
        const std::array<const CrossSectionBeam*, Lanes>& elements);

    /// Returns what a rate of twist meets through r_y and through r_z where no shear force acts,
    /// N m^2: a torque divides between the slopes in this proportion.
    ///
    /// G (k_z int y^2 dA, k_y int z^2 dA) about the centroid; with SectionModel::saint_venant the
    /// parts Iyy and Izz of G J. docs/theory-statics.md, "How a torque divides".
    [[nodiscard]] Vector<double, 2> torsion_stiffness() const noexcept {
        const auto without_shear = [](const Matrix<double, 3>& block, int twist) {
            return block(twist, twist) - block(0, twist) * block(0, twist) / block(0, 0);
        };
        return {without_shear(section_.shear_z, 1), without_shear(section_.shear_y, 2)};
    }

    /// Tells whether e is a beam whose strains are defined: finite; all along, tangent and slopes
    /// right-handed and turning by less than 120 degrees from node to node; at every station longer
    /// than 1e-6, the sine of the angle between them larger than 1e-6.
    [[nodiscard]] bool admissible(const Coordinates& e) const noexcept;

    /// Tells whether the centre line is shorter than softening_stretch of its length, at an end or
    /// at one of six places between them: its stress falls as it shortens further, and equilibria
    /// are no longer unique. Never so with engineering strains.
    [[nodiscard]] bool softened(const Coordinates& e) const noexcept {
        return !Measure::engineering && line_.least_stretch(e) < softening_stretch;
    }

    // Results at a place: xi in [0, 1] along the element, y and z in the section, m.

    /// Returns the twelve generalised strains (eps, b_y, b_z, a_yy/2, a_yz, a_zz/2, g_y, h_yy,
    /// h_zy, g_z, h_yz, h_zz).
    ///
    /// e_xx = eps + y b_y + z b_z + (y^2 a_yy + 2 y z a_yz + z^2 a_zz)/2, 2e_xy = g_y + y h_yy + z
    /// h_zy, 2e_xz = g_z + y h_yz + z h_zz; 1, 1/m or 1/m^2.
    template <class S>
    [[nodiscard]] Vector<S, 12> strains(const Vector<S, dofs>& e, double xi) const noexcept;

    /// Returns (e_yy, e_zz, 2e_yz), 1. [Dufva2006, Eqs. 24 to 28]
    template <class S>
    [[nodiscard]] Vector<S, 3> transverse_strains(const Vector<S, dofs>& e,
                                                  double xi) const noexcept;

    /// Returns the strains of a point [e_xx, e_yy, e_zz, 2e_yz, 2e_xz, 2e_xy], 1.
    [[nodiscard]] Vector<double, 6> green_strain(const Coordinates& e, double xi, double y = 0.0,
                                                 double z = 0.0) const noexcept;

    /// Returns the second Piola-Kirchhoff stress of a point in the order of green_strain(), Pa, by
    /// the diagonal material of [Dufva2006, Eq. 29]: shear stresses contain their correction
    /// factors. Those of torsion are k G times the rate of twist times the distance from the shear
    /// centre, whatever the torsion constant is: docs/limits.md.
    [[nodiscard]] Vector<double, 6> stress(const Coordinates& e, double xi, double y = 0.0,
                                           double z = 0.0) const noexcept {
        return moduli_.cwiseProduct(green_strain(e, xi, y, z));
    }

    /// Returns what the section transmits: resultants of the first Piola-Kirchhoff traction F S
    /// e_x.
    ///
    /// The force is sigma_1 r0' + sigma_2 d_y' + sigma_3 d_z' + sigma_7 d_y + sigma_10 d_z; the
    /// moment follows likewise, see docs/theory.md. sigma = C s comes from the element's section
    /// matrix, torsion constant included.
    [[nodiscard]] SectionForces section_forces(const Coordinates& e, double xi) const noexcept;

    /// Returns the directors d_y, d_z (columns), 1: the slopes' unit projections plus the shear
    /// along the tangent.
    template <class S>
    [[nodiscard]] Matrix<S, 3, 2> directors(const Vector<S, dofs>& e, double xi) const noexcept {
        const Place<S> at = place(e, xi);
        Matrix<S, 3, 2> directors;
        directors << detail::to_vector(at.director(0)), detail::to_vector(at.director(1));
        return directors;
    }

    /// Returns the position r0 + y d_y + z d_z of a point of the body, m.
    template <class S>
    [[nodiscard]] Vector<S, 3> position(const Vector<S, dofs>& e, double xi, double y = 0.0,
                                        double z = 0.0) const noexcept;

    /// Returns the derivative of position() by e.
    [[nodiscard]] Matrix<double, 3, dofs> position_jacobian(const Coordinates& e, double xi,
                                                            double y = 0.0,
                                                            double z = 0.0) const noexcept;

private:
    using Formulation = typename detail::FormulationOf<Directors, Shear, Measure, Line>::type;

    /// The state of the section at a place.
    template <class S>
    struct Place;
    template <class S>
    [[nodiscard]] Place<S> place(const Vector<S, dofs>& e, double xi) const noexcept {
        return place(e, xi, xi);
    }
    template <class S>
    [[nodiscard]] Place<S> place(const Vector<S, dofs>& e, double xi,
                                 double shear_weight) const noexcept;

    using Row = Eigen::Matrix<double, 1, dofs>;
    /// Returns the weight of the second node's shears in the strains at xi: xi, but for a shear
    /// centre beside the axis nearer to 1/2, where twist, constant along the element, would hold
    /// changes of shear. docs/theory-references.md, "The shear centre"
    [[nodiscard]] double shear_weight(double xi) const noexcept {
        if (!Shear::nodal || options_.section_model != SectionModel::saint_venant) return xi;
        const auto by_shear = [](const Matrix<double, 3>& block, int twist) {
            return block(0, twist) * block(0, twist) / block(0, 0);
        };
        const double twisted = by_shear(section_.shear_z, 1) + by_shear(section_.shear_y, 2);
        if (twisted == 0.0) return xi;
        const double torsion = torsion_stiffness().sum();
        return 0.5 + std::sqrt(torsion / (torsion + twisted)) * (xi - 0.5);
    }
    /// Returns the derivative by e of a director (0: y, 1: z), of its spin about the tangent, and
    /// of its shear.
    [[nodiscard]] Matrix<double, 3, dofs> director_jacobian(const Place<double>& at,
                                                            int director) const noexcept;
    [[nodiscard]] Row spin_row(const Place<double>& at, int director) const noexcept;
    [[nodiscard]] Row shear_row(const Place<double>& at, int director) const noexcept;

    void set_up(const Material& material, const Section& section);

    SectionStiffness section_;
    Vector<double, 6> moduli_;  ///< of green_strain(), Pa
};

template <int Dimension, class Directors, class Shear, class Measure, class Line>
CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::CrossSectionBeam(
    const Material& material, const Section& section, double length, const Options& options)
    : Base(length, options) {
    set_up(material, section);
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::CrossSectionBeam(
    const Material& material, const Section& section, const Coordinates& reference, double length,
    const Options& options)
    : Base(reference, length, options) {
    set_up(material, section);
    this->require_admissible(
        "slopes of some length, right-handed and turning by less than 120 degrees from node to "
        "node");
    kernel_.set_reference(reference);
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
void CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::set_up(const Material& material,
                                                                          const Section& section) {
    if constexpr (Measure::engineering && !quintic) {
        const Moments& m = section.moments();
        const double depth = 4.0 * std::sqrt(std::max(m.yy, m.zz) / m.area);
        if (options_.three_points_where_short && options_.rule.name() == "mixed" &&
            line_.length() < depth)
            options_.rule = Rule::gauss(3);
    }
    detail::require_points(options_.rule, StrainGroup::axial, "axial", quintic ? 5 : 3);
    detail::require_points(options_.rule, StrainGroup::bending, "bending", quintic ? 4 : 2);
    detail::require_points(options_.rule, StrainGroup::shear, "shear", Shear::nodal ? 2 : 3);
    detail::require_points(options_.rule, StrainGroup::torsion, "torsion", 1);
    detail::require(
        !section.has_shear_centre() || options_.section_model == SectionModel::saint_venant,
        "CrossSectionBeam: a section with a shear centre needs SectionModel::saint_venant");
    detail::require(
        !section.has_shear_centre() || Shear::nodal,
        "CrossSectionBeam: a section with a shear centre needs LinearShear: PointwiseShear holds "
        "the twist where a torque changes");
    section_ = section_stiffness(material, section, options_.section_model);
    const double shear_y = section.shear_correction_y() * material.shear;
    const double shear_z = section.shear_correction_z() * material.shear;
    moduli_ << material.young, material.young, material.young, 0.5 * (shear_y + shear_z), shear_z,
        shear_y;
    kernel_.stations = line_.stations(options_.rule, section_, !Measure::engineering);
    for (auto& station : kernel_.stations.full) station.shape.n2_s = shear_weight(station.shape.n2);
    kernel_.packs = packed<native_lanes>(kernel_.stations);
    const double length = line_.length();
    kernel_.transverse = {{section_.transverse_yy * length, section_.transverse_zz * length,
                           section_.transverse_yz * length},
                          {}};
    kernel_.transverse_measure = options_.transverse;
    mass_weights_ = line_.template mass<4>(material.density, section.mass_moments());
    if (options_.rotary_inertia == RotaryInertia::lumped) lump_rotary_inertia<4>(mass_weights_);
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
template <int Lanes>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::together(
    const std::array<const CrossSectionBeam*, Lanes>& elements) -> Together<Lanes> {
    const CrossSectionBeam& first = *elements[0];
    Together<Lanes> result;
    result.transverse_measure = first.options_.transverse;
    std::size_t full = 0, axial = 0;
    for (const CrossSectionBeam* element : elements) {
        full = std::max(full, element->kernel_.stations.full.size());
        axial = std::max(axial, element->kernel_.stations.axial.size());
    }
    result.stations.full.resize(full);
    result.stations.axial.resize(axial);
    for (int lane = 0; lane < Lanes; ++lane) {
        const CrossSectionBeam& element = *elements[lane];
        detail::require(element.options_.rule.name() == first.options_.rule.name(),
                        "elements put together must have one rule, got \"",
                        first.options_.rule.name(), "\" and \"", element.options_.rule.name(),
                        "\"");
        detail::require(element.options_.transverse == first.options_.transverse,
                        "elements put together must have one transverse strain measure");
        detail::put_lane(result.stations, lane, element.kernel_.stations);
        detail::put_lane(result.transverse, lane, element.kernel_.transverse);
    }
    return result;
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
bool CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::admissible(
    const Coordinates& e) const noexcept {
    using namespace detail;
    if (!detail::all_finite(e) || !upright<3, Line>(e, line_.parameter_length())) return false;
    NodalVectors<double, Line::vectors> nodes;
    nodal_vectors(e, nodes);
    constexpr double smallest = 1e-6;  // length, and sine of the angle between slope and tangent
    [[maybe_unused]] const auto distinct = [](const Vec3<double>& tangent,
                                              const Vec3<double>& slope) {
        const double tt = dot(tangent, tangent), ss = dot(slope, slope);
        const Vec3<double> normal = cross(tangent, slope);
        return tt > smallest * smallest && ss > smallest * smallest &&
               dot(normal, normal) > smallest * smallest * tt * ss;
    };
    for (const auto& station : kernel_.stations.full) {
        if constexpr (carries_directors<Directors>) {
            // carried from the nodes: undefined where the tangent turns back on a node's, or
            // directors meet from behind
            if (!carriable(nodes, line_derivative(station.shape.p, nodes), smallest)) return false;
        } else {
            LocalVectors<double> local;
            interpolate(station.shape, nodes, local);
            if (!distinct(local[l_p], local[l_a]) || !distinct(local[l_p], local[l_b]))
                return false;
        }
    }
    return true;
}

#if defined(ANCF_COMPILED)
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<3>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<3, Geodesic>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<3, Transported>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<3, Projected, PointwiseShear>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<3, Projected, LinearShear, EngineeringMeasure>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>);
ANCF_COMPILED_TEMPLATE(CrossSectionBeam<3, Geodesic, LinearShear, GreenMeasure, QuinticLine>);
#endif

}  // namespace ancf

#include <ancf/element/cross_section/results.hpp>  // IWYU pragma: export
