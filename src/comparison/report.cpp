#include "comparison/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/enumeration.h"
#include "text/escape.h"

namespace twrench::comparison {
namespace {

using Json = nlohmann::ordered_json;

/// The finding about a frame, without its name.
std::string finding(const FrameResult& frame, const Criteria& criteria) {
  switch (frame.outcome) {
    case Outcome::missing:
      return "missing: there is no actual frame";
    case Outcome::extra:
      return "extra: there is no expected frame";
    case Outcome::other_format:
      return "different: " + frame.formats;
    case Outcome::unreadable:
      return std::string("unreadable: ") + frame.failure->what();
    default:
      return fmt::format("{}: {}", frame.passed() ? "alike" : "different",
                         difference_text(frame, criteria));
  }
}

std::string_view verdict(const Comparison& comparison) {
  if (comparison.passed()) return "alike";
  const bool is_unknown = std::ranges::all_of(comparison.frames, [](const FrameResult& frame) {
    return frame.passed() || frame.outcome == Outcome::unreadable;
  });
  return is_unknown ? "unreadable" : "different";
}

/// "2 of 959 frames differ, 900 are identical files; not compared: 1 missing"
std::string summary_line(const Comparison& comparison) {
  const std::size_t compared = comparison.frames.size() - comparison.count(Outcome::missing) -
                               comparison.count(Outcome::extra) -
                               comparison.count(Outcome::unreadable);
  const std::size_t differ =
      comparison.count(Outcome::different) + comparison.count(Outcome::other_format);
  const bool is_any_compared = compared > 0;
  std::string line = fmt::format("{}: ", verdict(comparison));
  line += is_any_compared ? fmt::format("{} of {} frames differ, {} are identical files", differ,
                                        compared, comparison.count(Outcome::identical))
                          : "no frame was compared";
  std::string_view before = is_any_compared ? "; not compared: " : ": ";
  for (const Outcome outcome : {Outcome::missing, Outcome::extra, Outcome::unreadable}) {
    const std::size_t count = comparison.count(outcome);
    if (count == 0) continue;
    line += fmt::format("{}{} {}", before, count, enumerator_name(outcome));
    before = ", ";
  }
  return line + "\n";
}

void write_notes(const Comparison& comparison, const Write& write) {
  for (const std::string& note : notes_of(comparison)) write("note: " + note + "\n");
}

/// Serialises JSON, and replaces bytes of file names that are not UTF-8.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json frame_json(const FrameResult& frame) {
  Json json{{"file", frame.name}, {"outcome", enumerator_name(frame.outcome)}};
  if (frame.passed() || frame.outcome == Outcome::different) {
    const image::Difference& d = frame.difference;
    json["max"] = d.max;
    json["mean"] = d.mean;
    json["share"] = d.share;
    if (frame.similarity) json["ssim"] = *frame.similarity;
    if (d.area.width > 0) json["area"] = {d.area.x, d.area.y, d.area.width, d.area.height};
  }
  if (frame.outcome == Outcome::other_format) json["message"] = frame.formats;
  if (frame.failure) json["message"] = frame.failure->what();
  if (!frame.notes.empty()) json["notes"] = frame.notes;
  return json;
}

Json criteria_json(const Criteria& criteria) {
  const bool by_share = criteria.metric == Metric::share;
  Json json{{"metric", enumerator_name(criteria.metric)}, {"threshold", criteria.threshold}};
  if (by_share) {
    json["share"] = criteria.share;
  } else {
    json["min_ssim"] = criteria.min_similarity;
  }
  json["edges"] = criteria.edges;
  json["ignore"] = Json::array();
  for (const image::Area& area : criteria.ignored) {
    json["ignore"].push_back({area.x, area.y, area.width, area.height});
  }
  return json;
}

std::string junit_case(const FrameResult& frame, const Comparison& comparison) {
  const std::string start = fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                        text::escape_xml(comparison.inputs.actual.string()),
                                        text::escape_xml(frame.name));
  if (frame.passed()) return start + "/>\n";
  const std::string_view kind = frame.outcome == Outcome::unreadable ? "error" : "failure";
  return fmt::format("{}>\n      <{} type=\"{}\" message=\"{}\"/>\n    </testcase>\n", start, kind,
                     enumerator_name(frame.outcome),
                     text::escape_xml(finding(frame, comparison.criteria)));
}

}  // namespace

std::vector<std::string> notes_of(const Comparison& comparison) {
  std::map<std::string, std::size_t> counts;
  for (const FrameResult& frame : comparison.frames) {
    for (const std::string& note : frame.notes) ++counts[note];
  }
  std::vector<std::string> notes;
  for (const auto& [note, count] : counts) {
    notes.push_back(comparison.inputs.folders
                        ? fmt::format("{} frame{}: {}", count, count == 1 ? "" : "s", note)
                        : note);
  }
  return notes;
}

std::string difference_text(const FrameResult& frame, const Criteria& criteria) {
  const image::Difference& d = frame.difference;
  std::string text = fmt::format("max {:.6g} mean {:.6f} of 255, {:.6f} of the pixels over {}",
                                 d.max, d.mean, d.share, criteria.threshold);
  if (frame.similarity) text += fmt::format(", ssim {:.9f}", *frame.similarity);
  return text;
}

void write_text(const Comparison& comparison, const Write& write) {
  if (!comparison.inputs.folders) {
    write(finding(comparison.frames.front(), comparison.criteria) + "\n");
    return write_notes(comparison, write);
  }
  for (const FrameResult& frame : comparison.frames) {
    if (frame.passed()) continue;
    const image::Area& area = frame.difference.area;
    const std::string where =
        area.width == 0 ? ""
                        : fmt::format(", in {},{},{}x{}", area.x, area.y, area.width, area.height);
    write(text::escape(
              fmt::format("{}: {}{}", frame.name, finding(frame, comparison.criteria), where)) +
          "\n");
  }
  write_notes(comparison, write);
  write(summary_line(comparison));
}

void write_json(const Comparison& comparison, const Write& write) {
  Json head{{"expected", comparison.inputs.expected.string()},
            {"actual", comparison.inputs.actual.string()},
            {"verdict", verdict(comparison)},
            {"criteria", criteria_json(comparison.criteria)}};
  for (const Outcome outcome : enumerators<Outcome>)
    head["counts"][enumerator_name(outcome)] = comparison.count(outcome);
  std::string text = dump(head);
  text.back() = ',';  // The frames follow, one per line: all at once could be too long.
  write(text + "\n\"frames\": [\n");
  for (const FrameResult& frame : comparison.frames) {
    write(dump(frame_json(frame)) + (&frame == &comparison.frames.back() ? "\n" : ",\n"));
  }
  write("]}\n");
}

void write_junit(const Comparison& comparison, const Write& write) {
  const std::size_t errors = comparison.count(Outcome::unreadable);
  const std::size_t passed =
      comparison.count(Outcome::identical) + comparison.count(Outcome::alike);
  const std::string counts =
      fmt::format("name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\"",
                  text::escape_xml("twrench compare " + comparison.inputs.expected.string() + " " +
                                   comparison.inputs.actual.string()),
                  comparison.frames.size(), comparison.frames.size() - passed - errors, errors);
  write(
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n"
                  "  <testsuite {0}>\n",
                  counts));
  for (const FrameResult& frame : comparison.frames) write(junit_case(frame, comparison));
  write("  </testsuite>\n</testsuites>\n");
}

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
