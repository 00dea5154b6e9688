#include "fault_scenarios.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "program.h"
#include "system/bytes.h"
#include "system/file.h"

namespace twrench::torture {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The words of a render of six frames.
Words film(const Words& more) {
  return joined({"render", "--size", "64x48", "--duration", "6", "--fps", "6", "--speed", "6",
                 "--progress", "none", "--jobs", "2"},
                more);
}

Words other_film(const Words& more) { return joined(film(more), {"--omega", "0.1,2,0.3"}); }

void make(const fs::path& folder, const fs::path& twrench, const Words& words) {
  const Ended ended = run({joined({twrench.string()}, words), folder, folder.string() + ".said"});
  if (ended.code != 0) {
    throw std::runtime_error(shell_quoted(words) + " fails undisturbed: " + ended.err);
  }
}

bool is_manifest(const std::string& path) { return fs::path(path).filename() == "manifest.json"; }

/// Why the manifest does not match the frames next to it; empty if it does.
std::string objection_to_manifest(const fs::path& path) {
  try {
    const auto bytes = system::read_file(path, std::size_t{1} << 26U);
    const auto manifest = nlohmann::json::parse(bytes.begin(), bytes.end());
    for (const auto& frame : manifest.at("frames")) {
      const fs::path file = path.parent_path() / frame.at("file").get<std::string>();
      if (system::sha256_hex(system::read_file(file, std::size_t{1} << 26U)) !=
          frame.at("sha256").get<std::string>()) {
        return file.filename().string() + " is not the file that the manifest records";
      }
    }
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::vector<std::string> faults_of_manifests(const Snapshot& after, const fs::path& folder) {
  std::vector<std::string> faults;
  for (const auto& [path, entry] : after) {
    if (!is_manifest(path)) continue;
    const std::string objection = objection_to_manifest(folder / path);
    if (!objection.empty()) faults.push_back(fmt::format("{}: {}", path, objection));
  }
  return faults;
}

}  // namespace

std::vector<Scenario> all_scenarios() {
  const Words over{"--overwrite"};
  const auto simple = [](const std::string& name, const Words& words, long memory_points) {
    return Scenario{name, words, words, 0, memory_points, false};
  };
  const Words in_new{"--frames-dir", "new", "-o", "new.mp4"};
  const Words in_part{"--frames-dir", "part", "-o", "part.mp4", "--resume"};
  const Words in_old{"--frames-dir", "old", "-o", "old.mp4", "--overwrite"};
  std::vector<Scenario> scenarios{
      {"render", film(in_new), joined(film(in_new), {"--resume"}), 0, 1000, false},
      simple("resume", film(in_part), 500),
      simple("overwrite", film(in_old), 500),
      simple("encode", joined({"encode", "frames", "-o", "old.mp4", "--progress", "none"}, over),
             1000),
      simple("simulate",
             joined({"simulate", "--duration", "1", "--fps", "20", "-o", "old.csv"}, over), 2000),
      simple("simulate-json",
             joined({"simulate", "--method", "rk4", "--duration", "1", "--fps", "20", "--format",
                     "json", "-o", "old.json"},
                    over),
             1000),
      simple("inertia",
             joined({"inertia", "scene.toml", "--format", "json", "-o", "old.json"}, over), 2000),
      simple("compare", joined({"compare", "a.png", "b.png", "--diff", "old.png"}, over), 1000),
      simple("export", joined({"export", "--duration", "1", "-o", "old.glb"}, over), 2000),
      simple("study",
             joined({"study", "--duration", "1", "--methods", "rk4", "--steps", "0.1,0.05",
                     "--format", "json", "-o", "old.json"},
                    over),
             1000)};
  scenarios[7].code = 1;
  scenarios.back().varies = true;
  return scenarios;
}

void furnish_scenarios(const fs::path& folder, const fs::path& twrench) {
  system::write_file_atomically(folder / "scene.toml",
                                "[[part]]\nshape = \"box\"\nsize = [1, 2, 3]\ndensity = 2\n");
  make(folder, twrench, film({"--frames-dir", "frames", "--no-video"}));
  make(folder, twrench, film({"--frames-dir", "part", "--no-video", "--frames", "0-2"}));
  make(folder, twrench, other_film({"--frames-dir", "old", "-o", "old.mp4"}));
  fs::copy_file(folder / "frames/frame_000000.png", folder / "a.png");
  fs::copy_file(folder / "frames/frame_000005.png", folder / "b.png");
  fs::copy_file(folder / "frames/frame_000001.png", folder / "old.png");
  for (const char* name : {"old.csv", "old.json", "old.glb"})
    system::write_file_atomically(folder / name, "old\n");
}

std::vector<std::string> faults_in_files(const Course& course, const fs::path& folder) {
  std::vector<std::string> faults = faults_of_manifests(course.after, folder);
  for (const auto& [path, was] : course.before) {
    const auto is = course.after.find(path);
    // Frames to be replaced are removed before the first frame of the other video.
    if (is == course.after.end()) {
      if (path != "old/manifest.json") faults.push_back("removed: " + path);
    } else if (!is_manifest(path) && is->second != was && !course.scenario.varies &&
               is->second != course.undisturbed.at(path)) {
      faults.push_back("neither as it was nor whole and new: " + path);
    }
  }
  for (const auto& [path, entry] : course.after) {
    if (course.before.contains(path)) continue;
    const auto expected = course.undisturbed.find(path);
    if (expected == course.undisturbed.end()) {
      faults.push_back("left, and not asked for: " + path);
    } else if (!is_manifest(path) && entry != expected->second) {
      faults.push_back("not whole: " + path);
    }
  }
  return faults;
}

std::vector<std::string> faults_at_the_end(const Course& course, const fs::path& folder) {
  std::vector<std::string> faults = faults_in_files(course, folder);
  for (const auto& [path, expected] : course.undisturbed) {
    const auto is = course.after.find(path);
    const bool varies = is_manifest(path) || course.scenario.varies;
    if (is == course.after.end()) {
      faults.push_back("not there: " + path);
    } else if (is->second != expected && !varies) {
      faults.push_back("not as an undisturbed run makes it: " + path);
    }
  }
  return faults;
}

}  // namespace twrench::torture
