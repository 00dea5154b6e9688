#pragma once

#include <twrench/base/error.h>

namespace twrench::check {

/// A trajectory was read, but cannot be judged because information is missing.
class CheckError : public Error {
 public:
  /// Why it cannot be judged.
  enum class Reason {
    one_row,     ///< there are too few rows to judge or to fit
    at_rest,     ///< the body does not turn, so nothing can be fitted
    no_fit,      ///< no state near the given one fits
    no_inertia,  ///< the rows do not determine the ratios of the moments
    stopped,     ///< interrupted through Problem::stop
  };

  CheckError(const std::string& what, const std::string& why, Reason reason,
             const std::string& remedy = {})
      : Error(what, why, remedy), reason_(reason) {}

  Reason reason() const noexcept { return reason_; }

 private:
  Reason reason_;
};

}  // namespace twrench::check
