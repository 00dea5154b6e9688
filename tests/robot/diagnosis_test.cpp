#include "robot/diagnosis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/enumeration.h"
#include "robot/planted.h"
#include "robot/repair.h"
#include "robot/samples.h"

namespace twrench::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::HasSubstr;
using testing::SizeIs;

/// Writes a robot description and judges it.
JudgedRobot judged(const std::string& text, const std::filesystem::path& file) {
  std::ofstream(file, std::ios::binary) << text;
  return judge_robot(read_robot(file), {});
}

bool names(const Diagnosis& diagnosis, Fault fault) {
  const auto has = [&](const std::vector<Finding>& findings) {
    return std::ranges::find(findings, fault, &Finding::fault) != findings.end();
  };
  return has(diagnosis.faults) || has(diagnosis.mistakes);
}

std::string named_in(const Diagnosis& diagnosis) {
  std::string names(enumerator_name(diagnosis.verdict));
  for (const Finding& f : diagnosis.faults) names += fmt::format(" {}", enumerator_name(f.fault));
  names += " |";
  for (const Finding& f : diagnosis.mistakes)
    names += fmt::format(" {} {:.2g}", enumerator_name(f.fault), f.misfit.value_or(-1));
  return names;
}

Matrix3d point_inertia(double mass, const Vector3d& r) {
  return mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
}

/// A mistake that changes a correct link. It returns false if it would change nothing.
struct Plant {
  Fault fault;
  std::function<bool(PlantedLink&, Dice&)> spoil;
};

bool scale(PlantedLink& link, double factor) {
  for (double& number : link.numbers) number *= factor;
  return std::abs(std::log(factor)) > 0.1;
}

/// The share by which the matrix differs from the correct one.
double change(const PlantedLink& a, const PlantedLink& b) {
  return (a.inertia() - b.inertia()).cwiseAbs().maxCoeff() / b.inertia().cwiseAbs().maxCoeff();
}

