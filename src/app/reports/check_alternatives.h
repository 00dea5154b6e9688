#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "check/verdict/judge.h"

namespace twrench::app {

/// "t is in ms and the rates are in deg/s: use --time-unit ms --units deg": on which condition a
/// file follows the motion, and the options for it.
std::string alternative_text(const check::Judgement& judgement, const check::Convention& after);

/// The parts with a text between each two.
std::string joined(const std::vector<std::string>& parts, std::string_view between);

}  // namespace twrench::app
