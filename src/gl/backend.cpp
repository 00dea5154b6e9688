#include "gl/backend.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "gl/error.h"
#include "gl/functions.h"

namespace twrench::gl {
namespace {

using Maker = std::function<std::unique_ptr<Context>()>;

/// Returns a context on the first available EGL hardware device, or null.
std::unique_ptr<Context> make_hardware_context() {
  try {
    for (const EglDevice& device : egl_devices()) {
      // It selects one of the others.
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

/// Returns EGL's software device or, if none is marked as such, what the surfaceless platform
/// selects.
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
    throw GlError(what, why, "install one: apt-get install libegl1 libegl-mesa0, or libosmesa6");
  }
}

BackendReport report(std::string name, const Maker& make) {
  try {
    const auto context = make();
    return {std::move(name), renderer_string(Functions(*context)), {}};
  } catch (const Error&) {
    return {std::move(name), {}, std::current_exception()};
  }
}

constexpr std::array<std::pair<const char*, Backend>, 3> named_backends{
    {{"auto", Backend::automatic}, {"osmesa", Backend::osmesa}, {"egl", Backend::egl}}};

}  // namespace

std::vector<std::string> backend_names() {
  std::vector<std::string> names;
  for (const auto& [name, backend] : named_backends) names.emplace_back(name);
  return names;
}

Backend backend_named(const std::string& name) {
  for (const auto& [known, backend] : named_backends) {
    if (name == known) return backend;
  }
  throw InvalidArgument("backend", fmt::format("'{}' is unknown", name),
                        fmt::format("one of: {}", fmt::join(backend_names(), ", ")));
}

OpenedContext open_context(const BackendChoice& choice) {
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

std::vector<BackendReport> backends() {
  std::vector<BackendReport> reports{report("osmesa", make_osmesa_context)};
  try {
    for (const EglDevice& device : egl_devices()) {
      reports.push_back(
          report("egl " + device.name, [&] { return make_egl_context(device.name); }));
    }
  } catch (const GlError&) {
    reports.push_back({"egl", {}, std::current_exception()});
  }
  return reports;
}

}  // namespace twrench::gl
