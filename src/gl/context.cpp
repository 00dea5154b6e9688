#include "gl/context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "gl/functions.h"

namespace twrench::gl {
namespace {

constexpr std::array egl_libraries{"libEGL.so.1", "libEGL.so"};
constexpr const char* egl_remedy = "install EGL: apt-get install libegl1 libgl1-mesa-dri";
constexpr const char* surfaceless = "surfaceless";

[[noreturn]] void fail(const std::string& what, const std::string& why) {
  throw GlError("EGL " + what, why, {}, GlError::Reason::egl_device_refused);
}

/// Whether a space-separated list of extensions, which may be null, contains `name`.
bool has(const char* extensions, std::string_view name) {
  std::istringstream list(extensions == nullptr ? "" : extensions);
  for (std::string word; list >> word;) {
    if (word == name) return true;
  }
  return false;
}

/// The EGL functions in use, without the "egl".
class Egl {
 public:
  Egl() : library_(egl_libraries, egl_remedy) {
    // Mesa prints failures to standard error; here they are reported as errors instead.
    if (const auto control =
            function<PFNEGLDEBUGMESSAGECONTROLKHRPROC>("eglDebugMessageControlKHR");
        control != nullptr && has(extensions(), "EGL_KHR_debug")) {
      control([](EGLenum, const char*, EGLint, EGLLabelKHR, EGLLabelKHR, const char*) {}, nullptr);
    }
  }

  template <typename F>
  F function(const char* name) const {
    return reinterpret_cast<F>(GetProcAddress(name));
  }

  /// Client extensions, not those of a display. Null before EGL 1.5 without
  /// EGL_EXT_client_extensions.
  const char* extensions() const { return QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS); }

 private:
  template <typename F>
  F* entry(const char* name) const {
    void* const address = library_.symbol(name);
    if (address == nullptr)
      throw GlError("EGL", std::string("the library lacks ") + name, egl_remedy);
    return reinterpret_cast<F*>(address);
  }

  Library library_;

 public:
  decltype(&eglGetProcAddress) GetProcAddress =
      entry<decltype(eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglQueryString) QueryString = entry<decltype(eglQueryString)>("eglQueryString");
  decltype(&eglGetError) GetError = entry<decltype(eglGetError)>("eglGetError");
  decltype(&eglInitialize) Initialize = entry<decltype(eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) BindAPI = entry<decltype(eglBindAPI)>("eglBindAPI");
  decltype(&eglChooseConfig) ChooseConfig = entry<decltype(eglChooseConfig)>("eglChooseConfig");
  decltype(&eglCreateContext) CreateContext = entry<decltype(eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) DestroyContext =
      entry<decltype(eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) MakeCurrent = entry<decltype(eglMakeCurrent)>("eglMakeCurrent");
  decltype(&eglGetCurrentContext) GetCurrentContext =
      entry<decltype(eglGetCurrentContext)>("eglGetCurrentContext");
};

/// An EglDevice with its EGL handle: null on the surfaceless platform.
struct Device : EglDevice {
  EGLDeviceEXT handle = EGL_NO_DEVICE_EXT;
};

std::vector<EGLDeviceEXT> enumerate(const Egl& egl) {
  const auto query = egl.function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (query == nullptr || query(0, nullptr, &count) == EGL_FALSE) return {};
  std::vector<EGLDeviceEXT> handles(static_cast<std::size_t>(count));
  if (query(count, handles.data(), &count) == EGL_FALSE) return {};
  handles.resize(static_cast<std::size_t>(count));
  return handles;
}

std::vector<Device> devices(const Egl& egl) {
  const char* const extensions = egl.extensions();
  std::vector<Device> result;
  const bool enumerates =
      has(extensions, "EGL_EXT_device_enumeration") || has(extensions, "EGL_EXT_device_base");
  if (enumerates && has(extensions, "EGL_EXT_platform_device")) {
    const auto text = egl.function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    for (EGLDeviceEXT handle : enumerate(egl)) {
      const bool software =
          text != nullptr && has(text(handle, EGL_EXTENSIONS), "EGL_MESA_device_software");
      result.push_back({{std::to_string(result.size()), software}, handle});
    }
  }
  if (has(extensions, "EGL_MESA_platform_surfaceless")) {
    result.push_back({{surfaceless, false}, EGL_NO_DEVICE_EXT});
  }
  if (result.empty()) {
    throw GlError("EGL", "it lists no devices and lacks the surfaceless platform", egl_remedy);
  }
  return result;
}

Device find_device(const Egl& egl, const std::string& name) {
  const std::vector<Device> all = devices(egl);
  const auto found = std::ranges::find_if(all, [&](const Device& device) {
    return name == "software" ? device.software : device.name == name;
  });
  if (found != all.end()) return *found;
  std::string names;
  for (const Device& device : all) {
    names += fmt::format("{}{}{}", names.empty() ? "" : ", ", device.name,
                         device.software ? " (software)" : "");
  }
  throw InvalidArgument("EGL device " + name, "EGL has no device of that name",
                        "its devices: " + names);
}

class EglContext final : public Context {
 public:
  explicit EglContext(const std::string& name) : device_(find_device(egl_, name)) {
    open_display();
    make_context();
    if (egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_) == EGL_FALSE) {
      egl_.DestroyContext(display_, handle_);
      fail_on_device("its context could not be made current without a surface");
    }
  }

