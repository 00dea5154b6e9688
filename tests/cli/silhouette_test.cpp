// The body is drawn where its motion and the manifest's matrices place it. The test compares its
// silhouette with one computed without the renderer, by casting rays through the pixels at the two
// cylinders.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/twrench.h"
#include "image/png.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr int width = 640, height = 360;

/// A line in body axes: origin + s * direction.
struct Ray {
  Vector3d origin, direction;
};

/// Whether the ray meets the cylinder |position along `axis`| <= half, within `radius` of it.
bool meets(const Ray& ray, const Vector3d& centre, int axis, double half, double radius) {
  const Vector3d o = ray.origin - centre;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto& d = ray.direction;
  const double a = d[u] * d[u] + d[v] * d[v];
  const double b = o[u] * d[u] + o[v] * d[v];
  const double c = o[u] * o[u] + o[v] * o[v] - radius * radius;
  const double root = b * b - a * c;
  if (root < 0) return false;
  // Within the infinite cylinder for s from s1 to s2, between the planes of its ends from e1 to e2.
  const double s1 = (-b - std::sqrt(root)) / a, s2 = (-b + std::sqrt(root)) / a;
  const double e1 = (-half - o[axis]) / d[axis], e2 = (half - o[axis]) / d[axis];
  return std::max(s1, std::min(e1, e2)) <= std::min(s2, std::max(e1, e2));
}

/// The T-wrench about its centre of mass: a handle 8 cm long and a leg 4 cm long, both of radius 1
/// cm. The leg ends at x = 0, where it touches the handle along a line; it is drawn extended to the
/// handle's axis, x = -1, to close the gap along the handle.
bool meets_wrench(const Ray& ray) {
  return meets(ray, {-1, 0, 0}, 1, 4, 1) || meets(ray, {1.5, 0, 0}, 0, 2.5, 1);
}

template <int size>
Eigen::Matrix<double, size, size> matrix(const nlohmann::json& rows) {
  Eigen::Matrix<double, size, size> result;
  for (int i = 0; i < size * size; ++i) {
    result(i / size, i % size) = rows[static_cast<std::size_t>(i)];
  }
  return result;
}

double intersection_over_union(const image::Image& drawn, const nlohmann::json& frame) {
  const Matrix3d X = matrix<3>(frame["X"]);
  Matrix4d body_from_clip = (matrix<4>(frame["projection"]) * matrix<4>(frame["view"])).inverse();
  body_from_clip.topRows<3>() = X.transpose() * body_from_clip.topRows<3>().eval();
  int both = 0, either = 0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double x = (2 * column + 1.0) / width - 1, y = 1 - (2 * row + 1.0) / height;
      const Vector4d near = body_from_clip * Vector4d(x, y, -1, 1);
      const Vector4d far = near + 2 * body_from_clip.col(2);
      const Vector3d origin = near.head<3>() / near.w();
      const bool cast = meets_wrench({origin, far.head<3>() / far.w() - origin});
      const std::size_t pixel =
          static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
      const bool seen = drawn.pixels[4 * pixel + 3] >= 128;
      both += cast && seen ? 1 : 0;
      either += cast || seen ? 1 : 0;
    }
  }
  return static_cast<double>(both) / either;
}

class Silhouette : public testing::TestWithParam<const char*> {};

TEST_P(Silhouette, IsWhereRaysFindTheCylinders) {
  const ScratchFolder folder;
  const Outcome run =
      run_twrench(folder,
                  "render --bare --background transparent --size 640x360 --frames 0-959:40 "
                  "--no-video --progress none --frames-dir f --frame " +
                      std::string(GetParam()));
  ASSERT_EQ(run.code, 0) << run.err;
  const auto manifest = nlohmann::json::parse(text_of(folder / "f/manifest.json"));
  ASSERT_EQ(manifest["frames"].size(), 24U);
  for (const auto& frame : manifest["frames"]) {
    const image::Image drawn = image::read_png(folder / ("f/" + frame["file"].get<std::string>()));
    ASSERT_EQ(drawn.channels, 4);
    EXPECT_GE(intersection_over_union(drawn, frame), 0.99) << "frame " << frame["frame"];
  }
}

INSTANTIATE_TEST_SUITE_P(InEveryFrame, Silhouette, testing::Values("space", "body", "rotating"));

}  // namespace
}  // namespace twrench
