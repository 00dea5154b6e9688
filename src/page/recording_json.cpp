#include "page/recording_json.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "base/words.h"
#include "page/packing.h"

namespace twrench::page {
namespace {

constexpr std::size_t most_rows = 5000;    // 430 kB of a page, if no digits repeat
constexpr double widest_deviation = 0.02;  // rad: more would be visible
constexpr std::size_t doubles_of_row = 8;

}  // namespace

PageRecording page_recording(const scene::ShownRecording& recording) {
  const motion::RecordedMotion& all = recording.motion;
  if (all.instants().size() <= most_rows) return {all, {}};
  for (double angle = 1e-9; angle <= widest_deviation; angle *= 4) {
    motion::RecordedMotion few = all.thinned(angle);
    const std::size_t rows = few.instants().size();
    if (rows > most_rows) continue;
    return {
        std::move(few),
        fmt::format("the page plays {} of the {} rows of {}; at the others the attitude "
                    "differs by at most {:.2g} degrees",
                    rows, all.instants().size(), recording.file, angle * 180 / std::numbers::pi)};
  }
  throw InvalidArgument(
      recording.file,
      fmt::format("{} of its {} rows cannot show its motion within {:.2g} degrees, and a page has "
                  "no room for more",
                  most_rows, all.instants().size(), widest_deviation * 180 / std::numbers::pi),
      fmt::format("show a part of it, with {} and {}", argument("from"), argument("to")));
}

nlohmann::ordered_json recording_json(const scene::ShownRecording& recording,
                                      const motion::RecordedMotion& motion) {
  std::vector<std::uint32_t> halves;
  const auto add = [&](double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    halves.push_back(static_cast<std::uint32_t>(bits));
    halves.push_back(static_cast<std::uint32_t>(bits >> 32U));
  };
  for (const motion::RecordedMotion::Instant& instant : motion.instants()) {
    add(instant.t);
    for (const double component : {instant.X.w(), instant.X.x(), instant.X.y(), instant.X.z()}) {
      add(component);
    }
    for (const double component : instant.omega) add(component);
  }
  return {{"file", std::filesystem::path(recording.file).filename().string()},
          {"duration", motion.duration()},
          {"longest_step", motion.longest_step()},
          {"flips", recording.flip_times},
          {"rows", packed(halves, 2 * doubles_of_row)}};
}

}  // namespace twrench::page
