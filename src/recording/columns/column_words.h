#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recording/conventions/names.h"

namespace twrench::recording {

/// A meaning of a column that its name allows: one component of a kind.
struct Role {
  /// Columns belong together if their groups are equal: their names differ only in the word for the
  /// component.
  std::string group;
  std::size_t component = 0;  ///< index in names_of(kind); for "q0" and the like, the number
  bool in_space = false;      ///< for rates
  bool is_open = false;       ///< for q0 ... q3, r0 ... r8 and euler[0], whose order is open
  bool is_weak = false;       ///< for rx and sigma_1, which also have other usual meanings
};

/// Returns the roles of this kind that a column of this name may have. What precedes a point, a
/// colon or a slash may name an owner: "Sat.Q1", "IMU_ATTI(0):gyroX", "6DOF/omega_b(1)".
std::vector<Role> roles_of(std::string_view name, Kind kind);

}  // namespace twrench::recording
