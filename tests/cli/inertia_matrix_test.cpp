// --inertia with six numbers: the entries of a matrix whose principal axes are not the body's axes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "cli/twrench.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// "Ixx,Iyy,Izz,Ixy,Ixz,Iyz", in the order of MuJoCo's fullinertia.
std::string six_numbers(const Matrix3d& I) {
  return fmt::format("{},{},{},{},{},{}", I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
}

std::string three_numbers(const Vector3d& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); }

/// The inertia matrix of a body with these principal moments, turned by R; exactly symmetric.
Matrix3d turned(const Matrix3d& R, const Vector3d& moments) {
  const Matrix3d product = R * moments.asDiagonal() * R.transpose();
  return (product + product.transpose()) / 2;
}

Matrix3d rotation(double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

class InertiaMatrix : public testing::Test {
 protected:
  Outcome run(const std::string& arguments) const { return run_twrench(folder_, arguments); }

  /// The attitudes at 0, 1 ... 10 s.
  std::vector<Matrix3d> attitudes(const std::string& inertia, const Vector3d& omega) const {
    const Outcome outcome =
        run("simulate --method exact --times 0,1,2,3,4,5,6,7,8,9,10 --format json --inertia " +
            inertia + " --omega=" + three_numbers(omega));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    std::vector<Matrix3d> all;
    const json document = json::parse(outcome.out);
    for (const json& sample : document["samples"]) {
      all.emplace_back();
      for (int i = 0; i < 9; ++i)
        all.back()(i / 3, i % 3) = sample["X"][static_cast<std::size_t>(i)];
    }
    return all;
  }

  const ScratchFolder folder_;
  const std::string body_ =
      "--inertia " + six_numbers(turned(rotation(1.1, {1, -2, 3}), {2, 3, 4}));
};

// The same body in other axes: omega' = R omega, and X' R = R X.
TEST_F(InertiaMatrix, HasTheMotionOfTheSameBodyInOtherAxes) {
  std::mt19937 random(20240611);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto direction = [&] {
    return Vector3d(uniform(random), uniform(random), uniform(random));
  };
  const Vector3d moments(2, 3, 4), omega(0.9, 0.3, 0.4);
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const auto straight = attitudes(three_numbers(scale * moments), omega);
    ASSERT_EQ(straight.size(), 11U);
    const Matrix3d R = rotation(3 * uniform(random), direction());
    const auto other = attitudes(six_numbers(turned(R, scale * moments)), R * omega);
    ASSERT_EQ(other.size(), 11U);
    for (std::size_t i = 0; i < straight.size(); ++i) {
      EXPECT_LT((other[i] * R - R * straight[i]).norm(), 1e-13) << scale << " at " << i << " s";
    }
    EXPECT_GT((straight[10] - Matrix3d::Identity()).norm(), 0.1);
  }
}

TEST_F(InertiaMatrix, ThatIsDiagonalIsTheSameAsThreeMoments) {
  std::ofstream(folder_ / "t.html")
      << "{{title}}{{title}}<!-- twrench:poster --><!-- twrench:scene -->";
  for (const std::string command :
       {"simulate --duration 3", "inertia --format json", "export --duration 3 -o - --format glb",
        "page --template t.html -o -"}) {
    const Outcome three = run(command + " --inertia 5,3,4");
    const Outcome six = run(command + " --inertia 5,3,4,0,0,-0");
    EXPECT_EQ(three.code, 0) << three.err;
    EXPECT_TRUE(six.out == three.out) << command;
    EXPECT_EQ(six.err, three.err);
    EXPECT_FALSE(run(command + " --inertia 5,3,4,0,0,0.1").out == three.out) << command;
  }
}

TEST_F(InertiaMatrix, OfASceneFileIsTheSameAsThatOfTheOption) {
  std::ofstream(folder_ / "own.toml")
      << "[body]\ninertia = [[3, 0.25, -0.1], [0.25, 4, 0.3], [-0.1, 0.3, 5]]\n";
  const std::string six = "--inertia 3,4,5,0.25,-0.1,0.3";
  EXPECT_EQ(run("simulate own.toml --duration 3").out,
            run("simulate " + six + " --omega 1,0.05,0 --duration 3").out);
  const json file = json::parse(run("inertia own.toml --format json").out);
  const json option = json::parse(run("inertia --format json " + six).out);
  EXPECT_EQ(file["inertia"], json::parse("[[3, 0.25, -0.1], [0.25, 4, 0.3], [-0.1, 0.3, 5]]"));
  for (const char* key : {"inertia", "principal_moments", "principal_axes", "stability"}) {
    EXPECT_EQ(file[key], option[key]) << key;
  }
  EXPECT_EQ(option["stability"][1]["axis"], "I2");
}

TEST_F(InertiaMatrix, ThatNoRealBodyHasIsWarnedOf) {
  const Matrix3d R = rotation(0.8, {1, 1, -1});
  const Outcome unreal = run("simulate --times 1 --inertia " + six_numbers(turned(R, {1, 2, 3.1})));
  EXPECT_EQ(unreal.code, 0);
  EXPECT_THAT(unreal.err, HasSubstr("--inertia: moments 1, 2 and 3.1: no real body has them"));
  // A real body: each of its moments of inertia about x, y and z is less than the sum of the other
  // two.
  EXPECT_EQ(run("simulate --times 1 --inertia " + six_numbers(turned(R, {1, 2, 3}))).err, "");
}

