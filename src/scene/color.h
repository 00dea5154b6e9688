#pragma once

#include "base/color.h"

namespace twrench::scene {

using twrench::Color;

}  // namespace twrench::scene
