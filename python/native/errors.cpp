#include "errors.h"

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <twrench/motion/error.h>

#include <system_error>

#include "base/words.h"
#include "canvas/font.h"
#include "check/verdict/error.h"
#include "film/error.h"
#include "gl/context.h"
#include "recording/conventions/convention.h"
#include "recording/conventions/names.h"
#include "text/escape.h"
#include "video/error.h"

namespace twrench::python {
namespace {

namespace py = pybind11;

/// The remedy in terms of the module's arguments; may be empty.
std::string remedy_of(const motion::MotionError& error) {
  using enum motion::MotionError::Reason;
  switch (error.reason()) {
    case step_too_long:
      return "take a shorter step";
    case diverged:
      return "take a shorter step, or a method that stays on SO(3)";
    case too_many_steps:
      return "take a longer step or a shorter duration";
    case out_of_steps:
      return "take a larger tolerance or a shorter duration";
    case step_underflow:
      return "take a larger tolerance, or a slower motion";
    case too_many_flips:
      return "take a shorter duration";
    case stopped:
      break;
  }
  return {};
}

std::string remedy_of(const Error& error) {
  const auto* gl = dynamic_cast<const gl::GlError*>(&error);
  if (gl != nullptr && gl->reason() == gl::GlError::Reason::forked) {
    return "start processes by multiprocessing's 'spawn' or 'forkserver'";
  }
  if (!error.remedy().empty()) return error.remedy();
  if (const auto* motion = dynamic_cast<const motion::MotionError*>(&error)) {
    return remedy_of(*motion);
  }
  if (const auto* size = dynamic_cast<const video::FilmSizeError*>(&error)) {
    return fmt::format("use size=({}, {}), or write frames alone", size->width(), size->height());
  }
  if (const auto* glyph = dynamic_cast<const canvas::MissingGlyph*>(&error)) {
    return fmt::format(
        "set font to a file of a font that has it: fc-list :charset={:x} lists those that are "
        "installed",
        static_cast<std::uint32_t>(glyph->character()));
  }
  if (dynamic_cast<const film::SpaceError*>(&error)) {
    return "free some space, or choose another disk, a smaller size or fewer frames";
  }
  if (dynamic_cast<const film::ThreadError*>(&error)) {
    return "use fewer jobs, or raise the limit on processes";
  }
  if (dynamic_cast<const system::OverwriteError*>(&error)) {
    return "pass overwrite=True to replace it, or choose another path";
  }
  return {};
}

/// The name of the exception in twrench.errors.
const char* type_of(const Error& error) {
  if (dynamic_cast<const SceneError*>(&error)) return "SceneError";
  if (dynamic_cast<const canvas::MissingGlyph*>(&error)) return "SceneError";
  if (dynamic_cast<const video::FilmSizeError*>(&error)) return "SceneError";
  if (dynamic_cast<const InvalidArgument*>(&error)) return "UsageError";
  if (dynamic_cast<const check::CheckError*>(&error)) return "UsageError";
  if (dynamic_cast<const motion::MotionError*>(&error)) return "MotionError";
  if (dynamic_cast<const gl::GlError*>(&error)) return "GlError";
  if (dynamic_cast<const video::EncoderError*>(&error)) return "EncoderError";
  if (dynamic_cast<const system::OverwriteError*>(&error)) return "OverwriteError";
  if (dynamic_cast<const system::FileError*>(&error)) return "FileError";
  return "Error";
}

/// A text as Python's str on one line; bytes that are not UTF-8, which a path may have, are
/// escaped.
py::str to_str(const std::string& text) { return {text::escape(text)}; }

void set_exception(const char* type, const std::string& message, const std::string& remedy) {
  const py::object exception = py::module_::import("twrench.errors").attr(type);
  const py::object value = exception(to_str(message), to_str(remedy));
  PyErr_SetObject(exception.ptr(), value.ptr());
}

/// A text as Python writes it.
std::string in_quotes(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '\'';
}

/// "{'t': 'time', 'wx': 'p'}"
std::string dictionary(std::string_view columns) {
  const std::map<std::string, std::string> named = recording::parse_columns(columns, "columns");
  std::string text;
  for (const std::string& ours : recording::all_names()) {
    const auto column = named.find(ours);
    if (column == named.end()) continue;
    text += (text.empty() ? "{" : ", ") + in_quotes(ours) + ": " + in_quotes(column->second);
  }
  return text + '}';
}

/// "[1, 0, 0, 0]"
std::string list(std::string_view numbers) {
  std::string text = "[";
  for (const char c : numbers) text += c == ',' ? std::string(", ") : std::string(1, c);
  return text + ']';
}

std::string in_capitals(std::string_view axes) {
  std::string capitals;
  for (const char axis : axes) capitals += static_cast<char>('X' + (axis - 'x'));
  return capitals;
}

bool is_number(std::string_view text) {
  return text.find_first_not_of("+-.0123456789e") == std::string_view::npos;
}

}  // namespace

std::string argument_text(std::string_view name, std::string_view value) {
  if (name == "from-mesh") return "from_mesh=True";
  if (name == "package-path") return fmt::format("package_path=[\"{}\"]", value);
  if (value.empty()) return std::string(name) + (name == "fit" || name == "inverse" ? "=True" : "");
  if (name == "inertia") return fmt::format("body=Body(moments={})", list(value));
  const bool is_time = name == "from" || name == "to";  // "from" is a keyword of Python
  std::string text = std::string(name) + (is_time ? "_time=" : "=");
  if (name == "columns") return text + dictionary(value);
  if (name == "offset") return text + list(value);
  if (is_number(value)) return text.append(value);
  // Capitals are axes that turn with the body, as the program's always do.
  return fmt::format("{}\"{}\"", text,
                     name == "sequence" ? in_capitals(value) : std::string(value));
}

void register_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      set_exception(type_of(error), with_arguments(error.what(), argument_text),
                    with_arguments(remedy_of(error), argument_text));
    } catch (const std::system_error& error) {
      set_exception("FileError", fmt::format("the system refused: {}", error.what()), {});
    }
  });
}

}  // namespace twrench::python
