// Robot descriptions in URDF, SDF and MJCF.
#include "robot/robot.h"

#include <twrench/base/error.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "robot/repair.h"
#include "system/error.h"
#include "target.h"

namespace {

using namespace twrench;

void require_place(const robot::Robot& robot, const robot::Written& number) {
  if (!number.place) return;
  require(number.place->end() <= robot.text.size(), "a number is in the file");
  const std::string digits = robot.text.substr(number.place->begin, number.place->size);
  const double value = std::strtod(digits.c_str(), nullptr);
  require(value == number.value || std::isnan(value), "a number is at its place");
}

void read(std::string text) {
  const robot::JudgedRobot judged =
      robot::judge_robot(robot::read_robot(std::move(text), "robot.xml"), {});
  for (const robot::Link& link : judged.robot.links) {
    if (!link.inertial) continue;
    require_place(judged.robot, link.inertial->mass);
    for (const robot::Written& number : link.inertial->centre) require_place(judged.robot, number);
    for (const robot::Written& number : link.inertial->entries) require_place(judged.robot, number);
  }
  require(judged.diagnoses.size() == judged.robot.links.size(), "links are judged");
  const robot::Repair repair = robot::repair(judged, true);
  require(!repair.changes.empty() || repair.text == judged.robot.text, "only a repair changes it");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read({reinterpret_cast<const char*>(data), size});
  } catch (const InvalidArgument&) {
  } catch (const system::FileError&) {
  }
  return 0;
}