  /// The display is not terminated: EGL has one per device, which other contexts may share.
  ~EglContext() override {
    if (egl_.GetCurrentContext() == handle_) {
      egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    egl_.DestroyContext(display_, handle_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void* function(const char* name) const override { return egl_.function<void*>(name); }
  std::string backend() const override { return "egl"; }

 private:
  [[noreturn]] void fail_on_device(const std::string& why) const {
    fail("device " + device_.name, fmt::format("{} (EGL error {:#x})", why, egl_.GetError()));
  }

  void open_display() {
    const auto get = egl_.function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (get == nullptr) throw GlError("EGL", "it has no eglGetPlatformDisplayEXT", egl_remedy);
    display_ = device_.handle == EGL_NO_DEVICE_EXT
                   ? get(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr)
                   : get(EGL_PLATFORM_DEVICE_EXT, device_.handle, nullptr);
    if (display_ == EGL_NO_DISPLAY || egl_.Initialize(display_, nullptr, nullptr) == EGL_FALSE) {
      fail_on_device("it cannot be initialised");
    }
    if (!has(egl_.QueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
      fail_on_device("it does not support drawing without a surface");
    }
  }

  void make_context() {
    constexpr std::array config_attributes{EGL_SURFACE_TYPE, 0,  // any: no surface is created
                                           EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    constexpr std::array context_attributes{EGL_CONTEXT_MAJOR_VERSION,
                                            3,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            3,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl_.BindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        egl_.ChooseConfig(display_, config_attributes.data(), &config, 1, &count) == EGL_FALSE ||
        count == 0) {
      fail_on_device("it has no desktop OpenGL (it may have OpenGL ES)");
    }
    handle_ = egl_.CreateContext(display_, config, EGL_NO_CONTEXT, context_attributes.data());
    if (handle_ == EGL_NO_CONTEXT) fail_on_device("it has no OpenGL 3.3 core profile");
  }

  Egl egl_;
  Device device_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext handle_ = EGL_NO_CONTEXT;
};

}  // namespace

std::vector<EglDevice> egl_devices() {
  const std::vector<Device> all = devices(Egl());
  return {all.begin(), all.end()};
}

std::unique_ptr<Context> make_egl_context(const std::string& device) {
  return std::make_unique<EglContext>(device);
}

namespace {

// The part of OSMesa's interface that is used, as declared in include/GL/osmesa.h of Mesa 22.3 to
// 25.0. Mesa removed OSMesa in 25.1, so the header may be missing at compile time.
using OSMesaContext = struct osmesa_context*;
using OSMesaFunction = void (*)();
using OSMesaCreateContextAttribs = OSMesaContext(const int* attributes, OSMesaContext shared);
using OSMesaMakeCurrent = GLboolean(OSMesaContext context, void* pixels, GLenum type, GLsizei width,
                                    GLsizei height);
using OSMesaGetCurrentContext = OSMesaContext();
using OSMesaDestroyContext = void(OSMesaContext context);
using OSMesaGetProcAddress = OSMesaFunction(const char* name);
constexpr int OSMESA_FORMAT = 0x22;
constexpr int OSMESA_RGBA = GL_RGBA;
constexpr int OSMESA_PROFILE = 0x33;
constexpr int OSMESA_CORE_PROFILE = 0x34;
constexpr int OSMESA_CONTEXT_MAJOR_VERSION = 0x36;
constexpr int OSMESA_CONTEXT_MINOR_VERSION = 0x37;
constexpr std::array osmesa_libraries{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
constexpr const char* osmesa_remedy =
    "install OSMesa: apt-get install libosmesa6; Mesa 25.1 and newer no longer include it; "
    "draws through EGL";

[[noreturn]] void fail(const std::string& why) {
  throw GlError("OSMesa", why, osmesa_remedy, GlError::Reason::no_osmesa);
}

template <typename F>
F* entry(const Library& library, const char* name) {
  void* const address = library.symbol(name);
  if (address == nullptr) fail(fmt::format("it has no {}", name));
  return reinterpret_cast<F*>(address);
}

class OsmesaContext final : public Context {
 public:
  OsmesaContext() : library_(osmesa_libraries, osmesa_remedy, GlError::Reason::no_osmesa) {
    constexpr std::array attributes{OSMESA_FORMAT,
                                    OSMESA_RGBA,
                                    OSMESA_PROFILE,
                                    OSMESA_CORE_PROFILE,
                                    OSMESA_CONTEXT_MAJOR_VERSION,
                                    3,
                                    OSMESA_CONTEXT_MINOR_VERSION,
                                    3,
                                    0};
    handle_ = create_(attributes.data(), nullptr);
    if (handle_ == nullptr) fail("it cannot create an OpenGL 3.3 core profile context");
    if (make_current_(handle_, pixels_.data(), GL_UNSIGNED_BYTE, size, size) == GL_FALSE) {
      destroy_(handle_);
      throw GlError("OSMesa", "its context could not be made current");
    }
  }

  ~OsmesaContext() override {
    if (get_current_() == handle_) make_current_(nullptr, nullptr, 0, 0, 0);
    destroy_(handle_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void* function(const char* name) const override {
    return reinterpret_cast<void*>(get_function_(name));
  }
  std::string backend() const override { return "osmesa"; }

 private:
  static constexpr int size = 16;  // OSMesa requires a buffer to draw to; we draw to framebuffers

  Library library_;
  OSMesaCreateContextAttribs* create_ =
      entry<OSMesaCreateContextAttribs>(library_, "OSMesaCreateContextAttribs");
  OSMesaMakeCurrent* make_current_ = entry<OSMesaMakeCurrent>(library_, "OSMesaMakeCurrent");
  OSMesaGetCurrentContext* get_current_ =
      entry<OSMesaGetCurrentContext>(library_, "OSMesaGetCurrentContext");
  OSMesaDestroyContext* destroy_ = entry<OSMesaDestroyContext>(library_, "OSMesaDestroyContext");
  OSMesaGetProcAddress* get_function_ =
      entry<OSMesaGetProcAddress>(library_, "OSMesaGetProcAddress");
  OSMesaContext handle_ = nullptr;
  std::array<unsigned char, std::size_t{4} * size * size> pixels_{};
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace twrench::gl
