#include "draw/floor.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "image/image.h"
#include "picture/body/floor_plane.h"
#include "picture/space/screen_area.h"

namespace twrench::draw {
namespace {

using Eigen::ArrayXf;
using Eigen::Matrix3d;
using Eigen::Matrix3f;
using Eigen::Vector3d;
using Eigen::Vector3f;
using picture::Camera;

constexpr int rows_of_grid = 120;
constexpr int most_columns = 4096;  // every OpenGL supports the framebuffer's twice as many
// Subtracted from the shadow, out of 255. This is too little to be seen, but it bounds the shadow,
// and pixels outside it need not be composited.
constexpr float least_shadow = 2;
constexpr double pool = 0.7;  // half its width in radii; the light has fallen to a quarter there
constexpr double pool_depth = 2;  // in widths, away from the eye: a gleam is elongated
constexpr double far_away = 3.0;  // in radii from the pool's middle, where the floor ends

/// The pool's light at the given squared distance from its middle, in units of half its width: the
/// falloff of a lamp.
double falloff(double squared_distance) {
  const double share = 1 / (1 + squared_distance);
  return share * share;
}

/// Clouds in the polish of the floor, 0 to 1, at places given in radii from the pool's middle:
/// waves of several lengths in all directions.
ArrayXf clouds(const ArrayXf& x, const ArrayXf& z) {
  constexpr int waves = 8;
  ArrayXf sum = ArrayXf::Zero(x.size());
  for (int i = 0; i < waves; ++i) {
    const float frequency = 7.0F + 2.5F * static_cast<float>(i);  // rad per radius
    const float angle = 2.4F * static_cast<float>(i);             // the golden angle
    sum += (frequency * (std::cos(angle) * x + std::sin(angle) * z) + angle).sin();
  }
  return (0.5F + sum / waves).max(0).min(1);
}

/// Filters with (1 2 1) / 4 along `count` cells that are `stride` apart.
template <typename Cell>
void blur_line(Cell* line, int count, std::ptrdiff_t stride) {
  Cell before = line[0];
  for (int i = 0; i < count; ++i) {
    const Cell here = line[i * stride];
    const Cell& after = line[std::min(i + 1, count - 1) * stride];
    line[i * stride] = 0.25F * (before + after) + 0.5F * here;
    before = here;
  }
}

/// Rises from 0 at a side to 1 at some distance from it, both as fractions of the pane.
double ramp(double distance) {
  constexpr double way = 0.15;
  const double share = std::clamp(distance / way, 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

/// Averages each two by two pixels of a picture to a cell, and blurs the cells.
std::vector<SoftLayer::Cell> blurred(const image::Image& image) {
  const int columns = image.width / 2, rows = image.height / 2;
  std::vector<SoftLayer::Cell> cells;
  cells.reserve(image.pixels.size() / 16);
  for (int row = 0; row < rows; ++row) {
    const std::uint8_t* upper =
        &image.pixels[2 * static_cast<std::size_t>(row) * image.row_bytes()];
    const std::uint8_t* lower = upper + image.row_bytes();
    for (int column = 0; column < columns; ++column, upper += 8, lower += 8) {
      SoftLayer::Cell& cell = cells.emplace_back();
      for (int c = 0; c < 4; ++c) {
        cell[c] = 0.25F * static_cast<float>(upper[c] + upper[c + 4] + lower[c] + lower[c + 4]);
      }
    }
  }
  for (int y = 0; y < rows; ++y) blur_line(cells.data() + std::ptrdiff_t{y} * columns, columns, 1);
  for (int x = 0; x < columns; ++x) blur_line(cells.data() + x, rows, columns);
  return cells;
}

}  // namespace

Floor::Floor(const gl::Functions& gl, gl::ReadMode mode, const picture::FloorStyle& style,
             const image::Area& pane, const image::Area& picture, std::span<const body::Part> parts,
             double radius)
    : style_(style),
      pane_(pane),
      inner_{pane.x > picture.x, pane.x + pane.width<picture.x + picture.width, pane.y> picture.y,
             pane.y + pane.height < picture.y + picture.height},
      radius_(radius),
      height_(picture::floor_height(radius)),
      columns_(std::clamp(rows_of_grid * pane.width / pane.height, 1,
                          std::min(pane.width, most_columns))),
      rows_(std::min(rows_of_grid, pane.height)),
      framebuffer_(gl, 2 * columns_, 2 * rows_, 1, mode),
      balls_(picture::shadow_balls(parts)) {}

/// Returns the matrix that maps (column, row, 1) on a grid over the pane to (x, z, 1) / w: the
/// visible point of the floor in radii, with w > 0 in front of the eye.
Matrix3d Floor::floor_from_grid(const Camera& camera, int width, int height) const {
  Matrix3d device_from_grid;
  device_from_grid << 2.0 / width, 0, -1, 0, -2.0 / height, 1, 0, 0, 1;
  return picture::floor_from_device(camera, radius_) * device_from_grid;
}

/// The opacity of the floor at a position in the pane, given as fractions of its width and height.
float Floor::fade(double x, double y) const {
  const double across = (inner_.left ? ramp(x) : 1) * (inner_.right ? ramp(1 - x) : 1);
  const double down = (inner_.top ? ramp(y) : 1) * (inner_.bottom ? ramp(1 - y) : 1);
  return static_cast<float>(across * down);
}

picture::Layer Floor::light(const Camera& camera) const {
  picture::Layer layer{{pane_.width, pane_.height, 4}, pane_.x, pane_.y};
  const Eigen::Vector2d right(camera.view(0, 0), camera.view(0, 2));
  Matrix3d pool_from_floor = Matrix3d::Identity();
  pool_from_floor.topLeftCorner<2, 2>() << right.transpose() / pool,
      Eigen::RowVector2d(right.y(), -right.x()) / (pool * pool_depth);
  const Matrix3d pool_from_pane =
      pool_from_floor * floor_from_grid(camera, pane_.width, pane_.height);
  const Eigen::Array3d color(style_.light.red, style_.light.green, style_.light.blue);
  const auto draw_row = [&](int y) {
    std::uint8_t* out = &layer.image.pixels[static_cast<std::size_t>(y) * layer.image.row_bytes()];
    for (int x = 0; x < pane_.width; ++x, out += 4) {
      const Vector3d place = pool_from_pane * Vector3d(x + 0.5, y + 0.5, 1);
      if (place.z() <= 0) continue;
      const double share = falloff(place.head<2>().squaredNorm() / (place.z() * place.z())) *
                           fade((x + 0.5) / pane_.width, (y + 0.5) / pane_.height);
      for (int c = 0; c < 3; ++c) {
        out[c] = static_cast<std::uint8_t>(share * color[c] + 0.5 + image::dither(x, y));
      }
    }
  };
  constexpr std::size_t rows_at_once = 32;
  for_each_part(static_cast<std::size_t>(pane_.height), rows_at_once, 0,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t y = begin; y < end; ++y) draw_row(static_cast<int>(y));
                });
  return layer;
}

/// The cells of the grid in which the body's shadow may be visible.
image::Area Floor::seen(const Camera& camera) const {
  picture::ScreenArea screen({0, 0, columns_, rows_});
  screen.begin_shape();
  constexpr int points = 32;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    const double r = far_away * radius_;
    const Eigen::Vector4d place(r * std::cos(angle), height_, r * std::sin(angle), 1);
    screen.add((camera.projection * (camera.view * place)).cast<float>());
  }
  return screen.bounds();
}

