#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "errors.h"
#include "film/render_job.h"
#include "frame_drawer.h"
#include "image/png.h"
#include "interruptible.h"
#include "module.h"
#include "system/file.h"

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

/// Ends a run between two frames.
struct Stopped {};

/// Calls a Python function, if there is one, and ends the run where `stop` is true.
film::ProgressCallback progress_for(const py::object& callback, const std::atomic<bool>& stop) {
  return [&](int done, int total) {
    if (stop) throw Stopped{};
    if (callback.is_none()) return;
    const py::gil_scoped_acquire hold;
    callback(done, total);
  };
}

/// Returns the number of frames.
std::size_t render(const scene::Scene& scene, const std::optional<fs::path>& video,
                   const std::optional<std::string>& container, bool chapters,
                   const std::optional<fs::path>& frames_folder, const std::string& range,
                   const std::string& existing, std::optional<int> jobs, const std::string& backend,
                   const std::vector<fs::path>& inputs, const py::object& progress) {
  film::RenderSettings settings;
  settings.frames_folder = frames_folder;
  if (video) {
    settings.video = film::VideoOutput{
        *video, container ? video::container_named(*container) : video::container_of(*video),
        chapters};
    for (const fs::path& input : inputs) system::require_not_input(*video, input);
  }
  settings.range = range;
  settings.reuse = existing == "resume"      ? film::Reuse::resume
                   : existing == "overwrite" ? film::Reuse::overwrite
                                             : film::Reuse::none;
  if (jobs) settings.jobs = *jobs;
  settings.backend.backend = gl::backend_named(backend);
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    settings.stop = &stop;
    film::RenderJob job(scene, settings);
    job.run(progress_for(progress, stop));
    return job.size();
  });
}

image::Image draw(FrameDrawer& drawer, int frame) {
  return run_interruptibly([&](const std::atomic<bool>&) { return drawer.draw(frame); });
}

}  // namespace

void add_pictures(py::module_& module) {
  py::class_<FrameDrawer>(module, "FrameDrawer")
      .def(py::init([](const scene::Scene& scene, const std::string& backend) {
        return std::make_unique<FrameDrawer>(scene,
                                             gl::BackendChoice{gl::backend_named(backend), {}});
      }))
      .def("frame", [](FrameDrawer& drawer, int frame) { return to_array(draw(drawer, frame)); })
      .def("png", [](FrameDrawer& drawer, int frame) {
        const image::Image image = draw(drawer, frame);
        const auto png =
            run_interruptibly([&](const std::atomic<bool>&) { return image::encode_png(image); });
        return py::bytes(reinterpret_cast<const char*>(png.data()), png.size());
      });
  module.def("render", &render);
  module.def("container_names", [] { return video::format_texts(&video::OutputFormat::ending); });
  module.def("media_type", [](const fs::path& video) {
    return video::output_format(video::container_of(video)).media_type;
  });
}

}  // namespace twrench::python
