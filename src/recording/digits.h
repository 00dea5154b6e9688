#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include "table/reader.h"

namespace twrench::recording {

/// How the numbers of a column are written.
enum class NumberFormat { decimals, digits, float16, float32, float64 };

/// How precisely the written digits of a column determine its numbers: the spacing of the values
/// that it can represent.
struct Resolution {
  NumberFormat written = NumberFormat::float64;
  int count = 0;           ///< number of the decimals or digits
  bool converted = false;  ///< `count` excludes digits that a conversion of the unit added

  /// One unit of the last decimal place that is written; 0 if significant digits are counted.
  double absolute = 0;
  /// One unit of the last significant digit, relative to the leading one: 10^-(digits - 1), or the
  /// epsilon of a binary format.
  double relative = std::numeric_limits<double>::epsilon();
  /// 10 or 2. `relative` refers to the largest power of it that does not exceed the number.
  int base = 2;
  /// The file's unit in ours: pi/180 for degrees.
  double unit = 1;
  /// The file's zero in our unit, if the spacing depends on the file's own numbers and these count
  /// from elsewhere.
  double offset = 0;

  /// The spacing at `value`, in our unit: at least that of doubles.
  double at(double value) const;
};

/// Detects whether all numbers are values of a narrow binary format, however many decimals are
/// printed.
class NarrowFormat {
 public:
  /// `bits` includes the leading bit of the significand; `least_exponent` is that of the smallest
  /// normal number, as std::frexp returns it.
  NarrowFormat(int bits, int least_exponent) : bits_(bits), least_exponent_(least_exponent) {}

  void add(const table::Number& number);

  /// Whether all numbers are values of the format, and too many for this to be chance.
  bool holds_all() const;

  /// The epsilon of the format, and as much more as the printed numbers differ from its values: the
  /// shortest decimals that determine a value differ from it by up to half its spacing.
  double resolution() const { return std::ldexp(1 + 2 * farthest_, 1 - bits_); }

 private:
  int bits_, least_exponent_;
  bool all_ = true;
  double farthest_ = 0;  ///< the largest difference from a value, in units of the spacing
  double evidence_ = 0;  ///< bits: how improbable this would be for arbitrary numbers
};

/// Determines from the numbers of a column how they are written: with a fixed number of decimals or
/// of significant digits, as values of half or single precision, or with digits that a conversion
/// of the unit added.
class Digits {
 public:
  /// `may_be_angles` is whether a conversion from radians to degrees, or back, may have added
  /// digits.
  explicit Digits(bool may_be_angles = true) : may_be_angles_(may_be_angles) {}
  Digits(const Digits&) = delete;
  Digits& operator=(const Digits&) = delete;

  void add(const table::Number& number);

  /// Returns the spacing of the numbers added so far. `unit` is the size of the file's unit in
  /// ours.
  Resolution resolution(double unit) const;

  /// Whether all numbers have at most two digits before their zeros: 0, 20, -0.5.
  bool are_round() const { return are_round_; }

 private:
  /// Numbers with the same leading place: 10^k <= |x| < 10^(k + 1).
  struct Decade {
    std::size_t count = 0;
    int decimals = std::numeric_limits<int>::min();  ///< the most
  };

  Resolution written_resolution(double unit) const;
  bool has_fixed_decimals() const;

  bool may_be_angles_, are_round_ = true;
  std::map<int, Decade> decades_;
  Decade* last_ = nullptr;  ///< that of the previous number, as usually of the next
  int last_place_ = 0;
  int decimals_ = std::numeric_limits<int>::min();
  int significant_ = 0;
  NarrowFormat float16_{11, -13}, float32_{24, -125};
  std::vector<double> first_values_;  ///< nonzero, for find_hidden_digits()
};

/// Does the same for times since the first one, which may be exact with few digits.
class TimeDigits {
 public:
  /// `are_exact` is whether all digits were written, as of calendar times and of times in two
  /// columns. Other numbers of more digits than a double has may be doubles that were printed.
  explicit TimeDigits(bool are_exact = false) : are_known_exact_(are_exact) {}

  void add(const table::Number& number);

  /// Returns the resolution of doubles if the times are equally spaced in all their digits, or a
  /// few round numbers such as 0, 10 and 25, which are rarely the result of rounding.
  Resolution resolution(double unit) const;

 private:
  Digits digits_{false};
  std::size_t count_ = 0;
  table::Number first_;
  double step_ = 0;
  bool equally_spaced_ = true, are_round_ = true;
  bool are_known_exact_;
  bool are_exact_ = true;  ///< no number was rounded to a double
  bool are_long_ = false;  ///< some have more digits than the differences need
  int decimals_ = std::numeric_limits<int>::min();  ///< the most of a difference
};

}  // namespace twrench::recording
