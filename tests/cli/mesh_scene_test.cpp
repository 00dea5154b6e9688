// A mesh as SCENE, in every command.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/twrench.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class MeshAsScene : public testing::Test {
 protected:
  MeshAsScene() {
    write("box.obj", box);
    for (const char* name : {"tetrahedron.glb", "tetrahedron.gltf", "binary.stl", "little.ply",
                             "tetrahedron.dae", "tetrahedron.3mf"}) {
      const fs::path corpus = TWRENCH_TESTS_DIR "/fuzz/corpus/mesh";
      write(name, text_of(corpus / name).substr(1));  // a byte for the fuzzer precedes the file
    }
  }

  void write(const std::string& name, const std::string& text) {
    system::write_file_atomically(folder_ / name, text);
  }

  Outcome run(const std::string& arguments) { return run_twrench(folder_, arguments); }

  /// A box of 2 x 3 x 4.
  const std::string box =
      "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n"
      "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const std::string draw = "--size 64x36 --frames 0-1 --progress none --no-video --frames-dir ";
  ScratchFolder folder_;
};

TEST_F(MeshAsScene, IsTakenByEveryCommand) {
  for (const std::string& command :
       {"render box.obj --unit cm " + draw + "f",
        std::string("simulate box.obj --unit mm -o run.csv"),
        std::string("export box.obj --unit km -o box.aem"),
        std::string("export box.obj --scale 3 -o box.glb"),
        std::string("plot box.obj dzhanibekov --unit inch -o plot.svg"),
        std::string("inertia box.obj --unit m --density 3"),
        std::string("study box.obj --unit cm --mass 5 --methods rk4 --duration 1"),
        std::string("report box.obj --unit cm --shell 0.1 --static --duration 5 -o report.html"),
        std::string("check run.csv --scene box.obj --no-fail")}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << command << '\n' << outcome.err;
    EXPECT_EQ(outcome.err, "") << command;
  }
  EXPECT_THAT(text_of(folder_ / "report.html"), HasSubstr("box.obj --unit cm --shell 0.1"));
}

TEST_F(MeshAsScene, MayHaveAnyFormat) {
  for (const std::string mesh :
       {"tetrahedron.glb", "tetrahedron.gltf", "tetrahedron.dae", "tetrahedron.3mf",
        "binary.stl --unit mm", "little.ply --unit km", "box.obj --unit m"}) {
    const Outcome outcome = run("render " + mesh + ' ' + draw + "f --overwrite");
    EXPECT_EQ(outcome.code, 0) << mesh << '\n' << outcome.err;
  }
}

TEST_F(MeshAsScene, IsNamedAfterItsFile) {
  fs::rename(folder_ / "box.obj", folder_ / "my\nown box.obj");
  const Outcome outcome =
      run("render 'my\nown box.obj' --unit cm --size 64x36 --frames 0-1 --progress none");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/my\nown box.mp4"));
  const json scene = json::parse(text_of(folder_ / "out/my\nown box/manifest.json"))["scene"];
  EXPECT_EQ(scene["title"], "my own box");
  EXPECT_EQ(scene["part"][0]["file"], "my\nown box.obj");
  EXPECT_EQ(scene["part"][0]["scale"], 1);
}

TEST_F(MeshAsScene, HasOptionsThatReplaceItsMotion) {
  const Outcome outcome =
      run("simulate box.obj --unit cm --omega 0,0,2 --method exact --times 1 --format json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["samples"][0]["omega"], json({0, 0, 2}));
  const auto duration = [&](const std::string& options, const std::string& frames) {
    EXPECT_EQ(run("render box.obj --unit cm " + options + draw + frames).code, 0);
    const json manifest = json::parse(text_of(folder_ / (frames + "/manifest.json")));
    return manifest["scene"]["motion"]["duration"].get<double>();
  };
  EXPECT_NEAR(duration("--omega 0,2,0.1 ", "fast"), duration("", "usual") / 2, 1);
  EXPECT_EQ(duration("--omega 0,2,0.1 --duration 7 ", "given"), 7);
}

TEST_F(MeshAsScene, ThatIsBadIsOneClearLine) {
  write("empty.obj", "");
  write("broken.obj", "v 0 0\n");
  write("open.stl",
        "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\nendsolid x\n");
  write("cut.glb", text_of(folder_ / "tetrahedron.glb").substr(0, 40));
  fs::create_directory(folder_ / "folder.obj");
  for (const auto& [arguments, code, message, remedy] : {
           std::tuple("box.obj", 2, "box.obj: its unit is not known", "add --unit mm, cm, m, inch"),
           {"box.obj --unit cm --scale 2", 2, "--scale: --unit gives it already", ""},
           {"missing.ply --unit cm", 5, "cannot read missing.ply: No such file", "check the name"},
           {"empty.obj --unit cm", 5, "cannot read empty.obj: it is empty", ""},
           {"broken.obj --unit cm", 5, "broken.obj:1: a number is missing", ""},
           {"open.stl --unit cm", 2, "open.stl: the surface is open", "--shell T"},
           {"cut.glb", 5, "cut.glb", ""},
           {"folder.obj --unit cm", 5, "folder.obj", ""},
           {"box.obj --unit km --mass 1", 2, "--mass: is 1 g, which makes the density", ""},
           {"box.obj --scale 1e12", 2, "box.obj", ""},
           {"dzhanibekov --unit cm", 2, "--unit: is for a mesh", ".obj, .stl"},
       }) {
    for (const char* command : {"render --no-video --frames-dir f ", "simulate "}) {
      const Outcome outcome = run(std::string(command) + arguments);
      EXPECT_EQ(outcome.code, code) << command << arguments << outcome.err;
      EXPECT_EQ(outcome.out, "") << arguments;
      EXPECT_THAT(outcome.err,
                  AllOf(StartsWith("twrench: error: "), HasSubstr(message), HasSubstr(remedy)));
      EXPECT_LE(std::ranges::count(outcome.err, '\n'), 2) << outcome.err;
    }
  }
  EXPECT_FALSE(fs::exists(folder_ / "f"));
}

TEST_F(MeshAsScene, IsNoOutput) {
  for (const char* command :
       {"render box.obj --unit cm --container mp4 -o box.obj --overwrite",
        "simulate box.obj --unit cm -o ./box.obj",
        "export box.obj --unit cm --format glb -o box.obj", "inertia box.obj --unit cm -o box.obj",
        "study box.obj --unit cm -o box.obj", "check run.csv --scene box.obj -o box.obj"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 2) << command << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("it is an input of this command")) << command;
  }
  EXPECT_EQ(text_of(folder_ / "box.obj"), box);
}

}  // namespace
}  // namespace twrench
