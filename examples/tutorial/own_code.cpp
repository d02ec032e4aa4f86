// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Step 8 of the tutorial: the smallest element, linear solver, constraint and load of one's own.

#include <ancf/element/requirement.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/statics.hpp>

#include <Eigen/LU>

#include <cmath>
#include <iostream>

/// A bar: U = E A l eps^2/2, eps = (d.d/l^2 - 1)/2, d = r_2 - r_1.
struct Bar {
    double axial_stiffness, line_density, rest_length;  // E A in N, kg/m, m

    static constexpr int dimension = 2;
    static constexpr int dofs = 4;                          // two nodes, one vector, two components
    static constexpr ancf::Fields fields = ancf::Field::r;  // positions only
    using Coordinates = ancf::Vector<double, dofs>;

    double length() const { return rest_length; }
    bool admissible(const Coordinates& e) const { return e.allFinite(); }
    double energy(const Coordinates& e) const { return evaluate(e).energy; }
    Coordinates force(const Coordinates& e) const { return evaluate(e).force; }

    ancf::Evaluation<double, dofs> evaluate(const Coordinates& e) const {
        const ancf::Vector<double, 2> d = e.tail<2>() - e.head<2>();
        const double l = rest_length, eps = 0.5 * (d.squaredNorm() / (l * l) - 1.0);
        Coordinates slope;  // d eps/de
        slope << -d, d;
        slope /= l * l;
        ancf::Matrix<double, dofs> second;  // d2 eps/de2
        second << 1, 0, -1, 0, 0, 1, 0, -1, -1, 0, 1, 0, 0, -1, 0, 1;
        second /= l * l;
        return {0.5 * axial_stiffness * l * eps * eps, axial_stiffness * l * eps * slope,
                axial_stiffness * l * (slope * slope.transpose() + eps * second)};
    }

    ancf::Matrix<double, dofs> mass() const {
        ancf::Matrix<double, dofs> m;
        m << 2, 0, 1, 0, 0, 2, 0, 1, 1, 0, 2, 0, 0, 1, 0, 2;
        return line_density * rest_length / 6.0 * m;
    }

    Coordinates gravity(const ancf::Vector<double, 2>& g) const {
        return 0.5 * line_density * rest_length * Coordinates(g[0], g[1], g[0], g[1]);
    }
};

/// A dense factorisation.
class Dense final : public ancf::LinearSolver {
public:
    ancf::Storage storage() const noexcept override { return ancf::Storage::full; }
    void analyze(const ancf::SparseMatrix&) override {}
    ancf::FactorReport factorize(const ancf::SparseMatrix& matrix) override {
        lu_.compute(ancf::MatrixX(matrix));
        const bool good = lu_.rcond() > 1e-15;
        return {good ? ancf::Status::converged : ancf::Status::singular};
    }
    void solve(const ancf::VectorX& b, ancf::VectorX& x) const override { x = lu_.solve(b); }
    std::string_view name() const noexcept override { return "dense"; }

private:
    Eigen::PartialPivLU<ancf::MatrixX> lu_;
};

/// Holds a node on the line x = y: g = x - y, dg/dq = (1, -1).
struct Diagonal {
    ancf::NodeId node;
    ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
    int equations() const { return 1; }
    std::string name() const { return "diagonal"; }
    void evaluate(const ancf::ConstraintState& at, ancf::ConstraintResult& out) const {
        out.violation[0] = at.q[0] - at.q[1];
        out.jacobian << 1.0, -1.0;
    }
};

/// Pulls a node down with 1 N.
struct Weight {
    ancf::NodeId node;
    static constexpr bool constant_force = true;
    ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
    void evaluate(const ancf::LoadState&, ancf::LoadResult& out) const { out.force[1] = -1.0; }
};

int main() {
    ancf::PlanarModel model;
    const auto fixed = model.add_node({0.0, 0.0}), free = model.add_node({1.0, 1.0});
    const double l = std::sqrt(2.0), axial = 1000.0;  // m, N
    model.connect<Bar>(model.add_prototype(Bar{axial, 1.0, l}), fixed, free);
    model.pin(fixed);
    model.add(Diagonal{free});
    model.add(Weight{free});

    Dense solver;
    const auto report = ancf::solve_statics(model, solver);
    const auto tip = model.position(free);
    std::cout << to_string(report.status) << ", node at " << tip.transpose() << " m, multiplier "
              << model.state().multipliers << " N\n";

    // along the diagonal the bar carries N = E A eps (present length/l) = -sqrt(1/2) N
    const double stretch = tip.norm() / l;
    const double pull = axial * 0.5 * (stretch * stretch - 1.0) * stretch;
    return std::abs(pull + std::sqrt(0.5)) < 1e-8 && tip[0] == tip[1] ? 0 : 1;
}
