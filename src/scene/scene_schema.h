#pragma once

#include <nlohmann/json_fwd.hpp>

namespace twrench::scene {

/// Returns the JSON Schema (draft 2020-12) of scene files. Editors complete and check files with
/// it. It accepts each file that the reader accepts. The reader rejects more: relations between
/// values, such as the order of the times of a speed curve, and what other files contain.
nlohmann::ordered_json scene_schema();

}  // namespace twrench::scene
