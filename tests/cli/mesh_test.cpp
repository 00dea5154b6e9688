// Every command accepts bodies that are meshes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/twrench.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// A box of this size in mm, as OBJ.
std::string box(double x, double y, double z) {
  std::string text;
  for (int corner = 0; corner < 8; ++corner) {
    text += fmt::format("v {} {} {}\n", (corner & 1) != 0 ? x : 0, (corner & 2) != 0 ? y : 0,
                        (corner & 4) != 0 ? z : 0);
  }
  return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

class MeshBody : public testing::Test {
 protected:
  MeshBody() {
    write("box.obj", box(40, 20, 10));
    write("mesh.toml",
          "[[part]]\nshape = 'mesh'\nfile = 'box.obj'\nunit = 'mm'\ndensity = 2\nposition = "
          "[-2, -1, -0.5]\n[motion]\nomega = [0.01, 1, 0]\nduration = 96\n");
    write("parts.toml",
          "[[part]]\nshape = 'box'\nsize = [4, 2, 1]\ndensity = 2\n[motion]\nomega = [0.01, 1, "
          "0]\n");
  }

  void write(const std::string& name, const std::string& text) {
    system::write_file_atomically(folder_ / name, text);
  }

  Outcome run(const std::string& arguments) { return run_twrench(folder_, arguments); }

  Outcome render(const std::string& options, const std::string& scene = "mesh.toml") {
    return run("render " + scene +
               " --size 96x64 --fps 2 --speed 12 --progress none --frames-dir f --no-video " +
               options);
  }

  ScratchFolder folder_;
};

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (*end == '\0') numbers.push_back(number);
  }
  return numbers;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 3u);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-11 * (1 + std::abs(b[i])));
}

TEST_F(MeshBody, MovesAsTheSameBodyOfParts) {
  for (const char* command : {"inertia", "simulate --format json --times 0,10,20"}) {
    const Outcome mesh = run(std::string(command) + " mesh.toml");
    const Outcome parts = run(std::string(command) + " parts.toml");
    ASSERT_EQ(mesh.code, 0) << mesh.err;
    const auto plain = [](std::string text) {
      for (char& c : text) {
        if (std::string("[],:\"").find(c) != std::string::npos) c = ' ';
      }
      return text;
    };
    expect_near(numbers_in(plain(mesh.out)), numbers_in(plain(parts.out)));
  }
  const Outcome study = run("study mesh.toml --methods rk4 --duration 5 --steps 0.1,0.05");
  EXPECT_EQ(study.code, 0) << study.err;
}

