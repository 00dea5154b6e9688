#pragma once

#include <string>
#include <vector>

#include "program.h"

namespace twrench::torture {

/// What a run is allowed to say.
struct Manner {
  bool has_progress = false;     ///< lines of its progress, before the error too
  bool has_bar = false;          ///< which moves the cursor
  bool out_is_text = true;       ///< and no film
  bool may_lack_memory = false;  ///< which exit code 70 tells
  bool may_be_mute = false;      ///< where nothing can be written
};

/// What is wrong with how the run ended and what it said, one sentence each: an exit code that no
/// page promises, a signal, not exactly one error line and at most one remedy with an exit code
/// that has one, control characters, numbers that are none with exit code 0.
std::vector<std::string> faults_in_manner(const Ended& run, const Manner& manner);

}  // namespace twrench::torture
