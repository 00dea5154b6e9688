#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/terminal/error_report.h"
#include "app/terminal/message.h"
#include "canvas/font.h"
#include "gl/backend.h"
#include "plot/gnuplot.h"
#include "system/descriptor.h"
#include "system/file.h"
#include "system/output.h"
#include "system/processors.h"
#include "system/program.h"
#include "video/encoder.h"
#include "video/error.h"
#include "video/sound_track.h"

namespace twrench::app {
namespace {

/// The result of one check of the machine.
struct Finding {
  std::string name;
  std::string used_for;
  std::string found;   ///< description, such as the version; empty if it is missing
  std::string why;     ///< why it is missing
  std::string remedy;  ///< how to provide it if it is missing

  bool is_ready() const { return !found.empty(); }
};

/// Returns the result of `look`, or the Error that it throws.
Finding examine(std::string name, std::string used_for, const std::function<std::string()>& look) {
  Finding finding{std::move(name), std::move(used_for), {}, {}, {}};
  try {
    finding.found = look();
  } catch (const Error& error) {
    finding.why = error.what();
    finding.remedy = remedy_for(error);
  }
  return finding;
}

std::vector<Finding> examine_backends() {
  const std::vector<gl::BackendReport> reports = gl::backends();
  std::vector<Finding> findings;
  findings.reserve(reports.size());
  for (const gl::BackendReport& report : reports) {
    findings.push_back(examine("OpenGL by " + report.name, "drawing", [&] {
      if (report.failure) std::rethrow_exception(report.failure);
      return report.renderer;
    }));
  }
  const auto usable = std::ranges::find_if(findings, &Finding::is_ready);
  if (usable == findings.end()) return findings;
  for (Finding& finding : findings) {
    if (!finding.is_ready())
      finding.used_for += fmt::format("; not needed: {} is available", usable->name);
  }
  return findings;
}

/// The first line that `ffmpeg -version` prints.
std::string ffmpeg_version() {
  const system::MemoryFile output("");
  auto ffmpeg = system::start_program<video::EncoderError>(
      {"ffmpeg", "-version"}, video::ffmpeg_remedy, {}, output.descriptor());
  ffmpeg.wait();
  const std::string text = output.contents();
  const std::string line = text.substr(0, text.find('\n'));
  return line.empty() ? "unknown version" : line;
}

/// Checks the codec of each output format, in order, with alpha if the codec supports it.
std::vector<Finding> examine_codecs() {
  std::vector<Finding> findings;
  std::set<const video::Codec*> examined{nullptr};
  for (const video::OutputFormat& output : video::output_formats()) {
    for (const bool alpha : {true, false}) {
      const video::Codec* const codec = output.encoding(alpha).codec;
      if (!examined.insert(codec).second) continue;
      findings.push_back(examine(fmt::format("ffmpeg's {}", codec->name), codec->use, [&] {
        // The size of the trial does not matter: render tries the encoder with that of its film.
        video::require_encoder({320, 180, 60, output.container, alpha});
        return "encoded a test video";
      }));
    }
  }
  return findings;
}

/// Checks each codec for sound.
std::vector<Finding> examine_sound_codecs() {
  std::vector<Finding> findings;
  std::set<const video::SoundCodec*> examined{nullptr};
  for (const video::OutputFormat& output : video::output_formats()) {
    if (!examined.insert(output.sound).second) continue;
    findings.push_back(
        examine(fmt::format("ffmpeg's {}", output.sound->name), output.sound->use, [&] {
          const std::vector<float> silence(9600);
          video::SoundTrack({.files = {},
                             .motion = [&](const auto& sink) { sink(silence); },
                             .end = 0.1,
                             .film_length = 0.1},
                            output.container);
          return "encoded a test sound";
        }));
  }
  return findings;
}

std::string figure_formats() {
  for (const auto& format : system::plot_output.formats) plot::require_gnuplot(format);
  return "writes SVG, PDF and PNG";
}

/// Checks that a file can be created in the folder or, if that does not exist, in its nearest
/// existing parent.
std::string try_to_write_in(const std::string& folder) {
  const system::PendingFile trial(system::existing_folder(folder) / "trial");  // removed again
  return system::format_bytes(static_cast<double>(system::free_space(folder))) + " free";
}

struct Diagnosis {
  std::vector<Finding> backends;  ///< one of these is enough
  std::vector<Finding> encoder;   ///< all are required
  std::vector<Finding> disk;      ///< all are required
  std::vector<Finding> others;

