#include "render/wrench_view.h"

#include "render/joined_parts.h"
#include "render/reach.h"
#include "render/screen_area.h"

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

/// A mesh whose facets cannot be told from the shape's: a fifth of a pixel in the picture's middle.
Mesh mesh_of(const Scene& scene, const Camera& camera, int height) {
  const double pixel = 2 * camera.distance / (camera.projection(1, 1) * height);  // cm
  return body_mesh(joined_parts(visible_parts(scene.body)), 0.2 * pixel);
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
      mesh_(mesh_of(scene, camera(0), pane.area.height)),
      body_(gl, mesh_, radius_, material(scene.look), dark_studio()) {}

Camera WrenchView::camera(double film_time) const {
  return camera_at(path_, pane_, radius_, film_time);
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
  framebuffer_.draw_within(screen.rectangle(), screen.viewport());
  gl_.ClearColor(0, 0, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  body_.draw(now, X);
  std::vector<Layer> layers;
  layers.push_back({framebuffer_.read(screen.rectangle()), screen.area().x, screen.area().y});
  return layers;
}

}  // namespace twrench
