#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/hypotheses/hypotheses.h"
#include "check/verdict/judge.h"

namespace twrench::app {

/// A bound that was set for a file, and what it is for.
struct CheckBound {
  std::string option;  ///< "--max-rate-error"
  std::string unit;    ///< of both numbers; empty where they are relative
  double most;
  double value;

  /// Whether the value is beyond it; no number is.
  bool is_exceeded() const { return !(value <= most); }
};

/// What is told of one file.
struct CheckedFile {
  std::string name;
  check::Judgement judgement;
  /// How else it may be read, where it does not follow the motion as it is read.
  check::Alternatives alternatives;
  /// The initial state that fits the rows, where they begin in another than the given one.
  std::optional<check::Fit> other_start;
  std::vector<CheckBound> bounds;
  double step;  ///< s: what was told, or the mean time between rows
};

/// The exponents of the errors as functions of the step, where several files tell them.
struct CheckOrders {
  std::optional<double> rates, attitude;
  /// Why there are none; empty where there are, and for a single file.
  std::string why_not;
};

struct CheckResult {
  std::vector<CheckedFile> files;
  CheckOrders orders;
};

/// How a file has its rates.
struct RateScale {
  double per_radian;   ///< of the file's unit in 1 rad/s
  const char* symbol;  ///< "deg/s"
};
RateScale rate_scale(const check::Judgement& judgement);

/// rad in degrees.
double degrees(double angle);

/// The kind of a verdict. Reports for programs contain the names.
enum class Finding {
  exact,         ///< within the resolution of its digits
  noise,         ///< within that and noise
  convention,    ///< read in another convention than it was written in
  start,         ///< from another initial state
  body,          ///< of a body with other moments
  law,           ///< no motion of this body
  inconsistent,  ///< the attitude is not that of the rates
  integration,   ///< the motion with errors of its computation
};

/// The verdict on a file.
struct Verdict {
  Finding finding;
  std::string text;  ///< in one line
};
Verdict verdict(const CheckedFile& file);

/// How the numbers of a column are written: "6 decimals", "float32 (24 bits)".
std::string precision_text(const check::Resolution& resolution);

/// Whether a file passes: it follows the exact motion within what its digits and its noise allow,
/// or holds the bounds that were set for it.
bool passes(const CheckedFile& file);

/// Whether the rows follow another law than the motion of the body, as far as they tell.
bool is_foreign(const check::Judgement& judgement);

}  // namespace twrench::app
