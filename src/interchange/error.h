#pragma once

#include <twrench/base/error.h>

namespace twrench::interchange {

/// A format's numbers cannot hold the motion as accurately as was asked for.
class AccuracyError : public Error {
 public:
  using Error::Error;
};

}  // namespace twrench::interchange
