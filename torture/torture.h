#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace twrench::torture {

/// What the program is asked: SECONDS SEED [CASE]
struct Request {
  double seconds = 0;
  std::uint32_t seed = 0;
  std::string only;  ///< the one case to try; empty: as many as the time allows
};

/// Ends the program with its usage where the words are not such a request.
Request parse_request(int argc, char** argv);

/// Gives up root's rights, before which no permission is refused, where `program` can be run
/// without them.
void become_nobody(const std::string& program);

/// Calls `work` with 0, 1, 2, ..., on as many threads as there are processors, until the seconds
/// are over or `count` are done. Returns how many were.
std::size_t run_cases(double seconds, std::size_t count,
                      const std::function<void(std::uint32_t number)>& work);

/// Says something whole, whichever threads speak.
void tell(const std::string& text);

}  // namespace twrench::torture
