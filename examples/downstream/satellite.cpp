// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A rigid-body code of its own borrows the element class alone: force, tangent and mass.
///
///         __________ boom, 4 elements, clamped to the hub
///       |/
///     [hub]  rigid, free in the plane: place X, Y and angle theta
///
/// State vector and integrator belong to this program; of ancf it includes one element. The first
/// node of the boom follows the hub, e = phi(s), so that with T = dphi/ds the motion is
///
///     (M_hub + T^T M T) s'' = -T^T (Q(e) + M T' s').
///
/// The classical Runge-Kutta method moves it; the tangent K gives the largest frequency, and so the
/// largest stable step. The hub starts with a spin, the boom at rest beside it. Nothing acts from
/// outside: momentum, angular momentum and energy must stay, and the program checks that they do.

#include <ancf/element/planar/beam.hpp>
#include <ancf/section/section.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

namespace {

using Element = ancf::CrossSectionBeam<2>;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr int elements = 4;
constexpr int per_node = Element::dofs / 2;  // r, r_x, r_y of a node
constexpr int boom_size = per_node * (elements + 1);
constexpr int hub_size = 3;                           // X, Y, theta
constexpr int size = hub_size + per_node * elements;  // the boom's first node follows the hub
constexpr double boom_length = 2.0;                   // m
constexpr double hub_mass = 3.0;                      // kg
constexpr double hub_inertia = 0.6;                   // kg m^2
constexpr double hub_radius = 0.2;                    // m, from its centre to the boom
constexpr double spin = 0.5;                          // rad/s, of the hub at the start
constexpr double duration = 1.5;                      // s

/// A satellite in generalised coordinates s = (X, Y, theta, free nodes of the boom).
class Satellite {
public:
    Satellite() : element_(material(), ancf::rectangle(0.02, 0.02), boom_length / elements) {
        const auto mass = element_.mass();
        mass_ = MatrixXd::Zero(boom_size, boom_size);
        for (int k = 0; k < elements; ++k)
            mass_.block(per_node * k, per_node * k, Element::dofs, Element::dofs) += mass;
    }

    /// Returns the straight boom along X and a hub without an angle.
    [[nodiscard]] static VectorXd start() {
        VectorXd s = VectorXd::Zero(size);
        for (int k = 1; k <= elements; ++k)
            s.segment<per_node>(hub_size + per_node * (k - 1))
                << hub_radius + boom_length * k / elements,
                0.0, 1.0, 0.0, 0.0, 1.0;
        return s;
    }

    /// Returns the nodal coordinates of the whole boom.
    [[nodiscard]] static VectorXd boom(const VectorXd& s) {
        VectorXd e(boom_size);
        const Matrix2d turned = rotation(s[2]);
        e.head<2>() = s.head<2>() + hub_radius * turned.col(0);
        e.segment<2>(2) = turned.col(0);
        e.segment<2>(4) = turned.col(1);
        e.tail(size - hub_size) = s.tail(size - hub_size);
        return e;
    }

    /// Returns T = d boom/ds.
    [[nodiscard]] static MatrixXd transformation(const VectorXd& s) {
        MatrixXd t = MatrixXd::Zero(boom_size, size);
        const Matrix2d turned = rotation(s[2]);
        t.topLeftCorner<2, 2>().setIdentity();
        t.block<2, 1>(0, 2) = hub_radius * turned.col(1);  // d e_1/d theta = e_2
        t.block<2, 1>(2, 2) = turned.col(1);
        t.block<2, 1>(4, 2) = -turned.col(0);
        t.bottomRightCorner(size - hub_size, size - hub_size).setIdentity();
        return t;
    }

    /// Returns T' s': the centripetal acceleration of the first node.
    [[nodiscard]] static VectorXd convection(const VectorXd& s, const VectorXd& v) {
        VectorXd c = VectorXd::Zero(boom_size);
        const Matrix2d turned = rotation(s[2]);
        c.head<2>() = -v[2] * v[2] * hub_radius * turned.col(0);
        c.segment<2>(2) = -v[2] * v[2] * turned.col(0);
        c.segment<2>(4) = -v[2] * v[2] * turned.col(1);
        return c;
    }

    [[nodiscard]] MatrixXd mass(const MatrixXd& t) const {
        MatrixXd m = t.transpose() * mass_ * t;
        m(0, 0) += hub_mass;
        m(1, 1) += hub_mass;
        m(2, 2) += hub_inertia;
        return m;
    }

    [[nodiscard]] VectorXd acceleration(const VectorXd& s, const VectorXd& v) const {
        const MatrixXd t = transformation(s);
        const VectorXd e = boom(s);
        VectorXd force = mass_ * convection(s, v);
        for (int k = 0; k < elements; ++k) {
            const Element::Coordinates nodal = e.segment<Element::dofs>(per_node * k);
            force.segment<Element::dofs>(per_node * k) += element_.force(nodal);
        }
        return mass(t).llt().solve(-(t.transpose() * force));
    }