const std::vector<Plant>& plants() {
  static const std::vector<Plant> all{
      {Fault::mass,
       [](PlantedLink& link, Dice& dice) {
         link.mass = dice.below(2) == 0 ? 0.0 : -link.mass;
         return true;
       }},
      {Fault::moments,
       [](PlantedLink& link, Dice& dice) {
         if (dice.below(2) == 0) {
           link.numbers = {};
         } else {
           link.numbers[3] = -link.numbers[3];
         }
         return true;
       }},
      {Fault::triangle,
       [](PlantedLink& link, Dice& dice) {
         const int axis = dice.below(3);
         Matrix3d m = link.matrix();
         m = Vector3d(m.diagonal()).asDiagonal();
         m(axis, axis) = dice.between(1.1, 3) * (m.trace() - m(axis, axis));
         link.set_matrix(m);
         return true;
       }},
      {Fault::products_sign,
       [](PlantedLink& link, Dice& dice) {
         const int which = dice.below(4);
         for (const int i : {1, 2, 4})
           if (which == 3 || i == std::array{1, 2, 4}[which]) link.numbers[i] = -link.numbers[i];
         return true;
       }},
      {Fault::entries_order,
       [](PlantedLink& link, Dice& dice) {
         const auto [xx, xy, xz, yy, yz, zz] = link.numbers;
         switch (dice.below(3)) {
           case 0:  // lower triangle
             link.numbers = {xx, xy, yy, xz, yz, zz};
             return true;
           case 1:  // the diagonal first
             link.numbers = {xx, yy, zz, xy, xz, yz};
             return true;
           default:  // the order of Voigt
             link.numbers = {xx, yz, xz, yy, xy, zz};
             return true;
         }
       }},
      {Fault::about_origin,
       [](PlantedLink& link, Dice&) {
         link.set_inertia(link.inertia() + point_inertia(link.mass, link.centre));
         return true;
       }},
      {Fault::shifted_twice,
       [](PlantedLink& link, Dice&) {
         link.set_inertia(link.inertia() - point_inertia(link.mass, link.centre));
         return true;
       }},
      {Fault::frame,
       [](PlantedLink& link, Dice& dice) {
         if (link.rpy.isZero()) return false;
         switch (dice.below(3)) {
           case 0:
             link.set_matrix(link.inertia());
             return true;
           case 1:
             link.rpy.setZero();
             return true;
           default: {
             // the inverse rotation, which has other angles
             const Vector3d zyx = link.rotation().transpose().eulerAngles(2, 1, 0);
             link.rpy = {zyx[2], zyx[1], zyx[0]};
             return true;
           }
         }
       }},
      {Fault::inertia_unit,
       [](PlantedLink& link, Dice& dice) {
         return scale(link, std::array{1e6, 1e9, 1e-6, 1e3, 1e7}[dice.below(5)]);
       }},
      {Fault::mass_unit,
       [](PlantedLink& link, Dice& dice) {
         link.mass *= 1000;
         if (dice.below(2) == 0) scale(link, 1000);
         return true;
       }},
      {Fault::mass_twice, [](PlantedLink& link, Dice&) { return scale(link, link.mass); }},
      {Fault::unit_mass, [](PlantedLink& link, Dice&) { return scale(link, 1 / link.mass); }},
      {Fault::density_twice, [](PlantedLink& link, Dice&) { return scale(link, link.density); }},
      {Fault::unit_density,
       [](PlantedLink& link, Dice& dice) {
         return scale(link, (dice.below(2) == 0 ? 1 : 1000) / link.density);
       }},
      {Fault::placeholder,
       [](PlantedLink& link, Dice& dice) {
         const double x = std::array{1.0, 1e-3, 1e-6}[dice.below(3)];
         link.numbers = {x, 0, 0, x, 0, x};
         return true;
       }},
      {Fault::identity,
       [](PlantedLink& link, Dice&) {
         const double x = link.matrix().trace() / 3;
         link.numbers = {x, 0, 0, x, 0, x};
         return true;
       }},
      {Fault::centre_outside,
       [](PlantedLink& link, Dice& dice) {
         link.centre +=
             10 * std::sqrt(link.inertia().trace() / link.mass) * dice.vector(1).normalized();
         return true;
       }},
      {Fault::too_large,
       [](PlantedLink& link, Dice& dice) { return scale(link, dice.between(12, 60)); }},
  };
  return all;
}

TEST(Diagnosis, NamesPlantedMistakes) {
  const ScratchFolder folder;
  Dice dice(20261129);
  std::map<std::string, std::pair<int, int>> named;  // of how many, by fault
  int right = 0, wrong = 0, all = 0;
  for (std::size_t i = 0; all < 200; ++i) {
    const Plant& plant = plants()[i % plants().size()];
    const PlantedLink correct = correct_link("arm", dice, folder.path());
    PlantedLink link = correct;
    if (!plant.spoil(link, dice) || (link.mass == correct.mass && link.centre == correct.centre &&
                                     change(link, correct) < 0.05))
      continue;
    ++all;
    const JudgedRobot robot = judged(robot_xml({link}), folder / "robot.urdf");
    const Diagnosis& diagnosis = robot.diagnoses.front();
    auto& [of_kind, kind] = named[std::string(enumerator_name(plant.fault))];
    ++kind;
    if (names(diagnosis, plant.fault)) {
      ++right, ++of_kind;
    } else {
      if (!diagnosis.mistakes.empty()) ++wrong;
      std::cout << enumerator_name(plant.fault) << " is judged " << named_in(diagnosis) << "\n"
                << link.xml();
    }
  }
  for (const auto& [fault, counts] : named)
    std::cout << fault << " " << counts.first << " of " << counts.second << "\n";
  EXPECT_GE(right, 190);
  EXPECT_LE(wrong, 2);
}

