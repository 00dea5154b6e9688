#include "cli/every_command.h"

#include <fmt/format.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/time_unit.h"

namespace twrench {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using Rows = std::vector<std::vector<double>>;

/// The numbers of a CSV text below its header.
Rows rows_of(const std::string& csv) {
  Rows rows;
  std::istringstream lines(csv.substr(std::min(csv.find('\n'), csv.size() - 1) + 1));
  for (std::string line; std::getline(lines, line);) {
    std::vector<double>& row = rows.emplace_back();
    const char* at = line.c_str();
    for (char* end = nullptr;; at = end + 1) {
      row.push_back(std::strtod(at, &end));
      if (*end != ',') break;
    }
  }
  return rows;
}

bool all_finite(const std::vector<double>& row) {
  return std::ranges::all_of(row, [](double value) { return std::isfinite(value); });
}

class EveryCommand {
 public:
  EveryCommand(const CommandSubject& subject, const std::filesystem::path& folder,
               const RunCommand& run)
      : subject_(subject),
        scene_(subject.scene),
        folder_(folder),
        run_(run),
        body_(scene::free_body(scene_)) {
    if (!body_.is_rigid()) return;
    const motion::ExactMotion motion(body_);
    const auto flips = motion.flips();
    if (flips && flips->turns_over()) flips_ = motion.flip_times(scene_.motion.duration);
  }

  void tables();
  void plots();
  void reports(Thoroughness thoroughness);
  void exports();
  void film(Thoroughness thoroughness);
  std::vector<std::string> faults() && { return std::move(faults_); }

