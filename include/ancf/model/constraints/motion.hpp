// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Motions that are given as functions of time, with their first and second derivative.
///
/// A constraint evaluates them at a real time or, in the derivative checks of the tests, at a time
/// with a tiny imaginary part: f(t + i h) = f(t) + i h f'(t).

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/state.hpp>
#include <ancf/types.hpp>

#include <complex>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ancf {

/// A scalar over time with its rate and acceleration: an angle, a length, a coordinate.
///
/// Rate and acceleration are taken as they are: they must be the value's derivatives. A rate that
/// is not shows as DynamicsReport::violation_rate, but of Leapfrog, and makes rates and energies
/// wrong; the values hold. An acceleration that is not spoils multipliers.
struct Motion {
    Amplitude value;         ///< m or rad, over time
    Amplitude rate;          ///< first derivative
    Amplitude acceleration;  ///< second derivative

    /// @throws InvalidArgument unless all three are given.
    void check(std::string_view user) const {
        detail::require(value && rate && acceleration, user,
                        ": a motion needs value, rate and acceleration, in statics too");
    }
};

/// A point that moves on a given path; rate and acceleration as those of a Motion.
template <int Dimension>
struct PointMotion {
    using Function = std::function<Vector<double, Dimension>(double)>;  ///< a vector over time
    Function value;                                                     ///< m
    Function rate;                                                      ///< m/s
    Function acceleration;                                              ///< m/s^2

    PointMotion() = default;

    /// From position, velocity and acceleration over time.
    template <
        class Value, class Rate, class Acceleration,
        std::enable_if_t<std::is_invocable_v<Value, double> && std::is_invocable_v<Rate, double> &&
                             std::is_invocable_v<Acceleration, double>,
                         int> = 0>
    PointMotion(Value position, Rate velocity, Acceleration second)
        : value(std::move(position)), rate(std::move(velocity)), acceleration(std::move(second)) {}

    /// @throws InvalidArgument unless all three are given.
    void check(std::string_view user) const {
        detail::require(value && rate && acceleration, user,
                        ": a motion needs value, rate and acceleration, in statics too");
    }

    /// Returns the motion of a point that rests.
    [[nodiscard]] static PointMotion at_rest(const Vector<double, Dimension>& point) {
        const auto zero = [](double) -> Vector<double, Dimension> {
            return Vector<double, Dimension>::Zero();
        };
        return {[point](double) { return point; }, zero, zero};
    }
};

namespace detail {

/// Returns the motion of a value that rests.
[[nodiscard]] inline Motion resting_at(double value) {
    const auto zero = [](double) { return 0.0; };
    return {[value](double) { return value; }, zero, zero};
}

/// Evaluates a function of time, continued into the complex plane by its derivative.
template <class Function>
[[nodiscard]] auto continued(const Function& f, const Function&, double t) {
    return f(t);
}

[[nodiscard]] inline std::complex<double> continued(const Amplitude& f, const Amplitude& derivative,
                                                    const std::complex<double>& t) {
    return {f(t.real()), t.imag() * derivative(t.real())};
}

template <int Dimension>
[[nodiscard]] Vector<std::complex<double>, Dimension> continued(
    const std::function<Vector<double, Dimension>(double)>& f,
    const std::function<Vector<double, Dimension>(double)>& derivative,
    const std::complex<double>& t) {
    Vector<std::complex<double>, Dimension> value =
        f(t.real()).template cast<std::complex<double>>();
    value += std::complex<double>(0.0, t.imag()) * derivative(t.real());
    return value;
}

}  // namespace detail
}  // namespace ancf