TEST_F(MeshBody, IsInTheManifestWithItsDigest) {
  ASSERT_EQ(render("--frames 0").code, 0);
  const json part = json::parse(text_of(folder_ / "f/manifest.json"))["scene"]["part"][0];
  EXPECT_EQ(part["file"], "box.obj");
  EXPECT_EQ(part["scale"], 0.1);
  EXPECT_EQ(part["density"], 2);
  const std::string text = text_of(folder_ / "box.obj");
  EXPECT_EQ(part["sha256"],
            system::sha256_hex({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

TEST_F(MeshBody, IsDrawnAnewByResumeAfterItsFileChanged) {
  ASSERT_EQ(render("--frames 0-5").code, 0);
  const auto before = digests(folder_ / "f");
  const auto drawn = fs::last_write_time(folder_ / "f/frame_000003.png");
  ASSERT_EQ(render("--frames 0-5 --resume").code, 0);
  EXPECT_EQ(fs::last_write_time(folder_ / "f/frame_000003.png"), drawn) << "drawn again";

  write("box.obj", box(40, 22, 10));
  const Outcome refused = render("--frames 0-5");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("frames of another scene, mesh, font"));
  EXPECT_EQ(digests(folder_ / "f"), before);

  ASSERT_EQ(render("--frames 0-5 --resume").code, 0);
  for (const auto& [file, digest] : digests(folder_ / "f")) {
    EXPECT_NE(digest, before.at(file)) << file;
  }
  // A comment changes the file, but no pixel.
  const auto redrawn = digests(folder_ / "f");
  write("box.obj", box(40, 22, 10) + "# the end\n");
  EXPECT_EQ(render("--frames 0-5").code, 2);
  ASSERT_EQ(render("--frames 0-5 --resume").code, 0);
  EXPECT_EQ(digests(folder_ / "f"), redrawn);
  // Changing both the mesh and the motion makes another scene.
  write("box.obj", box(40, 20, 10));
  EXPECT_EQ(render("--frames 0-5 --resume --omega 1,0,0.1").code, 2);
}

TEST_F(MeshBody, IsDrawnInShardsAndEncoded) {
  ASSERT_EQ(render("--frames 0-5").code, 0);
  const auto whole = digests(folder_ / "f");
  fs::remove_all(folder_ / "f");
  ASSERT_EQ(render("--frames 0-5 --shard 1/2").code, 0);
  ASSERT_EQ(render("--frames 0-5 --shard 2/2").code, 0);
  EXPECT_EQ(digests(folder_ / "f"), whole);
  EXPECT_EQ(run("encode f -o v.mp4 --progress none").code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "v.mp4"));
  // The mesh file must not change between two shards.
  write("box.obj", box(40, 22, 10));
  EXPECT_EQ(render("--frames 0-5 --shard 2/2 --resume").code, 2);
}

TEST_F(MeshBody, MayBeThatOfAShot) {
  write("story.toml",
        text_of(folder_ / "parts.toml") +
            "[film]\nspeed = 6\n[[shot]]\nlength = 1\n[[shot]]\nlength = 1\n[[shot.part]]\nshape = "
            "'mesh'\nfile = 'box.obj'\nunit = 'mm'\nmass = 3\n");
  const std::string command =
      "render story.toml --size 96x64 --fps 4 --progress none --frames-dir f --no-video ";
  ASSERT_EQ(run(command).code, 0);
  const json scene = json::parse(text_of(folder_ / "f/manifest.json"))["scene"];
  EXPECT_EQ(scene["shot"][1]["part"][0]["file"], "box.obj");
  const auto before = digests(folder_ / "f");
  write("box.obj", box(40, 30, 10));
  ASSERT_EQ(run(command + "--resume").code, 0);
  EXPECT_NE(digests(folder_ / "f"), before);
}

TEST_F(MeshBody, IsAnInputThatNoOutputReplaces) {
  const std::string text = text_of(folder_ / "box.obj");
  fs::create_symlink("box.obj", folder_ / "box.svg");
  for (const char* command :
       {"simulate mesh.toml -o box.obj", "inertia mesh.toml -o ./box.obj",
        "plot mesh.toml -o box.svg", "study mesh.toml -o box.obj", "study mesh.toml --plot box.svg",
        "render mesh.toml --container mp4 -o box.obj --overwrite",
        "export mesh.toml --format oem -o box.obj"}) {
    const Outcome refused = run(command);
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_EQ(text_of(folder_ / "box.obj"), text) << command;
    if (std::string(command).find("export") != std::string::npos) continue;  // has no such option
    EXPECT_THAT(refused.err, HasSubstr("it is an input of this command")) << command;
  }
}

TEST_F(MeshBody, InSeveralFilesIsAnInputThatNoOutputReplaces) {
  const std::array<float, 12> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::string bytes(sizeof corners, '\0');
  std::memcpy(bytes.data(), corners.data(), sizeof corners);
  bytes += std::string("\0\2\1\0\1\3\0\3\2\1\2\3", 12);
  write("a b.bin", bytes);
  write("wedge.gltf", R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "buffers": [{"byteLength": 60, "uri": "a%20b.bin"}]})");
  write("wedge.toml", "[[part]]\nshape = 'mesh'\nfile = 'wedge.gltf'\ndensity = 1\n");
  fs::create_symlink("a b.bin", folder_ / "a.svg");
  ASSERT_EQ(run("inertia wedge.gltf -o out.txt").code, 0);
  for (const char* command : {"inertia wedge.gltf -o 'a b.bin'", "inertia wedge.toml -o 'a b.bin'",
                              "simulate wedge.toml -o './a b.bin'", "plot wedge.toml -o a.svg",
                              "render wedge.toml --container mp4 -o 'a b.bin' --overwrite"}) {
    const Outcome refused = run(command);
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_THAT(refused.err, HasSubstr("it is an input of this command")) << command;
    EXPECT_EQ(text_of(folder_ / "a b.bin"), bytes) << command;
  }
}

TEST_F(MeshBody, ThatIsBadIsReportedInOneLine) {
  write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("short.stl", std::string(90, '\0'));
  struct Bad {
    const char* keys;
    int code;
    const char* message;
  };
  for (const Bad& bad : {
           Bad{"file = 'none.obj'\nunit = 'mm'", 5,
               "bad.toml:3: part[0].file: cannot read none.obj"},
           Bad{"file = '.'\nunit = 'mm'", 5, "bad.toml:3: part[0].file: "},
           Bad{"file = '/dev/zero'\nunit = 'mm'", 5, "bad.toml:3: part[0].file: "},
           Bad{"file = \"a\\u0000b\"\nunit = 'mm'", 2, "bad.toml:3: part[0].file: is not the path"},
           Bad{"file = 'short.stl'\nunit = 'mm'", 5, "bad.toml:3: part[0].file: "},
           Bad{"file = 'open.obj'\nunit = 'mm'", 2, "bad.toml:3: part[0].file: open.obj"},
           Bad{"file = 'box.obj'", 2, "bad.toml:3: part[0].file: box.obj: its unit is not known"},
           Bad{"file = 'box.obj'\nunit = 'ft'", 2, "bad.toml:4: part[0].unit: unknown name 'ft'"},
           Bad{"file = 'box.obj'\nunit = 'mm'\nmass = 1", 2,
               "bad.toml:5: part[0].mass: cannot be combined with density"},
           Bad{"file = 'box.obj'\nunit = 'mm'\nsmooth = 1", 2, "bad.toml:5: part[0]: unknown name"},
       }) {
    write("bad.toml", std::string("[[part]]\nshape = 'mesh'\n") + bad.keys + "\ndensity = 1\n");
    for (const char* command : {"render", "simulate", "inertia"}) {
      const Outcome outcome = run(std::string(command) + " bad.toml");
      EXPECT_EQ(outcome.code, bad.code) << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr(std::string("twrench: error: ") + bad.message));
      EXPECT_LE(std::ranges::count(outcome.err, '\n'), 2) << outcome.err;
      EXPECT_EQ(outcome.out, "");
      EXPECT_FALSE(fs::exists(folder_ / "out"));
    }
  }
}

