// torture_scales SECONDS SEED [CASE]: runs every command with bodies from micrometres to
// kilometres, from micrograms to tonnes, with turns from nanoseconds to years, until the time is
// over; or with a single one of them. Case k depends only on SEED and k. Faults are: a run that
// fails without an option for times, and an output that makes no sense for the motion.
#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "cli/every_command.h"
#include "cli/random_scene.h"
#include "program.h"
#include "system/file.h"
#include "torture.h"

namespace twrench::torture {
namespace {

namespace fs = std::filesystem;

/// Runs the program with words that contain no quotes.
CommandEnd run_words(const fs::path& folder, const std::string& arguments) {
  Program program{{TWRENCH_BINARY}, folder, folder / "said"};
  std::size_t begin = 0;
  while (begin < arguments.size()) {
    const std::size_t end = std::min(arguments.find(' ', begin), arguments.size());
    if (end > begin) program.command.push_back(arguments.substr(begin, end - begin));
    begin = end + 1;
  }
  Ended ended = run(program);
  return {ended.code, std::move(ended.out), std::move(ended.err)};
}

/// Reports the faults of the case and returns their number.
int try_case(std::uint32_t seed, std::uint32_t number) {
  const RandomScene random = random_scene(seed, number);
  const fs::path folder = make_scratch_folder(fmt::format("scales-{}", number));
  system::write_file_atomically(folder / "own.toml", random.toml);
  const auto faults = faults_of_every_command(
      subject_of(random, number % 2 == 0), folder,
      [&](const std::string& arguments) { return run_words(folder, arguments); },
      Thoroughness::full);
  for (const std::string& fault : faults) {
    tell(fmt::format("fault: seed {} case {}: {}\n{}", seed, number, fault, random.toml));
  }
  remove_folder(folder);
  return static_cast<int>(faults.size());
}

int run_all(const Request& request) {
  if (!request.only.empty()) {
    const auto number = static_cast<std::uint32_t>(std::strtoul(request.only.c_str(), nullptr, 10));
    return try_case(request.seed, number) > 0 ? 1 : 0;
  }
  std::atomic<int> faulty = 0;
  const std::size_t ran = run_cases(
      request.seconds, std::numeric_limits<std::uint32_t>::max(),
      [&](std::uint32_t number) { faulty += try_case(request.seed, number) > 0 ? 1 : 0; });
  tell(fmt::format("scales: {} ran, {} faults\n", ran, faulty.load()));
  return faulty > 0 ? 1 : 0;
}

}  // namespace
}  // namespace twrench::torture

int main(int argc, char** argv) try {
  return twrench::torture::run_all(twrench::torture::parse_request(argc, argv));
} catch (const std::exception& error) {
  twrench::torture::tell(fmt::format("torture_scales: {}\n", error.what()));
  return 2;
}