 private:
  void expect(bool is_so, const std::string& what) {
    if (!is_so) faults_.push_back(what);
  }
  /// Returns the standard output of a run, which must succeed.
  std::string done(const std::string& command, const std::string& words, const std::string& more) {
    const CommandEnd end = run_(command + " " + words + " " + more);
    expect(end.code == 0,
           fmt::format("{} {} {}: exit {}: {}", command, words, more, end.code, end.err));
    return end.out;
  }
  /// The motion on a page has its own duration, or one of three to five times between flips.
  void expect_duration_of(const std::string& page) {
    const std::string key = "\"duration\":";
    const std::size_t at = page.find(key);
    const double shown = at == std::string::npos ? 0 : std::strtod(&page[at + key.size()], nullptr);
    const auto flips = body_.is_rigid() ? motion::ExactMotion(body_).flips() : std::nullopt;
    const double between = flips ? flips->interval : 0;
    expect(shown == scene_.motion.duration ||
               (between > 0 && shown > 2.999 * between && shown < 5.001 * between),
           fmt::format("page: a duration of {} s", shown));
  }
  std::string text_of(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  json json_of(const std::string& text, const std::string& what) {
    json document = json::parse(text, nullptr, false);
    expect(!document.is_discarded(), what + ": no JSON");
    return document;
  }
  /// Two times, one before and one after the first flip.
  std::pair<double, double> around_first_flip() const {
    const double next = flips_.size() > 1 ? flips_[1] : scene_.motion.duration;
    return {flips_[0] / 2, (flips_[0] + next) / 2};
  }

  const CommandSubject& subject_;
  const scene::Scene& scene_;
  const std::filesystem::path& folder_;
  const RunCommand& run_;
  motion::FreeBody body_;
  std::vector<double> flips_;  ///< s; empty for a body that does not turn over
  std::vector<std::string> faults_;
};

void EveryCommand::tables() {
  done("simulate", subject_.words, "-o motion.csv");
  const Rows rows = rows_of(text_of("motion.csv"));
  expect(rows.size() >= 200 && rows.size() <= 100'000, fmt::format("{} rows", rows.size()));
  if (rows.empty()) return;
  expect(rows.front()[0] == 0 && rows.back()[0] == scene_.motion.duration,
         "the table does not cover the duration");
  const std::size_t columns = body_.energy_loss() > 0 ? 16 : 17;  // without energy_drift
  const Vector3d middle = body_.principal().axes.col(1);
  std::size_t changes = 0;
  double last = 0;
  for (const std::vector<double>& row : rows) {
    if (row.size() != columns || !all_finite(row)) {
      return expect(false, fmt::format("a row without {} numbers", columns));
    }
    const double component = middle.dot(Vector3d(row[10], row[11], row[12]));
    if (component * last < 0) ++changes;
    last = component;
  }
  if (!flips_.empty()) {
    expect(changes == flips_.size(),
           fmt::format("{} flips in the table, not {}", changes, flips_.size()));
  }
  done("simulate", subject_.words, "--format json -o motion.json");
  const json document = json_of(text_of("motion.json"), "simulate");
  if (document.contains("samples")) {
    expect(document["samples"].size() == rows.size(), "JSON and CSV have other samples");
  }
  if (!body_.is_rigid()) {
    const CommandEnd end = run_("check motion.csv " + subject_.checked_body);
    return expect(end.code == 2 && end.err.find("needs the closed form") != std::string::npos,
                  "check: does not say that it needs a rigid body: " + end.err);
  }
  const json judged = json_of(
      done("check", "motion.csv " + subject_.checked_body, "--format json --no-fail"), "check");
  // In a fast flip the attitude depends on rounding, but the written rates are exact.
  if (judged.contains("energy_drift")) {
    expect(std::abs(judged["energy_drift"].get<double>()) < 1e-3, "check: the energy drifts");
    expect(judged["flips"].size() >= flips_.size(), "check: flips are missing");
  }
}

void EveryCommand::plots() {
  done("plot", subject_.words, "-o plot.svg");
  const std::string svg = text_of("plot.svg");
  const TimeUnit unit = time_unit(scene_.motion.duration);
  const double longest = scene_.motion.duration / unit.length;
  expect(svg.find(fmt::format("t ({})", unit.name)) != std::string::npos,
         fmt::format("plot: the axis is not in {}", unit.name));
  expect(longest >= 0.09 && longest < 1e6, fmt::format("{} {} read badly", longest, unit.name));
  expect(svg.find("flips") != std::string::npos || flips_.empty(), "plot: no flips");
}

void EveryCommand::reports(Thoroughness thoroughness) {
  const json inertia = json_of(done("inertia", subject_.body, "--format json"), "inertia");
  if (inertia.contains("principal_moments")) {
    for (const json& moment : inertia["principal_moments"]) {
      expect(moment.is_number() && moment.get<double>() > 0, "inertia: no moment");
    }
  }
  const std::string methods = body_.is_rigid() ? "rk4,exact" : "rk4";
  const json study =
      json_of(done("study", subject_.words, "--methods " + methods + " --format json"), "study");
  if (study.contains("methods")) {
    for (const json& method : study["methods"]) {
      expect(std::ranges::any_of(method["runs"],
                                 [](const json& run) { return !run.contains("failure"); }),
             "study: every run of a method failed: " + method.dump());
    }
  }
  if (thoroughness == Thoroughness::quick) return;
  done("report", subject_.words, "-o report.md");
  const std::string report = text_of("report.md");
  expect(report.find("nan") == std::string::npos, "report: nan");
  expect(flips_.empty() || report.find(fmt::format("Flips: {0} predicted, {0} seen",
                                                   flips_.size())) != std::string::npos,
         "report: no flips");
  done("report", subject_.words, "--static -o report.html");
}

void EveryCommand::exports() {
  done("export", subject_.words, "-o motion.aem");
  const std::string aem = text_of("motion.aem");
  const auto lines = std::ranges::count(aem, '\n');
  expect(lines > 40 && lines < 100'000, fmt::format("{} lines of AEM", lines));
  done("export", subject_.words, "-o motion.glb");
  const std::string glb = text_of("motion.glb");
  expect(glb.starts_with("glTF") && glb.size() < 20'000'000,
         fmt::format("{} bytes of glTF", glb.size()));
  done("export", subject_.words, "-o again.csv");
  expect(text_of("again.csv") == text_of("motion.csv"), "export and simulate differ");
  std::ofstream(folder_ / "template.html")
      << "{{title}} {{title}} <!-- twrench:poster --> <!-- twrench:scene -->";
  done("page", subject_.words, "--template template.html --size 160x90 -o page.html");
  expect_duration_of(text_of("page.html"));
}

void EveryCommand::film(Thoroughness thoroughness) {
  const int count = scene_.frame_count();
  expect(count >= 300 && count <= 7200, fmt::format("{} frames", count));
  const bool flips = !flips_.empty() && scene_.shots.empty();
  const auto frame_at = [&](double t) {
    const double frame = t * scene_.film.fps / scene_.film.speed;
    return std::clamp(static_cast<int>(std::lround(frame)), 0, count - 1);
  };
  const auto [before, after] = flips ? around_first_flip() : std::pair(0.0, 0.0);
  const int first = frame_at(before), second = flips ? frame_at(after) : count - 1;
  const std::string drawn =
      fmt::format("--size 64x36 --samples 1 --progress none --frames {},{}", first, second);
  done("render", subject_.words, drawn + " --no-video --frames-dir frames");
  const json manifest = json_of(text_of("frames/manifest.json"), "the manifest");
  if (!manifest.contains("frames")) return;
  std::vector<double> components;  // of L along the intermediate axis
  for (const json& frame : manifest["frames"]) {
    const auto X = frame["X"].get<std::vector<double>>();
    expect(all_finite(X), "a frame without attitude");
    components.push_back(body_.momentum().dot(
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(X.data()) *
        body_.principal().axes.col(1)));
  }
  expect(components.size() == 2, "not two frames");
  if (flips) expect(components.front() * components.back() < 0, "no flip in the film");
  if (thoroughness == Thoroughness::quick) return;
  done("render", subject_.words, drawn + " --no-frames -o film.mp4");
  expect(text_of("film.mp4").size() > 500, "no video");
}

}  // namespace

std::vector<std::string> faults_of_every_command(const CommandSubject& subject,
                                                 const std::filesystem::path& folder,
                                                 const RunCommand& run, Thoroughness thoroughness) {
  EveryCommand commands(subject, folder, run);
  commands.tables();
  commands.plots();
  commands.reports(thoroughness);
  commands.exports();
  commands.film(thoroughness);
  return std::move(commands).faults();
}

}  // namespace twrench
