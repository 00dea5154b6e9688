// Checks the captions of the film that explains why a body turns over against the dynamics.
#include <gtest/gtest.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/stability.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/reading_speed.h"
#include "scene/scene.h"
#include "scene/scene_json.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;

/// The shot whose caption contains the words.
const Shot& shot_with(const Scene& film, std::string_view words) {
  return *std::ranges::find_if(film.shots, [&](const Shot& shot) {
    return shot.scene.caption.value_or("").find(words) != std::string::npos;
  });
}

/// The shot whose caption contains the words, with its motion.
struct Told {
  explicit Told(std::string_view words, std::size_t compared = 0, const char* name = "explain")
      : film(load_scene(name)),
        shot(shot_with(film, words)),
        omega(shot.scene.overlay.compare_omega.empty()
                  ? shot.scene.motion.omega
                  : shot.scene.overlay.compare_omega[compared]),
        properties(mass_properties(shot.scene.body)),
        body(properties.inertia, omega),
        exact(body) {}

  double begin() const { return shot.start; }
  double end() const { return shot.time_of(*shot.scene.length); }
  /// Times of the motion in the shot, evenly spaced.
  std::vector<double> times() const {
    std::vector<double> result;
    for (int i = 0; i <= 200; ++i) result.push_back(begin() + (end() - begin()) * i / 200);
    return result;
  }
  /// The body axis about which it spins at the start.
  Eigen::Index axis() const {
    Eigen::Index result = 0;
    omega.cwiseAbs().maxCoeff(&result);
    return result;
  }
  /// The angle in rad between that axis and L.
  double tilt(double t) const {
    return std::acos(exact.at(t).X.col(axis()).dot(body.momentum().normalized()));
  }
  std::vector<double> flips() const {
    std::vector<double> result = exact.flip_times(end());
    std::erase_if(result, [&](double t) { return t < begin(); });
    return result;
  }
  /// The torque of the centrifugal forces on each group of parts about the axis of the tilt, per
  /// squared rate, to first order in the tilt: eps times the sum of m (r_i^2 - r_d^2), with d the
  /// direction in which axis i leans (docs/theory.md).
  std::map<std::string, double> torques(double t) const {
    const motion::Sample sample = exact.at(t);
    const Vector3d momentum = sample.X.transpose() * body.momentum().normalized();
    Vector3d lean = -momentum;
    lean[axis()] = 0;
    const double eps = lean.norm();
    lean /= eps;
    std::map<std::string, double> result;
    const std::vector<body::Part> parts = visible_parts(shot.scene.body);
    for (const PartGroup& group : part_groups(shot.scene.body)) {
      for (const std::size_t part : group.parts) {
        const body::MassProperties alone = body::mass_properties(std::vector{parts[part]});
        // About the body's centre of mass; the second moment is half the trace less the inertia.
        const Vector3d& r = alone.centre_of_mass;
        const Eigen::Matrix3d inertia =
            alone.inertia +
            alone.mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
        const Eigen::Matrix3d second =
            0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia;
        result[group.name] += eps * (second(axis(), axis()) - lean.dot(second * lean));
      }
    }
    return result;
  }

  Scene film;
  Shot shot;
  Vector3d omega;
  body::MassProperties properties;
  motion::FreeBody body;
  motion::ExactMotion exact;
};

TEST(Explain, IsTheSameFilmInBothLanguages) {
  auto english = scene_json(load_scene("explain")),
       norwegian = scene_json(load_scene("explain-nb"));
  ASSERT_EQ(english["shot"].size(), norwegian["shot"].size());
  EXPECT_NE(english["title"], norwegian["title"]);
  for (auto* const film : {&english, &norwegian}) {
    film->erase("title");
    film->erase("language");
    for (auto& part : (*film)["part"]) part.erase("name");
    for (auto& shot : (*film)["shot"]) shot.erase("caption");
  }
  EXPECT_EQ(english, norwegian);
}

