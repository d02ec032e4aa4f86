// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A rope of ANCF cables between two bodies of a Simbody system: a crane that slews, and its load.
///
///     pin |______________ jib, turns about the vertical
///                        |
///                        |  rope: Cable<3>, 8 elements
///                        |
///                       [ ]  load, free in space
///
/// The rope is a Force of Simbody. Its nodal coordinates q and their rates v are z variables of the
/// force subsystem, so Simbody's integrator moves bodies and rope together:
///
///     q' = v,    v' = M^-1 (f_gravity - Q(q) - f_bushings),
///
/// with the elastic force Q of the library and the constant mass matrix M, factorised once.
/// A bushing at each end holds the rope to a body; body and rope feel opposite forces. Nothing is
/// damped and nothing drives, so energy and angular momentum about the vertical must stay. The
/// program checks both, and that a more accurate integration keeps the energy better.

#include <ancf/element/cable/cable.hpp>
#include <ancf/section/section.hpp>

#include <Eigen/Cholesky>

#include <Simbody.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>

namespace {

using Element = ancf::Cable<3>;
using Eigen::Vector3d;
using Eigen::VectorXd;
using SimTK::Real;
using SimTK::State;
using SimTK::Vec3;

constexpr int elements = 8;
constexpr int per_node = Element::node_dofs;  // r and r_x
constexpr int size = per_node * (elements + 1);

constexpr double gravity = 9.81;           // m/s^2, along -Z
constexpr double rope_length = 8.0;        // m, without load
constexpr double load_mass = 60.0;         // kg
constexpr double jib_length = 5.0;         // m
constexpr double slewing = 0.6;            // rad/s at the start
constexpr double bushing_stiffness = 1e6;  // N/m
constexpr double duration = 10.0;          // s

/// Holds r to a point of a body, and r_x along a direction of it.
///
///     U = 1/2 k |r - p|^2 + 1/2 c |r_x - (r_x.a) a|^2
struct Bushing {
    SimTK::MobilizedBody body;
    Vec3 station;    ///< of p, in the body's frame, m
    Vec3 direction;  ///< a, in the body's frame, a unit vector
    double k;        ///< N/m
    double c;        ///< N m; 0 leaves the direction free

    /// What it exerts on the body, and its energy.
    struct Action {
        Vec3 force, couple;  // N, of r at p; N, of r_x
        Vec3 moment;         // on the body, N m
        double energy;       // J
    };

    /// Returns the action on the body; the node feels -force at r and -couple at r_x.
    [[nodiscard]] Action action(const State& state, const Vec3& r, const Vec3& slope) const {
        const Vec3 gap = r - body.findStationLocationInGround(state, station);
        const Vec3 a = body.expressVectorInGroundFrame(state, direction);
        const double along = SimTK::dot(slope, a);
        const Vec3 across = slope - along * a;
        return {k * gap, c * across, c * along * SimTK::cross(a, across),
                0.5 * k * gap.normSqr() + 0.5 * c * across.normSqr()};
    }
};

Vec3 simbody(const Vector3d& v) { return {v[0], v[1], v[2]}; }
Vector3d eigen(const Vec3& v) { return {v[0], v[1], v[2]}; }

/// A rope between two bodies.
class Rope : public SimTK::Force::Custom::Implementation {
public:
    /// @param start  z at the start: nodal coordinates, then their rates
    Rope(SimTK::GeneralForceSubsystem& forces, const Element& element,
         const std::array<Bushing, 2>& ends, const VectorXd& start)
        : forces_(forces), element_(element), ends_(ends), start_(start) {
        for (int k = 0; k < elements; ++k) {
            const int first = per_node * k;
            mass_.block<Element::dofs, Element::dofs>(first, first) += element_.mass();
            weight_.segment<Element::dofs>(first) += element_.gravity({0.0, 0.0, -gravity});
        }
        factor_.compute(mass_);
    }

    // ---- what Simbody asks of a force

    void realizeTopology(State& state) const override {
        z_ = forces_.allocateZ(state, SimTK::Vector(2 * size, start_.data()));
    }

    /// Adds what the bushings exert on the bodies.
    void calcForce(const State& state, SimTK::Vector_<SimTK::SpatialVec>& bodies,
                   SimTK::Vector_<Vec3>& /*particles*/,
                   SimTK::Vector& /*mobilities*/) const override {
        for (int end = 0; end < 2; ++end) {
            const Bushing::Action action = act(state, end);
            const Bushing& bushing = ends_[static_cast<std::size_t>(end)];
            bushing.body.applyForceToBodyPoint(state, bushing.station, action.force, bodies);
            bushing.body.applyBodyTorque(state, action.moment, bodies);
        }
    }

