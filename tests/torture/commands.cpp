// torture_commands SECONDS SEED [CASE]: runs random command lines, made from each command's own
// table of options, with the real program in a folder full of traps, until the time is over; or a
// single one of them. Case k is drawn by a generator seeded only from SEED and k. Faults are: a
// wrong end or output of the run (messages.h); a file that was not requested; a changed input or
// unrelated file; a file of another kind, replaced without --overwrite; an output that is missing
// although the run succeeded; invalid JSON; a small run that takes 120 seconds; and a long run that
// ignores SIGTERM.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "command_line.h"
#include "messages.h"
#include "playground.h"
#include "program.h"
#include "snapshot.h"
#include "torture.h"

namespace twrench::torture {
namespace {

namespace fs = std::filesystem;

/// The path of a name on the command line, relative to the folder of the run.
std::string place_of(const std::string& name, const fs::path& folder) {
  fs::path path = fs::path(name).lexically_normal();
  std::error_code failed;
  if (fs::is_symlink(folder / path, failed)) {
    path = (path.parent_path() / fs::read_symlink(folder / path, failed)).lexically_normal();
  }
  std::string text = path.string();
  while (text.size() > 1 && text.ends_with('/')) text.pop_back();
  return text;
}

/// The outputs that a command was asked to write.
struct Asked {
  std::set<std::string> files;
  std::set<std::string> frame_folders;
  std::string figures;  ///< beginning of the names of a report's figures, if not empty

  bool covers(const std::string& path) const {
    if (files.contains(path)) return true;
    if (!figures.empty() && path.starts_with(figures) && path.ends_with(".svg")) return true;
    static const std::regex in_frames("(frame_[0-9]{6,8}\\.png|manifest.*\\.json)");
    const fs::path as_path(path);
    const std::string folder = as_path.has_parent_path() ? as_path.parent_path().string() : ".";
    return frame_folders.contains(folder) &&
           std::regex_match(as_path.filename().string(), in_frames);
  }
  /// Whether the folder is an ancestor of a requested output.
  bool leads_through(const std::string& folder) const {
    const auto is_below = [&](const std::string& path) { return path.starts_with(folder + "/"); };
    return frame_folders.contains(folder) || std::ranges::any_of(files, is_below) ||
           std::ranges::any_of(frame_folders, is_below);
  }
};

/// The default name of the outputs: that of the scene, else that of the recording.
std::string default_name(const CommandLine& line) {
  const std::string recording = line.value("motion", "dzhanibekov");
  return fs::path(line.arguments.empty() ? recording : line.arguments.front()).stem().string();
}

/// Whether the first argument, a picture or a folder of them, is an output too.
bool replaces_expected(const CommandLine& line) {
  return line.command == "compare" && line.has("update") && !line.arguments.empty();
}

Asked asked_by(const CommandLine& line, const fs::path& folder) {
  Asked asked;
  const auto add_file = [&](const std::string& name) {
    asked.files.insert(place_of(name, folder));
  };
  for (const char* option : {"output", "diff", "plot", "report", "fix"}) {
    if (line.has(option)) add_file(line.value(option));
  }
  if (line.command == "report" && !asked.files.empty()) {
    const fs::path report(*asked.files.begin());
    asked.figures = (report.parent_path() / report.stem()).string() + "-";
  }
  if (line.command == "render") {
    const std::string as_scene = "out/" + default_name(line);
    const fs::path video = line.value("output", as_scene + ".mp4");
    add_file(video.string());
    // Standard output and devices have no ending.
    const std::string frames =
        video.has_extension() ? (video.parent_path() / video.stem()).string() : as_scene;
    asked.frame_folders.insert(place_of(line.value("frames-dir", frames), folder));
  }
  if (replaces_expected(line)) {
    add_file(line.arguments.front());
    asked.frame_folders.insert(place_of(line.arguments.front(), folder));
  }
  if (line.command == "render" || line.command == "encode") {
    for (const std::string& video : std::set(asked.files)) {
      asked.files.insert(fs::path(video).replace_extension(".vtt").string());
      asked.files.insert(fs::path(video).replace_extension(".chapters.vtt").string());
    }
  }
  return asked;
}

std::set<std::string> inputs_of(const CommandLine& line, const fs::path& folder) {
  std::set<std::string> inputs;
  for (const std::string& argument : line.arguments) inputs.insert(place_of(argument, folder));
  if (replaces_expected(line)) inputs.erase(place_of(line.arguments.front(), folder));
  if (line.has("font")) inputs.insert(place_of(line.value("font"), folder));
  return inputs;
}

/// Whether the command wrote this file of the playground as the same kind of output.
bool is_own_output(const CommandLine& line, const std::string& path) {
  static const std::regex own("own_([a-z]+)\\..*");
  std::smatch found;
  if (!std::regex_match(path, found, own)) return false;
  if (line.has("plot") && place_of(line.value("plot"), {}) == path) return found[1] == "plot";
  const bool are_motions = found[1] == "simulate" && line.command == "export";
  return found[1] == line.command || are_motions;
}

/// A case that was run, with the folder before and after.
struct Tried {
  CommandLine line;
  Ended ended;
  Snapshot before, after;
  Asked asked;
  std::set<std::string> inputs;

