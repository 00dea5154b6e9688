#include "comparison/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>
#include <tuple>
#include <vector>

#include "comparison/article.h"
#include "comparison/chart.h"
#include "comparison/report.h"
#include "embedded/comparison_page.h"
#include "text/xml.h"

namespace twrench::comparison {
namespace {

/// The most frames that a person looks at one by one, and the most bytes of PNG files that a
/// browser loads in a second. The first frame is shown regardless of its size.
constexpr std::size_t most_frames = 24;
constexpr std::size_t most_bytes = 32U << 20U;

/// The most lines in the list of frames without pictures.
constexpr std::size_t most_lines = 1000;

/// How bad an outcome is: frames that were compared and differ come first, then those that could
/// not be compared.
int rank(Outcome outcome) {
  switch (outcome) {
    case Outcome::other_format:
      return 0;
    case Outcome::different:
      return 1;
    case Outcome::unreadable:
      return 2;
    case Outcome::missing:
      return 3;
    case Outcome::extra:
      return 4;
    case Outcome::alike:
      return 5;
    case Outcome::identical:
      break;
  }
  return 6;
}

bool is_worse(const FrameResult* a, const FrameResult* b) {
  const auto order = [](const FrameResult& frame) {
    return std::tuple(rank(frame.outcome), frame.similarity.value_or(1.0), -frame.difference.share,
                      -frame.difference.mean);
  };
  return order(*a) < order(*b);
}

/// The frames that are not equal to the expected ones, the worst first, equally bad ones by name.
std::vector<const FrameResult*> worst_first(const Comparison& comparison) {
  std::vector<const FrameResult*> frames;
  for (const FrameResult& frame : comparison.frames) {
    const bool is_same = frame.passed() && frame.difference.max == 0.0;
    if (!is_same) frames.push_back(&frame);
  }
  std::ranges::stable_sort(frames, is_worse);
  return frames;
}

std::string title_of(const Comparison& comparison) {
  const std::size_t all = comparison.frames.size();
  const auto failed = static_cast<std::size_t>(
      std::ranges::count_if(comparison.frames, std::not_fn(&FrameResult::passed)));
  if (failed == 0)
    return all == 1 ? "The frame is alike" : fmt::format("All {} frames are alike", all);
  return all == 1 ? "The frame is not as expected"
                  : fmt::format("{} of {} frames {} not as expected", failed, all,
                                failed == 1 ? "is" : "are");
}

std::string bound_of(const Criteria& criteria) {
  if (criteria.metric == Metric::ssim) {
    return fmt::format("The structural similarity must be at least {}.", criteria.min_similarity);
  }
  const std::string beyond =
      criteria.threshold == 0 ? "" : fmt::format(" by more than {} of 255", criteria.threshold);
  if (criteria.share == 0.0) return fmt::format("No pixel may differ{}.", beyond);
  return fmt::format("Up to {:.6g} % of the pixels may differ{}.", 100 * criteria.share, beyond);
}

std::string rules_of(const Criteria& criteria) {
  std::string text = bound_of(criteria);
  if (criteria.edges > 0) text += fmt::format(" Edges may lie {} px elsewhere.", criteria.edges);
  if (!criteria.ignored.empty()) text += " Not looked at:";
  for (const image::Area& area : criteria.ignored) {
    text += fmt::format(" <code>{},{},{}x{}</code>", area.x, area.y, area.width, area.height);
  }
  return text;
}

std::string counts_of(const Comparison& comparison) {
  struct Count {
    const char* caption;
    std::size_t count;
    bool is_bad;
  };
  std::string text = "<ul class=\"counts\">\n";
  for (const Count& c : std::initializer_list<Count>{
           {"identical files", comparison.count(Outcome::identical), false},
           {"within the bounds", comparison.count(Outcome::alike), false},
           {"different",
            comparison.count(Outcome::different) + comparison.count(Outcome::other_format), true},
           {"missing", comparison.count(Outcome::missing), true},
           {"extra", comparison.count(Outcome::extra), true},
           {"unreadable", comparison.count(Outcome::unreadable), true}}) {
    if (c.count == 0) continue;
    text += fmt::format("<li{}><b>{}</b> {}</li>\n", c.is_bad ? " class=\"bad\"" : "", c.count,
                        c.caption);
  }
  return text + "</ul>\n";
}

std::string notes_html(const Comparison& comparison) {
  std::string html;
  for (const std::string& note : notes_of(comparison)) {
    html += "<p class=\"soft\">Note: " + text::escape_xml(note) + "</p>\n";
  }
  return html;
}

std::string beginning(const Comparison& comparison) {
  const std::string title = title_of(comparison);
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<meta name=\"generator\" content=\"twrench compare\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
      "<title>{0}</title>\n<style>\n{1}</style>\n<header>\n<h1{2}>{0}</h1>\n"
      "<dl class=\"paths\"><dt class=\"expected\">Expected<dd><code>{3}</code>"
      "<dt class=\"actual\">Actual<dd><code>{4}</code></dl>\n<p class=\"soft\">{5}</p>\n{6}",
      title, embedded::comparison_page().at("page.css"),
      comparison.passed() ? " class=\"passed\"" : "",
      text::escape_xml(comparison.inputs.expected.string()),
      text::escape_xml(comparison.inputs.actual.string()), rules_of(comparison.criteria),
      counts_of(comparison) + notes_html(comparison));
}

constexpr const char* toolbar = R"(<div class="bar" hidden>
<fieldset><legend class="hidden">What is shown</legend>
<label><input type="radio" name="mode" value="ea" data-key="1" checked>Expected | Actual</label>
<label><input type="radio" name="mode" value="ed" data-key="2">Expected | Difference</label>
<label><input type="radio" name="mode" value="ad" data-key="3">Actual | Difference</label>
<label><input type="radio" name="mode" value="all" data-key="4">Side by side</label>
</fieldset>
<fieldset><legend class="hidden">Size</legend>
<label><input type="radio" name="zoom" value="fit" checked>Fit</label>
<label><input type="radio" name="zoom" value="1">1:1</label>
<label><input type="radio" name="zoom" value="4">4:1</label>
</fieldset>
<span><input type="checkbox" id="mark" checked> <label for="mark">Frame what differs</label></span>
<span class="soft"><kbd>j</kbd> <kbd>k</kbd> next and previous frame, <kbd>1</kbd> to <kbd>4</kbd> what is shown,
<kbd>&larr;</kbd> <kbd>&rarr;</kbd> the slider</span>
</div>
)";

