#include "render/views/body_view.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "render/body/bounding_radius.h"
#include "render/body/gap_closing.h"
#include "render/compose/camera_path.h"
#include "render/look/theme.h"
#include "render/views/exposure.h"
#include "timeline/reference_frame.h"

namespace twrench::render {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;

/// An exposure of pictures some of which are in transfer.
class PendingExposure {
 public:
  PendingExposure(int width, int height) : exposure_(width, height) {}
  PendingExposure(PendingExposure&&) = default;

  void add(gl::Readback picture) {
    on_their_way_.push_back(std::move(picture));
    while (!is_ready() && (on_their_way_.front().is_ready() || on_their_way_.size() > most)) {
      add_first();
    }
  }

  bool is_ready() const { return on_their_way_.empty(); }

  /// Returns the mean of all.
  image::Image finish() {
    while (!is_ready()) add_first();
    return exposure_.mean();
  }

 private:
  static constexpr std::size_t most = 8;  // enough to keep a card busy while one is waited for

  void add_first() {
    exposure_.add(on_their_way_.front().finish());
    on_their_way_.pop_front();
  }

  Exposure exposure_;
  std::deque<gl::Readback> on_their_way_;
};

std::optional<ForceArrows> forces_of(const scene::Scene& scene, const timeline::Solution& solution,
                                     double radius) {
  if (!scene.overlay.shows(scene::Feature::forces)) return std::nullopt;
  return ForceArrows(scene, solution, radius);
}

/// Tolerance in cm at which facets are indistinguishable from the shape: a seventh of a pixel in
/// the middle of the picture.
double tolerance(const Camera& camera, int height) {
  return 0.15 * 2 * camera.distance / (camera.projection(1, 1) * height);
}

/// Draws the scene's body with facets that deviate from it by at most `tolerance` cm.
BodyPass body_pass(const gl::Functions& gl, const scene::Scene& scene, double tolerance,
                   double radius) {
  const std::vector<body::Part> parts = close_gaps(scene::visible_parts(scene.body));
  std::vector<scene::PartLook> looks;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    looks.push_back(scene::description(scene.body, i).look);
  }
  Mesh mesh = body_mesh(parts, tolerance, looks);
  std::vector<Material> materials;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    materials.push_back(material(scene.look, looks[i], mesh.is_colored[i] != 0));
  }
  return {gl, parts, std::move(mesh), radius, materials, style_of(scene.look.theme).studio};
}

std::vector<gl::Rectangle> rectangles_of(std::span<const image::Area> areas,
                                         const ScreenArea& screen) {
  std::vector<gl::Rectangle> rectangles;
  rectangles.reserve(areas.size());
  for (const image::Area& area : areas) rectangles.push_back(screen.rectangle(area));
  return rectangles;
}

/// A software rasteriser pays for each pixel that is cleared, read back and composited; a card pays
/// for each rectangle.
int band_height(const gl::Framebuffer& framebuffer) {
  return framebuffer.read_mode() == gl::ReadMode::at_once ? 32 : framebuffer.height();
}

// Size in pixels of the areas of a blurred picture, each drawn in as many poses as it needs.
constexpr int tile_width = 160, tile_height = 64;

/// Cuts the areas into ones that are at most so wide.
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

BodyView::BodyView(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
                   const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                   std::size_t solution, const Layout::Pane& pane)
    : framebuffer_(framebuffer),
      band_height_(band_height(framebuffer)),
      solution_(solution),
      motion_(solutions[solution].body),
      frame_(scene.camera.frame),
      pane_(pane),
      radius_(bounding_radius(scene::visible_parts(scene.body))),
      overlay_(scene, solutions[solution].body, radius_),
      forces_(forces_of(scene, solutions[solution], radius_)),
      path_(scene.camera),
      framing_(framing_of(scene, solutions[solution])),
      body_(body_pass(gl, scene, tolerance(camera(0), pane.area.height), radius_)),
      multisampled_(scene.look.samples > 1),
      draw_list_pass_(gl) {
  if (scene.look.motion_blur > 1) {
    sampling_.emplace(scene::visible_parts(scene.body), body_.mesh(), radius_);
  }
  if (scene.overlay.shows(scene::Feature::floor)) add_surroundings(gl, scene);
}

