// Scene files, and what is computed from a scene before drawing.
#include "scene/scene.h"

#include <string_view>

#include "base/error.h"
#include "scene/scene_json.h"
#include "target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace twrench;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const Scene scene = parse_scene(text, "input.toml");
    require(scene.frame_count() >= 1, "a film has a frame");
    mass_properties(scene.body);
    visible_parts(scene.body);
    scene_json(scene).dump();
  } catch (const UsageError&) {
  }
  return 0;
}
