// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How the library says that something went wrong.
///
/// A wrong call throws InvalidArgument. A numerical outcome is a value: a Status inside a report.
/// Nothing prints, aborts or exits.

#pragma once

#include <ancf/compiler.hpp>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

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
    degenerate,      ///< an element is no beam: without directors, twisted too far or folded
    not_finite,      ///< a NaN or an infinity appeared
    inconsistent,    ///< the start of a motion violates a constraint, or its course one left out
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

/// Returns the components of a vector for a message.
template <class Vector>
[[nodiscard]] Components components(const Vector& vector) noexcept {
    return {vector.data(), vector.size()};
}

/// One part of a message: text, a letter, a number or a row of numbers.
///
/// It refers to what it was made from: for use within one expression, not to be kept.
///
/// Nothing here is a template and nothing has a destructor: a message that is never needed costs a
/// few stores, and every program's unit compiles one function that writes text.
class MessagePart {
public:
    constexpr MessagePart(const char* text) noexcept : kind_(Kind::text), text_(text) {}
    constexpr MessagePart(std::string_view text) noexcept : kind_(Kind::text), text_(text) {}
    MessagePart(const std::string& text) noexcept : kind_(Kind::text), text_(text) {}
    constexpr MessagePart(char letter) noexcept : kind_(Kind::letter), letter_(letter) {}
    constexpr MessagePart(double value) noexcept : kind_(Kind::real), real_(value) {}
    constexpr MessagePart(const Components& row) noexcept : kind_(Kind::row), row_(row) {}
    constexpr MessagePart(int value) noexcept : MessagePart(static_cast<long long>(value)) {}
    constexpr MessagePart(long value) noexcept : MessagePart(static_cast<long long>(value)) {}
    constexpr MessagePart(long long value) noexcept : kind_(Kind::integer), integer_(value) {}
    constexpr MessagePart(unsigned long value) noexcept
        : MessagePart(static_cast<unsigned long long>(value)) {}
    constexpr MessagePart(unsigned long long value) noexcept
        : kind_(Kind::natural), natural_(value) {}

    /// Writes the part, numbers with the stream's digits.
    void write(std::ostream& out) const;

private:
    enum class Kind { text, letter, real, integer, natural, row };

    Kind kind_;
    union {
        std::string_view text_;
        char letter_;
        double real_;
        long long integer_;
        unsigned long long natural_;
        Components row_;
    };
};

/// Returns all parts in one text.
/// @param digits  of numbers that are not integers
[[nodiscard, gnu::cold]] std::string joined(std::initializer_list<MessagePart> parts,
                                            int digits = 6);

/// Throws InvalidArgument with all parts in one message.
[[noreturn, gnu::cold]] void reject_parts(std::initializer_list<MessagePart> parts);

/// What a part of a message is passed on as: of few types, so that few functions throw.
template <class Part>
using PassedPart =
    std::conditional_t<std::is_convertible_v<Part, std::string_view>, std::string_view,
                       std::conditional_t<std::is_same_v<Part, int>, long, Part>>;

template <class... Parts>
[[noreturn, gnu::cold, gnu::noinline]] void reject_passed(Parts... parts) {
    reject_parts({MessagePart(parts)...});
}

/// Throws InvalidArgument with all parts in one message.
template <class... Parts>
[[noreturn]] void reject(const Parts&... parts) {
    reject_passed<PassedPart<Parts>...>(parts...);
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

/// Throws unless all components of the named vector are finite.
void require_finite(std::string_view name, const Components& row);

/// Throws unless the named value is finite and at least zero.
inline void require_not_negative(std::string_view name, double value) {
    require(std::isfinite(value) && value >= 0.0, name, " must be finite and not negative, got ",
            value);
}

/// Throws unless the named value is finite and greater than zero.
inline void require_positive(std::string_view name, double value) {
    require(std::isfinite(value) && value > 0.0, name, " must be positive and finite, got ", value);
}

}  // namespace detail
}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/error.ipp>  // IWYU pragma: export
#endif