gl::Readback Floor::begin_reflection(const Camera& camera, const Matrix3d& X, const BodyPass& body,
                                     const image::Area& area) {
  const gl::Rectangle rectangle{2 * area.x, 2 * (rows_ - area.y - area.height), 2 * area.width,
                                2 * area.height};
  framebuffer_.clear({&rectangle, 1});
  framebuffer_.draw_within(rectangle, {0, 0, 2 * columns_, 2 * rows_});
  body.draw_mirrored(camera, X, height_);
  return framebuffer_.begin_read(rectangle);
}

/// Adds the fraction of the light from above, a cos^4 lobe about the vertical, that the spheres
/// block at each point. For a sphere seen under the half angle a at theta from the vertical, it is
/// approximately 5 cos^4(theta) (1 - cos a).
void Floor::add_shadow(const Camera& camera, const Matrix3d& X, const image::Area& area,
                       std::vector<Cell>& cells) const {
  const Matrix3f floor_from_cell = floor_from_grid(camera, columns_, rows_).cast<float>();
  const ArrayXf column =
      static_cast<float>(area.x) +
      ArrayXf::LinSpaced(area.width, 0.5F, static_cast<float>(area.width) - 0.5F);
  for (int y = 0; y < area.height; ++y) {
    const Vector3f row_part =
        floor_from_cell * Vector3f(0, static_cast<float>(area.y + y) + 0.5F, 1);
    const ArrayXf closeness = floor_from_cell(2, 0) * column + row_part.z();
    const ArrayXf w = 1 / closeness.max(1e-20F);  // closeness is small where the body is large
    const ArrayXf x = (floor_from_cell(0, 0) * column + row_part.x()) * w;
    const ArrayXf z = (floor_from_cell(1, 0) * column + row_part.y()) * w;
    ArrayXf open = ArrayXf::Ones(area.width);
    for (const picture::Ball& ball : balls_) {
      const Vector3f centre = ((X * ball.centre - Vector3d(0, height_, 0)) / radius_).cast<float>();
      if (centre.y() <= 0) continue;
      const auto r = static_cast<float>(ball.radius / radius_);
      const ArrayXf squared = (x - centre.x()).square() + (z - centre.z()).square() +
                              std::max(centre.y() * centre.y(), r * r);
      const ArrayXf cosine_squared = centre.y() * centre.y() / squared;
      open *= (1 - 5 * cosine_squared.square() * (1 - (1 - r * r / squared).sqrt())).max(0);
    }
    constexpr float faded = 1.3F;  // in radii from the middle: to a quarter
    const ArrayXf near =
        (closeness > 0).cast<float>() / (1 + (x.square() + z.square()) / (faded * faded)).square();
    const ArrayXf reflected = static_cast<float>(style_.reflection) * near;
    ArrayXf left = ArrayXf::Ones(area.width);
    if (style_.clouds > 0) left -= static_cast<float>(style_.clouds) * near * clouds(x, z);
    Cell* cell = cells.data() + std::ptrdiff_t{y} * area.width;
    for (int i = 0; i < area.width; ++i) {
      const float lit = 1 - static_cast<float>(style_.shadow) * (1 - open[i]);
      const float shadow = std::max(255 * (1 - left[i] * lit) - least_shadow, 0.0F);
      cell[i] *= reflected[i];
      cell[i][3] += (1 - cell[i][3] / 255) * shadow;
      cell[i] *= fade((area.x + i + 0.5) / columns_, (area.y + y + 0.5) / rows_);
    }
  }
}

