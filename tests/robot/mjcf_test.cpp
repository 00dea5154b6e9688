#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "robot/compiled.h"
#include "robot/samples.h"

// mujoco_test.cpp compares the numbers with those of MuJoCo.

namespace twrench::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string mjcf_of(const std::string& bodies, const std::string& sections = {}) {
  return "<mujoco model='m'>\n" + sections + "<worldbody>\n" + bodies + "</worldbody></mujoco>\n";
}

Robot mjcf(const std::string& bodies, const std::string& sections = {}) {
  return RobotFile(mjcf_of(bodies, sections), "robot.xml").read();
}

std::string mjcf_refusal(const std::string& bodies, const std::string& sections = {}) {
  return RobotFile(mjcf_of(bodies, sections), "robot.xml").refusal();
}

std::string body_of(const std::string& inside) {
  return "<body name='arm'>\n" + inside + "</body>\n";
}

std::string text_of(const Robot& robot, const Span& span) {
  return robot.text.substr(span.begin, span.size);
}

TEST(Mjcf, KnowsThePlaceOfEachNumber) {
  const Robot robot =
      mjcf(body_of("<inertial pos='0.1 +2e-1 -.3' mass='2.50'\r\n"
                   "  fullinertia='1 2 3\r\n 0.1 0.2 0.30'/>"));
  EXPECT_EQ(robot.format, Format::mjcf);
  EXPECT_EQ(robot.name, "m");
  const Inertial& read = *robot.link("arm").inertial;
  EXPECT_EQ(text_of(robot, *read.mass.place), "2.50");
  EXPECT_EQ(text_of(robot, *read.centre[1].place), "+2e-1");
  EXPECT_EQ(text_of(robot, *read.entries[zz].place), "3");
  EXPECT_EQ(read.entries[xy].value, 0.1);
  EXPECT_EQ(read.entries[xz].value, 0.2);
  EXPECT_EQ(text_of(robot, *read.entries[yz].place), "0.30");
  EXPECT_FALSE(read.diagonal);
  EXPECT_TRUE(read.rotations.empty());
}

TEST(Mjcf, KnowsTheAttributesOfADiagonalMatrix) {
  const Robot robot =
      mjcf(body_of("<inertial pos='0 0 0' euler='0 0 90' mass='1' diaginertia='1 2 2.5'/>"));
  const Inertial& read = *robot.link("arm").inertial;
  EXPECT_EQ(text_of(robot, *read.diagonal), " diaginertia='1 2 2.5'");
  ASSERT_EQ(read.rotations.size(), 1U);
  EXPECT_EQ(text_of(robot, read.rotations.front()), " euler='0 0 90'");
  EXPECT_EQ(read.matrix().diagonal(), Eigen::Vector3d(1, 2, 2.5));
  EXPECT_FALSE(read.entries[xy].place);
  EXPECT_NEAR(read.inertia()(0, 0), 2, 1e-15);
}

TEST(Mjcf, NamesBodiesAndTheirParents) {
  const Robot robot = mjcf(
      "<geom type='plane'/><body name='a'><frame><body/><body/></frame>\n"
      "<body name='b'/></body>");
  std::vector<std::string> names;
  for (const Link& link : robot.links) names.push_back(link.name + " in " + link.parent);
  EXPECT_THAT(names,
              ElementsAre("a in ", "body at line 3 in a", "body at line 3 (2) in a", "b in a"));
}

// A body that states its mass properties may have other geoms for the eye than for collisions.
TEST(Mjcf, TellsVisualGeomsFromOthers) {
  const std::string geoms =
      "<geom type='box' size='1 2 3' contype='0' conaffinity='0' mass='9'/>"
      "<geom size='1' contype='0'/><geom size='1'/>";
  const Robot stated =
      mjcf(body_of("<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>" + geoms));
  const std::vector<Geometry>& read = stated.link("arm").geometries;
  EXPECT_FALSE(stated.link("arm").is_from_geometry);
  EXPECT_EQ(read[0].use, Geometry::Use::visual);
  EXPECT_EQ(read[1].use, Geometry::Use::collision);
  EXPECT_EQ(read[2].use, Geometry::Use::collision);
  EXPECT_FALSE(read[0].mass || read[0].density || read[1].density);
  EXPECT_EQ(std::get<body::Box>(std::get<body::Shape>(read[0].shape)).size,
            Eigen::Vector3d(200, 400, 600));

  const Robot follows = mjcf(body_of(geoms));
  EXPECT_TRUE(follows.link("arm").is_from_geometry);
  EXPECT_FALSE(follows.link("arm").inertial);
  for (const Geometry& geometry : follows.link("arm").geometries)
    EXPECT_EQ(geometry.use, Geometry::Use::collision);
  EXPECT_EQ(follows.link("arm").geometries[0].mass, 9.0);
  EXPECT_EQ(follows.link("arm").geometries[1].density, 1000.0);
}