    /// Returns the strain energy of rope and bushings and the rope's energy of gravity, J.
    Real calcPotentialEnergy(const State& state) const override {
        const auto q = coordinates(state);
        double energy = -weight_.dot(q);
        for (int k = 0; k < elements; ++k)
            energy += element_.energy(Element::Coordinates(q.segment<Element::dofs>(per_node * k)));
        return energy + act(state, 0).energy + act(state, 1).energy;
    }

    /// Writes the derivative of z.
    void realizeAcceleration(const State& state) const override {
        const auto q = coordinates(state);
        VectorXd force = weight_;
        for (int k = 0; k < elements; ++k)
            force.segment<Element::dofs>(per_node * k) -=
                element_.force(Element::Coordinates(q.segment<Element::dofs>(per_node * k)));
        for (int end = 0; end < 2; ++end) {
            const Bushing::Action action = act(state, end);
            force.segment<3>(node(end)) -= eigen(action.force);
            force.segment<3>(node(end) + 3) -= eigen(action.couple);
        }
        double* derivative = &forces_.updZDot(state)[z_];
        Eigen::Map<VectorXd>(derivative, size) = rates(state);
        Eigen::Map<VectorXd>(derivative + size, size) = factor_.solve(force);
    }

    // ---- what the program asks of the rope

    [[nodiscard]] Eigen::Map<const VectorXd> coordinates(const State& state) const {
        return {&forces_.getZ(state)[z_], size};
    }
    [[nodiscard]] Eigen::Map<const VectorXd> rates(const State& state) const {
        return {&forces_.getZ(state)[z_] + size, size};
    }
    [[nodiscard]] double kinetic_energy(const State& state) const {
        const auto v = rates(state);
        return 0.5 * v.dot(mass_ * v);
    }

    /// Returns the angular momentum about Z: every vector of a node turns with a rotation.
    [[nodiscard]] double angular_momentum(const State& state) const {
        const auto q = coordinates(state);
        const VectorXd p = mass_ * rates(state);
        double sum = 0.0;
        for (int i = 0; i < size; i += 3) sum += q[i] * p[i + 1] - q[i + 1] * p[i];
        return sum;
    }

private:
    [[nodiscard]] static int node(int end) { return end == 0 ? 0 : size - per_node; }

    [[nodiscard]] Bushing::Action act(const State& state, int end) const {
        const auto q = coordinates(state);
        const Vector3d r = q.segment<3>(node(end)), slope = q.segment<3>(node(end) + 3);
        return ends_[static_cast<std::size_t>(end)].action(state, simbody(r), simbody(slope));
    }

