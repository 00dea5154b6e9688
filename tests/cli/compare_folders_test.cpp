// twrench compare with two folders of frames.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/twrench.h"
#include "image/png.h"
#include "system/file.h"

namespace twrench {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A gray picture in which one red sample has that value.
void write_picture(const std::filesystem::path& file, int value, int width = 16) {
  image::Image image(width, 16, 3);
  std::ranges::fill(image.pixels, std::uint8_t{100});
  image.pixels[0] = static_cast<std::uint8_t>(value);
  system::write_file_atomically(file, image::encode_png(image));
}

class CompareFolders : public testing::Test {
 protected:
  CompareFolders() {
    for (const char* name : {"golden", "actual"}) system::make_folder(folder_ / name);
  }

  void add(const std::string& name, int expected, int actual) const {
    write_picture(folder_ / "golden" / name, expected);
    write_picture(folder_ / "actual" / name, actual);
  }

  Outcome compare(const std::string& options = "") const {
    return run_twrench(folder_, "compare golden actual " + options);
  }

  const ScratchFolder folder_;
};

TEST_F(CompareFolders, Alike) {
  add("frame_000000.png", 100, 100);
  add("frame_000001.png", 100, 101);
  const Outcome run = compare("--threshold 1");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, "alike: 0 of 2 frames differ, 1 are identical files\n");
  EXPECT_EQ(run.err, "");
}

TEST_F(CompareFolders, HaveALineForEachFrameThatDiffersInTheOrderOfTheNames) {
  add("frame_000002.png", 100, 130);
  add("frame_000000.png", 100, 100);
  write_picture(folder_ / "golden/frame_000003.png", 100);
  write_picture(folder_ / "actual/frame_000004.png", 100);
  add("frame_000005.png", 100, 100);
  write_picture(folder_ / "actual/frame_000005.png", 100, 20);
  system::write_file_atomically(folder_ / "actual/manifest.json", "{}");
  const Outcome run = compare();
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out,
            "frame_000002.png: different: max 30 mean 0.039062 of 255, 0.003906 of the pixels over "
            "0, in 0,0,1x1\n"
            "frame_000003.png: missing: there is no actual frame\n"
            "frame_000004.png: extra: there is no expected frame\n"
            "frame_000005.png: different: 16x16 with 3 channels, and 20x16 with 3\n"
            "different: 2 of 3 frames differ, 1 are identical files; not compared: 1 missing, "
            "1 extra\n");
}

TEST_F(CompareFolders, OfWhichNoFrameCouldBeComparedAreDifferent) {
  for (const char* name : {"a.png", "b.png"}) write_picture(folder_ / "golden" / name, 100);
  write_picture(folder_ / "actual/c.png", 100);
  const Outcome run = compare();
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, EndsWith("different: no frame was compared: 2 missing, 1 extra\n"));
}

/// Writes an opaque gray picture with an alpha channel.
void write_opaque_picture(const std::filesystem::path& file) {
  image::Image image(16, 16, 4);
  std::ranges::fill(image.pixels, std::uint8_t{100});
  for (std::size_t at = 3; at < image.pixels.size(); at += 4) image.pixels[at] = 255;
  system::write_file_atomically(file, image::encode_png(image));
}

TEST_F(CompareFolders, NoteDifferencesOfTheFilesOnce) {
  for (const char* name : {"a.png", "b.png"}) {
    write_picture(folder_ / "golden" / name, 100);
    write_opaque_picture(folder_ / "actual" / name);
  }
  add("c.png", 100, 100);
  const Outcome run = compare("--report r.html");
  EXPECT_EQ(run.code, 0) << run.out;
  const std::string note =
      "the actual picture has an alpha channel, opaque everywhere, and the expected one has none";
  EXPECT_EQ(run.out,
            "note: 2 frames: " + note + "\nalike: 0 of 3 frames differ, 1 are identical files\n");
  EXPECT_THAT(text_of(folder_ / "r.html"), HasSubstr("Note: 2 frames: " + note));
  const auto found = nlohmann::json::parse(compare("--format json").out);
  EXPECT_EQ(found["frames"][0]["notes"], nlohmann::json({note}));
  EXPECT_FALSE(found["frames"][2].contains("notes"));
  const Outcome files = run_twrench(folder_, "compare golden/a.png actual/a.png --diff d.png");
  EXPECT_EQ(files.code, 0);
  EXPECT_THAT(files.out, AllOf(StartsWith("alike: max 0 "), EndsWith("\nnote: " + note + "\n")));
}

TEST_F(CompareFolders, AsJson) {
  add("a.png", 100, 130);
  add("b.png", 100, 100);
  const Outcome run = compare("--format json --metric ssim --ignore 8,8,2x2");
  EXPECT_EQ(run.code, 1);
  const auto found = nlohmann::json::parse(run.out);
  EXPECT_EQ(found["verdict"], "different");
  EXPECT_EQ(found["criteria"]["ignore"], nlohmann::json::parse("[[8, 8, 2, 2]]"));
  EXPECT_EQ(found["counts"]["different"], 1);
  EXPECT_EQ(found["counts"]["identical"], 1);
  EXPECT_EQ(found["frames"][0]["file"], "a.png");
  EXPECT_EQ(found["frames"][0]["max"], 30);
  EXPECT_LT(found["frames"][0]["ssim"], 1);
  EXPECT_EQ(found["frames"][0]["area"], nlohmann::json::parse("[0, 0, 1, 1]"));
  EXPECT_EQ(found["frames"][1]["outcome"], "identical");
  EXPECT_EQ(found["frames"][1]["ssim"], 1);
}

