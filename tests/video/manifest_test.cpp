#include "video/manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "scratch_folder.h"
#include "system/error.h"
#include "system/file.h"

namespace twrench::video {
namespace {

using ::testing::HasSubstr;

FrameRecord record_of(int frame) {
  FrameRecord result{.frame = frame,
                     .t = frame * 0.1,
                     .shot = frame / 4,
                     .flips = frame / 4,
                     .last_flip = frame < 4 ? 0 : 0.1 + 1e-17 * frame,
                     .file = frame_file_name(frame),
                     .sha256 = std::string(64, 'a')};
  for (std::size_t i = 0; i < result.X.size(); ++i) {
    result.X[i] = std::numbers::pi / (1.0 + static_cast<double>(i));
  }
  for (std::size_t i = 0; i < result.view.size(); ++i) {
    result.view[i] = -1.0 / (3.0 + static_cast<double>(i));
    result.projection[i] = 1e-300 * static_cast<double>(i);
  }
  result.projection[3] = std::numeric_limits<double>::denorm_min();
  result.projection[4] = std::numeric_limits<double>::max();
  return result;
}

Manifest sample() {
  return {.version = "0.1.0",
          .scene = {{"name", "dzhanibekov"}, {"omega", {1.0, 0.05, 0.0}}},
          .renderer = "llvmpipe (LLVM 15.0.6, 256 bits)",
          .width = 1920,
          .height = 1080,
          .fps = 60000.0 / 1001,
          .encoder = {"-c:v", "libx264"},
          .range = "3-9:2",
          .frames = {record_of(3), record_of(5)}};
}

/// The error for the sample after replacing `from` by `to` in its text.
std::string failure(const std::string& from, const std::string& to) {
  std::string text = format_manifest(sample());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    parse_manifest(text, "m.json");
  } catch (const system::FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Manifest, IsReadBackAsItWasToTheLastBit) {
  const Manifest written = sample();
  const Manifest read = parse_manifest(format_manifest(written), "m.json");
  EXPECT_EQ(read.version, written.version);
  EXPECT_EQ(read.scene, written.scene);
  EXPECT_EQ(read.renderer, written.renderer);
  EXPECT_EQ(read.width, written.width);
  EXPECT_EQ(read.height, written.height);
  EXPECT_EQ(read.fps, written.fps);
  EXPECT_EQ(read.encoder, written.encoder);
  EXPECT_EQ(read.range, written.range);
  ASSERT_EQ(read.frames.size(), written.frames.size());
  for (std::size_t i = 0; i < read.frames.size(); ++i) {
    EXPECT_EQ(read.frames[i].frame, written.frames[i].frame);
    EXPECT_EQ(read.frames[i].t, written.frames[i].t);
    EXPECT_EQ(read.frames[i].shot, written.frames[i].shot);
    EXPECT_EQ(read.frames[i].flips, written.frames[i].flips);
    EXPECT_EQ(read.frames[i].last_flip, written.frames[i].last_flip);
    EXPECT_EQ(read.frames[i].X, written.frames[i].X);
    EXPECT_EQ(read.frames[i].view, written.frames[i].view);
    EXPECT_EQ(read.frames[i].projection, written.frames[i].projection);
    EXPECT_EQ(read.frames[i].file, written.frames[i].file);
    EXPECT_EQ(read.frames[i].sha256, written.frames[i].sha256);
  }
}

TEST(Manifest, HasTheKeysThatScriptsReadInTheirOrder) {
  const auto json = nlohmann::ordered_json::parse(format_manifest(sample()));
  std::string keys;
  for (const auto& [key, value] : json.items()) {
    keys += key + " ";
  }
  EXPECT_EQ(keys, "version scene renderer size fps encoder range font frames ");
  keys.clear();
  for (const auto& [key, value] : json["frames"][1].items()) {
    keys += key + " ";
  }
  EXPECT_EQ(keys, "frame t shot flips last_flip X view projection file sha256 ");
  EXPECT_EQ(json["size"], nlohmann::ordered_json({1920, 1080}));
  EXPECT_EQ(json["frames"][1]["file"], "frame_000005.png");
}

TEST(Manifest, HasTheQualityOfTheVideo) {
  Manifest manifest = sample();
  manifest.quality = {Effort::small, 18};
  const auto json = nlohmann::ordered_json::parse(format_manifest(manifest));
  EXPECT_EQ(json["encode"], "small");
  EXPECT_EQ(json["crf"], 18);
  EXPECT_TRUE(same_film(manifest, sample())) << "frames do not depend on the encoder";
}

TEST(Manifest, MayLackShotsAndFlips) {
  auto json = nlohmann::ordered_json::parse(format_manifest(sample()));
  EXPECT_TRUE(json["frames"][0]["last_flip"].is_null());
  for (auto& frame : json["frames"]) {
    for (const char* key : {"shot", "flips", "last_flip"}) frame.erase(key);
  }
  const FrameRecord read = parse_manifest(json.dump(), "m.json").frames[1];
  EXPECT_EQ(read.shot, 0);
  EXPECT_EQ(read.flips, 0);
}

TEST(Manifest, HasAFrameALine) {
  const std::string text = format_manifest(sample());
  EXPECT_THAT(text, HasSubstr("\n{\"frame\":5,"));
}

TEST(Manifest, OfNoFramesIsOne) {
  Manifest manifest = sample();
  manifest.frames.clear();
  EXPECT_TRUE(parse_manifest(format_manifest(manifest), "m.json").frames.empty());
}

TEST(Manifest, NamesFilesByTheirNumberInTheFilm) {
  EXPECT_EQ(frame_file_name(0), "frame_000000.png");
  EXPECT_EQ(frame_file_name(1234567), "frame_1234567.png");
}

TEST(Manifest, RefusesFileNamesThatLeadElsewhere) {
  for (const char* name : {"../a.png", "/etc/passwd", "a/b.png", "..", ".", "", "a\\u0000b"}) {
    EXPECT_EQ(failure("frame_000005.png", name),
              "cannot use m.json: frames[1].file must be a file name without a path")
        << name;
  }
}

TEST(Manifest, SaysWhereItIsWrong) {
  const std::string cannot = "cannot use m.json: ";
  EXPECT_EQ(failure("\"version\"", "\"revision\""),
            cannot + "it must be an object with \"version\"");
  EXPECT_EQ(failure("[1920,", "[0,"), cannot + "size[0] must be an integer from 1 to 16384");
  EXPECT_EQ(failure("[1920,", "[1920.5,"), cannot + "size[0] must be an integer from 1 to 16384");
  EXPECT_EQ(failure("[1920,", "[1e99,"), cannot + "size[0] must be an integer from 1 to 16384");
  EXPECT_EQ(failure("[1920,", "[2,1920,"), cannot + "size must be [width, height]");
  EXPECT_EQ(failure("\"fps\": ", "\"fps\": -"), cannot + "fps must be positive");
  EXPECT_EQ(failure("\"fps\": ", "\"fps\": null, \"\": "), cannot + "fps must be a number");
  EXPECT_EQ(failure("\"libx264\"", "264"), cannot + "encoder[1] must be a string");
  EXPECT_EQ(failure("3-9:2", "9-3"), cannot + "range must be a range of frames");
  EXPECT_EQ(failure("\"frame\":5", "\"frame\":-5"),
            cannot + "frames[1].frame must be an integer from 0 to 9999999");
  EXPECT_EQ(failure("\"shot\":1", "\"shot\":-1"),
            cannot + "frames[1].shot must be an integer from 0 to 2147483647");
  EXPECT_EQ(failure("\"flips\":1,\"last_flip\":", "\"flips\":1,\"last_flip\":null,\"\":"),
            cannot + "frames[1].last_flip must be a number");
  EXPECT_EQ(failure("\"X\":[", "\"X\":[1,"), cannot + "frames[0].X must be an array of 9 numbers");
  EXPECT_EQ(failure("\"view\":[", "\"view\":[[],"),
            cannot + "frames[0].view must be an array of 16 numbers");
  for (const char* digits : {"AAAA", "aaa", "aaaaa"}) {
    EXPECT_EQ(failure("aaaa", digits),
              cannot + "frames[0].sha256 must be 64 lower-case hexadecimal digits");
  }
}

TEST(Manifest, RefusesFramesOutOfOrderTwiceOrOutsideItsRange) {
  for (const char* frame : {"\"frame\":3", "\"frame\":1", "\"frame\":4", "\"frame\":11"}) {
    EXPECT_THAT(
        failure("\"frame\":5", frame),
        HasSubstr("cannot use m.json: frames must be in ascending order and inside the range"));
  }
}

TEST(Manifest, RefusesWhatIsNotJson) {
  EXPECT_THAT(failure("\"fps\":", "fps:"), HasSubstr("m.json: line 6 is not valid JSON"));
  EXPECT_THAT(failure("\"fps\": ", "\"fps\": 1e999, \"\": "),
              HasSubstr("a number that is too large"));
  EXPECT_THAT(failure("{", ""), HasSubstr("cannot use m.json"));
  EXPECT_THROW(parse_manifest("", "m.json"), system::FileError);
  EXPECT_THROW(parse_manifest("[1]", "m.json"), system::FileError);
  EXPECT_THROW(parse_manifest("\xff\xfe", "m.json"), system::FileError);
}

TEST(Manifest, RefusesFramesThatAreNone) {
  EXPECT_THAT(failure("\"frames\": [", "\"frames\": [1,"),
              HasSubstr("frames[0] must be an object"));
  EXPECT_THAT(failure("\"frames\": [", "\"frames\": {\"a\": 1}, \"rest\": ["),
              HasSubstr("frames must be an array"));
}

TEST(Manifest, TellsOfItsShard) {
  Manifest manifest = sample();
  manifest.shard = {3, 10};
  const Manifest read = parse_manifest(format_manifest(manifest), "m.json");
  EXPECT_EQ(read.shard, manifest.shard);
  EXPECT_EQ(read.frames.size(), 2U);
  EXPECT_THAT(failure("\"range\":", "\"shard\":\"3/2\",\"range\":"),
              HasSubstr("shard must be i/n"));
}

TEST(Manifest, TellsAChangedMeshFromAnotherScene) {
  using nlohmann::ordered_json;
  const auto with = [](const char* scene) {
    Manifest manifest = sample();
    manifest.scene = ordered_json::parse(scene);
    return manifest;
  };
  const Manifest film = with(R"({"fps": 5, "part": [{"sha256": "a", "density": 1, "weld": 0}]})");
  EXPECT_TRUE(same_but_for_meshes(film, film));
  for (const char* same : {
           R"({"fps": 5, "part": [{"sha256": "b", "density": 1, "weld": 0}]})",
           R"({"fps": 5, "part": [{"sha256": "b", "density": 2, "weld": 0}]})",
       }) {
    EXPECT_TRUE(same_but_for_meshes(film, with(same))) << same;
    EXPECT_FALSE(same_film(film, with(same))) << same;
  }
  for (const char* other : {
           R"({"fps": 6, "part": [{"sha256": "b", "density": 1, "weld": 0}]})",
           R"({"fps": 5, "part": [{"sha256": "a", "density": 2, "weld": 0}]})",
           R"({"fps": 5, "part": [{"sha256": "b", "density": 1, "weld": 1}]})",
           R"({"fps": 5, "part": [{"density": 1, "weld": 0, "wild": 0}]})",
           R"({"fps": 5, "part": [{"sha256": "b", "density": 1, "weld": 0}, {}]})",
           R"({"fps": 5, "part": {"sha256": "b"}})",
       }) {
    EXPECT_FALSE(same_but_for_meshes(film, with(other))) << other;
  }
  Manifest resized = with(R"({"fps": 5, "part": [{"sha256": "b", "density": 1, "weld": 0}]})");
  resized.width = 7;
  EXPECT_FALSE(same_but_for_meshes(film, resized));
}

TEST(Manifest, HeadIsReadWithoutTheFrames) {
  const ScratchFolder scratch;
  const std::string text = format_manifest(sample());
  // The part after the head is not read.
  system::write_file_atomically(scratch / "cut.json", text.substr(0, text.find("\"frame\":3")));
  const Manifest head = read_manifest_head(scratch / "cut.json");
  EXPECT_TRUE(same_film(head, sample()));
  EXPECT_TRUE(head.frames.empty());
  // Another program may format it differently.
  system::write_file_atomically(scratch / "other.json", nlohmann::json::parse(text).dump());
  EXPECT_TRUE(read_manifest_head(scratch / "other.json").frames.empty());
  EXPECT_EQ(read_manifest_head(scratch / "other.json").range, "3-9:2");
  EXPECT_THROW(read_manifest_head(scratch / "none.json"), system::FileError);
}

TEST(Manifest, RefusesDeepNesting) {
  const std::string deep = std::string(1'000'000, '[');
  EXPECT_THAT(failure("\"dzhanibekov\"", deep), HasSubstr("nested more than"));
}

TEST(Manifest, IsReadFromItsFolder) {
  const ScratchFolder scratch;
  system::write_file_atomically(scratch / manifest_name, format_manifest(sample()));
  EXPECT_EQ(read_manifest(scratch / "manifest.json").frames.size(), 2U);
  EXPECT_THROW(read_manifest(scratch / "other.json"), system::FileError);
}

}  // namespace
}  // namespace twrench::video
