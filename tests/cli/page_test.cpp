#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "cli/twrench.h"
#include "sanitizers.h"

namespace twrench {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

/// A page with only a scene. scripts/maintain/page.sh builds the real one, which is tested in a
/// browser.
void write_template(const ScratchFolder& folder) {
  std::ofstream(folder / "t.html")
      << "<!doctype html>\n<meta name=\"generator\" content=\"twrench\">\n"
         "<title>{{title}}</title><h1>{{title}}</h1>\n"
         "<!-- twrench:poster -->\n<!-- twrench:scene -->\n";
}

/// An OBJ file of 4 (n - 1) n triangles: an ellipsoid with waves, which cannot be simplified.
std::string fine_ball(int n) {
  std::string text = "v 0 0 3\nv 0 0 -3\n";
  for (int ring = 1; ring < n; ++ring) {
    for (int i = 0; i < 2 * n; ++i) {
      const double polar = std::numbers::pi * ring / n, azimuth = std::numbers::pi * i / n;
      const double radius = 1 + 0.1 * std::sin(12 * polar) * std::sin(12 * azimuth);
      text += fmt::format("v {} {} {}\n", radius * std::sin(polar) * std::cos(azimuth),
                          2 * radius * std::sin(polar) * std::sin(azimuth),
                          3 * radius * std::cos(polar));
    }
  }
  const auto at = [&](int ring, int i) {
    return ring == 0 ? 1 : ring == n ? 2 : 3 + (ring - 1) * 2 * n + i % (2 * n);
  };
  for (int ring = 0; ring < n; ++ring) {
    for (int i = 0; i < 2 * n; ++i) {
      const int a = at(ring, i), b = at(ring + 1, i), c = at(ring + 1, i + 1), d = at(ring, i + 1);
      if (ring > 0) text += fmt::format("f {} {} {}\n", a, c, d);
      if (ring + 1 < n) text += fmt::format("f {} {} {}\n", a, b, c);
    }
  }
  return text;
}

nlohmann::json scene_of(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"scene\">";
  const std::size_t from = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(Page, HasTheSceneWithItsOverridesAndWithout) {
  const ScratchFolder folder;
  write_template(folder);
  const Outcome run =
      run_twrench(folder, "page stable-y --omega 0,2,0.5 --template t.html -o a.html");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  const nlohmann::json scene = scene_of(text_of(folder / "a.html"));
  EXPECT_EQ(scene["source"], "stable-y");
  EXPECT_EQ(scene["scene"]["motion"]["omega"], nlohmann::json({0, 2, 0.5}));
  EXPECT_NE(scene["source_scene"]["motion"]["omega"], scene["scene"]["motion"]["omega"]);
  EXPECT_EQ(scene["inertia"].size(), 9U);
  EXPECT_EQ(scene["surface"]["parts"].size(), 2U);
  EXPECT_EQ(scene["themes"].size(), 3U);
}

TEST(Page, HasTheArticleUnlessItIsTheLab) {
  const ScratchFolder folder;
  write_template(folder);
  ASSERT_EQ(run_twrench(folder, "page --template t.html -o a.html").code, 0);
  EXPECT_EQ(scene_of(text_of(folder / "a.html"))["article"], true);
  ASSERT_EQ(run_twrench(folder, "page --lab --template t.html -o b.html").code, 0);
  EXPECT_EQ(scene_of(text_of(folder / "b.html"))["article"], false);
}

TEST(Page, WritesAllBuiltInScenesAndTheirIndex) {
  if (has_sanitizers) GTEST_SKIP() << "writes more than the other pages";
  const ScratchFolder folder;
  write_template(folder);
  const Outcome run =
      run_twrench(folder, "page --all --theme paper --size 160x90 --template t.html -o a/site");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string index = text_of(folder / "a/site/index.html");
  std::size_t files = 0;
  std::istringstream scenes(run_twrench(folder, "scenes").out);
  for (std::string line; std::getline(scenes, line);) {
    const std::string name = line.substr(0, line.find(' '));
    const std::string page = text_of(folder / ("a/site/" + name + ".html"));
    const nlohmann::json scene = scene_of(page);
    EXPECT_EQ(scene["source"], name);
    EXPECT_EQ(scene["scene"]["look"]["theme"], "paper") << name;
    // The index has the same picture.
    const std::size_t picture = page.find("<img");
    ASSERT_NE(picture, std::string::npos) << name;
    const std::string link = "<a href=\"" + name + ".html\">";
    const std::string image = page.substr(picture, page.find('>', picture) + 1 - picture);
    EXPECT_NE(index.find(link + image), std::string::npos) << name;
    ++files;
  }
  EXPECT_NE(index.find("disc: why it flips</h2><p>unstable about y"), std::string::npos);
  EXPECT_GT(files, 10U);
  const std::filesystem::directory_iterator all(folder / "a/site");
  EXPECT_EQ(std::distance(begin(all), end(all)), static_cast<std::ptrdiff_t>(files + 1));
}

TEST(Page, RefusesWhatASiteCannotBe) {
  const ScratchFolder folder;
  write_template(folder);
  std::ofstream(folder / "file") << "kept";
  const auto refusal = [&](const std::string& words, int code) {
    const Outcome run = run_twrench(folder, "page --all --template t.html " + words);
    EXPECT_EQ(run.code, code) << words;
    return run.err;
  };
  EXPECT_THAT(refusal("toutatis -o site", 2), HasSubstr("SCENE is given too"));
  EXPECT_THAT(refusal("-o -", 2), HasSubstr("name the folder"));
  EXPECT_THAT(refusal("--omega 1,2 -o site", 2), HasSubstr("--omega"));
  EXPECT_THAT(refusal("-o file", 5), HasSubstr("Not a directory"));
  EXPECT_FALSE(std::filesystem::exists(folder / "site"));
  std::filesystem::copy_file(folder / "t.html", folder / "index.html");
  EXPECT_EQ(run_twrench(folder, "page --all --template index.html -o .").code, 2);
  EXPECT_THAT(text_of(folder / "index.html"), HasSubstr("twrench:poster"));
}

// A pipe can be read only once.
TEST(Page, TakesASceneFromAPipe) {
  const ScratchFolder folder;
  write_template(folder);
  const Outcome run =
      run_shell(folder,
                "printf '[body]\\nmoments = [1, 2, 3]\\n' | "
                "\"$TWRENCH\" page /dev/stdin --omega 0,2,0.5 --template t.html -o a.html");
  ASSERT_EQ(run.code, 0) << run.err;
  const nlohmann::json scene = scene_of(text_of(folder / "a.html"));
  EXPECT_EQ(scene["scene"]["motion"]["omega"], nlohmann::json({0, 2, 0.5}));
  EXPECT_EQ(scene["source_scene"]["body"]["moments"], nlohmann::json({1, 2, 3}));
  EXPECT_NE(scene["source_scene"]["motion"]["omega"], scene["scene"]["motion"]["omega"]);
}

// Such a body would turn over 400 million times in a second.
TEST(Page, OfABodyThatTurnsInNanoseconds) {
  const ScratchFolder folder;
  write_template(folder);
  const Outcome run =
      run_twrench(folder, "page --inertia 3,4,5 --omega 1e7,3e9,1e7 --template t.html -o a.html");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(text_of(folder / "a.html").find("<img"), std::string::npos);
}

TEST(Page, OfAMeshHasTheOptionsThatItsCommandsNeed) {
  const ScratchFolder folder;
  write_template(folder);
  std::ofstream(folder / "ball.obj") << fine_ball(4);
  const Outcome run =
      run_twrench(folder, "page ball.obj --unit mm --omega 0,2,0 --template t.html -o a.html");
  ASSERT_EQ(run.code, 0) << run.err;
  const nlohmann::json scene = scene_of(text_of(folder / "a.html"));
  EXPECT_EQ(scene["source"], "ball.obj");
  EXPECT_EQ(scene["source_options"], nlohmann::json({"--unit", "mm"}));
  const nlohmann::json given = scene.value("source_scene", scene["scene"]);
  EXPECT_EQ(given["part"][0]["scale"], 0.1);
  EXPECT_EQ(given["title"], "ball");
}

TEST(Page, HasAPictureForWhereItCannotDraw) {
  const ScratchFolder folder;
  write_template(folder);
  ASSERT_EQ(run_twrench(folder, "page --template t.html --size 1080x1920 -o a.html").code, 0);
  EXPECT_THAT(
      text_of(folder / "a.html"),
      HasSubstr("<img alt=\"\" width=\"450\" height=\"800\" src=\"data:image/jpeg;base64,"));
}

TEST(Page, HasAStillOfEachFigure) {
  const ScratchFolder folder;
  write_template(folder);
  const auto panes_of = [&](const std::string& options) {
    const Outcome run = run_twrench(folder, "page --template t.html -o a.html" + options);
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string page = text_of(folder / "a.html");
    const std::string begin = "<img id=\"stills\" alt=\"\" hidden data-panes=\"";
    const std::size_t from = page.find(begin) + begin.size();
    return page.substr(from, page.find("\" src=\"data:image/jpeg;base64,", from) - from);
  };
  EXPECT_EQ(panes_of(""),
            "part-flip:1 part-axes:3 part-try:1 part-constant:1 part-frame:1 part-stable:3 "
            "part-sphere:2 part-waiting:1 part-inside:2 part-methods:2 sphere:1 poinsot:1");
  EXPECT_EQ(panes_of(" --lab"), "sphere:1 poinsot:1");
}

TEST(Page, OpensInTheGivenLanguage) {
  const ScratchFolder folder;
  write_template(folder);
  const auto page = [&](const std::string& options, const std::string& notes = "") {
    const Outcome run = run_twrench(folder, "page --lab --template t.html -o a.html " + options);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, notes) << options;
    return scene_of(text_of(folder / "a.html"));
  };
  EXPECT_FALSE(page("").contains("language"));
  EXPECT_EQ(page("--language en")["language"], "en");
  EXPECT_EQ(page("--language no")["language"], "nb");
  EXPECT_EQ(
      page("--language sv", "twrench: note: the page is in English, not in 'sv'\n")["language"],
      "en");
  std::ofstream(folder / "s.toml") << "language = 'nb'\n[body]\nmoments = [1, 2, 3]\n";
  EXPECT_EQ(page("s.toml")["language"], "nb");
  EXPECT_EQ(page("s.toml --language en")["language"], "en");
  // The page's commands name the story that it shows.
  const nlohmann::json story = page("explain --language nb");
  EXPECT_EQ(story["source"], "explain-nb");
  EXPECT_EQ(story["scene"]["title"], "Hvorfor det snur");
}

TEST(Page, KeepsHostileTextText) {
  const ScratchFolder folder;
  write_template(folder);
  std::ofstream(folder / "s.toml")
      << "title = '</script><img src=x onerror=alert(1)>{{title}}<!-- twrench:scene -->'\n"
         "[[part]]\nname = '</script><b>'\nshape = 'box'\nsize = [1.0, 2.0, 3.0]\ndensity = 1.0\n";
  ASSERT_EQ(run_twrench(folder, "page s.toml --template t.html -o a.html").code, 0);
  const std::string page = text_of(folder / "a.html");
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;&lt;img src=x"));
  EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(page, Not(HasSubstr("</script><b>")));
  EXPECT_EQ(scene_of(page)["scene"]["part"][0]["name"], "</script><b>");
}

TEST(Page, SaysThatItDrawsALargeMeshByFewerTriangles) {
  if (has_sanitizers) GTEST_SKIP() << "writes more than the other pages";
  const ScratchFolder folder;
  write_template(folder);
  std::ofstream(folder / "ball.obj") << fine_ball(120);
  std::ofstream(folder / "s.toml")
      << "[[part]]\nshape = 'mesh'\nfile = 'ball.obj'\nunit = 'cm'\ndensity = 1.0\n";
  const Outcome run = run_twrench(folder, "page s.toml --template t.html -o a.html");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, MatchesRegex("twrench: the page draws [0-9]+ of 57120 triangles; mass "
                                    "properties use all of them\n"));
}

