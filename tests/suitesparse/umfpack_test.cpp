// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/suitesparse/umfpack.hpp>

#include <support/catch.hpp>

namespace umfpack_test {

using namespace ancf;
using namespace ancf::suitesparse;

TEST_CASE("Umfpack: options that cannot be meant are refused", "[suitesparse]") {
    UmfpackOptions options;
    options.refinement_steps = -1;
    CHECK_THROWS_WITH(Umfpack(options), ContainsSubstring("refinement_steps"));
    options.refinement_steps = 0;
    options.singular_rcond = 1.0;
    CHECK_THROWS_WITH(Umfpack(options), ContainsSubstring("singular_rcond"));
}

}  // namespace umfpack_test
