// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Comma-separated values: one header line, then rows of numbers and words.
///
/// Numbers carry 17 significant digits, so that reading them back gives the same bits, and a
/// decimal point whatever the locale. Not-a-number and infinities print as nan, inf and -inf.

#pragma once

#include <ancf/list.hpp>

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>
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
    void row(const Values&... values) {
        check(sizeof...(Values));
        write({cell(values)...});
    }

    /// Writes a row of numbers.
    /// @throws InvalidArgument for another number of values.
    void row(const std::vector<double>& values);
    /// The same for a List.
    void row(const List<double>& values) { row(std::vector<double>(values)); }

private:
    template <class Value>
    [[nodiscard]] static std::string cell(const Value& value) {
        if constexpr (std::is_floating_point_v<Value>)
            return number_text(static_cast<double>(value));
        else if constexpr (std::is_integral_v<Value>)
            return std::to_string(value);
        else
            return word(value);
    }
    [[nodiscard]] static std::string word(std::string_view value);
    void check(std::size_t values) const;
    void write(const std::vector<std::string>& cells);

    std::ostream& out_;
    std::vector<std::string> columns_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/output/csv.ipp>  // IWYU pragma: export
#endif
