#include "render/wrench_view.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "render/exposure.h"
#include "render/joined_parts.h"
#include "render/reach.h"
#include "render/theme.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;

Framing framing_at(const CameraPath& path, const Layout::Pane& pane, double radius,
                   double film_time) {
  return {direction_of(path.azimuth + path.orbit * film_time, path.elevation), path.field_of_view,
          static_cast<double>(pane.focus.width) / pane.focus.height, radius, path.distance};
}

/// Returns the path, moved away as far as needed to keep the overlay in view at all times.
CameraPath path_of(const Scene& scene, const Layout::Pane& pane, const BodyOverlay& overlay) {
  CameraPath path = scene.camera;
  constexpr int places = 32;  // along the path of a moving camera
  const double film = scene.motion.duration / scene.film.speed;
  double distance = 1;
  for (int i = 0; i < (path.orbit == 0 ? 1 : places); ++i) {
    const double time = std::min(film, 2 * std::numbers::pi / std::abs(path.orbit)) * i / places;
    const Framing framing = framing_at(path, pane, overlay.reach(), path.orbit == 0 ? 0 : time);
    distance = std::max(distance, distance_to_see(framing, overlay.extent()));
  }
  path.distance *= distance;
  return path;
}

/// An exposure of pictures some of which are in transfer.
class PendingExposure {
 public:
  PendingExposure(int width, int height) : exposure_(width, height) {}
  PendingExposure(PendingExposure&&) = default;

  void add(gl::Readback picture) {
    on_their_way_.push_back(std::move(picture));
    while (!is_there() && (on_their_way_.front().is_there() || on_their_way_.size() > most)) {
      add_first();
    }
  }

  bool is_there() const { return on_their_way_.empty(); }

  /// Returns the mean of all.
  Image take() {
    while (!is_there()) add_first();
    return exposure_.mean();
  }

 private:
  static constexpr std::size_t most = 8;  // enough to keep a card busy while one is waited for

  void add_first() {
    exposure_.add(on_their_way_.front().take());
    on_their_way_.pop_front();
  }

  Exposure exposure_;
  std::deque<gl::Readback> on_their_way_;
};

/// Tolerance in cm at which facets are indistinguishable from the shape: a seventh of a pixel in
/// the middle of the picture.
double tolerance(const Camera& camera, int height) {
  return 0.15 * 2 * camera.distance / (camera.projection(1, 1) * height);
}

/// A software rasteriser pays for each pixel that is cleared, read back and composited; a card pays
/// for each rectangle.
int band_height(const gl::Framebuffer& framebuffer) {
  return framebuffer.read_mode() == gl::ReadMode::at_once ? 32 : framebuffer.height();
}

}  // namespace

WrenchView::WrenchView(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
                       const Scene& scene, const std::vector<Take>& takes, std::size_t take,
                       const Layout::Pane& pane)
    : framebuffer_(framebuffer),
      band_height_(band_height(framebuffer)),
      take_(take),
      pane_(pane),
      radius_(reach(visible_parts(scene.body))),
      overlay_(scene, takes[take], radius_),
      path_(path_of(scene, pane, overlay_)),
      body_(gl, joined_parts(visible_parts(scene.body)), tolerance(camera(0), pane.area.height),
            radius_, material(scene.look), style_of(scene.look.theme).studio),
      multisampled_(scene.look.samples > 1),
      sketch_pass_(gl) {
  const auto& floor = style_of(scene.look.theme).floor;
  if (floor && scene.overlay.shows(Feature::floor) && !scene.look.transparent &&
      scene.camera.elevation >= 0) {
    const Area picture{0, 0, framebuffer.width(), framebuffer.height()};
    floor_.emplace(gl, framebuffer.read_mode(), *floor, pane.area, picture,
                   visible_parts(scene.body), radius_);
    floor_lit_ = !scene.look.background;
  }
}

Camera WrenchView::camera(double film_time) const {
  return widened(frame_sphere(framing_at(path_, pane_, overlay_.reach(), film_time)), pane_.focus,
                 pane_.area);
}

std::vector<Layer> WrenchView::still() {
  std::vector<Layer> layers;
  if (floor_ && floor_lit_) layers.push_back(floor_->light(camera(0)));
  return layers;
}

