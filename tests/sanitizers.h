#pragma once

namespace twrench {

/// Whether sanitizers check the tested code, which takes many times as long. A test that repeats a
/// computation of others with other numbers then finds no more errors, and skips itself.
#if defined(TWRENCH_SANITIZED)
constexpr bool has_sanitizers = true;
#else
constexpr bool has_sanitizers = false;
#endif

}  // namespace twrench
