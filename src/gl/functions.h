#pragma once

#include <GL/glcorearb.h>

#include <span>
#include <string>

#include "gl/context.h"

namespace twrench::gl {

/// Returns whether this process has opened a Library. Throws GlError if it was forked from a
/// process that has, because a driver's threads and locks do not survive a fork.
bool has_used_opengl();

/// A shared library, opened at run time and never closed, because GL drivers leave threads and
/// thread-local destructors behind that outlive every context.
class Library {
 public:
  /// Opens the first of `names` that the loader finds. If there is none, throws GlError with
  /// `remedy` and `reason`, and lists the names. Also throws as has_used_opengl() does.
  Library(std::span<const char* const> names, const std::string& remedy,
          GlError::Reason reason = GlError::Reason::failed);

  /// Returns the address of a symbol, or null.
  void* symbol(const char* name) const;

 private:
  void* handle_ = nullptr;
};

/// The OpenGL functions in use, resolved through a context, which must be current when they are
/// called. Members have GL's names without the "gl".
struct Functions {
  /// Throws GlError, naming the function, if the context lacks one.
  explicit Functions(const Context& context);

  PFNGLGETERRORPROC GetError;
  PFNGLGETINTEGERVPROC GetIntegerv;
  PFNGLGETSTRINGPROC GetString;

  PFNGLGENBUFFERSPROC GenBuffers;
  PFNGLDELETEBUFFERSPROC DeleteBuffers;
  PFNGLBINDBUFFERPROC BindBuffer;
  PFNGLBUFFERDATAPROC BufferData;
  PFNGLMAPBUFFERRANGEPROC MapBufferRange;
  PFNGLUNMAPBUFFERPROC UnmapBuffer;
  PFNGLGENVERTEXARRAYSPROC GenVertexArrays;
  PFNGLDELETEVERTEXARRAYSPROC DeleteVertexArrays;
  PFNGLBINDVERTEXARRAYPROC BindVertexArray;
  PFNGLENABLEVERTEXATTRIBARRAYPROC EnableVertexAttribArray;
  PFNGLVERTEXATTRIBPOINTERPROC VertexAttribPointer;

  PFNGLCREATESHADERPROC CreateShader;
  PFNGLDELETESHADERPROC DeleteShader;
  PFNGLSHADERSOURCEPROC ShaderSource;
  PFNGLCOMPILESHADERPROC CompileShader;
  PFNGLGETSHADERIVPROC GetShaderiv;
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog;
  PFNGLCREATEPROGRAMPROC CreateProgram;
  PFNGLDELETEPROGRAMPROC DeleteProgram;
  PFNGLATTACHSHADERPROC AttachShader;
  PFNGLLINKPROGRAMPROC LinkProgram;
  PFNGLGETPROGRAMIVPROC GetProgramiv;
  PFNGLGETPROGRAMINFOLOGPROC GetProgramInfoLog;
  PFNGLUSEPROGRAMPROC UseProgram;
  PFNGLGETATTRIBLOCATIONPROC GetAttribLocation;
  PFNGLGETUNIFORMLOCATIONPROC GetUniformLocation;
  PFNGLUNIFORM1FPROC Uniform1f;
  PFNGLUNIFORM3FVPROC Uniform3fv;
  PFNGLUNIFORM4FVPROC Uniform4fv;
  PFNGLUNIFORMMATRIX3FVPROC UniformMatrix3fv;
  PFNGLUNIFORMMATRIX4FVPROC UniformMatrix4fv;

  PFNGLGENRENDERBUFFERSPROC GenRenderbuffers;
  PFNGLDELETERENDERBUFFERSPROC DeleteRenderbuffers;
  PFNGLBINDRENDERBUFFERPROC BindRenderbuffer;
  PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC RenderbufferStorageMultisample;
  PFNGLGENFRAMEBUFFERSPROC GenFramebuffers;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer;
  PFNGLFRAMEBUFFERRENDERBUFFERPROC FramebufferRenderbuffer;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC CheckFramebufferStatus;
  PFNGLBLITFRAMEBUFFERPROC BlitFramebuffer;
  PFNGLREADPIXELSPROC ReadPixels;
  PFNGLPIXELSTOREIPROC PixelStorei;
  PFNGLFLUSHPROC Flush;

  PFNGLVIEWPORTPROC Viewport;
  PFNGLSCISSORPROC Scissor;
  PFNGLENABLEPROC Enable;
  PFNGLDISABLEPROC Disable;
  PFNGLBLENDFUNCPROC BlendFunc;
  PFNGLDEPTHFUNCPROC DepthFunc;
  PFNGLDEPTHMASKPROC DepthMask;
  PFNGLFRONTFACEPROC FrontFace;
  PFNGLCLEARCOLORPROC ClearColor;
  PFNGLCLEARPROC Clear;
  PFNGLDRAWARRAYSPROC DrawArrays;
  PFNGLDRAWELEMENTSPROC DrawElements;
};

/// Returns GL's renderer and version, for example "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5
/// ...".
std::string renderer_string(const Functions& gl);

/// Returns whether GL's renderer name is that of a software rasteriser. A device may be a graphics
/// card without a driver; Mesa then draws in software.
bool draws_in_software(const Functions& gl);

}  // namespace twrench::gl
