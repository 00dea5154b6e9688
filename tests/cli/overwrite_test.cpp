// Outputs replace what twrench wrote as the same kind of file, and nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/twrench.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A command, and the files that it writes.
struct Writing {
  std::string command;
  std::vector<std::string> files;
};

std::vector<Writing> writings() {
  const std::string study = "study --methods rk4 --steps 0.1 --duration 1 -o ";
  const std::string check = "check run.csv --scene dzhanibekov --no-fail -o ";
  return {{"simulate --times 0,1 -o s.csv", {"s.csv"}},
          {"simulate --times 0,1 -o s.json", {"s.json"}},
          {"simulate --times 0,1 -o s", {"s"}},
          {"inertia -o i.txt", {"i.txt"}},
          {"inertia -o i.json", {"i.json"}},
          {check + "c.txt", {"c.txt"}},
          {check + "c.json", {"c.json"}},
          {check + "c.xml --plot c.svg", {"c.xml", "c.svg"}},
          {"check run.csv run.csv --scene dzhanibekov --no-fail -o two.json", {"two.json"}},
          {study + "t.txt", {"t.txt"}},
          {study + "t.csv", {"t.csv"}},
          {study + "t.json --plot t.png", {"t.json", "t.png"}},
          {"cases -o l.txt", {"l.txt"}},
          {"cases -o l.csv", {"l.csv"}},
          {"cases -o l.json", {"l.json"}},
          {"cases basilisk-spacecraft -o p.txt", {"p.txt"}},
          {"cases basilisk-spacecraft -o p.csv", {"p.csv"}},
          {"cases basilisk-spacecraft -o p.json", {"p.json"}},
          {"schema -o x.json", {"x.json"}},
          {"plot -o plot.pdf", {"plot.pdf"}},
          {"export --duration 1 -o e.glb", {"e.glb"}},
          {"export --duration 1 -o e.py", {"e.py"}},
          {"export --duration 1 -o e.aem", {"e.aem"}},
          {"export --duration 1 -o e.csv", {"e.csv"}},
          {"export --duration 1 -o e.json", {"e.json"}},
          {"report stable-y --duration 1 --static -o r.html", {"r.html"}},
          {"report stable-y --duration 1 --static -o r.md", {"r.md", "r-methods.svg"}},
          {"page --template template.html -o page.html", {"page.html"}},
          {"compare a.png b.png --diff d.png --report d.html", {"d.png", "d.html"}}};
}

/// A folder with the inputs of the commands.
class ExistingFiles : public testing::Test {
 protected:
  void SetUp() override {
    system::write_file_atomically(
        folder / "template.html",
        "<!doctype html>\n<head><meta name=\"generator\" content=\"twrench\"></head>\n"
        "<title>{{title}}</title><h1>{{title}}</h1><!-- twrench:poster --><!-- twrench:scene -->");
    ASSERT_EQ(run_twrench(folder, "simulate --times 0,1,2 -o run.csv").code, 0);
    ASSERT_EQ(run_twrench(folder,
                          "render --size 64x36 --frames 0,9 --no-video --progress none "
                          "--frames-dir f")
                  .code,
              0);
    fs::copy(folder / "f/frame_000000.png", folder / "a.png");
    fs::copy(folder / "f/frame_000009.png", folder / "b.png");
  }

  const ScratchFolder folder;
};

TEST_F(ExistingFiles, EachOutputIsReplacedByItsOwnCommandOnly) {
  for (const auto& [command, files] : writings()) {
    for (const std::string& file : files) {
      system::write_file_atomically(folder / file, "the user's own");
      const Outcome refused = run_twrench(folder, command);
      EXPECT_EQ(refused.code, 5) << command << ": " << refused.err;
      EXPECT_THAT(refused.err, HasSubstr(file + ": it exists, and is not"));
      EXPECT_THAT(refused.err, HasSubstr("--overwrite replaces it"));
      EXPECT_EQ(text_of(folder / file), "the user's own");
      fs::remove(folder / file);
    }
    system::write_file_atomically(folder / files.back(), "the user's own");
    const int code = run_twrench(folder, command + " --overwrite").code;
    EXPECT_LE(code, 1) << command;
    for (const std::string& file : files) EXPECT_GT(text_of(folder / file).size(), 20U) << file;
    EXPECT_EQ(run_twrench(folder, command).code, code) << command << ", again";
  }
}

