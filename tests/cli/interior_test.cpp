// Commands on a body with a wheel or energy loss.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/samples.h"
#include "cli/twrench.h"
#include "sanitizers.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

std::string list_of(const Vector3d& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); }

/// A motion of tests/reference/constant_momentum.json as a scene file and as options, with the
/// times and the attitudes of its samples.
struct Reference {
  explicit Reference(const json& c) : name(c["name"]) {
    const json& I = c["inertia"];
    const std::string omega = list_of(vector_of(c["omega0"]));
    toml = "[body]\ninertia = " + I.dump() + "\n[motion]\nomega = [" + omega + "]\n";
    options = fmt::format("--inertia {},{},{},{},{},{} --omega={}", I[0][0].get<double>(),
                          I[1][1].get<double>(), I[2][2].get<double>(), I[0][1].get<double>(),
                          I[0][2].get<double>(), I[1][2].get<double>(), omega);
    if (c.contains("rotor")) {
      const std::string wheel = list_of(vector_of(c["rotor"]));
      toml += "wheel = [" + wheel + "]\n";
      options += " --wheel=" + wheel;
    }
    if (c.contains("tau")) {
      toml += "energy_loss_time = " + c["tau"].dump() + "\n";
      options += " --energy-loss-time " + c["tau"].dump();
    }
    for (const json& sample : c["samples"]) {
      times += fmt::format("{}{}", times.empty() ? "" : ",", sample["t"].get<double>());
      Matrix3d& X = attitudes.emplace_back();
      for (int i = 0; i < 9; ++i) {
        X(i / 3, i % 3) = std::stod(sample["X"][i / 3][i % 3].get<std::string>());
      }
    }
  }

  std::string name, toml, options, times;
  std::vector<Matrix3d> attitudes;
};

std::vector<Reference> references() {
  std::ifstream file(TWRENCH_TESTS_DIR "/reference/constant_momentum.json");
  std::vector<Reference> all;
  for (const json& c : json::parse(file)) all.emplace_back(c);
  return all;
}

TEST(Interior, SimulateFollowsTheReference) {
  const ScratchFolder folder;
  const std::vector<Reference> all = references();
  ASSERT_GE(all.size(), 3U);
  for (const Reference& reference : all) {
    std::ofstream(folder / "s.toml") << reference.toml;
    const std::string times = " --times " + reference.times;
    const json tight = samples(folder, "s.toml --method taylor --tolerance 1e-15" + times);
    ASSERT_EQ(tight.size(), reference.attitudes.size());
    for (std::size_t i = 0; i < tight.size(); ++i) {
      EXPECT_LE((matrix_of(tight[i]["X"]) - reference.attitudes[i]).norm(), 1e-12)
          << reference.name;
    }
    EXPECT_EQ(samples(folder, reference.options + times), samples(folder, "s.toml" + times));
  }
}

TEST(Interior, OptionsReplaceTheValuesOfTheScene) {
  const ScratchFolder folder;
  std::ofstream(folder / "s.toml") << "[body]\nmoments = [3, 4, 5]\n[motion]\nomega = [1, 0.1, 0]\n"
                                      "wheel = [0, 0, 1]\nenergy_loss_time = 30\n";
  std::ofstream(folder / "r.toml")
      << "[body]\nmoments = [3, 4, 5]\n[motion]\nomega = [1, 0.1, 0]\n";
  const std::string times = " --times 0,5 --step 0.01 --method rk4";
  EXPECT_EQ(samples(folder, "s.toml --wheel 0,0,0 --energy-loss-time inf" + times),
            samples(folder, "r.toml" + times));
}

struct Rows {
  std::vector<Vector3d> omega;
  std::vector<double> energy, momentum_error;
};

Rows rows_of(const json& samples) {
  Rows rows;
  for (const json& sample : samples) {
    rows.omega.push_back(vector_of(sample["omega"]));
    rows.energy.push_back(sample["energy"]);
    rows.momentum_error.push_back(sample["momentum_error"]);
  }
  return rows;
}