// Python's own XML parser rejects a file that is not well-formed.
TEST_F(CompareFolders, AsJUnitWhateverTheNames) {
  add("a & <b>\" '\x01\xff\xef\xbf\xbf.png", 100, 130);
  add("b.png", 100, 100);
  add("c.png", 100, 100);
  system::write_file_atomically(folder_ / "actual/c.png", "no picture");
  const Outcome run =
      run_shell(folder_, R"("$TWRENCH" compare golden actual --format junit | python3 -c '
import sys, xml.etree.ElementTree as tree
suite, = tree.parse(sys.stdin).getroot()
print(suite.get("tests"), suite.get("failures"), suite.get("errors"))
for case in suite:
    print(case.get("name"), [(child.tag, child.get("message")[:14]) for child in case])')");
  EXPECT_EQ(run.out,
            "3 1 1\n"
            "a & <b>\" '\\x01\\xff\\uffff.png [('failure', 'different: max')]\n"
            "b.png []\n"
            "c.png [('error', 'unreadable: ca')]\n");
}

TEST_F(CompareFolders, NameTheFrameThatIsDamagedAndJudgeTheOthers) {
  add("a.png", 100, 130);
  add("b.png", 100, 100);
  std::string damaged = text_of(folder_ / "actual/b.png");
  damaged[damaged.size() - 13] ^= 1;
  system::write_file_atomically(folder_ / "actual/b.png", damaged);
  const Outcome run = compare();
  EXPECT_EQ(run.code, 5);
  EXPECT_THAT(run.out, AllOf(HasSubstr("a.png: different"), HasSubstr("b.png: unreadable")));
  EXPECT_EQ(run.err,
            "twrench: error: cannot read actual/b.png: the checksum of a chunk is wrong\n");
  write_picture(folder_ / "actual/a.png", 100);
  EXPECT_THAT(compare().out, HasSubstr("\nunreadable: 0 of 1 frames differ, 1 are identical "
                                       "files; not compared: 1 unreadable\n"));
}

TEST_F(CompareFolders, RefuseWhatCannotBeCompared) {
  add("a.png", 100, 130);
  system::make_folder(folder_ / "empty");
  const std::vector<std::pair<std::string, std::pair<int, std::string>>> mistakes{
      {"golden golden/a.png", {2, "golden is a folder, but golden/a.png is a file"}},
      {"golden/a.png actual", {2, "golden/a.png is a file, but actual is a folder"}},
      {"golden missing", {5, "cannot read missing: No such file"}},
      {"missing golden", {5, "cannot read missing: No such file"}},
      {"empty empty", {5, "cannot compare empty with empty: neither has a frame"}},
      {"golden actual --diff d.png", {2, "--diff: it is for two files"}},
      {"golden actual --report golden/a.png", {2, "is an input"}},
      {"golden actual --report actual/a.png", {2, "is an input"}},
      {"golden actual --report -", {2, "standard output is used for the results"}},
      {"golden actual --report actual/manifest.json", {2, "must end in .html"}},
      {"golden/a.png actual/a.png --diff golden/manifest.json", {2, "must end in .png"}},
      {"golden actual --report missing/r.html", {5, "cannot write missing/r.html"}},
      {"golden actual --ignore 15,0,2x1", {2, "the area 15,0,2x1: it is not within actual/a.png"}},
      {"golden actual --ignore 1,2,3", {2, "--ignore: '1,2,3' is not X,Y,WIDTHxHEIGHT"}},
      {"golden actual --ignore 1,2,0x3", {2, "--ignore: is 0"}},
      {"golden actual --ignore=-1,2,1x3", {2, "--ignore: is -1"}},
      {"golden actual --edges 17", {2, "--edges: is 17"}},
      {"golden actual --min-ssim 0.9", {2, "--min-ssim: it bounds the metric ssim"}},
      {"golden actual --metric ssim --share 0.9", {2, "--share: it bounds the metric share"}},
  };
  for (const auto& [arguments, expected] : mistakes) {
    const Outcome run = run_twrench(folder_, "compare " + arguments);
    EXPECT_EQ(run.code, expected.first) << arguments << run.err;
    EXPECT_THAT(run.err, StartsWith("twrench: error: ")) << arguments;
    EXPECT_THAT(run.err, HasSubstr(expected.second)) << arguments;
  }
}

TEST_F(CompareFolders, ThatAreTheSameAreAlikeWithAWarning) {
  add("a.png", 100, 130);
  std::filesystem::create_symlink("golden", folder_ / "link");
  const Outcome run = run_twrench(folder_, "compare golden link");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("warning: both folders are the same one"));
}

