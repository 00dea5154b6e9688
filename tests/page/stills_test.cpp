#include "page/stills.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/motion/stability.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/enumeration.h"
#include "page/figure_start.h"
#include "page/page_html.h"
#include "scene/shown_recording.h"

namespace twrench::page {
namespace {

using body::PrincipalAxes;
using Eigen::Vector3d;
using scene::Scene;
using testing::IsSupersetOf;

std::vector<Still> stills_of_scene(const char* name, bool has_article = true) {
  return stills_of(shown_scene(scene::load_scene(name)), has_article);
}

std::vector<std::string> names_of(const std::vector<Still>& stills) {
  std::vector<std::string> names;
  for (const Still& still : stills) names.push_back(still.name);
  return names;
}

const Still& find(const std::vector<Still>& stills, const std::string& name) {
  return *std::ranges::find(stills, name, &Still::name);
}

TEST(Stills, AreOfEachFigureAndOfTheInsetsOfTheLab) {
  std::vector<std::string> names{"part-flip",   "part-axes",   "part-try",    "part-constant",
                                 "part-frame",  "part-stable", "part-sphere", "part-waiting",
                                 "part-inside", "part-methods"};
  std::vector<std::string> of_lab;
  for (const scene::Inset& inset : scene::insets) {
    of_lab.emplace_back(enumerator_name(inset.feature));
  }
  names.insert(names.end(), of_lab.begin(), of_lab.end());
  EXPECT_EQ(names_of(stills_of_scene("dzhanibekov")), names);
  EXPECT_EQ(names_of(stills_of_scene("dzhanibekov", false)), of_lab);
}

TEST(Stills, HaveTheSameSize) {
  for (const Still& still : stills_of_scene("dzhanibekov")) {
    int width = 0;
    for (const Scene& pane : still.panes) {
      width += pane.film.width;
      EXPECT_EQ(pane.film.height, 144) << still.name;
    }
    EXPECT_EQ(width, 192) << still.name;
  }
}

TEST(Stills, OfThreeAxesShowThreeBodiesEachAboutItsOwn) {
  const auto stills = stills_of_scene("dzhanibekov");
  const Still& axes = find(stills, "part-axes");
  ASSERT_EQ(axes.panes.size(), 3U);
  for (const int i : PrincipalAxes::all) {
    const Scene& pane = axes.panes.at(static_cast<std::size_t>(i));
    const auto [moments, principal] = scene::free_body(pane).principal();
    const Vector3d along = principal.transpose() * pane.motion.omega;
    EXPECT_NEAR(std::abs(along[i]), 1, 1e-3);
    EXPECT_NEAR(along.norm() / std::abs(along[i]), std::hypot(1, 0.05), 1e-12);
  }
}

TEST(Stills, OfARecordingShowItBesideTheExactMotion) {
  Scene scene = scene::load_scene("tennis-racket");
  scene.motion.attitude = Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vector3d::UnitX()));
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(1, Vector3d::UnitZ()));
  scene.motion.recording = std::make_shared<const scene::ShownRecording>(
      scene::ShownRecording{.file = "a.csv",
                            .path = {},
                            .motion = {{{0, turned, {1, 2, 3}}, {1, turned, {1, 2, 3}}}, 2},
                            .flip_times = {},
                            .sha256 = {}});
  const auto stills = stills_of(shown_scene(scene), true);
  const Still& recorded = find(stills, "part-recorded");
  ASSERT_EQ(recorded.panes.size(), 2U);
  EXPECT_EQ(recorded.panes[0].motion.recording, scene.motion.recording);
  EXPECT_LE(recorded.panes[0].motion.duration, 1);
  EXPECT_EQ(recorded.panes[1].motion.recording, nullptr);
  EXPECT_TRUE(recorded.panes[1].motion.attitude);
  for (const Still& still : stills) {
    if (still.name == "part-recorded") continue;
    for (const Scene& pane : still.panes) EXPECT_EQ(pane.motion.recording, nullptr) << still.name;
  }
  EXPECT_FALSE(find(stills, "part-flip").panes[0].motion.attitude);
}

// The figures of such a body are of a box, but the first is of the body itself.
TEST(Stills, OfABodyWithEqualMomentsShowItAndABox) {
  const auto stills = stills_of_scene("sphere");
  ASSERT_THAT(names_of(stills), IsSupersetOf({"part-own", "part-flip"}));
  EXPECT_FALSE(find(stills, "part-own").panes[0].body.inertia);
  EXPECT_EQ(scene::mass_properties(find(stills, "part-flip").panes[0].body).moments,
            Vector3d(700, 1000, 1500));
}

TEST(Stills, OfABodyWithAWheelLeaveOutWhatOnlyRigidBodiesHave) {
  const auto names = names_of(stills_of_scene("dual-spin"));
  EXPECT_EQ(std::ranges::count(names, "poinsot"), 0);
  EXPECT_EQ(std::ranges::count(names, "sphere"), 1);
}

TEST(FigureStart, LeansInTheDirectionInWhichTheLeanGrows) {
  const Vector3d moments(700, 1000, 1500);
  const FigureStart start(moments.asDiagonal(), Vector3d(0, 2, 0));
  constexpr double lean = 0.01;
  const Vector3d omega = start.leaning(lean);
  const Vector3d momentum = moments.cwiseProduct(omega);
  EXPECT_NEAR(momentum.norm(), 2000, 1e-9);
  EXPECT_NEAR(std::acos(momentum.normalized().y()), lean, 1e-12);
  // Euler's equations: the rates of the components across the axis are those of exp(rate t).
  const Vector3d across(momentum.x(), 0, momentum.z());
  const Vector3d derivative = momentum.cross(omega);
  const double rate = motion::stability(moments, PrincipalAxes::intermediate, 2).rate;
  EXPECT_NEAR((Vector3d(derivative.x(), 0, derivative.z()) - rate * across).norm(), 0,
              1e-3 * rate * across.norm());
}

TEST(FigureStart, TurnsFromTheLeastAxisToTheGreatest) {
  const FigureStart start(Vector3d(700, 1000, 1500).asDiagonal(), Vector3d(0, 2, 0));
  using std::numbers::pi;
  EXPECT_LT((start.between(0) - Vector3d(2, 0, 0)).norm(), 1e-15);
  EXPECT_LT((start.between(pi / 2) - Vector3d(0, 2, 0)).norm(), 1e-15);
  EXPECT_LT((start.between(pi / 3) - Vector3d(1, std::sqrt(3), 0)).norm(), 1e-15);
  EXPECT_LT((start.between(2 * pi / 3).cwiseAbs() - Vector3d(0, std::sqrt(3), 1)).norm(), 1e-15);
}

}  // namespace
}  // namespace twrench::page
