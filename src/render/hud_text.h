#pragma once

#include <string>

#include "timeline/timeline.h"

// Numbers and names as the film's viewer reads them: UTF-8, for typeset().
namespace twrench::hud_text {

/// Seconds between 0 and `longest`, all as wide: "\u2007" for the digits that are not there yet.
/// As many decimals as let `resolution` s show, three at most.
std::string seconds(double t, double longest, double resolution);

/// A relative error, of either sign: "+1.2×10⁻¹⁵"; "0" for zero.
std::string drift(double value);

/// An error's size: the same without a sign.
std::string error(double value);

/// A setting, as short as it may be said: "0.01", "10⁻¹⁰", "2.5×10⁻⁷".
std::string setting(double value);

/// "rkmk45, tolerance 10⁻¹⁰"
std::string method(const Take& take);

}  // namespace twrench::hud_text
