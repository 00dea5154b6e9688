#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench {

/// The result of a run of the program.
struct CommandEnd {
  int code = -1;
  std::string out, err;
};

/// A scene, and the words that name it on the command line.
struct CommandSubject {
  /// The scene as the commands should understand it.
  scene::Scene scene;
  /// SCENE and options for the commands that compute the motion.
  std::string words;
  /// The body alone, for inertia and for check: "hammer" and "--scene hammer".
  std::string body, checked_body;
};

/// Runs `twrench ARGUMENTS` in the folder.
using RunCommand = std::function<CommandEnd(const std::string& arguments)>;

/// Whether to make the slow outputs too: reports, which compare all methods, and a video.
enum class Thoroughness { quick, full };

/// Runs every command that takes a scene, with its main output formats and without options for
/// times, in `folder`. Returns the faults: failed runs, and outputs that make no sense for the
/// motion. A body that turns over must do so in the table, in the plot and in the film.
std::vector<std::string> faults_of_every_command(const CommandSubject& subject,
                                                 const std::filesystem::path& folder,
                                                 const RunCommand& run, Thoroughness thoroughness);

}  // namespace twrench
