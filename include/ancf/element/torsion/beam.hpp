// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A slender beam that stretches, bends and twists but does not shear: docs/theory-torsion.md.
///
/// Two nodes of r, r_x, r_y, 18 coordinates. The section stands normal to the centre line; its y
/// axis is r_y's projection, carried along the tangent as in docs/theory-directors.md. A slope
/// rather than a twist angle keeps the mass matrix constant and the coordinates free of poles.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/compiled_element.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/line_element.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/element/torsion/kernel.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// What may be chosen for a TorsionBeam.
struct TorsionBeamOptions {
    /// Stations of the axial, bending and torsion terms; the group of shear does not apply.
    Rule rule = Rule::mixed();

    /// What is most accurate for its cost: the default.
    [[nodiscard]] static TorsionBeamOptions best() { return {}; }
};

/// The Euler-Bernoulli beam with Saint-Venant's torsion.
///
///     U = int 1/2 EA eps^2 + 1/2 k^T EI k + 1/2 GJ om^2 ds,    eps = (r'.r' - 1)/2,
///
/// with k and om the section's turn per reference length, less that of the stress-free state. At
/// the nodes the section's own stiffness holds r_y at unit length and normal to r_x. Wagner's
/// coupling of twist and stretch is left out.
///
/// In the mass matrix r_y carries the polar moment of the section, which is exact for spin about
/// the axis. For the rotary inertia of bending, int y^2 dA + int z^2 dA stands for int y^2 dA about
/// the z axis and nothing for int z^2 dA about the y axis.
class TorsionBeam : public LineElement<TorsionBeam, detail::TorsionKernel, TorsionBeamOptions> {
public:
    static constexpr int dimension = 3;  ///< of space
    static constexpr int dofs = 18;      ///< number of nodal coordinates of an element
    /// The assembler may hand it several sets of coordinates at once.
    static constexpr bool evaluates_packs = true;
    /// Vectors that each node carries.
    static constexpr Fields fields = Field::r | Field::r_x | Field::r_y;

    /// Makes a straight element.
    /// @param section  centred on the axis, with a torsion constant
    /// @param length   l, m, > 0
    /// @throws InvalidArgument for bad values; for a section whose centroid or centre of mass is
    ///         off the axis; for a rule that leaves the element a mechanism (three axial, two
    ///         bending points are needed).
    ANCF_LAZY TorsionBeam(const Material& material, const Section& section, double length,
                          const Options& options = {});

    /// Makes an element whose stress-free state is given: its strains are subtracted, integrals run
    /// over its arc length.
    /// @param reference  nodal coordinates, 18 x 1
    /// @param length     range of the parameter x of r_x = dr/dx, m, > 0
    /// @throws InvalidArgument as above, and for a reference that is not admissible.
    ANCF_LAZY TorsionBeam(const Material& material, const Section& section,
                          const Coordinates& reference, double length, const Options& options = {});

    /// Tells whether the strains are defined at e: everything finite, slopes longer than 1e-6 and
    /// not parallel, no turn of 180 degrees between a node and a station; and that the section
    /// twists by less than 150 degrees from node to node. Beyond 180 it would seem twisted the
    /// other way. One driven joint does not pass that in a load step; two joints or a moment can.
    ANCF_LAZY [[nodiscard]] bool admissible(const Coordinates& e) const noexcept;

    // Results at a place: xi in [0, 1] along the element, y and z in the section, m.

    /// Returns (eps, b_y, b_z, om): e_xx = eps + y b_y + z b_z, 1 and 1/m; om the twist rate, 1/m.
    ANCF_LAZY [[nodiscard]] Vector<double, 4> strains(const Coordinates& e,
                                                      double xi) const noexcept;

    /// Returns axial force, torque and bending moments; the shear forces follow from equilibrium
    /// alone and are left zero.
    ANCF_LAZY [[nodiscard]] SectionForces section_forces(const Coordinates& e,
                                                         double xi) const noexcept;

    /// Returns the axial stress E (eps + y b_y + z b_z), Pa.
    ANCF_LAZY [[nodiscard]] Vector<double, 1> stress(const Coordinates& e, double xi,
                                                     double y = 0.0, double z = 0.0) const noexcept;

    /// Returns the directors n, c (columns), 1: with the tangent an orthonormal frame.
    template <class S>
    [[nodiscard]] Matrix<S, 3, 2> directors(const Vector<S, dofs>& e, double xi) const noexcept {
        detail::Invariants<S> w;
        const detail::CarriedFrame<S> f = frame(e, xi, w);
        Matrix<S, 3, 2> result;
        result << detail::to_vector(f.n), detail::to_vector(f.c);
        return result;
    }

    /// Returns the position r0 + y n + z c of a point of the body, m.
    template <class S>
    [[nodiscard]] Vector<S, 3> position(const Vector<S, dofs>& e, double xi, double y = 0.0,
                                        double z = 0.0) const noexcept {
        const Matrix<S, 3, 2> director = directors(e, xi);
        return line_.point(e, xi) + y * director.col(0) + z * director.col(1);
    }

    /// Returns the derivative of position() by e.
    ANCF_LAZY [[nodiscard]] Matrix<double, 3, dofs> position_jacobian(
        const Coordinates& e, double xi, double y = 0.0, double z = 0.0) const noexcept;

private:
    ANCF_LAZY void set_up(const Material& material, const Section& section);
    template <class S>
    [[nodiscard]] detail::CarriedFrame<S> frame(const Vector<S, dofs>& e, double xi,
                                                detail::Invariants<S>& w) const noexcept {
        detail::CarriedFrame<S> f;
        detail::torsion_frame(line_.shape(xi), detail::TorsionNodes<S>(e), f, w);
        return f;
    }

    double young_, axial_;       ///< E, Pa; EA, N
    Matrix<double, 2> bending_;  ///< E int (y, z)^T (y, z) dA, N m^2
    double torsion_;             ///< GJ, N m^2
};

#if defined(ANCF_COMPILED)
ANCF_COMPILED_ELEMENT(TorsionBeam);
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/element/torsion/beam.ipp>  // IWYU pragma: export
#endif
