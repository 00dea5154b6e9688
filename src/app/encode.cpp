#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.h"
#include "app/progress.h"
#include "app/video_options.h"
#include "video/encode_frames.h"
#include "video/frame_range.h"

namespace twrench::app {
namespace {

struct EncodeOptions {
  std::string folder;
  VideoOptions film;
  bool allow_missing = false;
  bool overwrite = false;
  std::string progress = "auto";
};

void encode(const EncodeOptions& options) {
  options.film.require_free_output(options.progress);
  const video::VideoOutput output{options.film.output, options.film.container(options.film.output),
                                  options.overwrite};
  Progress progress(options.progress);
  const std::vector<int> left_out = video::encode_frames(
      options.folder, output,
      options.allow_missing ? video::Missing::leave_out : video::Missing::refuse,
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
  command->add_flag("--allow-missing", options->allow_missing,
                    "encode the frames that exist even if some are missing");
  command->add_flag("--overwrite", options->overwrite,
                    "replace an existing video of something else");
  Progress::add_option(*command, options->progress);
  command->callback(
      [options] { Progress::tell_failure_of([&] { encode(*options); }, options->progress); });
}

}  // namespace twrench::app
