#pragma once

#include <twrench/base/error.h>

#include <cmath>
#include <span>

namespace twrench {

// Each function of one number returns `value`, or throws OutOfRange about `quantity`.

/// Requires a finite number.
double require_finite(const char* quantity, double value);

/// Throws OutOfRange about "QUANTITY[i]" unless all values are finite.
void require_finite(const char* quantity, std::span<const double> values);

/// Requires a finite number above zero.
double require_positive(const char* quantity, double value);

/// Requires a finite number that is not negative.
double require_not_negative(const char* quantity, double value);

/// Returns the entries of a vector, matrix or array, or throws OutOfRange about `quantity` unless
/// all are finite. It is inline because integration steps call it.
template <class Entries>
const Entries& require_finite_entries(const char* quantity, const Entries& entries) {
  for (const double entry : std::span(entries.data(), static_cast<std::size_t>(entries.size()))) {
    if (!std::isfinite(entry)) require_finite(quantity, entry);
  }
  return entries;
}

/// Throws OutOfRange about `quantity` unless all entries are positive and finite.
template <class Entries>
void require_positive_entries(const char* quantity, const Entries& entries) {
  for (const double entry : std::span(entries.data(), static_cast<std::size_t>(entries.size()))) {
    require_positive(quantity, entry);
  }
}

}  // namespace twrench
