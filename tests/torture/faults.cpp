// torture_faults SECONDS SEED [CASE]: small runs of the real program in which one system call or
// allocation, or all from one on, fails, in a random order given by the seed, until the time is
// over or each call has failed in every way; or the single CASE,
// SCENARIO/KIND/NUMBER/ERRNO/once|always. Faults are: a wrong end or output of the run
// (messages.h); existing files that are neither unchanged nor complete and new; leftovers; a run
// that takes 120 seconds; and a repeated command, with --resume if it draws frames, that does not
// reach the result of an undisturbed run.
//
// A lack of memory may end a run with exit code 70 and the corresponding message or, if there is
// not enough memory for that, without one; such runs are counted separately.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>

#include "fault_points.h"
#include "fault_scenarios.h"
#include "messages.h"
#include "program.h"
#include "snapshot.h"
#include "system/file.h"
#include "torture.h"

namespace twrench::torture {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

std::string text_of(const fs::path& path) {
  if (!fs::exists(path)) return {};
  const auto bytes = system::read_file(path, std::size_t{1} << 24U);
  return {bytes.begin(), bytes.end()};
}

/// The callers in the program from the shim's log, innermost first.
std::string callers_in(const std::string& log) {
  static const std::regex place(R"(/twrench\(\+(0x[0-9a-f]+)\))");
  std::string places;
  for (std::sregex_iterator at(log.begin(), log.end(), place), end; at != end; ++at) {
    places.append(" ").append((*at)[1].str());
  }
  return places.empty() ? "  it was not reached\n" : "  addr2line -Cfpe twrench" + places + "\n";
}

class Faults {
 public:
  Faults() : scratch_(make_scratch_folder("faults")), scenarios_(all_scenarios()) {
    fs::create_directories(scratch_ / "home");
    // NOLINTBEGIN(concurrency-mt-unsafe): there is one thread yet
    ::setenv("XDG_CACHE_HOME", (scratch_ / "home").c_str(), 1);
    ::setenv("LC_ALL", "C.UTF-8", 1);
    // NOLINTEND(concurrency-mt-unsafe)
    fs::create_directories(scratch_ / "template");
    furnish_scenarios(scratch_ / "template", TWRENCH_BINARY);
    before_ = take_snapshot(scratch_ / "template");
    for (const Scenario& scenario : scenarios_) run_undisturbed(scenario);
  }
  ~Faults() { remove_folder(scratch_); }
  Faults(const Faults&) = delete;
  Faults& operator=(const Faults&) = delete;

  const std::vector<CallCounts>& counts() const { return counts_; }
  void try_point(const FaultPoint& point, bool aloud);
  std::string summary(std::size_t ran, std::size_t all) const;
  std::size_t faults() const { return faults_; }

 private:
  const Scenario& scenario_called(const std::string& name) const;
  void run_undisturbed(const Scenario& scenario);
  static Ended run_shimmed(const Words& words, const std::string& order, const fs::path& folder);
  /// Returns the faults of the disturbed run.
  Words judge(const FaultPoint& point, const Ended& ended);
  /// Adds the faults in the result of repeating the command.
  static void go_on(const Course& course, const fs::path& folder, Words& faults, Snapshot& after);
  static void tell_of(const FaultPoint& point, const Scenario& scenario, const Ended& ended,
                      const Words& faults, const fs::path& folder);

