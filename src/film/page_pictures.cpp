#include "film/page_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "draw/film_renderer.h"
#include "image/stb.h"
#include "page/stills.h"
#include "scene/natural_times.h"
#include "system/bytes.h"
#include "timeline/film_timeline.h"

namespace twrench::film {
namespace {

/// The scene as a film of one frame, at t = 0, without text.
scene::Scene first_frame(scene::Scene scene) {
  scene.look.transparent = false;
  scene.look.motion_blur = 1;
  scene.shots.clear();
  scene.title.clear();
  scene.motion.method = scene.motion.is_rigid() ? "exact" : "taylor";
  scene.film.speed = scene.motion.duration;
  scene.film.fps = 1;
  return scene;
}

/// The scene as a film of one frame of that size, whose motion has one step, because only t = 0 is
/// shown.
scene::Scene still_scene(scene::Scene scene, double longest) {
  const double scale = longest / std::max(scene.film.width, scene.film.height);
  const auto scaled = [&](int side) {
    return std::max(16, 2 * static_cast<int>(std::lround(scale * side / 2)));
  };
  scene.film.width = scaled(scene.film.width), scene.film.height = scaled(scene.film.height);
  scene.motion.duration = scene::natural_times(scene).step;
  return first_frame(std::move(scene));
}

/// The scene reduced to its body and arrows, whose picture adds few bytes to the page.
scene::Scene poster_scene(scene::Scene scene) {
  constexpr double longest = 800;
  using enum scene::Feature;
  scene.overlay.view = scene::View::wrench;
  scene.overlay.show = {floor, momentum, omega};
  scene.overlay.stress.clear();
  scene.overlay.compare.clear();
  scene.overlay.compare_omega.clear(), scene.overlay.compare_wheel.clear();
  return still_scene(std::move(scene), longest);
}

image::Image drawn(gl::Context& context, const scene::Scene& scene) {
  const timeline::FilmTimeline timeline(scene, {0});
  draw::FilmRenderer renderer(context, scene);
  return renderer.draw(timeline, timeline.frame(0)).image;
}

std::string jpeg_url(const image::Image& picture, int quality) {
  return "data:image/jpeg;base64," + system::base64(image::stb::jpeg(picture, quality));
}

/// Copies a picture into a larger one.
void copy(const image::Image& from, image::Image& to, int x, int y) {
  const std::size_t left = static_cast<std::size_t>(x) * static_cast<std::size_t>(to.channels);
  for (int row = 0; row < from.height; ++row) {
    const auto begin = static_cast<std::size_t>(row) * from.row_bytes();
    const auto target = static_cast<std::size_t>(y + row) * to.row_bytes() + left;
    std::copy_n(&from.pixels[begin], from.row_bytes(), &to.pixels[target]);
  }
}

std::string picture_html(gl::Context& context, const scene::Scene& scene) {
  constexpr int quality = 55;
  const image::Image picture = drawn(context, scene);
  return fmt::format("<img alt=\"\" width=\"{}\" height=\"{}\" src=\"{}\">", picture.width,
                     picture.height, jpeg_url(picture, quality));
}

/// Draws the stills into one picture, because each JPEG file has tables of 600 bytes.
image::Image sheet_of(gl::Context& context, const std::vector<page::Still>& stills) {
  image::Image sheet;
  for (std::size_t row = 0; row < stills.size(); ++row) {
    const std::vector<scene::Scene>& panes = stills[row].panes;
    for (std::size_t column = 0; column < panes.size(); ++column) {
      const image::Image pane = drawn(context, first_frame(panes[column]));
      if (sheet.pixels.empty()) {
        sheet = {pane.width * static_cast<int>(panes.size()),
                 pane.height * static_cast<int>(stills.size()), pane.channels};
      }
      copy(pane, sheet, static_cast<int>(column) * pane.width, static_cast<int>(row) * pane.height);
    }
  }
  return sheet;
}

/// The names of the stills with the numbers of their panes, which the page needs to cut the sheet.
std::string stills_html(gl::Context& context, const std::vector<page::Still>& stills) {
  constexpr int quality = 40;
  std::string names;
  for (const page::Still& still : stills) {
    names += fmt::format("{}{}:{}", names.empty() ? "" : " ", still.name, still.panes.size());
  }
  return fmt::format("<img id=\"stills\" alt=\"\" hidden data-panes=\"{}\" src=\"{}\">", names,
                     jpeg_url(sheet_of(context, stills), quality));
}

}  // namespace

std::vector<std::string> still_pictures(const std::vector<scene::Scene>& scenes,
                                        const gl::BackendChoice& backend) {
  constexpr double longest = 480;
  const gl::OpenedContext opened = gl::open_context(backend);
  std::vector<std::string> pictures;
  for (const scene::Scene& scene : scenes)
    pictures.push_back(picture_html(*opened.context, still_scene(scene, longest)));
  return pictures;
}

PagePictures page_pictures(const scene::Scene& scene, bool has_article,
                           const gl::BackendChoice& backend) {
  const gl::OpenedContext opened = gl::open_context(backend);
  return {picture_html(*opened.context, poster_scene(scene)),
          stills_html(*opened.context, page::stills_of(scene, has_article))};
}

}  // namespace twrench::film
