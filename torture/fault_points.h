#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace twrench::torture {

/// One call that is made to fail; see fault_shim.cpp.
struct FaultPoint {
  std::string scenario;
  std::string kind;     ///< "open", "memory" ...
  long number = 1;      ///< of the call, from 1
  std::string error;    ///< "ENOSPC"
  bool always = false;  ///< this call and all that follow, else this one alone

  /// "SCENARIO/KIND/NUMBER/ERROR/once|always"
  std::string text() const;
  /// TWRENCH_FAULT's value
  std::string order() const;
};

/// Throws std::invalid_argument where the text names no such point.
FaultPoint parse_fault_point(const std::string& text);

/// How many calls of each kind a scenario makes, of a log of the shim's.
std::map<std::string, long> read_call_counts(const std::string& log);

/// What is known of a scenario before its calls are made to fail.
struct CallCounts {
  std::string scenario;
  std::map<std::string, long> calls;  ///< by kind
  long memory_points = 0;             ///< how many of the allocations are tried, at most
};

/// All points in a random order of the seed: those of system calls, in which each call fails once
/// before any fails in another way, each followed by two of memory.
std::vector<FaultPoint> all_fault_points(const std::vector<CallCounts>& counts, std::uint32_t seed);

}  // namespace twrench::torture
