#include "app/video_options.h"

#include <twrench/base/error.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

namespace twrench::app {

void VideoOptions::add_to(CLI::App& command, const std::string& standard) {
  CLI::Option* const file =
      command
          .add_option("-o,--output", output,
                      "video file (.mp4, .mov, .mkv or .webm), or - for standard output")
          ->type_name("VIDEO")
          ->default_str(standard);
  if (standard.empty()) file->required();
  command.add_option("--container", container_name, "container: mp4, mov, mkv or webm")
      ->type_name("NAME")
      ->default_str("from the file name; mp4 for -");
}

video::Container VideoOptions::container(const std::filesystem::path& film) const {
  if (!container_name.empty()) return video::container_named(container_name);
  return is_streamed() ? video::Container::mp4 : video::container_of(film);
}

void VideoOptions::require_free_output(const std::string& progress) const {
  if (!is_streamed()) return;
  if (::isatty(STDOUT_FILENO) != 0) {
    throw InvalidArgument("--output -", "standard output is a terminal",
                          "redirect it to a file or a program: twrench render -o - | ffplay -");
  }
  if (progress == "openjd") {
    throw InvalidArgument("--progress openjd",
                          "it writes to standard output, which carries the video",
                          "choose another --progress style, or write the video to a file");
  }
}

}  // namespace twrench::app