ScreenArea WrenchView::covered(const Camera& camera, std::span<const Matrix3d> poses) const {
  ScreenArea screen(pane_.area, framebuffer_.height());
  const Mesh& mesh = body_.mesh();
  for (const Matrix3d& X : poses) {
    Matrix4d space_from_body = Matrix4d::Identity();
    space_from_body.topLeftCorner<3, 3>() = X;
    const Eigen::Matrix4f clip_from_body =
        (camera.projection * camera.view * space_from_body).cast<float>();
    std::size_t i = 0;
    for (const std::size_t end : mesh.vertex_ends) {
      screen.begin_shape(1);  // half a pixel of the edge quads
      for (; i < end; ++i) {
        const glm::vec3& place = mesh.vertices[i].position;
        screen.add(clip_from_body * Eigen::Vector4f(place.x, place.y, place.z, 1));
      }
    }
  }
  solid_.add_to(screen);
  sheer_.add_to(screen);
  return screen;
}

/// Reads the areas, which contain everything that is drawn.
std::vector<gl::Readback> WrenchView::picture(const Camera& camera, const Matrix3d& X,
                                              const ScreenArea& screen,
                                              std::span<const Area> areas) {
  std::vector<gl::Rectangle> rectangles;
  rectangles.reserve(areas.size());
  for (const Area& area : areas) rectangles.push_back(screen.rectangle(area));
  framebuffer_.clear(rectangles);
  framebuffer_.draw_within(screen.rectangle(screen.bounds()), screen.viewport());
  if (multisampled_) {
    body_.draw(camera, X);
    sketch_pass_.draw_solid(solid_);
  } else {
    body_.draw_inset(camera, X, pane_.area);
    sketch_pass_.draw_solid(solid_);
    body_.draw_fins(camera, X);
  }
  sketch_pass_.draw_fins(solid_);
  sketch_pass_.draw_sheer(sheer_);
  std::vector<gl::Readback> readbacks;
  readbacks.reserve(areas.size());
  for (const auto& rectangle : rectangles) readbacks.push_back(framebuffer_.begin_read(rectangle));
  return readbacks;
}

void WrenchView::draw_sharp(const Camera& camera, const Matrix3d& X,
                            std::vector<PendingLayer>& layers) {
  const ScreenArea screen = covered(camera, {&X, 1});
  const std::vector<Area> areas = screen.bands(band_height_);
  std::vector<gl::Readback> pixels = picture(camera, X, screen, areas);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    layers.push_back(made_of(std::move(pixels[i]), areas[i].x, areas[i].y));
  }
}

void WrenchView::draw_blurred(const Camera& camera, std::span<const Matrix3d> poses,
                              std::vector<PendingLayer>& layers) {
  const ScreenArea screen = covered(camera, poses);
  const std::vector<Area> areas = screen.bands(band_height_);
  std::vector<PendingExposure> exposures;
  exposures.reserve(areas.size());
  for (const Area& area : areas) exposures.emplace_back(area.width, area.height);
  for (const Matrix3d& X : poses) {
    std::vector<gl::Readback> pixels = picture(camera, X, screen, areas);
    for (std::size_t i = 0; i < areas.size(); ++i) exposures[i].add(std::move(pixels[i]));
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    layers.push_back(made_of(std::move(exposures[i]), areas[i].x, areas[i].y));
  }
}

std::vector<PendingLayer> WrenchView::draw(const Moment& moment) {
  const Instant& instant = moment.instants[take_];
  const Matrix3d& X = instant.sample.X;
  const Camera now = camera(moment.film_time);
  solid_.begin(now, pane_.area);
  sheer_.begin(now, pane_.area);
  overlay_.draw(instant, solid_, sheer_);
  std::vector<PendingLayer> layers;
  if (floor_) layers.push_back(floor_->draw(now, X, body_));
  if (instant.blur.empty()) {
    draw_sharp(now, X, layers);
  } else {
    draw_blurred(now, instant.blur, layers);
  }
  return layers;
}

std::vector<Label> WrenchView::labels(const Moment& moment) const {
  if (!pane_.named) return {};
  return overlay_.labels(moment.instants[take_], camera(moment.film_time), pane_.area);
}

}  // namespace twrench