  ExitCode code() const {
    const auto is_ready = [](const Finding& finding) { return finding.is_ready(); };
    if (std::ranges::none_of(backends, is_ready)) return ExitCode::no_gl;
    if (!std::ranges::all_of(encoder, is_ready)) return ExitCode::encoder;
    return std::ranges::all_of(disk, is_ready) ? ExitCode::done : ExitCode::file;
  }

  std::vector<Finding> all() const {
    std::vector<Finding> findings = backends;
    findings.insert(findings.end(), encoder.begin(), encoder.end());
    findings.insert(findings.end(), disk.begin(), disk.end());
    findings.insert(findings.end(), others.begin(), others.end());
    return findings;
  }
};

Diagnosis diagnose() {
  Diagnosis diagnosis;
  diagnosis.backends = examine_backends();
  diagnosis.encoder.push_back(examine("ffmpeg", "videos", &ffmpeg_version));
  const std::vector<Finding> codecs = examine_codecs();
  diagnosis.encoder.push_back(codecs.front());  // that of MP4, the default container
  diagnosis.others.assign(codecs.begin() + 1, codecs.end());
  const std::vector<Finding> sound_codecs = examine_sound_codecs();
  diagnosis.others.insert(diagnosis.others.end(), sound_codecs.begin(), sound_codecs.end());
  diagnosis.disk.push_back(examine("disk",
                                   "frames and videos in out/; -o and --frames-dir choose "
                                   "other folders",
                                   [] { return try_to_write_in("out"); }));
  diagnosis.others.push_back(examine("fonts", "text in the picture", [] {
    for (const char* name : {"sans", "mono"}) canvas::load_typeface(name);
    return "sans and mono, built in";
  }));
  diagnosis.others.push_back(
      examine("gnuplot", "plot and study --plot; videos do not need it", &figure_formats));
  diagnosis.others.push_back(examine("processors", "drawing and compressing in parallel",
                                     [] { return fmt::format("{}", system::processor_count()); }));
  return diagnosis;
}

std::string as_text(const Diagnosis& diagnosis) {
  const std::vector<Finding> findings = diagnosis.all();
  const auto length = [](const Finding& finding) { return finding.name.size(); };
  const std::size_t width = length(std::ranges::max(findings, {}, length));
  std::string text;
  for (const Finding& finding : findings) {
    text += format_message("{:<{}}  {:<7}  {}\n", finding.name, width,
                           finding.is_ready() ? "found" : "missing",
                           finding.is_ready() ? finding.found : finding.why);
    if (finding.is_ready()) continue;
    text += format_message("{:<{}}  used for {}\n", "", width + 9, finding.used_for);
    if (!finding.remedy.empty())
      text += format_message("{:<{}}  {}\n", "", width + 9, finding.remedy);
  }
  return text + (diagnosis.code() == ExitCode::done ? "twrench render can run.\n"
                                                    : "twrench render cannot run.\n");
}

std::string as_json(const Diagnosis& diagnosis) {
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const Finding& finding : diagnosis.all()) {
    findings.push_back({{"name", finding.name},
                        {"used_for", finding.used_for},
                        {"is_ready", finding.is_ready()},
                        {"found", finding.found},
                        {"why", finding.why},
                        {"remedy", finding.remedy}});
  }
  const nlohmann::ordered_json whole{{"can_render", diagnosis.code() == ExitCode::done},
                                     {"findings", findings}};
  return whole.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

void add_doctor(CLI::App& app, ExitCode& code) {
  CLI::App* command = app.add_subcommand(
      "doctor", "Check this machine, and show how to install missing dependencies");
  command->footer(
      "Example: twrench doctor\nExit codes: 0 twrench render can run, 3 no OpenGL, 4 no "
      "ffmpeg, 5 the output\nfolder is not writable.");
  const auto format = std::make_shared<std::string>("text");
  command->add_option("--format", *format, "text or json")
      ->check(one_of("--format", {"text", "json"}))
      ->type_name("FORMAT")
      ->capture_default_str()
      ->group(heading(OptionGroup::output));
  command->callback([format, &code] {
    const Diagnosis diagnosis = diagnose();
    system::write_output(*format == "json" ? as_json(diagnosis) : as_text(diagnosis));
    code = diagnosis.code();
  });
}

}  // namespace twrench::app
