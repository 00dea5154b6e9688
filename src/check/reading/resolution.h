#pragma once

#include <limits>

namespace twrench::check {

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

}  // namespace twrench::check
