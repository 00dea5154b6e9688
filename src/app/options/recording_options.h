#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "app/options/convention_options.h"
#include "recording/rows.h"
#include "scene/recording_file.h"
#include "scene/scene.h"

namespace twrench::app {

/// The options that leave out rows of a recording. Must live as long as the command.
class ExtractOptions {
 public:
  void add_to(CLI::App& command);

  /// Returns the rows that remain. Throws InvalidArgument.
  recording::Extract extract() const;

  /// Returns the options that were given, as words of a command line.
  std::vector<std::string> given() const;

 private:
  std::string from_, to_;
};

/// The options for a recorded motion that a scene shows instead of a computed one. Must live as
/// long as the command.
class RecordingOptions {
 public:
  void add_to(CLI::App& command);

  /// Lets the scene show the recording that is given, or else the one that its file names, if there
  /// is one; `has_body` is whether the user named the body of the scene. Throws InvalidArgument
  /// about the options, and what replay::show_recording() throws.
  void apply(scene::Scene& scene, bool has_body) const;

  /// Returns the options that were given, as words of a command line.
  std::vector<std::string> given() const;

 private:
  /// Throws InvalidArgument if there are options for a recording.
  void require_recorded() const;
  /// Throws InvalidArgument if there are options that compute a motion.
  void require_nothing_computed(const std::string& file) const;
  /// Returns the recording of a scene file with the values that the options give.
  std::shared_ptr<const scene::RecordingFile> with_options(const scene::RecordingFile& own) const;

  CLI::App* command_ = nullptr;  ///< Null if the command has no such options.
  std::string file_;
  ExtractOptions extract_;
  bool smooth_ = false;
  ConventionOptions convention_;
};

}  // namespace twrench::app
