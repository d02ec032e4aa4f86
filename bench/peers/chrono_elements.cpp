// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Time of force and Jacobian of one element: Project Chrono's ANCF elements and the library's, in
/// one run on one thread, each code called by its own interface and by turns.
///
///     chrono_elements [REPEATS]    400 unless told otherwise

#include "chrono_chain.hpp"  // first: it includes Chrono before Eigen

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace peers;
using Paper = ancf::CrossSectionBeam<3>;
using Best = ancf::CrossSectionBeam<3, ancf::Geodesic>;

constexpr double angle = 0.125;  // that an element is bent by
constexpr double arc = 0.25;     // m, its length

/// A beam of a given number of elements, all bent to one arc.
Beam bent_beam(int count) { return {arc * count, 0.01, 2.07e11, 7.9615e10, 0.0, 7850.0}; }

/// The point of the arc at an angle, the tangent there, the normal.
struct Frame {
    explicit Frame(double at)
        : r(arc / angle * std::sin(at), arc / angle * (1.0 - std::cos(at)), 0.0),
          x(std::cos(at), std::sin(at), 0.0),
          y(-std::sin(at), std::cos(at), 0.0) {}
    ancf::Vector<double, 3> r, x, y;
};

/// Some elements of one kind: computes all their forces, or all their Jacobians.
struct Subject {
    const char* name;
    int count;
    std::function<void()> forces, jacobians;
    double force = 1e99, jacobian = 1e99;  // ns of an element
};

Subject in_chrono(const char* name, Kind (*kind)(const Beam&), int count) {
    const auto chain = std::make_shared<Chain>(bent_beam(count), kind(bent_beam(count)), count);
    chain->system.DoStepDynamics(1e-9);  // sets the elements up
    for (const NodePointer& node : chain->nodes) {
        const Frame frame(node->GetX0().x() / arc * angle);
        node->SetPos(ChVector3d(frame.r));
        auto* with_y = dynamic_cast<fea::ChNodeFEAxyzDD*>(node.get());
        auto* with_x = dynamic_cast<fea::ChNodeFEAxyzDDD*>(node.get());
        if (with_x || !with_y) node->SetSlope1(ChVector3d(frame.x));
        if (with_x) with_x->SetSlope2(ChVector3d(frame.y));
        if (with_y && !with_x) with_y->SetSlope1(ChVector3d(frame.y));
    }
    const int size = static_cast<int>(chain->elements[0]->GetNumCoordsPosLevel());
    const auto force = std::make_shared<chrono::ChVectorDynamic<>>(size);
    const auto h = std::make_shared<chrono::ChMatrixDynamic<>>(size, size);
    return {name, count,
            [=] {
                for (const auto& element : chain->elements) element->ComputeInternalForces(*force);
            },
            [=] {
                for (const auto& element : chain->elements)
                    element->ComputeKRMmatricesGlobal(*h, 1.0, 0.0, 0.0);
            }};
}

/// @tparam Scalar  double, or a pack of several elements that are computed at once
template <class Scalar, class Element>
Subject in_ancf(const char* name, const typename Element::Options& options, int count) {
    struct Mesh {
        std::vector<Element> elements;
        std::vector<ancf::Vector<Scalar, Element::dofs>> e;
        ancf::Vector<Scalar, Element::dofs> force;
        ancf::Evaluation<Scalar, Element::dofs> all;
    };
    const auto mesh = std::make_shared<Mesh>();
    const Beam beam = bent_beam(count);
    const int lanes = static_cast<int>(sizeof(Scalar) / sizeof(double));
    for (int k = 0; k < std::max(1, count / lanes); ++k) {
        mesh->elements.emplace_back(material(beam), section(beam), arc, options);
        typename Element::Coordinates e;
        int at = 0;
        for (const Frame& frame : {Frame(k * angle), Frame((k + 1) * angle)})
            for (const auto& [field, value] :
                 {std::pair(ancf::Field::r, frame.r), std::pair(ancf::Field::r_x, frame.x),
                  std::pair(ancf::Field::r_y, frame.y),
                  std::pair(ancf::Field::r_z, ancf::Vector<double, 3>(0.0, 0.0, 1.0)),
                  std::pair(ancf::Field::r_xx, ancf::Vector<double, 3>(angle / arc * frame.y))})
                if (Element::fields.contains(field)) {
                    e.template segment<3>(at) = value;
                    at += 3;
                }
        mesh->e.push_back(e.template cast<Scalar>());
    }
    return {name, static_cast<int>(mesh->e.size()) * lanes,
            [=] {
                for (std::size_t k = 0; k < mesh->e.size(); ++k)
                    mesh->force = mesh->elements[k].force(mesh->e[k]);
            },
            [=] {
                for (std::size_t k = 0; k < mesh->e.size(); ++k)
                    mesh->all = mesh->elements[k].evaluate(mesh->e[k]);
            }};
}

/// Returns processor time, which does not count when others have the core.
double nanoseconds(const Subject& subject, const std::function<void()>& all) {
    const int loops = std::max(1, 400 / subject.count);
    const std::clock_t began = std::clock();
    for (int k = 0; k < loops; ++k) all();
    return static_cast<double>(std::clock() - began) * 1e9 / CLOCKS_PER_SEC /
           (loops * subject.count);
}

void measure_elements(int count, int rounds) {
    using Four = ancf::Pack<4>;
    const auto best = ancf::CrossSectionOptions::best();
    ancf::CrossSectionOptions mixed;
    mixed.rule = ancf::Rule::mixed();
    std::vector<Subject> subjects = {
        in_chrono(
            "Chrono 3243, continuous integration",
            [](const Beam& beam) { return chrono_3243(beam); }, count),
        in_chrono(
            "Chrono 3243, pre-integration",
            [](const Beam& beam) { return chrono_3243(beam, false); }, count),
        in_chrono(
            "Chrono 3333, continuous integration",
            [](const Beam& beam) { return chrono_3333(beam); }, count),
        in_chrono(
            "Chrono 3333, pre-integration",
            [](const Beam& beam) { return chrono_3333(beam, false); }, count),
        in_chrono("Chrono cable", chrono_cable, count),
        in_ancf<double, Paper>("CrossSectionBeam<3>, rule mixed", mixed, count),
        in_ancf<double, Best>("CrossSectionBeam<3, Geodesic>, best()", best, count),
        in_ancf<double, ancf::QuinticBeam<>>("QuinticBeam<>", {}, count),
        in_ancf<double, ancf::Cable<3>>("Cable<3>", {}, count),
        in_ancf<Four, Paper>("CrossSectionBeam<3>, rule mixed, four at once", mixed, count),
        in_ancf<Four, Best>("CrossSectionBeam<3, Geodesic>, four at once", best, count),
        in_ancf<Four, ancf::QuinticBeam<>>("QuinticBeam<>, four at once", {}, count),
        in_ancf<Four, ancf::Cable<3>>("Cable<3>, four at once", {}, count)};
    for (int round = 0; round < rounds; ++round)
        for (Subject& subject : subjects) {
            subject.force = std::min(subject.force, nanoseconds(subject, subject.forces));
            subject.jacobian = std::min(subject.jacobian, nanoseconds(subject, subject.jacobians));
        }
    std::printf("A mesh of %d elements, ns of an element: force, Jacobian\n", count);
    for (const Subject& subject : subjects)
        std::printf("  %-48s %8.0f %10.0f\n", subject.name, subject.force, subject.jacobian);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 400;
    measure_elements(1, rounds);
    measure_elements(32, rounds);
    measure_elements(2000, rounds / 10);
    return 0;
}
