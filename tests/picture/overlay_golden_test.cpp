// Overlays without the body, compared with images that were inspected and found correct. To change
// an image, run TWRENCH_UPDATE_GOLDENS=1 picture_test, inspect the new image, and commit it with
// the reason.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "picture/compose/label_painter.h"
#include "picture/golden.h"
#include "picture/hud/angle_panel.h"
#include "picture/hud/component_panel.h"
#include "picture/hud/curve_panel.h"
#include "picture/hud/hud.h"
#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

struct OverlayGolden {
  const char* name;
  scene::Scene scene;
};

void PrintTo(const OverlayGolden& golden, std::ostream* out) { *out << golden.name; }

std::vector<OverlayGolden> overlay_goldens() {
  const auto film = [](int width, int height, scene::Theme theme = scene::Theme::studio) {
    scene::Scene scene = film_of(width, height);
    scene.motion.method = "exact";
    scene.motion.duration = 48;
    scene.look.theme = theme;
    using enum scene::Feature;
    scene.overlay.show.insert({components, method, drift});
    return scene;
  };
  scene::Scene mono = film(640, 360);
  mono.overlay.font = "mono";
  scene::Scene paper = film(480, 480, scene::Theme::paper);
  paper.overlay.show.erase(scene::Feature::sphere);
  scene::Scene compared = film(854, 480);
  compared.overlay.compare = {"lie-euler", "rk4", "exact"};
  compared.motion.control.step = 0.1;
  scene::Scene in_rows = film(360, 640);
  in_rows.overlay.compare = {"euler", "strang"};
  in_rows.motion.control.step = 0.1;
  scene::Scene quad = film(640, 360);
  quad.overlay.view = scene::View::quad;
  return {{"overlay", film(854, 480)},       {"overlay-portrait", film(360, 640)},
          {"overlay-small", film(320, 180)}, {"overlay-mono", mono},
          {"overlay-paper", paper},          {"overlay-quad", quad},
          {"overlay-compare", compared},     {"overlay-compare-rows", in_rows}};
}

/// Returns the frame state in the middle of the video, modified by `change`.
timeline::FrameState middle(const OverlayScene& film,
                            const std::function<void(timeline::SolutionState&)>& change) {
  timeline::FrameState state = film.timeline.frame_state(0);
  for (std::size_t i = 0; i < state.solutions.size(); ++i) {
    const timeline::Solution& solution = film.timeline.solutions()[i];
    timeline::SolutionState& instant = state.solutions[i];
    instant.sample = solution.whole[solution.whole.size() / 2];
    instant.diagnostics = motion::diagnose(solution.body, solution.initial_energy, instant.sample);
    // Round-off differs between machines.
    if (solution.method->name == "exact") instant.diagnostics = {0, -1.2e-15, 3.4e-16, 0};
    if (solution.method->name == "strang") instant.diagnostics.orthogonality_error = 0;
    if (solution.method->name == "rk4") instant.diagnostics.orthogonality_error = 5e-15;
    if (solution.method->name == "lie-euler") instant.diagnostics.orthogonality_error = 6e-15;
    instant.flips = 2;
    change(instant);
  }
  return state;
}

image::Image drawn(
    const scene::Scene& scene,
    const std::function<void(timeline::SolutionState&)>& change = [](timeline::SolutionState&) {}) {
  const OverlayScene film(scene);
  const auto& solutions = film.timeline.solutions();
  const timeline::FrameState state = middle(film, change);
  image::Image image(scene.film.width, scene.film.height, 3);
  // This background is visible through a panel that darkens or brightens it.
  image.pixels.assign(image.pixels.size(), 110);
  const auto lay = [&](const std::vector<Layer>& layers) {
    for (const Layer& layer : layers) composite_over(image, layer);
  };
  if (film.layout.components) {
    ComponentPanel panel(film.scene, solutions, film.layout, film.typeface, film.colors);
    lay(panel.draw(state));
  }
  if (film.layout.curve) {
    CurvePanel panel(film.scene, solutions, film.layout, film.typeface, film.colors);
    lay(panel.draw(state));
  }
  if (film.layout.angle) {
    AnglePanel panel(film.scene, solutions, film.layout, film.typeface, film.colors);
    lay(panel.draw(state));
  }
  Hud hud(film.scene, solutions, film.layout, film.typeface, film.colors);
  lay(hud.draw(state));
  const LabelPainter painter(film.typeface.regular, film.layout.text.readout, film.colors.panel,
                             {0, 0, image.width, image.height}, hud.extents());
  const image::Area& focus = film.layout.panes[0].focus;
  const Eigen::Vector2d end(focus.x + focus.width / 2.0, focus.y + focus.height / 2.0);
  lay(painter.paint({{"L", end, {1, 0}, film.colors.momentum},
                     {"ω", end, {0.9, 0.4}, film.colors.omega},
                     {"x₁", {0, 0}, {0, -1}, film.colors.axis[0]}}));
  return image;
}

/// Releases of Cairo and of compilers round coverage differently, by a few levels of 255. The
/// glyphs of Roboto 2 and Roboto 3, which releases of Debian have, differ at edges by up to 61
/// (docs/platforms.md). A single changed digit changes a dozen pixels by far more.
bool same_words(const image::Image& a, const image::Image& b) {
  constexpr int threshold = 80;
  constexpr double most_pixels = 6;
  const auto difference = image::compare(a, b, threshold);
  return difference && difference->share * a.width * a.height <= most_pixels;
}

class OverlayGoldenImage : public testing::TestWithParam<OverlayGolden> {};

TEST_P(OverlayGoldenImage, IsDrawn) {
  expect_golden(GetParam().name, drawn(GetParam().scene), same_words);
}

// The thresholds must detect these changes.
TEST_P(OverlayGoldenImage, SeesOneFigureOrPointThatIsAnother) {
  const image::Image golden = image::read_png(golden_path(GetParam().name));
  EXPECT_FALSE(same_words(
      drawn(GetParam().scene, [](timeline::SolutionState& i) { i.sample.t += 0.1; }), golden));
  EXPECT_FALSE(
      same_words(drawn(GetParam().scene,
                       [](timeline::SolutionState& i) { i.diagnostics.energy_drift = 7e-3; }),
                 golden));
}

INSTANTIATE_TEST_SUITE_P(All, OverlayGoldenImage, testing::ValuesIn(overlay_goldens()),
                         [](const auto& param) {
                           std::string name(param.param.name);
                           std::erase(name, '-');
                           return name;
                         });

TEST(ComponentsInTheGoldens, ShowATransposedPose) {
  const scene::Scene scene = overlay_goldens()[0].scene;
  EXPECT_FALSE(
      same_words(drawn(scene, [](timeline::SolutionState& i) { i.sample.X.transposeInPlace(); }),
                 drawn(scene)));
}

}  // namespace
}  // namespace twrench::picture
