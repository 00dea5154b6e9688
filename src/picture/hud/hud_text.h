#pragma once

#include <string>

#include "base/time_unit.h"
#include "timeline/timeline.h"

// Formatting of numbers and names for the HUD, as UTF-8 for typeset().
namespace twrench::picture::hud_text {

/// Formats a time in s with as many decimals as `resolution` (in s) requires, at most three.
std::string time(double t, double resolution, const TimeUnit& unit);

/// Formats a time in s with three digits, or without decimals if it has more.
std::string rounded_time(double t, const TimeUnit& unit);

/// An error of at least this size is formatted with its digits. The digits of smaller ones, which
/// are round-off, would change in every frame.
inline constexpr double round_off = 1e-14;

/// Formats a relative error with its sign and two digits, for example "+1.2×10⁻¹³" or "−0.034", or
/// as "<10⁻¹⁴" if it is round-off.
std::string drift(double value);

/// Formats the magnitude of an error: the same without the sign.
std::string error(double value);

/// Returns "10⁻³" for -3.
std::string power_of_ten(int exponent);

/// Formats a setting as briefly as possible: "0.01", "10⁻¹⁰", "2.5×10⁻⁷".
std::string setting(double value);

/// Returns the angle between two attitudes, "12.3°".
std::string degrees(const motion::Sample& from, const motion::Sample& to);

/// Returns, for example, "rkmk45, tolerance 10⁻¹⁰".
std::string method(const timeline::Solution& solution, scene::Language language);

}  // namespace twrench::picture::hud_text
