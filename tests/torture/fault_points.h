#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace twrench::torture {

/// A call that is made to fail; see fault_shim.cpp.
struct FaultPoint {
  std::string scenario;
  std::string kind;     ///< "open", "memory" ...
  long number = 1;      ///< of the call, starting at 1
  std::string error;    ///< "ENOSPC"
  bool always = false;  ///< this call and all later ones, otherwise only this one

  /// Returns "SCENARIO/KIND/NUMBER/ERROR/once|always".
  std::string text() const;
  /// Returns the value of TWRENCH_FAULT.
  std::string order() const;
};

/// Throws std::invalid_argument if the text does not describe a point.
FaultPoint parse_fault_point(const std::string& text);

/// Returns the number of calls of each kind that a scenario makes, from the shim's log.
std::map<std::string, long> read_call_counts(const std::string& log);

/// The calls of a scenario without faults.
struct CallCounts {
  std::string scenario;
  std::map<std::string, long> calls;  ///< by kind
  long memory_points = 0;             ///< maximum number of allocations to try
};

/// Returns all points in a random order given by the seed. Each system call fails once before any
/// fails in another way; two memory points follow each of these points.
std::vector<FaultPoint> all_fault_points(const std::vector<CallCounts>& counts, std::uint32_t seed);

}  // namespace twrench::torture