TEST(Diagnosis, RaisesNoFalseAlarmAboutCorrectLinks) {
  const ScratchFolder folder;
  Dice dice(7);
  for (int i = 0; i < 300; ++i) {
    const PlantedLink link = correct_link("arm", dice, folder.path());
    const JudgedRobot robot = judged(robot_xml({link}), folder / "robot.urdf");
    EXPECT_EQ(robot.diagnoses.front().verdict, Verdict::good)
        << named_in(robot.diagnoses.front()) << "\n"
        << link.xml();
    EXPECT_TRUE(robot.diagnoses.front().agreement.has_value()) << link.xml();
  }
}

/// The judgement on the first link of a robot.
Diagnosis diagnosis_of(const std::string& links) {
  const ScratchFolder folder;
  return judged("<robot name=\"r\">" + links + "</robot>", folder / "robot.urdf").diagnoses.front();
}

std::string link_of(const std::string& name, double mass, const std::string& inertia,
                    const std::string& shape) {
  return fmt::format(
      "<link name='{}'><inertial><mass value='{}'/><inertia {}/></inertial>"
      "<visual><geometry>{}</geometry></visual></link>",
      name, mass, inertia, shape);
}

std::string diagonal(double a, double b, double c) {
  return fmt::format("ixx='{}' ixy='0' ixz='0' iyy='{}' iyz='0' izz='{}'", a, b, c);
}

TEST(Diagnosis, NamesTheLinkFromWhichNumbersWereCopied) {
  // A box of 12 kg with the edges 1, 2 and 3 m.
  const std::string box = "<box size='1 2 3'/>", ball = "<box size='2 1 4'/>";
  const std::string inertia = diagonal(13, 10, 5);
  const std::string robot = link_of("copy", 12, inertia, ball) + link_of("own", 12, inertia, box);
  const Diagnosis copy = diagnosis_of(robot);
  EXPECT_EQ(copy.verdict, Verdict::doubtful);
  ASSERT_THAT(copy.mistakes, SizeIs(1));
  EXPECT_EQ(copy.mistakes[0].fault, Fault::copied);
  EXPECT_THAT(copy.mistakes[0].text, HasSubstr("link 'own'"));
  // Two equal links with equal geometries are no mistake.
  EXPECT_EQ(diagnosis_of(link_of("a", 12, inertia, box) + link_of("b", 12, inertia, box)).verdict,
            Verdict::good);
}

TEST(Diagnosis, FindsCopiesAmongManyLinks) {
  // Comparing each link with each other takes minutes.
  const std::string inertia = diagonal(13, 10, 5);
  std::string robot;
  for (int i = 0; i < 30000; ++i)
    robot += link_of(fmt::format("copy{}", i), 12, inertia, "<box size='2 1 4'/>");
  robot += link_of("own", 12, inertia, "<box size='1 2 3'/>");
  EXPECT_THAT(diagnosis_of(robot).mistakes, SizeIs(1));
}

TEST(Diagnosis, JudgesTheOtherLinksBesideOneOfHugeNumbers) {
  const std::string box = "<box size='1 2 3'/>";
  const auto huge = [](const char* x) {
    return fmt::format(
        "ixx='{0}' ixy='{0}' ixz='0' iyy='{0}' "
        "iyz='0' izz='{0}'",
        x);
  };
  const Diagnosis diagnosis = diagnosis_of(link_of("a", 1, huge("1e308"), box));
  EXPECT_EQ(diagnosis.verdict, Verdict::impossible);
  EXPECT_EQ(diagnosis.faults.front().fault, Fault::not_finite);
  for (const double mass : {1e308, -1e308, 1e-320, 1e-160}) {
    const Diagnosis extreme = diagnosis_of(link_of("a", mass, diagonal(13, 10, 5), box));
    EXPECT_EQ(extreme.faults.front().fault, Fault::not_finite) << mass;
  }
}

