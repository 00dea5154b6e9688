#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scene/shown_recording.h"

namespace twrench::page {

/// A recorded motion as a page plays it.
struct PageRecording {
  motion::RecordedMotion motion;
  /// That the page has fewer rows than the recording, and the angle by which their motions differ;
  /// empty if it has all.
  std::string note;
};

/// Returns the recorded motion with so few rows that the page does not become much larger. Throws
/// InvalidArgument about the recording if they cannot show its motion.
PageRecording page_recording(const scene::ShownRecording& recording);

/// Returns a recorded motion as JSON, in the terms of web/app/types.d.ts. Each row has eight
/// doubles: the time, the attitude as the quaternion w, x, y, z, and omega.
nlohmann::ordered_json recording_json(const scene::ShownRecording& recording,
                                      const motion::RecordedMotion& motion);

}  // namespace twrench::page
