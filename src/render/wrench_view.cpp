#include "render/wrench_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/joined_parts.h"
#include "render/reach.h"
#include "render/screen_area.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;

Framing framing_at(const CameraPath& path, const Layout::Pane& pane, double radius,
                   double film_time) {
  return {direction_of(path.azimuth + path.orbit * film_time, path.elevation), path.field_of_view,
          static_cast<double>(pane.focus.width) / pane.focus.height, radius, path.distance};
}

/// The path, as much farther off as the overlay needs to be in view all the time.
CameraPath path_of(const Scene& scene, const Layout::Pane& pane, const BodyOverlay& overlay) {
  CameraPath path = scene.camera;
  constexpr int places = 32;  // on the way of a camera that moves
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

/// A mesh whose facets cannot be told from the shape's: a fifth of a pixel in the picture's middle.
Mesh mesh_of(const Scene& scene, const Camera& camera, int height) {
  const double pixel = 2 * camera.distance / (camera.projection(1, 1) * height);  // cm
  return body_mesh(joined_parts(visible_parts(scene.body)), 0.2 * pixel);
}

}  // namespace

WrenchView::WrenchView(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
                       const Scene& scene, const std::vector<Take>& takes, std::size_t take,
                       const Layout::Pane& pane)
    : gl_(gl),
      framebuffer_(framebuffer),
      take_(take),
      pane_(pane),
      radius_(reach(visible_parts(scene.body))),
      overlay_(scene, takes[take], radius_),
      path_(path_of(scene, pane, overlay_)),
      mesh_(mesh_of(scene, camera(0), pane.area.height)),
      body_(gl, mesh_, radius_, material(scene.look), dark_studio()),
      sketch_pass_(gl) {}

Camera WrenchView::camera(double film_time) const {
  return widened(frame_sphere(framing_at(path_, pane_, overlay_.reach(), film_time)), pane_.focus,
                 pane_.area);
}

std::vector<Layer> WrenchView::draw(const Moment& moment) {
  const Matrix3d& X = moment.instants[take_].sample.X;
  const Camera now = camera(moment.film_time);
  Matrix4d space_from_body = Matrix4d::Identity();
  space_from_body.topLeftCorner<3, 3>() = X;
  const Eigen::Matrix4f clip_from_body =
      (now.projection * now.view * space_from_body).cast<float>();
  ScreenArea screen(pane_.area, framebuffer_.height());
  for (const Vertex& vertex : mesh_.vertices) {
    const auto& [x, y, z] = std::tie(vertex.position.x, vertex.position.y, vertex.position.z);
    screen.add(clip_from_body * Eigen::Vector4f(x, y, z, 1));
  }
  solid_.begin(now, pane_.area);
  sheer_.begin(now, pane_.area);
  overlay_.draw(moment.instants[take_], solid_, sheer_);
  solid_.add_to(screen);
  sheer_.add_to(screen);
  framebuffer_.draw_within(screen.rectangle(), screen.viewport());
  gl_.ClearColor(0, 0, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  body_.draw(now, X);
  sketch_pass_.draw_solid(solid_);
  sketch_pass_.draw_sheer(sheer_);
  std::vector<Layer> layers;
  layers.push_back({framebuffer_.read(screen.rectangle()), screen.area().x, screen.area().y});
  return layers;
}

std::vector<Label> WrenchView::labels(const Moment& moment) const {
  return overlay_.labels(moment.instants[take_], camera(moment.film_time), pane_.area);
}

}  // namespace twrench
