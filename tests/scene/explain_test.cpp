// Checks the captions of the film that explains why a body turns over against the dynamics.
#include <gtest/gtest.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/stability.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "scene/reading_speed.h"
#include "scene/scene.h"
#include "scene/scene_json.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;

/// The shot whose caption contains the words, with its motion.
struct Told {
  explicit Told(std::string_view words, std::size_t compared = 0)
      : film(load_scene("explain")),
        shot(*std::ranges::find_if(film.shots,
                                   [&](const Shot& other) {
                                     return other.scene.caption->find(words) != std::string::npos;
                                   })),
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
  /// The angle in rad between the body's x axis and L.
  double tilt(double t) const {
    return std::acos(exact.at(t).X.col(0).dot(body.momentum().normalized()));
  }
  std::vector<double> flips() const {
    std::vector<double> result = exact.flip_times(end());
    std::erase_if(result, [&](double t) { return t < begin(); });
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
    for (auto& part : (*film)["part"]) part.erase("name");
    for (auto& shot : (*film)["shot"]) {
      EXPECT_FALSE(shot["caption"].get<std::string>().empty());
      shot.erase("caption");
    }
  }
  EXPECT_EQ(english, norwegian);
}

TEST(Explain, LastsAMinute) {
  for (const char* name : {"explain", "explain-nb"}) {
    const Scene film = load_scene(name);
    EXPECT_DOUBLE_EQ(film.video_length(), 60) << name;
    EXPECT_EQ(film.frame_count(), 3600) << name;
  }
}

TEST(Explain, SixTurnsAreEachLikeTheLast) {
  const Told told("six turns");
  EXPECT_GE((told.end() - told.begin()) * told.omega.norm(), 6 * 2 * std::numbers::pi);
  for (const double t : told.times()) EXPECT_LT(told.tilt(t), 0.01);
}

TEST(Explain, ItTurnsOverInSlowMotion) {
  const Told told("turns over, all by itself");
  const Told before("six turns");
  EXPECT_EQ(told.begin(), before.end()) << "it goes on";
  ASSERT_EQ(told.flips().size(), 1u);
  const double flip = told.flips()[0];
  double video = 0;  // of the flip, in the shot
  while (told.shot.time_of(video) < flip) video += 0.01;
  EXPECT_LT(told.shot.speed.at(video), 0.3 * before.shot.speed.at(0)) << "slow";
  EXPECT_LT(told.tilt(told.begin()), 0.02);
  EXPECT_GT(told.tilt(told.end()), 0.8 * std::numbers::pi) << "on the other side";
}

TEST(Explain, TwoAxesAreSteadyAndTheMiddleOneIsNot) {
  const Vector3d moments = Told("The middle one is not").properties.moments;
  EXPECT_LT(moments[0], moments[1]);
  EXPECT_LT(moments[1], moments[2]);
  EXPECT_EQ(Vector3d(moments.array().round()), Vector3d(723, 982, 1579));
  for (std::size_t i = 0; i < 3; ++i) {
    const Told told("The middle one is not", i);
    Eigen::Index axis = 0;
    told.omega.maxCoeff(&axis);
    const double moment = told.properties.inertia(axis, axis);
    double farthest = 0;
    for (const double t : told.times()) {
      farthest = std::max(farthest, std::acos(told.exact.at(t).X(axis, axis)));
    }
    if (std::abs(moment - moments[1]) < 1) {
      EXPECT_GT(farthest, 0.9 * std::numbers::pi);
    } else {
      EXPECT_LT(farthest, 0.15) << moment;
    }
  }
}

TEST(Explain, TheMomentumStaysAndTheAngularVelocityMoves) {
  const Told still("never moves"), wandering("moves about L");
  EXPECT_EQ(wandering.begin(), still.end());
  const Vector3d up = wandering.body.momentum();
  double farthest = 0;
  for (const double t : wandering.times()) {
    const motion::Sample sample = wandering.exact.at(t);
    const Vector3d omega = sample.X * sample.omega;
    EXPECT_LT((sample.X * (wandering.body.inertia() * sample.omega) - up).norm(), 1e-9 * up.norm());
    farthest = std::max(farthest, std::acos(omega.normalized().dot(up.normalized())));
  }
  EXPECT_GT(farthest, 0.2);
  EXPECT_EQ(wandering.flips().size(), 1u) << "while it turns over";
}

