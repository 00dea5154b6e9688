#include "gl/backend.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <utility>

#include "base/enumeration.h"
#include "gl/child_call.h"
#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/functions.h"

namespace twrench::gl {
namespace {

using Maker = std::function<std::unique_ptr<Context>()>;

/// Returns a context on the first available EGL hardware device, or null.
std::unique_ptr<Context> make_hardware_context() {
  try {
    for (const EglDevice& device : egl_devices()) {
      // The surfaceless platform selects one of the other devices.
      if (device.software || device.name == "surfaceless") continue;
      try {
        auto context = make_egl_context(device.name);
        if (!draws_in_software(Functions(*context))) return context;
      } catch (const GlError&) {  // the next one may be available
      }
    }
  } catch (const GlError&) {  // No EGL.
  }
  return nullptr;
}

/// Returns a context on the software device of EGL or, if none is marked as such, on the
/// surfaceless platform.
std::unique_ptr<Context> make_egl_software_context() {
  const auto devices = egl_devices();
  const bool told_apart = std::ranges::any_of(devices, &EglDevice::software);
  return make_egl_context(told_apart ? "software" : "surfaceless");
}

OpenedContext fall_back(bool egl_alone) {
  constexpr const char* note =
      "no graphics device is available through EGL; drawing in software with {}";
  std::string osmesa_reason;
  if (!egl_alone) {
    try {
      return {make_osmesa_context(), fmt::format(note, "OSMesa")};
    } catch (const GlError& error) {
      osmesa_reason = fmt::format("; OSMesa is not usable ({})", error.what());
    }
  }
  try {
    return {make_egl_software_context(), fmt::format(note, "EGL") + osmesa_reason};
  } catch (const GlError& error) {
    const std::string what = "no usable OpenGL", why = error.what() + osmesa_reason;
    if (egl_alone) throw GlError(what, why, error.remedy(), error.reason());
    throw GlError(what, why, "install one: apt-get install libegl1 libgl1-mesa-dri, or libosmesa6");
  }
}

/// Draws some pixels and returns the renderer. The driver compiles its first program for them.
std::string try_drawing(const Context& context) {
  constexpr int size = 16;
  constexpr Rectangle all{0, 0, size, size};
  const Functions gl(context);
  const Framebuffer framebuffer(gl, size, size, 1, ReadMode::at_once);
  framebuffer.clear(std::array{all});
  framebuffer.begin_read(all).finish();
  return renderer_string(gl);
}

/// Runs the call in a child process, unless this process has already used OpenGL without a crash.
std::string call_safely(const std::function<std::string()>& call) {
  return has_used_opengl() ? call() : ChildCall(call).result();
}

BackendReport report(std::string name, const Maker& make) {
  try {
    std::string renderer = call_safely([&] { return try_drawing(*make()); });
    return {std::move(name), std::move(renderer), {}};
  } catch (const Error&) {
    return {std::move(name), {}, std::current_exception()};
  }
}

std::vector<std::string> egl_device_names() {
  std::istringstream lines(call_safely([] {
    std::string all;
    for (const EglDevice& device : egl_devices()) all += device.name + "\n";
    return all;
  }));
  std::vector<std::string> names;
  for (std::string name; std::getline(lines, name);) names.push_back(name);
  return names;
}

OpenedContext open_here(const BackendChoice& choice) {
  if (choice.backend == Backend::osmesa) {
    if (choice.egl_device) {
      throw InvalidArgument("an EGL device", "OSMesa has none");
    }
    return {make_osmesa_context(), {}};
  }
  if (choice.egl_device) return {make_egl_context(*choice.egl_device), {}};
  if (auto context = make_hardware_context()) return {std::move(context), {}};
  return fall_back(choice.backend == Backend::egl);
}

struct BackendName {
  Backend backend;
  const char* name;
};
constexpr std::array backend_rows{BackendName{Backend::automatic, "auto"},
                                  BackendName{Backend::osmesa, "osmesa"},
                                  BackendName{Backend::egl, "egl"}};
static_assert(has_row_for_each(backend_rows, &BackendName::backend));

}  // namespace

std::vector<std::string> backend_names() {
  std::vector<std::string> names;
  for (const auto& [backend, name] : backend_rows) names.emplace_back(name);
  return names;
}

Backend backend_named(const std::string& name) {
  for (const auto& [backend, known] : backend_rows) {
    if (name == known) return backend;
  }
  throw InvalidArgument("backend", fmt::format("'{}' is unknown", name),
                        fmt::format("one of: {}", fmt::join(backend_names(), ", ")));
}

BackendTrial::BackendTrial(BackendChoice choice) : choice_(std::move(choice)) {
  if (has_used_opengl()) return;
  call_ = std::make_unique<ChildCall>([this] { return try_drawing(*open_here(choice_).context); });
}

BackendTrial::~BackendTrial() = default;

const BackendChoice& BackendTrial::finish() {
  if (call_ && !std::exchange(is_finished_, true)) call_->result();
  return choice_;
}

OpenedContext open_context(BackendTrial& trial) { return open_here(trial.finish()); }

OpenedContext open_context(BackendChoice choice) {
  BackendTrial trial(std::move(choice));
  return open_context(trial);
}

std::vector<BackendReport> backends() {
  std::vector<BackendReport> reports{report("osmesa", make_osmesa_context)};
  try {
    for (const std::string& name : egl_device_names()) {
      reports.push_back(report("egl " + name, [&] { return make_egl_context(name); }));
    }
  } catch (const GlError&) {
    reports.push_back({"egl", {}, std::current_exception()});
  }
  return reports;
}

}  // namespace twrench::gl