/// Adds the floor or, for a camera that goes along with a turning frame, the stars.
void BodyView::add_surroundings(const gl::Functions& gl, const scene::Scene& scene) {
  std::optional<FloorStyle> floor = style_of(scene.look.theme).floor;
  if (frame_ != scene::Frame::space) {
    if (!scene.look.transparent) stars_.emplace(scene);
  } else if (floor && !scene.look.transparent && scene.camera.elevation >= 0) {
    floor_lit_ = !scene.look.background;
    if (!floor_lit_ || scene.camera.orbit == 0) floor->clouds = 0;
    const image::Area picture{0, 0, framebuffer_.width(), framebuffer_.height()};
    floor_.emplace(gl, framebuffer_.read_mode(), *floor, pane_.area, picture,
                   scene::visible_parts(scene.body), radius_);
  }
}

/// Returns the framing, the same throughout the video, that keeps the overlay in view at all times.
Framing BodyView::framing_of(const scene::Scene& scene, const timeline::Solution& solution) const {
  std::vector<Eigen::Vector3d> points;
  if (forces_) points = forces_->extent();
  constexpr std::size_t stride = 12;  // of the samples, which are finer than needed here
  for (std::size_t i = 0; i < solution.whole.size(); i += stride) {
    const Matrix3d frame_from_space = frame_at(solution.whole[i]).attitude.transpose();
    for (const Eigen::Vector3d& p : overlay_.extent()) points.emplace_back(frame_from_space * p);
    if (frame_ == scene::Frame::space) break;  // there they are at rest
  }
  const double aspect = static_cast<double>(pane_.focus.width) / pane_.focus.height;
  return framing_along(scene, aspect, overlay_.bounding_radius(), points);
}

Camera BodyView::camera(double video_time) const {
  Framing framing = framing_;
  framing.direction = direction_of(path_.azimuth + path_.orbit * video_time, path_.elevation);
  return widened(frame_sphere(framing), pane_.focus, pane_.area);
}

motion::RotatingFrame BodyView::frame_at(const motion::Sample& sample) const {
  return timeline::reference_frame(frame_, motion_, sample);
}

Camera BodyView::own_camera_in_space(const timeline::FrameState& state) const {
  return carried(camera(state.video_time), frame_at(state.solutions[solution_].sample).attitude);
}

/// Returns the state with its earlier and blurred poses as they were in the frame, which has turned
/// on since.
timeline::SolutionState BodyView::relative(timeline::SolutionState instant) const {
  if (frame_ == scene::Frame::space) return instant;
  const Matrix3d now = frame_at(instant.sample).attitude;
  const auto carry = [&](motion::Sample& sample) {
    sample.X = now * frame_at(sample).attitude.transpose() * sample.X;
  };
  std::ranges::for_each(instant.trail, carry);
  std::ranges::for_each(instant.blur, carry);
  return instant;
}

std::vector<Layer> BodyView::static_layers() {
  std::vector<Layer> layers;
  if (floor_ && floor_lit_) layers.push_back(floor_->light(other_camera().value_or(camera(0))));
  return layers;
}

ScreenArea BodyView::covered(const Camera& camera, std::span<const Matrix3d> poses) const {
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
  opaque_.add_to(screen);
  translucent_.add_to(screen);
  return screen;
}

