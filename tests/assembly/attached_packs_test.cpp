// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Elements with attached vectors, several at once against one by one.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <assembly/element_groups.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <vector>

namespace attached_packs_test {

using namespace ancf;

template <class Element, int Dimension>
void compare(const std::vector<typename BasicModel<Dimension>::Point>& points,
             const std::vector<Member>& members) {
    BasicModel<Dimension> shared;
    const auto built = frame<Element>(
        shared, {{Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.02, 0.02)}}, points, members);
    shared.clamp(built.joints[0]);
    BasicModel<Dimension> own = shared;
    const int elements = own.template group<Element>().size();
    REQUIRE(elements > 16);
    for (int k = 0; k < elements; ++k) own.template make_own_prototype<Element>(k);
    REQUIRE(shared.template group<Element>().prototype_count() == 1);
    REQUIRE(own.template group<Element>().prototype_count() == elements);
    test::Random random(5);
    VectorX q = shared.state().q;
    for (double& entry : q) entry += 1e-2 * random.uniform(-1.0, 1.0);
    shared.dependence().complete(q);
    const VectorX still = VectorX::Zero(q.size()), none;
    for (const Storage storage : {Storage::lower, Storage::full}) {
        Assembly packs(shared, storage), single(own, storage);
        REQUIRE_FALSE(packs.evaluate({q, still, none, {}}, Request::tangent));
        REQUIRE_FALSE(single.evaluate({q, still, none, {}}, Request::tangent));
        // round-off of another order of summation; measured 2e-16
        const VectorX difference = packs.internal_force() - single.internal_force();
        CHECK(difference.cwiseAbs().maxCoeff() <=
              1e-13 * single.internal_force().cwiseAbs().maxCoeff());
        const SparseMatrix tangent = packs.tangent() - single.tangent();
        CHECK(MatrixX(tangent).cwiseAbs().maxCoeff() <=
              1e-13 * MatrixX(single.tangent()).cwiseAbs().maxCoeff());
        CHECK(packs.strain_energy() == Approx(single.strain_energy()).epsilon(1e-13));
    }
}

TEST_CASE("attachments: several elements at once give what they give one by one",
          "[assembly][attachment]") {
    SECTION("in space") {
        std::vector<Vector<double, 3>> points;
        std::vector<Member> members;
        const auto place = [](int i, int j, int k) { return i + 3 * (j + 3 * k); };
        for (int k = 0; k < 2; ++k)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) {
                    points.emplace_back(0.5 * i, 0.5 * j, 0.5 * k);
                    if (i > 0) members.push_back({place(i - 1, j, k), place(i, j, k)});
                    if (j > 0) members.push_back({place(i, j - 1, k), place(i, j, k)});
                    if (k > 0) members.push_back({place(i, j, k - 1), place(i, j, k)});
                }
        compare<CrossSectionBeam<3>, 3>(points, members);
    }
    SECTION("in the plane") {
        std::vector<Vector<double, 2>> points;
        std::vector<Member> members;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                points.emplace_back(0.5 * i, 0.5 * j);
                if (i > 0) members.push_back({4 * j + i - 1, 4 * j + i});
                if (j > 0) members.push_back({4 * j + i - 4, 4 * j + i});
            }
        compare<CrossSectionBeam<2>, 2>(points, members);
    }
}

}  // namespace attached_packs_test
