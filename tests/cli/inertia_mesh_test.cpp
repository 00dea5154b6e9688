// `twrench inertia` on the file of a mesh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/twrench.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class InertiaOfAMesh : public testing::Test {
 protected:
  InertiaOfAMesh() {
    write("cube.obj", cube);
    write("open.obj", cube.substr(0, cube.find("f 4")));
    write("over.obj", "f 1 2 9\n" + cube);
    write("toutatis.obj", text_of(TWRENCH_TESTS_DIR "/../assets/meshes/toutatis.obj"));
  }

  void write(const std::string& name, const std::string& text) {
    system::write_file_atomically(folder_ / name, text);
  }

  Outcome inertia(const std::string& arguments) {
    return run_twrench(folder_, "inertia " + arguments);
  }

  json described(const std::string& arguments) {
    const Outcome run = inertia(arguments + " --format json");
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }

  const std::string cube =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  ScratchFolder folder_;
};

TEST_F(InertiaOfAMesh, IsThatOfExactArithmetic) {
  const json found = described("toutatis.obj --unit cm");
  EXPECT_EQ(found["scene"], "toutatis");
  EXPECT_EQ(found["triangles"], 12796);
  EXPECT_EQ(found["open_edges"], 0);
  EXPECT_DOUBLE_EQ(found["volume"].get<double>(), 7.6988168847477665);
  EXPECT_DOUBLE_EQ(found["mass"].get<double>(), 7.6988168847477665) << "of density 1";
  EXPECT_NEAR(found["area"].get<double>(), 22.554, 1e-3);
  const std::array moments{2.861959401240807, 8.623292414962608, 9.129415281983114};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found["principal_moments"][i].get<double>(), moments[i], 1e-14 * moments[2]);
  }
  EXPECT_EQ(found["stability"].size(), 3U);
}

TEST_F(InertiaOfAMesh, HasItsUnitAndItsMass) {
  EXPECT_DOUBLE_EQ(described("cube.obj --unit inch --density 2")["mass"].get<double>(),
                   2 * 2.54 * 2.54 * 2.54);
  EXPECT_DOUBLE_EQ(described("cube.obj --scale 3")["volume"].get<double>(), 27);
  const json massive = described("cube.obj --unit mm --mass 6");
  EXPECT_DOUBLE_EQ(massive["mass"].get<double>(), 6);
  EXPECT_DOUBLE_EQ(massive["inertia"][0][0].get<double>(), 0.01);
  const json wall = described("open.obj --unit cm --shell 0.5 --density 4");
  EXPECT_EQ(wall["open_edges"], 4);
  EXPECT_DOUBLE_EQ(wall["area"].get<double>(), 5);
  EXPECT_DOUBLE_EQ(wall["mass"].get<double>(), 10);
}

TEST_F(InertiaOfAMesh, IsPrintedAsText) {
  const Outcome run = inertia("cube.obj --unit m");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(
      run.out,
      AllOf(HasSubstr("mesh                 cube\n"), HasSubstr("triangles            12\n"),
            HasSubstr("open edges           0\n"), HasSubstr("volume               1000000 cm^3\n"),
            HasSubstr("area                 60000 cm^2\n"),
            HasSubstr("mass                 1000000 g\n")));
  EXPECT_EQ(run.err, "");
}

TEST_F(InertiaOfAMesh, WarnsOfWhatWasChanged) {
  std::string turned = cube;
  for (std::size_t at = 0; (at = turned.find("f ", at)) != std::string::npos; at += 9) {
    std::swap(turned[at + 2], turned[at + 6]);
  }
  write("turned.obj", turned);
  const Outcome run = inertia("turned.obj --unit cm");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "twrench: warning: turned.obj: it was inside out and has been turned over\n");
}

TEST_F(InertiaOfAMesh, ThatIsBadIsOneClearLineWithARemedy) {
  for (const auto& [arguments, code, message, remedy] : {
           std::tuple("cube.obj", 2, "cube.obj: its unit is not known",
                      "add --unit mm, cm, m, inch"),
           {"open.obj --unit mm", 2,
            "open.obj: the surface is open at 4 edges, the first from (0, 0, 0) to (0, 1, 0); the "
            "largest gap is 0.1 cm",
            "close it; or --shell T makes it a wall"},
           {"over.obj --unit mm", 2, "over.obj:1: the face refers to vertex 9", ""},
           {"missing.stl --unit mm", 5, "cannot read missing.stl: No such file", "check the name"},
           {"cube.obj --unit ft", 2, "--unit", "mm"},
           {"cube.obj --unit mm --scale 1", 2, "--scale: --unit gives it already", "leave out"},
           {"cube.obj --unit mm --mass 1 --density 1", 2, "--mass: --density", "leave out"},
           {"cube.obj --scale 0", 2, "--scale: is 0", ""},
           {"cube.obj --scale -1", 2, "--scale: is -1", ""},
           {"cube.obj --unit mm --density 0", 2, "--density: is 0", ""},
           {"cube.obj --unit mm --mass nan", 2, "--mass: is nan", ""},
           {"cube.obj --unit mm --mass 1e300", 2, "--mass: is 1e+300, but must be", ""},
           {"cube.obj --unit mm --mass 1e-320", 2, "--mass: is 1e-320, but must be", ""},
           {"cube.obj --unit mm --mass 5e7", 2, "--mass: is 50000000 g, which makes the", ""},
           {"cube.obj --unit mm --shell 1e300", 2, "--shell: is 1e+300, but must be", ""},
           {"cube.obj --scale 1e300", 2, "--scale: is 1e+300, but must be", ""},
           {"cube.obj --unit mm --weld 1e300", 2, "--weld: is 1e+300, but must be", ""},
           {"cube.obj --unit mm --weld -1", 2, "--weld: is -1", ""},
           {"cube.obj --unit mm --shell 0", 2, "--shell: is 0", ""},
           {"cube.obj --unit mm --inertia 1,2,3", 2, "cube.obj: only the values of a scene", ""},
           {"cube.obj --unit mm -o cube.obj", 2, "cube.obj: it is an input", ""},
           {"dzhanibekov --density 2", 2, "--density: is for a mesh", ".obj, .stl"},
       }) {
    const Outcome run = inertia(arguments);
    EXPECT_EQ(run.code, code) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_THAT(run.err, AllOf(HasSubstr(message), HasSubstr(remedy))) << arguments;
    EXPECT_LE(std::ranges::count(run.err, '\n'), 2) << run.err;
  }
}

// As in radar models of asteroids, the triangles at a pole do not quite meet.
TEST_F(InertiaOfAMesh, OffersTheWeldingThatClosesIt) {
  write("gap.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 3e-7 1\nv 2e-7 1e-7 1\n"
        "f 1 3 2\nf 1 2 4\nf 2 3 5\nf 3 1 6\n");
  const Outcome run = inertia("gap.obj --unit cm");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("open at 6 edges"), HasSubstr("the largest gap is 3e-07 cm"),
                             HasSubstr("--weld 5e-07 closes it; or --shell T")));
  EXPECT_NEAR(described("gap.obj --unit cm --weld 5e-7")["volume"].get<double>(), 1.0 / 6, 1e-6);
}

}  // namespace
}  // namespace twrench
