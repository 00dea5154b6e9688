// "Add a shape" of CONTRIBUTING.md, for every alternative of body::Shape. A shape without an
// example here is a link error; so is one without its functions, unless it is a compile error or
// fails here.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <variant>

#include "picture/body/bounding_radius.h"
#include "picture/body/mesh.h"
#include "picture/body/occluders.h"
#include "picture/overlay/trail_point.h"
#include "picture/shapes/shapes.h"
#include "scene/scene_json.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

/// Returns an example in which no two lengths are equal.
template <typename T>
T example();
template <>
body::Cylinder example() {
  return {1.5, 4.0};
}
template <>
body::Box example() {
  return {{2.0, 3.0, 5.0}};
}
template <>
body::Ellipsoid example() {
  return {{1.0, 2.0, 3.5}};
}
template <>
body::Cone example() {
  return {2.0, 5.0, 0.7};
}
template <>
body::Torus example() {
  return {3.0, 0.8};
}
template <>
body::Capsule example() {
  return {0.9, 4.0};
}
template <>
body::Tube example() {
  return {2.0, 1.2, 5.0};
}

template <>
body::Mesh example() {
  return body::make_mesh({{{-1, -2, -1}, {3, -1, -1}, {0, 3, -1}, {0, 0, 4}},
                          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                          {}});
}

template <typename Variant>
struct AlternativesOf;
template <typename... T>
struct AlternativesOf<std::variant<T...>> {
  using Types = testing::Types<T...>;
};

template <typename T>
class ShapeRecipe : public testing::Test {
 protected:
  const body::Part part{example<T>(), 2.0, Vector3d(3, -1, 2), body::frame_with_z_along({1, 2, 2})};
};
TYPED_TEST_SUITE(ShapeRecipe, AlternativesOf<body::Shape>::Types);

std::string toml_of(const nlohmann::ordered_json& part) {
  std::string text = "[[part]]\n";
  for (const auto& [key, value] : part.items()) text += key + " = " + value.dump() + "\n";
  return text;
}

/// Returns the part as in a scene's JSON.
nlohmann::ordered_json json_of(const body::Part& part) {
  scene::Scene scene;
  scene.body.parts = {part};
  return scene::scene_json(scene)["part"][0];
}

template <typename T>
constexpr bool has_file_of_its_own = std::is_same_v<T, body::Mesh>;

TYPED_TEST(ShapeRecipe, IsReadFromAFileAsItIsWritten) {
  if constexpr (has_file_of_its_own<TypeParam>) GTEST_SKIP();
  const auto json = json_of(this->part);
  const scene::Scene scene = scene::parse_scene(toml_of(json), "recipe.toml");
  ASSERT_EQ(scene.body.parts.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<TypeParam>(scene.body.parts[0].shape));
  EXPECT_NEAR(body::volume(scene.body.parts[0].shape), body::volume(this->part.shape), 1e-12);
  EXPECT_EQ(json_of(scene.body.parts[0])["shape"], json["shape"]);
}

TYPED_TEST(ShapeRecipe, IsDescribedInTheDocument) {
  if constexpr (has_file_of_its_own<TypeParam>) GTEST_SKIP();
  std::ifstream file(TWRENCH_TESTS_DIR "/../docs/scene-files.md");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string name = json_of(this->part)["shape"];
  EXPECT_NE(text.str().find("| `" + name + "` |"), std::string::npos) << name;
}

/// Volume of the picture's mesh and the integral for its moments, by the divergence theorem.
struct Solid {
  double volume = 0;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();  ///< the integral of x x^T
};

