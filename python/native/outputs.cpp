#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "film/page_pictures.h"
#include "gl/context.h"
#include "interchange/export.h"
#include "interruptible.h"
#include "module.h"
#include "output.h"
#include "page/page_html.h"
#include "page/site_html.h"
#include "plot/gnuplot.h"
#include "report/command_lines.h"
#include "report/file.h"
#include "report/solution.h"
#include "scene/fields.h"
#include "scene/motion_summary.h"
#include "system/file.h"
#include "system/output.h"
#include "system/program.h"
#include "text/escape.h"

namespace twrench::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;
using scene::Scene;
using Array = py::array_t<double, py::array::c_style>;
using Texts = std::vector<std::string>;

/// Formats the value of a field as that of an option.
std::string option_value(const nlohmann::ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return fmt::format("{}", value.get<double>());
  return fmt::format("{}", fmt::join(value.get<std::vector<double>>(), ","));
}

/// Whether a value is natural, because the user did not give it.
bool is_natural(const Scene& scene, const std::string& key) {
  const auto follows = [](scene::Origin origin) { return origin != scene::Origin::user; };
  return (key == "step" && follows(scene.origins.step)) ||
         (key == "duration" && follows(scene.origins.duration)) ||
         (key == "speed" && follows(scene.origins.speed));
}

/// The options that change the motion of `original` to that of `scene`: one for each differing
/// field among `keys`.
Texts options_between(const Scene& original, const Scene& scene, const Texts& keys) {
  Texts options;
  for (const scene::Field& field : scene::fields()) {
    if (std::ranges::find(keys, field.key) == keys.end()) continue;
    const nlohmann::ordered_json value = field.get(scene);
    if (value.is_null() || value == field.get(original) || is_natural(scene, field.key)) continue;
    std::string option = "--" + field.key;
    std::ranges::replace(option, '_', '-');
    options.insert(options.end(), {std::move(option), option_value(value)});
  }
  return options;
}

/// The option that gives `original` the inertia of the body of `scene`; none if it is the same.
Texts body_options(const Scene& original, const Scene& scene) {
  const Eigen::Matrix3d I = scene::mass_properties(scene.body).inertia;
  if (I == scene::mass_properties(original.body).inertia) return {};
  return {"--inertia",
          fmt::format("{},{},{},{},{},{}", I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2))};
}

/// The page of a scene, and an <img> for browsers that cannot draw it. Without OpenGL there is a
/// note instead of the <img>.
struct ScenePage {
  page::PageDocument page;
  std::string poster;
  std::string policy;
  std::string summary;  ///< Summary of the motion shown, for an index of pages.
};

/// Throws Stopped between the steps.
ScenePage page_of(const Scene& scene, const Scene& original, const std::string& source,
                  const Texts& source_options, const std::string& template_file, bool has_article,
                  const std::atomic<bool>& stop) {
  const std::string empty = page::page_template(template_file);
  Texts recording_options;
  const bool is_own = scene.motion.recording_file != nullptr;
  if (scene.motion.recording && !is_own)
    recording_options = {"--motion", scene.motion.recording->file};
  const page::PageScene shown{scene,          original,          source,
                              source_options, recording_options, has_article};
  film::PagePictures pictures;
  Texts notes;
  page::PageDocument page = page::page_html(empty, shown, [&] {
    try {
      pictures = film::page_pictures(scene, has_article, {});
    } catch (const gl::GlError& error) {
      notes.push_back(fmt::format("the page has no fallback pictures: {}", error.what()));
    }
    if (stop) throw Stopped{};
    return pictures.poster + pictures.stills;
  });
  page.notes.insert(page.notes.end(), notes.begin(), notes.end());
  return {std::move(page), std::move(pictures.poster), page::content_policy(empty),
          scene::motion_summary(scene)};
}

ScenePage make_page(const Scene& scene, const Scene& original, const std::string& source,
                    const Texts& source_options, const std::string& template_file,
                    bool has_article) {
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    return page_of(page::shown_scene(scene), original, source, source_options, template_file,
                   has_article, stop);
  });
}

/// The index of a folder of pages, each given by its file, title, description and poster.
std::string site_html(const std::vector<std::array<std::string, 4>>& pages) {
  std::vector<page::SiteEntry> entries;
  for (const auto& [file, title, description, poster] : pages) {
    entries.push_back({file, title, description, poster});
  }
  return page::site_html(entries);
}

/// A scene of a report: as it is, as its source has it, and the source as words of a command: its
/// name and, if it is a mesh, the options of the mesh.
using ReportedScene = std::tuple<Scene, Scene, Texts>;

/// Appends the options, each a pair of words, that are not among `words` yet.
void append_missing(Texts& words, const Texts& options) {
  for (std::size_t i = 0; i + 1 < options.size(); i += 2) {
    if (std::ranges::find(words, options[i]) != words.end()) continue;
    words.insert(words.end(), {options[i], options[i + 1]});
  }
}

