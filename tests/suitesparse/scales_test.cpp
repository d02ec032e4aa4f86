// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/statics.hpp>
#include <ancf/suitesparse/klu.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <support/scaled_motions.hpp>

#include <cstdlib>

namespace suitesparse_scales_test {

using namespace ancf::test;
using ancf::suitesparse::Klu;
using ancf::suitesparse::Umfpack;

/// Newton's iterations in statics; the tip's place is checked to be that of unit scales.
template <class Solver, class Make>
void check_statics(const Make& make, double base, long apart) {
    const auto solve = [&](const Scale& scale, double& tip) {
        auto model = make(scale);
        Solver solver;
        const auto report = ancf::solve_statics(model, solver);
        CAPTURE(report.message);
        CHECK(report.status == ancf::Status::converged);
        tip = model.position({model.nodes() - 1})[1] / scale.length;
        return static_cast<long>(report.iterations());
    };
    double there = 0.0;
    const long wanted = solve(Scale{}, there);
    int checked = 0;
    for (const Scale& scale : powers_of(base)) {
        INFO(scale);
        double tip = 0.0;
        CHECK(std::abs(solve(scale, tip) - wanted) <= apart);
        CHECK(tip == Approx(there).epsilon(1e-7).margin(1e-9));
        ++checked;
    }
    CHECK(checked == 11);
}

TEMPLATE_TEST_CASE("scales: statics take the same iterations in any units by KLU and UMFPACK",
                   "[statics][scales]", Klu, Umfpack) {
    for (const double base : {2.0, 1e3, 1e9}) {
        CAPTURE(base);
        const long apart = base == 2.0 ? 0 : 1;
        check_statics<TestType>([](const Scale& s) { return cantilever(s); }, base, apart);
        check_statics<TestType>([](const Scale& s) { return linkage(s); }, base, apart);
        check_statics<TestType>([](const Scale& s) { return elbow(s); }, base, apart);
    }
}

TEMPLATE_TEST_CASE("scales: integrators take the same steps and iterations by KLU and UMFPACK",
                   "[dynamics][scales]", Klu, Umfpack) {
    for (const double base : {2.0, 1e3, 1e9}) {
        CAPTURE(base);
        const bool exactly = base == 2.0;
        check_integrators<TestType>([](const Scale& s) { return cantilever(s); }, 1e-4, base,
                                    exactly);
        check_integrators<TestType>([](const Scale& s) { return linkage(s); }, 2e-4, base, exactly);
        check_integrators<TestType>([](const Scale& s) { return elbow(s); }, 2e-4, base, exactly);
    }
}

}  // namespace suitesparse_scales_test