TEST(Explain, HasTheLengthOfItsStory) {
  for (const char* name : {"explain", "explain-nb"}) {
    EXPECT_GE(load_scene(name).video_length(), 75) << name;
    EXPECT_LE(load_scene(name).video_length(), 100) << name;
  }
  EXPECT_NEAR(load_scene("explain-short").video_length(), 30, 1);
}

TEST(Explain, CanBeRead) {
  for (const char* name : {"explain", "explain-nb", "explain-short", "explorer-1"}) {
    const Scene film = load_scene(name);
    for (const Shot& shot : film.shots) {
      EXPECT_LE(reading_speed(shot), 15) << name << ": " << *shot.scene.caption;
    }
  }
}

TEST(Captions, ThatAreTooFastAreNamed) {
  Scene film = load_scene("explain");
  EXPECT_TRUE(hasty_captions(film).empty());
  Shot& shot = film.shots[3];
  shot.scene.caption = std::string(34, 'a') + "åøæ";  // 37 characters of 40 bytes
  shot.scene.length = 37 / 17.1;
  shot.place = "a.toml:3: shot[4]";
  ASSERT_EQ(hasty_captions(film).size(), 1U);
  EXPECT_EQ(
      hasty_captions(film).front(),
      "a.toml:3: shot[4].caption: 17.1 characters a second are too fast to read: give the shot "
      "2.18 s, not 2.16 s");
  shot.scene.length = 37 / 16.9;
  EXPECT_TRUE(hasty_captions(film).empty());
}

TEST(Explain, ItTurnsOverBeforeAnyText) {
  for (const char* name : {"explain", "explain-short"}) {
    const Told told("All by itself", 0, name);
    const Shot& first = told.film.shots.front();
    EXPECT_EQ(first.scene.caption.value_or(""), "") << name;
    const double end = first.time_of(*first.scene.length);
    EXPECT_EQ(told.begin(), end) << name << ": it goes on";
    const std::vector<double> flips = told.exact.flip_times(end);
    ASSERT_FALSE(flips.empty()) << name;
    EXPECT_GT(flips.back(), first.start) << name << ": a flip within the first two seconds";
    EXPECT_LE(*first.scene.length, 2) << name;
  }
}

TEST(Explain, NoForceActsOnIt) {
  const Told told("No force acts on it"), before("All by itself"), question("So why");
  EXPECT_TRUE(told.shot.scene.motion.is_rigid());
  EXPECT_EQ(told.begin(), before.end()) << "the same take";
  EXPECT_LT(told.shot.speed.at(2), 0.2 * before.shot.speed.at(0)) << "in slow motion";
  for (const double t : told.times()) {
    const motion::Sample sample = told.exact.at(t);
    const Vector3d momentum = sample.X * (told.body.inertia() * sample.omega);
    EXPECT_LT((momentum - told.body.momentum()).norm(), 1e-12 * momentum.norm());
  }
  EXPECT_EQ(question.begin(), told.end());
  EXPECT_EQ(question.shot.speed.at(2), 0) << "frozen";
  EXPECT_GT(question.tilt(question.end()), 0.3 * std::numbers::pi) << "in the middle of a flip";
  EXPECT_LT(question.tilt(question.end()), 0.7 * std::numbers::pi);
}

