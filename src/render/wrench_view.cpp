#include "render/wrench_view.h"

#include "render/exposure.h"
#include "render/joined_parts.h"
#include "render/reach.h"
#include "render/theme.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;

Camera camera_at(const CameraPath& path, const Layout::Pane& pane, double radius,
                 double film_time) {
  const Camera camera = frame_sphere(
      {direction_of(path.azimuth + path.orbit * film_time, path.elevation), path.field_of_view,
       static_cast<double>(pane.focus.width) / pane.focus.height, radius, path.distance});
  return widened(camera, pane.focus, pane.area);
}

/// cm: facets that cannot be told from the shape, a seventh of a pixel in the picture's middle.
double tolerance(const Camera& camera, int height) {
  return 0.15 * 2 * camera.distance / (camera.projection(1, 1) * height);
}

}  // namespace

WrenchView::WrenchView(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
                       const Scene& scene, std::size_t take, const Layout::Pane& pane)
    : gl_(gl),
      framebuffer_(framebuffer),
      path_(scene.camera),
      take_(take),
      pane_(pane),
      radius_(reach(visible_parts(scene.body))),
      body_(gl, joined_parts(visible_parts(scene.body)), tolerance(camera(0), pane.area.height),
            radius_, material(scene.look), style_of(scene.look.theme).studio) {
  const auto& floor = style_of(scene.look.theme).floor;
  if (floor && scene.overlay.shows(Feature::floor) && !scene.look.transparent &&
      scene.camera.elevation >= 0) {
    floor_.emplace(gl, *floor, pane.area, visible_parts(scene.body), radius_);
    floor_lit_ = !scene.look.background;
  }
}

Camera WrenchView::camera(double film_time) const {
  return camera_at(path_, pane_, radius_, film_time);
}

std::vector<Layer> WrenchView::still() {
  std::vector<Layer> layers;
  if (floor_ && floor_lit_) layers.push_back(floor_->light(camera(0)));
  return layers;
}

ScreenArea WrenchView::covered(const Camera& camera, std::span<const Matrix3d> poses) const {
  ScreenArea screen(pane_.area, framebuffer_.height());
  for (const Matrix3d& X : poses) {
    Matrix4d space_from_body = Matrix4d::Identity();
    space_from_body.topLeftCorner<3, 3>() = X;
    const Eigen::Matrix4f clip_from_body =
        (camera.projection * camera.view * space_from_body).cast<float>();
    for (const Vertex& vertex : body_.mesh().vertices) {
      const auto& [x, y, z] = std::tie(vertex.position.x, vertex.position.y, vertex.position.z);
      screen.add(clip_from_body * Eigen::Vector4f(x, y, z, 1));
    }
  }
  return screen;
}

Image WrenchView::picture(const Camera& camera, const Matrix3d& X, const ScreenArea& screen) const {
  framebuffer_.draw_within(screen.rectangle(), screen.viewport());
  gl_.ClearColor(0, 0, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  body_.draw(camera, X);
  return framebuffer_.read(screen.rectangle());
}

Layer WrenchView::blurred(const Camera& camera, std::span<const Matrix3d> poses) const {
  const ScreenArea screen = covered(camera, poses);
  const Area area = screen.area();
  Exposure exposure(area.width, area.height);
  for (const Matrix3d& X : poses) exposure.add(picture(camera, X, screen));
  return {exposure.mean(), area.x, area.y};
}

std::vector<Layer> WrenchView::draw(const Moment& moment) {
  const Instant& instant = moment.instants[take_];
  const Matrix3d& X = instant.sample.X;
  const Camera now = camera(moment.film_time);
  std::vector<Layer> layers;
  if (floor_) layers.push_back(floor_->draw(now, X, body_));
  if (instant.blur.empty()) {
    const ScreenArea screen = covered(now, {&X, 1});
    layers.push_back({picture(now, X, screen), screen.area().x, screen.area().y});
  } else {
    layers.push_back(blurred(now, instant.blur));
  }
  return layers;
}

}  // namespace twrench
