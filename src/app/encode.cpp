#include <memory>

#include "app/commands.h"
#include "app/progress.h"
#include "movie/encode_frames.h"

namespace twrench {
namespace {

struct Options {
  std::string folder;
  std::string output;
  std::string progress = "auto";
};

void encode(const Options& options) {
  Progress progress(options.progress);
  encode_frames(options.folder, options.output,
                [&](int done, int total) { progress.update(done, total); });
}

}  // namespace

void add_encode(CLI::App& app) {
  CLI::App* command = app.add_subcommand("encode", "A video from frames written earlier");
  command->footer("Example: twrench encode out/dzhanibekov -o flip.mp4");
  const auto options = std::make_shared<Options>();
  command->add_option("FRAMES_DIR", options->folder, "folder of frames and their manifest.json")
      ->required();
  command->add_option("-o,--output", options->output, "the video")->required()->type_name("F.mp4");
  Progress::add_option(*command, options->progress);
  command->callback([options] { encode(*options); });
}

}  // namespace twrench
