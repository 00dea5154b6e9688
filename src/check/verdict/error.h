#pragma once

#include <twrench/base/error.h>

namespace twrench::check {

/// A trajectory that was read, but cannot be judged with what is known.
class CheckError : public Error {
 public:
  /// Why it cannot.
  enum class Reason {
    no_rates,  ///< there is an attitude alone, so nothing tells the initial angular velocity
    one_row,   ///< there are too few rows to judge, or to fit anything to
    at_rest,   ///< nor to a body that does not turn
  };

  CheckError(const std::string& what, const std::string& why, Reason reason)
      : Error(what, why), reason_(reason) {}

  Reason reason() const noexcept { return reason_; }

 private:
  Reason reason_;
};

}  // namespace twrench::check
