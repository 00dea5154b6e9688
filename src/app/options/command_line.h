#pragma once

#include <string>

// CLI11's own header defines objects, so each source that includes it takes seconds longer to
// compile. Only sources that add or read options include it.
namespace CLI {
class App;
class Option;
class ParseError;
class Validator;
}  // namespace CLI

namespace twrench::app {

/// The groups in which --help-all lists options, in this order. Each option names its group by
/// CLI::Option::group(heading(...)).
enum class OptionGroup {
  motion,    ///< The initial condition, and how the motion is computed and sampled.
  body,      ///< The body and its mesh.
  data,      ///< The meaning of a file's numbers.
  picture,   ///< Colours, materials and quality.
  camera,    ///< The position and the motion of the camera.
  overlays,  ///< Views, arrows, curves and text.
  film,      ///< Size, frames and container.
  bounds,    ///< Limits that determine the exit code.
  output,    ///< Files and their formats.
  run,       ///< How the program runs.
};

/// Returns the heading of a group: "Motion".
std::string heading(OptionGroup group);

/// Returns the group with that heading. Throws std::logic_error about `option` if there is none,
/// because the option was added without a group.
OptionGroup group_with(const std::string& text, const std::string& option);

}  // namespace twrench::app
