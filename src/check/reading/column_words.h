#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "check/conventions/names.h"

namespace twrench::check {

/// What a column can be, as its name says: one component of a kind.
struct Role {
  /// Which columns belong together: those of one group have the same words but for the component's.
  std::string group;
  std::size_t component = 0;  ///< in names_of(kind); of "q0" and the like, the number
  bool in_space = false;      ///< of rates
  bool is_open = false;       ///< of q0 ... q3 and r0 ... r8: their order is left open
};

/// All that a column with these words in its name can be of this kind.
std::vector<Role> roles_of(const std::vector<std::string>& words, Kind kind);

}  // namespace twrench::check
