#include "app/options/video_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <map>
#include <vector>

#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "base/enumeration.h"
#include "system/file.h"

namespace twrench::app {
namespace {

using video::format_texts;
using video::listed;
using video::OutputFormat;

constexpr auto is_video = &OutputFormat::is_video;
constexpr auto is_animation = &OutputFormat::is_animated_image;
constexpr auto keeps_alpha = &OutputFormat::keeps_alpha;

/// The formats of opaque videos for each largest number of their scale of quality.
std::map<int, std::vector<std::string>> quality_scales() {
  std::map<int, std::vector<std::string>> scales;
  for (const OutputFormat& format : video::output_formats()) {
    if (format.has_quality(false))
      scales[format.opaque.codec->most_crf].push_back(format.extension());
  }
  return scales;
}

/// "0 to 51 for .mp4, .mov, .mkv; 0 to 63 for .webm".
std::string quality_ranges() {
  std::vector<std::string> ranges;
  for (const auto& [most, extensions] : quality_scales()) {
    ranges.push_back(fmt::format("0 to {} for {}", most, fmt::join(extensions, ", ")));
  }
  return fmt::format("{}", fmt::join(ranges, "; "));
}

}  // namespace

void VideoOptions::add_to(CLI::App& command, const std::string& standard) {
  CLI::Option* const file =
      command
          .add_option(
              "-o,--output", output,
              fmt::format("video ({}) or animated {} for slides ({}); {} keep a transparent "
                          "background; - for standard output",
                          fmt::join(format_texts(&OutputFormat::extension, is_video), ", "),
                          listed(format_texts(&OutputFormat::label, is_animation), "or"),
                          fmt::join(format_texts(&OutputFormat::extension, is_animation), ", "),
                          listed(format_texts(&OutputFormat::extension, keeps_alpha), "and")))
          ->type_name("VIDEO")
          ->default_str(standard)
          ->group(heading(OptionGroup::output));
  if (standard.empty()) file->required();
  command
      .add_option("--container", container_name,
                  "container: " + listed(format_texts(&OutputFormat::ending), "or"))
      ->type_name("NAME")
      ->default_str("from the file name; mp4 for -")
      ->group(heading(OptionGroup::film));
  command
      .add_flag("--chapters", chapters,
                "make the flips chapters of the video, also in VIDEO's .chapters.vtt; on by "
                "default")
      ->group(heading(OptionGroup::film));
  command.add_flag("--no-chapters", no_chapters, "make no chapters")
      ->group(heading(OptionGroup::film));
  command
      .add_option(
          "--encode", effort,
          "effort of the encoder at the same quality: fast takes less processor time, small "
          "makes a smaller file")
      ->check(one_of("--encode", enumerator_names<video::Effort>()))
      ->type_name("NAME")
      ->default_str(std::string(enumerator_name(video::Effort::balanced)))
      ->group(heading(OptionGroup::film));
  command.add_option("--crf", crf, "quality of the video, smaller is better: " + quality_ranges())
      ->type_name("N")
      ->default_str("depends on the format and --encode")
      ->group(heading(OptionGroup::film));
}

video::Container VideoOptions::container(const std::filesystem::path& film) const {
  if (!container_name.empty()) return video::container_named(container_name);
  return is_streamed() ? video::Container::mp4 : video::container_of(film);
}

bool VideoOptions::chapters_in(video::Container in) const {
  if (chapters && no_chapters) {
    throw InvalidArgument("--chapters", "it contradicts --no-chapters", "give one of the two");
  }
  const bool has_chapters = !video::is_animated_image(in);
  if (chapters && !has_chapters) {
    throw InvalidArgument(
        "--chapters",
        listed(format_texts(&OutputFormat::label, is_animation), "and") + " have none",
        "leave it out, or choose " + listed(format_texts(&OutputFormat::ending, is_video), "or"));
  }
  return has_chapters && !no_chapters;
}

video::Quality VideoOptions::quality() const {
  video::Quality quality;
  if (!effort.empty()) quality.effort = find_enumerator<video::Effort>(effort, "--encode");
  // The codec of the video may have a smaller range, which it checks.
  const double most = quality_scales().rbegin()->first;
  if (!crf.empty()) quality.crf = parse_whole(crf, "--crf", {0, most});
  return quality;
}

void VideoOptions::require_free_output(const std::string& progress) const {
  if (!is_streamed()) return;
  require_no_terminal(": twrench render -o - | ffplay -");
  // Writing nothing fails if it is closed. Otherwise ffmpeg would fail after the first frames.
  if (::write(STDOUT_FILENO, "", 0) < 0) {
    throw system::file_error("cannot write standard output", errno);
  }
  if (progress == "openjd") {
    throw InvalidArgument("--progress openjd",
                          "it writes to standard output, which carries the video",
                          "choose another --progress style, or write the video to a file");
  }
}

}  // namespace twrench::app