/// Bodies of the shape of a phone, from a millionth to a million times its size. The wheel and the
/// energy loss scale with them.
TEST(Interior, KeepsTheMomentumOfABodyOfAnySize) {
  const ScratchFolder folder;
  const Vector3d moments(0.1, 0.4, 0.48), wheel(0.03, -0.02, 0.05);
  for (const double size : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const double unit = std::pow(size, 5);
    const std::string words = fmt::format(
        "--inertia {} --omega 0.02,1,0.01 --wheel={} --duration 60 --fps 2 --step 0.01 ",
        list_of(unit * moments), list_of(unit * wheel));
    for (const std::string method : {"rkmk4", "rkmk45", "taylor", "cf4"}) {
      const Rows kept = rows_of(samples(folder, words + "--method " + method));
      const Rows lost =
          rows_of(samples(folder, words + "--energy-loss-time 25 --method " + method));
      ASSERT_EQ(kept.energy.size(), 121U);
      ASSERT_EQ(lost.energy.size(), 121U);
      for (std::size_t i = 0; i < kept.energy.size(); ++i) {
        EXPECT_LE(kept.momentum_error[i], 1e-13) << method << " " << size;
        EXPECT_LE(lost.momentum_error[i], 1e-13) << method << " " << size;
        EXPECT_NEAR(kept.energy[i] / kept.energy[0], 1, 1e-7) << method << " " << size;
        if (i == 0) continue;
        EXPECT_LE(lost.energy[i], lost.energy[i - 1] * (1 + 1e-14)) << method << " " << size;
      }
      EXPECT_LT(lost.energy.back(), 0.95 * lost.energy.front()) << method << " " << size;
    }
  }
}

/// Every built-in body that has a single axis of greatest moment ends in a rotation about it, after
/// the time that follows from the time constant.
TEST(Interior, LosesEnergyUntilItTurnsAboutTheAxisOfGreatestMoment) {
  const ScratchFolder folder;
  for (const std::string scene : {"dzhanibekov", "calm", "stable-y", "tao-disk", "t-handle",
                                  "wing-nut", "tennis-racket", "phone", "book", "hammer"}) {
    const json inertia = json::parse(run_twrench(folder, "inertia --format json " + scene).out);
    const double greatest = inertia["principal_moments"][2];
    Vector3d axis;
    for (int i = 0; i < 3; ++i) axis[i] = inertia["principal_axes"][i][2];
    const Rows rows = rows_of(samples(folder, scene + " --energy-loss-time 20 --times 0,2000"));
    ASSERT_EQ(rows.omega.size(), 2U) << scene;
    const Vector3d end = rows.omega[1];
    EXPECT_GE(std::abs(end.dot(axis)) / end.norm(), 1 - 1e-9) << scene;
    const double least = greatest * end.squaredNorm() / 2;
    EXPECT_NEAR(rows.energy[1] / least, 1, 1e-9) << scene;
    EXPECT_LE(rows.energy[1], rows.energy[0]) << scene;
  }
}

TEST(Interior, HasNaturalTimes) {
  const ScratchFolder folder;
  const auto last = [&](const std::string& words) {
    const Outcome run = run_twrench(folder, "simulate --inertia 3,4,5 --omega 0,0,1 " + words);
    EXPECT_EQ(run.code, 0) << run.err;
    const std::size_t line = run.out.rfind('\n', run.out.size() - 2) + 1;
    return std::stod(run.out.substr(line));
  };
  EXPECT_EQ(last("--energy-loss-time 50"), 250);                      // five time constants
  EXPECT_EQ(last("--energy-loss-time 8"), last("--wheel 0,0,1e-9"));  // 16 turns
}

TEST(Interior, TablesHaveNoDriftOfAnEnergyThatIsLost) {
  const ScratchFolder folder;
  const std::string words = "simulate --times 0,1 ";
  EXPECT_THAT(run_twrench(folder, words + "--wheel 9,0,0").out, HasSubstr(",energy_drift,"));
  for (const std::string format : {"csv", "json"}) {
    const Outcome run = run_twrench(folder, words + "--energy-loss-time 9 --format " + format);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("momentum_error"));
    EXPECT_THAT(run.out, Not(HasSubstr("energy_drift")));
  }
}

TEST(Interior, ExactIsRefusedAndNamesTaylor) {
  const ScratchFolder folder;
  for (const std::string words : {"--wheel 1,0,0", "--energy-loss-time 9"}) {
    const Outcome run = run_twrench(folder, "simulate --method exact " + words);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("method exact: there is no closed form"));
    EXPECT_THAT(run.err, HasSubstr("use the method taylor"));
  }
  // A symmetric body whose wheel turns along its axis has a closed form.
  EXPECT_EQ(run_twrench(folder, "simulate --inertia 2,2,3 --wheel 0,0,1 --method exact").code, 0);
}