report::Experiment experiment_of(const ReportedScene& reported, const std::atomic<bool>& stop) {
  const auto& [scene, original, source] = reported;
  Scene solved = scene;
  solved.motion.control.stop = &stop;
  Texts words = source;
  words.front() = report::argument_of(words.front());
  return {solved, report::commands_of(scene, words, body_options(original, scene),
                                      options_between(original, scene,
                                                      {"omega", "attitude", "wheel",
                                                       "energy_loss_time", "duration"}))};
}

/// How a report is written.
struct ReportOptions {
  std::string file, author, date;
  bool is_static;
  /// Whether it solves the tasks of the course, whose scenes no word of the command names.
  bool solves_tasks;
};

/// The command that writes the report.
Texts report_command(const std::vector<ReportedScene>& scenes, const ReportOptions& options) {
  Texts command{"twrench", "report"};
  if (!options.solves_tasks) {
    for (const auto& [scene, original, source] : scenes) {
      command.push_back(report::argument_of(source.front()));
    }
  }
  for (const auto& [scene, original, source] : scenes) {
    append_missing(command, Texts(source.begin() + 1, source.end()));
  }
  for (const auto& [scene, original, source] : scenes) {
    append_missing(command, body_options(original, scene));
  }
  for (const auto& [scene, original, source] : scenes) {
    append_missing(command,
                   options_between(original, scene,
                                   {"omega", "attitude", "wheel", "energy_loss_time", "method",
                                    "step", "tolerance", "duration", "fps", "speed"}));
  }
  for (const auto& [scene, original, source] : scenes) {
    if (scene.language_tag == "en" && original.language_tag == "en") continue;
    append_missing(command, {"--language", scene.language_tag});
  }
  if (!options.author.empty()) command.insert(command.end(), {"--author", options.author});
  if (!options.date.empty()) command.insert(command.end(), {"--date", options.date});
  if (options.is_static) command.emplace_back("--static");
  command.insert(command.end(), {"-o", report::argument_of(options.file)});
  return command;
}

/// Writes a report on at least one scene, and returns notes.
Texts write_report(const std::vector<ReportedScene>& scenes, Output& output,
                   const std::string& author, const std::string& date, bool is_static,
                   bool solves_tasks) {
  const std::string file = output.file.path().string();
  const bool wants_page = output.file.format().name == "html" && !is_static;
  const std::string missing = wants_page ? page::note_on_missing_page() : std::string();
  plot::require_gnuplot(system::plot_output.formats.front());
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    std::vector<report::Experiment> experiments;
    for (const ReportedScene& scene : scenes) experiments.push_back(experiment_of(scene, stop));
    std::optional<report::Viewer> viewer;
    Texts notes;
    if (!missing.empty()) notes.push_back(missing);
    if (wants_page && missing.empty()) {
      const auto& [scene, original, source] = scenes.front();
      ScenePage page = page_of(scene, original, report::argument_of(source.front()),
                               Texts(source.begin() + 1, source.end()), {}, false, stop);
      notes = page.page.notes;
      viewer = {std::move(page.page.html), std::move(page.policy), std::move(page.poster)};
    }
    const std::string note = report::note_on_language(experiments);
    if (!note.empty()) notes.push_back(note);
    const report::Document document{
        experiments.front().scene.language,
        report::title_of(experiments),
        text::escape(author),
        text::escape(date),
        text::escape(system::shell_command(
            report_command(scenes, {file, author, date, is_static, solves_tasks}))),
        "twrench " TWRENCH_VERSION,
        solves_tasks ? report::report_on_tasks(experiments, report::task_commands())
                     : report::report_on_motions(experiments)};
    report::write_report(output.file, document, viewer ? &*viewer : nullptr, output.files);
    return notes;
  });
}

/// Returns notes.
Texts export_motion(const Scene& scene, const Output& to, double max_angle,
                    std::optional<double> speed, const std::string& epoch) {
  const interchange::ExportFormat& found = interchange::export_format(to.file.format());
  const interchange::ExportOptions options{
      scene::limits::check(interchange::max_angle_limit, "max_angle", max_angle),
      speed ? std::optional(scene::limits::check(scene::limits::speed, "speed", *speed))
            : std::nullopt,
      epoch};
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    Scene written = scene;
    written.motion.control.stop = &stop;
    system::Output output(to.file);
    Texts notes = found.write(options, written, [&](std::string_view text) {
      if (stop) throw Stopped{};
      output.write(text);
    });
    output.finish();
    return notes;
  });
}

std::vector<plot::AttitudeCurve> curves_of(const Scene& scene) {
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    Scene drawn = scene;
    drawn.motion.control.stop = &stop;
    return report::shown_curves(drawn);
  });
}

