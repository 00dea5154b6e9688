#pragma once

#include <nlohmann/json_fwd.hpp>

#include "cases/case.h"

namespace twrench::cases {

/// Returns a case with its published values, the exact ones beside them, and the exact states at
/// times_of(). Rates are in rad/s unless a unit is beside them; quaternions have the scalar first.
nlohmann::ordered_json case_json(const Case& problem);

/// Returns the parameters of a case and its source.
nlohmann::ordered_json summary_json(const Case& problem);

}  // namespace twrench::cases
