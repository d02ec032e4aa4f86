// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <system_error>

namespace ancf {

namespace detail {

ANCF_INLINE void write_column(std::ostream& out, const std::string& head, const VectorX& values) {
    require(detail::all_finite(values), "write_state: ", head, " is not finite");
    out << head << ' ' << std::to_string(values.size()) << '\n';  // in any locale
    for (const double value : values) out << number_text(value) << '\n';
}

ANCF_INLINE const std::string& require_word(const std::string& name) {
    require(!name.empty() && name.find_first_of(" \t\r\n") == std::string::npos,
            "write_state: a name must be one word, got \"", name, '"');
    return name;
}

/// Reads lines and knows their numbers.
class StateReader {
public:
    explicit StateReader(std::istream& in) : in_(in) {}

    /// Reads a line that begins with a word and returns what follows it.
    std::string after(const std::string& word) {
        const std::string line = next();
        if (line == word) return {};
        expect(line.rfind(word + ' ', 0) == 0, word, line);
        return line.substr(word.size() + 1);
    }

    /// Reads the next line.
    std::string next() {
        constexpr std::size_t longest = 1000;
        std::string line;
        ++number_;
        char c = 0;
        while (in_.get(c) && c != '\n') {
            line += c;
            require(line.size() <= longest, "state file, line ", number_, ": longer than ", longest,
                    " characters");
        }
        require(!line.empty() || c == '\n', "state file, line ", number_,
                ": the file ends too early");
        if (!line.empty() && line.back() == '\r') line.pop_back();
        return line;
    }

    /// Returns the one value that a whole text is.
    template <class Value>
    Value value(const std::string& text) {
        std::istringstream stream(text);
        stream.imbue(std::locale::classic());
        Value result{};
        stream >> std::noskipws >> result;
        // some standard libraries fail at a subnormal number, which they read, and some take "nan"
        if (result != 0 && std::abs(result) < std::numeric_limits<Value>::min()) stream.clear();
        expect(!stream.fail() && stream.peek() == std::char_traits<char>::eof() &&
                   text.find_first_not_of("0123456789+-.eE") == std::string::npos,
               "a number", text);
        return result;
    }

    /// Reads the numbers of a column.
    VectorX column(const std::string& count) {
        constexpr int most = 100'000'000;
        const int size = value<int>(count);
        expect(size >= 0 && size <= most, "a count", count);
        VectorX values;
        for (int k = 0; k < size; ++k) {  // grows, so that a wrong count ends with the file
            if (k == values.size()) values.conservativeResize(std::min(size, 2 * k + 64));
            values[k] = value<double>(next());
        }
        values.conservativeResize(size);
        return values;
    }

    template <class Expected>
    void expect(bool condition, const Expected& expected, const std::string& got) const {
        require(condition, "state file, line ", number_, ": expected ", expected, ", got \"", got,
                '"');
    }

private:
    std::istream& in_;
    int number_ = 0;
};

}  // namespace detail

ANCF_INLINE void write_state(std::ostream& out, const SavedState& saved) {
    detail::require_finite("write_state: time", saved.state.time);
    out << "ancf-state 1\ntime " << number_text(saved.state.time) << '\n';
    detail::write_column(out, "q", saved.state.q);
    detail::write_column(out, "v", saved.state.v);
    detail::write_column(out, "multipliers", saved.state.multipliers);
    if (!saved.memory.empty()) {
        out << "memory " << detail::require_word(saved.memory.integrator) << '\n';
        for (const auto& [name, values] : saved.memory.values)
            detail::write_column(out, "value " + detail::require_word(name), values);
    }
    out << "end\n";
}

ANCF_INLINE SavedState read_state(std::istream& in) {
    detail::StateReader reader(in);
    SavedState saved;
    const std::string version = reader.after("ancf-state");
    reader.expect(version == "1", "version 1", version);
    saved.state.time = reader.value<double>(reader.after("time"));
    saved.state.q = reader.column(reader.after("q"));
    saved.state.v = reader.column(reader.after("v"));
    saved.state.multipliers = reader.column(reader.after("multipliers"));
    std::string line = reader.next();
    if (line.rfind("memory ", 0) == 0) {
        saved.memory.integrator = line.substr(7);
        for (line = reader.next(); line.rfind("value ", 0) == 0; line = reader.next()) {
            const std::size_t blank = line.rfind(' ');
            reader.expect(blank > 6, "value NAME COUNT", line);
            saved.memory.put(line.substr(6, blank - 6), reader.column(line.substr(blank + 1)));
        }
    }
    reader.expect(line == "end", "end", line);
    return saved;
}

ANCF_INLINE void save_state(const std::filesystem::path& file, const SavedState& saved) {
    std::ostringstream text;
    write_state(text, saved);
    // a file is replaced as a whole, the one that a link leads to; what is no file is written to
    std::error_code failure;
    const bool there = std::filesystem::exists(file, failure);
    const bool replaced = !there || std::filesystem::is_regular_file(file, failure);
    const auto target = there ? std::filesystem::canonical(file, failure) : file;
    auto fresh = target;
    if (replaced) fresh += ".new";
    std::ofstream out(fresh);
    out << text.str();
    out.close();
    failure.clear();
    if (!out.fail() && replaced) std::filesystem::rename(fresh, target, failure);
    detail::require(!out.fail() && !failure, "cannot write ", file.string());
}

ANCF_INLINE SavedState load_state(const std::filesystem::path& file) {
    std::ifstream in(file);
    detail::require(in.is_open(), "cannot read ", file.string());
    try {
        return read_state(in);
    } catch (const InvalidArgument& error) {
        detail::reject(file.string(), ": ", error.what());
    }
}

}  // namespace ancf
