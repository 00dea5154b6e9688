#pragma once

#include <optional>
#include <span>
#include <vector>

#include "table/reader.h"

namespace twrench::recording {

/// Numbers as they were before a program converted their unit, and the conversion factor.
struct HiddenDigits {
  double factor = 1;
  std::vector<table::Number> numbers;
};

/// Detects whether numbers that are written with all digits of doubles had fewer digits before: if
/// one program prints 12 digits of rad/s, and another converts them to deg/s with 57.295779513, the
/// digits that this adds are not significant. Returns nothing if the numbers had no fewer digits,
/// or if there are too few different numbers to decide. Conversions are tried only if the numbers
/// `may_be_angles` or rates.
std::optional<HiddenDigits> find_hidden_digits(std::span<const double> values, bool may_be_angles);

}  // namespace twrench::recording
