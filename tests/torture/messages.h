#pragma once

#include <string>
#include <vector>

#include "program.h"

namespace twrench::torture {

/// The expected behaviour of a run.
struct Manner {
  bool has_progress = false;       ///< progress lines, also before the error
  bool has_bar = false;            ///< a bar, which moves the cursor
  bool out_is_text = true;         ///< standard output is text, not video
  bool may_name_infinity = false;  ///< the schema and the help do, as a value of a key or an option
  bool may_lack_memory = false;    ///< may end with exit code 70
  bool may_be_mute = false;        ///< may end silently, if nothing can be written
};

/// Returns the faults in the end and the output of the run, one sentence each: an undocumented exit
/// code, a signal, other than one error line and at most one remedy for an exit code that requires
/// an error, control characters, NaN or infinity with exit code 0.
std::vector<std::string> faults_in_manner(const Ended& run, const Manner& manner);

}  // namespace twrench::torture
