#include <GL/glcorearb.h>
#include <fmt/format.h>

#include <array>

#include "gl/context.h"
#include "gl/functions.h"

namespace twrench::gl {
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
