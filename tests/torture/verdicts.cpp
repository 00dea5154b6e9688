// torture_verdicts SECONDS SEED [CASE]: checks recordings of exact motions in random units, frames,
// axes, orders and precisions with options that describe them wrongly; or a single one of them.
// Case k depends only on SEED and k. The first cases are single mistakes with twenty starts of each
// body; random combinations follow. Faults are verdicts that propose a wrong reading, no reading,
// or more than two. Every third case is a simulation with a mistake instead; its faults are wrong
// readings and wrong mistakes, and it counts the mistakes that are named. One in four of these has
// the attitude alone.
#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "check/random_recording.h"
#include "check/wrong_simulator.h"
#include "program.h"
#include "torture.h"

namespace twrench::torture {
namespace {

constexpr std::uint32_t starts = 20;
constexpr std::array bodies{check::RecordedBody::t_wrench, check::RecordedBody::nearly_symmetric,
                            check::RecordedBody::toutatis};

std::uint32_t single_count() {
  return static_cast<std::uint32_t>(check::single_mistakes().size() * bodies.size()) * starts;
}

check::RandomRecording recording_of(std::uint32_t seed, std::uint32_t number) {
  if (number >= single_count()) return check::random_recording(seed, number);
  const std::uint32_t kind = number / starts;
  return check::recording_with(check::single_mistakes()[kind / bodies.size()],
                               bodies[kind % bodies.size()], seed, number);
}

/// The numbers of recordings and simulators that were judged, and of wrong verdicts.
struct Counts {
  std::atomic<int> recordings = 0, wrong_recordings = 0;
  std::atomic<int> simulations = 0, named = 0, wrong_simulations = 0;
};
Counts counts;

/// Reports the simulation if the verdict on it is a fault, and returns whether it is.
bool try_simulation(std::uint32_t seed, std::uint32_t number) {
  const check::WrongSimulation simulation = check::wrong_simulation(seed, number);
  const std::filesystem::path folder = make_scratch_folder(fmt::format("laws-{}", number));
  const check::VerdictOnLaw verdict = check::verdict_on(simulation, folder);
  remove_folder(folder);
  counts.simulations += 1;
  counts.named += verdict.names_mistake ? 1 : 0;
  if (verdict.fault.empty()) return false;
  counts.wrong_simulations += 1;
  tell(fmt::format("fault: seed {} case {}: {}: {}\n", seed, number, simulation.description,
                   verdict.fault));
  return true;
}

/// Reports the case if it is a fault, and returns whether it is.
bool try_case(std::uint32_t seed, std::uint32_t number) {
  constexpr std::uint32_t every = 3;
  if (number % every == every - 1) return try_simulation(seed, number);
  const check::RandomRecording recording = recording_of(seed, number);
  const std::filesystem::path folder = make_scratch_folder(fmt::format("verdicts-{}", number));
  const std::string fault = check::fault_of_verdict(recording, folder);
  remove_folder(folder);
  counts.recordings += 1;
  if (fault.empty()) return false;
  counts.wrong_recordings += 1;
  tell(fmt::format("fault: seed {} case {}: {}: {}\n", seed, number, recording.description, fault));
  return true;
}

int run_all(const Request& request) {
  if (!request.only.empty()) {
    const auto number = static_cast<std::uint32_t>(std::strtoul(request.only.c_str(), nullptr, 10));
    return try_case(request.seed, number) ? 1 : 0;
  }
  run_cases(request.seconds, std::numeric_limits<std::uint32_t>::max(),
            [&](std::uint32_t number) { try_case(request.seed, number); });
  tell(
      fmt::format("verdicts: {} recordings in other conventions, {} wrong; {} wrong simulators, {} "
                  "named, {} wrong\n",
                  counts.recordings.load(), counts.wrong_recordings.load(),
                  counts.simulations.load(), counts.named.load(), counts.wrong_simulations.load()));
  return counts.wrong_recordings + counts.wrong_simulations > 0 ? 1 : 0;
}

}  // namespace
}  // namespace twrench::torture

int main(int argc, char** argv) try {
  return twrench::torture::run_all(twrench::torture::parse_request(argc, argv));
} catch (const std::exception& error) {
  twrench::torture::tell(fmt::format("torture_verdicts: {}\n", error.what()));
  return 2;
}