TEST_F(InertiaMatrix, IsWhatCheckJudgesBy) {
  ASSERT_EQ(run("simulate --method exact --duration 20 -o a.csv --omega 1,0.4,0.3 " + body_).code,
            0);
  const std::string bound = " --max-attitude-error 1e-6";
  const Outcome same = run("check a.csv " + body_ + bound);
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_EQ(same.err, "");
  EXPECT_EQ(run("check a.csv --inertia 2,3,4" + bound).code, 1);
}

TEST_F(InertiaMatrix, IsInTheReportAndItsCommands) {
  const Outcome report = run("report --static --duration 5 -o a.md " + body_);
  ASSERT_EQ(report.code, 0) << report.err;
  EXPECT_THAT(text_of(folder_ / "a.md"), HasSubstr("twrench inertia dzhanibekov " + body_));
  EXPECT_THAT(text_of(folder_ / "a.md"), HasSubstr("A free rigid body"));
}

TEST_F(InertiaMatrix, IsInTheManifestOfItsFrames) {
  const Outcome render =
      run("render --size 64x36 --frames 0 --no-video --frames-dir f --inertia 3,4,5,0.25,-0.1,0.3");
  ASSERT_EQ(render.code, 0) << render.err;
  const json scene = json::parse(text_of(folder_ / "f/manifest.json"))["scene"];
  EXPECT_EQ(
      scene["body"],
      json::parse(
          R"({"inertia": [[3, 0.25, -0.1], [0.25, 4, 0.3], [-0.1, 0.3, 5]], "shape": "box"})"));
  EXPECT_EQ(scene["title"], "A free rigid body");
}

/// A box of 1 x 2 x 3 cm and 12 g with a corner at the origin.
constexpr const char* box_scene =
    "[[part]]\nshape = \"box\"\nsize = [1, 2, 3]\ndensity = 2\nposition = [0.5, 1, 1.5]\n";

Matrix3d matrix_in(const json& rows) {
  Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = rows[i / 3][i % 3];
  return m;
}

// The moment of a box about an edge of its corner is m (b^2 + c^2) / 3, the product -m a b / 4.
TEST(InertiaAboutAPoint, OfABoxIsThatOfTheFormula) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "box.toml", box_scene);
  Matrix3d corner;
  corner << 12 * 13 / 3.0, -6, -9, -6, 12 * 10 / 3.0, -18, -9, -18, 12 * 5 / 3.0;
  const std::string command = "inertia box.toml --format json --about ";
  const json found = json::parse(run_twrench(folder, command + "0,0,0").out);
  EXPECT_EQ(found["units"]["inertia"], "g cm^2");
  EXPECT_EQ(found["about"]["point"], json({0.0, 0.0, 0.0}));
  EXPECT_LE((matrix_in(found["about"]["inertia"]) - corner).norm(), 1e-13);
  const json centre = json::parse(run_twrench(folder, command + "0.5,1,1.5").out);
  EXPECT_EQ(centre["about"]["inertia"], centre["inertia"]);
  const json si = json::parse(run_twrench(folder, command + "0.01,0,0 --si").out);
  const Matrix3d other = matrix_in(si["about"]["inertia"]) * 1e7;  // the mirrored corner
  EXPECT_LE((other.cwiseAbs() - corner.cwiseAbs()).norm(), 1e-12);
  EXPECT_NEAR(other(0, 1), 6, 1e-12);
}

TEST(InertiaInSi, HasKilogramsAndMetres) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "box.toml", box_scene);
  const json cgs = json::parse(run_twrench(folder, "inertia box.toml --format json").out);
  const json si = json::parse(run_twrench(folder, "inertia box.toml --format json --si").out);
  EXPECT_EQ(si["units"], json({{"mass", "kg"}, {"length", "m"}, {"inertia", "kg m^2"}}));
  EXPECT_DOUBLE_EQ(si["mass"], 0.012);
  EXPECT_DOUBLE_EQ(si["centre_of_mass"][2], 0.015);
  EXPECT_DOUBLE_EQ(si["principal_moments"][0], double(cgs["principal_moments"][0]) * 1e-7);
  EXPECT_EQ(si["stability"][0]["rate"], cgs["stability"][0]["rate"]);
  const std::string text = run_twrench(folder, "inertia box.toml --si --about 1,2,3").out;
  EXPECT_THAT(text, HasSubstr("mass                 0.012 kg\n"));
  EXPECT_THAT(text, HasSubstr("centre of mass, m\n"));
  EXPECT_THAT(text, HasSubstr("inertia about (1, 2, 3) m, body axes, kg m^2\n"));
  EXPECT_THAT(text, Not(HasSubstr("cm")));
}

TEST(InertiaAboutAPoint, NeedsAMassAndAPoint) {
  const ScratchFolder folder;
  const Outcome massless = run_twrench(folder, "inertia --inertia 1,2,3 --about 0,0,0");
  EXPECT_EQ(massless.code, 2);
  EXPECT_THAT(massless.err, HasSubstr("--about: needs the mass"));
  for (const char* point : {"1,2", "1,2,x", "1e13,0,0", "nan,0,0"}) {
    EXPECT_EQ(run_twrench(folder, std::string("inertia --about ") + point).code, 2) << point;
  }
}

}  // namespace
}  // namespace twrench