  bool succeeded() const { return ended.code == 0 || ended.code == 1; }
};

using Faults = std::vector<std::string>;

std::string printable(const std::string& path) { return shell_quoted({path}); }

/// Existing entries must be unchanged unless the command was to replace them.
void judge_old_entries(const Tried& tried, Faults& faults) {
  for (const auto& [path, was] : tried.before) {
    const auto found = tried.after.find(path);
    if (found == tried.after.end()) {
      faults.push_back("removed: " + printable(path));
      continue;
    }
    const Entry& is = found->second;
    if (is == was) continue;
    if (is.type == was.type && is.mode != was.mode)
      faults.push_back("another mode: " + printable(path));
    const bool is_frame = !tried.asked.files.contains(path) && tried.asked.covers(path);
    const bool goes_on =
        path.ends_with("/manifest.json") && !path.starts_with("m_") && tried.line.has("resume");
    if (is.type != was.type) {
      faults.push_back("no longer of its kind: " + printable(path));
    } else if (is.content == was.content) {
      continue;
    } else if (tried.inputs.contains(path)) {
      faults.push_back("an input was written over: " + printable(path));
    } else if (!tried.asked.covers(path)) {
      faults.push_back("changed unasked: " + printable(path));
    } else if (is_frame && !goes_on && !tried.line.has("overwrite") &&
               !replaces_expected(tried.line)) {
      faults.push_back("frames written over without --overwrite: " + printable(path));
    } else if (!is_frame && !tried.line.has("overwrite") && !replaces_expected(tried.line) &&
               !is_own_output(tried.line, path)) {
      faults.push_back("another file was written over without --overwrite: " + printable(path));
    } else if (!is_frame && !tried.succeeded()) {
      faults.push_back("changed by a run that failed: " + printable(path));
    }
  }
}

/// New entries must have been requested; a rejected command must create none.
void judge_new_entries(const Tried& tried, Faults& faults) {
  for (const auto& [path, entry] : tried.after) {
    if (tried.before.contains(path)) continue;
    const bool is_folder = entry.type == fs::file_type::directory;
    if (is_folder ? !tried.asked.leads_through(path) : !tried.asked.covers(path)) {
      faults.push_back("left, and not asked for: " + printable(path));
    } else if (tried.ended.code == 2) {
      faults.push_back("left by a run that was refused: " + printable(path));
    } else if (!is_folder && tried.asked.files.contains(path) && !tried.succeeded()) {
      faults.push_back("left by a run that failed: " + printable(path));
    }
  }
}

void judge_output(const Tried& tried, const fs::path& folder, Faults& faults) {
  const CommandLine& line = tried.line;
  if (tried.ended.code != 0 || line.has("help") || line.has("no-video")) return;
  for (const char* option : {"output", "diff", "plot"}) {
    const std::string name = line.value(option, "-");
    std::error_code failed;
    const fs::path path = folder / name;
    if (name == "-" || (fs::exists(path, failed) && !fs::is_regular_file(path, failed))) continue;
    if (fs::file_size(path, failed) == 0 || failed) {
      faults.push_back("not there, or empty: " + printable(name));
    }
  }
}

bool is_json(const std::string& text) { return nlohmann::json::accept(text); }

void judge_json(const Tried& tried, Faults& faults) {
  const CommandLine& line = tried.line;
  if (!tried.succeeded() || tried.ended.out.size() >= std::size_t{4} << 20U) return;
  if (line.value("format") == "json" && line.value("output", "-") == "-" &&
      !is_json(tried.ended.out)) {
    faults.emplace_back("no JSON on standard output");
  }
  if (line.value("progress") == "json" && (!line.has("timing") || line.value("timing") == "json")) {
    std::istringstream lines(tried.ended.err);
    for (std::string text; std::getline(lines, text);) {
      if (is_json(text) || text.starts_with("twrench: warning: ")) continue;
      faults.push_back("a line of --progress json that is none: " + printable(text));
      break;
    }
  }
}

Manner manner_of(const CommandLine& line) {
  const std::string progress = line.value("progress", "auto");
  Manner manner;
  manner.has_progress = line.is_odd || progress != "none";
  manner.has_bar = line.is_odd || progress == "bar";
  const std::string output = line.value("output");
  const bool is_film = line.command == "render" || line.command == "encode";
  manner.out_is_text =
      line.value("format") != "npz" && (!is_film || (output != "-" && output != "/dev/stdout"));
  const auto is_help = [](const std::string& word) {
    return word == "-h" || word.starts_with("--help");
  };
  manner.may_name_infinity = line.command == "schema" || std::ranges::any_of(line.words, is_help);
  return manner;
}

class Commands {
 public:
  explicit Commands(std::uint32_t seed)
      : seed_(seed), scratch_(make_scratch_folder("commands")), table_(read_option_table()) {
    fs::create_directories(scratch_ / "template");
    set_environment();
    furnish(scratch_ / "template", TWRENCH_BINARY);
    put_loud_programs(scratch_ / "loud");
  }
  ~Commands() { remove_folder(scratch_); }
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;

