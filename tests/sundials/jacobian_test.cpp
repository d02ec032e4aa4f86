// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// The Jacobian that IDA gets against central differences of the residual that it gets.

#include <ancf/dynamics/problem.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/sundials/context.hpp>
#include <ancf/sundials/ida.hpp>
#include <ancf/sundials/ida_system.hpp>

#include <sundials/scenes.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <sunmatrix/sunmatrix_sparse.h>

namespace jacobian_test {

using ancf::MatrixX;
using ancf::VectorX;
using namespace ancf_test;

/// A force against the velocity of a node: a load that depends on rates.
struct Damper {
    ancf::NodeId node;
    [[nodiscard]] ancf::Coupling coupling() const { return {{node, ancf::Field::r}}; }
    void evaluate(const ancf::LoadState& state, ancf::LoadResult& out) const {
        out.force = -7.0 * state.v;
        out.damping.diagonal().setConstant(-7.0);
    }
};

MatrixX dense(SUNMatrix matrix) {
    const auto size = SUNSparseMatrix_Columns(matrix);
    MatrixX out = MatrixX::Zero(size, size);
    for (sunindextype j = 0; j < size; ++j)
        for (sunindextype k = SUNSparseMatrix_IndexPointers(matrix)[j];
             k < SUNSparseMatrix_IndexPointers(matrix)[j + 1]; ++k)
            out(SUNSparseMatrix_IndexValues(matrix)[k], j) += SUNSparseMatrix_Data(matrix)[k];
    return out;
}

TEST_CASE("IdaSystem: the Jacobian is the derivative of the residual, also after SUNMatZero",
          "[ida][jacobian]") {
    using ancf::sundials::view;
    using System = ancf::sundials::detail::IdaSystem;
    const bool stabilised = GENERATE(false, true);  // index 3, and Gear, Gupta, Leimkuhler
    const bool repeated = GENERATE(false, true);
    CAPTURE(stabilised, repeated);
    Hanging scene = link_pendulum(2);
    scene.model->add(Damper{scene.beam.last()});
    if (repeated)
        scene.model->add(ancf::Distance<3>(scene.beam.first(), Point(0.0, 0.4, 0.0), 0.4));
    ancf::ProblemOptions least;
    least.redundancy = ancf::Redundancy::minimum_norm;
    ancf::DynamicProblem problem(*scene.model, least);
    REQUIRE(problem.start().status == ancf::Status::converged);
    REQUIRE(problem.left_out().size() == (repeated ? 1u : 0u));

    System system(problem, stabilised);
    ancf::sundials::Context context;
    const auto n = system.size();
    const auto y = ancf::sundials::make_vector(context, n);
    const auto dy = ancf::sundials::make_vector(context, n);
    const auto r = ancf::sundials::make_vector(context, n);
    const auto matrix = ancf::sundials::make_matrix(context, n, system.map().values());
    ancf::test::Random random(5);
    auto state = view(y.get());
    auto rate = view(dy.get());
    for (Eigen::Index i = 0; i < n; ++i) {
        state[i] = random.uniform(-0.1, 0.1);
        rate[i] = random.uniform(-1.0, 1.0);
    }
    ancf::VectorX q;
    problem.numbering().gather_free(scene.model->state().q, q);
    system.q(state) += q;
    system.lambda(state) *= 1e3;
    const double c = 37.0;

    SUNMatZero(matrix.get());
    REQUIRE(System::jacobian(0.0, c, y.get(), dy.get(), r.get(), matrix.get(), &system, nullptr,
                             nullptr, nullptr) == 0);
    const MatrixX jacobian = dense(matrix.get());

    // dF/dy + c dF/dy'
    const double step = 1e-6;
    MatrixX expected(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        VectorX side[2];
        for (int k = 0; k < 2; ++k) {
            const double h = k == 0 ? step : -step;
            state[j] += h;
            rate[j] += c * h;
            REQUIRE(System::residual(0.0, y.get(), dy.get(), r.get(), &system) == 0);
            side[k] = view(r.get());
            state[j] -= h;
            rate[j] -= c * h;
        }
        expected.col(j) = (side[0] - side[1]) / (2.0 * step);
    }
    REQUIRE(expected.norm() > 0.0);
    // row by row, as their units differ; 1e-8 measured, the error of the difference quotient
    for (Eigen::Index i = 0; i < n; ++i) {
        CAPTURE(i, n);
        CHECK((jacobian.row(i) - expected.row(i)).norm() <= 1e-6 * expected.row(i).norm());
    }
}

}  // namespace jacobian_test