  fs::path scratch_;
  std::vector<Scenario> scenarios_;
  std::vector<CallCounts> counts_;
  Snapshot before_;
  std::map<std::string, Snapshot> undisturbed_;  ///< by scenario
  std::atomic<std::size_t> faults_ = 0, memory_points_ = 0, without_memory_ = 0;
};

const Scenario& Faults::scenario_called(const std::string& name) const {
  for (const Scenario& scenario : scenarios_) {
    if (scenario.name == name) return scenario;
  }
  throw std::invalid_argument("no scenario is called " + name);
}

Ended Faults::run_shimmed(const Words& words, const std::string& order, const fs::path& folder) {
  Program program{
      {"env", "LD_PRELOAD=" TWRENCH_FAULT_SHIM, "TWRENCH_FAULT_LOG=" + folder.string() + ".log"},
      folder,
      folder.string() + ".said"};
  if (!order.empty()) program.command.push_back("TWRENCH_FAULT=" + order);
  program.command.emplace_back(TWRENCH_BINARY);
  program.command.insert(program.command.end(), words.begin(), words.end());
  return run(program);
}

void Faults::run_undisturbed(const Scenario& scenario) {
  const fs::path folder = scratch_ / scenario.name;
  fs::copy(scratch_ / "template", folder, fs::copy_options::recursive);
  const Ended ended = run_shimmed(scenario.words, {}, folder);
  if (ended.code != scenario.code) {
    throw std::runtime_error(scenario.name + " fails undisturbed: " + ended.err);
  }
  undisturbed_[scenario.name] = take_snapshot(folder);
  counts_.push_back(
      {scenario.name, read_call_counts(text_of(folder.string() + ".log")), scenario.memory_points});
}

Words Faults::judge(const FaultPoint& point, const Ended& ended) {
  const bool is_memory = point.kind == "memory";
  Manner manner;
  manner.may_lack_memory = is_memory;
  manner.may_be_mute = point.always && (is_memory || point.kind == "write");
  Words faults = faults_in_manner(ended, manner);
  if (ended.asked_to_stop) faults.emplace_back("it takes more than 120 s");
  memory_points_ += is_memory ? 1 : 0;
  without_memory_ += is_memory && ended.code == 70 ? 1 : 0;
  return faults;
}

void Faults::try_point(const FaultPoint& point, bool aloud) {
  const Scenario& scenario = scenario_called(point.scenario);
  std::string name = point.text();
  std::replace(name.begin(), name.end(), '/', '-');
  const fs::path folder = scratch_ / "cases" / name;
  fs::create_directories(folder.parent_path());
  fs::copy(scratch_ / "template", folder, fs::copy_options::recursive);
  const Ended ended = run_shimmed(scenario.words, point.order(), folder);
  Words faults = judge(point, ended);
  const Snapshot& undisturbed = undisturbed_.at(point.scenario);
  Snapshot after = take_snapshot(folder);
  const bool came_through = ended.code == scenario.code;
  const Course course{scenario, before_, undisturbed, after};
  const Words in_files =
      came_through ? faults_at_the_end(course, folder) : faults_in_files(course, folder);
  faults.insert(faults.end(), in_files.begin(), in_files.end());
  if (!came_through) go_on(course, folder, faults, after);
  if (!faults.empty() || aloud) tell_of(point, scenario, ended, faults, folder);
  faults_ += faults.size();
  remove_folder(folder);
}

void Faults::go_on(const Course& course, const fs::path& folder, Words& faults, Snapshot& after) {
  Program program{{TWRENCH_BINARY}, folder, folder.string() + ".again"};
  const Words& words = course.scenario.again;
  program.command.insert(program.command.end(), words.begin(), words.end());
  const Ended again = run(program);
  after = take_snapshot(folder);
  if (again.code != course.scenario.code) {
    faults.push_back(fmt::format("the next run ends in {}: {}", again.code, again.err));
  }
  for (const std::string& fault : faults_at_the_end(course, folder)) {
    faults.push_back("after the next run: " + fault);
  }
}

void Faults::tell_of(const FaultPoint& point, const Scenario& scenario, const Ended& ended,
                     const Words& faults, const fs::path& folder) {
  std::string text = fmt::format(
      "faults: case {}: exit {}, signal {}\n  LD_PRELOAD={} TWRENCH_FAULT={} twrench {}\n",
      point.text(), ended.code, ended.signal, TWRENCH_FAULT_SHIM, point.order(),
      shell_quoted(scenario.words));
  for (const std::string& fault : faults) text += fmt::format("  fault: {}\n", fault);
  text += fmt::format("  said: {}\n", shell_quoted({ended.err.substr(0, 400)}));
  tell(text + callers_in(text_of(folder.string() + ".log")));
}

std::string Faults::summary(std::size_t ran, std::size_t all) const {
  return fmt::format(
      "faults: {} of {} points ran ({} of memory, {} of them ended for want of it), {} faults\n",
      ran, all, memory_points_.load(), without_memory_.load(), faults_.load());
}

int run_all(const Request& request) {
  Faults faults;
  if (!request.only.empty()) {
    faults.try_point(parse_fault_point(request.only), true);
    tell(faults.summary(1, 1));
  } else {
    const auto points = all_fault_points(faults.counts(), request.seed);
    const std::size_t ran = run_cases(request.seconds, points.size(), [&](std::uint32_t number) {
      faults.try_point(points[number], false);
    });
    tell(faults.summary(ran, points.size()));
  }
  return faults.faults() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace twrench::torture

int main(int argc, char** argv) try {
  return twrench::torture::run_all(twrench::torture::parse_request(argc, argv));
} catch (const std::exception& error) {
  twrench::torture::tell(fmt::format("torture_faults: {}\n", error.what()));
  return 2;
}
