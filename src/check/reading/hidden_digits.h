#pragma once

#include <optional>
#include <span>
#include <vector>

#include "table/reader.h"

namespace twrench::check {

/// Numbers as they were before a program changed their unit, and the factor by which it did.
struct HiddenDigits {
  double factor = 1;
  std::vector<table::Number> numbers;
};

/// Finds whether numbers that are written with all digits of doubles had fewer before: a program
/// that prints 12 digits of rad/s, of which another makes deg/s with 57.295779513, adds none that
/// are true. Nothing where there are too few different numbers to tell.
std::optional<HiddenDigits> find_hidden_digits(std::span<const double> values);

}  // namespace twrench::check
