// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// An element for the meshes of Project Chrono that computes with an element of this library.
///
/// Chrono's node ChNodeFEAxyzDDD carries r, r_x, r_y and r_z, as a node of the library does. The
/// scene keeps its nodes, its mesh, its supports and its solver. Chrono's force is that of the
/// element on its nodes, -dU/de; its stiffness is d2U/de2.
///
/// There: internal forces, Jacobian, mass, gravity, forces on nodes. Not there: loads along the
/// element (ChLoadableU, ChLoadableUVW), damping of the element, section results for colours.

#pragma once

// Chrono adds members to Eigen's matrices: its headers come before all others that include Eigen.
#include <chrono/fea/ChElementANCF.h>
#include <chrono/fea/ChElementBeam.h>
#include <chrono/fea/ChMesh.h>
#include <chrono/fea/ChNodeFEAxyzDDD.h>

#include <ancf/types.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace ancf_chrono {

/// @tparam Element  of two nodes in space with r, r_x, r_y and r_z: CrossSectionBeam<3> with any
///         directors and measure, ContinuumBeam<3>
template <class Element>
class ChElementOf : public chrono::fea::ChElementANCF, public chrono::fea::ChElementBeam {
    static_assert(Element::dimension == 3 && Element::dofs == 24,
                  "a node of Chrono carries r, r_x, r_y and r_z");

public:
    using Node = chrono::fea::ChNodeFEAxyzDDD;
    using Coordinates = typename Element::Coordinates;

    ChElementOf(std::shared_ptr<Node> first, std::shared_ptr<Node> last, Element element)
        : nodes_{std::move(first), std::move(last)},
          element_(std::move(element)),
          mass_(element_.mass()) {
        std::vector<chrono::ChVariables*> variables;
        for (const auto& node : nodes_)
            variables.insert(variables.end(), {&node->Variables(), &node->VariablesSlope1(),
                                               &node->VariablesSlope2(), &node->VariablesSlope3()});
        Kmatr.SetVariables(variables);
    }

    /// Returns the library's element, for energies and section forces.
    [[nodiscard]] const Element& element() const { return element_; }

    /// Returns the nodal coordinates of the present state.
    [[nodiscard]] Coordinates coordinates() const {
        Coordinates e;
        for (int k = 0; k < 2; ++k) {
            const Node& node = *nodes_[static_cast<std::size_t>(k)];
            e.template segment<3>(12 * k) = node.GetPos().eigen();
            e.template segment<3>(12 * k + 3) = node.GetSlope1().eigen();
            e.template segment<3>(12 * k + 6) = node.GetSlope2().eigen();
            e.template segment<3>(12 * k + 9) = node.GetSlope3().eigen();
        }
        return e;
    }

    // ---- what a mesh asks

    unsigned int GetNumNodes() override { return 2; }
    unsigned int GetNumCoordsPosLevel() override { return 24; }
    unsigned int GetNumCoordsPosLevelActive() override {
        return nodes_[0]->GetNumCoordsPosLevelActive() + nodes_[1]->GetNumCoordsPosLevelActive();
    }
    unsigned int GetNodeNumCoordsPosLevel(unsigned int n) override {
        return nodes_[n]->GetNumCoordsPosLevel();
    }
    unsigned int GetNodeNumCoordsPosLevelActive(unsigned int n) override {
        return nodes_[n]->GetNumCoordsPosLevelActive();
    }
    std::shared_ptr<chrono::fea::ChNodeFEAbase> GetNode(unsigned int n) override {
        return nodes_[n];
    }
    void GetStateBlock(chrono::ChVectorDynamic<>& block) override { block = coordinates(); }

    void ComputeInternalForces(chrono::ChVectorDynamic<>& force) override {
        force = -element_.force(coordinates());
    }

    void ComputeKRMmatricesGlobal(chrono::ChMatrixRef h, double stiffness, double /*damping*/,
                                  double mass) override {
        h = stiffness * element_.evaluate(coordinates()).tangent + mass * mass_;
    }

    void ComputeMmatrixGlobal(chrono::ChMatrixRef m) override { m = mass_; }

    void ComputeGravityForces(chrono::ChVectorDynamic<>& force,
                              const chrono::ChVector3d& acceleration) override {
        force = element_.gravity(acceleration.eigen());
    }

    void ComputeNodalMass() override {
        const double coupling = mass_(0, 12);
        nodes_[0]->m_TotalMass += mass_(0, 0) + coupling;
        nodes_[1]->m_TotalMass += mass_(12, 12) + coupling;
    }

    // ---- what a beam is asked for pictures; place from -1 to 1

    void EvaluateSectionFrame(const double place, chrono::ChVector3d& point,
                              chrono::ChQuaternion<>& turned) override {
        const Coordinates e = coordinates();
        const double xi = 0.5 * (place + 1.0);
        const auto centre = element_.position(e, xi, 0.0, 0.0);
        const auto across = element_.position(e, xi, 1.0, 0.0);
        const auto up = element_.position(e, xi, 0.0, 1.0);
        const chrono::ChVector3d y(across - centre), z(up - centre);
        point = chrono::ChVector3d(centre);
        chrono::ChMatrix33<> axes;
        axes.SetFromAxisX(y.Cross(z), y);
        turned = axes.GetQuaternion();
    }
    void EvaluateSectionDisplacement(const double, chrono::ChVector3d&,
                                     chrono::ChVector3d&) override {}
    void EvaluateSectionForceTorque(const double, chrono::ChVector3d&,
                                    chrono::ChVector3d&) override {}
    void EvaluateSectionStrain(const double, chrono::ChVector3d&) override {}

private:
    std::array<std::shared_ptr<Node>, 2> nodes_;
    Element element_;
    ancf::Matrix<double, 24> mass_;
};

/// Adds an element of the library to a mesh of Chrono, where the scene added one of Chrono's.
template <class Element>
std::shared_ptr<ChElementOf<Element>> add_element(
    chrono::fea::ChMesh& mesh, std::shared_ptr<chrono::fea::ChNodeFEAxyzDDD> first,
    std::shared_ptr<chrono::fea::ChNodeFEAxyzDDD> last, Element element) {
    auto added = std::make_shared<ChElementOf<Element>>(std::move(first), std::move(last),
                                                        std::move(element));
    mesh.AddElement(added);
    return added;
}

}  // namespace ancf_chrono
