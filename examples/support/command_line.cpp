// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>

#include <support/command_line.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>

namespace examples {

namespace {

bool has_space(const std::string& text) {
    return text.find_first_of(" \t\r\n\v\f") != std::string::npos;
}

int whole_number(const std::string& text, int least, int most) {
    char* end = nullptr;
    errno = 0;
    const long value = std::strtol(text.c_str(), &end, 10);
    const bool whole = !text.empty() && end == text.c_str() + text.size() && errno == 0;
    ancf::detail::require(whole && !has_space(text) && value >= least && value <= most,
                          "expected a whole number from ", least, " to ", most, ", got \"", text,
                          '"');
    return static_cast<int>(value);
}

/// Returns the parts of a text between commas; an empty part counts.
std::vector<std::string> parts(const std::string& text) {
    std::vector<std::string> list(1);
    for (const char letter : text)
        if (letter == ',')
            list.emplace_back();
        else
            list.back() += letter;
    return list;
}

template <class Values, class Text>
std::string joined(const Values& values, const char* separator, Text&& text) {
    std::string list;
    for (const auto& value : values) list.append(list.empty() ? "" : separator).append(text(value));
    return list;
}

std::string joined(const std::vector<std::string>& words) {
    return joined(words, ", ", [](const std::string& word) { return word; });
}

}  // namespace

double number(const std::string& text, Range range) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool decimal = text.find_first_not_of("0123456789+-.eE") == std::string::npos;
    const bool whole = !text.empty() && end == text.c_str() + text.size() && decimal;
    ancf::detail::require(whole && std::isfinite(value) && (range == Range::finite || value > 0.0),
                          "expected a ", range == Range::positive ? "positive, " : "",
                          "finite number, got \"", text, '"');
    return value;
}

struct CommandLine::Parser {
    explicit Parser(const std::string& description) : app(description) {
        app.get_formatter()->column_width(36);
        app.footer(
            "Exit status: 0 done, 1 a published value was missed or a run did not converge, "
            "2 bad input.");
    }

    /// Adds an option whose text `take` reads or refuses.
    template <class Take>
    void add(const std::string& name, const std::string& type, const std::string& shown,
             const std::string& text, Take take) {
        const auto read = [name, take](const std::string& given) {
            try {
                take(given);
            } catch (const ancf::InvalidArgument& error) {
                throw CLI::ValidationError(name, error.what());
            }
        };
        auto* option = app.add_option_function<std::string>(name, read, text);
        option->type_name(type)->group(group);
        if (!shown.empty()) option->default_str(shown);
    }

    CLI::App app;
    std::string group = "Options";
};

CommandLine::CommandLine(const std::string& description)
    : parser_(std::make_unique<Parser>(description)) {}

CommandLine::~CommandLine() = default;

void CommandLine::set_group(const std::string& title) { parser_->group = title; }

void CommandLine::add_number(const std::string& name, double& value, Range range,
                             const std::string& text) {
    std::ostringstream shown;
    shown.precision(16);
    shown << value;
    parser_->add(name, "NUMBER", shown.str(), text,
                 [&value, range](const std::string& given) { value = number(given, range); });
}

void CommandLine::add_triple(const std::string& name, double* values, const std::string& text) {
    parser_->add(name, "X,Y,Z", "", text, [values](const std::string& given) {
        const std::vector<std::string> list = parts(given);
        ancf::detail::require(list.size() == 3, "expected three numbers X,Y,Z, got \"", given, '"');
        for (std::size_t k = 0; k < 3; ++k) values[k] = number(list[k], Range::finite);
    });
}

void CommandLine::add_count(const std::string& name, int& value, int least, int most,
                            const std::string& text) {
    parser_->add(name, "COUNT", std::to_string(value), text,
                 [&value, least, most](const std::string& given) {
                     value = whole_number(given, least, most);
                 });
}

void CommandLine::add_counts(const std::string& name, std::vector<int>& values, int least, int most,
                             const std::string& text) {
    const std::string shown = joined(values, ",", [](int value) { return std::to_string(value); });
    parser_->add(name, "COUNT,...", shown, text, [&values, least, most](const std::string& given) {
        values.clear();
        for (const std::string& part : parts(given))
            values.push_back(whole_number(part, least, most));
    });
}

void CommandLine::add_choice(const std::string& name, std::string& value,
                             const std::vector<std::string>& words, const std::string& text) {
    const std::string list = joined(words);
    parser_->add(
        name, "NAME", value, text + ": " + list, [&value, words, list](const std::string& given) {
            ancf::detail::require(std::find(words.begin(), words.end(), given) != words.end(),
                                  "expected one of ", list, ", got \"", given, '"');
            value = given;
        });
}

void CommandLine::add_file(const std::string& name, std::string& value, const std::string& text) {
    parser_->add(name, "FILE", "", text, [&value](const std::string& given) {
        ancf::detail::require(!given.empty() && given.rfind("--", 0) != 0,
                              "expected the name of a file, got \"", given, '"');
        value = given;
    });
}

void CommandLine::add_flag(const std::string& name, bool& value, const std::string& text) {
    parser_->app.add_flag(name, value, text)->disable_flag_override()->group(parser_->group);
}

void CommandLine::note_unused(const std::string& name, const std::string& what) const {
    if (given(name)) std::cerr << name << " is of no use with " << what << '\n';
}

void CommandLine::exclude(const std::string& one, const std::string& other) {
    parser_->app.get_option(one)->excludes(parser_->app.get_option(other));
}

void CommandLine::parse(int argc, const char* const* argv) {
    try {
        parser_->app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        throw Exit{parser_->app.exit(error) == 0 ? exit_done : exit_bad_input};
    }
}

bool CommandLine::given(const std::string& name) const {
    return parser_->app.get_option(name)->count() > 0;
}

void detail::require_output() {
    std::cout.flush();
    ancf::detail::require(std::cout.good(), "cannot write standard output");
}

int detail::exit_code() noexcept {
    try {
        try {
            throw;
        } catch (const Exit& exit) {
            require_output();
            return exit.code;
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
    } catch (...) {
        std::cerr << "unknown failure\n";
    }
    return exit_bad_input;
}

}  // namespace examples
