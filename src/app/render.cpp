#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.h"
#include "app/progress.h"
#include "app/render_job.h"

namespace twrench::app {

void add_render(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("render", "Simulate, draw every frame, and write PNG frames and a video");
  command->footer(std::string(about_defaults) +
                  "Example: twrench render dzhanibekov --size 1280x720 -o flip.mp4\n"
                  "Exit codes: 3 no OpenGL, 4 no ffmpeg, 130 or 143 interrupted.");
  const auto options = std::make_shared<RenderOptions>(*command);
  command->callback(
      [options] { Progress::tell_failure_of([&] { render_film(*options); }, options->progress); });
}

}  // namespace twrench::app