TEST(Diagnosis, AllowsForTheRoundingOfTheCentre) {
  const auto faults = [](const char* centre, double moment) {
    return diagnosis_of(
               fmt::format("<link name='a'><inertial><origin xyz='{} 0 0'/><mass value='1'/>"
                           "<inertia {}/></inertial><visual><geometry><box size='1 1 1'/>"
                           "</geometry></visual></link>",
                           centre, diagonal(0.1 * moment, moment, moment)))
        .faults;
  };
  // On the face, within the last digit, the mass may be a little inside.
  EXPECT_THAT(faults("0.50", 0.001), SizeIs(0));
  EXPECT_THAT(faults("0.50", 0.1), SizeIs(1));
  // Few digits do not hide moments that are ten times too large.
  EXPECT_THAT(diagnosis_of("<link name='a'><inertial><origin xyz='0 0 0.1'/><mass value='0.3'/>"
                           "<inertia " +
                           diagonal(0.001015625, 0.001015625, 0.002) +
                           "/></inertial><visual><origin xyz='0 0 0.1'/><geometry>"
                           "<box size='0.025 0.025 0.2'/></geometry></visual></link>")
                  .faults,
              SizeIs(1));
  // A centre outside allows no moments. Only the centre is reported.
  const auto outside = faults("0.70", 0.001);
  ASSERT_THAT(outside, SizeIs(1));
  EXPECT_EQ(outside.front().fault, Fault::centre_outside);
}

TEST(Diagnosis, SaysWhetherABodyIsHollow) {
  // A thin spherical shell has 2/3 m r^2, a ball 2/5 m r^2.
  const std::string ball = "<sphere radius='0.5'/>";
  const double hollow = 2.0 / 3 * 3 * 0.25, solid = 0.4 * 3 * 0.25;
  EXPECT_EQ(diagnosis_of(link_of("a", 3, diagonal(hollow, hollow, hollow), ball)).agreement->model,
            "the surface of its visual geometry");
  EXPECT_EQ(diagnosis_of(link_of("a", 3, diagonal(solid, solid, solid), ball)).agreement->model,
            "its visual geometry");
}

TEST(Diagnosis, AcceptsLinksWithoutGeometry) {
  const std::string frame = "<link name='a'><inertial><mass value='1e-6'/><inertia " +
                            diagonal(1e-6, 1e-6, 1e-6) + "/></inertial></link>";
  EXPECT_EQ(diagnosis_of(frame).verdict, Verdict::good);
  EXPECT_EQ(diagnosis_of("<link name='a'/>").verdict, Verdict::unstated);
}

TEST(Diagnosis, AcceptsFixedFramesWithoutMass) {
  const auto verdict = [](const char* joint) {
    return diagnosis_of("<link name='tool'><inertial><mass value='0'/><inertia " +
                        diagonal(0, 0, 0) + "/></inertial></link><link name='arm'/><joint type='" +
                        joint + "'><parent link='arm'/><child link='tool'/></joint>")
        .verdict;
  };
  EXPECT_EQ(verdict("fixed"), Verdict::unstated);
  EXPECT_EQ(verdict("revolute"), Verdict::impossible);
}

TEST(Diagnosis, AcceptsARootWithoutMassThatIsFixedToTheRobot) {
  const auto verdict = [](const char* joint) {
    return diagnosis_of("<link name='root'><inertial><mass value='0'/><inertia " +
                        diagonal(0, 0, 0) + "/></inertial></link><link name='arm'/><joint type='" +
                        joint + "'><parent link='root'/><child link='arm'/></joint>")
        .verdict;
  };
  EXPECT_EQ(verdict("fixed"), Verdict::unstated);
  EXPECT_EQ(verdict("revolute"), Verdict::impossible);
}

// As libsdformat, which accepts a mass of zero.
TEST(Diagnosis, AcceptsFixedFramesOfSdf) {
  const auto verdict = [](const char* joint) {
    const RobotFile file(
        fmt::format("<sdf version='1.9'><model name='m'><link name='tool'><inertial><mass>0</mass>"
                    "<inertia><ixx>0</ixx><iyy>0</iyy><izz>0</izz></inertia></inertial></link>"
                    "<link name='arm'/><joint name='j' type='{}'><parent>arm</parent>"
                    "<child>tool</child></joint></model></sdf>",
                    joint),
        "robot.sdf");
    return judge_robot(file.read(), {}).diagnoses.front().verdict;
  };
  EXPECT_EQ(verdict("fixed"), Verdict::unstated);
  EXPECT_EQ(verdict("revolute"), Verdict::impossible);
}

