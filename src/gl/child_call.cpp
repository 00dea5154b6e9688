#include "gl/child_call.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "gl/context.h"

namespace twrench::gl {
namespace {

/// The child writes `returned` and the text, or `threw`, the reason as a digit, the message, a NUL
/// and the remedy. Then it writes `done`. No text contains a NUL or `done`.
constexpr char returned = 'r', threw = 't', done = '\4';

void write_all(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(pipe, text.data(), text.size());
    if (written < 0 && errno != EINTR) return;
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

std::string answer_of(const std::function<std::string()>& call) {
  try {
    return returned + call() + done;
  } catch (const GlError& error) {
    return fmt::format("{}{}{}{}", threw, static_cast<int>(error.reason()), error.what(), '\0') +
           error.remedy() + done;
  } catch (const std::exception&) {  // the call in the parent process will throw it again
    return {returned, done};
  }
}

/// Leaves signals to the parent. The child ends with the parent, reports no crash and writes no
/// core file.
void become_quiet() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    static_cast<void>(std::signal(signal, SIG_IGN));
  }
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    static_cast<void>(std::signal(signal, SIG_DFL));
  }
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::dup2(nowhere, descriptor);
  }
}

/// Returns the remedy for a driver that crashes.
std::string remedy_for_crash() {
  std::vector<std::string> set;
  for (const char* name :
       {"GALLIUM_DRIVER", "MESA_LOADER_DRIVER_OVERRIDE", "LIBGL_DRIVERS_PATH",
        "LP_NATIVE_VECTOR_WIDTH", "__EGL_VENDOR_LIBRARY_FILENAMES", "LD_PRELOAD"}) {
    if (std::getenv(name) != nullptr) set.emplace_back(name);
  }
  if (!set.empty()) return fmt::format("unset {}", fmt::join(set, ", "));
  rlimit memory{};
  if (::getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY) {
    return "raise the limit on memory (ulimit -v)";
  }
  return "reinstall the OpenGL driver, or install another version";
}

GlError crashed(int status) {
  const std::string how = WIFSIGNALED(status)
                              ? fmt::format("signal {}", ::strsignal(WTERMSIG(status)))
                              : fmt::format("exit status {}", WEXITSTATUS(status));
  return {"OpenGL", fmt::format("its driver crashes ({})", how), remedy_for_crash(),
          GlError::Reason::crashed};
}

}  // namespace

ChildCall::ChildCall(const std::function<std::string()>& call) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw GlError("OpenGL",
                  fmt::format("cannot create a pipe to test the driver: {}", std::strerror(errno)),
                  "raise the limit on open files (ulimit -n)");
  }
  child_ = ::fork();
  if (child_ == 0) {
    become_quiet();
    write_all(ends[1], answer_of(call));
    ::_exit(0);  // skips the destructors of the parent's objects
  }
  pipe_ = ends[0];
  ::close(ends[1]);
  if (child_ >= 0) return;
  ::close(pipe_);
  throw GlError("OpenGL",
                fmt::format("cannot create a process to test the driver: {}", std::strerror(errno)),
                "raise the limit on processes (ulimit -u)");
}

ChildCall::~ChildCall() {
  if (child_ > 0) {
    ::kill(child_, SIGKILL);
    reap();
  }
  ::close(pipe_);
}

int ChildCall::reap() {
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return status;
}

std::string ChildCall::read_all() {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::minutes(1);
  std::string all;
  std::array<char, 4096> bytes{};
  while (Clock::now() < end) {
    pollfd from_child{pipe_, POLLIN, 0};
    const int ready = ::poll(&from_child, 1, 1000);
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    // If poll() fails, read() waits for the call without a time limit.
    const ssize_t got = ::read(pipe_, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw crashed(reap());
    all.append(bytes.data(), static_cast<std::size_t>(got));
    if (all.back() != done) continue;
    all.pop_back();
    return all;
  }
  throw GlError("OpenGL", "its driver hangs", remedy_for_crash(), GlError::Reason::crashed);
}

std::string ChildCall::result() {
  const std::string answer = read_all();
  if (answer[0] == returned) return answer.substr(1);
  const auto reason = static_cast<GlError::Reason>(answer[1] - '0');
  const std::size_t end = answer.find('\0');
  const std::string message = answer.substr(2, end - 2);
  const std::size_t colon = message.find(": ");
  throw GlError(message.substr(0, colon), message.substr(colon + 2), answer.substr(end + 1),
                reason);
}

}  // namespace twrench::gl
