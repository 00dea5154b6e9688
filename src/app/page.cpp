#include "embedded/page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/message.h"
#include "app/output.h"
#include "app/scene_options.h"
#include "app/version.h"
#include "app/xml.h"
#include "gl/error.h"
#include "image/stb.h"
#include "page/page_json.h"
#include "page/poster.h"
#include "scene/scene_json.h"
#include "system/base64.h"
#include "system/file.h"

namespace twrench::app {
namespace {

struct PageOptions {
  explicit PageOptions(CLI::App& command) : scene(command) {
    scene.add_motion_options();
    scene.add_look_options();
  }

  SceneOptions scene;
  std::string output;
  std::string template_file;
};

constexpr std::size_t most_bytes = std::size_t{1} << 26U;

/// The page without a scene: scripts/page.sh builds it of web/.
std::string page_template(const PageOptions& options) {
  if (!options.template_file.empty()) {
    const auto bytes = system::read_regular_file(options.template_file, most_bytes);
    return {bytes.begin(), bytes.end()};
  }
  const auto& files = embedded::page();
  const auto found = files.find("page.html");
  if (found != files.end()) return std::string(found->second);
  throw system::FileError("page", "this build of twrench has no page built in",
                          "run scripts/page.sh, which makes it, and build again");
}

/// An <img>; empty where nothing can be drawn, because the page can do without.
std::string poster_html(const scene::Scene& scene) {
  constexpr int quality = 80;
  try {
    const image::Image picture = page::poster(scene, {});
    return fmt::format(
        "<img alt=\"\" width=\"{}\" height=\"{}\" src=\"data:image/jpeg;base64,{}\">",
        picture.width, picture.height, system::base64(image::stb::jpeg(picture, quality)));
  } catch (const gl::GlError& error) {
    warn(fmt::format("the page has no picture for where it cannot draw: {}", error.what()));
    return {};
  }
}

/// In a script of data, nothing may look like the end of the script. `source` is the scene's name
/// or file: with it and the values there, the page writes a command line for what it shows.
std::string scene_html(const scene::Scene& scene, const std::string& source) {
  nlohmann::ordered_json json = page::page_json(scene);
  json["program"] = std::string("twrench ") + version;
  json["source"] = source;
  json["source_scene"] = scene::scene_json(scene::load_scene(source));
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

/// Writes the template with what stands in the place of its marks.
class Filling {
 public:
  Filling(std::string_view text, Output& output) : rest_(text), output_(output) {}

  /// Writes up to the next such mark, and `text` in its place. Throws FileError.
  void put(std::string_view mark, std::string_view text) {
    const std::size_t at = rest_.find(mark);
    if (at == std::string_view::npos) {
      throw system::FileError("page template",
                              fmt::format("there is no {} where it should be", mark));
    }
    output_.write(rest_.substr(0, at));
    output_.write(text);
    rest_.remove_prefix(at + mark.size());
  }

  void finish() { output_.write(rest_); }

 private:
  std::string_view rest_;
  Output& output_;
};

void write_page(const PageOptions& options) {
  options.scene.require_not_input(options.output);
  if (!options.template_file.empty()) {
    system::require_not_input(options.output, options.template_file);
  }
  const std::string html = page_template(options);
  const scene::Scene scene = options.scene.scene();
  const std::string title = xml_text(scene.title.empty() ? scene.name : scene.title);
  const std::string data = scene_html(scene, options.scene.names().front()), picture = poster_html(scene);
  Output output(options.output);
  Filling page(html, output);
  page.put("{{title}}", title);
  page.put("{{title}}", title);
  page.put("<!-- twrench:poster -->", picture);
  page.put("<!-- twrench:scene -->", data);
  page.finish();
  output.finish();
}

}  // namespace

void add_page(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "page", "Write one HTML file in which the motion can be turned, scrubbed and changed");
  command->footer(std::string(about_defaults) +
                  "The page needs no network and no server: it can be mailed.\n"
                  "Example: twrench page dzhanibekov -o flip.html");
  const auto options = std::make_shared<PageOptions>(*command);
  command->add_option("-o,--output", options->output, "output file, or - for standard output")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--template", options->template_file,
                   "the page without a scene, as scripts/page.sh builds it")
      ->type_name("FILE")
      ->default_str("the one built in");
  command->callback([options] { write_page(*options); });
}

}  // namespace twrench::app
