// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Tables for people, and the comparison of results with published values.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/solver/statics.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace examples {

/// Returns a number with a fixed count of decimals.
inline std::string fixed(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

/// Returns a number with two digits and an exponent.
inline std::string scientific(double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.1e", value);
    return text;
}

/// Columns of text, aligned to the right.
class Table {
public:
    explicit Table(std::vector<std::string> header) { rows_.push_back(std::move(header)); }

    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    void print(std::ostream& out) const {
        std::vector<std::size_t> width(rows_.front().size(), 0);
        for (const auto& row : rows_)
            for (std::size_t k = 0; k < row.size(); ++k)
                width[k] = std::max(width[k], row[k].size());
        for (const auto& row : rows_) {
            for (std::size_t k = 0; k < row.size(); ++k)
                out << (k == 0 ? "" : "  ") << std::setw(static_cast<int>(width[k])) << row[k];
            out << '\n';
        }
    }

private:
    std::vector<std::vector<std::string>> rows_;
};

/// Rows that go out as CSV at once, or as a table for people at the end.
class Sheet {
public:
    Sheet(bool csv, std::vector<std::string> csv_columns, std::vector<std::string> table_columns)
        : table_(std::move(table_columns)) {
        if (csv) csv_.emplace(std::cout, std::move(csv_columns));
    }

    template <class... Values>
    void add_csv(const Values&... values) {
        if (csv_) csv_->row(values...);
    }

    void add_table(std::vector<std::string> row) { table_.add(std::move(row)); }

    /// Prints the table under its title, unless CSV was asked for.
    void finish(const std::string& title) const {
        if (csv_) return;
        std::cout << title << '\n';
        table_.print(std::cout);
    }

private:
    std::optional<ancf::CsvWriter> csv_;
    Table table_;
};

/// A published pair of numbers for one element and mesh.
struct Published {
    const char* element;
    int elements;
    double first;
    double second;
};

/// Returns the entry of an element and mesh, or nullptr.
template <class Entries>
const Published* find(const Entries& entries, const std::string& element, int elements) {
    const auto at =
        std::find_if(std::begin(entries), std::end(entries), [&](const Published& entry) {
            return element == entry.element && elements == entry.elements;
        });
    return at == std::end(entries) ? nullptr : &*at;
}

/// Beyond this turn of an element from end to end, rad, a mesh is told to be coarse.
inline constexpr double coarse_turn = 1.0;

/// Keeps account of what a program found, for its exit code.
class Verdict {
public:
    /// Records whether a static solution converged, and says on stderr how Newton's method went:
    /// the last four residuals of the last load step.
    void add(int elements, const ancf::StaticsReport& report);

    /// Returns how far a pair of numbers is from the published one, and records whether that is
    /// within the tolerance.
    double deviation(const Published& published, double first, double second, double tolerance) {
        const double most =
            std::max(std::abs(first - published.first), std::abs(second - published.second));
        if (!(most <= tolerance)) {
            good_ = false;
            std::cerr << published.element << ", " << published.elements
                      << (published.elements == 1 ? " element" : " elements")
                      << ": the published value is missed by " << scientific(most) << ", tolerance "
                      << scientific(tolerance) << '\n';
        }
        return most;
    }

    [[nodiscard]] bool good() const noexcept { return good_; }

private:
    bool good_ = true;
};

inline void Verdict::add(int elements, const ancf::StaticsReport& report) {
    good_ = good_ && report.status == ancf::Status::converged;
    std::ostringstream text;
    text << elements << (elements == 1 ? " element: " : " elements: ") << to_string(report.status);
    if (report.steps.size() != 1) text << " after " << report.steps.size() << " load steps";
    text << ", " << report.iterations() << " iterations";
    if (report.fault && report.fault->element >= 0) text << ", element " << report.fault->element;
    if (!report.message.empty()) text << ", " << report.message;
    if (!report.steps.empty()) {
        const ancf::LoadStep& step = report.steps.back();
        text << ", last residuals";
        const std::size_t count = step.residuals.size();
        for (std::size_t k = count < 4 ? 0 : count - 4; k < count; ++k)
            text << ' ' << scientific(step.residuals[k]);
        if (step.at_round_off) text << " (round-off)";
    }
    if (report.stability == ancf::Stability::unstable)
        text << "; unstable: past a bifurcation or limit point, or on a branch of the mesh alone";
    int indefinite = 0;
    for (const ancf::LoadStep& step : report.steps) indefinite += step.indefinite;
    if (indefinite > 0)
        text << "; " << indefinite
             << " of the tangents on the way indefinite: smaller steps may end elsewhere";
    if (report.softened)
        text << "; element " << report.softened->element
             << " is so short that its law softens: smaller steps may end elsewhere";
    if (report.largest_turn > coarse_turn)
        text << "; an element turns by " << std::lround(report.largest_turn * 180.0 / ancf::pi)
             << " degrees from end to end: so coarse a mesh may have several equilibria";
    std::cerr << text.str() << '\n';
}

}  // namespace examples