/// Writes the frames with pictures, and returns their number.
std::size_t write_articles(const std::vector<const FrameResult*>& frames,
                           const Comparison& comparison, const Write& write) {
  std::size_t shown = 0, bytes = 0;
  for (; shown < std::min(frames.size(), most_frames); ++shown) {
    const Article article = article_of(*frames[shown], comparison);
    bytes += article.picture_bytes;
    if (shown > 0 && bytes > most_bytes) break;
    write(article.html);
  }
  return shown;
}

void write_table(std::span<const FrameResult* const> frames, const Criteria& criteria,
                 const Write& write) {
  write(
      fmt::format("<h2>{} more, without pictures</h2>\n<div class=\"tablebox\"><table>\n"
                  "<tr><th>Frame<th>Verdict<th>Finding</tr>\n",
                  frames.size()));
  for (const FrameResult* frame : frames.first(std::min(frames.size(), most_lines))) {
    write(table_row(*frame, criteria));
  }
  write("</table></div>\n");
  if (frames.size() > most_lines) {
    write(fmt::format("<p class=\"soft\">and {} more, which are left out here</p>\n",
                      frames.size() - most_lines));
  }
}

}  // namespace

void write_page(const Comparison& comparison, const Write& write) {
  const std::vector<const FrameResult*> frames = worst_first(comparison);
  write(beginning(comparison));
  if (comparison.frames.size() > 1 && !frames.empty()) write(difference_chart(comparison));
  write("</header>\n");
  if (!frames.empty()) {
    write(toolbar);
    write("<main class=\"frames side\" data-zoom=\"fit\">\n");
    const std::size_t shown = write_articles(frames, comparison, write);
    if (shown < frames.size()) {
      write_table(std::span(frames).subspan(shown), comparison.criteria, write);
    }
    write("</main>\n");
  }
  write(fmt::format("<script>\n{}</script>\n</html>\n", embedded::comparison_page().at("page.js")));
}

}  // namespace twrench::comparison
