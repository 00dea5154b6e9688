#include "comparison/article.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "comparison/report.h"
#include "image/png.h"
#include "system/base64.h"
#include "system/file.h"
#include "text/xml.h"

namespace twrench::comparison {
namespace {

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

}  // namespace

Article article_of(const FrameResult& frame, const Comparison& comparison) {
  const Pictures pictures = pictures_of(frame, comparison);
  return {
      fmt::format("<article>\n<header><h2>{}</h2> <span class=\"verdict{}\">{}</span> "
                  "<p>{}</p></header>\n{}</article>\n",
                  text::escape_xml(frame.name), frame.passed() ? " passed" : "", verdict_of(frame),
                  finding_html(frame, comparison.criteria), stage(frame, pictures)),
      pictures.size()};
}

std::string table_row(const FrameResult& frame, const Criteria& criteria) {
  return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", text::escape_xml(frame.name),
                     verdict_of(frame), finding_html(frame, criteria));
}

}  // namespace twrench::comparison
