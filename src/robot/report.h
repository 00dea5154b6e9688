#pragma once

#include <string>
#include <vector>

#include "base/words.h"
#include "robot/repair.h"

namespace twrench::robot {

/// Returns how many links have a verdict.
std::size_t count(const JudgedRobot& judged, Verdict verdict);

/// Returns the verdict on a link in one sentence.
std::string verdict_text(const Diagnosis& diagnosis);

// The judgement: one row per link, the worst first, and the reasons; as JSON; as JUnit's XML, in
// which an impossible link fails.

std::string robot_text(const JudgedRobot& judged);
std::string robot_json(const JudgedRobot& judged);
std::string robot_junit(const JudgedRobot& judged);

/// Returns what a repair changes and why, one line per link.
std::string repair_text(const Repair& repair, const ArgumentWording& wording);

}  // namespace twrench::robot
