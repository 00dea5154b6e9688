#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/hypotheses/hypotheses.h"
#include "check/verdict/judge.h"

namespace twrench::check {

/// A bound that was set for a file, and the value that it limits.
struct CheckBound {
  std::string argument;  ///< its name, "max_rate_error"
  std::string unit;      ///< of both numbers; empty if they are relative
  double most;
  double value;

  /// Whether the value exceeds the bound; NaN does.
  bool is_exceeded() const { return !(value <= most); }
};

/// The results for one file.
struct CheckedFile {
  std::string name;
  Judgement judgement;
  /// Other ways to read the file, if it does not follow the motion as it is read.
  Alternatives alternatives;
  /// The initial state that fits the rows, if they do not begin in the given one.
  std::optional<Fit> other_start;
  std::vector<CheckBound> bounds;
  double step;  ///< s: as the user gave it, or the mean time between rows
  /// Columns that are not read, but could be what the file lacks: rates or an attitude.
  std::vector<std::string> unread = {};
  std::optional<FittedInertia> inertia = {};  ///< that was fitted to the rates
  /// If the rows do not follow the motion with the fitted inertia: those that follow a free motion
  /// within their noise.
  std::optional<recording::Extract> free_rows = {};
  std::string left_out = {};  ///< the rows at the start and the end that lack a number
};

/// The exponents of the errors as functions of the step, if several files determine them.
struct CheckOrders {
  std::optional<double> rates, attitude;
  /// Why there are none; empty if there are some, and for a single file.
  std::string why_not;
};

struct CheckResult {
  std::vector<CheckedFile> files;
  CheckOrders orders;
};

/// The unit of a file's rates.
struct RateScale {
  double per_radian;   ///< 1 rad/s in the file's unit
  const char* symbol;  ///< "deg/s"
};
RateScale rate_scale(const Judgement& judgement);

/// Converts rad to degrees.
double degrees(double angle);

/// A time of a judgement on the file's clock, "1700000000.020000", in s. A clock that counts from
/// 1970 needs ten digits before the point.
std::string clock_text(const Judgement& judgement, double t);

/// The kind of a verdict. Reports for programs contain the names.
enum class Finding {
  exact,         ///< within the resolution of its digits
  noise,         ///< within the resolution and the noise
  convention,    ///< read in another convention than it was written in
  start,         ///< from another initial state
  body,          ///< of a body with other moments
  law,           ///< not a motion of this body
  inconsistent,  ///< the attitude is not that of the rates
  integration,   ///< the motion, with numerical errors
};

/// The verdict on a file.
struct Verdict {
  Finding finding;
  std::string text;  ///< in one line
};
Verdict verdict(const CheckedFile& file);

/// States that these rows follow a free motion, and the arguments that select them.
std::string free_rows_text(const recording::Extract& rows);

/// A relative change with a format of fmt such as "{:.2e}", or a remark if it is infinite.
std::string change_text(const char* format, double change);

/// How the numbers of a column are written: "6 decimals", "float32 (24 bits)".
std::string precision_text(const recording::Resolution& resolution);

/// Whether a file passes: it follows the exact motion within its digits and its noise, or stays
/// within the bounds that were set for it.
bool passes(const CheckedFile& file);

/// Whether the rows follow another law than the motion of the body, as far as can be tested.
bool is_foreign(const Judgement& judgement);

}  // namespace twrench::check
