#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

/// Processes one input, which must succeed or throw an Error. The name and signature are
/// libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace twrench {

/// Aborts the program, which a fuzzer reports, unless the property holds.
inline void require(bool property, const char* what) {
  if (property) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

}  // namespace twrench