TEST(Mjcf, NamesWhatItIgnores) {
  const Robot robot = mjcf(
      body_of("<geom type='hfield' hfield='h'/>\n<geom type='box' mesh='inline'/>\n"
              "<geom type='mesh' mesh='inline'/>\n<composite type='cable'/>\n"
              "<replicate count='3'><body/></replicate>\n<attach model='x'/>\n<flexcomp/>\n"),
      "<compiler fusestatic='true'/><asset><mesh name='inline' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/>\n"
      "<mesh file='a.stl' scale='1 2 3' refquat='0 1 0 0'/><mesh file='b.stl' inertia='convex'/>"
      "</asset>\n");
  EXPECT_THAT(
      robot.notes,
      ElementsAre(
          HasSubstr("robot.xml:2: compiler: fusestatic is ignored"),
          HasSubstr("robot.xml:2: mesh: mesh 'inline' is ignored, because it names no mesh file"),
          HasSubstr("robot.xml:3: mesh: mesh 'a' is ignored, because it has both refquat"),
          HasSubstr("mesh 'b' counts as it is, not as its convex hull"),
          HasSubstr("robot.xml:9: composite: <composite> and the bodies that it makes"),
          HasSubstr("robot.xml:10: replicate: <replicate>"), HasSubstr("attach: <attach>"),
          HasSubstr("flexcomp: <flexcomp>"), HasSubstr("geom: a hfield is ignored"),
          HasSubstr("geom: a box that is fitted to a mesh is ignored")));
  Meshes meshes(robot, {});
  const LinkGeometry geometry(robot.links.front(), meshes);
  EXPECT_FALSE(geometry.is_known());
  EXPECT_FALSE(compiled(robot, {geometry}).front());
}

TEST(Mjcf, ReportsFaultsThatTheCompilerHides) {
  const std::string flawed = body_of("<inertial pos='0 0 0' mass='1' diaginertia='1 2 6'/>");
  EXPECT_THAT(
      mjcf(flawed, "<compiler balanceinertia='true'/>\n").notes,
      ElementsAre(HasSubstr("robot.xml:5: body 'arm': balanceinertia hides that the moments "
                            "1, 2 and 6 kg m^2 violate the triangle inequality: MuJoCo "
                            "replaces each by their mean, 3 kg m^2")));
  EXPECT_THAT(mjcf(flawed, "<compiler boundmass='2'/>").notes,
              ElementsAre(HasSubstr("boundmass raises the mass from 1 kg to 2 kg")));
  EXPECT_THAT(mjcf(flawed, "<compiler boundinertia='3'/>").notes,
              ElementsAre(HasSubstr("boundinertia raises the moment 1 kg m^2 to 3 kg m^2")));
  EXPECT_THAT(mjcf(flawed, "<compiler settotalmass='3'/>").notes,
              ElementsAre(HasSubstr("settotalmass scales all masses and moments to a total of 3")));
  EXPECT_THAT(mjcf(body_of("<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/><geom size='1'/>"),
                   "<compiler inertiafromgeom='true'/>")
                  .notes,
              ElementsAre(HasSubstr("replaces its <inertial> by that of its geoms")));
  EXPECT_THAT(mjcf(flawed).notes, ElementsAre());
  EXPECT_EQ(mjcf(flawed, "<compiler balanceinertia='true'/>").link("arm").inertial->matrix()(2, 2),
            6.0);
}

