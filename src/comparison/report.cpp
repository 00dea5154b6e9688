#include "comparison/report.h"

#include <fmt/format.h>

#include <algorithm>
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

}  // namespace twrench::comparison
