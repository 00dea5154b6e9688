// Measures in each built-in scene for how long the name of one arrow lies over another arrow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "picture/compose/label_painter.h"
#include "picture/compose/letters.h"
#include "picture/overlay_scene.h"
#include "picture/views/body_view.h"
#include "picture/views/shown.h"
#include "sanitizers.h"

namespace twrench::picture {
namespace {

using Eigen::Vector2d;

double distance(const Vector2d& point, const Vector2d& from, const Vector2d& to) {
  const Vector2d way = to - from;
  const double share = std::clamp(way.dot(point - from) / way.squaredNorm(), 0.0, 1.0);
  return (point - from - share * way).norm();
}

/// Whether the letters of one label lie over another's arrow.
bool is_over_an_arrow(const std::vector<Label>& labels, const std::vector<Layer>& layers,
                      double radius) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::vector<Vector2d> ink = letters(layers[i], labels[i].color);
    for (const Label& other : labels) {
      if (&other == &labels[i] || !other.root || (other.anchor - *other.root).norm() < 20) continue;
      if (std::ranges::any_of(ink, [&](const Vector2d& pixel) {
            return distance(pixel, *other.root, other.anchor) < radius;
          })) {
        return true;
      }
    }
  }
  return false;
}

/// Scenes, without and with the arrows of the body's axes.
class LabelsOf : public testing::TestWithParam<std::tuple<std::string, bool>> {};

TEST_P(LabelsOf, DoNotLieOverOtherArrowsForLong) {
  const auto& [name, with_axes] = GetParam();
  if (has_sanitizers && (name != "dzhanibekov" || !with_axes)) {
    GTEST_SKIP() << "repeats the computation with other numbers";
  }
  scene::Scene scene = scene::load_scene(name);
  if (with_axes) scene.overlay.show.insert(scene::Feature::axes);
  scene.film.width = 1280;
  scene.film.height = 720;
  std::vector<int> frames;
  constexpr int step = 2;
  for (int i = 0; i < std::min(scene.frame_count(), 960); i += step) frames.push_back(i);
  const timeline::Timeline timeline(scene, frames);
  const Layout layout = compute_layout(scene);
  const auto typeface = canvas::load_typeface("sans");
  const BodyView view(scene, timeline.solutions(), 0, layout.panes[0]);
  const LabelPainter painter(typeface.regular, layout.text.readout, {}, layout.panes[0].area, {});
  int run = 0, longest = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const ViewContents contents = shown_by(view, timeline.frame_state(static_cast<int>(i)));
    const std::vector<Layer> layers = painter.paint(contents.labels);
    run = is_over_an_arrow(contents.labels, layers, 2) ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  constexpr double most = 0.1;  // s of video
  EXPECT_LE(longest * step / scene.film.fps, most);
}

std::vector<std::string> scenes_of_one_shot() {
  std::vector<std::string> names = scene::builtin_scene_names();
  std::erase_if(names,
                [](const std::string& name) { return !scene::load_scene(name).shots.empty(); });
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, LabelsOf,
                         testing::Combine(testing::ValuesIn(scenes_of_one_shot()),
                                          testing::Bool()));

}  // namespace
}  // namespace twrench::picture
