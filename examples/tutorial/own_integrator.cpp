// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A time integrator of one's own on DynamicProblem, beside RadauIIA.

#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <cmath>
#include <iostream>

/// The method of Hilber, Hughes and Taylor with fixed steps of h, of second order:
///
///     M a_1 + (1 + alpha) r_1 - alpha r_0 = 0,   g(q_1, t_1) = 0,
///     q_1 = q_0 + h v_0 + h^2 ((1/2 - beta) a_0 + beta a_1),
///     v_1 = v_0 + h ((1 - gamma) a_0 + gamma a_1)
///
/// @param alpha  from -1/3, which damps fast vibrations most, to 0.
ancf::Status integrate_hht(ancf::DynamicProblem& problem, ancf::LinearSolver& solver, double end,
                           int steps, double alpha = -0.1) {
    const double beta = 0.25 * (1.0 - alpha) * (1.0 - alpha), gamma = 0.5 - alpha;
    const ancf::Start start = problem.start();  // consistent accelerations and multipliers
    if (start.status != ancf::Status::converged) return start.status;
    ancf::VectorX q = start.q, v = start.v, a = start.acceleration, lambda = start.multipliers;
    if (problem.evaluate(start.time, q, v, lambda, ancf::Request::force))
        return ancf::Status::not_finite;
    ancf::VectorX r = problem.force(), rhs(problem.size() + problem.multipliers()), change;
    solver.analyze(problem.mass());  // all matrices have one pattern

    const double h = (end - start.time) / steps, weight = h * h * beta * (1.0 + alpha);
    for (int step = 1; step <= steps; ++step) {
        const double time = start.time + step * h;
        const ancf::VectorX q_known = q + h * v + h * h * (0.5 - beta) * a;
        const ancf::VectorX v_known = v + h * (1.0 - gamma) * a, r_before = r;
        double largest = 1.0;  // change of a coordinate, relative to its size
        for (int iteration = 0; iteration < 12; ++iteration) {
            q = q_known + h * h * beta * a;
            v = v_known + h * gamma * a;
            if (problem.evaluate(time, q, v, lambda, ancf::Request::tangent_and_damping))
                return ancf::Status::not_finite;
            r = problem.force();
            if (largest < 1e-10) break;
            // of the changes of q, and of lambda times the weight
            const ancf::SparseMatrix matrix = problem.mass() + weight * problem.tangent() +
                                              weight * gamma / (h * beta) * problem.damping();
            ancf::VectorX forces = (1.0 + alpha) * r - alpha * r_before;
            problem.add_mass_product(1.0, a, forces);
            rhs << -h * h * beta * forces, -weight * problem.constraint_residual();
            if (const auto factors = solver.factorize(matrix);
                factors.status != ancf::Status::converged)
                return factors.status;
            solver.solve(rhs, change);
            a += change.head(problem.size()) / (h * h * beta);
            lambda += change.tail(problem.multipliers());
            largest = problem.largest_ratio(change.head(problem.size()));
        }
        if (!(largest < 1e-10)) return ancf::Status::max_iterations;
    }
    problem.store(end, q, v, lambda);
    return ancf::Status::converged;
}

int main() {
    const auto rubber = ancf::Material::isotropic(0.7e6, 0.3, 5540.0);  // Pa, 1, kg/m^3
    const auto section = ancf::rectangle(0.05, 0.05);                   // m
    ancf::PlanarModel model;
    const auto beam =
        ancf::straight_beam<ancf::CrossSectionBeam<2>>(model, rubber, section, {0, 0}, {1.2, 0}, 4);
    model.add(ancf::Pin<2>(beam.first(), {0.0, 0.0}));  // a constraint: two multipliers
    ancf::add_kelvin_voigt(model, beam, 1e-3);          // s
    model.set_gravity({0.0, -9.81});                    // m/s^2
    ancf::PlanarModel other = model;

    ancf::EigenLu solver;
    ancf::DynamicProblem problem(model), same(other);
    const auto status = integrate_hht(problem, solver, 0.5, 1000);
    const auto report =
        ancf::RadauIIA().integrate(same, solver, ancf::equal_intervals(0.0, 0.5, 0.5));
    const auto tip = model.position(beam.last()), expected = other.position(beam.last());
    std::cout << to_string(status) << ", tip " << tip.transpose() << " m\n"
              << to_string(report.status) << ", tip " << expected.transpose() << " m by RadauIIA\n";
    const double force = model.state().multipliers[1], right = other.state().multipliers[1];
    std::cout << "force on the pin " << force << " N, " << right << " N by RadauIIA\n";

    const bool good = (tip - expected).norm() < 1e-4 && std::abs(force / right - 1.0) < 1e-4;
    return status == ancf::Status::converged && report.status == status && good ? 0 : 1;
}