  /// Runs case `number` and reports its faults; with `aloud` also the command.
  void try_case(std::uint32_t number, bool aloud);

  std::size_t faults() const { return faults_; }

 private:
  void set_environment() const {
    // NOLINTBEGIN(concurrency-mt-unsafe): there is one thread yet
    fs::create_directories(scratch_ / "home");
    ::setenv("HOME", (scratch_ / "home").c_str(), 1);
    ::setenv("XDG_CACHE_HOME", (scratch_ / "home").c_str(), 1);
    ::setenv("LC_ALL", "C.UTF-8", 1);
    // NOLINTEND(concurrency-mt-unsafe)
  }
  Tried run_case(const CommandLine& line, const fs::path& folder) const;

  std::uint32_t seed_;
  fs::path scratch_;
  OptionTable table_;
  std::mutex counting_;
  std::size_t faults_ = 0;
};

Tried Commands::run_case(const CommandLine& line, const fs::path& folder) const {
  const fs::path work = folder / "work";
  fs::create_directories(work);
  copy_playground(scratch_ / "template", work);
  Tried tried{line, {}, take_snapshot(work), {}, asked_by(line, work), inputs_of(line, work)};
  Program program{{}, work, folder / "said"};
  if (!line.piped_scene.empty()) {
    // The program replaces the shell, so that it receives the signals. If the scene is a pipe,
    // possibly no process ever writes to it.
    program.command = {"bash", "-c",
                       R"(scene=$1; shift; exec "$@" < <(timeout 60 cat -- "$scene" 2>/dev/null))",
                       "bash", line.piped_scene};
  }
  if (line.has_loud_children) {
    const std::string path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    program.command.insert(program.command.end(),
                           {"env", "PATH=" + (scratch_ / "loud").string() + ":" + path});
  }
  program.command.emplace_back(TWRENCH_BINARY);
  program.command.insert(program.command.end(), line.words.begin(), line.words.end());
  if (line.may_last || line.is_odd) program.until_asked = Seconds(4);
  tried.ended = run(program);
  tried.after = take_snapshot(work);
  return tried;
}

void Commands::try_case(std::uint32_t number, bool aloud) {
  Dice dice(seed_, number);
  const CommandLine line = random_command_line(table_, dice);
  const fs::path folder = scratch_ / fmt::format("case{}", number);
  const Tried tried = run_case(line, folder);
  Faults faults = faults_in_manner(tried.ended, manner_of(line));
  if (tried.ended.asked_to_stop && !line.may_last && !line.is_odd) {
    faults.emplace_back("it takes more than 120 s");
  }
  if (line.has_one_output_twice && tried.succeeded() && !line.is_odd && !line.has("help")) {
    faults.emplace_back("two of its outputs are one file");
  }
  if (!line.is_odd) {
    judge_old_entries(tried, faults);
    judge_new_entries(tried, faults);
    judge_output(tried, folder / "work", faults);
    judge_json(tried, faults);
  }
  remove_folder(folder);
  if (faults.empty() && !aloud) return;
  std::vector<std::string> words{"twrench"};
  words.insert(words.end(), line.words.begin(), line.words.end());
  std::string text = fmt::format("commands: seed {}, case {}: exit {}\n  {}\n", seed_, number,
                                 tried.ended.code, shell_quoted(words));
  for (const std::string& fault : faults) text += fmt::format("  fault: {}\n", fault);
  text += fmt::format("  said: {}\n", printable(tried.ended.err.substr(0, 400)));
  tell(text);
  const std::lock_guard lock(counting_);
  faults_ += faults.size();
}

int run_all(const Request& request) {
  Commands commands(request.seed);
  std::size_t ran = 1;
  if (request.only.empty()) {
    constexpr std::size_t most = 100'000'000;
    ran = run_cases(request.seconds, most,
                    [&](std::uint32_t number) { commands.try_case(number, false); });
  } else {
    commands.try_case(static_cast<std::uint32_t>(std::stoul(request.only)), true);
  }
  tell(fmt::format("commands: {} ran, {} faults\n", ran, commands.faults()));
  return commands.faults() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace twrench::torture

int main(int argc, char** argv) try {
  const auto request = twrench::torture::parse_request(argc, argv);
  twrench::torture::become_nobody(TWRENCH_BINARY);
  return twrench::torture::run_all(request);
} catch (const std::exception& error) {
  twrench::torture::tell(fmt::format("torture_commands: {}\n", error.what()));
  return 2;
}