PendingLayer Floor::draw(const Camera& camera, const Matrix3d& X, const BodyPass& body) {
  const image::Area area = seen(camera);
  return pending_layer(begin_reflection(camera, X, body, area),
                       [=, this](const image::Image& reflection) {
                         std::vector<Cell> cells = blurred(reflection);
                         add_shadow(camera, X, area, cells);
                         return over_pane(area, std::move(cells));
                       });
}

/// Returns the cells in `area` of the grid as a layer over that part of the pane.
SoftLayer Floor::over_pane(const image::Area& area, std::vector<Cell> cells) const {
  const Eigen::Array2d cell(static_cast<double>(pane_.width) / columns_,
                            static_cast<double>(pane_.height) / rows_);
  const Eigen::Array2d first = cell * Eigen::Array2d(area.x, area.y);
  const Eigen::Array2i size(pane_.width, pane_.height), cells_of_pane(columns_, rows_);
  const Eigen::Array2i from = Eigen::Array2i(area.x, area.y) * size / cells_of_pane;
  const Eigen::Array2i to =
      Eigen::Array2i(area.x + area.width, area.y + area.height) * size / cells_of_pane;
  return {area.width,
          area.height,
          std::move(cells),
          first + Eigen::Array2d(pane_.x, pane_.y),
          cell,
          {pane_.x + from.x(), pane_.y + from.y(), (to - from).x(), (to - from).y()}};
}

}  // namespace twrench::draw
