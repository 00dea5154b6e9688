#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "robot/samples.h"

namespace twrench::robot {
namespace {

using testing::HasSubstr;

std::string robot_of(const std::string& links) {
  return "<?xml version=\"1.0\"?>\n<robot name='r'>\n" + links + "</robot>\n";
}

std::string link_of(const std::string& inside) {
  return "<link name=\"arm\">\n" + inside + "</link>\n";
}

constexpr const char* inertial =
    "<inertial><origin xyz=\"0.1 +2e-1 -.3\" rpy=\"0 0 1.5707963267948966\"/>\n"
    "<mass value=' 2.50 '/>\n"
    "<inertia ixx=\"0.01\" ixy=\"0.001\" ixz=\"-2e-3\" iyy=\"2.0e-2\" iyz='0' izz=\"0.03\"/>"
    "</inertial>\n";

TEST(Urdf, ReadsTheMassPropertiesOfALink) {
  const Robot robot = RobotFile(robot_of(link_of(inertial))).read();
  EXPECT_EQ(robot.name, "r");
  const Inertial& read = *robot.link("arm").inertial;
  EXPECT_EQ(read.mass.value, 2.5);
  EXPECT_EQ(read.centre_of_mass(), Eigen::Vector3d(0.1, 0.2, -0.3));
  // A quarter of a turn about z: the link's x axis is minus the matrix's y axis.
  const Eigen::Matrix3d inertia = read.inertia();
  EXPECT_NEAR(inertia(0, 0), 0.02, 1e-17);
  EXPECT_NEAR(inertia(1, 1), 0.01, 1e-17);
  EXPECT_NEAR(inertia(0, 1), -0.001, 1e-17);
  EXPECT_NEAR(inertia(1, 2), -0.002, 1e-17);
}

TEST(Urdf, KnowsTheDigitsAndThePlaceOfEachNumber) {
  const Robot robot = RobotFile(robot_of(link_of(inertial))).read();
  const Inertial& read = *robot.link("arm").inertial;
  const auto text_of = [&](const Written& number) {
    return robot.text.substr(number.place->begin, number.place->size);
  };
  EXPECT_EQ(text_of(read.mass), "2.50");
  EXPECT_DOUBLE_EQ(read.mass.resolution, 0.005);
  EXPECT_EQ(text_of(read.centre[1]), "+2e-1");
  EXPECT_DOUBLE_EQ(read.centre[1].resolution, 0.05);
  EXPECT_EQ(text_of(read.entries[xz]), "-2e-3");
  EXPECT_EQ(text_of(read.entries[yy]), "2.0e-2");
  EXPECT_DOUBLE_EQ(read.entries[yy].resolution, 0.0005);
}

TEST(Urdf, PlacesAreThoseOfTheFileBehindReferencesAndAByteOrderMark) {
  const std::string text =
      "\xEF\xBB\xBF" + robot_of("<link name=\"a&amp;&#x62;\"/>\r\n" + link_of(inertial));
  const Robot robot = RobotFile(text).read();
  EXPECT_EQ(robot.links.front().name, "a&b");
  const Span place = *robot.link("arm").inertial->mass.place;
  EXPECT_EQ(robot.text.substr(place.begin, place.size), "2.50");
}

TEST(Urdf, PlacesAreThoseOfTheFileInAttributesOfSeveralLines) {
  const Robot robot =
      RobotFile(robot_of(link_of("<inertial><origin xyz='1\r\n2\r\n-0.5'/>"
                                 "<mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' "
                                 "iyz='0' izz='1'/></inertial>")))
          .read();
  const Span place = *robot.link("arm").inertial->centre[2].place;
  EXPECT_EQ(robot.text.substr(place.begin, place.size), "-0.5");
}

TEST(Urdf, ReadsGeometries) {
  const Robot robot =
      RobotFile(
          robot_of(link_of(
              "<visual><origin xyz='1 2 3' rpy='0 1.5707963267948966 0'/>"
              "<geometry><cylinder radius='0.1' length='2'/></geometry></visual>\n"
              "<collision><geometry><box size='1 2 3'/></geometry></collision>"
              "<collision><geometry><sphere radius='.5'/></geometry></collision>"
              "<collision><geometry><mesh filename='package://a/b.stl' scale='.001 .001 -.001'/>"
              "</geometry></collision>")))
          .read();
  const std::vector<Geometry>& read = robot.link("arm").geometries;
  ASSERT_EQ(read.size(), 4U);
  EXPECT_EQ(read[0].use, Geometry::Use::visual);
  const auto& cylinder = std::get<body::Cylinder>(std::get<body::Shape>(read[0].shape));
  EXPECT_DOUBLE_EQ(cylinder.radius, 10);
  EXPECT_DOUBLE_EQ(cylinder.length, 200);
  EXPECT_EQ(read[0].link_from_geometry.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(read[0].link_from_geometry.linear().col(2).isApprox(Eigen::Vector3d::UnitX(), 1e-15));
  EXPECT_EQ(std::get<body::Box>(std::get<body::Shape>(read[1].shape)).size,
            Eigen::Vector3d(100, 200, 300));
  EXPECT_EQ(std::get<MeshReference>(read[3].shape).uri, "package://a/b.stl");
  EXPECT_EQ(std::get<MeshReference>(read[3].shape).scale[2], -.001);
}

TEST(Urdf, KnowsTheParents) {
  const Robot robot = RobotFile(robot_of("<link name='a'/><link name='b'/>"
                                         "<joint name='j' type='fixed'><parent link='a'/>"
                                         "<child link='b'/></joint>"))
                          .read();
  EXPECT_EQ(robot.link("a").parent, "");
  EXPECT_EQ(robot.link("b").parent, "a");
}

TEST(Urdf, IgnoresGeometriesWithoutSize) {
  const RobotFile file(robot_of(
      link_of("<visual><geometry><box size='0 0.0 0'/></geometry></visual>"
              "<collision><geometry><sphere radius='0.0'/></geometry></collision>"
              "<collision><geometry><cylinder radius='1' length='1'/></geometry></collision>")));
  const Robot robot = file.read();
  EXPECT_EQ(robot.links.front().geometries.size(), 1U);
  ASSERT_EQ(robot.notes.size(), 2U);
  EXPECT_THAT(robot.notes[0], HasSubstr("robot.urdf:4: box is ignored, because its size is 0"));
}

TEST(Urdf, RefusesWhatItCannotRead) {
  const auto refusal = [](const std::string& text) { return RobotFile(text).refusal(); };
  EXPECT_THAT(refusal(robot_of("<link name='a'/>\n<link name='a'/>")),
              HasSubstr("2 robot.urdf:4: link 'a': line 3 has a link of the same name"));
  EXPECT_THAT(refusal(robot_of("<link/>")), HasSubstr("robot.urdf:3: link: it has no attribute"));
  EXPECT_THAT(refusal(robot_of("")), HasSubstr("it has no links"));
  EXPECT_THAT(refusal("<a/>"), HasSubstr("5 cannot read"));
  EXPECT_THAT(refusal("PK\3\4 <robot/>"), HasSubstr("robot.urdf: it is a ZIP archive"));
  EXPECT_THAT(refusal("\xEF\xBB\xBF\n<!DOCTYPE html><robot/>"), HasSubstr("it has no links"));
  EXPECT_THAT(refusal("<robot><link name='a'>"), HasSubstr("cut off or damaged"));
  EXPECT_THAT(refusal("<!DOCTYPE robot [<!ENTITY a 'xx'><!ENTITY b '&a;&a;'>]>" +
                      robot_of(link_of("<inertial><mass value='&b;'/><inertia/></inertial>"))),
              HasSubstr("value is '&b;', which is not a number"));
  std::string nested = "<robot>";
  for (int i = 0; i < 100'000; ++i) nested += "<a>";
  for (int i = 0; i < 100'000; ++i) nested += "</a>";
  EXPECT_THAT(refusal(nested + "</robot>"),
              HasSubstr("robot.urdf:1: a: elements are nested more than 200 deep"));
  EXPECT_THAT(refusal(robot_of("<xacro:property name='x'/>")), HasSubstr("run xacro first"));
  EXPECT_THAT(refusal(robot_of(link_of("<inertial><mass value='${m}'/></inertial>"))),
              HasSubstr("run xacro first"));
  // xacro keeps the comments of its source.
  EXPECT_EQ(refusal(robot_of("<!-- <xacro:x/> <a b=\"${c}\"/> -->" + link_of(""))), "nothing");
  EXPECT_THAT(refusal(robot_of(link_of("<inertial><mass value='0,5'/><inertia/></inertial>"))),
              HasSubstr("value is '0,5', which is not a number; write 0.5"));
  EXPECT_THAT(
      refusal(robot_of(link_of("<inertial><mass value='1'/><inertia ixx='1'/></inertial>"))),
      HasSubstr("it has no attribute 'iyy'"));
  EXPECT_THAT(refusal(robot_of(link_of("<inertial><inertia/></inertial>"))),
              HasSubstr("it has no <mass>"));
  EXPECT_THAT(
      refusal(robot_of(link_of("<visual><geometry><box size='1 -1 1'/></geometry></visual>"))),
      HasSubstr("robot.urdf:4: box: a length is -1 m"));
  // Sums over such geometries would overflow.
  for (const char* size : {"1e200", "1e-200", "inf"}) {
    EXPECT_THAT(refusal(robot_of(link_of(fmt::format(
                    "<visual><geometry><sphere radius='{}'/></geometry></visual>", size)))),
                HasSubstr("robot.urdf:4: sphere: "))
        << size;
  }
  EXPECT_THAT(refusal(robot_of(link_of("<visual><origin xyz='0 -1e300 0'/><geometry>"
                                       "<sphere radius='1'/></geometry></visual>"))),
              HasSubstr("robot.urdf:4: origin: xyz is -1e+300; give a number of at most 1e+30"));
  EXPECT_THAT(refusal(robot_of(link_of("<visual><geometry><ball/></geometry></visual>"))),
              HasSubstr("it has no known shape, but 'ball'"));
}

}  // namespace
}  // namespace twrench::robot
