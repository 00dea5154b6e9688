#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/color.h"
#include "base/enumeration.h"
#include "errors.h"
#include "film/render_job.h"
#include "frame_drawer.h"
#include "image/png.h"
#include "interruptible.h"
#include "module.h"
#include "picture/look/theme.h"
#include "scene/limits.h"
#include "system/error.h"
#include "system/file.h"
#include "video/encode_frames.h"
#include "video/frame_range.h"

namespace twrench::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

/// An image as an array (height, width, channels), which owns the pixels.
py::array to_array(image::Image image) {
  auto owned = std::make_unique<image::Image>(std::move(image));
  const image::Image& pixels = *owned;
  const py::capsule owner(owned.release(),
                          [](void* memory) { delete static_cast<image::Image*>(memory); });
  return py::array_t<std::uint8_t>(
      std::vector<py::ssize_t>{pixels.height, pixels.width, pixels.channels}, pixels.pixels.data(),
      owner);
}

/// Calls a Python function, if there is one, and ends the run if `stop` is true.
film::ProgressCallback progress_for(const py::object& callback, const std::atomic<bool>& stop) {
  return [&](int done, int total) {
    if (stop) throw Stopped{};
    if (callback.is_none()) return;
    const py::gil_scoped_acquire hold;
    callback(done, total);
  };
}

video::Quality quality_of(const std::optional<std::string>& effort, std::optional<int> crf) {
  video::Quality quality{.crf = crf};
  if (effort) quality.effort = find_enumerator<video::Effort>(*effort, "encode");
  return quality;
}

/// Returns the number of frames, and warnings.
std::pair<std::size_t, std::vector<std::string>> render(
    const scene::Scene& scene, const std::optional<fs::path>& video,
    const std::optional<std::string>& container, bool chapters,
    const std::optional<std::string>& effort, std::optional<int> crf,
    const std::optional<fs::path>& frames_folder, const std::string& range,
    const std::optional<std::string>& shard, const std::string& existing, std::optional<int> jobs,
    const std::string& backend, const std::optional<std::string>& egl_device,
    const std::vector<fs::path>& inputs, const py::object& progress) {
  film::RenderSettings settings;
  settings.frames_folder = frames_folder;
  if (video) {
    settings.video = film::VideoOutput{
        *video, container ? video::container_named(*container) : video::container_of(*video),
        chapters, quality_of(effort, crf)};
  }
  settings.inputs = inputs;
  settings.range = range;
  if (shard) settings.shard = video::parse_shard(*shard);
  settings.reuse = existing == "resume"      ? film::Reuse::resume
                   : existing == "overwrite" ? film::Reuse::overwrite
                                             : film::Reuse::none;
  if (jobs) settings.jobs = *jobs;
  settings.backend = {gl::backend_named(backend), egl_device};
  try {
    return run_interruptibly([&](const std::atomic<bool>& stop) {
      settings.stop = &stop;
      film::RenderJob job(scene, settings);
      job.run(progress_for(progress, stop));
      return std::pair(job.size(), job.warnings());
    });
  } catch (const system::ExistingFileError& error) {
    if (settings.reuse != film::Reuse::resume) throw;
    throw system::ExistingFileError("resume", error.what(),
                                    "pass overwrite=True instead of resume=True to replace it, or "
                                    "choose another path");
  }
}

/// Returns the number of frames.
std::size_t encode(const fs::path& folder, const fs::path& path,
                   const std::optional<std::string>& container, bool chapters,
                   const std::optional<std::string>& effort, std::optional<int> crf,
                   std::optional<int> width, const std::optional<fs::path>& audio,
                   bool leave_sound_out, bool allow_missing, bool overwrite,
                   const py::object& progress) {
  video::VideoOutput output{
      .path = path,
      .container = container ? video::container_named(*container) : video::container_of(path),
      .overwrite = overwrite,
      .chapters = chapters,
      .quality = quality_of(effort, crf),
      .audio = audio.value_or(fs::path()),
      .leave_sound_out = leave_sound_out};
  if (width) {
    if (!video::is_animated_image(output.container)) {
      throw InvalidArgument("width", "only animated images are scaled", "leave it out");
    }
    output.width = scene::limits::check_whole(scene::limits::pixels, "width", *width);
  }
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    int frames = 0;
    const auto report = progress_for(progress, stop);
    video::encode_frames(
        folder, output,
        allow_missing ? video::MissingFrames::leave_out : video::MissingFrames::refuse,
        [&](int done, int total) {
          frames = total;
          report(done, total);
        });
    return static_cast<std::size_t>(frames);
  });
}

/// The colours of a theme's overlays as "#rrggbb".
py::dict theme_colors(const std::string& theme) {
  const picture::OverlayColors& colors =
      picture::style_of(find_enumerator<scene::Theme>(theme, "theme")).overlay;
  const auto texts = [](const auto& several) {
    std::vector<std::string> found;
    for (const Color& color : several) found.push_back(to_string(color));
    return found;
  };
  py::dict found;
  found["axes"] = texts(colors.axis);
  found["components"] = texts(colors.curve);
  found["text"] = to_string(colors.text);
  found["momentum"] = to_string(colors.momentum);
  found["plane"] = to_string(colors.plane);
  return found;
}

image::Image draw(FrameDrawer& drawer, int frame) {
  return run_interruptibly([&](const std::atomic<bool>& stop) { return drawer.draw(frame, stop); });
}

}  // namespace

void add_pictures(py::module_& module) {
  using Drawer = std::unique_ptr<FrameDrawer, FrameDrawer::Deleter>;
  py::class_<FrameDrawer, Drawer>(module, "FrameDrawer")
      .def(py::init([](const scene::Scene& scene, const std::string& backend) {
        return Drawer(new FrameDrawer(scene, gl::BackendChoice{gl::backend_named(backend), {}}));
      }))
      .def("frame", [](FrameDrawer& drawer, int frame) { return to_array(draw(drawer, frame)); })
      .def("png", [](FrameDrawer& drawer, int frame) {
        const image::Image image = draw(drawer, frame);
        const auto png =
            run_interruptibly([&](const std::atomic<bool>&) { return image::encode_png(image); });
        return py::bytes(reinterpret_cast<const char*>(png.data()), png.size());
      });
  module.def("theme_colors", &theme_colors);
  module.def("render", &render);
  module.def("encode", &encode);
  module.def("effort_names", &enumerator_names<video::Effort>);
  module.def("container_names", [] { return video::format_texts(&video::OutputFormat::ending); });
  module.def("media_type", [](const fs::path& video) {
    return video::output_format(video::container_of(video)).media_type;
  });
}

}  // namespace twrench::python
