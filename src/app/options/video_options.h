#pragma once

#include <string>

#include "app/options/command_line.h"
#include "video/encode_frames.h"

namespace twrench::app {

/// The options for the destination, container, chapters and quality of a video.
struct VideoOptions {
  /// Adds --output, --container, --chapters, --no-chapters, --encode and --crf. `standard` is the
  /// default output shown in the help, if any.
  void add_to(CLI::App& command, const std::string& standard);

  bool is_streamed() const { return output == "-"; }

  /// Returns the container given by name or by the file extension. Throws InvalidArgument.
  video::Container container(const std::filesystem::path& film) const;

  /// Returns whether the flips become chapters. Throws InvalidArgument if the user requests them in
  /// a container that supports none.
  bool chapters_in(video::Container container) const;

  /// Returns whether an effort or a quality is given.
  bool has_quality() const { return !effort.empty() || !crf.empty(); }

  /// Returns the given effort and quality. Throws InvalidArgument if the quality is no integer.
  video::Quality quality() const;

  /// Throws InvalidArgument if the video should go to standard output but cannot: it is a terminal,
  /// or `progress` uses it.
  void require_free_output(const std::string& progress) const;

  std::string output;          ///< a file, "-", or empty
  std::string container_name;  ///< May be empty.
  bool chapters = false;
  bool no_chapters = false;
  std::string effort;  ///< May be empty, like the next.
  std::string crf;
};

}  // namespace twrench::app
