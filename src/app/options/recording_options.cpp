#include "app/options/recording_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "recording/recording.h"
#include "replay/replay.h"
#include "scene/limits.h"
#include "scene/recording_table.h"

namespace twrench::app {

void ExtractOptions::add_to(CLI::App& command) {
  command
      .add_option("--from", from_,
                  "of a recording: leave out the rows before this time, s since the first row")
      ->type_name("T")
      ->group(heading(OptionGroup::motion));
  command
      .add_option("--to", to_,
                  "of a recording: leave out the rows after this time, s since the first row")
      ->type_name("T")
      ->group(heading(OptionGroup::motion));
}

recording::Extract ExtractOptions::extract() const {
  recording::Extract extract;
  if (!from_.empty()) extract.from = parse_number(from_, "--from", scene::limits::coordinate);
  if (!to_.empty()) extract.to = parse_number(to_, "--to", scene::limits::coordinate);
  return extract;
}

std::vector<std::string> ExtractOptions::given() const {
  std::vector<std::string> words;
  for (const auto& [option, value] : {std::pair("--from", from_), std::pair("--to", to_)}) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  }
  return words;
}

void RecordingOptions::add_to(CLI::App& command) {
  command_ = &command;
  command
      .add_option(
          "--motion", file_,
          "show this recorded motion instead of a computed one: a CSV, TSV, JSON, AEM, .npy "
          "or .npz file of times and attitudes, rates or both")
      ->type_name("FILE")
      ->group(heading(OptionGroup::motion));
  extract_.add_to(command);
  command
      .add_flag("--smooth", smooth_,
                "of a recording: show the smoothest motion within its noise instead of its rows")
      ->group(heading(OptionGroup::motion));
  convention_.add_to(command);
}

std::vector<std::string> RecordingOptions::given() const {
  std::vector<std::string> words;
  if (!file_.empty()) words = {"--motion", file_};
  const std::vector<std::string> smooth(smooth_ ? 1 : 0, "--smooth");
  for (const std::vector<std::string>& more : {extract_.given(), smooth, convention_.given()}) {
    words.insert(words.end(), more.begin(), more.end());
  }
  return words;
}

void RecordingOptions::require_recorded() const {
  const std::vector<std::string> others = given();
  if (others.empty()) return;
  throw InvalidArgument(others.front(), "it applies to a recorded motion, and there is none",
                        "give the recording with --motion FILE, or leave the option out");
}

void RecordingOptions::require_nothing_computed(const std::string& file) const {
  for (const char* option : {"--omega", "--method"}) {
    if (command_->count(option) == 0) continue;
    throw InvalidArgument(option, "the motion is recorded in " + file,
                          "leave it out; --compare exact shows the free motion beside it");
  }
}

std::shared_ptr<const scene::RecordingFile> RecordingOptions::with_options(
    const scene::RecordingFile& own) const {
  nlohmann::ordered_json keys = nlohmann::ordered_json::parse(own.keys);
  const recording::Extract extract = extract_.extract();
  if (std::isfinite(extract.from)) keys["from"] = extract.from;
  if (std::isfinite(extract.to)) keys["to"] = extract.to;
  if (smooth_) keys["smooth"] = true;
  keys.update(convention_.values());
  return std::make_shared<const scene::RecordingFile>(
      scene::recording_file(keys, own.path, name_of_option));
}

void RecordingOptions::apply(scene::Scene& scene, bool has_body) const {
  if (command_ == nullptr) return;
  if (!file_.empty()) {
    require_nothing_computed(file_);
    replay::show_recording(
        scene, recording::Recording(file_).between(extract_.extract()), convention_.convention(),
        has_body ? replay::Body::known : replay::Body::unknown,
        smooth_ ? recording::Smoothing::within_noise : recording::Smoothing::none);
  } else if (scene.motion.recording_file) {
    require_nothing_computed(scene.motion.recording_file->file);
    scene.motion.recording_file = with_options(*scene.motion.recording_file);
    scene::propose_keys([&] { replay::show_own_recording(scene); });
  } else {
    require_recorded();
  }
}

}  // namespace twrench::app
