// Films, tables and exports of a recorded motion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>

#include "cli/twrench.h"

namespace twrench {
namespace {

using testing::HasSubstr;

/// A folder with the recording run.csv of a tennis racket, 2 s at 50 Hz.
class MotionFile : public testing::Test {
 protected:
  MotionFile() {
    const Outcome run = run_twrench(
        folder_, "simulate tennis-racket --method exact --duration 2 --fps 50 -o run.csv");
    EXPECT_EQ(run.code, 0) << run.err;
  }

  Outcome film(const std::string& options) const {
    return run_twrench(folder_,
                       "render tennis-racket --motion run.csv --size 160x90 --progress none "
                       "--frames 0-4 --frames-dir f " +
                           options);
  }

  ScratchFolder folder_;
};

TEST_F(MotionFile, IsPartOfTheIdentityOfAFilm) {
  ASSERT_EQ(film("-o v.mp4").code, 0);
  const auto manifest = nlohmann::json::parse(text_of(folder_ / "f/manifest.json"));
  const auto recording = manifest["scene"]["motion"]["recording"];
  EXPECT_EQ(recording["file"], "run.csv");
  EXPECT_EQ(recording["sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(film("-o v.mp4 --resume").code, 0);
  const Outcome other = film("-o v.mp4 --resume --from 0.5");
  EXPECT_EQ(other.code, 5) << other.err;
}

TEST_F(MotionFile, IsNeverAnOutput) {
  const std::string before = text_of(folder_ / "run.csv");
  const Outcome run =
      run_twrench(folder_, "export tennis-racket --motion run.csv -o ./run.csv --overwrite");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("is an input of this command"));
  EXPECT_EQ(text_of(folder_ / "run.csv"), before);
}

TEST_F(MotionFile, ExcludesWhatComputesAMotion) {
  for (const char* options :
       {"--omega 1,2,3", "--method rk4", "--duration 3", "--compare-omega '1,0,0;0,1,0'",
        "--frame rotating", "--from 5", "--from x", "--units deg --units rad", "--axes x,x,z"}) {
    const Outcome run = film(std::string(options) + " --no-video");
    EXPECT_EQ(run.code, 2) << options << run.err;
    EXPECT_THAT(run.err, testing::StartsWith("twrench: error: ")) << options;
  }
  for (const char* option : {"--from 1", "--to 1", "--units deg", "--inverse"}) {
    const Outcome run =
        run_twrench(folder_, std::string("render --no-video --frames-dir g ") + option);
    EXPECT_EQ(run.code, 2) << option;
    EXPECT_THAT(run.err, HasSubstr("give the recording with --motion FILE")) << option;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f"));
}

TEST_F(MotionFile, IsConverted) {
  for (const char* name : {"a.json", "a.aem"}) {
    const std::string export_it = "export tennis-racket --motion run.csv --fps 50 -o ";
    ASSERT_EQ(run_twrench(folder_, export_it + name).code, 0);
    const Outcome judged = run_twrench(folder_, std::string("check --scene tennis-racket ") + name);
    EXPECT_EQ(judged.code, 0) << judged.out << judged.err;
  }
  ASSERT_EQ(run_twrench(folder_, "export tennis-racket --motion run.csv -o a.glb").code, 0);
  const Outcome beyond =
      run_twrench(folder_, "simulate tennis-racket --motion run.csv --times 0,2.5");
  EXPECT_EQ(beyond.code, 2);
  EXPECT_THAT(beyond.err, HasSubstr("2.5 s is not among the 2 s that are recorded"));
}

TEST_F(MotionFile, IsPlottedWithTheExactMotion) {
  const Outcome run = run_twrench(folder_, "plot tennis-racket --motion run.csv -o a.svg");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = text_of(folder_ / "a.svg");
  EXPECT_THAT(svg, HasSubstr(">run.csv<"));
  EXPECT_THAT(svg, HasSubstr(">exact<"));
  const Outcome alone = run_twrench(folder_, "plot --motion run.csv -o b.svg");
  ASSERT_EQ(alone.code, 0) << alone.err;
  EXPECT_THAT(text_of(folder_ / "b.svg"), testing::Not(HasSubstr(">exact<")));
}

TEST_F(MotionFile, IsPlayedByAPageBesideTheExactMotion) {
  std::ofstream(folder_ / "t.html")
      << "{{title}}{{title}}<!-- twrench:poster --><!-- twrench:scene -->";
  const std::string page = "page --template t.html --lab -o a.html --motion run.csv --from 0.5 ";
  const Outcome run = run_twrench(folder_, page + "tennis-racket --inverse --overwrite");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string html = text_of(folder_ / "a.html");
  const std::size_t begin = html.find("id=\"scene\">") + 11;
  const auto data = nlohmann::json::parse(html.substr(begin, html.find("</script>") - begin));
  EXPECT_EQ(data["recording"]["file"], "run.csv");
  EXPECT_DOUBLE_EQ(data["recording"]["duration"], 1.5);
  EXPECT_EQ(data["recording"]["options"],
            nlohmann::json({"--motion", "run.csv", "--from", "0.5", "--inverse"}));
  EXPECT_NE(data["attitude"], nlohmann::json({1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_LE(data["scene"]["motion"]["duration"], 1.5);
  const Outcome unknown = run_twrench(folder_, "page --template t.html -o b.html --motion run.csv");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("run.csv: a page shows the exact motion beside it, and the "
                                     "body is not given"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b.html"));
}

/// The verdict is that of a check.
TEST_F(MotionFile, OfAnotherUnitIsToldSo) {
  std::ofstream rows(folder_ / "deg.csv");
  std::istringstream lines(
      run_twrench(folder_, "simulate tennis-racket --method exact --duration 2 --fps 500").out);
  std::string line;
  std::getline(lines, line);
  rows << "t,wx,wy,wz\n";
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; std::getline(cells, cell, ','); ++i) {
      if (i == 0) rows << cell;
      if (i >= 10 && i < 13) rows << ',' << std::stod(cell) * 180 / std::numbers::pi;
    }
    rows << '\n';
  }
  rows.close();
  const Outcome run = run_twrench(
      folder_,
      "render tennis-racket --motion deg.csv --size 160x90 --frames 0 --no-video --frames-dir g");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("it does if the rates are in deg/s: use --units deg\n"));
  EXPECT_THAT(run.err, HasSubstr("so these are left out: momentum"));
}

TEST_F(MotionFile, WithGapsMarksThem) {
  std::ofstream rows(folder_ / "gap.csv");
  rows << "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n9,1,0,0,0\n10,1,0,0,0\n";
  rows.close();
  const Outcome run = run_twrench(
      folder_, "render --motion gap.csv --size 160x90 --frames 0,300 --no-video --frames-dir g");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("gap.csv has 1 gap of more than four intervals"));
  const Outcome model = run_twrench(folder_, "export --motion gap.csv -o a.glb");
  EXPECT_EQ(model.code, 2);
  EXPECT_THAT(model.err, HasSubstr("leave them out by --from and --to, or write .csv"));
}

TEST_F(MotionFile, IsNoMotionOfAllBuiltInScenes) {
  const Outcome run = run_twrench(folder_, "page --all --motion run.csv -o site");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, testing::StartsWith("twrench: error: --all: takes all built-in scenes, and "
                                           "--motion is a recording of one body"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "site"));
}

/// The same folder with a scene in scenes/toss.toml, which names the recording beside it.
class OwnRecording : public MotionFile {
 protected:
  OwnRecording() {
    std::filesystem::create_directory(folder_ / "scenes");
    std::filesystem::rename(folder_ / "run.csv", folder_ / "scenes/run.csv");
    write_scene("");
  }

  /// Writes the scene with more lines in [motion].
  void write_scene(const std::string& lines) const {
    std::ofstream(folder_ / "scenes/toss.toml")
        << "title = 'A toss'\n[body]\nmoments = [2, 3, 4.5]\n[motion]\nfile = 'run.csv'\n"
        << lines;
  }

  Outcome run(const std::string& words) const { return run_twrench(folder_, words); }

  Outcome film(const std::string& options) const {
    return run(
        "render scenes/toss.toml --size 160x90 --progress none --frames 0-4 --no-video "
        "--frames-dir f " +
        options);
  }

  nlohmann::json scene_of_film() const {
    return nlohmann::json::parse(text_of(folder_ / "f/manifest.json"))["scene"];
  }
};

TEST_F(OwnRecording, IsPlayedByEveryCommandThatShowsAMotion) {
  ASSERT_EQ(film("").code, 0);
  const auto recording = scene_of_film()["motion"]["recording"];
  EXPECT_EQ(recording["file"], "run.csv") << "as the scene file gives it, from any folder";
  EXPECT_EQ(scene_of_film()["motion"]["duration"], 2);
  EXPECT_EQ(scene_of_film()["title"], "A toss");

  const Outcome rows = run("simulate scenes/toss.toml --times 0,1");
  ASSERT_EQ(rows.code, 0) << rows.err;
  EXPECT_EQ(rows.out, run("simulate --inertia 2,3,4.5 --motion scenes/run.csv --times 0,1").out);
  EXPECT_EQ(run("export scenes/toss.toml -o a.aem").code, 0);
  EXPECT_THAT(text_of(folder_ / "a.aem"), HasSubstr("run.csv"));
  ASSERT_EQ(run("plot scenes/toss.toml -o a.svg").code, 0);
  EXPECT_THAT(text_of(folder_ / "a.svg"), HasSubstr(">exact<"));
  std::ofstream(folder_ / "t.html")
      << "{{title}}{{title}}<!-- twrench:poster --><!-- twrench:scene -->";
  const Outcome page = run("page scenes/toss.toml --template t.html --lab -o a.html");
  ASSERT_EQ(page.code, 0) << page.err;
  EXPECT_THAT(text_of(folder_ / "a.html"), HasSubstr("\"recording\":{\"file\":\"run.csv\""));
  EXPECT_THAT(text_of(folder_ / "a.html"), HasSubstr("\"options\":[]")) << "the file names it";
}

TEST_F(OwnRecording, IsReadAsTheSceneAndThenTheOptionsSay) {
  write_scene("from = 0.5\nto = 1.5\nunits = 'deg'\ninverse = true\noffset = [1, 0, 0, 0]\n");
  ASSERT_EQ(film("").code, 0);
  const auto recording = scene_of_film()["motion"]["recording"];
  EXPECT_EQ(recording["units"], "deg");
  EXPECT_EQ(recording["inverse"], true);
  EXPECT_EQ(scene_of_film()["motion"]["duration"], 1);
  ASSERT_EQ(film("--units rad --to 1.76 --overwrite").code, 0);
  const auto changed = scene_of_film()["motion"]["recording"];
  EXPECT_EQ(changed["units"], "rad");
  EXPECT_EQ(changed["from"], 0.5);
  EXPECT_EQ(changed["to"], 1.76);
  EXPECT_EQ(scene_of_film()["motion"]["duration"], 1.26);
  EXPECT_NE(changed["sha256"], recording["sha256"]);
}

TEST_F(OwnRecording, KeepsTheTimesOfItsSceneAndGivesWayToAnother) {
  write_scene("duration = 1\n[film]\nspeed = 0.25\n");
  ASSERT_EQ(film("").code, 0);
  EXPECT_EQ(scene_of_film()["motion"]["duration"], 1);
  EXPECT_EQ(scene_of_film()["film"]["speed"], 0.25);
  std::filesystem::copy_file(folder_ / "scenes/run.csv", folder_ / "other.csv");
  ASSERT_EQ(film("--motion other.csv --from 0.5 --overwrite").code, 0);
  EXPECT_EQ(scene_of_film()["motion"]["recording"]["file"], "other.csv");
  EXPECT_EQ(scene_of_film()["motion"]["duration"], 1.5) << "the times suit the other motion";
}

TEST_F(OwnRecording, IsAnInputOfEveryCommand) {
  const std::string before = text_of(folder_ / "scenes/run.csv");
  for (const char* command : {"simulate scenes/toss.toml", "export scenes/toss.toml",
                              "inertia scenes/toss.toml --format json",
                              "check scenes/run.csv --scene scenes/toss.toml"}) {
    const Outcome refused = run(std::string(command) + " -o scenes/run.csv --overwrite");
    EXPECT_EQ(refused.code, 2) << command << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("is an input of this command")) << command;
  }
  EXPECT_EQ(text_of(folder_ / "scenes/run.csv"), before);
}

TEST_F(OwnRecording, IsRefusedByWhatComputesMotions) {
  for (const char* command : {"study", "report -o a.md"}) {
    const Outcome refused = run(std::string(command) + " scenes/toss.toml");
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_THAT(refused.err,
                HasSubstr("twrench: error: toss: the motion is recorded in run.csv, and a "));
    EXPECT_THAT(refused.err, HasSubstr("use a scene whose [motion] has omega instead of file"));
  }
  const Outcome body = run("inertia scenes/toss.toml --format json");
  EXPECT_EQ(body.code, 0) << body.err;
  EXPECT_THAT(body.out, testing::Not(HasSubstr("\"phase\""))) << "it has no initial rates";
  EXPECT_EQ(run("check scenes/run.csv --scene tennis-racket").code, 0);
  const Outcome omega = film("--omega 1,2,3");
  EXPECT_EQ(omega.code, 2);
  EXPECT_THAT(omega.err, HasSubstr("--omega: the motion is recorded in run.csv"));
}

TEST_F(OwnRecording, ThatCannotBePlayedIsNamed) {
  write_scene("duration = 3\n");
  EXPECT_THAT(film("").err, HasSubstr("it lasts 2 s, but 3 s are to be shown"));
  write_scene("from = 5\n");
  EXPECT_THAT(film("").err, testing::StartsWith("twrench: error: scenes/run.csv: "));
  write_scene("");
  std::ofstream(folder_ / "scenes/run.csv") << "no table";
  const Outcome text = film("");
  EXPECT_EQ(text.code, 2);
  EXPECT_THAT(text.err, testing::StartsWith("twrench: error: scenes/run.csv: ")) << text.err;
  std::filesystem::remove(folder_ / "scenes/run.csv");
  const Outcome none = film("");
  EXPECT_EQ(none.code, 5);
  EXPECT_THAT(none.err, HasSubstr("scenes/run.csv: No such file")) << none.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f"));
}

// Its author can write a key; a user of the option --motion cannot.
TEST_F(OwnRecording, ThatIsReadInSeveralWaysProposesKeysOfItsScene) {
  const auto remedy = [&](const char* columns) {
    std::ofstream(folder_ / "scenes/run.csv") << columns << "\n0,0.1,0.2,0.3\n1,0.2,0.3,0.4\n";
    return run("simulate scenes/toss.toml").err;
  };
  EXPECT_THAT(
      remedy("t,yaw,pitch,roll"),
      testing::ContainsRegex("say which: sequence = \"zyx\"; or sequence = .*, in \\[motion] of "
                             "the scene\n$"));
  EXPECT_THAT(remedy("t,a,b,c"),
              HasSubstr("\n  columns = \"t=NAME,wx=NAME,wy=NAME,wz=NAME\" in [motion] of the scene "
                        "names them; its columns are: t, a, b, c\n"));
  EXPECT_THAT(remedy("t,wx,wy,q"),
              HasSubstr("\n  columns = \"wz=NAME\" in [motion] of the scene "));
  EXPECT_THAT(run("simulate --inertia 2,3,4.5 --motion scenes/run.csv").err,
              HasSubstr("\n  --columns wz=NAME names it; "));
}

/// No free motion of a rigid body can be compared with it.
TEST_F(OwnRecording, OfABodyWithAWheelIsShownWithoutAFreeMotion) {
  write_scene("wheel = [0, 0, 5]\n");
  const Outcome shown = film("");
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_THAT(shown.err, HasSubstr("no free motion of this body can be fitted to scenes/run.csv"));
}

}  // namespace
}  // namespace twrench
