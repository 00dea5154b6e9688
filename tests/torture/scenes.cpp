// torture_scenes SECONDS SEED [CASE]: draws random scenes, valid except for some of their meshes,
// until the time is over, or a single one of them. Faults are: an undocumented exception, a picture
// of the wrong size or with damaged areas beyond its edges, and a frame drawn in reused memory that
// differs from the same frame in new memory. Assertions detect layers outside the picture, and
// sanitizers other errors, so build with both.
//
// Case k is made by a generator seeded only from SEED and k. Its number is printed on standard
// error while it is drawn, so that the last one is the one that crashed.
#include <fmt/format.h>
#include <twrench/motion/error.h>
#include <twrench/motion/method.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/enumeration.h"
#include "draw/renderer.h"
#include "gl/backend.h"
#include "gl/child_call.h"
#include "gl/context.h"
#include "random_body.h"
#include "scene/scene.h"
#include "scene/scene_json.h"
#include "timeline/timeline.h"

namespace twrench::torture {
namespace {

using Eigen::Vector3d;

scene::Motion random_motion(SceneDice& dice) {
  scene::Motion motion;
  const double speed = dice.spread(0.1, 100);
  const double kind = dice.uniform(0, 1);
  motion.omega = speed * (kind < 0.1   ? Vector3d(Vector3d::Unit(dice.whole(0, 2)))
                          : kind < 0.2 ? Vector3d(1, 1e-3, 1e-3)
                                       : dice.vector(-1, 1));
  if (dice.chance(0.05)) motion.omega.setZero();
  motion.method = dice.pick(motion::methods()).name;
  motion.control.step = dice.spread(0.003, 0.1) / speed;
  motion.control.tolerance = dice.spread(1e-12, 1e-4);
  motion.duration = dice.spread(1, 100) / speed;
  return motion;
}

/// Usually about 10^5 pixels with any aspect ratio, sometimes as long as possible.
scene::Film random_film(SceneDice& dice, const scene::Motion& motion) {
  scene::Film film;
  const bool extreme = dice.chance(0.15);
  const double area = dice.spread(400, 300'000);
  const double aspect = extreme ? dice.spread(0.01, 100) : dice.spread(0.2, 5);
  const auto side = [](double length) {
    return static_cast<int>(std::clamp(std::round(length), 16.0, 4000.0));
  };
  film.width = side(std::sqrt(area * aspect));
  film.height = side(std::sqrt(area / aspect));
  film.fps = dice.spread(1, 120);
  film.speed = film.fps * motion.duration / dice.spread(1, 1000);
  return film;
}

scene::Look random_look(SceneDice& dice) {
  scene::Look look;
  look.theme = dice.pick(enumerators<scene::Theme>);
  look.samples = dice.pick(std::array{1, 1, 1, 2, 4});
  look.motion_blur = dice.chance(0.3) ? dice.whole(2, 4) : 1;
  const double kind = dice.uniform(0, 1);
  look.transparent = kind < 0.2;
  if (kind > 0.8) look.background = random_color(dice);
  vary(dice, look);
  return look;
}

scene::CameraPath random_camera(SceneDice& dice) {
  scene::CameraPath camera;
  camera.azimuth = dice.uniform(-10, 10);
  if (dice.chance(0.5)) camera.elevation = dice.uniform(-1, 1) * std::numbers::pi / 2;
  if (dice.chance(0.05)) camera.elevation = std::copysign(std::numbers::pi / 2, camera.azimuth);
  if (dice.chance(0.3)) camera.distance = dice.spread(0.2, 20);
  if (dice.chance(0.3)) camera.orbit = dice.uniform(-3, 3);
  if (dice.chance(0.3)) camera.field_of_view = dice.uniform(0.05, 2.5);
  camera.frame = dice.pick(enumerators<scene::Frame>);
  return camera;
}

scene::Overlay random_overlay(SceneDice& dice, const scene::Motion& motion) {
  scene::Overlay overlay;
  if (dice.chance(0.8)) overlay.view = dice.pick(enumerators<scene::View>);
  const double share = dice.pick(std::array{0.0, 0.5, 0.9, 1.0});
  overlay.show.clear();
  for (const scene::Feature feature : enumerators<scene::Feature>) {
    if (dice.chance(share)) overlay.show.insert(feature);
  }
  if (overlay.view == scene::View::wrench && dice.chance(0.3)) {
    const int count = dice.whole(1, 4);
    for (int i = 0; i < count; ++i) overlay.compare.emplace_back(dice.pick(motion::methods()).name);
  }
  if (dice.chance(0.2)) overlay.trail_point = dice.vector(-10, 10);
  if (dice.chance(0.3)) overlay.trail_length = motion.duration * dice.spread(1e-3, 10);
  if (dice.chance(0.3)) overlay.star_trail = dice.spread(1e-3, 10);
  overlay.font = dice.pick(std::array{"sans", "mono"});
  return overlay;
}

std::string random_title(SceneDice& dice) {
  static const std::array<std::string, 16> titles{"",
                                                  "x",
                                                  "The Dzhanibekov effect",
                                                  "Η περιστροφή ενός στερεού",
                                                  "Вращение твёрдого тела",
                                                  "دوران جسم صلب",
                                                  "סיבוב גוף קשיח",
                                                  "刚体的旋转、剛体の回転",
                                                  "강체의 회전",
                                                  "e\u0301\u0302\u0303a\u0308\u0308",
                                                  "\u0301\u0301",
                                                  "🛰️ 🔧",
                                                  "\u200B\u200D",
                                                  "\u2009\u2007\u2009",
                                                  "Ω × (I Ω) = −I Ω̇, ω₁²⁺⁻",
                                                  "T-wrench — “quoted”, 50 %\tof\n<it> & \\more"};
  std::string title = dice.pick(titles);
  if (dice.chance(0.15)) {
    const int times = dice.whole(10, 300);
    const std::string once = title + " ";
    for (int i = 0; i < times; ++i) title += once;
  }
  return title;
}

scene::Scene random_scene(SceneDice& dice) {
  scene::Scene scene;
  scene.name = "torture";
  scene.title = random_title(dice);
  scene.body = random_body(dice);
  scene.motion = random_motion(dice);
  scene.film = random_film(dice, scene.motion);
  scene.look = random_look(dice);
  scene.camera = random_camera(dice);
  scene.overlay = random_overlay(dice, scene.motion);
  return scene;
}

/// One to three, ascending.
std::vector<int> random_frames(SceneDice& dice, int count) {
  std::vector<int> frames;
  const int wanted = dice.whole(1, 3);
  for (int i = 0; i < wanted; ++i) frames.push_back(dice.whole(0, count - 1));
  std::ranges::sort(frames);
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

void check(const image::Frame& frame, const scene::Scene& scene) {
  const image::Image& image = frame.image;
  require(image.width == scene.film.width && image.height == scene.film.height,
          "the picture has another size than its film");
  require(image.channels == (scene.look.transparent ? 4 : 3) &&
              image.pixels.size() == image.row_bytes() * static_cast<std::size_t>(image.height),
          "the picture has other pixels than its size and channels say");
  for (const auto& [x, y, width, height] : frame.damage) {
    require(x >= 0 && y >= 0 && width >= 0 && height >= 0 && x + width <= image.width &&
                y + height <= image.height,
            "the changed rectangle is not within the picture");
  }
}

/// Draws some frames of the scene as the program does, each of them twice.
void draw(const scene::Scene& scene, SceneDice& dice) {
  const auto opened = gl::open_context({});
  const timeline::Timeline timeline(scene, random_frames(dice, scene.frame_count()));
  draw::Renderer renderer(*opened.context, scene, timeline.solutions());
  std::vector<std::vector<std::uint8_t>> drawn;
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    image::Frame frame = renderer.draw(timeline.frame_state(i));
    check(frame, scene);
    drawn.push_back(frame.image.pixels);
  }
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const image::Frame frame = renderer.draw(timeline.frame_state(i));
    require(frame.image.pixels == drawn[i], "a frame is another when it is drawn again");
  }
}

enum class Outcome { drawn, refused, fault };

/// Expected errors are not faults, except errors that report a bug.
Outcome run(std::uint32_t seed, std::uint32_t number, std::map<std::string, int>& refusals) {
  SceneDice dice(seed, number);
  scene::Scene scene;
  std::string what;
  try {
    scene = random_scene(dice);
    draw(scene, dice);
    return Outcome::drawn;
  } catch (const std::exception& error) {
    what = error.what();
    const bool is_refusal = dynamic_cast<const InvalidArgument*>(&error) != nullptr ||
                            dynamic_cast<const motion::MotionError*>(&error) != nullptr;
    if (is_refusal) {
      ++refusals[what.substr(0, what.find(':'))];
      return Outcome::refused;
    }
  }
  fmt::print(
      "\nscenes: fault: seed {} case {}: {}\n{}\n", seed, number, what,
      scene::scene_json(scene).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  return Outcome::fault;
}

/// Whether a process that is forked from this one, which has drawn, refuses to draw.
bool refuses_after_fork() {
  try {
    gl::ChildCall([] { return gl::open_context(gl::BackendChoice{}).context->backend(); }).result();
    return false;
  } catch (const gl::GlError& error) {
    return error.reason() == gl::GlError::Reason::forked;
  }
}

int run(double seconds, std::uint32_t seed, std::optional<std::uint32_t> only) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  std::map<Outcome, int> outcomes;
  std::map<std::string, int> refusals;
  std::uint32_t number = only.value_or(0);
  do {
    fmt::print(stderr, "\rscenes: seed {} case {} ", seed, number);
    ++outcomes[run(seed, number, refusals)];
    ++number;
  } while (!only && Clock::now() < end);
  fmt::print(stderr, "\n");
  if (outcomes[Outcome::drawn] > 0 && !refuses_after_fork()) {
    fmt::print("scenes: fault: a forked process does not refuse to draw\n");
    ++outcomes[Outcome::fault];
  }
  for (const auto& [what, count] : refusals) fmt::print("scenes: {} refused: {}\n", count, what);
  fmt::print("scenes: {} drawn, {} faults\n", outcomes[Outcome::drawn], outcomes[Outcome::fault]);
  return outcomes[Outcome::fault] > 0 ? 1 : 0;
}

}  // namespace
}  // namespace twrench::torture

int main(int count, char** words) {
  if (count != 3 && count != 4) {
    fmt::print(stderr, "usage: torture_scenes SECONDS SEED [CASE]\n");
    return 2;
  }
  const auto number = [&](int i) { return static_cast<std::uint32_t>(std::stoul(words[i])); };
  return twrench::torture::run(std::stod(words[1]), number(2),
                               count == 4 ? std::optional(number(3)) : std::nullopt);
}