TEST(Interior, InertiaPrintsNothingThatAppliesOnlyToARigidBody) {
  const ScratchFolder folder;
  std::ofstream(folder / "s.toml") << "[body]\nmoments = [3, 4, 5]\n[motion]\nwheel = [0, 0, 1]\n";
  const Outcome text = run_twrench(folder, "inertia s.toml");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("principal axes"));
  EXPECT_THAT(text.out, Not(HasSubstr("tilt")));
  EXPECT_THAT(text.out, HasSubstr("rotation about L"));
  EXPECT_THAT(text.out, Not(HasSubstr("2 E T")));
  const json document = json::parse(run_twrench(folder, "inertia s.toml --format json").out);
  EXPECT_FALSE(document.contains("stability"));
  EXPECT_NEAR(
      document["phase"]["total"].get<double>(),
      document["phase"]["dynamic"].get<double>() + document["phase"]["geometric"].get<double>(),
      1e-12);
  std::ofstream(folder / "s.toml", std::ios::app) << "energy_loss_time = 50\n";
  const json lossy = json::parse(run_twrench(folder, "inertia s.toml --format json").out);
  EXPECT_FALSE(lossy.contains("phase"));
}

TEST(Interior, IsPlottedAndExportedWithoutFlips) {
  const ScratchFolder folder;
  const std::string words = " dzhanibekov --wheel 1000,0,0";
  ASSERT_EQ(run_twrench(folder, "plot -o p.svg" + words).code, 0);
  EXPECT_THAT(text_of(folder / "p.svg"), Not(HasSubstr("flips")));
  ASSERT_EQ(run_twrench(folder, "export -o a.csv" + words).code, 0);
  EXPECT_EQ(text_of(folder / "a.csv"), run_twrench(folder, "simulate" + words).out);
  EXPECT_EQ(run_twrench(folder, "export -o a.json" + words).code, 0);
  ASSERT_EQ(run_twrench(folder, "export -o a.aem --duration 20" + words).code, 0);
  const std::string aem = text_of(folder / "a.aem");
  EXPECT_THAT(aem, HasSubstr("of a body with a wheel or energy loss, by the method taylor."));
  const json end = samples(folder, words + " --method taylor --tolerance 1e-15 --times 20").back();
  const std::string line = aem.substr(aem.rfind("T00:00:20"));
  Eigen::Quaterniond q;
  ASSERT_EQ(std::sscanf(line.c_str(), "%*s %lf %lf %lf %lf", &q.x(), &q.y(), &q.z(), &q.w()), 4);
  EXPECT_LE((q.toRotationMatrix() - matrix_of(end["X"])).norm(), 1e-13);
}

TEST(Interior, StudyNamesItsReference) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ScratchFolder folder;
  const std::string words =
      "study --inertia 3,4,5 --omega 0.01,1,0.02 --duration 20 --wheel 0,1,0 ";
  const Outcome text = run_twrench(folder, words);
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("methods compared with taylor at tolerance 1e-15, because"));
  EXPECT_THAT(text.out, Not(HasSubstr("exact:")));
  for (const auto& [loss, flips] :
       {std::pair("", "of taylor: "), std::pair("--energy-loss-time 30", "not counted")}) {
    EXPECT_THAT(run_twrench(folder, words + "--methods rk4 " + loss).out, HasSubstr(flips));
  }
  const Outcome exact = run_twrench(folder, words + "--methods rk4,exact");
  EXPECT_EQ(exact.code, 2);
  EXPECT_THAT(exact.err, HasSubstr("method exact: there is no closed form"));
  const json document = json::parse(run_twrench(folder, words + "--methods rk4 --format json").out);
  EXPECT_EQ(document["reference"], "taylor");
  EXPECT_EQ(run_twrench(folder, words + "--max-error 1e-12 --methods rk4 --steps 0.5").code, 1);
  EXPECT_EQ(run_twrench(folder, words + "--energy-loss-time 30 --plot p.svg").code, 0);
  // A symmetric body with its wheel along the axis has a closed form.
  EXPECT_THAT(run_twrench(folder, "study --inertia 2,2,3 --wheel 0,0,1 --duration 9").out,
              HasSubstr("methods compared with the exact solution"));
}

