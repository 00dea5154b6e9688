#include "page/page_json.h"

#include <nlohmann/json.hpp>
#include <span>

#include "base/enumeration.h"
#include "base/time_unit.h"
#include "page/recording_json.h"
#include "page/surface_json.h"
#include "page/theme_json.h"
#include "scene/interior.h"
#include "scene/limits.h"
#include "scene/scene_json.h"

namespace twrench::page {
namespace {

using nlohmann::ordered_json;

ordered_json range_json(const scene::limits::Limit& limit) { return {limit.low, limit.high}; }

ordered_json limits_json() {
  namespace limits = scene::limits;
  return {{"moment", range_json(limits::moment)},
          {"moment_ratio", limits::max_moment_ratio},
          {"omega", range_json(limits::coordinate)},
          {"wheel", range_json(limits::angular_momentum)},
          {"energy_loss_time", range_json(limits::energy_loss_time)},
          {"step", range_json(limits::step)},
          {"tolerance", range_json(limits::tolerance)},
          {"time", {-limits::duration.high, limits::duration.high}}};
}

ordered_json names_json(std::span<const scene::Feature> features) {
  ordered_json names = ordered_json::array();
  for (const scene::Feature feature : features) names.push_back(enumerator_name(feature));
  return names;
}

ordered_json rows_json(const Eigen::Matrix3d& matrix) {
  ordered_json numbers = ordered_json::array();
  for (const auto row : matrix.rowwise()) {
    for (const double value : row) numbers.push_back(value);
  }
  return numbers;
}

/// The units of time, the longest first, each with the shortest time that is written in it, its
/// length in s and its symbol.
ordered_json time_units_json() {
  ordered_json units = ordered_json::array();
  for (const TimeUnit& unit : time_units()) units.push_back({unit.from, unit.length, unit.symbol});
  return units;
}

}  // namespace

ordered_json page_json(const scene::Scene& scene, const Surface& surface,
                       const motion::RecordedMotion* recording) {
  const Materials materials = materials_of(scene.body);
  scene::Scene alone = scene;
  alone.shots.clear();
  const motion::FreeBody body = scene::free_body(scene);
  ordered_json json{{"scene", scene::scene_json(alone)},
                    {"inertia", rows_json(body.inertia())},
                    {"surface", surface_json(scene, surface, materials)},
                    {"themes", themes_json(scene.look, materials)},
                    {"limits", limits_json()},
                    {"rigid_features", names_json(scene::features_of_rigid_bodies)},
                    {"lossless_features", names_json(scene::features_of_lossless_bodies)},
                    {"time_units", time_units_json()}};
  if (scene.motion.attitude) json["attitude"] = rows_json(body.attitude());
  if (recording != nullptr) {
    json["recording"] = recording_json(*scene.motion.recording, *recording);
  }
  return json;
}

}  // namespace twrench::page
