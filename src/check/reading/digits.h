#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include "check/reading/resolution.h"
#include "table/reader.h"

namespace twrench::check {

/// Whether numbers are values of a narrow binary format, in whatever decimals they are printed.
class NarrowFormat {
 public:
  /// A format with so many bits, the leading one included, and the least exponent of normal numbers
  /// as std::frexp returns it.
  NarrowFormat(int bits, int least_exponent) : bits_(bits), least_exponent_(least_exponent) {}

  void add(const table::Number& number);

  /// Whether all numbers are values of it, which more of them are than by chance.
  bool holds_all() const;

 private:
  int bits_, least_exponent_;
  bool all_ = true;
  double evidence_ = 0;  ///< bits: how improbable it is that other numbers would all have been
};

/// Finds from the numbers of a column how they are written: with so many decimals, with so many
/// significant digits, as values of half or single precision, or with digits that a change of the
/// unit added.
class Digits {
 public:
  Digits() = default;
  Digits(const Digits&) = delete;
  Digits& operator=(const Digits&) = delete;

  void add(const table::Number& number);

  /// The spacing of the numbers seen, of which one unit is `unit` of ours.
  Resolution resolution(double unit) const;

 private:
  /// Numbers with the same leading place: 10^k <= |x| < 10^(k + 1).
  struct Decade {
    std::size_t count = 0;
    int decimals = std::numeric_limits<int>::min();  ///< the most
  };

  Resolution written_resolution(double unit) const;
  bool has_fixed_decimals() const;

  std::map<int, Decade> decades_;
  Decade* last_ = nullptr;  ///< the decade of the number before, which the next mostly shares
  int last_place_ = 0;
  int decimals_ = std::numeric_limits<int>::min();
  int significant_ = 0;
  NarrowFormat float16_{11, -13}, float32_{24, -125};
  std::vector<double> first_values_;  ///< some that are not zero
};

/// The same for times, which may be written exactly in few digits.
class TimeDigits {
 public:
  void add(const table::Number& number);

  /// That of doubles where the times are equally spaced in all their digits.
  Resolution resolution(double unit) const;

 private:
  Digits digits_;
  std::size_t count_ = 0;
  double first_ = 0, step_ = 0;
  bool equally_spaced_ = true;
};

}  // namespace twrench::check
