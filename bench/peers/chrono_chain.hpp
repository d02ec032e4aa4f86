// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Straight beams of Project Chrono's ANCF elements: its beams 3243 and 3333 and its cable.

#pragma once

#include <chrono/fea/ChElementBeamANCF_3243.h>  // first: Chrono adds members to Eigen's matrices
#include <chrono/fea/ChElementBeamANCF_3333.h>
#include <chrono/fea/ChElementCableANCF.h>
#include <chrono/fea/ChLinkNodeFrame.h>
#include <chrono/fea/ChLinkNodeSlopeFrame.h>
#include <chrono/fea/ChMesh.h>
#include <chrono/physics/ChBody.h>
#include <chrono/physics/ChSystemSMC.h>
#include <chrono/solver/ChDirectSolverLS.h>
#include <chrono/timestepper/ChTimestepperHHT.h>

#include <ancf/section/material.hpp>
#include <ancf/section/profiles.hpp>

#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace peers {

namespace fea = chrono::fea;
using chrono::ChVector3d;
using Node = fea::ChNodeFEAxyzD;
using NodePointer = std::shared_ptr<Node>;
using ElementPointer = std::shared_ptr<fea::ChElementGeneric>;

/// A beam along X from the origin, of a square section.
struct Beam {
    double length, side;            // m
    double young, shear, poisson;   // Pa, Pa, 1
    double density;                 // kg/m^3
    double correction = 5.0 / 6.0;  // of the shear modulus
};

/// Returns what the library's elements are made of.
inline ancf::Material material(const Beam& beam) {
    return ancf::Material::from_moduli(beam.young, beam.shear, beam.density);
}
inline ancf::Section section(const Beam& beam) {
    return ancf::rectangle(beam.side, beam.side)
        .with_shear_correction(beam.correction, beam.correction);
}

/// An element of Chrono, or another that takes the nodes of one.
struct Kind {
    enum class Nodes { beam_3243, beam_3333, cable };
    using Adder =
        std::function<ElementPointer(fea::ChMesh&, const std::vector<NodePointer>&, double length)>;

    const char* name;
    const char* integration;
    Nodes nodes;
    Adder add;  ///< puts an element on its nodes, first, last, middle, into a mesh

    [[nodiscard]] int nodes_per_element() const { return nodes == Nodes::beam_3333 ? 2 : 1; }
    /// Where the slope that a moment about Z turns stands in a node's coordinates: r_y, of the
    /// cable r_x.
    [[nodiscard]] int turning_slope() const { return nodes == Nodes::beam_3243 ? 6 : 3; }
};

/// Chrono's beams of continuum mechanics.
/// @param damping  Chrono's "alpha", s
template <class Element, class ItsNode>
Kind::Adder beams(const Beam& beam, typename Element::IntFrcMethod method, double damping = 0.0) {
    return [=](fea::ChMesh& mesh, const std::vector<NodePointer>& nodes, double length) {
        const auto node = [&](int k) { return std::static_pointer_cast<ItsNode>(nodes[k]); };
        auto element = std::make_shared<Element>();
        if constexpr (std::is_same_v<Element, fea::ChElementBeamANCF_3333>)
            element->SetNodes(node(0), node(1), node(2));
        else
            element->SetNodes(node(0), node(1));
        element->SetDimensions(length, beam.side, beam.side);
        element->SetMaterial(std::make_shared<fea::ChMaterialBeamANCF>(
            beam.density, ChVector3d(beam.young), ChVector3d(beam.poisson), ChVector3d(beam.shear),
            beam.correction, beam.correction));
        element->SetAlphaDamp(damping);
        element->SetIntFrcCalcMethod(method);
        mesh.AddElement(element);
        return element;
    };
}

inline Kind chrono_3243(const Beam& beam, bool continuous = true, double damping = 0.0) {
    using Element = fea::ChElementBeamANCF_3243;
    using Method = Element::IntFrcMethod;
    return {"chrono-3243", continuous ? "continuous" : "pre-integrated", Kind::Nodes::beam_3243,
            beams<Element, fea::ChNodeFEAxyzDDD>(
                beam, continuous ? Method::ContInt : Method::PreInt, damping)};
}

