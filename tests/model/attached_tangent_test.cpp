// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Force and tangent of attached elements against the complex step.
///
/// The transfer of each scene comes from the reference positions and slopes alone, and its elements
/// are evaluated one by one on complex coordinates.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/joint/affine_joint.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <support/catch.hpp>
#include <support/complex_elements.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

namespace attached_tangent_test {

using namespace ancf;
using Complex = std::complex<double>;
template <class S>
using Values = Vector<S, Eigen::Dynamic>;

/// Soft and thick, so that forces on positions and on slopes are of one size.
Material soft() { return Material::isotropic(2e4, 0.3, 1000.0); }
Section thick() { return rectangle(0.25, 0.25); }

/// A vector of one node that follows another node.
struct Bond {
    NodeId end, joint;
    Field field;
};

/// Members of one type on two joints that stand askew, each joint with a body of its own.
template <class Element>
struct Askew {
    static constexpr int dimension = Element::dimension;
    using Body = AffineJoint<dimension>;
    using Point = Vector<double, dimension>;

    BasicModel<dimension> model;
    std::vector<Bond> bonds;

    /// A member on arms at both ends, one on an arm that follows another arm, with a hinge at its
    /// other end, and one that is pinned to an arm and free elsewhere.
    Askew() {
        test::Random random(8);
        const auto at = [](double x, double y, double z) {
            Point point = Point::Zero();
            point[0] = x;
            point[1] = y;
            if constexpr (dimension == 3) point[2] = z;
            return point;
        };
        const auto node = [&](const Point& point) {
            return model.add_node(point, test::random_rotation<dimension>(random));
        };
        const auto member = [&](const Point& from, const Point& to) {
            return straight_beam<Element>(model, soft(), thick(), from, to, 1);
        };
        const NodeId left = node(at(0.0, 0.0, 0.0)), right = node(at(1.5, 0.3, -0.2));
        const auto tie = member(at(0.1, 0.2, -0.1), at(1.3, 0.1, 0.1));
        const auto strut = member(at(-0.2, 0.5, 0.3), at(1.4, 0.6, 0.2));
        const auto spike = member(at(1.7, 0.2, 0.1), at(2.4, 0.5, 0.3));
        const int body = model.add_prototype(Body(soft(), 0.02, 0.3));
        model.template connect<Body>(body, left, left);
        model.template connect<Body>(body, right, right);
        const NodeId arm = node(at(-0.1, 0.3, 0.1));
        bind(tie.first(), left, rigid());
        bind(tie.last(), right, rigid());
        bind(strut.first(), arm, rigid());
        bind(strut.last(), right, hinge());
        bind(arm, left, Field::r | Body::fields);
        bind(spike.first(), right, Field::r);
    }

    /// What a rigid joint attaches; of cables a pin.
    static Fields rigid() {
        if (!Element::fields.contains(Field::r_y)) return Field::r;
        if (dimension == 2) return Field::r | Field::r_y;
        if (!Element::fields.contains(Field::r_z)) return Field::r | Field::r_x | Field::r_y;
        return Field::r | Field::r_y | Field::r_z;
    }

    /// Position and a slope across where space has one, else a pin.
    static Fields hinge() {
        if (dimension == 2 || !Element::fields.contains(Field::r_y)) return Field::r;
        return Field::r | (Element::fields.contains(Field::r_z) ? Field::r_z : Field::r_y);
    }

    void bind(NodeId end, NodeId joint, Fields fields) {
        model.attach(end, joint, fields);
        for (int k = 0; k < fields.count(); ++k) bonds.push_back({end, joint, fields.at(k)});
    }

    /// d(all coordinates)/d(those that are not attached), from the reference.
    [[nodiscard]] MatrixX transfer() const {
        const Layout& layout = model.layout();
        const VectorX& q = model.state().q;
        const auto index = [&](NodeId node, Field field) { return layout.index({node, field}); };
        const int size = layout.size();
        MatrixX follow = MatrixX::Identity(size, size);
        for (const Bond& bond : bonds) {
            const int own = index(bond.end, bond.field);
            for (int i = 0; i < dimension; ++i) follow.row(own + i).setZero();
            Point rest = q.template segment<dimension>(own);
            if (bond.field == Field::r) {
                const int to = index(bond.joint, Field::r);
                rest -= q.template segment<dimension>(to);
                follow.template block<dimension, dimension>(own, to).setIdentity();
            }
            Matrix<double, dimension> slopes;
            const int first = index(bond.joint, Field::r_x);  // the others follow it
            for (int k = 0; k < dimension; ++k)
                slopes.col(k) = q.template segment<dimension>(first + k * dimension);
            const Point part = slopes.inverse() * rest;
            for (int k = 0; k < dimension; ++k)
                for (int i = 0; i < dimension; ++i)
                    follow(own + i, first + k * dimension + i) = part[k];
        }
        const MatrixX chained = follow * follow;  // no chain is longer than two
        MatrixX columns(size, 0);
        for (int k = 0; k < size; ++k) {
            const int vector = k - k % dimension;
            const bool attached = std::any_of(bonds.begin(), bonds.end(), [&](const Bond& bond) {
                return index(bond.end, bond.field) == vector;
            });
            if (attached) continue;
            columns.conservativeResize(size, columns.cols() + 1);
            columns.col(columns.cols() - 1) = chained.col(k);
        }
        return columns;
    }

