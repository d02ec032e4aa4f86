// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/version.hpp>

#include <support/catch.hpp>

#include <string>

namespace version_test {

TEST_CASE("version: the header, its numbers and the CMake project agree", "[architecture]") {
    CHECK(ancf::version == ANCF_PROJECT_VERSION);
    CHECK(ancf::version == std::to_string(ANCF_VERSION_MAJOR) + "." +
                               std::to_string(ANCF_VERSION_MINOR) + "." +
                               std::to_string(ANCF_VERSION_PATCH));
}

}  // namespace version_test