plot::Plot plot_of(const std::vector<Scene>& scenes, bool overlay) {
  std::vector<plot::AttitudeCurve> curves;
  for (const Scene& scene : scenes) {
    for (plot::AttitudeCurve& curve : curves_of(scene)) curves.push_back(std::move(curve));
  }
  return overlay ? plot::column_panels(curves) : plot::nine_panels(curves);
}

void draw_plot(const std::vector<Scene>& scenes, const Output& output, bool overlay) {
  plot::require_gnuplot(output.file.format());
  const plot::Plot plot = plot_of(scenes, overlay);
  run_interruptibly([&](const std::atomic<bool>&) { plot::draw_plot(output.file, plot); });
}

std::string plot_svg(const Scene& scene, bool overlay) {
  plot::require_gnuplot(system::plot_output.formats.front());
  const plot::Plot plot = plot_of({scene}, overlay);
  return run_interruptibly([&](const std::atomic<bool>&) { return plot::svg(plot); });
}

/// Times (n), attitudes (n, 3, 3) and the times of flips (m).
py::tuple numbers_of(const plot::AttitudeCurve& curve) {
  const auto n = static_cast<py::ssize_t>(curve.samples.size());
  Array t(n), X({n, py::ssize_t{3}, py::ssize_t{3}});
  for (py::ssize_t i = 0; i < n; ++i) {
    const motion::Sample& sample = curve.samples[static_cast<std::size_t>(i)];
    t.mutable_at(i) = sample.t;
    for (py::ssize_t row = 0; row < 3; ++row) {
      for (py::ssize_t column = 0; column < 3; ++column) {
        X.mutable_at(i, row, column) = sample.X(row, column);
      }
    }
  }
  return py::make_tuple(t, X,
                        Array(static_cast<py::ssize_t>(curve.flips.size()), curve.flips.data()));
}

/// The motion of a scene, or the recorded motion and the exact one.
py::list attitude_curves(const Scene& scene) {
  py::list curves;
  for (const plot::AttitudeCurve& curve : curves_of(scene)) curves.append(numbers_of(curve));
  return curves;
}

void write_samples(const Output& to, const motion::FreeBody& body, const Array& times,
                   const Array& X, const Array& omega) {
  using RowMajorMatrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  std::vector<motion::Sample> samples;
  for (py::ssize_t i = 0; i < times.size(); ++i) {
    samples.push_back({times.at(i), Eigen::Map<const RowMajorMatrix>(X.data() + 9 * i),
                       Eigen::Map<const Eigen::Vector3d>(omega.data() + 3 * i)});
  }
  run_interruptibly([&](const std::atomic<bool>& stop) {
    system::Output output(to.file);
    interchange::write_csv(
        [&](std::string_view text) {
          if (stop) throw Stopped{};
          output.write(text);
        },
        body, samples);
    output.finish();
  });
}

}  // namespace

Output make_output(const std::string& kind, const fs::path& file,
                   const std::vector<fs::path>& inputs, bool overwrite, const std::string& format) {
  static constexpr std::array kinds{
      &system::saved_motion,    &system::exported_motion,    &system::plot_output,
      &system::page_output,     &system::index_output,       &system::report_output,
      &system::comparison_page, &system::difference_picture, &system::robot_page};
  const auto found = std::ranges::find(kinds, kind, &system::OutputKind::name);
  if (file == "-") throw InvalidArgument("path", "standard output is not written", "name a file");
  system::FileList files(overwrite);
  for (const fs::path& input : inputs) files.add_input(input);
  const system::OutputFile output = files.add_output(**found, file, format);
  return {std::move(files), output};
}

void add_outputs(py::module_& module) {
  py::class_<Output>(module, "Output")
      .def(py::init(&make_output))
      .def_property_readonly("path", [](const Output& output) { return output.file.path(); })
      .def_property_readonly("format",
                             [](const Output& output) { return output.file.format().name; });
  py::class_<ScenePage>(module, "Page")
      .def_property_readonly("html", [](const ScenePage& page) { return page.page.html; })
      .def_property_readonly("notes", [](const ScenePage& page) { return page.page.notes; })
      .def_readonly("poster", &ScenePage::poster)
      .def_readonly("summary", &ScenePage::summary);
  module.def("page", &make_page);
  module.def("site_html", &site_html);
  module.def("report", &write_report);
  module.def("export_motion", &export_motion);
  module.def("draw_plot", &draw_plot);
  module.def("plot_svg", &plot_svg);
  module.def("attitude_curves", &attitude_curves);
  module.def("write_samples", &write_samples);
  module.def("write_output", [](const Output& output, const std::string& bytes) {
    system::write_output(output.file, bytes);
  });
  module.def("make_folder", &system::make_folder);
}

}  // namespace twrench::python