inline Kind chrono_3333(const Beam& beam, bool continuous = true) {
    using Element = fea::ChElementBeamANCF_3333;
    using Method = Element::IntFrcMethod;
    return {
        "chrono-3333", continuous ? "continuous" : "pre-integrated", Kind::Nodes::beam_3333,
        beams<Element, fea::ChNodeFEAxyzDD>(beam, continuous ? Method::ContInt : Method::PreInt)};
}

// The section's class has another name since the release 10.0.0.
#if __has_include(<chrono/fea/ChBeamSectionCableANCF.h>)
using CableSection = fea::ChBeamSectionCableANCF;
#else
using CableSection = fea::ChBeamSectionCable;
#endif

inline Kind chrono_cable(const Beam& beam) {
    const auto add = [=](fea::ChMesh& mesh, const std::vector<NodePointer>& nodes, double) {
        auto section = std::make_shared<CableSection>();
        const double area = beam.side * beam.side;
        section->SetArea(area);
        section->SetInertia(area * area / 12.0);
        section->SetYoungModulus(beam.young);
        section->SetDensity(beam.density);
        section->SetRayleighDamping(0.0);
        auto element = std::make_shared<fea::ChElementCableANCF>();
        element->SetNodes(nodes[0], nodes[1]);
        element->SetSection(section);
        element->SetAlphaDamp(0.0);
        mesh.AddElement(element);
        return element;
    };
    return {"chrono-cable", "", Kind::Nodes::cable, add};
}

/// A chain of one kind in a system of Chrono, solved by its sparse LU.
struct Chain {
    chrono::ChSystemSMC system;
    std::shared_ptr<fea::ChMesh> mesh = std::make_shared<fea::ChMesh>();
    std::shared_ptr<chrono::ChBody> ground = std::make_shared<chrono::ChBody>();
    std::shared_ptr<chrono::ChSolverSparseLU> solver = std::make_shared<chrono::ChSolverSparseLU>();
    std::vector<NodePointer> nodes;
    std::vector<ElementPointer> elements;

    Chain(const Beam& beam, const Kind& kind, int count, const ChVector3d& gravity = {0, 0, 0}) {
        system.SetGravitationalAcceleration(gravity);
        const int per = kind.nodes_per_element();
        for (int k = 0; k <= per * count; ++k) {
            nodes.push_back(node(kind, {beam.length * k / (per * count), 0, 0}));
            mesh->AddNode(nodes.back());
        }
        for (int k = 0; k < count; ++k)
            elements.push_back(kind.add(*mesh,
                                        {nodes[per * k], nodes[per * (k + 1)], nodes[per * k + 1]},
                                        beam.length / count));
        system.Add(mesh);
        ground->SetFixed(true);
        system.Add(ground);
        solver->UseSparsityPatternLearner(false);  // as in Chrono's own benchmarks
        solver->LockSparsityPattern(true);
        system.SetSolver(solver);
    }

    static NodePointer node(const Kind& kind, const ChVector3d& at) {
        const ChVector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
        switch (kind.nodes) {
            case Kind::Nodes::beam_3243: return std::make_shared<fea::ChNodeFEAxyzDDD>(at, x, y, z);
            case Kind::Nodes::beam_3333: return std::make_shared<fea::ChNodeFEAxyzDD>(at, y, z);
            case Kind::Nodes::cable: break;
        }
        return std::make_shared<Node>(at, x);
    }

    /// Joins the first node to the ground by a spherical joint.
    void pin() {
        auto joint = std::make_shared<fea::ChLinkNodeFrame>();
        joint->Initialize(nodes.front(), ground);
        system.Add(joint);
    }

    /// Sets Chrono's HHT integrator to steps of one length.
    /// @param alpha  damping, from -1/3 to 0. Take 0: docs/chrono.md
    std::shared_ptr<chrono::ChTimestepperHHT> take_hht(double alpha) {
        system.SetTimestepperType(chrono::ChTimestepper::Type::HHT);
        auto hht = std::static_pointer_cast<chrono::ChTimestepperHHT>(system.GetTimestepper());
        hht->SetAlpha(alpha);
        hht->SetMaxIters(100);
        hht->SetAbsTolerances(1e-5);
        hht->SetJacobianUpdateMethod(chrono::ChTimestepperImplicit::JacobianUpdate::EVERY_STEP);
        return hht;
    }
};

}  // namespace peers
