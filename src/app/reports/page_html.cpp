#include "app/reports/page_html.h"

#include <fmt/format.h>

#include <string_view>

#include "app/terminal/message.h"
#include "app/terminal/version.h"
#include "embedded/page.h"
#include "film/poster.h"
#include "gl/error.h"
#include "image/stb.h"
#include "page/page_json.h"
#include "scene/scene_json.h"
#include "system/base64.h"
#include "system/file.h"
#include "text/xml.h"

namespace twrench::app {
namespace {

/// In a script of data, nothing may look like the end of the script. With the source and the values
/// there, the page writes a command line for what it shows.
std::string scene_html(const PageScene& scene) {
  const page::Surface surface = page::surface_of(scene.shown.body);
  if (const auto& simplified = surface.simplification) {
    say("twrench: the page draws {} of {} triangles; mass properties are those of all of them\n",
        simplified->drawn, simplified->given);
  }
  nlohmann::ordered_json json = page::page_json(scene.shown, surface);
  json["program"] = std::string("twrench ") + version;
  json["source"] = scene.source;
  json["source_options"] = scene.source_options;
  json["source_scene"] = scene::scene_json(scene.original);
  std::string data;
  for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<') {
      data += "\\u003c";
    } else {
      data += c;
    }
  }
  return "<script type=\"application/json\" id=\"scene\">" + data + "</script>";
}

/// Puts texts in the place of the marks of a template, in their order.
class Filling {
 public:
  explicit Filling(std::string_view text) : rest_(text) {}

  void put(std::string_view mark, std::string_view text) {
    const std::size_t at = rest_.find(mark);
    if (at == std::string_view::npos) {
      throw system::FileError("page template",
                              fmt::format("there is no {} where it should be", mark));
    }
    filled_.append(rest_.substr(0, at)).append(text);
    rest_.remove_prefix(at + mark.size());
  }

  std::string filled() && { return std::move(filled_.append(rest_)); }

 private:
  std::string_view rest_;
  std::string filled_;
};

}  // namespace

std::string page_template(const std::string& file) {
  constexpr std::size_t most_bytes = std::size_t{1} << 26U;
  if (!file.empty()) {
    const auto bytes = system::read_regular_file(file, most_bytes);
    return {bytes.begin(), bytes.end()};
  }
  const auto& files = embedded::page();
  const auto found = files.find("page.html");
  if (found != files.end()) return std::string(found->second);
  throw system::FileError("page", "this build of twrench has no page built in",
                          "run scripts/page.sh, which makes it, and build again");
}

std::string poster_html(const scene::Scene& scene) {
  constexpr int quality = 80;
  try {
    const image::Image picture = film::poster(scene, {});
    return fmt::format(
        "<img alt=\"\" width=\"{}\" height=\"{}\" src=\"data:image/jpeg;base64,{}\">",
        picture.width, picture.height, system::base64(image::stb::jpeg(picture, quality)));
  } catch (const gl::GlError& error) {
    warn(fmt::format("the page has no picture for where it cannot draw: {}", error.what()));
    return {};
  }
}

std::string page_html(const std::string& page_template, const PageScene& scene,
                      const std::string& poster) {
  const scene::Scene& shown = scene.shown;
  const std::string title = text::escape_xml(shown.shown_title());
  Filling page(page_template);
  page.put("{{title}}", title);
  page.put("{{title}}", title);
  page.put("<!-- twrench:poster -->", poster);
  page.put("<!-- twrench:scene -->", scene_html(scene));
  return std::move(page).filled();
}

}  // namespace twrench::app