TEST(Interior, IsRefusedInOneLineByCheck) {
  const ScratchFolder folder;
  std::ofstream(folder / "wheel.toml")
      << "[body]\nmoments = [3, 4, 5]\n[motion]\nwheel = [0, 0, 1]\n";
  std::ofstream(folder / "loss.toml")
      << "[body]\nmoments = [3, 4, 5]\n[motion]\nenergy_loss_time = 50\n";
  std::ofstream(folder / "run.csv") << "t,wx,wy,wz\n0,1,0,0\n1,1,0,0\n";
  for (const auto& [scene, key] :
       {std::pair("wheel.toml", "wheel"), std::pair("loss.toml", "energy_loss_time")}) {
    const Outcome run = run_twrench(folder, std::string("check run.csv --scene ") + scene);
    EXPECT_EQ(run.code, 2) << scene << "\n" << run.err;
    EXPECT_EQ(run.err,
              fmt::format("twrench: error: {}: a check needs the closed form of a rigid body's "
                          "motion\n  use a rigid body; simulate computes the motion of any body\n",
                          key));
    EXPECT_EQ(run.out, "");
  }
}

// It would need more steps than fit into memory.
TEST(Interior, AWheelOfAnySpeedIsExportedOrRefused) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "export t-handle --wheel 1e12,0,0 -o a.glb");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("method taylor: about "));
  EXPECT_THAT(run.err, HasSubstr("take a shorter --duration"));
  EXPECT_FALSE(exists(folder / "a.glb"));
}

TEST(Interior, ThePhaseNeedsTheSphere) {
  const ScratchFolder folder;
  const std::string film = "render --size 64x48 --frames 0 --no-video --frames-dir f ";
  for (const char* options :
       {"--bare --show phase", "--show phase --hide sphere", "--show phase --view poinsot"}) {
    const Outcome run = run_twrench(folder, film + options);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_THAT(run.err, HasSubstr("show: phase is an area on the momentum sphere, which is not"));
    EXPECT_FALSE(exists(folder / "f")) << options;
  }
}

TEST(Interior, IsShownInPages) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ScratchFolder folder;
  std::ofstream(folder / "t.html")
      << "<!doctype html>\n<meta name=\"generator\" content=\"twrench\">"
         "{{title}}{{title}}<!-- twrench:poster --><!-- twrench:scene -->";
  std::ofstream(folder / "shot.toml") << "[body]\nmoments = [3, 4, 5]\n[[shot]]\nlength = 1\n"
                                         "[shot.motion]\nwheel = [0, 0, 1]\n";
  for (const auto& [words, value] :
       {std::pair("dzhanibekov --wheel 9,0,0", "\"wheel\":[9.0,0.0,0.0]"),
        std::pair("dzhanibekov --energy-loss-time 40", "\"energy_loss_time\":40.0"),
        std::pair("dual-spin", "\"wheel\":[40000000.0,0.0,0.0]"),
        std::pair("t-handle-wheel --wheel 1,0,0", "\"wheel\":[1.0,0.0,0.0]"),
        std::pair("shot.toml", "\"program\"")}) {
    const Outcome run = run_twrench(
        folder, std::string("page --template t.html --size 320x180 -o p.html ") + words);
    EXPECT_EQ(run.code, 0) << words << run.err;
    const std::string page = text_of(folder / "p.html");
    EXPECT_THAT(page, HasSubstr(value)) << words;
    EXPECT_THAT(page, HasSubstr("<img")) << words;
  }
  const Outcome run =
      run_twrench(folder, "page --template t.html -o q.html --energy-loss-time 0.01");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("--energy-loss-time: is 0.01 s, but must be above"));
  EXPECT_FALSE(exists(folder / "q.html"));
}

