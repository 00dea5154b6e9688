// Scenes whose body contains a wheel or loses energy.
#include "scene/interior.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/motion/trajectory.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/natural_times.h"
#include "scene/scene.h"
#include "scene/scene_json.h"
#include "scene/scene_values.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

const std::string spinning = "[body]\nmoments = [3, 4, 5]\n[motion]\nomega = [0.1, 1, 0.2]\n";

Scene scene_with(const std::string& motion) { return parse_scene(spinning + motion, "s.toml"); }

TEST(InteriorOfAScene, IsThatOfItsBody) {
  const Scene scene = scene_with("wheel = [1, 2, 3]\nenergy_loss_time = 40\n");
  const motion::FreeBody body = free_body(scene);
  EXPECT_EQ(body.interior().wheel, Vector3d(1, 2, 3));
  EXPECT_EQ(body.interior().energy_loss_time, 40);
  EXPECT_EQ(body.body_momentum(), Vector3d(0.1 * 3 + 1, 4 + 2, 0.2 * 5 + 3));
  EXPECT_FALSE(scene.motion.is_rigid());
  const nlohmann::ordered_json json = scene_json(scene)["motion"];
  EXPECT_EQ(json["wheel"], nlohmann::ordered_json({1.0, 2.0, 3.0}));
  EXPECT_EQ(json["energy_loss_time"], 40);
}

TEST(InteriorOfAScene, IsNoneIfTheWheelIsZeroAndTheTimeInfinite) {
  const Scene scene = scene_with("wheel = [0, 0, 0]\nenergy_loss_time = inf\n");
  EXPECT_TRUE(scene.motion.is_rigid());
  EXPECT_TRUE(free_body(scene).is_rigid());
  EXPECT_EQ(scene_json(scene), scene_json(scene_with("")));
}

/// The closed form that the author of a rigid scene chose is replaced, but not one that is chosen
/// together with the wheel.
TEST(InteriorOfAScene, ReplacesTheClosedFormByTaylor) {
  for (const char* key : {"wheel", "energy_loss_time"}) {
    Scene scene = scene_with("method = \"exact\"");
    const nlohmann::ordered_json value =
        std::string(key) == "wheel" ? nlohmann::ordered_json{1, 0, 0} : nlohmann::ordered_json(50);
    set_value(scene, key, value);
    EXPECT_EQ(scene.motion.method, "taylor") << key;
    Scene other = scene_with("method = \"rk4\"");
    set_value(other, key, value);
    EXPECT_EQ(other.motion.method, "rk4") << key;
  }
  EXPECT_EQ(scene_with("method = \"exact\"\nwheel = [1, 0, 0]").motion.method, "exact");
}

TEST(InteriorOfAScene, IsCheckedWhenTheMotionOrTheBodyChanges) {
  Scene scene = scene_with("energy_loss_time = 40\n");
  const auto expect_refused = [&](auto change) {
    const nlohmann::ordered_json before = scene_json(scene);
    try {
      change();
      ADD_FAILURE();
    } catch (const InvalidArgument& refused) {
      EXPECT_EQ(refused.quantity(), "energy_loss_time");
    }
    EXPECT_EQ(scene_json(scene), before);
  };
  expect_refused([&] { set_value(scene, "omega", {0, 0, 1e-6}); });
  expect_refused([&] { set_value(scene, "energy_loss_time", 0.1); });
  expect_refused([&] { set_value(scene, "energy_loss_time", 0); });
  EXPECT_TRUE(limits::energy_loss_time.describe().ends_with(", or inf"));
  expect_refused([&] {
    Body ball;
    ball.inertia = Eigen::Matrix3d::Identity();
    set_body(scene, ball);
  });
  expect_refused([&] { set_value(scene, "compare_omega", {{0, 0, 1}, {0, 0, 1e-6}}); });
}

TEST(InteriorOfAScene, MakesAnotherMotionOfAShot) {
  const std::string shots =
      "[[shot]]\nlength = 2\n[[shot]]\nlength = 3\n[shot.motion]\nwheel = [0, 0, 1]\n"
      "[[shot]]\nlength = 4\n[shot.motion]\nenergy_loss_time = 50\n[[shot]]\nlength = 5\n";
  const Scene film = scene_with("[film]\nspeed = 1\n" + shots);
  ASSERT_EQ(film.shots.size(), 4U);
  EXPECT_EQ(film.shots[1].start, 0);
  EXPECT_EQ(film.shots[2].start, 0);
  EXPECT_EQ(film.shots[3].start, 2);  // continues the first
}

