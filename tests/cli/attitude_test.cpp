// Commands on a motion whose initial attitude is not the identity.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "cli/samples.h"
#include "cli/twrench.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using nlohmann::json;
using testing::HasSubstr;

/// An eighth of a turn about y, then a third of a turn about the diagonal.
const std::string tilted = "0.270598050073,0.653281482438,0.653281482438,0.270598050073";

Matrix3d rotation() {
  return Eigen::Quaterniond(0.270598050073, 0.653281482438, 0.653281482438, 0.270598050073)
      .normalized()
      .toRotationMatrix();
}

const std::string three_times = "--times 0,1,7.5 ";

TEST(Attitude, TurnsTheMotionInSpace) {
  const ScratchFolder folder;
  for (const std::string scene : {"dzhanibekov", "stable-z", "phone", "sphere"}) {
    for (const std::string method : {"exact", "rk4", "rkmk45", "euler"}) {
      const std::string options = scene + " --method " + method;
      const json plain = samples(folder, three_times + options);
      const json turned = samples(folder, three_times + options + " --attitude " + tilted);
      for (std::size_t i = 0; i < plain.size(); ++i) {
        const Matrix3d expected = rotation() * matrix_of(plain[i]["X"]);
        EXPECT_LT((matrix_of(turned[i]["X"]) - expected).norm(), 1e-9) << options;
        EXPECT_NEAR(turned[i]["energy_drift"], plain[i]["energy_drift"], 1e-9) << options;
      }
    }
  }
}

TEST(Attitude, OfASceneFileIsThatOfTheOption) {
  const ScratchFolder folder;
  const std::string body = "[body]\nmoments = [1, 2, 3]\n[motion]\nomega = [0.1, 1, 0.2]\n";
  std::ofstream(folder / "plain.toml") << body;
  std::ofstream(folder / "turned.toml") << body << "attitude = [" << tilted << "]\n";
  EXPECT_EQ(samples(folder, three_times + "turned.toml"),
            samples(folder, three_times + "plain.toml --attitude " + tilted));
  EXPECT_EQ(samples(folder, three_times + "turned.toml --attitude 1,0,0,0"),
            samples(folder, three_times + "plain.toml"));
}

TEST(Attitude, IsInFramesAndTheirManifest) {
  const ScratchFolder folder;
  const std::string film = "render stable-y --size 64x48 --frames 0 --no-video --progress none ";
  ASSERT_EQ(run_twrench(folder, film + "--frames-dir plain").code, 0);
  ASSERT_EQ(run_twrench(folder, film + "--frames-dir turned --attitude " + tilted).code, 0);
  const json manifest = json::parse(text_of(folder / "turned/manifest.json"));
  EXPECT_LT((matrix_of(manifest["frames"][0]["X"]) - rotation()).norm(), 1e-9);
  EXPECT_TRUE(manifest["scene"]["motion"].contains("attitude"));
  EXPECT_NE(text_of(folder / "plain/frame_000000.png"),
            text_of(folder / "turned/frame_000000.png"));
}

TEST(Attitude, IsInExports) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "export stable-y --attitude " + tilted + " -o a.aem").code, 0);
  const std::string aem = text_of(folder / "a.aem");
  const std::size_t data = aem.find("DATA_START\n") + 11;
  EXPECT_THAT(aem.substr(data, aem.find('\n', data) - data), HasSubstr(" 0.653281482438"));
}

TEST(Attitude, ChangesNoErrorOfAStudy) {
  const ScratchFolder folder;
  const std::string study = "study --methods rk4 --steps 0.05 --duration 5 --format json ";
  const json plain = json::parse(run_twrench(folder, study).out);
  const Outcome turned = run_twrench(folder, study + "--attitude " + tilted);
  ASSERT_EQ(turned.code, 0) << turned.err;
  const auto error = [](const json& found) -> double {
    return found["methods"][0]["runs"][0]["error"];
  };
  EXPECT_NEAR(error(json::parse(turned.out)), error(plain), 1e-9);
}

TEST(Attitude, IsAMotionThatACheckFollows) {
  const ScratchFolder folder;
  std::ofstream(folder / "s.toml")
      << "[body]\nmoments = [1, 2, 3]\n[motion]\nomega = [0.1, 1, 0.2]\n"
         "attitude = ["
      << tilted << "]\nmethod = \"exact\"\n";
  ASSERT_EQ(run_twrench(folder, "simulate s.toml --duration 10 --fps 5 -o run.csv").code, 0);
  EXPECT_EQ(run_twrench(folder, "check run.csv --scene s.toml").code, 0);
}

TEST(Attitude, MustBeAQuaternion) {
  const ScratchFolder folder;
  for (const auto& [value, message] :
       {std::pair("1,0,0", "has 3 numbers"), std::pair("2,0,0,0", "has the length 2"),
        std::pair("0,0,0,0", "has the length 0"), std::pair("1,0,0,x", "x")}) {
    const Outcome run = run_twrench(folder, std::string("simulate --attitude ") + value);
    EXPECT_EQ(run.code, 2) << value;
    EXPECT_THAT(run.err, HasSubstr("--attitude")) << value;
    EXPECT_THAT(run.err, HasSubstr(message));
  }
  std::ofstream(folder / "s.toml")
      << "[body]\nmoments = [1, 2, 3]\n[motion]\nattitude = [1, 0, 0]\n";
  const Outcome run = run_twrench(folder, "simulate s.toml");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("s.toml:4: motion.attitude"));
}

}  // namespace
}  // namespace twrench
