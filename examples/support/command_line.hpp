// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Command lines that say exactly what is wrong with a value, and one place for exit codes.
///
/// 0: done. 1: a published value was missed or a run did not converge. 2: input that cannot be
/// meant.

#pragma once

#include <memory>
#include <string>
#include <vector>

namespace examples {

inline constexpr int exit_done = 0;
inline constexpr int exit_missed = 1;
inline constexpr int exit_bad_input = 2;

/// Ends a program with an exit code after everything has been said.
struct Exit {
    int code;
};

/// Which numbers an option takes.
enum class Range { finite, positive };

/// Returns the number that a whole text is.
/// @throws ancf::InvalidArgument with the text and what was expected.
[[nodiscard]] double number(const std::string& text, Range range);

/// The options of one program. Values live with the caller and outlive the command line.
class CommandLine {
public:
    explicit CommandLine(const std::string& description);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// Puts the options that follow under a title in the help.
    void set_group(const std::string& title);

    /// Adds an option of one number.
    void add_number(const std::string& name, double& value, Range range, const std::string& text);

    /// Adds an option of three numbers between commas; `values` is the first of three.
    void add_triple(const std::string& name, double* values, const std::string& text);

    /// Adds an option of one whole number.
    void add_count(const std::string& name, int& value, int least, int most,
                   const std::string& text);

    /// Adds an option of whole numbers between commas.
    void add_counts(const std::string& name, std::vector<int>& values, int least, int most,
                    const std::string& text);

    /// Adds an option of one of several words.
    void add_choice(const std::string& name, std::string& value,
                    const std::vector<std::string>& words, const std::string& text);

    /// Adds an option of the name of a file.
    void add_file(const std::string& name, std::string& value, const std::string& text);

    void add_flag(const std::string& name, bool& value, const std::string& text);

    /// Says on stderr that an option on the command line is of no use with `what`.
    void note_unused(const std::string& name, const std::string& what) const;

    /// Lets only one of two options be given.
    void exclude(const std::string& one, const std::string& other);

    /// Reads the command line.
    /// @throws Exit after printing the help (0) or a message (2).
    void parse(int argc, const char* const* argv);

    /// Returns whether an option stood on the command line.
    [[nodiscard]] bool given(const std::string& name) const;

    /// Gives an option that did not stand on the command line the value of a preset.
    template <class Value>
    void settle(const std::string& name, Value& value, const Value& preset) const {
        if (!given(name)) value = preset;
    }

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

namespace detail {

/// @throws ancf::InvalidArgument where standard output could not be written.
void require_output();

/// Says on stderr what the exception in flight is about and returns the exit code.
int exit_code() noexcept;

}  // namespace detail

/// Runs the body of a main function; what it throws, and results that standard output did not take,
/// become a message and an exit code.
template <class Body>
int run(Body&& body) noexcept {
    try {
        const int code = body();
        detail::require_output();
        return code;
    } catch (...) {
        return detail::exit_code();
    }
}

}  // namespace examples
