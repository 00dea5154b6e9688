#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/words.h"
#include "robot/repair.h"

namespace twrench::robot {

/// Returns how many links have a verdict.
std::size_t count(const JudgedRobot& judged, Verdict verdict);

/// Returns the indices of the links, the worst first, otherwise in the order of the file.
std::vector<std::size_t> worst_first(const JudgedRobot& judged);

/// Returns the verdict on a link in one sentence.
std::string verdict_text(const Diagnosis& diagnosis);

// The judgement: one row per link, the worst first, and the reasons; as JSON; as JUnit's XML, in
// which an impossible link fails.

std::string robot_text(const JudgedRobot& judged);
std::string robot_json(const JudgedRobot& judged, const ArgumentWording& wording);
std::string robot_junit(const JudgedRobot& judged);

/// Pictures of a link with the ellipsoid of its inertia, as HTML elements; empty if there is none.
struct LinkPictures {
  std::string before, after;
};

/// The pictures of a robot's links that are not good.
struct RobotPictures {
  std::map<std::size_t, LinkPictures> of_links = {};  ///< By their indices.
  std::size_t left_out = 0;                           ///< Links that are too many to be drawn.
};

/// Returns the judgement as a page with pictures, and what a repair would change.
std::string robot_html(const JudgedRobot& judged, const Repair& repair,
                       const RobotPictures& pictures, const ArgumentWording& wording);

/// Returns what a repair changes and why, one line per link.
std::string repair_text(const Repair& repair, const ArgumentWording& wording);

}  // namespace twrench::robot
