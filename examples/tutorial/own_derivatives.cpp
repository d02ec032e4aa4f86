// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Compares the derivatives that parts of one's own give with differences of what they give.

#include <ancf/dynamics/problem.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

/// Compares the derivatives of a scene with central differences, and prints those that differ.
/// @param reach  how far beside the model's state: a part of the scene's size, and of slopes.
/// @return the largest difference, relative to the largest entry of its matrix.
double check_derivatives(ancf::Scene& model, double reach = 0.1) {
    ancf::DynamicProblem problem(model);
    const int n = problem.size(), m = problem.multipliers();
    const ancf::VectorX unit = problem.scales();  // the scene's size; of slopes 1
    ancf::VectorX q;
    problem.numbering().gather_free(model.state().q, q);
    q += reach * unit.cwiseProduct(ancf::VectorX::Random(n));
    const ancf::VectorX v = unit.cwiseProduct(ancf::VectorX::Random(n));
    const ancf::VectorX lambda = ancf::VectorX::Random(m);
    const double t = model.state().time + 0.1, h = 1e-5;
    double worst = 0.0;
    const auto compare = [&](const char* what, const ancf::MatrixX& given,
                             const ancf::MatrixX& wanted) {
        if (wanted.size() == 0) return;
        Eigen::Index row = 0, column = 0;
        const double most = (given - wanted).cwiseAbs().maxCoeff(&row, &column);
        const double error = most / std::max(wanted.cwiseAbs().maxCoeff(), 1e-30);
        if (error > 1e-6)
            std::cout << what << ", entry (" << row << ", " << column << "): " << given(row, column)
                      << ", differences give " << wanted(row, column) << '\n';
        worst = std::max(worst, error);
    };
    // r of all free coordinates, g, and the strain energy
    const auto values = [&](double time, const ancf::VectorX& at, const ancf::VectorX& rate) {
        ancf::VectorX all(n + m + 1);
        if (problem.evaluate(time, at, rate, lambda, ancf::Request::force)) all.setZero();
        all << problem.force(), problem.constraint_residual(), problem.energies().strain;
        return all;
    };
    const auto constraint_rate = [&](double time, const ancf::VectorX& at) {
        problem.evaluate_constraints(time, at, v);
        return ancf::VectorX(problem.constraints().rate());
    };
    ancf::MatrixX by_q(n + m + 1, n), by_v(n + m + 1, n);
    for (int j = 0; j < n; ++j) {
        const ancf::VectorX step = h * ancf::VectorX::Unit(n, j) * unit[j];
        by_q.col(j) = (values(t, q + step, v) - values(t, q - step, v)) / (2.0 * step[j]);
        by_v.col(j) = (values(t, q, v + step) - values(t, q, v - step)) / (2.0 * step[j]);
    }
    const ancf::VectorX along =
        (values(t + h, q + h * v, v) - values(t - h, q - h * v, v)) / (2 * h);
    const ancf::VectorX turning =
        (constraint_rate(t + h, q + h * v) - constraint_rate(t - h, q - h * v)) / (2.0 * h);

    if (problem.evaluate(t, q, v, lambda, ancf::Request::tangent_and_damping)) return HUGE_VAL;
    const ancf::MatrixX tangent = problem.tangent(), damping = problem.damping();
    ancf::VectorX elastic;
    problem.numbering().gather_free(problem.assembly().internal_force(), elastic);
    problem.evaluate_constraints(t, q, v);
    compare("force of elements", elastic, by_q.row(n + m).transpose());
    compare("tangent or stiffness", tangent.topLeftCorner(n, n), by_q.topRows(n));
    compare("jacobian", tangent.bottomLeftCorner(m, n), by_q.middleRows(n, m));
    compare("damping", damping.topLeftCorner(n, n), by_v.topRows(n));
    compare("rate", problem.constraints().rate(), along.segment(n, m));
    compare("convection", problem.constraint_convection(), turning);
    return worst;
}

/// Attracts a node with the force s/d^2 at the distance d.
struct Magnet {
    ancf::NodeId node;
    ancf::Vector<double, 2> place;  // m
    double strength;                // N m^2
    double mistake = 1.0;

    ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        const ancf::Vector<double, 2> way = place - at.q;
        const double d = way.norm(), k = strength / (d * d * d);
        out.force = k * way;
        out.stiffness = mistake * 3.0 * k / (d * d) * way * way.transpose();
        out.stiffness.diagonal().array() -= k;
    }
};

/// Keeps a node on the wave y = a sin(x/b - w t).
struct Wave {
    ancf::NodeId node;
    double a, b, w;  // m, m, rad/s
    double mistake = 1.0;

    ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
    int equations() const { return 1; }
    std::string name() const { return "wave"; }
    void evaluate(const ancf::ConstraintState& at, ancf::ConstraintResult& out) const {
        const double phase = at.q[0] / b - w * at.time, turn = at.v[0] / b - w;
        out.violation[0] = at.q[1] - a * std::sin(phase);
        out.jacobian << -a / b * std::cos(phase), 1.0;
        out.stiffness(0, 0) = a / (b * b) * std::sin(phase) * at.multipliers[0];
        out.rate[0] = a * w * std::cos(phase);
        out.convection[0] = mistake * a * turn * turn * std::sin(phase);
    }
};

/// A cantilever with both at its tip.
double check(double mistake_of_magnet, double mistake_of_wave) {
    const auto rubber = ancf::Material::isotropic(0.7e6, 0.3, 5540.0);  // Pa, 1, kg/m^3
    ancf::PlanarModel model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
        model, rubber, ancf::rectangle(0.05, 0.05), {0, 0}, {1, 0}, 2);
    model.clamp(beam.first());
    model.add(Magnet{beam.last(), {1.0, 1.0}, 100.0, mistake_of_magnet});
    model.add(Wave{beam.last(), 0.2, 0.3, 5.0, mistake_of_wave});
    return check_derivatives(model);
}

int main() {
    const double right = check(1.0, 1.0);
    std::cout << "without a mistake " << right << '\n';
    const double wrong_stiffness = check(-1.0, 1.0), wrong_convection = check(1.0, 0.5);
    return right < 1e-6 && wrong_stiffness > 1e-3 && wrong_convection > 1e-3 ? 0 : 1;
}