TEST(Interior, IsDrawnWithoutWhatOnlyARigidBodyHas) {
  const ScratchFolder folder;
  const std::string film =
      "render dzhanibekov --wheel 100,0,0 --energy-loss-time 40 --size 64x48 --progress none "
      "--frames 0,30,200 --no-video --frames-dir f ";
  for (const auto& [options, message] :
       {std::pair("--show drift,forces", "show: drift,forces can be shown only of a rigid body"),
        std::pair("--show poinsot", "show: poinsot can be shown only of a rigid body"),
        std::pair("--view poinsot", "view: poinsot can be shown only of a rigid body"),
        std::pair("--view quad", "view: quad can be shown only of a rigid body")}) {
    const Outcome run = run_twrench(folder, film + options);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_THAT(run.err, HasSubstr(message));
    EXPECT_FALSE(exists(folder / "f")) << options;
  }
  std::ofstream(folder / "shots.toml")
      << "[body]\nmoments = [3, 4, 5]\n[[shot]]\nlength = 1\n"
         "[[shot]]\nlength = 1\n[shot.motion]\n"
         "wheel = [0, 0, 1]\n[shot.overlay]\nshow = [\"forces\"]\n";
  const Outcome shots = run_twrench(folder, "render shots.toml -o f.mp4");
  EXPECT_EQ(shots.code, 2);
  EXPECT_THAT(shots.err, HasSubstr("show: forces can be shown only of a rigid body"));

  for (const std::string options :
       {"--view momentum", "--show tilt", "--compare rk4,rkmk4", "--compare-omega '1,0,0;0,1,0'"}) {
    EXPECT_EQ(run_twrench(folder, film + options + " --overwrite").code, 0) << options;
  }
  ASSERT_EQ(run_twrench(folder, film + "--overwrite").code, 0);
  const json manifest = json::parse(text_of(folder / "f/manifest.json"));
  std::string times;
  for (const json& frame : manifest["frames"]) {
    times += (times.empty() ? "" : ",") + frame["t"].dump();
    EXPECT_EQ(frame["flips"], 0);
  }
  const json expected =
      samples(folder, "dzhanibekov --wheel 100,0,0 --energy-loss-time 40 --times " + times);
  ASSERT_EQ(expected.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE((matrix_of(manifest["frames"][i]["X"]) - matrix_of(expected[i]["X"])).norm(), 1e-12);
  }
  EXPECT_EQ(manifest["scene"]["motion"]["energy_loss_time"], 40);
}

/// A wheel that is too slow to hold the middle axis lets the body turn over at other times. Flips
/// in the plot, in the film and in the report are those of the motion with the wheel.
TEST(Interior, FlipsAreThoseOfTheMotionWithTheWheel) {
  const ScratchFolder folder;
  const std::string words = "t-handle --wheel 500,30,0 --duration 8 ";
  const json study =
      json::parse(run_twrench(folder, "study " + words + "--methods taylor --format json").out);
  const auto& flips = study["methods"][0]["runs"].back()["flips"];
  ASSERT_GE(flips.size(), 2U);
  Vector3d middle;
  const json inertia = json::parse(run_twrench(folder, "inertia --format json t-handle").out);
  for (int i = 0; i < 3; ++i) middle[i] = inertia["principal_axes"][i][1];
  const json moments = inertia["principal_moments"];
  for (const double flip : flips) {
    const std::string times =
        fmt::format("--method taylor --tolerance 1e-15 --times {},{}", flip - 1e-6, flip + 1e-6);
    std::vector<double> component;
    for (const json& sample : samples(folder, words + times)) {
      component.push_back(moments[1].get<double>() * middle.dot(vector_of(sample["omega"])) +
                          middle.dot(Vector3d(500, 30, 0)));
    }
    EXPECT_LT(component.front() * component.back(), 0) << flip;
  }
  const std::string film = "--size 64x48 --fps 1 --speed 1 --frames 0-7 --no-video --frames-dir f";
  ASSERT_EQ(run_twrench(folder, "render " + words + film).code, 0);
  const json manifest = json::parse(text_of(folder / "f/manifest.json"));
  for (const json& frame : manifest["frames"]) {
    const auto before =
        std::ranges::count_if(flips, [&](const json& flip) { return flip <= frame["t"]; });
    EXPECT_EQ(frame["flips"], before) << frame["t"];
  }
  ASSERT_EQ(run_twrench(folder, "plot -o p.svg " + words).code, 0);
  EXPECT_THAT(text_of(folder / "p.svg"), HasSubstr("flips"));
}

TEST(Interior, WheelsAreShownSideBySide) {
  const ScratchFolder folder;
  const std::string film =
      "render dzhanibekov --size 96x48 --progress none --frames 0,600 --no-video --frames-dir f ";
  const std::string wheels = "--compare-wheel '0,0,0;900,0,0' ";
  ASSERT_EQ(run_twrench(folder, film + wheels).code, 0);
  const json frames = json::parse(text_of(folder / "f/manifest.json"))["frames"];
  EXPECT_GT(frames[1]["flips"], 0);  // of the body without a wheel
  const std::pair<const char*, const char*> refused[] = {
      {"--compare rk4,rkmk4", "compare_wheel: cannot be combined with compare"},
      {"--compare-omega 1,0,0", "compare_omega: cannot be combined with compare_wheel"},
      {"--view momentum", "compare_wheel: the view 'momentum' shows only one motion"},
      {"--show forces", "show: forces can be shown only of a rigid body"},
      {"--method exact", "method exact: there is no closed form"}};
  for (const auto& [options, message] : refused) {
    const Outcome run = run_twrench(folder, film + "--overwrite " + wheels + options);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_THAT(run.err, HasSubstr(message));
  }
  for (const char* value : {"1,2", "1e300,0,0", "1,0,0;2,0,0;3,0,0;4,0,0;5,0,0", "x"}) {
    const Outcome run = run_twrench(folder, film + "--compare-wheel '" + value + "'");
    EXPECT_EQ(run.code, 2) << value;
    EXPECT_THAT(run.err, HasSubstr("--compare-wheel: "));
  }
}

