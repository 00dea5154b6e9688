#pragma once

#include <twrench/base/error.h>

namespace twrench::interchange {

/// A format's numbers cannot represent the motion as accurately as requested.
class AccuracyError : public Error {
 public:
  using Error::Error;
};

}  // namespace twrench::interchange