TEST(Mjcf, IsTheOnlyFormatThatIsCompiled) {
  const RobotFile file(
      "<sdf><model name='m'><link name='l'><inertial><mass>-1</mass></inertial>"
      "</link></model></sdf>",
      "robot.sdf");
  const auto mass_of = [](const Robot& robot) {
    Meshes meshes(robot, {});
    return compiled(robot, {LinkGeometry(robot.links.front(), meshes)}).front()->mass;
  };
  EXPECT_EQ(mass_of(file.read()), -1.0);
  const Robot robot = mjcf(body_of("<inertial pos='0 0 0' mass='-1' diaginertia='1 1 1'/>"));
  EXPECT_EQ(mass_of(robot), 0.0);
  EXPECT_THAT(robot.notes, ElementsAre());
}

TEST(Mjcf, IncludesOtherFilesWithoutBodies) {
  const RobotFile file(mjcf_of(body_of("<geom class='c'/>"), "<include file='parts/a.xml'/>"),
                       "robot.xml");
  std::filesystem::create_directory(file.folder() / "parts");
  const auto write = [&](const std::string& text) {
    std::ofstream(file.folder() / "parts/a.xml", std::ios::binary) << text;
  };
  write("<x><default><default class='c'><geom size='0.3'/></default></default></x>");
  const Robot robot = file.read();
  EXPECT_EQ(
      std::get<body::Ellipsoid>(std::get<body::Shape>(robot.link("arm").geometries.front().shape))
          .radii[0],
      30);
  EXPECT_EQ(robot.others, std::vector{file.folder() / "parts/a.xml"});

  write("<x>\n<worldbody><body/></worldbody></x>");
  EXPECT_THAT(file.refusal(),
              HasSubstr("2 parts/a.xml:2: body: it is in an included file, but only "
                        "bodies of the file itself are read; give the file with "
                        "the bodies itself"));
  write("<x><include file='robot.xml'/></x>");
  EXPECT_THAT(file.refusal(), HasSubstr("robot.xml' is included already"));
  write("<x><include file='parts/a.xml'/></x>");
  EXPECT_THAT(file.refusal(), HasSubstr("parts/a.xml' is included already"));
  write("<x>");
  EXPECT_THAT(file.refusal(), HasSubstr("parts/a.xml: the XML document is cut off or damaged"));
  std::filesystem::remove(file.folder() / "parts/a.xml");
  EXPECT_THAT(file.refusal(), HasSubstr("5 cannot read parts/a.xml"));
}

TEST(Mjcf, RefusesPartsThatOtherFilesInclude) {
  for (const char* part : {"<mujoco><default><geom size='1'/></default></mujoco>",
                           "<mujocoinclude><body><geom size='1'/></body></mujocoinclude>"}) {
    EXPECT_THAT(RobotFile(part, "part.xml").refusal(),
                HasSubstr("2 part.xml: it has no <worldbody>, like a part that another file "
                          "includes; give the file that includes it"));
  }
}

