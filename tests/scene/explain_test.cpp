// Checks the captions of the film that explains why a body turns over against the dynamics.
#include <gtest/gtest.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/rotating_frame.h>
#include <twrench/motion/stability.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/reading_speed.h"
#include "scene/scene.h"
#include "scene/scene_json.h"
#include "timeline/tip_forces.h"

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
  /// The largest tilt in the shot.
  double largest_tilt() const {
    double largest = 0;
    for (const double t : times()) largest = std::max(largest, tilt(t));
    return largest;
  }
  /// A force on the tip of that axis in two directions across L.
  struct Parts {
    double outwards;  ///< Away from L, as the tip leans.
    double sideways;
  };
  Parts parts(const Vector3d& force, double t) const {
    const Vector3d up = exact.at(t).X.transpose() * body.momentum().normalized();
    const Vector3d tip = timeline::TipForces(body).axis();
    const Vector3d lean = (tip - tip.dot(up) * up).normalized();
    return {lean.dot(force), up.cross(lean).dot(force)};
  }
  timeline::TipForces::Forces tip_forces(double t) const {
    return timeline::TipForces(body).at(exact.at(t));
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
    EXPECT_LE(load_scene(name).video_length(), 103) << name;
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

TEST(Explain, ItTurnsOverUnderTheWordsAndThenSlowly) {
  for (const char* name : {"explain", "explain-short"}) {
    const Told told("turns over. All by itself", 0, name);
    EXPECT_LT(told.tilt(told.begin()), 0.2) << name << ": it still spins calmly";
    EXPECT_GT(told.tilt(told.end()), std::numbers::pi - 0.2) << name << ": a whole flip";
  }
  const Told calm("in a space station"), first("turns over. All by itself"), slow("slowly");
  EXPECT_EQ(first.begin(), calm.end()) << "one take";
  EXPECT_LT(calm.largest_tilt(), 0.2);
  EXPECT_LT(slow.tilt(slow.begin()), 0.2);
  EXPECT_GT(slow.tilt(slow.end()), std::numbers::pi - 0.5) << "the same flip";
  EXPECT_EQ(slow.flips(), first.flips());
  EXPECT_LE(slow.shot.speed.at(1), 0.5 * first.shot.speed.at(1));
}

TEST(Explain, NoForceActsOnIt) {
  const Told told("no force acts on it");
  EXPECT_TRUE(told.shot.scene.motion.is_rigid());
  for (const double t : told.times()) {
    const motion::Sample sample = told.exact.at(t);
    const Vector3d momentum = sample.X * (told.body.inertia() * sample.omega);
    EXPECT_LT((momentum - told.body.momentum()).norm(), 1e-12 * momentum.norm());
  }
}

TEST(Explain, AsksWhichWayItWillPointBeforeItComesBack) {
  const Told slow("slowly"), question("Which way"), back("Back again");
  EXPECT_EQ(question.begin(), slow.end());
  EXPECT_EQ(back.begin(), question.end());
  EXPECT_TRUE(question.flips().empty()) << "the answer comes later";
  ASSERT_EQ(back.flips().size(), 1u);
  EXPECT_LT(back.tilt(back.end()), 0.2);
}

TEST(Explain, ComparesTheAxesInTheOrderOfTheirMoments) {
  double last = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Told told("The moment of inertia", i);
    const double moment = told.properties.inertia(told.axis(), told.axis());
    EXPECT_GT(moment, last);
    last = moment;
  }
}

TEST(Explain, OnlyTheMiddleAxisTurnsOver) {
  for (const auto& [words, name] : {std::pair{"Only the middle one turns over", "explain"},
                                    std::pair{"Only the middle one turns over", "explain-short"}}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Told told(words, i, name);
      EXPECT_NEAR(told.tilt(0) * 180 / std::numbers::pi, 1, 0.01) << name << ": one degree off";
      EXPECT_EQ(told.omega[told.axis()], 1) << name;
      double before = 0;
      for (double t = 0; t <= told.begin(); t += 0.1) before = std::max(before, told.tilt(t));
      EXPECT_LT(before, 0.5) << name << ": not before the words";
      if (i == 1) {
        ASSERT_EQ(told.flips().size(), 1u) << name;
        EXPECT_GT((told.flips()[0] - told.begin()) / told.shot.speed.at(1), 1)
            << name << ": a second after its caption";
        EXPECT_GT(told.tilt(told.end()), 0.9 * std::numbers::pi) << name;
      } else {
        EXPECT_LT(told.largest_tilt(), 0.15) << name;
      }
    }
  }
}

