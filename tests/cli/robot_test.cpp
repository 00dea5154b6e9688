// `twrench` on the links of robot descriptions.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/twrench.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class RobotFile : public testing::Test {
 protected:
  RobotFile() { write("arm.urdf", arm); }

  void write(const std::string& name, const std::string& text) {
    system::write_file_atomically(folder_ / name, text);
  }

  Outcome run(const std::string& arguments) { return run_twrench(folder_, arguments); }

  // A box, a rod whose products of inertia have the other sign, a link that no body has, one whose
  // mesh is missing, and a frame.
  const std::string arm =
      "<robot name=\"arm\">\n"
      "<link name=\"box\"><inertial><mass value=\"12\"/>"
      "<inertia ixx=\"13\" ixy=\"0\" ixz=\"0\" iyy=\"10\" iyz=\"0\" izz=\"5\"/></inertial>"
      "<visual><geometry><box size=\"1 2 3\"/></geometry></visual></link>\n"
      "<link name=\"rod\"><inertial><mass value=\"12\"/>\n"
      "<inertia ixx=\"11.5\"  ixy='1.5' ixz=\"0.0\" iyy=\"11.5\" iyz=\"0\" izz=\"5\"/></inertial>"
      "<visual><origin rpy=\"0 0 -0.7853981633974483\"/>"
      "<geometry><box size=\"1 2 3\"/></geometry></visual></link>\n"
      "<link name=\"flat\"><inertial><mass value=\"1\"/>"
      "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"3\"/></inertial></link>\n"
      "<link name=\"lost\"><visual><geometry><mesh filename=\"package://a/b.stl\"/></geometry>"
      "</visual></link>\n"
      "</robot>\n";
  ScratchFolder folder_;
};

TEST_F(RobotFile, IsJudgedLinkByLinkTheWorstFirst) {
  const Outcome text = run("inertia arm.urdf");
  EXPECT_EQ(text.code, 1) << text.err;
  EXPECT_THAT(text.out, StartsWith("URDF arm, 4 links: 1 impossible, 1 doubtful, 1 good, 1 "));
  EXPECT_LT(text.out.find("\nflat "), text.out.find("\nrod "));
  EXPECT_LT(text.out.find("\nrod "), text.out.find("\nbox "));
  EXPECT_THAT(text.out, HasSubstr("  the products of inertia have the other sign: without this the "
                                  "moments are those of its visual geometry to"));
  EXPECT_THAT(text.err, HasSubstr("arm.urdf: a mesh was not found: 'package://a/b.stl'; name the "
                                  "folder that contains the packages: --package-path DIR"));
  const json notes = json::parse(run("inertia arm.urdf --format json").out)["notes"];
  EXPECT_THAT(notes.at(0), HasSubstr("packages: --package-path DIR"));
}

TEST_F(RobotFile, RefusesPackagesThatAreNoFolders) {
  for (const char* place : {"nowhere", "arm.urdf"}) {
    const Outcome refused = run(fmt::format("inertia arm.urdf --package-path {}", place));
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err,
                HasSubstr(fmt::format("--package-path {}: there is no such folder", place)));
  }
}

TEST_F(RobotFile, HasAFewWarnings) {
  std::string text = "<sdf version='1.9'><model name='m'>";
  for (int i = 0; i < 23; ++i)
    text += fmt::format("<link name='{}'><inertial><mass>2</mass></inertial></link>", i);
  write("m.sdf", text + "</model></sdf>");
  const Outcome some = run("inertia m.sdf --format json");
  EXPECT_EQ(std::ranges::count(some.err, '\n'), 21);
  EXPECT_THAT(some.err, HasSubstr("m.sdf: 3 other notes are not shown; see them all with inertia "
                                  "--format json"));
  EXPECT_EQ(json::parse(some.out)["notes"].size(), 23U);
}