TEST(Mjcf, RefusesWhatItCannotRead) {
  const auto inertial = [](const std::string& attributes) {
    return mjcf_refusal(body_of("<inertial " + attributes + "/>"));
  };
  EXPECT_THAT(inertial("mass='1'"),
              HasSubstr("2 robot.xml:4: inertial: it has no attribute 'pos'"));
  EXPECT_THAT(inertial("pos='0 0 0'"), HasSubstr("it has no attribute 'mass'"));
  EXPECT_THAT(inertial("pos='0 0' mass='1'"), HasSubstr("pos has 2 numbers instead of 3"));
  EXPECT_THAT(inertial("pos='0 0 0' mass='1,5'"), HasSubstr("write 1.5"));
  EXPECT_THAT(inertial("pos='0 0 0' mass='1' fullinertia='1 1 1 0 0 0' quat='1 0 0 0'"),
              HasSubstr("fullinertia excludes diaginertia and a rotation"));
  EXPECT_THAT(inertial("pos='0 0 0' mass='1' euler='0 0 0' quat='1 0 0 0'"),
              HasSubstr("it states its rotation twice"));
  EXPECT_THAT(inertial("pos='0 0 0' mass='1' quat='0 0 0 0'"), HasSubstr("quaternion is zero"));
  EXPECT_THAT(inertial("pos='0 0 0' mass='1' zaxis='0 0 0'"), HasSubstr("axis of its rotation"));
  EXPECT_THAT(inertial("pos='0 0 0' mass='1' euler='nan 0 0'"), HasSubstr("euler is not finite"));
  EXPECT_THAT(inertial("pos='0 0 0' mass='1' xyaxes='1 0 0 2 0 0'"),
              HasSubstr("axis of its rotation"));
  EXPECT_THAT(mjcf_refusal(body_of("<inertial pos='0 0 0' mass='1'/>\n"
                                   "<inertial pos='0 0 0' mass='1'/>")),
              HasSubstr("robot.xml:5: inertial: its body has another one"));
  EXPECT_THAT(mjcf_refusal(body_of("<frame pos='1 0 0'><inertial pos='0 0 0' mass='1'/></frame>")),
              HasSubstr("move it out of the <frame>"));
  EXPECT_THAT(mjcf_refusal("<body name='a'/>\n<body name='a'/>"),
              HasSubstr("line 3 has a link of the same name"));
  EXPECT_THAT(mjcf_refusal("<geom size='1'/>"), HasSubstr("it has no links"));
  EXPECT_THAT(mjcf_refusal(body_of(""), "<compiler coordinate='global'/>"),
              HasSubstr("coordinate is 'global'"));
  EXPECT_THAT(mjcf_refusal(body_of(""), "<compiler angle='degrees'/>"),
              HasSubstr("angle is 'degrees'; MJCF has degree, radian"));
  EXPECT_THAT(mjcf_refusal(body_of(""), "<compiler eulerseq='xy'/>"),
              HasSubstr("it has three of the letters"));
  EXPECT_THAT(mjcf_refusal(body_of(""), "<compiler inertiagrouprange='1'/>"),
              HasSubstr("inertiagrouprange has 1 numbers instead of 2"));
}

TEST(Mjcf, RefusesGeomsAndDefaultsThatItCannotRead) {
  const auto geom = [](const std::string& attributes, const std::string& sections = {}) {
    return mjcf_refusal(body_of("<geom " + attributes + "/>"), sections);
  };
  EXPECT_THAT(geom(""), HasSubstr("2 robot.xml:4: geom: a length is 0 m"));
  EXPECT_THAT(geom("size='inf'"), HasSubstr("a length is inf m"));
  EXPECT_THAT(geom("size='1 2 3 4'"), HasSubstr("size has 4 numbers"));
  EXPECT_THAT(geom("type='bx'"), HasSubstr("unknown name 'bx'"));
  EXPECT_THAT(geom("type='mesh' mesh='b'"), HasSubstr("robot.xml:4: geom: mesh: unknown name 'b'"));
  EXPECT_THAT(geom("size='1' class='b'"), HasSubstr("geom: class: unknown name 'b'"));
  EXPECT_THAT(geom("size='1' mass='-1'"), HasSubstr("its mass or density is negative"));
  EXPECT_THAT(geom("size='1' fromto='0 0 0 0 0 1'"),
              HasSubstr("a sphere has no attribute 'fromto'"));
  EXPECT_THAT(geom("type='capsule' size='1' fromto='0 0 1 0 0 1'"),
              HasSubstr("an axis of its rotation is zero"));
  EXPECT_THAT(geom("size='1'", "<default><default/></default>"),
              HasSubstr("default: it has no attribute 'class'"));
  EXPECT_THAT(geom("size='1'", "<default><default class='a'/><default class='a'/></default>"),
              HasSubstr("class 'a' is defined twice"));
  EXPECT_THAT(geom("size='1'", "<asset><mesh file='a.stl'/><mesh name='a' file='b.stl'/></asset>"),
              HasSubstr("mesh 'a' is defined twice"));
  EXPECT_THAT(geom("size='1'", "<include/>"), HasSubstr("include: it has no attribute 'file'"));
}

TEST(Mjcf, ReadsBodiesThatAreNestedDeeplyButNotTooDeeply) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<body name='" + std::to_string(i) + "'>\n";
    for (int i = 0; i < depth; ++i) text += "</body>";
    return text;
  };
  EXPECT_EQ(mjcf(nested(190)).links.back().parent, "188");
  EXPECT_THAT(mjcf_refusal(nested(100'000)), HasSubstr("elements are nested more than 200 deep"));
}

}  // namespace
}  // namespace twrench::robot