// The camera goes over to the rotating frame without a cut, and says that the body rests when it
// does.
TEST(Explain, TheCameraSpinsUpWithTheBody) {
  for (const auto& [words, name] :
       {std::pair{"Take a cross", "explain"}, std::pair{"a cross", "explain-short"}}) {
    const Told before(words, 0, name), along("spin along", 0, name), rests("it rests", 0, name);
    EXPECT_EQ(before.shot.scene.camera.frame, Frame::space) << name;
    EXPECT_EQ(along.shot.scene.camera.frame, Frame::rotating) << name;
    EXPECT_EQ(along.begin(), before.end()) << name << ": one motion";
    EXPECT_EQ(rests.begin(), along.end()) << name;
    EXPECT_EQ(along.omega, before.omega) << name;
    EXPECT_EQ(along.shot.move, *along.shot.scene.length) << name << ": before it is said to rest";
    EXPECT_EQ(rests.shot.move, 0) << name;
    for (const double t : rests.times()) EXPECT_LT(rests.tilt(t), 1e-9) << name;
  }
}

/// The parts of a body by the names of their groups.
std::map<std::string, std::vector<body::Part>> groups_of(const Body& body) {
  const std::vector<body::Part> parts = visible_parts(body);
  std::map<std::string, std::vector<body::Part>> groups;
  for (const PartGroup& group : part_groups(body)) {
    for (const std::size_t part : group.parts) groups[group.name].push_back(parts[part]);
  }
  return groups;
}

TEST(Explain, TheCrossSpinsAboutTheLineOfItsLightDiscsTheMiddleAxis) {
  const Told told("line of its light discs");
  std::map<std::string, std::vector<body::Part>> groups = groups_of(told.shot.scene.body);
  ASSERT_EQ(groups["heavy discs"].size(), 2u);
  ASSERT_EQ(groups["light discs"].size(), 2u);
  EXPECT_GT(body::mass_properties(groups["heavy discs"]).mass,
            2 * body::mass_properties(groups["light discs"]).mass);
  for (const body::Part& disc : groups["light discs"]) {
    EXPECT_NEAR(std::abs(disc.position.normalized()[told.axis()]), 1, 1e-12);
  }
  EXPECT_EQ(motion::Tilt(told.body).axis(), body::PrincipalAxes::intermediate);
}

TEST(Explain, TheCentrifugalForceIsThereBeforeItActs) {
  const Told told("As on a carousel"), rests("it rests");
  EXPECT_EQ(told.begin(), rests.end());
  EXPECT_EQ(told.shot.scene.overlay.forces, std::set{Force::centrifugal});
  EXPECT_TRUE(told.shot.scene.overlay.shows(Feature::forces));
  for (const auto& [name, parts] : groups_of(told.shot.scene.body)) {
    for (const body::Part& disc : parts) {
      const double from_axis = std::hypot(disc.position.x(), disc.position.z());
      if (name == "heavy discs") {
        EXPECT_GT(from_axis, 1);
      } else if (name == "light discs") {
        EXPECT_LT(from_axis, 1e-9) << "not pulled yet";
      }
    }
  }
}

TEST(Explain, TheLightDiscsArePulledOutwards) {
  const Told told("and are pulled outwards");
  EXPECT_LT(told.tilt(told.begin()), 0.12) << "a small tilt";
  EXPECT_GT(told.tilt(told.end()), 0.7);
  double last = 0;
  for (const double t : told.times()) {
    EXPECT_GT(told.tilt(t), last) << "they leave the axis";
    last = told.tilt(t);
    if (last > 0.7) continue;  // the torques are those of the first order
    std::map<std::string, double> torques = told.torques(t);
    EXPECT_GT(torques["light discs"], -torques["heavy discs"]) << t;
    EXPECT_LE(torques["heavy discs"], 0) << t;
  }
}