    SimTK::GeneralForceSubsystem& forces_;
    Element element_;
    std::array<Bushing, 2> ends_;
    VectorXd start_;
    VectorXd weight_ = VectorXd::Zero(size);
    Eigen::MatrixXd mass_ = Eigen::MatrixXd::Zero(size, size);
    Eigen::LLT<Eigen::MatrixXd> factor_;
    mutable SimTK::ZIndex z_;  // of the rope's first variable, given by realizeTopology
};

/// What a motion has shown.
struct Outcome {
    double kinetic = 0.0;   ///< largest kinetic energy, J
    double energy = 0.0;    ///< largest change of the total energy, J
    double momentum = 0.0;  ///< largest change of the angular momentum about Z, of its first value
    double swing = 0.0;     ///< farthest that the load comes from the tower, m
    int steps = 0;
};

Outcome run(double accuracy) {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter(system);
    SimTK::GeneralForceSubsystem forces(system);
    SimTK::Force::Gravity(forces, matter, Vec3(0, 0, -gravity));

    // the jib along X turns about Z; the rope hangs from its tip
    const Vec3 middle(0.5 * jib_length, 0, 0), tip(jib_length, 0, 0), turning(0, 0, slewing);
    const SimTK::Body::Rigid jib_body(SimTK::MassProperties(
        300.0, middle,
        SimTK::UnitInertia::brick(0.5 * jib_length, 0.2, 0.2).shiftFromCentroid(middle)));
    SimTK::MobilizedBody::Pin jib(matter.Ground(), jib_body);

    // a box whose eye lies above its centre
    const Vec3 eye(0, 0, 0.4);
    const SimTK::Body::Rigid load_body(
        SimTK::MassProperties(load_mass, Vec3(0), SimTK::UnitInertia::brick(0.3, 0.25, 0.4)));
    SimTK::MobilizedBody::Free load(matter.Ground(), load_body);

    // polyamide: E, nu, density. The rope hangs stretched by its load and by its own weight, and
    // turns with the crane.
    const auto polyamide = ancf::Material::isotropic(1e9, 0.4, 1140.0);
    const ancf::Section section = ancf::circle(0.008);
    const Element element(polyamide, section, rope_length / elements);
    const double stiffness = polyamide.young * section.moments().area;           // N
    const double weight = gravity * polyamide.density * section.moments().area;  // N/m
    const double total = load_mass * gravity + weight * rope_length;             // N
    VectorXd start(2 * size);
    for (int k = 0; k <= elements; ++k) {
        const double s = rope_length * k / elements;
        const double hangs =
            total / bushing_stiffness + s + (total * s - 0.5 * weight * s * s) / stiffness;
        const Vec3 r = tip - Vec3(0, 0, hangs);
        const Vec3 slope(0, 0, -1.0 - (total - weight * s) / stiffness);
        start.segment<per_node>(per_node * k) << eigen(r), eigen(slope);
        start.segment<per_node>(size + per_node * k) << eigen(SimTK::cross(turning, r)),
            eigen(SimTK::cross(turning, slope));
    }

    const std::array<Bushing, 2> ends{Bushing{jib, tip, Vec3(0, 0, -1), bushing_stiffness, 0.0},
                                      Bushing{load, eye, Vec3(0, 0, -1), bushing_stiffness, 10.0}};
    auto* const rope = new Rope(forces, element, ends, start);  // the system owns it
    SimTK::Force::Custom(forces, rope);

    State state = system.realizeTopology();
    const Vec3 last = simbody(start.segment<3>(size - per_node));
    const Vec3 centre = last - eye - Vec3(0, 0, load_mass * gravity / bushing_stiffness);
    load.setQToFitTranslation(state, centre);
    jib.setOneU(state, 0, slewing);
    system.realize(state, SimTK::Stage::Position);
    load.setUToFitVelocity(state, SimTK::SpatialVec(turning, SimTK::cross(turning, centre)));

    SimTK::RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(accuracy);
    SimTK::TimeStepper stepper(system, integrator);
    stepper.initialize(state);

    Outcome outcome;
    double first_energy = 0.0, first_momentum = 0.0;
    for (int k = 0; k <= 200; ++k) {
        if (k > 0) stepper.stepTo(duration * k / 200);
        const State& now = integrator.getState();
        system.realize(now, SimTK::Stage::Dynamics);
        const double kinetic = system.calcKineticEnergy(now) + rope->kinetic_energy(now);
        const double energy = kinetic + system.calcPotentialEnergy(now);
        const double momentum =
            matter.calcSystemMomentumAboutGroundOrigin(now)[0][2] + rope->angular_momentum(now);
        if (k == 0) {
            first_energy = energy;
            first_momentum = momentum;
        }
        const Vec3 place = load.getBodyOriginLocation(now);
        outcome.swing = std::max(outcome.swing, std::hypot(place[0], place[1]));
        outcome.kinetic = std::max(outcome.kinetic, kinetic);
        outcome.energy = std::max(outcome.energy, std::abs(energy - first_energy));
        outcome.momentum =
            std::max(outcome.momentum, std::abs(momentum - first_momentum) / first_momentum);
    }
    outcome.steps = integrator.getNumStepsTaken();
    return outcome;
}

}  // namespace

int main() try {
    bool good = true;
    double before = 0.0;
    for (const double accuracy : {1e-3, 1e-4}) {  // the first is Simbody's default
        const Outcome seen = run(accuracy);
        const double drift = seen.energy / seen.kinetic;
        std::cout << "accuracy " << accuracy << ": " << seen.steps
                  << " steps, kinetic energy up to " << seen.kinetic << " J, energy changes by "
                  << drift << " of it, angular momentum by " << seen.momentum << ", load out to "
                  << seen.swing << " m" << std::endl;
        good &= drift < 1e-5 && (before == 0.0 || drift < 0.1 * before);
        good &= seen.momentum < 1e-9 && seen.swing > jib_length + 2.0;
        before = drift;
    }
    return good ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