/// Reads the areas, which contain everything that is drawn.
std::vector<gl::Readback> BodyView::picture(const Camera& camera, const Matrix3d& X,
                                            const ScreenArea& screen,
                                            std::span<const image::Area> areas) {
  if (areas.empty()) return {};  // the camera is so near that all parts are beside the picture
  const std::vector<gl::Rectangle> rectangles = rectangles_of(areas, screen);
  framebuffer_.clear(rectangles);
  const image::Area all = std::accumulate(areas.begin(), areas.end(), areas.front(), image::around);
  framebuffer_.draw_within(screen.rectangle(all), screen.viewport());
  if (multisampled_) {
    body_.draw(camera, X);
    draw_list_pass_.draw_ghosts(opaque_);
    draw_list_pass_.draw_opaque(opaque_);
  } else {
    body_.draw_shrunk(camera, X, pane_.area);
    draw_list_pass_.draw_ghosts(opaque_);
    draw_list_pass_.draw_opaque(opaque_);
    body_.draw_edge_quads(camera, X);
  }
  draw_list_pass_.draw_edge_quads(opaque_);
  draw_list_pass_.draw_translucent(translucent_);
  std::vector<gl::Readback> readbacks;
  readbacks.reserve(areas.size());
  for (const auto& rectangle : rectangles) readbacks.push_back(framebuffer_.begin_read(rectangle));
  return readbacks;
}

void BodyView::draw_sharp(const Camera& camera, const Matrix3d& X,
                          std::vector<PendingLayer>& layers) {
  const ScreenArea screen = covered(camera, {&X, 1});
  const std::vector<image::Area> areas = screen.bands(band_height_);
  std::vector<gl::Readback> pixels = picture(camera, X, screen, areas);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    layers.push_back(made_of(std::move(pixels[i]), areas[i].x, areas[i].y));
  }
}

/// Draws each area in as many of the poses as the motion there calls for.
void BodyView::draw_blurred(const Camera& camera, std::span<const Matrix3d> poses,
                            std::vector<PendingLayer>& layers) {
  const ScreenArea screen = covered(camera, poses);
  const std::vector<image::Area> areas = cut_to_width(screen.bands(tile_height), tile_width);
  const std::vector<int> counts = sampling_->counts(areas, camera, pane_.area, poses);
  std::vector<PendingExposure> exposures;
  exposures.reserve(areas.size());
  for (const image::Area& area : areas) exposures.emplace_back(area.width, area.height);
  std::vector<char> is_blocked(areas.size());
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    std::vector<std::size_t> drawn;
    std::vector<image::Area> drawn_areas, left_out;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      if (is_in_exposure(static_cast<int>(pose), counts[i], static_cast<int>(poses.size()))) {
        drawn.push_back(i);
        drawn_areas.push_back(areas[i]);
      } else if (is_blocked[i] == 0) {
        left_out.push_back(areas[i]);
      }
      is_blocked[i] = drawn.empty() || drawn.back() != i;
    }
    framebuffer_.block(rectangles_of(left_out, screen));
    if (drawn.empty()) continue;
    std::vector<gl::Readback> pixels = picture(camera, poses[pose], screen, drawn_areas);
    for (std::size_t i = 0; i < drawn.size(); ++i) exposures[drawn[i]].add(std::move(pixels[i]));
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    layers.push_back(made_of(std::move(exposures[i]), areas[i].x, areas[i].y));
  }
}

std::vector<PendingLayer> BodyView::draw(const timeline::FrameState& state) {
  const timeline::SolutionState instant = relative(state.solutions[solution_]);
  const Matrix3d& X = instant.sample.X;
  const Camera now = camera_in_space(state);
  opaque_.begin(now, pane_.area);
  translucent_.begin(now, pane_.area);
  if (stars_) stars_->draw(frame_at(instant.sample), now, pane_.area.height, translucent_);
  overlay_.draw(instant, opaque_, translucent_);
  if (forces_) forces_->draw(instant, opaque_);
  std::vector<PendingLayer> layers;
  if (floor_) layers.push_back(floor_->draw(now, X, body_));
  if (instant.blur.empty()) {
    draw_sharp(now, X, layers);
  } else {
    std::vector<Matrix3d> poses;
    for (const motion::Sample& sample : instant.blur) poses.push_back(sample.X);
    draw_blurred(now, poses, layers);
  }
  return layers;
}

std::vector<Label> BodyView::labels(const timeline::FrameState& state) const {
  if (!pane_.named) return {};
  return overlay_.labels(state.solutions[solution_], camera_in_space(state), pane_.area);
}

}  // namespace twrench::render