TEST(Explain, AboutTheLeastAxisCoriolisBendsTheOutwardMotionIntoACircle) {
  const Told told("About the least axis"), circles("the Coriolis force. So it circles");
  EXPECT_EQ(motion::Tilt(told.body).axis(), body::PrincipalAxes::least);
  EXPECT_EQ(circles.begin(), told.end());
  for (const Told* shot : {&told, &circles}) {
    for (const double t : shot->times()) {
      const auto [centrifugal, coriolis] = shot->tip_forces(t);
      EXPECT_GT(shot->parts(centrifugal, t).outwards, 0) << t;
      EXPECT_LT(shot->parts(centrifugal + coriolis, t).outwards, 0) << "so it stays, " << t;
    }
    EXPECT_LT(shot->largest_tilt(), 0.7);
  }
  // Once around L in the rotating frame.
  double turned = 0;
  Vector3d last = Vector3d::Zero();
  const Vector3d up = told.body.momentum().normalized();
  for (const Told* shot : {&told, &circles}) {
    for (const double t : shot->times()) {
      const Eigen::Matrix3d frame = motion::steady_frame(told.body, t).attitude;
      const Vector3d tip = frame.transpose() * told.exact.at(t).X.col(told.axis());
      const Vector3d lean = (tip - tip.dot(up) * up).normalized();
      if (!last.isZero(0.0)) turned += std::atan2(up.dot(last.cross(lean)), last.dot(lean));
      last = lean;
    }
  }
  EXPECT_GT(std::abs(turned), 1.6 * std::numbers::pi);
}

TEST(Explain, AboutTheMiddleAxisTheHeavyDiscsHoldCoriolis) {
  for (const char* name : {"explain", "explain-short"}) {
    const Told sideways("Coriolis turns", 0, name), held("heavy discs pull", 0, name);
    EXPECT_EQ(motion::Tilt(held.body).axis(), body::PrincipalAxes::intermediate);
    EXPECT_EQ(held.begin(), sideways.end()) << name;
    for (const double t : held.times()) {
      const auto [centrifugal, coriolis] = held.tip_forces(t);
      const double to_the_side = held.parts(coriolis, t).sideways;
      const double back = held.parts(centrifugal, t).sideways;
      EXPECT_GT(std::abs(to_the_side), std::abs(held.parts(coriolis, t).outwards)) << t;
      EXPECT_LT(back * to_the_side, 0) << t;
      EXPECT_NEAR(back / to_the_side, -1, 0.3) << "the two almost cancel, " << t;
      EXPECT_GT(held.parts(centrifugal + coriolis, t).outwards, 0) << t;
    }
    // A lean towards the heavy discs is pulled back, by them.
    double all = 0, heavy = 0;
    for (const auto& [group, parts] : groups_of(held.shot.scene.body)) {
      for (const body::Part& part : parts) {
        for (const auto& [mass, position] : body::equimomental_points(part)) {
          const double back = mass * (std::pow(position.x(), 2) - std::pow(position.y(), 2));
          all += back;
          if (group == "heavy discs") heavy += back;
        }
      }
    }
    EXPECT_GT(all, 0) << name;
    EXPECT_GT(heavy, all) << name;
  }
}

TEST(Explain, WhatIsLeftPointsOutwardsAndTurnsItOver) {
  for (const auto& [words, name] : {std::pair{"What is left points outwards", "explain"},
                                    std::pair{"points outwards", "explain-short"}}) {
    const Told told(words, 0, name), held("heavy discs pull", 0, name);
    EXPECT_EQ(told.begin(), held.end()) << name;
    EXPECT_EQ(told.shot.scene.overlay.forces, std::set{Force::sum}) << name;
    for (const double t : told.times()) {
      if (told.tilt(t) > 0.85) break;  // later on it follows the curve of the whole flip
      const auto [centrifugal, coriolis] = told.tip_forces(t);
      const auto [outwards, sideways] = told.parts(centrifugal + coriolis, t);
      EXPECT_GT(outwards, std::abs(sideways)) << name << t;
    }
    EXPECT_GT(told.tilt(told.end()), 0.5 * std::numbers::pi) << name;
  }
}

TEST(Explain, AboutTheGreatestAxisItIsPulledBackWhicheverWayItTilts) {
  const Told told("About the greatest axis");
  EXPECT_EQ(motion::Tilt(told.body).axis(), body::PrincipalAxes::greatest);
  EXPECT_EQ(told.shot.scene.overlay.forces, std::set{Force::centrifugal});
  for (const double t : told.times()) {
    EXPECT_LT(told.parts(told.tip_forces(t).centrifugal, t).outwards, 0) << t;
  }
  // The torque has the sign of the difference to the moment about the axis of the lean.
  EXPECT_LT(told.properties.moments[1], told.properties.moments[2]);
  EXPECT_LT(told.largest_tilt(), 0.5);
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
  EXPECT_GT(told.tilt(told.end()), 0.9 * std::numbers::pi);
}

