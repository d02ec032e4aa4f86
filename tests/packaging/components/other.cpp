// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/suitesparse/cholmod.hpp>
#include <ancf/suitesparse/umfpack.hpp>
#include <ancf/sundials/ida.hpp>

#include <string>

/// Returns what IDA says to a negative tolerance.
std::string refusal_of_ida() {
    ancf::sundials::IdaOptions options;
    options.tolerance = -1.0;
    try {
        const ancf::sundials::Ida ida(options);
    } catch (const ancf::InvalidArgument& error) {
        return error.what();
    }
    return {};
}