/// The middle axis of the T-handle is steady with a little more than the threshold, and not with a
/// little less.
TEST(Interior, InertiaPrintsTheWheelThatStabilisesTheMiddleAxis) {
  const ScratchFolder folder;
  const json unstable =
      json::parse(run_twrench(folder, "inertia t-handle --format json").out)["stability"][1];
  const double wheel = 9 * unstable["stabilizing_wheel"].get<double>();
  EXPECT_THAT(run_twrench(folder, "inertia t-handle").out,
              HasSubstr(fmt::format("a wheel along x with more than {:.4g} g cm^2/s", wheel / 9)));
  for (const auto& [factor, is_steady] : {std::pair(0.97, false), std::pair(1.03, true)}) {
    double least = 9;
    for (const json& sample : samples(
             folder, fmt::format("t-handle --omega 9,1e-3,0 --duration 20 --fps 60 --wheel {},0,0",
                                 factor * wheel))) {
      least = std::min(least, vector_of(sample["omega"])[0]);
    }
    EXPECT_EQ(least > 8.99, is_steady) << factor;
  }
}

TEST(Interior, NamesTheOptionOrThePlaceOfAWrongValue) {
  const ScratchFolder folder;
  for (const auto& [value, message] :
       {std::pair("0", "is 0, but must be"), std::pair("-1", "is -1, but must be"),
        std::pair("nan", "is nan, but must be"), std::pair("-inf", "is -inf, but must be"),
        std::pair("0.6", "is 0.6 s, but must be above 0.61"), std::pair("x", "is not a number")}) {
    const Outcome run = run_twrench(folder, std::string("simulate --energy-loss-time=") + value);
    EXPECT_EQ(run.code, 2) << value;
    EXPECT_THAT(run.err, HasSubstr("error: --energy-loss-time: ")) << value;
    EXPECT_THAT(run.err, HasSubstr(message)) << value;
  }
  for (const char* value : {"1,2", "nan,0,0", "0,inf,0", "1e300,0,0", "0,0,1e-200"}) {
    const Outcome run = run_twrench(folder, std::string("simulate --wheel=") + value);
    EXPECT_EQ(run.code, 2) << value;
    EXPECT_THAT(run.err, HasSubstr("error: --wheel: ")) << value;
  }
  const Outcome ball = run_twrench(folder, "simulate sphere --energy-loss-time 9");
  EXPECT_EQ(ball.code, 2);
  EXPECT_THAT(ball.err, HasSubstr("--energy-loss-time: the body has no single axis of greatest"));

  const std::string body = "[body]\nmoments = [3, 4, 5]\n[motion]\nomega = [0, 0, 1]\n";
  const auto error_of = [&](const std::string& toml, const std::string& options) {
    std::ofstream(folder / "s.toml") << toml;
    const Outcome run = run_twrench(folder, "simulate s.toml " + options);
    EXPECT_EQ(run.code, 2) << toml;
    return run.err;
  };
  EXPECT_THAT(error_of(body + "\nenergy_loss_time = 0.01\n", ""),
              HasSubstr("s.toml:6: motion.energy_loss_time: is 0.01 s, but must be above"));
  EXPECT_THAT(error_of(body + "wheel = [1, 2]\n", ""), HasSubstr("s.toml:5: motion.wheel: "));
  // The omega of the command line makes the time of the file too short.
  EXPECT_THAT(error_of(body + "energy_loss_time = 50\n", "--omega 0,0,1e-5"),
              HasSubstr("error: s: energy_loss_time: is 50 s, but must be above"));
  EXPECT_THAT(error_of(body + "energy_loss_time = 50\n[[shot]]\nlength = 1\n[shot.motion]\n"
                              "omega = [0, 0, 1e-5]\n",
                       ""),
              HasSubstr("s.toml:6: shot[0].motion.energy_loss_time: is 50 s, but must be above"));
}

}  // namespace
}  // namespace twrench
