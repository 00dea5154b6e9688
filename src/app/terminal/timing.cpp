#include "app/terminal/timing.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace twrench::app {
namespace {

double milliseconds(const film::StageTimes::Counter& counter) {
  return 1e-6 * static_cast<double>(counter.load());
}

double processor_milliseconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto ms = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

}  // namespace

ProcessorTime processor_time() {
  return {processor_milliseconds(RUSAGE_SELF), processor_milliseconds(RUSAGE_CHILDREN)};
}

std::string timing_report(const film::StageTimes& times, const ProcessorTime& before,
                          double seconds, std::size_t frames, bool json) {
  const auto count = static_cast<double>(std::max<std::size_t>(frames, 1));
  const std::array<std::pair<const char*, double>, 7> stages{
      {{"pose", milliseconds(times.pose) / count},
       {"draw", milliseconds(times.draw) / count},
       {"composite", milliseconds(times.composite) / count},
       {"convert", milliseconds(times.convert) / count},
       {"compress", milliseconds(times.compress) / count},
       {"write", milliseconds(times.write) / count},
       {"encode", milliseconds(times.encode) / count}}};
  const ProcessorTime now = processor_time();
  const double own = (now.own - before.own) / count;
  const double children = (now.children - before.children) / count;
  if (json) {
    nlohmann::ordered_json report{{"frames", frames},
                                  {"wall_seconds", seconds},
                                  {"first_frame_seconds", 1e-3 * milliseconds(times.first)}};
    auto busy = nlohmann::ordered_json::object();
    for (const auto& [name, ms] : stages) busy[name] = ms;
    report["busy_ms_per_frame"] = busy;
    report["cpu_ms_per_frame"] = {{"twrench", own}, {"children", children}};
    return report.dump();
  }
  std::string text = "busy time per frame, ms: ";
  for (const auto& [name, ms] : stages) text += fmt::format("{} {:.2f}, ", name, ms);
  return text + fmt::format(
                    "wall {:.1f}; CPU {:.1f}, encoder's CPU {:.1f}; first frame "
                    "after {:.0f} ms",
                    1e3 * seconds / count, own, children, milliseconds(times.first));
}

}  // namespace twrench::app
