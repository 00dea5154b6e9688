#include "picture/overlay/draw_list.h"

#include <gtest/gtest.h>
#include <twrench/body/shape.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace twrench::picture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const image::Area list_pane{20, 10, 400, 300};
const Ink red{{255, 0, 0}};

Camera camera() { return frame_sphere({{1, 2, 5}, 0.6, 4.0 / 3, 1.5}); }

Vector2d pixel(const DrawList::Vertex& v) {
  return {list_pane.x + (0.5 + 0.5 * v.clip.x / v.clip.w) * list_pane.width,
          list_pane.y + (0.5 - 0.5 * v.clip.y / v.clip.w) * list_pane.height};
}

class DrawListTest : public testing::Test {
 protected:
  DrawListTest() { list.begin(camera(), list_pane); }

  double nearest(const Vector2d& place) const {
    double distance = 1e9;
    for (const auto& v : list.vertices()) {
      distance = std::min(distance, (pixel(v) - place).norm());
    }
    return distance;
  }

  DrawList list;
};

TEST_F(DrawListTest, PutsAnArrowsTipWhereTheMatricesSay) {
  const Vector3d tip(0.4, 0.9, -0.3);
  list.arrow({0.1, 0, 0.2}, tip, 0.02, red);
  EXPECT_LT(nearest(pixel_of(camera(), list_pane, tip)), 1e-3);
  for (const auto& v : list.vertices()) EXPECT_TRUE(std::isfinite(v.clip.x + v.paint.x));
}

// In the depth buffer the arrow is where its points would be after a move towards the eye; on the
// screen it stays where it is.
TEST_F(DrawListTest, AnArrowCanHideWhatIsNearer) {
  const Vector3d from(0.1, 0, 0.2), to(0.4, 0.9, -0.3);
  constexpr double nearer = 0.3;
  list.arrow(from, to, 0.02, red);
  const std::vector<DrawList::Vertex> plain = list.vertices();
  list.begin(camera(), list_pane);
  list.arrow(from, to, 0.02, red, nearer);
  ASSERT_EQ(list.vertices().size(), plain.size());
  const Eigen::Matrix4d clip_from_space = camera().projection * camera().view;
  const auto depth = [&](const Vector3d& place) {
    const Eigen::Vector4d clip = clip_from_space * place.homogeneous();
    return clip.z() / clip.w();
  };
  const double change = depth(to + nearer * (list.eye() - to).normalized()) - depth(to);
  ASSERT_LT(change, 0);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const auto &before = plain[i].clip, &after = list.vertices()[i].clip;
    EXPECT_LT((pixel(list.vertices()[i]) - pixel(plain[i])).norm(), 1e-3);
    EXPECT_NEAR(after.z / after.w - before.z / before.w, change, 0.5 * std::abs(change));
  }
  list.begin(camera(), list_pane);
  list.arrow(from, to, 0.02, red);
  EXPECT_EQ(list.vertices().front().clip.z, plain.front().clip.z) << "only that arrow";
}

TEST_F(DrawListTest, AnArrowOfNoLengthIsNothingAndAShortOneAllHead) {
  list.arrow({1, 1, 1}, {1, 1, 1}, 0.1, red);
  EXPECT_TRUE(list.vertices().empty());
  list.arrow(Vector3d::Zero(), {0.01, 0, 0}, 0.1, red);
  const double size = list.pixels(Vector3d::Zero());
  for (const auto& v : list.vertices()) {
    EXPECT_LT((pixel(v) - pixel_of(camera(), list_pane, Vector3d::Zero())).norm(), 0.02 * size);
  }
}

TEST_F(DrawListTest, ALineIsAsWideAsItSaysWithRoomForItsRamp) {
  list.line(std::array<DrawList::Point, 2>{{{{-1, 0, 0}, 4, red}, {{1, 0, 0}, 4, red}}});
  ASSERT_EQ(list.vertices().size(), 8);
  for (const std::size_t i : {0, 2, 4, 6}) {
    const DrawList::Vertex &left = list.vertices()[i], &right = list.vertices()[i + 1];
    EXPECT_NEAR((pixel(left) - pixel(right)).norm(), 6, 1e-3);
    EXPECT_EQ(left.edge.z, 2);
  }
}

TEST_F(DrawListTest, ALinesEndsAreRoundUnlessItIsClosed) {
  const std::array<DrawList::Point, 3> bend{
      {{{-1, 0, 0}, 4, red}, {{0, 0.3, 0}, 4, red}, {{1, 0, 0}, 4, red}}};
  list.line(bend);
  const auto middle = [&](std::size_t i) -> Vector2d {
    return 0.5 * (pixel(list.vertices()[i]) + pixel(list.vertices()[i + 1]));
  };
  ASSERT_EQ(list.vertices().size(), 10);
  EXPECT_NEAR((middle(0) - middle(2)).norm(), 3, 1e-3) << "half the width and the ramp's margin";
  EXPECT_NEAR((middle(8) - middle(6)).norm(), 3, 1e-3);
  for (const std::size_t i : {0, 1, 8, 9}) EXPECT_EQ(list.vertices()[i].edge.y, 3);
  for (std::size_t i = 2; i < 8; ++i) EXPECT_EQ(list.vertices()[i].edge.y, 0);
  list.begin(camera(), list_pane);
  std::vector<DrawList::Point> circle;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    circle.push_back({{std::cos(angle), std::sin(angle), 0}, 4, red});
  }
  list.line(circle);
  for (const auto& vertex : list.vertices()) EXPECT_EQ(vertex.edge.y, 0) << "on a closed line";
}

