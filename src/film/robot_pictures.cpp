#include "film/robot_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "film/page_pictures.h"
#include "scene/limits.h"
#include "scene/link_scene.h"
#include "scene/mesh_scene.h"

namespace twrench::film {
namespace {

/// A scene of a link with its ellipsoid of equal inertia, and nothing else.
scene::Scene link_picture(const robot::JudgedRobot& judged, std::size_t link,
                          const robot::LinkMass& mass) {
  scene::Scene scene =
      scene::body_scene(judged.robot.links[link].name, scene::link_body(judged, link, mass));
  scene.overlay.show = {scene::Feature::inertia, scene::Feature::axes};
  // The same before and after the repair.
  scene.camera.azimuth = 0.6, scene.camera.elevation = 0.35;
  return scene;
}

/// Whether a link with this inertia can be drawn: a scene can have its moments, and beside an
/// ellipsoid that is much larger than the link, it would be a dot.
bool is_drawable(const robot::JudgedRobot& judged, std::size_t link, const robot::LinkMass& mass) {
  const Eigen::Vector3d moments = robot::principal_moments(mass.inertia);
  constexpr double g_cm2 = 1e-7;  // kg m^2
  const bool is_body = mass.mass > 0.0 && moments[0] >= g_cm2 * scene::limits::moment.low &&
                       moments[2] <= g_cm2 * scene::limits::moment.high;
  if (!is_body) return false;
  const robot::LinkGeometry& geometry = judged.geometries[link];
  double size = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
    size = std::max(size, geometry.extent(axis) + geometry.extent(-axis));
  }
  constexpr double largest = 5.0;
  return geometry.parts().empty() || std::sqrt(moments[2] / mass.mass) < largest * size;
}

}  // namespace

robot::RobotPictures robot_pictures(const robot::JudgedRobot& judged, const robot::Repair& repair,
                                    const gl::BackendChoice& backend) {
  constexpr std::size_t most_links = 50;
  std::map<std::size_t, const robot::Change*> changes;
  for (const robot::Change& change : repair.changes) changes.emplace(change.index, &change);
  std::vector<scene::Scene> scenes;
  std::vector<std::pair<std::size_t, std::string robot::LinkPictures::*>> places;
  const auto add = [&](std::size_t link, const robot::LinkMass& mass,
                       std::string robot::LinkPictures::*place) {
    if (!is_drawable(judged, link, mass)) return;
    scenes.push_back(link_picture(judged, link, mass));
    places.emplace_back(link, place);
  };
  robot::RobotPictures result;
  std::size_t links = 0;
  for (const std::size_t i : robot::worst_first(judged)) {
    if (!judged.diagnoses[i].is_bad()) continue;
    if (++links > most_links) {
      ++result.left_out;
      continue;
    }
    add(i, judged.diagnoses[i].body, &robot::LinkPictures::before);
    if (const auto change = changes.find(i); change != changes.end())
      add(i, change->second->after, &robot::LinkPictures::after);
  }
  if (scenes.empty()) return result;
  const std::vector<std::string> pictures = still_pictures(scenes, backend);
  for (std::size_t i = 0; i < places.size(); ++i)
    result.of_links[places[i].first].*places[i].second = pictures[i];
  return result;
}

}  // namespace twrench::film
