#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

/// Reads one input. Whatever it is, that ends well or in an Error; libFuzzer's name and signature.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace twrench {

/// Ends the program, which a fuzzer takes for a finding, unless the property holds.
inline void require(bool property, const char* what) {
  if (property) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

}  // namespace twrench
