#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/judge.h"
#include "check/reading.h"

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
  /// The only other way to read it that fits the physics, where it does not fit as it is read.
  std::optional<check::Reading> proposal;
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

/// A quantity of rates in the file's unit, and the unit's name.
struct RateUnit {
  double per_radian;
  const char* name;        ///< "deg/s"
  const char* angle_name;  ///< "deg"
};
RateUnit rate_unit(const check::Judgement& judgement);

/// rad in degrees.
double degrees(double angle);

/// Returns the options to add where the first convention is in force, so that the second is:
/// "--units deg --inverse".
std::string option_text(const check::Convention& before, const check::Convention& after);

/// Returns what is to be told of a file in one line.
std::string verdict(const CheckedFile& file);

/// Whether the rows follow another law than the motion of the body, as far as they tell.
bool is_foreign(const check::Judgement& judgement);

}  // namespace twrench::app
