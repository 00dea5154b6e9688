// random_views COUNT: writes the contents of a page's views for COUNT random states in each theme,
// as this build computes them: a line of JSON with the state, then the numbers of its draw lists.
// tests/page/views_test.mjs compares them with those of the page's core.

#include <Eigen/Geometry>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "base/enumeration.h"
#include "page_views.h"

namespace twrench::page {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;
using picture::ViewContents;

json numbers(const auto& matrix) {
  json values = json::array();
  for (const auto row : matrix.rowwise()) {
    for (const double value : row) values.push_back(value);
  }
  return values;
}

/// Random motions and settings, the same in each run.
class Dice {
 public:
  double between(double low, double high) {
    const double share =
        static_cast<double>(random_()) / 4294967296.0;  // the same with every library
    return low + share * (high - low);
  }
  int below(int count) { return static_cast<int>(between(0, count)); }
  Vector3d vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

  Motion motion() {
    const double size = std::pow(10, between(-6, 6));
    const double a = between(0.1, 1), b = between(0.1, 1);
    const Vector3d moments = size * Vector3d(a, b, a + b * between(0.2, 0.99));
    Matrix3d R = Matrix3d::Identity();
    if (below(2) == 0) R = Eigen::AngleAxisd(between(0, 3), vector().normalized()).matrix();
    const Matrix3d inertia = R * moments.asDiagonal() * R.transpose();
    const Vector3d omega = std::pow(10, between(-2, 2)) * vector();
    motion::Interior interior;
    if (below(3) == 0) interior.wheel = size * omega.norm() * vector();
    if (below(3) == 0) interior.energy_loss_time = 1000 / omega.norm();
    return Motion({inertia, omega, Matrix3d::Identity(), interior});
  }

  Settings settings(const Motion& motion) {
    const double rate = motion.body.omega().norm();
    Settings settings;
    settings.width = 100 + below(1500);
    settings.height = 100 + below(1000);
    settings.thinnest = between(1, 3);
    settings.frame = below(static_cast<int>(enumerators<scene::Frame>.size()));
    settings.show = below(1 << enumerators<scene::Feature>.size());
    settings.stress = below(2) * below(1 << enumerators<scene::Feature>.size());
    settings.azimuth = between(-3, 3);
    settings.elevation = between(-1, 1);
    settings.distance = between(0.5, 2);
    settings.field_of_view = between(0.2, 1);
    settings.interval = below(2) * between(0, 0.5) / rate;
    settings.radius = std::pow(10, between(-6, 6));
    settings.trail_length = between(1, 12) / rate;
    settings.trail_x = settings.radius * between(-1, 1);
    settings.trail_y = settings.radius * between(-1, 1);
    settings.trail_z = settings.radius * between(-1, 1);
    settings.curve_begin = between(0, 100) / rate;
    settings.curve_end = settings.curve_begin + between(1, 300) / rate;
    return settings;
  }

  /// A time of the motion, and the trail before it.
  timeline::SolutionState instant(const Motion& motion, const Settings& settings) {
    const double t = between(0, 300) / motion.body.omega().norm();
    std::vector<double> times;
    for (int i = 20 + below(200); i >= 0; --i) {
      times.push_back(std::max(t - settings.trail_length * i / 220, 0.0));
    }
    timeline::SolutionState state;
    state.trail = motion.at(times);
    state.sample = state.trail.back();
    return state;
  }

 private:
  std::mt19937 random_{20};
};

template <typename Values>
void write_values(const Values& values) {
  const auto bytes = std::as_bytes(std::span(values));
  std::cout.write(reinterpret_cast<const char*>(bytes.data()),
                  static_cast<std::streamsize>(bytes.size()));
}

void write(json state, const ViewContents& contents) {
  const auto spans = [&](auto visit) {
    for (const picture::DrawList* list : {&contents.opaque, &contents.translucent}) {
      visit(list->vertices());
      for (const auto* triangles : {&list->items(), &list->outlines(), &list->ghosts()}) {
        visit(triangles->faces);
        visit(triangles->edge_quads);
      }
    }
  };
  spans([&](const auto& values) {
    state["sizes"].push_back(std::as_bytes(std::span(values)).size());
  });
  state["projection"] = numbers(contents.camera.projection);
  state["attitude"] = numbers(contents.camera.camera_from_space());
  state["distance"] = contents.camera.distance;
  state["labels"] = json::array();
  for (const picture::Label& label : contents.labels) {
    state["labels"].push_back({{"text", label.text},
                               {"anchor", {label.anchor.x(), label.anchor.y()}},
                               {"away", {label.away.x(), label.away.y()}},
                               {"color", {label.color.red, label.color.green, label.color.blue}}});
  }
  std::cout << state.dump() << '\n';
  spans([](const auto& values) { write_values(values); });
}

json samples(const timeline::SolutionState& instant) {
  json t = json::array(), X = json::array(), omega = json::array();
  for (const motion::Sample& sample : instant.trail) {
    t.push_back(sample.t);
    for (const json& value : numbers(sample.X)) X.push_back(value);
    for (const double value : sample.omega) omega.push_back(value);
  }
  return {{"t", t}, {"X", X}, {"omega", omega}};
}

void write_state(Dice& dice, scene::Theme theme) {
  const Motion motion = dice.motion();
  Settings settings = dice.settings(motion);
  settings.theme = static_cast<double>(theme);
  const picture::Viewpoint from{dice.between(-3, 3), dice.between(-1.5, 1.5),
                                dice.between(0.25, 4)};
  timeline::FrameState instants;
  for (int i = 0; i < 2; ++i) instants.solutions.push_back(dice.instant(motion, settings));
  json state{
      {"inertia", numbers(motion.body.inertia())},
      {"omega", numbers(motion.body.omega())},
      {"interior", {{"wheel", numbers(motion.body.interior().wheel)}}},
      {"from", {{"azimuth", from.azimuth}, {"elevation", from.elevation}, {"zoom", from.zoom}}},
      {"instants", {samples(instants.solutions[0]), samples(instants.solutions[1])}}};
  for (const auto& [name, field] : fields) state["settings"][name] = settings.*field;
  const double tau = motion.body.interior().energy_loss_time;
  if (std::isfinite(tau)) state["interior"]["energyLossTime"] = tau;
  const auto view = [&](std::string_view name) {
    state["view"] = name;
    return state;
  };
  write(view("body"), body_contents(motion, settings, from, instants));
  for (std::size_t i = 0; i < scene::insets.size(); ++i) {
    if (scene::insets[i].view == scene::View::poinsot && !motion.body.is_rigid()) continue;
    write(view(enumerator_name(scene::insets[i].feature)),
          inset_contents(motion, settings, i, from, instants));
  }
}

}  // namespace
}  // namespace twrench::page

int main(int, char** arguments) {
  twrench::page::Dice dice;
  for (const auto theme : twrench::enumerators<twrench::scene::Theme>) {
    for (int i = 0; i < std::atoi(arguments[1]); ++i) twrench::page::write_state(dice, theme);
  }
}
