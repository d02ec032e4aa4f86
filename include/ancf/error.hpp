// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How the library says that something went wrong.
///
/// A wrong call throws InvalidArgument. A numerical outcome is a value: a Status inside a report.
/// Nothing prints, aborts or exits.

#pragma once

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace ancf {

/// Thrown by a call that cannot be meant: the message names the value and what was expected.
class InvalidArgument : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// The outcome of a numerical procedure.
enum class Status {
    converged,       ///< the stopping test holds
    max_iterations,  ///< the iteration limit came first
    diverged,        ///< the residual grew beyond recovery, or the step became too small
    singular,        ///< the matrix could not be factorised
    degenerate,  ///< an element lost its directors: slope parallel to the tangent, or of no length
    not_finite,  ///< a NaN or an infinity appeared
    inconsistent,    ///< the start of a motion violates a constraint
    redundant,       ///< constraints say the same thing twice
    step_too_small,  ///< the step fell below its limit
    stopped          ///< a callback asked to stop
};

/// Returns the status as the word that tables and CSV files print.
[[nodiscard]] constexpr std::string_view to_string(Status status) noexcept {
    switch (status) {
        case Status::converged: return "converged";
        case Status::max_iterations: return "max_iterations";
        case Status::diverged: return "diverged";
        case Status::singular: return "singular";
        case Status::degenerate: return "degenerate";
        case Status::not_finite: return "not_finite";
        case Status::inconsistent: return "inconsistent";
        case Status::redundant: return "redundant";
        case Status::step_too_small: return "step_too_small";
        case Status::stopped: return "stopped";
    }
    return "unknown";
}

namespace detail {

/// Numbers that stand in a row of a message.
struct Components {
    const double* values;
    std::ptrdiff_t count;
};

/// Returns the components of a vector, or the first of them, for a message.
template <class Vector>
[[nodiscard]] Components components(const Vector& vector) noexcept {
    return {vector.data(), vector.size()};
}
template <class Vector>
[[nodiscard]] Components components(const Vector& vector, std::ptrdiff_t count) noexcept {
    return {vector.data(), count};
}

/// One part of a message as text, numbers with 17 digits.
///
/// Nothing here is a template: it compiles once in a program's unit, not once for each message.
class MessagePart {
public:
    MessagePart(const char* text) : text_(text) {}
    MessagePart(std::string_view text) : text_(text) {}
    MessagePart(std::string text) : text_(std::move(text)) {}
    MessagePart(char letter) : text_(1, letter) {}
    MessagePart(double value) : MessagePart(Components{&value, 1}) {}
    MessagePart(const Components& row) {
        std::ostringstream stream;
        stream.precision(17);
        for (std::ptrdiff_t k = 0; k < row.count; ++k)
            stream << (k > 0 ? " " : "") << row.values[k];
        text_ = stream.str();
    }
    MessagePart(int value) : text_(std::to_string(value)) {}
    MessagePart(long value) : text_(std::to_string(value)) {}
    MessagePart(long long value) : text_(std::to_string(value)) {}
    MessagePart(unsigned long value) : text_(std::to_string(value)) {}
    MessagePart(unsigned long long value) : text_(std::to_string(value)) {}

    /// Returns the text.
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

/// Throws InvalidArgument with all parts in one message.
[[noreturn, gnu::cold]] inline void reject_parts(std::initializer_list<MessagePart> parts) {
    std::string message;
    for (const MessagePart& part : parts) message += part.text();
    throw InvalidArgument(message);
}

/// Throws InvalidArgument with all parts in one message.
template <class... Parts>
[[noreturn, gnu::cold, gnu::noinline]] void reject(const Parts&... parts) {
    reject_parts({MessagePart(parts)...});
}

/// Throws unless the condition holds.
template <class... Parts>
void require(bool condition, const Parts&... parts) {
    if (!condition) reject(parts...);
}

/// Throws unless the named value is finite.
inline void require_finite(std::string_view name, double value) {
    require(std::isfinite(value), name, " must be finite, got ", value);
}

/// Throws unless the named value is finite and greater than zero.
inline void require_positive(std::string_view name, double value) {
    require(std::isfinite(value) && value > 0.0, name, " must be positive and finite, got ", value);
}

}  // namespace detail
}  // namespace ancf