TEST_F(ExistingFiles, AnOutputOfAnotherCommandIsKept) {
  ASSERT_EQ(run_twrench(folder, "simulate --times 0,1 -o s.json").code, 0);
  ASSERT_EQ(run_twrench(folder, "inertia -o i.json").code, 0);
  const std::string manifest = text_of(folder / "f/manifest.json");
  for (const char* command :
       {"inertia -o s.json", "schema -o s.json", "simulate --times 0 -o i.json",
        "cases -o f/manifest.json", "simulate --times 0 -o f/manifest.json",
        "compare a.png b.png --diff f/frame_000000.png"}) {
    EXPECT_EQ(run_twrench(folder, command).code, 5) << command;
  }
  EXPECT_EQ(text_of(folder / "f/manifest.json"), manifest);
}

TEST_F(ExistingFiles, TheEndingFitsTheKind) {
  system::write_file_atomically(folder / "me.toml", "[body]\nmoments = [1, 2, 3]\n");
  fs::create_symlink("me.toml", folder / "link.txt");
  for (const char* command :
       {"simulate -o me.toml --overwrite", "simulate -o run.xlsx", "inertia -o me.toml",
        "check run.csv -o me.toml", "cases -o me.toml", "schema -o me.toml", "plot -o me.toml",
        "export -o me.toml", "report -o me.toml", "page -o me.toml", "study -o me.toml",
        "simulate -o run.csv --format json", "export -o a.glb --format aem",
        "compare a.png b.png --diff me.toml", "compare a.png b.png --report me.toml"}) {
    const Outcome run = run_twrench(folder, command);
    EXPECT_EQ(run.code, 2) << command << ": " << run.err;
    EXPECT_THAT(run.err, HasSubstr("its name must end in ."));
  }
  EXPECT_EQ(run_twrench(folder, "check run.csv --scene stable-y -o link.txt").code, 5);
  EXPECT_THAT(text_of(folder / "me.toml"), HasSubstr("moments"));
}

TEST_F(ExistingFiles, StreamsTakeAnything) {
  system::write_file_atomically(folder / "notes.txt", "x");
  const Outcome run = run_shell(folder,
                                "\"$TWRENCH\" simulate --times 0 >notes.txt && "
                                "\"$TWRENCH\" simulate --times 0 -o /dev/stdout >more.txt && "
                                "\"$TWRENCH\" inertia --format json -o /dev/fd/3 3>more.txt && "
                                "\"$TWRENCH\" simulate --times 0 -o /dev/null");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(text_of(folder / "notes.txt"), HasSubstr("t,x11"));
  EXPECT_THAT(text_of(folder / "more.txt"), HasSubstr("principal_moments"));
}

TEST_F(ExistingFiles, AFilmIsNoneOfItsOwnFiles) {
  const std::string small = "render --size 64x36 --frames 0-2 --progress none ";
  const std::string story = "[[shot]]\ncaption = \"one\"\n[shot.motion]\nduration = 1\n";
  system::write_file_atomically(folder / "story.toml", story);
  const std::string manifest = text_of(folder / "f/manifest.json");
  for (const std::string& command :
       {small + "story.toml -o y.vtt --container mp4",
        small + "-o f/manifest.json --frames-dir f --container mp4 --overwrite",
        small + "-o f/frame_000002.png --frames-dir f --container mp4 --overwrite",
        small + "-o new/frame_000001.png --frames-dir new --container mp4",
        small + "-o v.mp4 --font f/frame_000000.png --frames-dir f --overwrite",
        std::string("encode f -o y.vtt --container mp4")}) {
    const Outcome run = run_twrench(folder, command);
    EXPECT_EQ(run.code, 2) << command << ": " << run.err;
  }
  EXPECT_EQ(text_of(folder / "f/manifest.json"), manifest);
  EXPECT_FALSE(fs::exists(folder / "new"));
  EXPECT_FALSE(fs::exists(folder / "y.vtt"));
}

}  // namespace
}  // namespace twrench