TEST_F(RobotFile, HasATableWhoseColumnsFit) {
  const std::string rest =
      "\"><inertial><mass value=\"1\"/><inertia ixx=\"0.0102068936147596\" ixy=\"0\" ixz=\"0\" "
      "iyy=\"1\" iyz=\"0\" izz=\"0.0704821466878227\"/></inertial></link>";
  write("long.urdf", "<robot name=\"r\"><link name=\"a" + rest + "<link name=\"" +
                         std::string(40, 'b') + rest + "</robot>");
  const std::string text = run("inertia long.urdf").out;
  const auto column = [&](const std::string& row) {
    const std::size_t begin = text.find("\n" + row + " ");
    return text.find(row == "link" ? "verdict" : "impossible", begin) - begin;
  };
  EXPECT_EQ(column("a"), column("link"));
  EXPECT_EQ(column(std::string(40, 'b')), column("link"));
}

TEST_F(RobotFile, IsJudgedForPrograms) {
  const json found = json::parse(run("inertia arm.urdf --format json").out);
  EXPECT_EQ(found["counts"]["impossible"], 1);
  EXPECT_EQ(found["links"][0]["name"], "flat");
  EXPECT_EQ(found["links"][0]["faults"][0]["fault"], "triangle");
  EXPECT_EQ(found["links"][1]["mistakes"][0]["fault"], "products_sign");
  const Outcome junit = run("inertia arm.urdf -o result.xml");
  EXPECT_EQ(junit.code, 1);
  EXPECT_THAT(text_of(folder_ / "result.xml"),
              AllOf(HasSubstr("tests=\"4\" failures=\"1\""),
                    HasSubstr("<failure type=\"impossible\" message=\"impossible: the greatest")));
  // Its own result may be replaced.
  EXPECT_EQ(run("inertia arm.urdf -o result.xml").code, 1);
}

TEST_F(RobotFile, HasLinksThatAreBodies) {
  const json link = json::parse(run("inertia arm.urdf --link box --si --format json").out);
  EXPECT_EQ(link["mass"], 12);
  EXPECT_EQ(link["principal_moments"], json({5, 10, 13}));
  const Outcome motion = run("simulate arm.urdf --link box --times 0,1 --format json");
  EXPECT_EQ(motion.code, 0) << motion.err;
  const Outcome frame =
      run("render arm.urdf --link rod --show inertia --length 0.1 --size 64x36 "
          "--frames-dir f --no-video");
  EXPECT_EQ(frame.code, 0) << frame.err;
  EXPECT_THAT(run("render arm.urdf -o v.mp4").err,
              HasSubstr("--link NAME, which is one of box, rod, flat, lost"));
  EXPECT_THAT(run("render arm.urdf --link bx -o v.mp4").err, HasSubstr("did you mean 'box'"));
  EXPECT_THAT(run("inertia arm.urdf --link lost").err,
              HasSubstr("link 'lost': it has no mass properties"));
}

TEST_F(RobotFile, IsRepairedByteForByteElsewhere) {
  const Outcome fix = run("inertia arm.urdf --fix fixed.urdf -o report.txt");
  EXPECT_EQ(fix.code, 1);
  EXPECT_THAT(fix.err, AllOf(HasSubstr("rod: the products of inertia have the other sign\n"),
                             HasSubstr("flat: the greatest principal moment, 3 kg m^2, exceeds"),
                             HasSubstr("2 links repaired, 0 not; wrote fixed.urdf")));
  // Three numbers differ, and nothing else.
  std::string expected = arm;
  const auto replace = [&](const std::string& old, const std::string& text) {
    expected.replace(expected.find(old), old.size(), text);
  };
  replace("'1.5'", "'-1.5'");
  replace("ixx=\"1\"", "ixx=\"1.500003\"");
  replace("iyy=\"1\"", "iyy=\"1.500003\"");
  EXPECT_EQ(text_of(folder_ / "fixed.urdf"), expected);
  EXPECT_EQ(run("inertia fixed.urdf").code, 0);
  // Neither the input nor another file is replaced.
  EXPECT_EQ(run("inertia arm.urdf --fix arm.urdf").code, 2);
  EXPECT_EQ(run("inertia arm.urdf --fix fixed.urdf").code, 5);
  EXPECT_EQ(run("inertia arm.urdf --fix fixed.urdf --overwrite").code, 1);
  EXPECT_EQ(run("inertia arm.urdf --fix fixed.sdf").code, 2);
  EXPECT_EQ(text_of(folder_ / "arm.urdf"), arm);
}