TEST_F(DrawListTest, ALineTurnsSharplyAroundARoundCorner) {
  const Vector3d corner(0, 1, 0);
  list.line(std::array<DrawList::Point, 3>{
      {{{-0.2, 0, 0}, 4, red}, {corner, 4, red}, {{0.2, 0, 0}, 4, red}}});
  const Vector2d place = pixel_of(camera(), list_pane, corner);
  double beyond = 0;
  for (const auto& v : list.vertices()) {
    if (v.edge.y > 0) beyond = std::max(beyond, place.y() - pixel(v).y());
  }
  EXPECT_GT(beyond, 2) << "the tip is as round as an end";
}

TEST_F(DrawListTest, TellsHowMuchNearerAShareOfTheHeightIs) {
  for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(0.5, -0.4, 1)}) {
    const Vector3d nearer = place + (list.eye() - place).normalized() / list.pixels(place);
    const Eigen::Matrix4d clip_from_space = camera().projection * camera().view;
    const Eigen::Vector4d before = clip_from_space * place.homogeneous(),
                          after = clip_from_space * nearer.homogeneous();
    const double moved = before.w() * (after.z() / after.w() - before.z() / before.w());
    EXPECT_NEAR(list.clip_z_nearer(1.0 / list_pane.height), moved, 0.02 * std::abs(moved));
  }
}

/// Returns twice the area in pixels, positive if the triangle appears anticlockwise.
double turn(const DrawList& list, const std::vector<std::uint32_t>& faces, std::size_t i) {
  const Vector2d a = pixel(list.vertices()[faces[i]]);
  const Vector2d ab = pixel(list.vertices()[faces[i + 1]]) - a,
                 ac = pixel(list.vertices()[faces[i + 2]]) - a;
  return ac.x() * ab.y() - ab.x() * ac.y();  // y points down
}

TEST_F(DrawListTest, FacesOfArrowsAreAnticlockwiseFromOutside) {
  // The arrow is only a head. If it points towards the eye, the base is hidden and the side is
  // seen, and vice versa.
  for (const double sign : {1.0, -1.0}) {
    list.begin(camera(), list_pane);
    list.arrow(Vector3d::Zero(), sign * 0.1 * list.eye().normalized(), 0.3, red);
    const auto& faces = list.items().faces;
    double seen = 0;
    for (std::size_t i = 0; i < faces.size(); i += 3) {
      seen += turn(list, faces, i) > 0 ? 1 : 0;
    }
    const double around = 28;
    EXPECT_EQ(seen, around) << (sign > 0 ? "the side" : "the base");
  }
}

TEST_F(DrawListTest, ArrowsHaveAnOutlineOfTheOppositeLightness) {
  const auto outline = [&](const Color& color) {
    list.begin(camera(), list_pane);
    list.arrow({-1, 0, 0}, {1, 0, 0}, 0.02, {color});
    EXPECT_FALSE(list.outlines().faces.empty());
    return list.vertices()[list.outlines().faces[0]].paint;
  };
  EXPECT_GT(outline({20, 20, 120}).x, 0.8F) << "white around dark blue";
  EXPECT_LT(outline({255, 216, 39}).x, 0.1F) << "black around yellow";
  // The outline is at least a pixel wide on both sides.
  double lowest = 1e9, highest = -1e9, low = 1e9, high = -1e9;
  const auto extend = [&](const std::vector<std::uint32_t>& faces, double& from, double& to) {
    for (const std::uint32_t i : faces) {
      const Vector2d place = pixel(list.vertices()[i]);
      from = std::min(from, place.y());
      to = std::max(to, place.y());
    }
  };
  extend(list.items().faces, lowest, highest);
  extend(list.outlines().faces, low, high);
  EXPECT_LT(low, lowest - 0.9);
  EXPECT_GT(high, highest + 0.9);
}

TEST_F(DrawListTest, ALineThinnerThanAPixelIsFainterInstead) {
  list.line(std::array<DrawList::Point, 2>{{{{-1, 0, 0}, 0.25, red}, {{1, 0, 0}, 0.25, red}}});
  EXPECT_EQ(list.vertices()[0].edge.z, 0.5F);
  EXPECT_EQ(list.vertices()[0].paint.w, 0.25F);
}

