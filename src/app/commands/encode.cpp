#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/video_options.h"
#include "app/terminal/progress.h"
#include "scene/limits.h"
#include "video/encode_frames.h"
#include "video/frame_range.h"

namespace twrench::app {
namespace {

struct EncodeOptions {
  std::string folder;
  VideoOptions film;
  bool allow_missing = false;
  bool overwrite = false;
  std::string width;
  std::string audio;
  std::string sound;
  std::string progress = "auto";

  /// Throws InvalidArgument.
  video::VideoOutput video_output() const;
};

std::string animated_images(const char* conjunction) {
  return video::listed(
      video::format_texts(&video::OutputFormat::label, &video::OutputFormat::is_animated_image),
      conjunction);
}

video::VideoOutput EncodeOptions::video_output() const {
  const video::Container container = film.container(film.output);
  video::VideoOutput video{.path = film.output,
                           .container = container,
                           .overwrite = overwrite,
                           .chapters = film.chapters_in(container),
                           .quality = film.quality(),
                           .audio = audio,
                           .leave_sound_out = !sound.empty()};
  if (width.empty()) return video;
  if (!video::is_animated_image(container)) {
    throw InvalidArgument("--width", fmt::format("only {} are scaled", animated_images("and")),
                          "leave it out, or render frames of that --size");
  }
  video.width = parse_whole(width, "--width", scene::limits::pixels);
  return video;
}

void encode(const EncodeOptions& options) {
  options.film.require_free_output(options.progress);
  const video::VideoOutput output = options.video_output();
  Progress progress(options.progress);
  const std::vector<int> left_out = video::encode_frames(
      options.folder, output,
      options.allow_missing ? video::MissingFrames::leave_out : video::MissingFrames::refuse,
      [&](int done, int total) { progress.update(done, total); });
  progress.finish();
  if (left_out.empty()) return;
  progress.warn(fmt::format("{}: the video lacks the missing frames {}", options.film.output,
                            video::brief_frame_range(left_out)));
}

}  // namespace

void add_encode(CLI::App& app) {
  CLI::App* command = app.add_subcommand("encode", "Encode a video from frames rendered earlier");
  command->footer("Example: twrench encode out/dzhanibekov -o flip.mp4");
  const auto options = std::make_shared<EncodeOptions>();
  command
      ->add_option("FRAMES_DIR", options->folder,
                   "folder with frames and their manifest.json, or the manifests of all shards")
      ->required();
  options->film.add_to(*command, "");
  command
      ->add_option("--width", options->width,
                   fmt::format("width of a {} in pixels", animated_images("or")))
      ->type_name("N")
      ->default_str(fmt::format("that of the frames, but at most {}", video::widest_animation))
      ->group(heading(OptionGroup::film));
  command
      ->add_option("--audio", options->audio,
                   "sound file under the video, trimmed to it or followed by silence")
      ->type_name("FILE")
      ->group(heading(OptionGroup::film));
  command
      ->add_option("--sound", options->sound,
                   "none leaves out the sound of the scene, which the frames do not contain; "
                   "render --resume adds it")
      ->check(one_of("--sound", {"none"}))
      ->type_name("NAME")
      ->group(heading(OptionGroup::film));
  command
      ->add_flag("--allow-missing", options->allow_missing,
                 "encode the frames that exist even if some are missing")
      ->group(heading(OptionGroup::output));
  command
      ->add_flag("--overwrite", options->overwrite, "replace an existing video of something else")
      ->group(heading(OptionGroup::output));
  add_progress_option(*command, options->progress);
  command->callback(
      [options] { Progress::tell_failure_of([&] { encode(*options); }, options->progress); });
}

}  // namespace twrench::app
