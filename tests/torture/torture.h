#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace twrench::torture {

/// The program's arguments: SECONDS SEED [CASE].
struct Request {
  double seconds = 0;
  std::uint32_t seed = 0;
  std::string only;  ///< the single case to run; empty for as many as the time allows
};

/// Exits with the usage if the arguments are invalid.
Request parse_request(int argc, char** argv);

/// Drops root's rights, because root has every permission, if `program` can run without them.
void become_nobody(const std::string& program);

/// Calls `work` with 0, 1, 2, ..., on all processors, until the seconds are over or `count` are
/// done. Returns the number of calls.
std::size_t run_cases(double seconds, std::size_t count,
                      const std::function<void(std::uint32_t number)>& work);

/// Prints a text without interleaving between threads.
void tell(const std::string& text);

}  // namespace twrench::torture
