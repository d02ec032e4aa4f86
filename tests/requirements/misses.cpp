// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Types that miss what ancf asks for; each comment `expected:` is what the compiler must say.
/// With ANCF_CONFORMING the same uses with types that miss nothing: that must compile.

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>

#include <support/bar.hpp>

using Bar = ancf::test::Bar<3>;

#ifdef ANCF_CONFORMING

using Element = Bar;
using Measure = ancf::GreenAxial;
constexpr bool conforming = true;

constexpr int of_pin = 3, of_force = 3, of_arc = 2;
using Options = ancf::CableOptions;

struct Added {
    static ancf::Coupling coupling() { return {}; }
    void evaluate(const ancf::LoadState&, ancf::LoadResult&) const {}
};

#else

struct Nothing {};
using Element = Nothing;
using Measure = Nothing;  // as GreenMeasure, which beams have
constexpr bool conforming = false;
using Added = Nothing;
constexpr int of_pin = 2, of_force = 2, of_arc = 3;
using Options = Nothing;

struct WrongSizes : Bar {
    static constexpr int dofs = 7;  // expected: dofs = 2 * dimension * fields.count()
};
static_assert(ancf::require_element<WrongSizes>());

struct NoInertia : Bar {
    void mass() const;  // expected: an element needs: ancf::Matrix<double, dofs> mass() const
};
static_assert(ancf::require_element<NoInertia>());

struct NoForce : Bar {
    void force() const;  // expected: an element needs: Coordinates force(const Coordinates&) const
};
static_assert(ancf::require_element<NoForce>());

// expected: add_line_load needs of an element without slopes
void load(ancf::Model& model, const ancf::Beam<Bar>& beam) {
    ancf::add_line_load(model, beam, {0.0, 0.0, 1.0});
}

#endif

// expected: an element needs: static constexpr int dimension, dofs
// expected: an element needs: ancf::Evaluation<double, dofs> evaluate
// expected: an element needs: bool admissible(const Coordinates&) const
static_assert(ancf::require_element<Element>());
static_assert(ancf::is_element_v<Element> == conforming);

// expected: a cable takes GreenAxial or EngineeringAxial
static_assert(sizeof(ancf::Cable<3, Measure>) > 0);

// expected: Model::add takes a load, which offers
void use_added(ancf::Model& model) { model.add(Added()); }

// expected: Model::add takes an amplitude with a load alone, which offers
void use_amplitude(ancf::Model& model, const ancf::Amplitude& amplitude) {
    model.add(Added(), amplitude);
}

// expected: the constraint is of another dimension than the model: Model takes Pin<3>
void use_pin(ancf::Model& model) { model.add(ancf::Pin<of_pin>(ancf::NodeId{0}, ancf::NodeId{1})); }

// expected: the load is of another dimension than the model: Model takes Force<3>
void use_force(ancf::Model& model, const ancf::Force<of_force>& force) { model.add(force); }

// expected: the last argument of a builder is the options of its element
void use_options(ancf::Model& model, const ancf::Material& material, const ancf::Section& section) {
    (void)ancf::net<ancf::Cable<3>>(model, {{material, section}}, {}, {}, {}, Options());
}

// expected: an arc in space takes: from, tangent, normal, radius, angle, elements
void use_arc(ancf::BasicModel<of_arc>& model, const ancf::Material& material,
             const ancf::Section& section) {
    (void)ancf::arc<ancf::Cable<of_arc>>(model, material, section, {0, 0}, {1, 0}, 1.0, 1.0, 8);
}

// expected: a spline needs a model in space
void use_spline(ancf::BasicModel<of_force>& model, const ancf::Material& material,
                const ancf::Section& section) {
    (void)ancf::spline<ancf::Cable<of_force>>(model, material, section, {{0, 0, 0}, {1, 0, 0}},
                                              {0, 1, 0});
}
