#include "scene/interior.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/enumeration.h"

namespace twrench::scene {
namespace {

/// Returns whether all motions of the scene, without its shots, are those of a rigid body.
bool is_rigid(const Scene& scene) {
  return scene.motion.is_rigid() && scene.overlay.compare_wheel.empty();
}

/// Returns whether a feature is computed from the closed form or from the energy of a rigid body.
bool needs_rigid_body(Feature feature) {
  static constexpr std::array features{Feature::plane, Feature::poinsot, Feature::phase,
                                       Feature::forces, Feature::moments};
  return std::ranges::find(features, feature) != features.end();
}

/// Returns the features of a film that have a meaning only for the scene's body if it is rigid.
std::vector<std::string> features_of_rigid_bodies(const Scene& scene) {
  std::vector<std::string> names;
  for (const Feature feature : scene.overlay.show) {
    // An energy that is lost is no error.
    const bool is_loss = feature == Feature::drift && scene.motion.energy_loss_time;
    if (is_loss || needs_rigid_body(feature)) names.emplace_back(enumerator_name(feature));
  }
  return names;
}

}  // namespace

void check_interior(const Scene& scene,
                    const std::function<std::string(const std::string& key)>& name_of) {
  if (is_rigid(scene)) return;
  try {
    shown_bodies(scene);
  } catch (const InvalidArgument& error) {
    const std::string why = std::string(error.what()).substr(error.quantity().size() + 2);
    throw InvalidArgument(name_of(error.quantity()), why, error.remedy());
  }
}

void check_shown_motion(const Scene& film) {
  const auto require = [](bool is_shown, const std::string& key, const std::string& what,
                          const std::string& remedy) {
    if (is_shown) return;
    throw InvalidArgument(key, what + " can be shown only of a rigid body", remedy);
  };
  if (film.shots.empty() && !is_rigid(film)) {
    const Overlay& overlay = film.overlay;
    require(overlay.view == View::wrench || overlay.view == View::momentum, "view",
            std::string(enumerator_name(overlay.view)), "use the view wrench or momentum");
    const std::string names = fmt::format("{}", fmt::join(features_of_rigid_bodies(film), ","));
    require(names.empty(), "show", names, "hide it: " + names);
  }
  for (const Shot& shot : film.shots) check_shown_motion(shot.scene);
}

void require_rigid(const Scene& scene, const std::string& what) {
  if (!scene.motion.is_rigid()) {
    throw InvalidArgument(scene.motion.wheel ? "wheel" : "energy_loss_time",
                          what + " needs the closed form of a rigid body's motion",
                          "use a rigid body; simulate computes the motion of any body");
  }
  for (const Shot& shot : scene.shots) require_rigid(shot.scene, what);
}

}  // namespace twrench::scene
