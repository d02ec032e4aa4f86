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
#include <ancf/element/hermite.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/element/reference_line.hpp>
#include <ancf/element/torsion/kernel.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <memory>

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
class TorsionBeam {
public:
    static constexpr int dimension = 3;  ///< of space
    static constexpr int dofs = 18;      ///< number of nodal coordinates of an element
    /// The assembler may hand it several sets of coordinates at once.
    static constexpr bool evaluates_packs = true;
    /// Vectors that each node carries.
    static constexpr Fields fields = Field::r | Field::r_x | Field::r_y;
    /// Nodal coordinates e, those of the first node first.
    using Coordinates = Vector<double, dofs>;
    using Options = TorsionBeamOptions;  ///< choices that are values

    /// Makes a straight element.
    /// @param section  centred on the axis, with a torsion constant
    /// @param length   l, m, > 0
    /// @throws InvalidArgument for bad values; for a section whose centroid is off the axis; for a
    ///         rule that leaves the element a mechanism (three axial, two bending points are
    ///         needed).
    ANCF_LAZY TorsionBeam(const Material& material, const Section& section, double length,
                          const Options& options = {});

    /// Makes an element whose stress-free state is given: its strains are subtracted, integrals run
    /// over its arc length.
    /// @param reference  nodal coordinates, 18 x 1
    /// @param length     range of the parameter x of r_x = dr/dx, m, > 0
    /// @throws InvalidArgument as above, and for a reference that is not admissible.
    ANCF_LAZY TorsionBeam(const Material& material, const Section& section,
                          const Coordinates& reference, double length, const Options& options = {});

    /// Returns the strain energy U, J.
    template <class S>
    [[nodiscard]] S energy(const Vector<S, dofs>& e) const noexcept {
        return kernel_.energy(e);
    }

    /// Returns the elastic force Q = dU/de; N for positions, N m for slopes.
    template <class S>
    [[nodiscard]] Vector<S, dofs> force(const Vector<S, dofs>& e) const noexcept {
        return kernel_.force(e);
    }

    /// Returns energy, elastic force and tangent in one pass; noexcept, no heap allocation.
    /// @param e  nodal coordinates, 18 x 1, [r r_x r_y] per node; m and 1
    template <class S>
    [[nodiscard]] Evaluation<S, dofs> evaluate(const Vector<S, dofs>& e) const noexcept {
        return kernel_.evaluate(e);
    }

    /// Returns the same with a tangent of mixed integration points: its geometric part has the
    /// stresses C (s + B change) of an earlier state. docs/theory-statics.md, "Stresses as
    /// unknowns".
    /// @param before  where the last tangent was taken, 18 x 1
    /// @param change  the correction that it gave, 18 x 1
    template <class S>
    [[nodiscard]] MixedEvaluation<S, dofs> evaluate(const Vector<S, dofs>& e,
                                                    const Vector<S, dofs>& before,
                                                    const Vector<S, dofs>& change) const noexcept {
        return kernel_.evaluate(e, before, change);
    }

    /// Returns the constant mass matrix, 18 x 18; kg, kg m and kg m^2 by block.
    ///
    /// r_y carries the polar moment of the section, which is exact for spin about the axis. For the
    /// rotary inertia of bending, int y^2 dA + int z^2 dA stands for int y^2 dA about the z axis
    /// and nothing for int z^2 dA about the y axis.
    ANCF_LAZY [[nodiscard]] Matrix<double, dofs> mass() const;

    /// Returns the nodal force of gravity.
    /// @param g  acceleration, m/s^2
    ANCF_LAZY [[nodiscard]] Vector<double, dofs> gravity(const Vector<double, 3>& g) const;

    /// Returns the nodal force of a dead force per length of the stress-free centre line.
    /// @param force  N/m
    ANCF_LAZY [[nodiscard]] Vector<double, dofs> line_load(const Vector<double, 3>& force) const;

    /// Tells whether the strains are defined at e: everything finite, slopes longer than 1e-6 and
    /// not parallel, no turn of 180 degrees between a node and a station; and that the section
    /// twists by less than 150 degrees from node to node. Beyond 180 it would seem twisted the
    /// other way. One driven joint does not pass that in a load step; two joints or a moment can.
    ANCF_LAZY [[nodiscard]] bool admissible(const Coordinates& e) const noexcept;

