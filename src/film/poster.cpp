#include "film/poster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/film_renderer.h"
#include "image/stb.h"
#include "scene/natural_times.h"
#include "system/base64.h"
#include "timeline/film_timeline.h"

namespace twrench::film {
namespace {

/// The scene reduced to one frame, whose picture adds few bytes to the page.
scene::Scene still(scene::Scene scene) {
  constexpr double longest = 960;
  const double scale = longest / std::max(scene.film.width, scene.film.height);
  const auto scaled = [&](int side) {
    return std::max(16, 2 * static_cast<int>(std::lround(scale * side / 2)));
  };
  scene.film.width = scaled(scene.film.width), scene.film.height = scaled(scene.film.height);
  using enum scene::Feature;
  scene.overlay.view = scene::View::wrench;
  scene.overlay.show = {floor, momentum, omega};
  scene.overlay.stress.clear();
  scene.overlay.compare.clear();
  scene.overlay.compare_omega.clear(), scene.overlay.compare_wheel.clear();
  scene.look.transparent = false;
  scene.shots.clear();
  scene.title.clear();
  // Only t = 0 is shown, so the film has one frame and the motion one step.
  scene.motion.method = scene.motion.is_rigid() ? "exact" : "taylor";
  scene.motion.duration = scene.film.speed = scene::natural_times(scene).step;
  scene.film.fps = 1;
  return scene;
}

}  // namespace

image::Image poster(const scene::Scene& scene, const gl::BackendChoice& backend) {
  const scene::Scene drawn = still(scene);
  const timeline::FilmTimeline timeline(drawn, {0});
  const gl::OpenedContext opened = gl::open_context(backend);
  draw::FilmRenderer renderer(*opened.context, drawn);
  return renderer.draw(timeline, timeline.frame(0)).image;
}

std::string poster_html(const scene::Scene& scene, const gl::BackendChoice& backend) {
  constexpr int quality = 80;
  const image::Image picture = poster(scene, backend);
  return fmt::format("<img alt=\"\" width=\"{}\" height=\"{}\" src=\"data:image/jpeg;base64,{}\">",
                     picture.width, picture.height,
                     system::base64(image::stb::jpeg(picture, quality)));
}

}  // namespace twrench::film
