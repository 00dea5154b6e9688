#pragma once

#include "base/error.h"

namespace twrench {

// Each returns `value`, or throws OutOfRange about `quantity`.

/// A finite number.
double require_finite(const char* quantity, double value);

/// A finite number above zero.
double require_positive(const char* quantity, double value);

}  // namespace twrench
