// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>
#include <ancf/output/csv.hpp>

#include <support/catch.hpp>

#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace csv_test {

struct CommaDecimals : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST_CASE("CsvWriter: the header stands alone on the first line, exactly as given", "[output]") {
    std::ostringstream out;
    ancf::CsvWriter csv(out, {"element", "elements", "x"});
    CHECK(out.str() == "element,elements,x\n");
    csv.row("cross-section", 4, 0.5);
    csv.row(std::string("continuum"), 16L, -1);
    CHECK(out.str() == "element,elements,x\ncross-section,4,0.5\ncontinuum,16,-1\n");
}

TEST_CASE("number_text: reading 17 digits back gives the same bits", "[output]") {
    for (const double value : {0.1, 1.0 / 3.0, -1.7841133235, 6.02214076e23, 4.9e-324,
                               std::numeric_limits<double>::max(), 0.0}) {
        const std::string text = ancf::number_text(value);
        INFO(text);
        CHECK(std::strtod(text.c_str(), nullptr) == value);
    }
    CHECK(ancf::number_text(2.0 / 3.0, 4) == "0.6667");
}

TEST_CASE("number_text: what is no number has one spelling", "[output]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK(ancf::number_text(std::numeric_limits<double>::quiet_NaN()) == "nan");
    CHECK(ancf::number_text(-std::numeric_limits<double>::quiet_NaN()) == "nan");
    CHECK(ancf::number_text(infinity) == "inf");
    CHECK(ancf::number_text(-infinity) == "-inf");
}

TEST_CASE("number_text: the locale of the program changes no file", "[output]") {
    const std::locale before =
        std::locale::global(std::locale(std::locale::classic(), new CommaDecimals));
    const std::string text = ancf::number_text(12345.5);
    std::ostringstream out;
    ancf::CsvWriter(out, {"a"}).row(1234567);
    std::locale::global(before);
    CHECK(text == "12345.5");
    CHECK(out.str() == "a\n1234567\n");
}

TEST_CASE("messages: the locale of the program changes no number", "[output]") {
    const std::locale before =
        std::locale::global(std::locale(std::locale::classic(), new CommaDecimals));
    const std::string text = ancf::detail::joined({"got ", 12345.5, " of ", 1234567});
    std::locale::global(before);
    CHECK(text == "got 12345.5 of 1234567");
}

TEST_CASE("CsvWriter: a row of another length is refused with both numbers", "[output]") {
    std::ostringstream out;
    ancf::CsvWriter csv(out, {"a", "b"});
    CHECK_THROWS_WITH(csv.row(1.0), ContainsSubstring("2 columns, got 1"));
    CHECK_THROWS_WITH(csv.row(std::vector<double>(3, 0.0)), ContainsSubstring("2 columns, got 3"));
    CHECK(out.str() == "a,b\n");
}

TEST_CASE("CsvWriter: words that would break a line are refused by name", "[output]") {
    std::ostringstream out;
    CHECK_THROWS_AS(ancf::CsvWriter(out, {}), ancf::InvalidArgument);
    CHECK_THROWS_WITH(ancf::CsvWriter(out, {"a,b"}), ContainsSubstring("a,b"));
    ancf::CsvWriter csv(out, {"a"});
    CHECK_THROWS_WITH(csv.row("x\ny"), ContainsSubstring("x\ny"));
    CHECK_THROWS_WITH(csv.row("say \"x\""), ContainsSubstring("\"x\""));
    CHECK_THROWS_AS(ancf::number_text(1.0, 0), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::number_text(1.0, 18), ancf::InvalidArgument);
}

}  // namespace csv_test
