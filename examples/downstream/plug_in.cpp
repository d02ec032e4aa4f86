// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A linear solver, a constraint and a load of one's own in the statics of ancf.
///
///     clamp |=========o   the tip slides along the track x = L - a y^2, pulled by a magnet
///                     )   beside it
///
/// - `Gauss` eliminates in a dense matrix with pivots: a class derived from ancf::LinearSolver.
/// - `Track` is one equation on the position of a node.
/// - `Magnet` attracts a node in inverse proportion to the square of the distance.
///
/// Constraint and load have no base class. The same file compiles header-only and with
/// ancf::compiled.
///
/// The program checks itself: Newton's method converges in few steps, which a wrong derivative of
/// the track would prevent; the magnet's stiffness is the derivative of its force; the tip is on
/// the track; and ancf's own solver gives the same equilibrium.

#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/statics.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>

namespace {

using Point = ancf::Vector<double, 2>;

/// Gaussian elimination with partial pivoting, in place.
class Gauss final : public ancf::LinearSolver {
public:
    [[nodiscard]] ancf::Storage storage() const noexcept override { return ancf::Storage::full; }

    void analyze(const ancf::SparseMatrix& matrix) override {
        size_ = static_cast<int>(matrix.cols());
    }

    [[nodiscard]] ancf::FactorReport factorize(const ancf::SparseMatrix& matrix) override {
        ancf::FactorReport report;
        factors_ = matrix;
        order_.setLinSpaced(size_, 0, size_ - 1);
        for (int k = 0; k < size_; ++k) {
            Eigen::Index pivot = 0;
            const double largest = factors_.col(k).tail(size_ - k).cwiseAbs().maxCoeff(&pivot);
            if (!std::isfinite(largest)) report.status = ancf::Status::not_finite;
            if (largest == 0.0) report.status = ancf::Status::singular;
            if (report.status != ancf::Status::converged) {
                report.failed_column = k;
                return report;
            }
            factors_.row(k).swap(factors_.row(k + pivot));
            std::swap(order_[k], order_[k + pivot]);
            const int rest = size_ - k - 1;
            factors_.col(k).tail(rest) /= factors_(k, k);
            factors_.bottomRightCorner(rest, rest).noalias() -=
                factors_.col(k).tail(rest) * factors_.row(k).tail(rest);
        }
        return report;
    }

    void solve(const ancf::VectorX& b, ancf::VectorX& x) const override {
        ancf::VectorX y = b(order_);
        for (int k = 0; k < size_; ++k)
            y.tail(size_ - k - 1) -= y[k] * factors_.col(k).tail(size_ - k - 1);
        for (int k = size_ - 1; k >= 0; --k) {
            y[k] /= factors_(k, k);
            y.head(k) -= y[k] * factors_.col(k).head(k);
        }
        x = std::move(y);
    }

    [[nodiscard]] std::string_view name() const noexcept override { return "gauss"; }

private:
    int size_ = 0;
    ancf::MatrixX factors_;
    Eigen::VectorXi order_;
};

/// Keeps a node on the curve x = x0 - a y^2.
struct Track {
    ancf::NodeId node;
    double x0, a;  // m, 1/m

    [[nodiscard]] double violation(const Point& r) const { return r[0] - x0 + a * r[1] * r[1]; }

    [[nodiscard]] ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
    [[nodiscard]] static int equations() { return 1; }
    [[nodiscard]] static std::string name() { return "track"; }

    void evaluate(const ancf::ConstraintState& at, ancf::ConstraintResult& out) const {
        out.violation[0] = violation(at.q);
        out.jacobian << 1.0, 2.0 * a * at.q[1];
        out.stiffness(1, 1) = 2.0 * a * at.multipliers[0];
        out.convection[0] = 2.0 * a * at.v[1] * at.v[1];
    }
};

/// Attracts a node with the force strength/d^2 at the distance d.
struct Magnet {
    ancf::NodeId node;
    Point place;      // m
    double strength;  // N m^2

    static constexpr bool symmetric_stiffness = true;

    [[nodiscard]] ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }

    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        const Point way = place - at.q;
        const double d = way.norm();
        out.force = strength / (d * d * d) * way;
        out.stiffness =
            strength / (d * d * d) *
            (3.0 / (d * d) * way * way.transpose() - ancf::Matrix<double, 2>::Identity());
        out.potential = -strength / d;
    }
};

struct Result {
    ancf::StaticsReport report;
    Point tip;
    double off_track;  // m
};

/// Bends the beam with a given linear solver.
Result bend(ancf::LinearSolver& solver) {
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);
    const auto section = ancf::rectangle(0.01, 0.01);
    ancf::PlanarModel model;
    const auto beam =
        ancf::straight_beam<ancf::CrossSectionBeam<2>>(model, steel, section, {0, 0}, {2, 0}, 8);
    model.clamp(beam.first());
    const Track track{beam.last(), 2.0, 0.5};
    model.add(track);
    model.add(Magnet{beam.last(), Point(2.0, 2.0), 150.0});
    Result result;
    ancf::StaticsOptions options;
    options.steps = 4;
    result.report = ancf::solve_statics(model, solver, options);
    result.tip = model.position(beam.last());
    result.off_track = track.violation(result.tip);
    return result;
}

/// Returns the largest difference between the magnet's stiffness and the differences of its force.
double stiffness_error(const Magnet& magnet, const Point& place) {
    const auto at = [&](const Point& q) {
        ancf::LoadResult out;
        out.force.setZero(2);
        out.stiffness.setZero(2, 2);
        magnet.evaluate({q, Point::Zero(), 1.0}, out);
        return out;
    };
    constexpr double step = 1e-5;
    double error = 0.0;
    for (int k = 0; k < 2; ++k) {
        const Point side = step * Point::Unit(k);
        const Point difference = (at(place + side).force - at(place - side).force) / (2.0 * step);
        error = std::max(error, (at(place).stiffness.col(k) - difference).norm());
    }
    return error;
}

}  // namespace

int main() try {
    Gauss gauss;
    ancf::EigenLu lu;
    const Result ours = bend(gauss);
    const Result theirs = bend(lu);
    const double stiff = stiffness_error({{0}, {2.0, 2.0}, 150.0}, {1.8, 0.3});
    std::cout << "status " << to_string(ours.report.status) << " after " << ours.report.iterations()
              << " iterations in " << ours.report.steps.size() << " steps\ntip "
              << ours.tip.transpose() << " m, off the track by " << ours.off_track
              << " m, from the library's solver by " << (ours.tip - theirs.tip).norm()
              << " m\nthe magnet's stiffness is off by " << stiff << " N/m\n";
    const bool good = ours.report.status == ancf::Status::converged &&
                      theirs.report.status == ancf::Status::converged &&
                      ours.report.iterations() <= 40 && ours.tip[1] > 0.2 &&
                      std::abs(ours.off_track) <= 1e-10 && (ours.tip - theirs.tip).norm() <= 1e-9 &&
                      stiff <= 1e-6;  // the step leaves 1e-8
    return good ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
