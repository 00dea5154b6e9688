// Scene files, and the values computed from a scene before drawing.
#include "scene/scene.h"

#include <twrench/base/error.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "scene/scene_json.h"
#include "target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace twrench;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const scene::Scene scene = scene::parse_scene(text, "input.toml");
    require(scene.frame_count() >= 1, "a film has a frame");
    scene::mass_properties(scene.body);
    scene::visible_parts(scene.body);
    scene::scene_json(scene).dump();
    scene::input_files(scene);
  } catch (const InvalidArgument&) {
  } catch (const system::FileError&) {  // the scene names a missing mesh
  }
  return 0;
}
