// Compares the contents of the views with numbers whose pictures were inspected and found correct.
// A golden image does not reveal a line that is 1 % fainter; the numbers do. To renew them, run
// TWRENCH_UPDATE_GOLDENS=1 picture_test, inspect the pictures of golden_test, and commit the
// numbers with the reason.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <span>
#include <string>
#include <vector>

#include "base/enumeration.h"
#include "picture/body/shader_constants.h"
#include "picture/compose/layout.h"
#include "picture/look/theme.h"
#include "picture/views/body_view.h"
#include "picture/views/inset_views.h"
#include "picture/views/momentum_view.h"
#include "picture/views/shown.h"
#include "sanitizers.h"
#include "system/file.h"

namespace twrench::picture {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Sums in which numbers at different places have different weights, so that an exchange of two
/// numbers is noticed, too.
class Digest {
 public:
  void add(double value) { sum_ += std::abs(value) * (1 + static_cast<double>(count_++ % 7) / 7); }
  double sum() const { return sum_; }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

/// Adds the number of rows of `width` floats, and a digest of each column.
void add_rows(json& numbers, std::span<const float> values, std::size_t width) {
  numbers.push_back(values.size() / width);
  for (std::size_t column = 0; column < width; ++column) {
    Digest digest;
    for (std::size_t i = column; i < values.size(); i += width) {
      digest.add(static_cast<double>(values[i]));
    }
    numbers.push_back(digest.sum());
  }
}

template <typename Rows>
void add_rows(json& numbers, const Rows& rows) {
  using Row = typename Rows::value_type;
  constexpr std::size_t width = sizeof(Row) / sizeof(float);
  add_rows(numbers, {reinterpret_cast<const float*>(rows.data()), rows.size() * width}, width);
}

void add_indices(json& numbers, const std::vector<std::uint32_t>& indices) {
  Digest digest;
  for (const std::uint32_t index : indices) digest.add(index);
  numbers.push_back(indices.size());
  numbers.push_back(digest.sum());
}

json numbers_of(const ViewContents& contents) {
  json numbers = json::array();
  for (const DrawList* list : {&contents.opaque, &contents.translucent}) {
    add_rows(numbers, list->vertices());
    for (const DrawList::Triangles* triangles :
         {&list->items(), &list->outlines(), &list->ghosts()}) {
      add_indices(numbers, triangles->faces);
      add_indices(numbers, triangles->edge_quads);
    }
    numbers.push_back(list->clip_z_nearer(1));
  }
  for (const Label& label : contents.labels) {
    for (const double x : {label.anchor.x(), label.anchor.y(), label.away.x(), label.away.y()}) {
      numbers.push_back(x);
    }
    for (const int channel : {label.color.red, label.color.green, label.color.blue}) {
      numbers.push_back(channel);
    }
  }
  for (const double x : contents.camera.projection.reshaped()) numbers.push_back(x);
  for (const double x : contents.camera.view.reshaped()) numbers.push_back(x);
  return numbers;
}

json numbers_of(const BodyModel& body) {
  json numbers = json::array();
  add_rows(numbers, body.mesh.vertices);
  // The shade in colours depends on rays that just miss an edge, and so on round-off. Their number
  // does not.
  numbers.push_back(body.mesh.colors.size());
  add_indices(numbers, body.mesh.indices);
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    const PartModel& part = body.parts[i];
    Digest digest;
    for (const float x : {part.radii.x, part.radii.y, part.radii.z}) {
      digest.add(static_cast<double>(x));
    }
    for (const glm::vec4& row : part.across_from_body) {
      for (const float x : {row.x, row.y, row.z, row.w}) digest.add(static_cast<double>(x));
    }
    for (const Capsule& capsule : part.occluders) {
      for (const double x : capsule.from) digest.add(x);
      for (const double x : capsule.to) digest.add(x);
      digest.add(capsule.radius);
      digest.add(capsule.meets ? 2 : 1);
    }
    numbers.push_back(digest.sum());
    // The numbers in the GLSL constants.
    const std::string constants = shader_constants(body.materials[i], body.studio);
    Digest of_material;
    const std::regex number(R"(-?\d+\.\d*(e[-+]\d+)?)");
    for (std::sregex_iterator found(constants.begin(), constants.end(), number), end; found != end;
         ++found) {
      of_material.add(std::stod(found->str()));
    }
    numbers.push_back(of_material.sum());
  }
  return numbers;
}

void add_area(json& numbers, const image::Area& area) {
  for (const int x : {area.x, area.y, area.width, area.height}) numbers.push_back(x);
}

json numbers_of(const Layout& layout) {
  json numbers = json::array();
  const auto add_pane = [&](const Layout::Pane& view) {
    add_area(numbers, view.area);
    add_area(numbers, view.focus);
    if (view.heading) add_area(numbers, *view.heading);
  };
  for (const Layout::Pane& body : layout.panes) add_pane(body);
  for (const auto& inset : layout.insets) {
    if (inset) add_pane(*inset);
  }
  for (const auto* area :
       {&layout.components, &layout.curve, &layout.title, &layout.description, &layout.readouts,
        &layout.forces, &layout.torques, &layout.tilt, &layout.moments}) {
    if (*area) add_area(numbers, **area);
  }
  for (const image::Area& area : layout.legends) add_area(numbers, area);
  if (layout.caption) add_area(numbers, layout.caption->area);
  for (const double size : {layout.text.title, layout.text.readout, layout.text.caption}) {
    numbers.push_back(size);
  }
  return numbers;
}

/// Returns a number for the layout of the scene in each of several sizes.
json numbers_of_layouts(scene::Scene scene) {
  json numbers = json::array();
  for (const auto& [width, height] : {std::pair(100, 60),
                                      {160, 90},
                                      {240, 320},
                                      {320, 180},
                                      {480, 270},
                                      {500, 500},
                                      {640, 300},
                                      {720, 1280},
                                      {1280, 720},
                                      {1600, 1200},
                                      {3840, 2160}}) {
    scene.film.width = width;
    scene.film.height = height;
    Digest digest;
    for (const json& x : numbers_of(compute_layout(scene))) digest.add(x);
    numbers.push_back(digest.sum());
  }
  return numbers;
}

/// Returns a built-in scene with all overlays of its body.
scene::Scene with_all(const std::string& name, scene::Theme theme, scene::Frame frame) {
  scene::Scene scene = scene::load_scene(name);
  if (!scene.shots.empty()) scene = scene.shots[1].scene;
  scene.shots.clear();
  scene.look.theme = theme;
  scene.camera.frame = frame;
  for (const scene::Feature feature : enumerators<scene::Feature>)
    scene.overlay.show.insert(feature);
  if (frame != scene::Frame::rotating) {
    scene.overlay.show.erase(scene::Feature::torques);
    scene.overlay.show.erase(scene::Feature::tip);
  }
  return scene;
}

json numbers_of(const scene::Scene& scene) {
  const timeline::Timeline timeline(scene, {scene.frame_count() / 3});
  const Layout::Pane view_pane{{10, 20, 640, 480}, {60, 40, 500, 400}};
  const timeline::FrameState state = timeline.frame_state(0);
  const auto& solutions = timeline.solutions();
  const BodyView body(scene, solutions, 0, view_pane);
  // There, bevels have their share of a body's size instead of a least width in pixels.
  const BodyView large(scene, solutions, 0, {{0, 0, 2560, 1920}, {0, 0, 2560, 1920}});
  const MomentumView sphere(scene, solutions, 0, view_pane);
  ViewContents still;
  still.begin(sphere.camera(0), view_pane.area);
  sphere.add_still(still);
  json numbers{
      {"body", numbers_of(shown_by(body, state))},   {"surface", numbers_of(body.body())},
      {"large surface", numbers_of(large.body())},   {"sphere", numbers_of(still)},
      {"layout", numbers_of(compute_layout(scene))}, {"layouts", numbers_of_layouts(scene)}};
  for (const InsetView& row : inset_views) {
    const auto view = row.make(scene, solutions, view_pane);
    numbers[std::string(enumerator_name(row.view))] = numbers_of(shown_by(*view, state));
  }
  return numbers;
}

const fs::path golden_numbers = fs::path(TWRENCH_TESTS_DIR) / "golden" / "view-contents.json";

/// Returns each built-in scene, with varying themes and frames.
std::map<std::string, scene::Scene> scenes() {
  std::map<std::string, scene::Scene> all;
  std::size_t i = 0;
  for (const std::string& name : scene::builtin_scene_names()) {
    // Another theme changes only colours and lights, so new ones need no numbers.
    constexpr std::array themes{scene::Theme::studio, scene::Theme::paper, scene::Theme::space};
    constexpr auto& frames = enumerators<scene::Frame>;
    all[name] = with_all(name, themes[i % themes.size()], frames[i / 2 % frames.size()]);
    ++i;
  }
  return all;
}

void expect_close(const json& found, const json& expected, const std::string& what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double wanted = expected[i];
    EXPECT_NEAR(found[i], wanted, 1e-6 * std::max(std::abs(wanted), 1e-3))
        << what << ", number " << i;
  }
}

TEST(ContentsOfViews, AreTheGoldenNumbers) {
  if (has_sanitizers) GTEST_SKIP() << "tests the numbers of views that others draw";
  json found;
  for (const auto& [name, scene] : scenes()) found[name] = numbers_of(scene);
  if (std::getenv("TWRENCH_UPDATE_GOLDENS") != nullptr) {
    std::string text = "{\n";
    for (const auto& [name, views] : found.items()) {
      for (const auto& [view, numbers] : views.items()) {
        text +=
            (text.size() > 2 ? ",\n" : "") + json(name + " " + view).dump() + ": " + numbers.dump();
      }
    }
    system::write_file_atomically(golden_numbers, text + "\n}\n");
    return;
  }
  const json golden = json::parse(std::ifstream(golden_numbers));
  for (const auto& [name, views] : found.items()) {
    for (const auto& [view, numbers] : views.items()) {
      const std::string what = name + " " + view;
      ASSERT_TRUE(golden.contains(what)) << what;
      expect_close(numbers, golden[what], what);
    }
  }
}

}  // namespace
}  // namespace twrench::picture