// With the same push: the same angular velocity across the axis.
TEST(Explain, OnlyTheMiddleAxisTurnsOver) {
  for (const auto& [words, name] : {std::pair{"The one in between turns over", "explain"},
                                    std::pair{"Only the one in between", "explain-short"}}) {
    const Vector3d moments = Told(words, 0, name).properties.moments;
    EXPECT_LT(moments[0], moments[1]);
    EXPECT_LT(moments[1], moments[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Told told(words, i, name);
      EXPECT_EQ(told.omega[told.axis()], 1) << name;
      EXPECT_NEAR(told.omega.squaredNorm(), 1 + 0.02 * 0.02, 1e-15) << name;
      const double moment = told.properties.inertia(told.axis(), told.axis());
      double farthest = 0;
      for (double t = 0; t <= told.end(); t += 0.1) farthest = std::max(farthest, told.tilt(t));
      if (std::abs(moment - moments[1]) < 1) {
        EXPECT_GT(farthest, 0.9 * std::numbers::pi) << name;
      } else {
        EXPECT_LT(farthest, 0.15) << name << moment;
      }
    }
  }
}

// The camera goes over to the rotating frame without a cut.
TEST(Explain, TheCameraSpinsUpWithTheBody) {
  for (const auto& [words, name] :
       {std::pair{"the stars turn", "explain"}, std::pair{"Now the body rests", "explain-short"}}) {
    const Told before("spin along", 0, name), told(words, 0, name);
    EXPECT_EQ(before.shot.scene.camera.frame, Frame::space) << name;
    EXPECT_EQ(told.shot.scene.camera.frame, Frame::rotating) << name;
    EXPECT_EQ(told.begin(), before.end()) << name << ": one motion";
    EXPECT_EQ(told.omega, before.omega) << name;
    EXPECT_GT(told.shot.move, 2) << name;
    EXPECT_EQ(told.shot.fade, 0) << name;
    for (const double t : told.times()) EXPECT_LT(told.tilt(t), 0.15) << name << ": it rests";
  }
}

TEST(Explain, TheCrossSpinsAboutTheLineThroughTheLightDiscs) {
  const Told cross("two heavy and two light"), told("line through the light ones");
  const std::vector<body::Part> parts = visible_parts(told.shot.scene.body);
  std::map<std::string, std::vector<body::Part>> groups;
  for (const PartGroup& group : part_groups(told.shot.scene.body)) {
    for (const std::size_t part : group.parts) groups[group.name].push_back(parts[part]);
  }
  ASSERT_EQ(groups["heavy discs"].size(), 2u);
  ASSERT_EQ(groups["light discs"].size(), 2u);
  EXPECT_GT(body::mass_properties(groups["heavy discs"]).mass,
            2 * body::mass_properties(groups["light discs"]).mass);
  for (const body::Part& disc : groups["light discs"]) {
    EXPECT_NEAR(std::abs(disc.position.normalized()[told.axis()]), 1, 1e-12);
  }
  for (const double t : told.times()) EXPECT_LT(told.tilt(t), 0.1);
  EXPECT_EQ(told.begin(), cross.end());
}

TEST(Explain, TheLightDiscsAreFlungOut) {
  const Told told("and are flung out");
  EXPECT_EQ(told.begin(), Told("line through the light ones").end());
  double last = 0;
  for (const double t : told.times()) {
    std::map<std::string, double> torques = told.torques(t);
    EXPECT_GT(torques["light discs"], -torques["heavy discs"]) << t;
    EXPECT_LE(torques["heavy discs"], 0) << t;
    EXPECT_GT(torques["light discs"], last) << "farther and farther, " << t;
    last = torques["light discs"];
  }
}

TEST(Explain, TheBarPullsBackAndTheLegPullsHarder) {
  for (const char* name : {"explain", "explain-short"}) {
    const Told told("the leg pulls harder", 0, name);
    for (const double t : told.times()) {
      std::map<std::string, double> torques = told.torques(t);
      EXPECT_LT(torques["bar"], 0) << name << t;
      EXPECT_GT(torques["leg"], -torques["bar"]) << name << t;
    }
    const Told over("over it goes", 0, name);
    EXPECT_EQ(over.begin(), told.end()) << name;
    EXPECT_GT(over.tilt(over.end()), 0.5 * std::numbers::pi) << name;
  }
}

TEST(Explain, TheTiltDoublesAgainAndAgain) {
  const Told told("again and again");
  const double doubling =
      motion::stability(told.properties.moments, body::PrincipalAxes::intermediate, 1)
          .doubling_time();
  EXPECT_EQ(told.begin(), 0);
  EXPECT_LT(told.tilt(0), 1e-7);
  int doublings = 0;
  for (double t = 10; t < 44; t += doubling) {
    EXPECT_NEAR(told.tilt(t + doubling) / told.tilt(t), 2, 0.01) << t;
    ++doublings;
  }
  EXPECT_GT(doublings, 15);
  EXPECT_EQ(told.flips().size(), 1u) << "until it is over";
}

TEST(Explain, TheMomentumStaysOnASphereAndOnOneCurve) {
  const Told sphere("its tip stays on a sphere"), told("leaves one curve");
  EXPECT_EQ(sphere.end(), told.begin());
  const double energy = motion::energy(told.body.inertia(), told.omega);
  for (const Told* shot : {&sphere, &told}) {
    for (const double t : shot->times()) {
      const Vector3d omega = shot->exact.at(t).omega;
      const Vector3d momentum = shot->body.inertia() * omega;
      EXPECT_NEAR(momentum.norm() / told.body.momentum().norm(), 1, 1e-12);
      EXPECT_NEAR(motion::energy(told.body.inertia(), omega) / energy, 1, 1e-12);
    }
  }
}

TEST(Explain, TheMomentumGoesToTheOtherEndOfTheMiddleAxisAndBack) {
  const Told first("its tip stays on a sphere"), told("to the other, and back");
  EXPECT_EQ(told.begin(), Told("leaves one curve").end());
  EXPECT_LT(first.tilt(first.begin()), 0.2);
  double farthest = 0;
  for (double t = first.begin(); t < told.end(); t += 0.1) {
    farthest = std::max(farthest, told.tilt(t));
  }
  EXPECT_GT(farthest, std::numbers::pi - 0.1);
  EXPECT_LT(told.tilt(told.end()), 0.2);
}

// As the scene explorer-1; see docs/theory.md, "A wheel and energy loss".
TEST(Explain, ExplorerTumbledAboutTheAxisOfItsGreatestMoment) {
  const Scene film = load_scene("explain");
  const Shot& launched = shot_with(film, "about its easiest axis");
  const Shot& tumbling = shot_with(film, "ended about its hardest axis");
  const Shot& now = shot_with(film, "about the hardest from the start");
  EXPECT_EQ(launched.start, 0);
  EXPECT_EQ(launched.scene.motion.omega, tumbling.scene.motion.omega);
  const motion::FreeBody satellite = free_body(tumbling.scene);
  const motion::Tilt tilt(satellite);
  EXPECT_EQ(tilt.axis(), body::PrincipalAxes::least);
  EXPECT_EQ(now.start, tumbling.time_of(*tumbling.scene.length));
  const std::vector<motion::Sample> samples =
      motion::integrate(satellite, motion::find_method("taylor"), {},
                        std::array{0.0, tumbling.start})
          .samples;
  EXPECT_LT(tilt.of(samples[0]), 0.05);
  EXPECT_GT(tilt.of(samples[1]), 1.5);
  const double least_energy =
      satellite.momentum().squaredNorm() / (2 * satellite.principal().moments[2]);
  EXPECT_NEAR(motion::energy(satellite.inertia(), samples[1].omega) / least_energy, 1, 0.05);
  EXPECT_GT(motion::energy(satellite.inertia(), samples[0].omega), 2 * least_energy) << "lost";
}

TEST(Explain, EndsWithTheCommandThatMakesIt) {
  for (const char* name : {"explain", "explain-nb", "explain-short"}) {
    const std::string command = load_scene(name).shots.back().scene.caption.value_or("");
    EXPECT_EQ(command.find("twrench render explain"), 0u) << name;
  }
}

// So that it can be played in a loop.
TEST(Explain, TheLastFrameOfTheShortFilmContinuesIntoTheFirst) {
  const Scene film = load_scene("explain-short");
  const Shot &first = film.shots.front(), &last = film.shots.back();
  EXPECT_EQ(last.scene.motion.omega, first.scene.motion.omega);
  EXPECT_EQ(last.scene.camera.azimuth, first.scene.camera.azimuth);
  EXPECT_NEAR(last.time_of(*last.scene.length), first.start, 1e-9);
}

}  // namespace
}  // namespace twrench::scene