// As MuJoCo, which requires a mass only of moving bodies without a welded child that has one.
TEST(Diagnosis, AcceptsFixedFramesOfMjcf) {
  const auto verdict = [](const std::string& body, const std::string& child) {
    const RobotFile file("<mujoco><worldbody><body name='a'>" + body +
                             "<inertial pos='0 0 0' mass='0' diaginertia='0 0 0'/>" + child +
                             "</body></worldbody></mujoco>",
                         "robot.xml");
    return judge_robot(file.read(), {}).diagnoses.front().verdict;
  };
  EXPECT_EQ(verdict("", ""), Verdict::unstated);
  EXPECT_EQ(verdict("<joint/>", ""), Verdict::impossible);
  EXPECT_EQ(verdict("<frame><freejoint/></frame>", ""), Verdict::impossible);
  EXPECT_EQ(verdict("<joint/>", "<body><geom size='1'/></body>"), Verdict::unstated);
  EXPECT_EQ(verdict("<joint/>", "<body><joint/><geom size='1'/></body>"), Verdict::impossible);
}

TEST(Diagnosis, GivesTheEvidence) {
  const Diagnosis flat = diagnosis_of(link_of("a", 1, diagonal(1, 1, 3), "<box size='1 1 1'/>"));
  EXPECT_EQ(flat.verdict, Verdict::impossible);
  EXPECT_THAT(flat.faults.front().text,
              HasSubstr("the greatest principal moment, 3 kg m^2, exceeds the sum of the two "
                        "others, 1 + 1"));
  EXPECT_THAT(diagnosis_of(link_of("a", 1, "ixx='nan' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'",
                                   "<box size='1 1 1'/>"))
                  .faults.front()
                  .text,
              HasSubstr("NaN"));
}

TEST(Diagnosis, MovesWithTheUnitOfTheBody) {
  // The same body from a micrometre to a thousand kilometres.
  for (int power = -6; power <= 6; power += 3) {
    const double s = std::pow(10.0, power), i = std::pow(10.0, 2 * power);
    const std::string box = fmt::format("<box size='{} {} {}'/>", s, 2 * s, 3 * s);
    EXPECT_EQ(diagnosis_of(link_of("a", 12, diagonal(13 * i, 10 * i, 5 * i), box)).verdict,
              Verdict::good)
        << power;
    EXPECT_EQ(diagnosis_of(link_of("a", 12, diagonal(13 * i, 10 * i, 2 * i), box)).verdict,
              Verdict::impossible)
        << power;
  }
}

TEST(Diagnosis, RepairsPlantedMistakes) {
  const ScratchFolder folder;
  Dice dice(11);
  int repaired = 0;
  for (std::size_t i = 0; i < 160; ++i) {
    const Plant& plant = plants()[i % plants().size()];
    PlantedLink link = correct_link("arm", dice, folder.path());
    if (!plant.spoil(link, dice)) continue;
    const JudgedRobot robot = judged(robot_xml({link}), folder / "robot.urdf");
    for (const bool from_geometry : {false, true}) {
      const Repair fixed = repair(robot, from_geometry);
      const JudgedRobot again = judged(fixed.text, folder / "repaired.urdf");
      if (fixed.changes.empty()) {
        EXPECT_EQ(fixed.text, robot.robot.text);
        continue;
      }
      ++repaired;
      EXPECT_NE(again.diagnoses.front().verdict, Verdict::impossible)
          << fixed.changes.front().reason << "\n"
          << fixed.text;
      EXPECT_TRUE(is_possible(again.diagnoses.front().body));
    }
  }
  EXPECT_GT(repaired, 150);
}

}  // namespace
}  // namespace twrench::robot
