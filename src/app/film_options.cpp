#include "app/film_options.h"

#include <unistd.h>

#include "base/error.h"

namespace twrench {

void FilmOptions::add_to(CLI::App& command, const std::string& standard) {
  std::string help = "video file (.mp4, .mov, .mkv or .webm), or - for standard output";
  if (!standard.empty()) help += " (default: " + standard + ")";
  CLI::Option* const file = command.add_option("-o,--output", output, help)->type_name("VIDEO");
  if (standard.empty()) file->required();
  command
      .add_option("--container", container_name,
                  "mp4, mov, mkv or webm (default: from the file name; mp4 for -)")
      ->type_name("NAME");
}

Container FilmOptions::container(const std::filesystem::path& film) const {
  if (!container_name.empty()) return container_named(container_name);
  return is_streamed() ? Container::mp4 : container_of(film);
}

void FilmOptions::require_free_output(const std::string& progress) const {
  if (!is_streamed()) return;
  if (::isatty(STDOUT_FILENO) != 0) {
    throw UsageError("--output -", "standard output is a terminal",
                     "redirect it to a file or a program: twrench render -o - | ffplay -");
  }
  if (progress == "openjd") {
    throw UsageError("--progress openjd", "it writes to standard output, which carries the video",
                     "choose another --progress style, or write the video to a file");
  }
}

}  // namespace twrench
