#pragma once

#include <string>

#include "check/law/mistakes.h"
#include "check/verdict/judge.h"

namespace twrench::check {

/// Words for the laws that explain the rows and how well these then agree: "the gyroscopic term has
/// the wrong sign; with this, the rates agree to 3e-11 of what changes". First those of the rates,
/// then those of the attitude. There must be one.
std::string law_text(const Judgement& judgement, const WrongLaws& laws);

}  // namespace twrench::check
