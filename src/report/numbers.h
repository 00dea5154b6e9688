#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace twrench::report {

/// Returns a value with eight significant digits; a dash if it is not finite.
std::string digits(double value);

/// Returns an error or another small quantity with three significant digits; a dash if it is not
/// finite.
std::string brief(double value);

/// Returns three values in parentheses.
template <typename Vector>
std::string triple(const Vector& v) {
  return fmt::format("({}, {}, {})", digits(v[0]), digits(v[1]), digits(v[2]));
}

}  // namespace twrench::report