    /// Returns the length of the stress-free element, m.
    [[nodiscard]] double length() const noexcept { return line_.length(); }
    /// Returns the range of the parameter x of r_x = dr/dx, m: length() of a straight element.
    [[nodiscard]] double parameter_length() const noexcept { return line_.parameter_length(); }
    /// Returns the options it was made with.
    [[nodiscard]] const Options& options() const noexcept { return options_; }

    // Results at a place: xi in [0, 1] along the element, y and z in the section, m. -------------

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
    [[nodiscard]] Matrix<S, 3, 2> directors(const Vector<S, dofs>& e, double xi) const noexcept;

    /// Returns the position r0 + y n + z c of a point of the body, m.
    template <class S>
    [[nodiscard]] Vector<S, 3> position(const Vector<S, dofs>& e, double xi, double y = 0.0,
                                        double z = 0.0) const noexcept;

    /// Returns the derivative of position() by e.
    ANCF_LAZY [[nodiscard]] Matrix<double, 3, dofs> position_jacobian(
        const Coordinates& e, double xi, double y = 0.0, double z = 0.0) const noexcept;

    /// Returns the velocity of a point of the body, m/s.
    /// @param rate  time derivative of e
    ANCF_LAZY [[nodiscard]] Vector<double, 3> velocity(const Coordinates& e,
                                                       const Coordinates& rate, double xi,
                                                       double y = 0.0,
                                                       double z = 0.0) const noexcept;

private:
    ANCF_LAZY void set_up(const Material& material, const Section& section);
    template <class S>
    [[nodiscard]] detail::CarriedFrame<S> frame(const Vector<S, dofs>& e, double xi,
                                                detail::Invariants<S>& w) const noexcept;
    ANCF_LAZY [[nodiscard]] Vector<double, 4> raw_strains(const Coordinates& e,
                                                          double xi) const noexcept;
    ANCF_LAZY [[nodiscard]] static Coordinates straight(double length);

    ReferenceLine<3> line_;
    Coordinates reference_;  ///< nodal coordinates of the stress-free state
    Options options_;
    double young_, axial_;       ///< E, Pa; EA, N
    Matrix<double, 2> bending_;  ///< E int (y, z)^T (y, z) dA, N m^2
    double torsion_;             ///< GJ, N m^2
    detail::TorsionKernel kernel_;
    Matrix<double, 6> mass_weights_;
};

template <class S>
detail::CarriedFrame<S> TorsionBeam::frame(const Vector<S, dofs>& e, double xi,
                                           detail::Invariants<S>& w) const noexcept {
    detail::TorsionNodes<S> nodes;
    detail::torsion_nodes(e, nodes);
    detail::CarriedFrame<S> f;
    detail::torsion_frame(line_.shape(xi), nodes, f, w);
    return f;
}

template <class S>
Matrix<S, 3, 2> TorsionBeam::directors(const Vector<S, dofs>& e, double xi) const noexcept {
    detail::Invariants<S> w;
    const detail::CarriedFrame<S> f = frame(e, xi, w);
    Matrix<S, 3, 2> result;
    for (int k = 0; k < 3; ++k) {
        result(k, 0) = f.n[k];
        result(k, 1) = f.c[k];
    }
    return result;
}

template <class S>
Vector<S, 3> TorsionBeam::position(const Vector<S, dofs>& e, double xi, double y,
                                   double z) const noexcept {
    const Matrix<S, 3, 2> director = directors(e, xi);
    const auto first = hermite(xi, line_.parameter_length());
    Vector<S, 3> result = y * director.col(0) + z * director.col(1);
    for (int node = 0; node < 2; ++node) {
        const auto at = static_cast<unsigned>(2 * node);
        result += first[at] * e.template segment<3>(9 * node) +
                  first[at + 1] * e.template segment<3>(9 * node + 3);
    }
    return result;
}

}  // namespace ancf

#if defined(ANCF_COMPILED)
namespace ancf {

ANCF_COMPILED_ELEMENT(TorsionBeam);

}  // namespace ancf
#endif

#if !defined(ANCF_COMPILED)
#include <ancf/element/torsion/beam.ipp>  // IWYU pragma: export
#endif
