// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Comma-separated values: one header line, then rows of numbers and words.
///
/// Numbers carry 17 significant digits, so that reading them back gives the same bits, and a
/// decimal point whatever the locale. Not-a-number and infinities print as nan, inf and -inf.

#pragma once

#include <ancf/error.hpp>

#include <cmath>
#include <cstddef>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

/// Returns a number as text: 17 significant digits unless told otherwise, decimal point.
/// @throws InvalidArgument unless 1 <= digits <= 17.
[[nodiscard]] std::string number_text(double value, int digits = 17);

/// Writes rows under a header.
///
///     ancf::CsvWriter csv(std::cout, {"elements", "status", "x"});
///     csv.row(4, "converged", 1.78);
class CsvWriter {
public:
    /// Writes the header. The stream outlives the writer.
    /// @throws InvalidArgument for no column, or a name that would need quotes.
    CsvWriter(std::ostream& out, std::vector<std::string> columns);

    /// Writes a row of one value per column: floating point, integers and words.
    /// @throws InvalidArgument for another number of values, or a word that would need quotes.
    template <class... Values>
    void row(const Values&... values);

    /// Writes a row of numbers.
    /// @throws InvalidArgument for another number of values.
    void row(const std::vector<double>& values);

    /// Returns the number of columns.
    [[nodiscard]] const std::vector<std::string>& columns() const noexcept { return columns_; }

private:
    template <class Value>
    [[nodiscard]] static std::string cell(const Value& value);
    void write(const std::vector<std::string>& cells);

    std::ostream& out_;
    std::vector<std::string> columns_;
};

namespace detail {

inline const std::string& require_plain(const std::string& word) {
    require(word.find_first_of(",\"\r\n") == std::string::npos,
            "CsvWriter: a word must not contain a comma, a quote or a line break, got ", word);
    return word;
}

}  // namespace detail

inline std::string number_text(double value, int digits) {
    detail::require(digits >= 1 && digits <= 17, "number_text: digits must lie in [1, 17], got ",
                    digits);
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value < 0.0 ? "-inf" : "inf";
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    text << value;
    return text.str();
}

inline CsvWriter::CsvWriter(std::ostream& out, std::vector<std::string> columns)
    : out_(out), columns_(std::move(columns)) {
    detail::require(!columns_.empty(), "CsvWriter: at least one column is needed, got none");
    for (const std::string& name : columns_) detail::require_plain(name);
    write(columns_);
}

template <class Value>
std::string CsvWriter::cell(const Value& value) {
    if constexpr (std::is_floating_point_v<Value>)
        return number_text(static_cast<double>(value));
    else if constexpr (std::is_integral_v<Value>)
        return std::to_string(value);
    else
        return detail::require_plain(std::string(std::string_view(value)));
}

template <class... Values>
void CsvWriter::row(const Values&... values) {
    detail::require(sizeof...(Values) == columns_.size(), "CsvWriter: there are ", columns_.size(),
                    " columns, got ", sizeof...(Values), " values");
    write({cell(values)...});
}

inline void CsvWriter::row(const std::vector<double>& values) {
    detail::require(values.size() == columns_.size(), "CsvWriter: there are ", columns_.size(),
                    " columns, got ", values.size(), " values");
    std::vector<std::string> cells;
    cells.reserve(values.size());
    for (const double value : values) cells.push_back(number_text(value));
    write(cells);
}

inline void CsvWriter::write(const std::vector<std::string>& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k) out_ << (k == 0 ? "" : ",") << cells[k];
    out_ << '\n';
}

}  // namespace ancf
