// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/output/csv.hpp>

#include <charconv>
#include <cmath>
#include <ostream>
#include <utility>

namespace ancf {

ANCF_INLINE std::string number_text(double value, int digits) {
    detail::require(digits >= 1 && digits <= 17, "number_text: digits must lie in [1, 17], got ",
                    digits);
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value < 0.0 ? "-inf" : "inf";
    char text[32];
    return {text,
            std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

ANCF_INLINE CsvWriter::CsvWriter(std::ostream& out, std::vector<std::string> columns)
    : out_(out), columns_(std::move(columns)) {
    detail::require(!columns_.empty(), "CsvWriter: at least one column is needed, got none");
    for (const std::string& name : columns_) static_cast<void>(word(name));
    write(columns_);
}

ANCF_INLINE std::string CsvWriter::word(std::string_view value) {
    detail::require(value.find_first_of(",\"\r\n") == std::string_view::npos,
                    "CsvWriter: a word must not contain a comma, a quote or a line break, got ",
                    value);
    return std::string(value);
}

ANCF_INLINE void CsvWriter::check(std::size_t values) const {
    detail::require(values == columns_.size(), "CsvWriter: there are ", columns_.size(),
                    " columns, got ", values, " values");
}

ANCF_INLINE void CsvWriter::row(const std::vector<double>& values) {
    check(values.size());
    std::vector<std::string> cells;
    cells.reserve(values.size());
    for (const double value : values) cells.push_back(number_text(value));
    write(cells);
}

ANCF_INLINE void CsvWriter::write(const std::vector<std::string>& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k) out_ << (k == 0 ? "" : ",") << cells[k];
    out_ << '\n';
}

}  // namespace ancf