TEST(Explain, LMovesAsSeenFromTheBody) {
  const Told told("Seen from the body, L");
  EXPECT_EQ(told.shot.scene.camera.frame, Frame::body);
  EXPECT_TRUE(told.shot.scene.overlay.shows(Feature::momentum));
  EXPECT_LT(told.tilt(told.begin()), 0.5);
  EXPECT_GT(told.tilt(told.end()), std::numbers::pi - 0.5);
}

TEST(Explain, TheMomentumStaysOnASphereAndOnOneCurve) {
  const Told told("one curve on it");
  const double energy = motion::energy(told.body.inertia(), told.omega);
  for (const double t : told.times()) {
    const Vector3d omega = told.exact.at(t).omega;
    const Vector3d momentum = told.body.inertia() * omega;
    EXPECT_NEAR(momentum.norm() / told.body.momentum().norm(), 1, 1e-12);
    EXPECT_NEAR(motion::energy(told.body.inertia(), omega) / energy, 1, 1e-12);
  }
}

TEST(Explain, TheMomentumGoesToTheOtherEndOfTheMiddleAxisAndBack) {
  const Told first("one curve on it"), told("to the other, and back");
  EXPECT_EQ(told.begin(), first.end());
  EXPECT_LT(first.tilt(first.begin()), 0.2);
  EXPECT_GT(std::max(first.largest_tilt(), told.largest_tilt()), std::numbers::pi - 0.1);
  EXPECT_LT(told.tilt(told.end()), 0.2);
}

// As the scene explorer-1; see docs/theory.md, "A wheel and energy loss".
TEST(Explain, ExplorerTumbledAboutTheAxisOfItsGreatestMoment) {
  const Scene film = load_scene("explain");
  const Shot& launched = shot_with(film, "about its least axis");
  const Shot& tipping = shot_with(film, "whips bent and lost energy");
  const Shot& tumbling = shot_with(film, "turned about its greatest axis");
  EXPECT_EQ(launched.start, 0);
  EXPECT_EQ(launched.scene.motion.omega, tumbling.scene.motion.omega);
  const motion::FreeBody satellite = free_body(tumbling.scene);
  const motion::Tilt tilt(satellite);
  EXPECT_EQ(tilt.axis(), body::PrincipalAxes::least);
  const std::vector<motion::Sample> samples =
      motion::integrate(satellite, motion::find_method("taylor"), {},
                        std::array{0.0, tipping.start, tumbling.start})
          .samples;
  EXPECT_LT(tilt.of(samples[0]), 0.05);
  EXPECT_GT(tilt.of(samples[1]), 0.3);
  EXPECT_LT(tilt.of(samples[1]), 1.2);
  EXPECT_GT(tilt.of(samples[2]), 1.5);
  const double least_energy =
      satellite.momentum().squaredNorm() / (2 * satellite.principal().moments[2]);
  const auto energy = [&](std::size_t i) {
    return motion::energy(satellite.inertia(), samples[i].omega);
  };
  EXPECT_LT(energy(1), energy(0)) << "lost";
  EXPECT_GT(energy(0), 2 * least_energy);
  EXPECT_NEAR(energy(2) / least_energy, 1, 0.05);
}

// Of all three bodies of the film, and only about the middle axis, over the first flip.
TEST(Explain, EndsWithTheAnswer) {
  for (const char* name : {"explain", "explain-short"}) {
    const Scene film = load_scene(name);
    const Shot& last = film.shots.back();
    EXPECT_NE(last.scene.caption.value_or("").find("Only about the middle axis"),
              std::string::npos);
    EXPECT_EQ(last.scene.motion.omega, film.shots.front().scene.motion.omega) << name;
    for (const Shot& shot : film.shots) {
      if (!shot.scene.motion.is_rigid()) continue;
      const Vector3d moments = mass_properties(shot.scene.body).moments;
      for (const auto axis : {body::PrincipalAxes::least, body::PrincipalAxes::intermediate,
                              body::PrincipalAxes::greatest}) {
        EXPECT_EQ(motion::stability(moments, axis, 1).kind == motion::Stability::Kind::unstable,
                  axis == body::PrincipalAxes::intermediate)
            << name;
      }
    }
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