    /// Returns the largest angular frequency about a state at rest, rad/s.
    [[nodiscard]] double largest_frequency(const VectorXd& s) const {
        const MatrixXd t = transformation(s);
        const VectorXd e = boom(s);
        MatrixXd stiffness = MatrixXd::Zero(boom_size, boom_size);
        for (int k = 0; k < elements; ++k) {
            const Element::Coordinates nodal = e.segment<Element::dofs>(per_node * k);
            stiffness.block(per_node * k, per_node * k, Element::dofs, Element::dofs) +=
                element_.evaluate(nodal).tangent;
        }
        const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(
            t.transpose() * stiffness * t, mass(t), Eigen::EigenvaluesOnly);
        return std::sqrt(modes.eigenvalues().maxCoeff());
    }

    [[nodiscard]] double energy(const VectorXd& s, const VectorXd& v) const {
        double sum = 0.5 * v.dot(mass(transformation(s)) * v);
        const VectorXd e = boom(s);
        for (int k = 0; k < elements; ++k) {
            const Element::Coordinates nodal = e.segment<Element::dofs>(per_node * k);
            sum += element_.energy(nodal);
        }
        return sum;
    }

    /// Returns momentum (2) and angular momentum about the origin (1); kg m/s, kg m^2/s.
    [[nodiscard]] Eigen::Vector3d momenta(const VectorXd& s, const VectorXd& v) const {
        const VectorXd e = boom(s);
        const VectorXd p = mass_ * (transformation(s) * v);
        VectorXd shift = VectorXd::Zero(boom_size);  // a translation moves positions alone
        VectorXd turn(boom_size);                    // a rotation turns every vector
        Eigen::Vector3d result(hub_mass * v[0], hub_mass * v[1],
                               hub_mass * (s[0] * v[1] - s[1] * v[0]) + hub_inertia * v[2]);
        for (int first = 0; first < boom_size; first += 2) {
            if (first % per_node == 0) result.head<2>() += p.segment<2>(first);
            result[2] += e[first] * p[first + 1] - e[first + 1] * p[first];
        }
        return result;
    }

private:
    [[nodiscard]] static ancf::Material material() {
        return ancf::Material::isotropic(2e6, 0.3, 1200.0);  // a soft boom: Pa, 1, kg/m^3
    }

    [[nodiscard]] static Matrix2d rotation(double angle) {
        Matrix2d result;
        result << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        return result;
    }

    Element element_;
    MatrixXd mass_;  // of the boom, all nodes
};

/// One step of the classical Runge-Kutta method.
void step(const Satellite& satellite, double h, VectorXd& s, VectorXd& v) {
    const VectorXd a1 = satellite.acceleration(s, v);
    const VectorXd v2 = v + 0.5 * h * a1;
    const VectorXd a2 = satellite.acceleration(s + 0.5 * h * v, v2);
    const VectorXd v3 = v + 0.5 * h * a2;
    const VectorXd a3 = satellite.acceleration(s + 0.5 * h * v2, v3);
    const VectorXd v4 = v + h * a3;
    const VectorXd a4 = satellite.acceleration(s + h * v3, v4);
    s += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
}

/// Says what was found beside what is allowed.
bool within(const char* what, double value, double limit) {
    std::cout << what << ": " << value << ", at most " << limit << '\n';
    return std::abs(value) <= limit;
}

}  // namespace

int main() try {
    const Satellite satellite;
    VectorXd s = Satellite::start();
    VectorXd v = VectorXd::Zero(size);
    v[2] = spin;
    const double frequency = satellite.largest_frequency(s);
    const int steps = static_cast<int>(std::ceil(duration * frequency / 1.4));  // limit: 2.83
    const double energy = satellite.energy(s, v);
    const Eigen::Vector3d momenta = satellite.momenta(s, v);
    double bent = 0.0;  // m, the tip across the hub's axis
    for (int k = 0; k < steps; ++k) {
        step(satellite, duration / steps, s, v);
        const Vector2d tip = s.segment<2>(size - per_node) - s.head<2>();
        bent = std::max(bent, std::abs(std::cos(s[2]) * tip[1] - std::sin(s[2]) * tip[0]));
    }
    std::cout << steps << " steps, largest frequency " << frequency << " rad/s, the tip bends by "
              << bent << " m\n";

    const Eigen::Vector3d lost = satellite.momenta(s, v) - momenta;
    bool good = bent > 0.05;
    good &= within("momentum lost, kg m/s", lost.head<2>().norm(), 1e-12);
    good &= within("angular momentum lost, relative", lost[2] / momenta[2], 1e-11);
    good &= within("energy lost, relative", satellite.energy(s, v) / energy - 1.0, 1e-8);
    return good ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
