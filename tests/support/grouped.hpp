// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A locale that groups digits one by one.

#pragma once

#include <locale>
#include <string>

namespace ancf::test {

struct Grouped : std::numpunct<char> {
    std::string do_grouping() const override { return "\1"; }
};

/// Returns the classic locale with that grouping.
[[nodiscard]] inline std::locale grouped() {
    return std::locale(std::locale::classic(), new Grouped);
}

}  // namespace ancf::test
