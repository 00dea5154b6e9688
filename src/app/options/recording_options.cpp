#include "app/options/recording_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "recording/recording.h"
#include "replay/replay.h"
#include "scene/limits.h"

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
  convention_.add_to(command);
}

std::vector<std::string> RecordingOptions::given() const {
  std::vector<std::string> words;
  if (!file_.empty()) words = {"--motion", file_};
  for (const std::vector<std::string>& more : {extract_.given(), convention_.given()}) {
    words.insert(words.end(), more.begin(), more.end());
  }
  return words;
}

void RecordingOptions::apply(scene::Scene& scene, bool has_body) const {
  if (command_ == nullptr) return;
  if (file_.empty()) {
    const std::vector<std::string> others = given();
    if (others.empty()) return;
    throw InvalidArgument(others.front(), "it applies to a recorded motion, and there is none",
                          "give the recording with --motion FILE, or leave the option out");
  }
  for (const char* option : {"--omega", "--method"}) {
    if (command_->count(option) == 0) continue;
    throw InvalidArgument(option, "the motion is recorded in " + file_,
                          "leave it out; --compare exact shows the free motion beside it");
  }
  replay::show_recording(scene, recording::Recording(file_).between(extract_.extract()),
                         convention_.convention(),
                         has_body ? replay::Body::known : replay::Body::unknown);
}

}  // namespace twrench::app