    /// Adds energy and force of all elements of a type.
    template <class Type, class S>
    void add(const Values<S>& q, S& energy, Values<S>& force) const {
        const auto& group = model.template group<Type>();
        for (int k = 0; k < group.size(); ++k) {
            const Connection& of = group.connection(k);
            std::vector<int> at;
            for (const NodeId node : {of.first, of.second})
                for (int f = 0; f < Type::fields.count(); ++f)
                    for (int i = 0; i < dimension; ++i)
                        at.push_back(model.layout().index({node, Type::fields.at(f)}) + i);
            Vector<S, Type::dofs> e;
            for (int i = 0; i < Type::dofs; ++i) e[i] = q[at[static_cast<std::size_t>(i)]];
            energy += group.element(k).energy(e);
            const Vector<S, Type::dofs> own = group.element(k).force(e);
            for (int i = 0; i < Type::dofs; ++i) force[at[static_cast<std::size_t>(i)]] += own[i];
        }
    }

    template <class S>
    void evaluate(const Values<S>& q, S& energy, Values<S>& force) const {
        energy = S(0.0);
        force = Values<S>::Zero(q.size());
        add<Element>(q, energy, force);
        add<Body>(q, energy, force);
    }
};

/// Checks that transferred force and tangent are those of the complex step, and symmetric.
template <class Element>
void check_attached() {
    const Askew<Element> scene;
    Assembly assembly(scene.model, Storage::full);
    const MatrixX T = scene.transfer();
    const MatrixX T_t = T.transpose();
    const auto free = assembly.numbering().free_coordinates();
    REQUIRE(T.cols() == free);
    REQUIRE(T.rows() > T.cols());
    VectorX rest;
    assembly.numbering().gather_free(scene.model.state().q, rest);
    REQUIRE((T * rest - scene.model.state().q).norm() <= 1e-14 * rest.norm());
    const VectorX still = VectorX::Zero(T.rows()), none;
    double gradient_error = 0.0, tangent_error = 0.0, asymmetry = 0.0;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        test::Random random(seed);
        const VectorX u = rest + 0.15 * random.vector(static_cast<int>(free));
        REQUIRE_FALSE(assembly.evaluate({T * u, still, none, {}}, Request::tangent));
        VectorX force;
        assembly.residual(force);
        const MatrixX K = assembly.tangent();
        const VectorX gradient = test::complex_step_gradient(
            [&](const Values<Complex>& z) {
                Complex energy;
                Values<Complex> unused;
                scene.evaluate(Values<Complex>(T * z), energy, unused);
                return energy;
            },
            u);
        const MatrixX jacobian = test::complex_step_jacobian(
            [&](const Values<Complex>& z) {
                Complex energy;
                Values<Complex> all;
                scene.evaluate(Values<Complex>(T * z), energy, all);
                return Values<Complex>(T_t * all);
            },
            u);
        REQUIRE(gradient.norm() > 1.0);
        gradient_error = std::max(gradient_error, test::relative_error(force, gradient));
        tangent_error = std::max(tangent_error, test::relative_error(K, jacobian));
        asymmetry = std::max(asymmetry, test::relative_error(K, MatrixX(K.transpose())));
    }
    INFO("force " << gradient_error << ", tangent " << tangent_error << ", symmetry " << asymmetry);
    CHECK(gradient_error <= 1e-12);
    CHECK(tangent_error <= 1e-12);
    CHECK(asymmetry <= 1e-14);
}

TEST_CASE("attachments: force and tangent equal the complex step, the tangent is symmetric",
          "[model][attachment]") {
    SECTION("cross-section") { check_attached<CrossSectionBeam<3>>(); }
    SECTION("cross-section, geodesic") { check_attached<CrossSectionBeam<3, Geodesic>>(); }
    SECTION("torsion") { check_attached<TorsionBeam>(); }
    SECTION("planar") { check_attached<CrossSectionBeam<2>>(); }
    SECTION("cable") { check_attached<Cable<3>>(); }
}

}  // namespace attached_tangent_test