TEST(InteriorOfAScene, IsNotThatOfARigidBody) {
  EXPECT_NO_THROW(require_rigid(scene_with(""), "a report"));
  const auto refused = [](const std::string& toml) {
    try {
      require_rigid(scene_with(toml), "a report");
      return std::string("nothing");
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(refused("wheel = [0, 0, 1]"), HasSubstr("wheel: a report needs"));
  EXPECT_THAT(refused("energy_loss_time = 50"), HasSubstr("energy_loss_time: a report needs"));
  EXPECT_EQ(refused("[[shot]]\nlength = 2\n[shot.motion]\nwheel = [0, 0, 1]"), "nothing")
      << "shots are of films only";
}

/// No method refuses the natural step of a needle as longer than a turn.
TEST(InteriorOfAScene, HasStepsThatEveryMethodTakes) {
  for (const double least : {1e-3, 1e-6, 1e-9}) {
    const motion::FreeBody body(Vector3d(least, 1, 1.2).asDiagonal(), {0, 0.1, 1},
                                Eigen::Matrix3d::Identity(), {.wheel = {0.1, 2, 3}});
    const double step = natural_times(body).step;
    for (const motion::Method& method : motion::methods()) {
      if (method.exact()) continue;
      const std::vector<double> times{step};
      EXPECT_NO_THROW(motion::integrate(body, method, {.step = step}, times))
          << method.name << " " << least;
    }
  }
}

TEST(InteriorOfAScene, HasAFilmWithoutWhatOnlyARigidBodyHas) {
  const auto refused = [](const std::string& toml) {
    try {
      check_shown_motion(scene_with(toml));
      return std::string("nothing");
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
  };
  const std::string wheel = "wheel = [0, 0, 1]\n", loss = "energy_loss_time = 50\n";
  const std::string all =
      "[overlay]\nshow = ['floor', 'axes', 'momentum', 'omega', 'trail', 'labels', 'hud', "
      "'components', 'curve', 'method', 'sphere', 'tilt'";
  EXPECT_EQ(refused(wheel + loss + all + "]"), "nothing");
  EXPECT_EQ(refused(wheel + all + ", 'drift']"), "nothing");
  EXPECT_THAT(refused(loss + all + ", 'drift']"), HasSubstr("show: drift can"));
  for (const std::string feature :
       {"plane", "poinsot", "phase", "forces", "torques", "tip", "moments"}) {
    EXPECT_THAT(refused(wheel + all + ", '" + feature + "']"), HasSubstr("show: " + feature));
    EXPECT_EQ(refused(all + ", '" + feature + "']"), "nothing");
  }
  EXPECT_EQ(refused(loss + "[overlay]\nview = 'momentum'"), "nothing");
  for (const std::string view : {"poinsot", "quad"}) {
    EXPECT_THAT(refused(loss + "[overlay]\nview = '" + view + "'"), HasSubstr("view: " + view));
  }
}

/// omega stays below the bound, and for a body that loses its energy slowly the bound is not far.
TEST(InteriorOfAScene, TurnsNoFasterThanTheBound) {
  for (const std::string interior : {"wheel = [0.4, 1, -0.7]\n", "energy_loss_time = 9\n",
                                     "wheel = [3, 0, 1]\nenergy_loss_time = 30\n"}) {
    const motion::FreeBody body = free_body(scene_with(interior));
    const double bound = fastest_rate(body);
    std::vector<double> times;
    for (int i = 0; i < 500; ++i) times.push_back(0.2 * i);
    double fastest = 0;
    for (const motion::Sample& sample :
         motion::integrate(body, motion::find_method("taylor"), {}, times).samples) {
      fastest = std::max(fastest, sample.omega.norm());
    }
    EXPECT_LE(fastest, bound) << interior;
    EXPECT_GE(fastest, bound / 2) << interior;
  }
}

/// A step resolves the nutation that the wheel causes in a body that hardly turns.
TEST(InteriorOfAScene, HasStepsThatResolveItsMotion) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    const auto times = [&](double spin, double wheel) {
      return natural_times(motion::FreeBody(Vector3d(3, 4, 5).asDiagonal(), {0, 0, spin / scale},
                                            Eigen::Matrix3d::Identity(),
                                            {.wheel = {wheel / scale, 0, 0}}));
    };
    EXPECT_DOUBLE_EQ(times(1, 0.1).step, 0.01 * scale);
    EXPECT_DOUBLE_EQ(times(1e-6, 100 * std::sqrt(12)).step, 1e-4 * scale);
  }
}

}  // namespace
}  // namespace twrench::scene
