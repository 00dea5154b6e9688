#pragma once

#include <atomic>

#include "check/verdict/error.h"

namespace twrench::check {

/// Throws CheckError if the caller wants a check to end. `stop` may be null.
inline void throw_if_stopped(const std::atomic<bool>* stop) {
  if (stop == nullptr || !stop->load(std::memory_order_relaxed)) return;
  throw CheckError("check", "was stopped", CheckError::Reason::stopped);
}

}  // namespace twrench::check
