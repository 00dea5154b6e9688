#include "scene/interior.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/enumeration.h"
#include "scene/shown_recording.h"

namespace twrench::scene {
namespace {

/// Returns whether all motions of the scene, without its shots, are those of a rigid body.
bool is_rigid(const Scene& scene) {
  return scene.motion.is_rigid() && scene.overlay.compare_wheel.empty();
}

/// Returns the features of a film that have no meaning for the scene's body, which is not rigid.
std::vector<std::string> meaningless_features(const Scene& scene) {
  const auto contains = [](const auto& features, Feature feature) {
    return std::ranges::find(features, feature) != features.end();
  };
  std::vector<std::string> names;
  for (const Feature feature : scene.overlay.show) {
    const bool is_lost =
        scene.motion.energy_loss_time && contains(features_of_lossless_bodies, feature);
    if (is_lost || contains(features_of_rigid_bodies, feature)) {
      names.emplace_back(enumerator_name(feature));
    }
  }
  return names;
}

void require_recorded(const Motion& motion) {
  const double end = motion.recording->motion.duration();
  constexpr double rounding = 1 + 1e-9;
  if (motion.duration <= end * rounding) return;
  throw InvalidArgument(
      motion.recording->file,
      fmt::format("it lasts {:.6g} s, but {:.6g} s are to be shown", end, motion.duration),
      "ask for a shorter duration, or leave it out");
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
  if (film.motion.recording) require_recorded(film.motion);
  const auto require = [](bool is_shown, const std::string& key, const std::string& what,
                          const std::string& remedy) {
    if (is_shown) return;
    throw InvalidArgument(key, what + " can be shown only of a rigid body", remedy);
  };
  if (film.shots.empty() && !is_rigid(film)) {
    const Overlay& overlay = film.overlay;
    require(overlay.view == View::wrench || overlay.view == View::momentum, "view",
            std::string(enumerator_name(overlay.view)), "use the view wrench or momentum");
    const std::string names = fmt::format("{}", fmt::join(meaningless_features(film), ","));
    require(names.empty(), "show", names, "hide it: " + names);
  }
  for (const Shot& shot : film.shots) check_shown_motion(shot.scene);
}

void require_rigid(const Scene& scene, const std::string& what) {
  if (scene.motion.is_rigid()) return;
  const bool has_both = scene.motion.wheel && scene.motion.energy_loss_time;
  const char* const one = scene.motion.wheel ? "wheel" : "energy_loss_time";
  throw InvalidArgument(has_both ? "energy_loss_time and wheel" : one,
                        what + " needs the closed form of a rigid body's motion",
                        "use a rigid body; simulate computes the motion of any body");
}

}  // namespace twrench::scene
