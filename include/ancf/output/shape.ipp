// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/output/shape.hpp>

#include <ostream>
#include <string>

namespace ancf {

ANCF_INLINE void write_shape(std::ostream& out, const std::vector<ShapeStation>& shape) {
    detail::require(!shape.empty(), "write_shape: the shape needs at least one station, got none");
    std::vector<std::string> columns = {"s", "x", "y", "z"};
    for (std::size_t k = 0; k < shape.front().outline.size(); ++k)
        for (const char* axis : {"x", "y", "z"}) columns.push_back(axis + std::to_string(k));
    CsvWriter csv(out, columns);
    for (const ShapeStation& station : shape) {
        std::vector<double> row = {station.s, station.centre[0], station.centre[1],
                                   station.centre[2]};
        for (const auto& point : station.outline) row.insert(row.end(), point.begin(), point.end());
        csv.row(row);
    }
}

}  // namespace ancf
