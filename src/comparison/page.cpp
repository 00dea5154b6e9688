#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "comparison/report.h"
#include "embedded/comparison_page.h"
#include "image/png.h"
#include "system/bytes.h"
#include "system/file.h"
#include "text/escape.h"

namespace twrench::comparison {
namespace {

/// A frame as the page of `twrench compare --report` shows it.
struct Article {
  /// An HTML element that contains the pictures.
  std::string html;
  /// Total size of its PNG files in bytes.
  std::size_t picture_bytes;
};

using Bytes = std::vector<std::uint8_t>;

/// The pictures of a frame; empty if there is none.
struct Pictures {
  Bytes expected, actual, difference;
  int width = 0, height = 0;  ///< The largest of the pictures.

  std::size_t size() const { return expected.size() + actual.size() + difference.size(); }
};

Bytes read_picture(const std::filesystem::path& path, Pictures& pictures) {
  Bytes bytes = system::read_regular_file(path, image::max_png_size);
  const image::PngHeader header = image::png_header(bytes);
  pictures.width = std::max(pictures.width, static_cast<int>(header.width));
  pictures.height = std::max(pictures.height, static_cast<int>(header.height));
  return bytes;
}

/// The image of a difference for the page. The square root makes faint differences visible.
Bytes shown_difference(image::Image difference) {
  for (std::uint8_t& sample : difference.pixels) {
    sample = static_cast<std::uint8_t>(std::lround(std::sqrt(255.0 * sample)));
  }
  return image::encode_png(difference);
}

Pictures pictures_of(const FrameResult& frame, const Comparison& comparison) {
  Pictures pictures;
  const auto expected = comparison.inputs.expected_frame(frame.name);
  const auto actual = comparison.inputs.actual_frame(frame.name);
  if (frame.outcome == Outcome::unreadable) return pictures;
  if (frame.outcome != Outcome::extra) pictures.expected = read_picture(expected, pictures);
  if (frame.outcome != Outcome::missing) pictures.actual = read_picture(actual, pictures);
  if (frame.outcome == Outcome::different || frame.outcome == Outcome::alike) {
    PicturePair pair({pictures.expected, expected.string()}, {pictures.actual, actual.string()});
    pair.ignore(comparison.criteria.ignored);
    pictures.difference = shown_difference(pair.difference_image(comparison.criteria.edges));
  }
  return pictures;
}

std::string verdict_of(const FrameResult& frame) {
  switch (frame.outcome) {
    case Outcome::missing:
      return "missing";
    case Outcome::extra:
      return "extra";
    case Outcome::unreadable:
      return "unreadable";
    default:
      return frame.passed() ? "within the bounds" : "different";
  }
}

std::string finding_html(const FrameResult& frame, const Criteria& criteria) {
  if (frame.failure) return text::escape_xml(frame.failure->what());
  if (frame.outcome == Outcome::missing) return "there is no actual frame";
  if (frame.outcome == Outcome::extra) return "there is no expected frame";
  if (frame.outcome == Outcome::other_format) return text::escape_xml(frame.formats);
  return text::escape_xml(difference_text(frame, criteria));
}

std::string figure(const char* kind, const char* caption, const Bytes& png,
                   const FrameResult& frame, const Pictures& pictures) {
  if (png.empty()) return {};
  const double width = 100.0 * image::png_header(png).width / pictures.width;
  return fmt::format(
      "<figure class=\"{0}\" style=\"--part:{1:.6g}\"><img alt=\"{2}: {3}\" decoding=\"async\" "
      "src=\"data:image/png;base64,{4}\"><figcaption class=\"tag\">{3}</figcaption></figure>\n",
      kind, width, text::escape_xml(frame.name), caption, system::base64(png));
}

/// A rectangle around the area that differs, unless that is most of the picture.
std::string mark(const FrameResult& frame, const Pictures& pictures) {
  const image::Area& area = frame.difference.area;
  const double share =
      static_cast<double>(area.width) * area.height / pictures.width / pictures.height;
  if (area.width == 0 || share > 0.5) return {};
  const auto percent = [](int part, int whole) { return 100.0 * part / whole; };
  return fmt::format(
      "<i class=\"mark\" style=\"left:{:.4f}%;top:{:.4f}%;width:{:.4f}%;height:{:.4f}%\"></i>\n",
      percent(area.x, pictures.width), percent(area.y, pictures.height),
      percent(area.width, pictures.width), percent(area.height, pictures.height));
}

std::string stage(const FrameResult& frame, const Pictures& pictures) {
  if (pictures.size() == 0) return {};
  const bool has_slider = !pictures.difference.empty();
  std::string text =
      fmt::format("<div class=\"view\"><div class=\"stage{}\" style=\"--w:{};--h:{}\">\n",
                  has_slider ? "" : " single", pictures.width, pictures.height);
  text += figure("expected base", "Expected", pictures.expected, frame, pictures);
  text += figure("actual top", "Actual", pictures.actual, frame, pictures);
  text += figure("difference", "Difference, amplified", pictures.difference, frame, pictures);
  if (has_slider) {
    text += mark(frame, pictures);
    text += fmt::format(
        "<i class=\"line\"></i><input type=\"range\" min=\"0\" max=\"100\" step=\"any\" "
        "value=\"50\" aria-label=\"Where the one picture of {} ends and the other begins\">\n",
        text::escape_xml(frame.name));
  }
  return text + "</div></div>\n";
}

/// Returns the article on a frame, with the expected image, the actual one and their difference, as
/// far as they exist. Reads the files again, because a film would not fit in memory. Throws
/// FileError.
Article article_of(const FrameResult& frame, const Comparison& comparison) {
  const Pictures pictures = pictures_of(frame, comparison);
  return {
      fmt::format("<article>\n<header><h2>{}</h2> <span class=\"verdict{}\">{}</span> "
                  "<p>{}</p></header>\n{}</article>\n",
                  text::escape_xml(frame.name), frame.passed() ? " passed" : "", verdict_of(frame),
                  finding_html(frame, comparison.criteria), stage(frame, pictures)),
      pictures.size()};
}

/// Returns the table row of a frame that is listed without pictures.
std::string table_row(const FrameResult& frame, const Criteria& criteria) {
  return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", text::escape_xml(frame.name),
                     verdict_of(frame), finding_html(frame, criteria));
}

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
