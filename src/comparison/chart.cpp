#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "comparison/report.h"
#include "text/escape.h"

namespace twrench::comparison {
namespace {

constexpr std::size_t most_bars = 480;
constexpr double height = 100.0;
constexpr int decades = 6;

/// Maps a millionth ... 1 to 0 ... 100, logarithmically.
double on_scale(double value) {
  return height * std::clamp(1.0 + std::log10(std::max(value, 1e-300)) / decades, 0.0, 1.0);
}

struct Bar {
  bool is_over = false, is_absent = false;
  double value = 0.0;
};

double value_of(const FrameResult& frame, const Criteria& criteria) {
  if (criteria.metric == Metric::ssim) return 1.0 - frame.similarity.value_or(1.0);
  return frame.difference.share;
}

void add(const FrameResult& frame, const Criteria& criteria, Bar& bar) {
  const bool is_compared = frame.passed() || frame.outcome == Outcome::different;
  bar.is_absent |= !is_compared;
  bar.is_over |= is_compared && !frame.passed();
  bar.value = std::max(bar.value, value_of(frame, criteria));
}

std::vector<Bar> bars_of(const Comparison& comparison) {
  const std::size_t count = comparison.frames.size();
  std::vector<Bar> bars(std::min(count, most_bars));
  for (std::size_t i = 0; i < count; ++i) {
    add(comparison.frames[i], comparison.criteria, bars[i * bars.size() / count]);
  }
  return bars;
}

/// The path of the bars for which `is_of` is true. Even the smallest difference is visible.
template <typename Predicate>
std::string path(const char* kind, const std::vector<Bar>& bars, Predicate is_of) {
  constexpr double least = 2.0;
  const double width = std::min(0.8, 0.2 + 0.01 * static_cast<double>(bars.size()));
  std::string d;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (!is_of(bars[i])) continue;
    const double top = bars[i].is_absent && !bars[i].is_over
                           ? 0.0
                           : height - std::max(least, on_scale(bars[i].value));
    const double left = static_cast<double>(i) + 0.5 - width / 2;
    d += fmt::format("M{:.2f} {:.4g}h{:.2g}V100h-{:.2g}z", left, top, width, width);
  }
  return d.empty() ? d : fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, d);
}

std::string line(const char* kind, double y, std::size_t width) {
  return fmt::format("<path class=\"{}\" d=\"M0 {:.4g}H{}\"/>\n", kind, y, width);
}

std::string caption(const Comparison& comparison) {
  const bool by_share = comparison.criteria.metric == Metric::share;
  return fmt::format(
      "{}, frame by frame, on a logarithmic scale. Red is over the bound, green within it{}.",
      by_share ? fmt::format("Share of the pixels that differ by more than {} of 255",
                             comparison.criteria.threshold)
               : "1 minus the structural similarity",
      std::ranges::all_of(
          comparison.frames,
          [](const FrameResult& f) { return f.passed() || f.outcome == Outcome::different; })
          ? ""
          : ", gray could not be compared");
}

}  // namespace

std::string difference_chart(const Comparison& comparison) {
  const std::vector<Bar> bars = bars_of(comparison);
  std::string drawing;
  for (int i = 0; i <= 3; ++i) drawing += line("grid", height / 3 * i, bars.size());
  drawing += path("absent", bars, [](const Bar& bar) { return bar.is_absent && !bar.is_over; });
  drawing += path("within", bars,
                  [](const Bar& bar) { return !bar.is_over && !bar.is_absent && bar.value > 0.0; });
  drawing += path("over", bars, [](const Bar& bar) { return bar.is_over; });
  const Criteria& criteria = comparison.criteria;
  const double bound =
      criteria.metric == Metric::share ? criteria.share : 1.0 - criteria.min_similarity;
  if (bound > 0.0) drawing += line("bound", height - on_scale(bound), bars.size());
  const std::string text = caption(comparison);
  return fmt::format(
      "<figure class=\"chart\"><figcaption>{0}</figcaption>\n<div class=\"plot\">"
      "<ol aria-hidden=\"true\"><li>1<li>10<sup>-2</sup><li>10<sup>-4</sup><li>10<sup>-6</sup></ol>"
      "<svg role=\"img\" aria-label=\"{0}\" viewBox=\"0 0 {1} 100\" preserveAspectRatio=\"none\">\n"
      "{2}</svg><div class=\"ends\"><span>{3}</span><span>{4}</span></div></div></figure>\n",
      text, bars.size(), drawing, text::escape_xml(comparison.frames.front().name),
      text::escape_xml(comparison.frames.back().name));
}

}  // namespace twrench::comparison
