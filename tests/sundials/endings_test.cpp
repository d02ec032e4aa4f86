// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Every status of IDA and ARKODE but `converged` comes with a message.

#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/ida.hpp>

#include <support/endings.hpp>

namespace sundials_endings_test {

using namespace ancf;
using namespace ancf::test;
using sundials::Explicit;
using sundials::ExplicitOptions;
using sundials::Form;
using sundials::Ida;
using sundials::IdaOptions;

template <class Integrator>
auto run_by(const Integrator& integrator) {
    return [=](PlanarModel& model, const Schedule& schedule) {
        DynamicProblem problem(model);
        return integrator.integrate(problem, schedule);
    };
}

template <class Integrator>
void check_limit(const Integrator& integrator, Status expected) {
    PlanarModel model = cantilever(Scale{});
    Schedule schedule;
    schedule.end = 2e-4;
    const auto report = run_by(integrator)(model, schedule);
    check_ending("limit", report.status, report.message, {expected});
}

TEST_CASE("endings: IDA says why it stopped", "[ida][endings]") {
    IdaOptions options;
    options.tolerance = 1e-4;
    for (const Form form : {Form::index3, Form::gear_gupta_leimkuhler}) {
        options.form = form;
        check_motions(run_by(Ida(options)));
        check_constrained_motions(run_by(Ida(options)));
    }
    options.max_steps = 2;
    check_limit(Ida(options), Status::max_iterations);
}

TEST_CASE("endings: explicit methods say why they stopped", "[explicit][endings]") {
    check_motions(run_by(Explicit()), false);
    ExplicitOptions options;
    options.max_steps = 2;
    check_limit(Explicit(options), Status::max_iterations);
    options = {};
    options.step = 1e-4;
    check_limit(Explicit(options), Status::diverged);
}

}  // namespace sundials_endings_test