TEST_F(CompareFolders, WithoutActualFramesAreDifferent) {
  write_picture(folder_ / "golden/a.png", 100);
  const Outcome run = compare();
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("a.png: missing"));
}

TEST_F(CompareFolders, UpdateAcceptsWhatDiffers) {
  add("a.png", 100, 130);
  add("b.png", 100, 100);
  write_picture(folder_ / "actual/c.png", 100);
  const Outcome update = compare("--update");
  EXPECT_EQ(update.code, 0) << update.err;
  EXPECT_THAT(update.out, HasSubstr("a.png: different"));
  EXPECT_EQ(update.err, "twrench: compare: 2 frames were updated in golden\n");
  const Outcome after = compare();
  EXPECT_EQ(after.code, 0);
  EXPECT_THAT(after.out, HasSubstr("3 are identical files"));
}

TEST_F(CompareFolders, UpdateLeavesWhatIsMissing) {
  write_picture(folder_ / "golden/a.png", 100);
  add("b.png", 100, 130);
  EXPECT_EQ(compare("--update").code, 1);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "golden/a.png"));
  EXPECT_THAT(compare().out,
              HasSubstr("different: 0 of 1 frames differ, 1 are identical files; not "
                        "compared: 1 missing\n"));
}

TEST_F(CompareFolders, UpdateMakesTheFirstGoldenFrames) {
  write_picture(folder_ / "actual/a.png", 100);
  EXPECT_EQ(run_twrench(folder_, "compare new/golden actual --update").code, 0);
  EXPECT_EQ(run_twrench(folder_, "compare new/golden actual").code, 0);
  EXPECT_EQ(run_twrench(folder_, "compare new/golden/b.png actual/a.png --update").code, 0);
  EXPECT_EQ(run_twrench(folder_, "compare new/golden/b.png actual/a.png").code, 0);
}

TEST_F(CompareFolders, UpdateTouchesNothingIfAFrameCannotBeRead) {
  add("a.png", 100, 130);
  add("b.png", 100, 100);
  system::write_file_atomically(folder_ / "actual/b.png", "no picture");
  EXPECT_EQ(compare("--update").code, 5);
  EXPECT_EQ(image::read_png(folder_ / "golden/a.png").pixels[0], 100);
}

TEST_F(CompareFolders, ReportIsOnePageWithPictures) {
  add("a<b.png", 100, 130);
  add("b.png", 100, 160);
  write_picture(folder_ / "golden/c.png", 100);
  EXPECT_EQ(compare("--report report.html").code, 1);
  const std::string page = text_of(folder_ / "report.html");
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_THAT(page,
              AllOf(HasSubstr("3 of 3 frames are not as expected"), HasSubstr("default-src 'none'"),
                    HasSubstr("a&lt;b.png"), HasSubstr("--w:16;--h:16"), Not(HasSubstr("a<b")),
                    Not(HasSubstr("http:")), Not(HasSubstr("https:"))));
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (auto at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("src=\"data:image/png;base64,iVBOR"), 7);
  EXPECT_EQ(count("type=\"range\""), 2);
  EXPECT_EQ(count("src="), 7);
  EXPECT_EQ(count("href="), 0);
  EXPECT_LT(page.find("<h2>b.png"), page.find("<h2>a&lt;b.png"));  // the worst first
}

TEST_F(CompareFolders, ReportHasAChartOfSeveralFrames) {
  add("a.png", 100, 130);
  EXPECT_EQ(compare("--report one.html").code, 1);
  EXPECT_THAT(text_of(folder_ / "one.html"), Not(HasSubstr("frame by frame")));
  add("b.png", 100, 100);
  EXPECT_EQ(compare("--report two.html").code, 1);
  EXPECT_THAT(text_of(folder_ / "two.html"), HasSubstr("frame by frame"));
}

TEST_F(CompareFolders, ReportHasNoPicturesOfAFrameThatCannotBeRead) {
  add("a.png", 100, 130);
  system::write_file_atomically(folder_ / "actual/a.png", "no picture");
  EXPECT_EQ(compare("--report report.html").code, 5);
  const std::string page = text_of(folder_ / "report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("<h2>a.png"), Not(HasSubstr("class=\"stage"))));
}

TEST_F(CompareFolders, ReportOfManyFramesListsWhatHasNoPictures) {
  for (int i = 0; i < 30; ++i) add("f" + std::to_string(i) + ".png", 100, 101 + i);
  EXPECT_EQ(compare("--report report.html").code, 1);
  const std::string page = text_of(folder_ / "report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("6 more, without pictures"), HasSubstr("<td>f0.png</td>")));
}

TEST_F(CompareFolders, EdgesMayLieElsewhere) {
  for (const auto& [name, edge] : {std::pair{"golden", 8}, {"actual", 9}}) {
    image::Image image(16, 16, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      image.pixels[i] = i / 3 % 16 < static_cast<std::size_t>(edge) ? 20 : 200;
    }
    system::write_file_atomically(folder_ / name / "a.png", image::encode_png(image));
  }
  EXPECT_EQ(compare().code, 1);
  EXPECT_EQ(compare("--edges 1").code, 0);
}

}  // namespace
}  // namespace twrench
