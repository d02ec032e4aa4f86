// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/sundials/context.hpp>

#include <support/catch.hpp>

#include <cmath>

using namespace ancf::sundials;

TEST_CASE("make_vector: sums and norms of clones, of any length", "[vectors]") {
    const Context context;
    for (const Eigen::Index size : {1, 15, 16, 17, 50}) {
        CAPTURE(size);
        const VectorOwner x = make_vector(context, size);
        const VectorOwner y(N_VClone(x.get())), z(N_VClone(x.get()));
        for (Eigen::Index i = 0; i < size; ++i) {
            view(x.get())[i] = std::sin(1.0 + static_cast<double>(i));
            view(y.get())[i] = std::cos(3.0 * static_cast<double>(i));
            view(z.get())[i] = 1.0 / (2.0 + static_cast<double>(i));
        }
        const ancf::VectorX a = view(x.get()), b = view(y.get()), c = view(z.get());

        CHECK(
            N_VWrmsNorm(x.get(), y.get()) ==
            Approx(a.cwiseProduct(b).norm() / std::sqrt(static_cast<double>(size))).epsilon(1e-14));

        double factors[] = {2.0, -0.5, 3.0};
        N_Vector vectors[] = {x.get(), y.get(), z.get()};
        REQUIRE(N_VLinearCombination(3, factors, vectors, x.get()) == 0);  // into the first
        CHECK((view(x.get()) - (2.0 * a - 0.5 * b + 3.0 * c)).lpNorm<Eigen::Infinity>() < 1e-14);
        CHECK(view(y.get()) == b);
        REQUIRE(N_VLinearCombination(1, factors, vectors + 2, y.get()) == 0);
        CHECK(view(y.get()) == 2.0 * c);
    }
}