TEST(Explain, InTheRotatingFrameItOnlyLeans) {
  const Told told("only leans");
  EXPECT_EQ(told.shot.scene.camera.frame, Frame::rotating);
  // Both frames coincide after whole turns, and the camera moves by less than half a turn.
  EXPECT_NEAR(std::remainder(told.begin(), 2 * std::numbers::pi), 0, 1e-9);
  EXPECT_LT(told.shot.time_of(told.shot.move) - told.begin(), std::numbers::pi);
  for (const double t : told.times()) EXPECT_LT(told.tilt(t), 0.15);
}

TEST(Explain, TheTiltDoublesEvery1point9Seconds) {
  const Told told("every 1.9 s");
  const motion::Stability stability =
      motion::stability(told.properties.moments, body::PrincipalAxes::intermediate, 1);
  EXPECT_NEAR(stability.doubling_time(), 1.9, 0.05);
  EXPECT_EQ(told.shot.speed.fastest(), 1) << "the seconds are those of the video";
  for (double t = told.begin(); t + 1.9 <= told.end(); t += 0.1) {
    EXPECT_NEAR(told.tilt(t + 1.9) / told.tilt(t), 2, 0.12) << t;
  }
}

TEST(Explain, TheBarTurnsItBackAndTheLegTurnsItFurther) {
  const Told told("The leg turns it further");
  EXPECT_EQ(told.begin(), Told("every 1.9 s").end()) << "it goes on";
  EXPECT_EQ(told.shot.speed.at(2), 0) << "and stands still";
  // The torque of the centrifugal forces on each part about the axis of the tilt, per tilt and
  // squared rate, is the sum of m (r_x^2 - r_d^2), with d the direction in which x leans.
  const motion::Sample sample = told.exact.at(told.end());
  const Vector3d momentum = sample.X.transpose() * told.body.momentum().normalized();
  const Vector3d lean = -Vector3d(0, momentum.y(), momentum.z()).normalized();
  std::vector<double> torques;
  for (const body::Part& part : visible_parts(told.shot.scene.body)) {
    const body::MassProperties alone = body::mass_properties(std::vector{part});
    // About the body's centre of mass; the second moment is half the trace less the inertia.
    const Vector3d& r = alone.centre_of_mass;
    const Eigen::Matrix3d inertia =
        alone.inertia +
        alone.mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    const Eigen::Matrix3d second = 0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia;
    torques.push_back(second(0, 0) - lean.dot(second * lean));
  }
  EXPECT_LT(torques[0], 0) << "the bar";
  EXPECT_GT(torques[1], 0) << "the leg";
  EXPECT_GT(torques[0] + torques[1], 0) << "the leg is stronger";
}

TEST(Explain, TheMomentumMovesOnOneCurve) {
  const Told told("equal energy");
  const double energy = motion::energy(told.body.inertia(), told.omega);
  for (const double t : told.times()) {
    const Vector3d omega = told.exact.at(t).omega;
    const Vector3d momentum = told.body.inertia() * omega;
    EXPECT_NEAR(momentum.norm() / told.body.momentum().norm(), 1, 1e-12);
    EXPECT_NEAR(motion::energy(told.body.inertia(), omega) / energy, 1, 1e-12);
  }
}

// The two curves that cross are those whose energy is that of a rotation about the middle axis.
TEST(Explain, AtTheMiddleAxisTwoCurvesCross) {
  const Told told("two such curves cross");
  const Vector3d moments = told.properties.moments;
  const auto energy = [&](const Vector3d& momentum) {  // of a point of the sphere, principal axes
    return 0.5 * momentum.cwiseAbs2().cwiseQuotient(moments).sum();
  };
  const double at_axis = energy(Vector3d::UnitY());
  int crossings = 0;
  constexpr int steps = 360;
  const auto above = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / steps;
    return energy(Vector3d(0.01 * std::cos(angle), 1, 0.01 * std::sin(angle)).normalized()) >
           at_axis;
  };
  for (int i = 0; i < steps; ++i) crossings += above(i) != above(i + 1) ? 1 : 0;
  EXPECT_EQ(crossings, 4) << "around the axis: two curves enter and leave";
}

TEST(Explain, CanBeRead) {
  for (const char* name : {"explain", "explain-nb", "explorer-1"}) {
    for (const Shot& shot : load_scene(name).shots) {
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

TEST(Explain, ItStaysUpsideDownAndComesBack) {
  const Told told("the curve leads back");
  const std::vector<double> flips = told.flips();
  ASSERT_EQ(flips.size(), 2u) << "over and back";
  const double middle = (flips[0] + flips[1]) / 2;
  EXPECT_GT(told.tilt(middle), std::numbers::pi - 0.03) << "the same axis, upside down";
  EXPECT_LT(told.tilt(told.end()), 0.25 * std::numbers::pi);
}

}  // namespace
}  // namespace twrench::scene
