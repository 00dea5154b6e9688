#pragma once

#include <twrench/base/error.h>

#include <span>

namespace twrench {

// Each that takes one number returns `value`, or throws OutOfRange about `quantity`.

/// A finite number.
double require_finite(const char* quantity, double value);

/// Throws OutOfRange about "QUANTITY[i]" unless all are finite numbers.
void require_finite(const char* quantity, std::span<const double> values);

/// A finite number above zero.
double require_positive(const char* quantity, double value);

/// A finite number that is zero or above.
double require_not_negative(const char* quantity, double value);

}  // namespace twrench
