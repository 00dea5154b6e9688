#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/render_options.h"
#include "app/terminal/message.h"
#include "app/terminal/progress.h"
#include "app/terminal/timing.h"
#include "base/argument.h"
#include "film/render_job.h"
#include "image/picture_memory.h"
#include "scene/languages.h"
#include "scene/shown_recording.h"
#include "scene/video_length.h"
#include "system/error.h"
#include "system/termination.h"

namespace twrench::app {
namespace {

/// Records the complete frames when a signal ends the run, and reports their number to the user.
void end_whole(film::RenderJob& job, system::TerminationMessage& message) {
  message.error = "render: " + message.error;
  const std::optional<std::size_t> complete = job.record_frames();
  if (!complete) {
    message.error += "; the video was not complete";
    return;
  }
  message.error += fmt::format(" after {} of {} frames, which are complete", *complete, job.size());
  message.remedy = "repeat the command with --resume to continue";
}

Summary summary_of(const film::RenderSettings& settings, std::size_t frames, double seconds) {
  Summary summary{frames, seconds, settings.frames_folder, {}};
  if (settings.video) summary.film = settings.video->path;
  return summary;
}

void render(const RenderOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const ProcessorTime before = processor_time();
  options.require_consistent();
  const scene::Scene scene = options.scene_to_draw();
  options.scene.require_drawable(scene);
  image::keep_memory_of_pictures(scene.film.width, scene.film.height);
  const film::RenderSettings settings = options.settings(scene);
  film::RenderJob job(scene, settings);
  const system::TerminationAction on_signal(
      [&](system::TerminationMessage& message) { end_whole(job, message); });

  Progress progress(options.progress);
  progress.note(scene::describe_video(scene));
  const std::string language = scene::note_on_language(scene);
  if (!language.empty()) progress.note(language);
  if (!job.note().empty()) progress.note(job.note());
  for (const std::string& warning : job.warnings()) progress.warn(warning);
  job.run([&](int done, int total) { progress.update(done, total); });
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  progress.summarize(summary_of(settings, job.size(), seconds));
  if (scene.motion.recording && !scene.motion.recording->verdict.empty()) {
    const scene::ShownRecording& recording = *scene.motion.recording;
    progress.note(recording.file + ": " + with_arguments(recording.verdict, option_text));
  }
  if (!options.timing.empty()) {
    const bool json = options.timing == "json" || options.progress == "json";
    say("{}\n", timing_report(job.times(), before, seconds, job.size(), json));
  }
}

/// Also corrects the remedy of an error about an existing video, because --resume excludes
/// --overwrite.
void render_with_remedies(const RenderOptions& options) {
  try {
    render(options);
  } catch (const system::ExistingFileError& error) {
    if (!options.resume) throw;
    throw system::ExistingFileError(
        "--resume", error.what(),
        "--overwrite instead of --resume replaces it, or choose another name");
  }
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("render", "Simulate, draw every frame, and write PNG frames and a video");
  command->footer(std::string(about_defaults) +
                  "Captions, fades and a speed that changes: [[shot]] tables of the scene file.\n"
                  "Example: twrench render dzhanibekov --size 1280x720 -o flip.mp4\n"
                  "Exit codes: 3 no OpenGL, 4 no ffmpeg, 130 or 143 interrupted.");
  const auto options = std::make_shared<RenderOptions>(*command);
  command->callback([options] {
    Progress::tell_failure_of([&] { render_with_remedies(*options); }, options->progress);
  });
}

}  // namespace twrench::app
