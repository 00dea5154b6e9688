#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "check/verdict/judge.h"

namespace twrench::check {

/// Returns the condition under which a file follows the motion, and the options for it: "t is in ms
/// and the rates are in deg/s: use --time-unit ms --units deg".
std::string alternative_text(const Judgement& judgement, const recording::Convention& after);

/// Joins the parts with a separator.
std::string joined(const std::vector<std::string>& parts, std::string_view between);

}  // namespace twrench::check