TEST_F(RobotFile, HasAPageWithPicturesOfBadLinks) {
  const Outcome page = run("inertia arm.urdf --report arm.html");
  EXPECT_EQ(page.code, 1) << page.err;
  const std::string html = text_of(folder_ / "arm.html");
  EXPECT_THAT(html, AllOf(StartsWith("<!doctype html>"), HasSubstr("<h2>flat "),
                          HasSubstr("<h2>rod "), Not(HasSubstr("<h2>box "))));
  std::size_t pictures = 0;  // two of each, before and after the repair
  for (std::size_t at = 0; (at = html.find("<img ", at)) != std::string::npos; ++at) ++pictures;
  EXPECT_EQ(pictures, 4U);
  EXPECT_EQ(run("inertia arm.urdf --report arm.html").code, 1);
  EXPECT_EQ(run("inertia arm.urdf --report arm.txt").code, 2);
}

// Those of thousands of links would take hours. Without a mass, none is drawn here.
TEST_F(RobotFile, HasPicturesOfTheWorstLinks) {
  const auto page = [&](int links) {
    std::string text = "<robot name='r'>";
    for (int i = 0; i < links; ++i) {
      text += fmt::format(
          "<link name='{}'><inertial><mass value='0'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' "
          "iyz='0' izz='1'/></inertial></link>",
          i);
    }
    write("many.urdf", text + "</robot>");
    EXPECT_EQ(run("inertia many.urdf --report many.html").code, 1);
    return text_of(folder_ / "many.html");
  };
  EXPECT_THAT(page(50), Not(HasSubstr("left out")));
  EXPECT_THAT(page(53),
              HasSubstr("The worst links have pictures; those of 3 others are left out."));
}

TEST_F(RobotFile, MixesNoOutputsInStandardOutput) {
  const Outcome mixed = run("inertia arm.urdf --fix -");
  EXPECT_EQ(mixed.code, 2);
  EXPECT_THAT(mixed.err, HasSubstr("--fix -: standard output is used for the results"));
  const Outcome fixed = run("inertia arm.urdf --fix - -o report.txt");
  EXPECT_EQ(fixed.code, 1) << fixed.err;
  EXPECT_THAT(fixed.out, StartsWith("<robot name=\"arm\">"));
}

TEST_F(RobotFile, HasAReportOfNumbersThatCannotBeDrawn) {
  for (const char* number : {"1e308", "1e40", "1e-80"}) {
    const std::string moments = fmt::format(
        "ixx='{0}' ixy='0' ixz='0' iyy='{0}' iyz='0' "
        "izz='{0}'",
        number);
    write("extreme.urdf",
          fmt::format("<robot name='r'><link name='l'><inertial><mass value='{}'/>"
                      "<inertia {}/></inertial><visual><geometry><box size='1 2 3'/>"
                      "</geometry></visual></link></robot>",
                      number, moments));
    for (const char* from : {"", " --from-mesh"}) {
      const Outcome page = run(fmt::format("inertia extreme.urdf --report r.html{}", from));
      EXPECT_THAT(page.code, testing::AnyOf(0, 1)) << number << page.err;
      EXPECT_THAT(text_of(folder_ / "r.html"), HasSubstr("<h2>l ")) << number;
    }
  }
}

TEST_F(RobotFile, RefusesOptionsThatHaveNoMeaning) {
  EXPECT_THAT(run("inertia arm.urdf --from-mesh").err,
              HasSubstr("add --fix FILE or --report FILE"));
  EXPECT_THAT(run("inertia phone --fix a.urdf").err, HasSubstr("--fix: is for the links"));
  EXPECT_THAT(run("inertia phone --format junit").err, HasSubstr("is for the links"));
  EXPECT_THAT(run("inertia phone --link a").err, HasSubstr("--link: is for a robot description"));
  EXPECT_THAT(run("inertia arm.urdf --inertia 1,2,3").err, HasSubstr("arm.urdf: only the values"));
  for (const char* words : {"inertia arm.urdf --from-mesh", "inertia phone --fix a.urdf",
                            "inertia phone --format junit", "inertia phone --link a",
                            "inertia arm.urdf --inertia 1,2,3", "inertia arm.urdf --unit mm"}) {
    EXPECT_EQ(run(words).code, 2) << words;
  }
}

}  // namespace
}  // namespace twrench