Solid solid_of(const Mesh& mesh, const Vector3d& centre) {
  Solid solid;
  const auto corner = [&](std::size_t index) -> Vector3d {
    const glm::vec3& p = mesh.vertices[mesh.indices[index]].position;
    return Vector3d(p.x, p.y, p.z) - centre;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vector3d a = corner(i), b = corner(i + 1), c = corner(i + 2), sum = a + b + c;
    const double tetrahedron = a.dot(b.cross(c)) / 6;
    solid.volume += tetrahedron;
    solid.squares +=
        tetrahedron / 20 *
        (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  return solid;
}

// The drawn solid is the one that turns, except for the bevels of edges, which are narrow here.
TYPED_TEST(ShapeRecipe, IsDrawnAsTheSolidThatItsNumbersTellOf) {
  const Vector3d centre =
      this->part.position + this->part.body_from_part * body::centroid(this->part.shape);
  const Solid solid = solid_of(part_mesh(this->part, 1e-4), centre);
  EXPECT_NEAR(solid.volume / body::volume(this->part.shape), 1, 0.01);
  const Eigen::Matrix3d& R = this->part.body_from_part;
  const Eigen::Matrix3d own = R.transpose() * solid.squares * R;
  const Vector3d moments = Vector3d::Constant(own.trace()) - own.diagonal();
  const Vector3d expected =
      body::central_inertia(this->part.shape, body::volume(this->part.shape)).diagonal();
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(moments[axis] / expected[axis], 1, 0.02) << axis;
}

TYPED_TEST(ShapeRecipe, LiesInItsBounds) {
  double farthest = 0, farthest_of_all = 0;
  for (const Vertex& vertex : part_mesh(this->part, 1e-4).vertices) {
    const Vector3d point(vertex.position.x, vertex.position.y, vertex.position.z);
    farthest = std::max(farthest, (point - this->part.position).norm());
    farthest_of_all = std::max(farthest_of_all, point.norm());
  }
  const double bound = body::bounding_radius(this->part.shape);
  EXPECT_LE(farthest, bound * (1 + 1e-6));
  EXPECT_GE(farthest, bound * 0.96);
  EXPECT_LE(farthest_of_all,
            bounding_radius(std::span<const body::Part>(&this->part, 1)) * (1 + 1e-6));
}

TYPED_TEST(ShapeRecipe, HoldsWhatIsInsideItsSurface) {
  if constexpr (IsRings<TypeParam>) {
    const auto shape = example<TypeParam>();
    for (const auto& ring : rings_of(shape, 1e-4).rings) {
      for (const auto& [position, normal] : ring) {
        EXPECT_TRUE(holds(shape, position, 1e-3));
        EXPECT_FALSE(holds(shape, position + 0.2 * normal, 1e-3));
      }
    }
  }
}

// The integrals equal those over the points that the shape holds, by the midpoint rule on a grid.
TYPED_TEST(ShapeRecipe, HasTheIntegralsOverWhatItHolds) {
  if constexpr (IsRings<TypeParam>) {
    const auto shape = example<TypeParam>();
    const Eigen::AlignedBox3d box = body::bounding_box(shape);
    constexpr int n = 120;
    double count = 0;
    Vector3d sum = Vector3d::Zero(), squares = Vector3d::Zero();
    for (int i = 0; i < n * n * n; ++i) {
      const Vector3d share = Vector3d(i % n + 0.5, i / n % n + 0.5, i / (n * n) + 0.5) / n;
      const Vector3d point = box.min() + share.cwiseProduct(box.sizes());
      if (!holds(shape, point, 0)) continue;
      ++count;
      sum += point;
      squares += point.cwiseAbs2();
    }
    const double volume = count / n / n / n * box.volume();
    EXPECT_NEAR(volume / body::volume(shape), 1, 2e-3);
    const Vector3d centre = sum / count;
    EXPECT_LE((centre - body::centroid(shape)).norm(), 2e-3 * body::bounding_radius(shape));
    const Vector3d spread = squares / count - centre.cwiseAbs2();
    const Vector3d moments = Vector3d::Constant(spread.sum()) - spread;
    const Vector3d expected = body::central_inertia(shape, 1).diagonal();
    EXPECT_LE((moments - expected).norm(), 3e-3 * expected.norm());
  }
}

TYPED_TEST(ShapeRecipe, HasTheSymmetryOfItsExtent) {
  const body::Shape shape = example<TypeParam>();
  const auto extent = [&](double angle) {
    const Vector3d direction(std::cos(angle), std::sin(angle), 0.3);
    return direction.dot(body::support(shape, direction));
  };
  bool is_round = true;
  for (int i = 1; i < 12; ++i) is_round = is_round && std::abs(extent(i) - extent(0)) < 1e-12;
  EXPECT_EQ(traits_of(shape).symmetry == of_revolution, is_round);
}

// The capsules that shade other parts instead of the shape, and the end that draws a trail, are
// close to the shape.
TYPED_TEST(ShapeRecipe, HasACapsuleAndAnEnd) {
  const double bound = body::bounding_radius(this->part.shape);
  const std::vector<Capsule> capsules = capsules_of(this->part);
  EXPECT_FALSE(capsules.empty());
  for (const Capsule& capsule : capsules) {
    EXPECT_GT(capsule.radius, 0);
    for (const Vector3d& end : {capsule.from, capsule.to}) {
      EXPECT_LE((end - this->part.position).norm(), bound);
    }
  }
  scene::Scene scene;
  scene.body.parts = {this->part};
  const double distance = trail_point(scene).norm();
  EXPECT_GT(distance, 0.3 * bound);
  EXPECT_LT(distance, 1.2 * bound);
}

}  // namespace
}  // namespace twrench::picture