TEST_F(DrawListTest, LeavesOutPointsOfALineThatNobodyMisses) {
  std::vector<DrawList::Point> circle;
  for (int i = 0; i <= 2000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 2000;
    circle.push_back({{std::cos(angle), std::sin(angle), 0}, 2, red});
  }
  list.line(circle);
  const auto& vertices = list.vertices();
  EXPECT_LT(vertices.size(), 400);
  const auto middle = [&](std::size_t i) -> Vector2d {
    return 0.5 * (pixel(vertices[i]) + pixel(vertices[i + 1]));
  };
  double astray = 0;
  for (const auto& point : circle) {
    const Vector2d place = pixel_of(camera(), list_pane, point.place);
    double nearest = 1e9;
    for (std::size_t i = 0; i + 3 < vertices.size(); i += 2) {
      const Vector2d a = middle(i), way = middle(i + 2) - a;
      const double t = std::clamp((place - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (a + t * way - place).norm());
    }
    astray = std::max(astray, nearest);
  }
  EXPECT_LT(astray, 0.2);
}

TEST_F(DrawListTest, BreaksALineBehindTheEye) {
  const Vector3d eye = list.eye();
  list.line(std::array<DrawList::Point, 5>{{{{-1, 0, 0}, 2, red},
                                            {{0, 0, 0}, 2, red},
                                            {2 * eye, 2, red},
                                            {{1, 0, 0}, 2, red},
                                            {{1, 1, 0}, 2, red}}});
  EXPECT_EQ(list.vertices().size(), 16);
  EXPECT_EQ(list.items().faces.size(), 36);
}

TEST_F(DrawListTest, ShowsTheNearSideOfAnEllipsoidOnly) {
  const Eigen::Matrix3d radii = Vector3d(1, 0.5, 0.7).asDiagonal();
  list.ellipsoid(radii, red, 1);
  ASSERT_GT(list.items().faces.size(), 300);
  const auto& v = list.vertices();
  int facets = 0;
  for (std::size_t i = 0; i < list.items().faces.size(); i += 3) {
    if (v[list.items().faces[i]].edge.z < 1e5F) continue;  // of the edge quad along the silhouette
    ++facets;
    const Vector2d a = pixel(v[list.items().faces[i]]), b = pixel(v[list.items().faces[i + 1]]),
                   c = pixel(v[list.items().faces[i + 2]]);
    const Vector2d ab = b - a, ac = c - a;
    // The silhouette is shrunk by 0.75 pixels, and may thus come inside the previous ring.
    const double tucked = 0.75 * std::max(ab.norm(), ac.norm());
    EXPECT_LE(ab.x() * ac.y() - ab.y() * ac.x(), tucked) << "turned away";
  }
  EXPECT_GT(facets, 100);
  list.begin(camera(), list_pane);
  list.ellipsoid(Vector3d(1, 1e-5, 1e-5).asDiagonal(), red, 1);
  for (const auto& vertex : list.vertices()) EXPECT_TRUE(std::isfinite(vertex.paint.x));
}

TEST_F(DrawListTest, AnEllipsoidThatReachesBehindTheEyeIsTheSameWhateverWasDrawnBefore) {
  const Vector3d eye = list.eye();
  const Eigen::Matrix3d frame = body::frame_with_z_along(eye);
  // The disc is about the origin and has a radius larger than the eye's distance. Its plane passes
  // the eye.
  const Eigen::Matrix3d disc = frame *
                               Eigen::AngleAxisd(0.3, Vector3d::UnitX()).toRotationMatrix() *
                               Vector3d(3 * eye.norm(), 0.01, 3 * eye.norm()).asDiagonal();
  std::vector<DrawList::Point> line;
  for (int i = 0; i < 9000; ++i) line.push_back({{0.01 * (i % 40), 0.02 * (i % 9), 0}, 1, red});
  list.line(line);
  list.begin(camera(), list_pane);
  list.ellipsoid(disc, red, 1);
  DrawList fresh;
  fresh.begin(camera(), list_pane);
  fresh.ellipsoid(disc, red, 1);
  ASSERT_EQ(list.vertices().size(), fresh.vertices().size());
  int behind = 0;
  for (std::size_t i = 0; i < fresh.vertices().size(); ++i) {
    behind += fresh.vertices()[i].clip.w <= 0 ? 1 : 0;
    ASSERT_EQ(list.vertices()[i].clip, fresh.vertices()[i].clip) << i;
  }
  EXPECT_GT(behind, 0);
}

TEST_F(DrawListTest, TellsTheAreaItCovers) {
  list.dot({0.3, 0.2, 0.1}, 5, red);
  ScreenArea screen(list_pane);
  list.add_to(screen);
  const Vector2d middle = pixel_of(camera(), list_pane, {0.3, 0.2, 0.1});
  const image::Area area = screen.bounds();
  EXPECT_LT(area.x, middle.x() - 5.5);
  EXPECT_GT(area.x + area.width, middle.x() + 5.5);
  EXPECT_LT(area.width, 17);
}

}  // namespace
}  // namespace twrench::picture