TEST(Page, RefusesWhatItCannotDo) {
  const ScratchFolder folder;
  write_template(folder);
  std::ofstream(folder / "bare.html") << "<title>{{title}}</title>";
  std::ofstream(folder / "s.toml") << "[body]\nmoments = [1.0, 2.0, 3.0]\n";
  const auto expect_refused = [&](const std::string& options, int code, const char* message) {
    const Outcome run = run_twrench(folder, "page " + options);
    EXPECT_EQ(run.code, code) << options;
    EXPECT_THAT(run.err, StartsWith("twrench: error: "));
    EXPECT_THAT(run.err, HasSubstr(message));
  };
  expect_refused("--template t.html", 2, "--output");
  expect_refused("--template none.html -o a.html", 5, "No such file");
  expect_refused("--template bare.html -o a.html", 5, "the mark {{title}} is missing");
  expect_refused("--template t.html -o t.html", 2, "t.html");
  expect_refused("s.toml --template t.html -o s.toml", 2, "s.toml");
  expect_refused("--template t.html -o no/such.html", 5, "No such file or directory");
  expect_refused("--template t.html -o /dev/full", 5, "No space left on device");
  expect_refused("--template t.html -o a.html --duration 2e15", 2, "--duration");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.html"));
  EXPECT_EQ(run_twrench(folder, "page s.toml --template t.html -o a.html --duration 1e9").code, 0);
}

// Only scripts/maintain/page.sh makes the built-in page.
TEST(Page, IsBuiltInOrSaysHowToGetIt) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "page sphere -o a.html");
  if (run.code == 0) {
    EXPECT_THAT(text_of(folder / "a.html"), StartsWith("<!doctype html>"));
  } else {
    EXPECT_EQ(run.code, 5);
    EXPECT_EQ(run.err,
              "twrench: error: page: this build does not include the page\n"
              "  run scripts/maintain/page.sh, which adds it\n");
  }
}

}  // namespace
}  // namespace twrench