// The warning appears with the result, wherever that is written.
TEST_F(MeshBody, ThatWasPutRightIsUsedWithAWarning) {
  std::string torn = box(40, 20, 10);
  torn.replace(torn.find("f 1 3 4 2"), 9, "f 9 3 4 2");
  write("box.obj", torn.insert(torn.find("f "), "v 0 0 0.000001\n"));
  write("mesh.toml", text_of(folder_ / "parts.toml") +
                         "[[part]]\nshape = 'mesh'\nfile = 'box.obj'\nunit = 'mm'\ndensity = "
                         "2\nweld = 1e-6\n");
  const Outcome outcome = run("inertia mesh.toml");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "twrench: warning: box.obj: 1 vertices were joined to others within 1e-06 cm\n");
  EXPECT_EQ(outcome.out, run_shell(folder_, "\"$TWRENCH\" inertia mesh.toml 2>/dev/null").out);
}

TEST_F(MeshBody, ThatIsInsideOutIsTurnedWithAWarning) {
  const Outcome sound = run("inertia mesh.toml");
  std::string turned;
  std::istringstream lines(box(40, 20, 10));
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == 'f') std::reverse(line.begin() + 2, line.end());
    turned += line + "\n";
  }
  write("box.obj", turned);
  const Outcome outcome = run("inertia mesh.toml");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, testing::StartsWith("twrench: warning: box.obj: "));
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.out, sound.out);
}

TEST_F(MeshBody, OfMomentsHasTheShapeThatIsAskedFor) {
  write("moments.toml", "[body]\nmoments = [3, 4, 5]\nshape = 'ellipsoid'\n");
  std::map<std::string, std::string> pictures;
  for (const char* options : {"", "--shape box", "--shape cross", "--shape ellipsoid"}) {
    ASSERT_EQ(render(std::string("--overwrite --bare --frames 0 ") + options, "moments.toml").code,
              0);
    pictures[options] = digests(folder_ / "f").at("frame_000000.png");
  }
  EXPECT_EQ(pictures[""], pictures["--shape ellipsoid"]);
  EXPECT_NE(pictures["--shape box"], pictures["--shape ellipsoid"]);
  EXPECT_NE(pictures["--shape cross"], pictures["--shape box"]);
  ASSERT_EQ(
      render("--overwrite --bare --frames 0 --shape cross --inertia 3,4,5", "parts.toml").code, 0);
  const json scene = json::parse(text_of(folder_ / "f/manifest.json"))["scene"];
  EXPECT_EQ(scene["body"]["shape"], "cross");
  const Outcome refused = render("--shape cross", "parts.toml");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(
      refused.err,
      HasSubstr(
          "--shape: applies only to a body given by its inertia alone, and this body has parts\n"
          "  give its moments by --inertia, or leave --shape out"));
  EXPECT_EQ(render("--shape crosss", "moments.toml").code, 2);
}

}  // namespace
}  // namespace twrench
