#include "app/reports/scene_list.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include "scene/motion_summary.h"
#include "scene/scene.h"

namespace twrench::app {
namespace {

std::string description_of_scene(const std::string& name) {
  try {
    const scene::Scene scene = scene::load_scene(name);
    return fmt::format("{}; {}", scene.title, motion_summary(scene));
  } catch (const Error& error) {
    return fmt::format("invalid: {}", error.what());
  }
}

}  // namespace

std::string scene_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += fmt::format("{:<13} {}\n", name, description_of_scene(name));
  }
  return text;
}

}  // namespace twrench::app
