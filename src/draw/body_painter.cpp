#include "draw/body_painter.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "draw/view_painter.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using picture::ScreenArea;
using picture::ViewContents;

/// Returns the number of rows to clear and read back together. A software rasteriser pays for each
/// pixel that is cleared, read back and composited; a card pays for each rectangle.
int rows_at_once(const gl::Framebuffer& framebuffer) {
  return framebuffer.read_mode() == gl::ReadMode::at_once ? 32 : framebuffer.height();
}

// Size in pixels of the areas of a blurred picture. Each is drawn in as many poses as it needs.
constexpr int tile_width = 160, tile_height = 64;

/// Cuts the areas into ones that are at most `width` pixels wide.
std::vector<image::Area> cut_to_width(const std::vector<image::Area>& areas, int width) {
  std::vector<image::Area> result;
  for (const image::Area& area : areas) {
    const int count = (area.width + width - 1) / width;
    for (int i = 0; i < count; ++i) {
      const int left = area.width * i / count, right = area.width * (i + 1) / count;
      result.push_back({area.x + left, area.y, right - left, area.height});
    }
  }
  return result;
}

}  // namespace

BodyPainter::BodyPainter(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
                         const picture::BodyView& view, std::span<const body::Part> parts,
                         bool is_multisampled)
    : framebuffer_(framebuffer),
      view_(view),
      band_height_(rows_at_once(framebuffer)),
      body_(gl, view.body()),
      draw_list_pass_(gl),
      still_painter_(gl, framebuffer, view.pane().area),
      is_multisampled_(is_multisampled) {
  if (!view.floor()) return;
  const image::Area picture{0, 0, framebuffer.width(), framebuffer.height()};
  floor_.emplace(gl, framebuffer.read_mode(), view.floor()->style, view.pane().area, picture, parts,
                 view.body().radius);
}

std::vector<picture::Layer> BodyPainter::draw_still(const ViewContents& contents) {
  std::vector<picture::Layer> layers;
  if (floor_ && view_.floor()->is_lit) layers.push_back(floor_->light(contents.camera));
  std::ranges::move(still_painter_.draw_still(contents), std::back_inserter(layers));
  return layers;
}

ScreenArea BodyPainter::covered(const ViewContents& contents,
                                std::span<const Matrix3d> poses) const {
  ScreenArea screen(view_.pane().area);
  const picture::Mesh& mesh = view_.body().mesh;
  for (const Matrix3d& X : poses) {
    Matrix4d space_from_body = Matrix4d::Identity();
    space_from_body.topLeftCorner<3, 3>() = X;
    const Eigen::Matrix4f clip_from_body =
        (contents.camera.projection * contents.camera.view * space_from_body).cast<float>();
    std::size_t i = 0;
    for (const std::size_t end : mesh.vertex_ends) {
      screen.begin_shape(1);  // half a pixel of the edge quads
      for (; i < end; ++i) {
        const glm::vec3& place = mesh.vertices[i].position;
        screen.add(clip_from_body * Eigen::Vector4f(place.x, place.y, place.z, 1));
      }
    }
  }
  contents.opaque.add_to(screen);
  contents.translucent.add_to(screen);
  return screen;
}

std::vector<gl::Rectangle> BodyPainter::rectangles_of(std::span<const image::Area> areas) const {
  std::vector<gl::Rectangle> rectangles;
  rectangles.reserve(areas.size());
  for (const image::Area& area : areas) {
    rectangles.push_back(gl_rectangle(area, framebuffer_.height()));
  }
  return rectangles;
}

/// Draws the contents in the pose X and begins to read the areas, which contain everything that is
/// drawn.
std::vector<gl::Readback> BodyPainter::draw_areas(const ViewContents& contents, const Matrix3d& X,
                                                  std::span<const image::Area> areas) {
  if (areas.empty()) return {};  // the camera is so near that all parts are beside the picture
  const std::vector<gl::Rectangle> rectangles = rectangles_of(areas);
  framebuffer_.clear(rectangles);
  const image::Area all = std::accumulate(areas.begin(), areas.end(), areas.front(), image::around);
  const image::Area& pane = view_.pane().area;
  framebuffer_.draw_within(gl_rectangle(all, framebuffer_.height()),
                           gl_rectangle(pane, framebuffer_.height()));
  if (is_multisampled_) {
    body_.draw(contents.camera, X);
    draw_list_pass_.draw_ghosts(contents.opaque);
    draw_list_pass_.draw_opaque(contents.opaque);
  } else {
    body_.draw_shrunk(contents.camera, X, pane);
    draw_list_pass_.draw_ghosts(contents.opaque);
    draw_list_pass_.draw_opaque(contents.opaque);
    body_.draw_edge_quads(contents.camera, X);
  }
  draw_list_pass_.draw_edge_quads(contents.opaque);
  draw_list_pass_.draw_translucent(contents.translucent);
  std::vector<gl::Readback> readbacks;
  readbacks.reserve(areas.size());
  for (const auto& rectangle : rectangles) readbacks.push_back(framebuffer_.begin_read(rectangle));
  return readbacks;
}

void BodyPainter::draw_sharp(const ViewContents& contents, std::vector<PendingLayer>& layers) {
  const Matrix3d& X = *contents.X;
  const std::vector<image::Area> areas = covered(contents, {&X, 1}).bands(band_height_);
  std::vector<gl::Readback> pixels = draw_areas(contents, X, areas);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    layers.push_back(layer_at(areas[i], std::move(pixels[i])));
  }
}

/// Draws each area in as many of the poses as the motion there requires.
void BodyPainter::draw_blurred(const ViewContents& contents, std::vector<PendingLayer>& layers) {
  const std::vector<Matrix3d>& poses = contents.blur;
  const std::vector<image::Area> areas =
      cut_to_width(covered(contents, poses).bands(tile_height), tile_width);
  const std::vector<int> counts =
      view_.sampling()->counts(areas, contents.camera, view_.pane().area, poses);
  std::vector<PendingExposure> exposures;
  exposures.reserve(areas.size());
  for (const image::Area& area : areas) exposures.emplace_back(area.width, area.height);
  std::vector<char> is_blocked(areas.size());
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    std::vector<std::size_t> drawn;
    std::vector<image::Area> drawn_areas, left_out;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      if (picture::is_in_exposure(static_cast<int>(pose), counts[i],
                                  static_cast<int>(poses.size()))) {
        drawn.push_back(i);
        drawn_areas.push_back(areas[i]);
      } else if (is_blocked[i] == 0) {
        left_out.push_back(areas[i]);
      }
      is_blocked[i] = drawn.empty() || drawn.back() != i;
    }
    framebuffer_.block(rectangles_of(left_out));
    if (drawn.empty()) continue;
    std::vector<gl::Readback> pixels = draw_areas(contents, poses[pose], drawn_areas);
    for (std::size_t i = 0; i < drawn.size(); ++i) exposures[drawn[i]].add(std::move(pixels[i]));
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    layers.push_back(layer_at(areas[i], std::move(exposures[i])));
  }
}

std::vector<PendingLayer> BodyPainter::draw(const ViewContents& contents) {
  std::vector<PendingLayer> layers;
  if (floor_) layers.push_back(floor_->draw(contents.camera, *contents.X, body_));
  if (contents.blur.empty()) {
    draw_sharp(contents, layers);
  } else {
    draw_blurred(contents, layers);
  }
  return layers;
}

}  // namespace twrench::draw
