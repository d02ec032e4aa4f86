// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// What fits into the integers of SUNDIALS, whose width its build chose.

#include <ancf/sundials/context.hpp>

#include <support/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace index_test {

using ancf::sundials::detail::checked_index;

constexpr std::ptrdiff_t most = std::numeric_limits<std::int32_t>::max();

TEST_CASE("checked_index: 32 bits take 2147483647 entries and refuse one more by name",
          "[ida][index]") {
    CHECK(checked_index<std::int32_t>(0, "entries") == 0);
    CHECK(checked_index<std::int32_t>(most, "entries") == most);
    CHECK(checked_index<std::int64_t>(most + 1, "entries") == most + 1);
    std::string message;
    try {
        static_cast<void>(checked_index<std::int32_t>(most + 1, "entries of the Jacobian"));
    } catch (const ancf::InvalidArgument& error) {
        message = error.what();
    }
    CHECK(message ==
          "2147483648 entries of the Jacobian; this build of SUNDIALS counts them by 32 "
          "bits and takes at most 2147483647");
}

TEST_CASE("make_vector and make_matrix: a size beyond the integers of SUNDIALS is refused",
          "[ida][index]") {
    if (sizeof(sunindextype) > sizeof(std::int32_t)) {
        WARN("this build of SUNDIALS has integers of 64 bits: no size is beyond them");
        return;
    }
    const ancf::sundials::Context context;
    CHECK_THROWS_AS(ancf::sundials::make_vector(context, most + 1), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::sundials::make_matrix(context, most + 1, 1), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::sundials::make_matrix(context, 1, most + 1), ancf::InvalidArgument);
}

}  // namespace index_test
