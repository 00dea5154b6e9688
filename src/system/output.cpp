#include "system/output.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>

#include "system/error.h"
#include "system/file.h"

namespace twrench::system {
namespace {

[[noreturn]] void fail_to_write() {
  const char* const what = "cannot write standard output";
  if (errno == EPIPE) throw ClosedPipe(what, "its reader has ended");
  throw file_error(what, errno);
}

}  // namespace

Output::Output(const OutputFile& file) {
  if (file.path() != "-") file_.emplace(file.path());
}

void Output::write(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;
  waiting_ += text;
  if (waiting_.size() >= enough) pass_on();
}

void Output::finish() {
  pass_on();
  if (file_) return file_->commit();
  if (std::fflush(stdout) != 0) fail_to_write();
}

void Output::pass_on() {
  if (file_) {
    file_->write({reinterpret_cast<const std::uint8_t*>(waiting_.data()), waiting_.size()});
  } else if (std::fwrite(waiting_.data(), 1, waiting_.size(), stdout) != waiting_.size()) {
    fail_to_write();
  }
  waiting_.clear();
}

void write_output(const OutputFile& file, std::string_view text) {
  Output output(file);
  output.write(text);
  output.finish();
}

void write_output(std::string_view text) {
  Output output;
  output.write(text);
  output.finish();
}

}  // namespace twrench::system
