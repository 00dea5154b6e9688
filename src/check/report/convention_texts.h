#pragma once

#include <string>

#include "recording/conventions/convention.h"

namespace twrench::check {

/// A convention as users write it: the values of the options of the same names. An empty text
/// leaves its aspect to the file.
struct ConventionTexts {
  std::string columns, time_unit, units, angle_units, sequence, rates = "body", axes;
  bool inverse = false;
};

/// Throws InvalidArgument about the option whose value is wrong.
recording::Convention parse_convention(const ConventionTexts& texts);

}  // namespace twrench::check
