#include "system/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>
#include <utility>

namespace twrench::system {
namespace {

/// Blocks SIGPIPE on this thread, so that only EPIPE reports a closed reader.
class SigpipeBlocked {
 public:
  SigpipeBlocked() {
    sigemptyset(&sigpipe_);
    sigaddset(&sigpipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &sigpipe_, &before_);
  }
  ~SigpipeBlocked() {
    const timespec at_once{};
    if (!was_pending_) {
      sigtimedwait(&sigpipe_, nullptr, &at_once);
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  SigpipeBlocked(const SigpipeBlocked&) = delete;
  SigpipeBlocked& operator=(const SigpipeBlocked&) = delete;

 private:
  sigset_t sigpipe_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

struct Pipe {
  Descriptor read, write;
};

[[noreturn]] void throw_system_error(int error_number, const std::string& what) {
  throw std::system_error(error_number, std::generic_category(), what);
}

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw_system_error(errno, "pipe");
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// Assigns the child's descriptors 0, 1 and 2: input, output and errors.
class SpawnActions {
 public:
  SpawnActions(const Descriptor& input, int output, const Descriptor& errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input.get(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors.get(), STDERR_FILENO);
    if (output == ChildProcess::output_dropped) {
      posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    } else {
      posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    }
  }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Its own process group, and default signal handling, whatever this process has set.
class SpawnAttributes {
 public:
  SpawnAttributes() {
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnAttributes() { posix_spawnattr_destroy(&attributes_); }
  SpawnAttributes(const SpawnAttributes&) = delete;
  SpawnAttributes& operator=(const SpawnAttributes&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

pid_t spawn(std::vector<std::string> command, const Descriptor& input, int output,
            const Descriptor& errors) {
  std::vector<char*> arguments(command.size() + 1);  // The last is null.
  std::transform(command.begin(), command.end(), arguments.begin(),
                 [](std::string& argument) { return argument.data(); });
  pid_t pid = -1;
  const int failed = posix_spawnp(&pid, arguments[0], SpawnActions(input, output, errors).get(),
                                  SpawnAttributes().get(), arguments.data(), environ);
  if (failed != 0) {
    throw_system_error(failed, command[0]);
  }
  return pid;
}

/// Measures the time without progress. What a child prints is not progress, because it may print
/// without end. Time during which this program is stopped, and cannot see progress, counts as at
/// most one wait.
class Idleness {
 public:
  explicit Idleness(const Patience& patience) : left_(patience.time), stop_(patience.stop) {}

  /// Waits for the events, and returns whether there were any.
  bool wait(std::span<pollfd> events, ChildProcess::Time most = longest_wait) {
    const auto left = std::chrono::ceil<ChildProcess::Time>(left_);
    const auto span = std::clamp(left, ChildProcess::Time(0), most);
    const int found = ::poll(events.data(), events.size(), static_cast<int>(span.count()));
    if (found < 0 && errno != EINTR) throw_system_error(errno, "poll");
    const Clock::time_point now = Clock::now();
    left_ -= std::min<Clock::duration>(now - std::exchange(before_, now), longest_wait);
    return found > 0;
  }
  bool is_over() const { return left_.count() <= 0 || (stop_ != nullptr && *stop_); }

  /// The maximum delay before a request to stop is noticed.
  static constexpr ChildProcess::Time longest_wait = std::chrono::milliseconds(200);

 private:
  using Clock = std::chrono::steady_clock;
  Clock::duration left_;
  Clock::time_point before_ = Clock::now();
  const std::atomic<bool>* stop_;
};

ssize_t copy_into(int pipe, std::span<const std::uint8_t> bytes) {
  return ::write(pipe, bytes.data(), bytes.size());
}

/// Copies where the system does not support vmsplice, as in some sandboxes.
ssize_t lend_to(int pipe, std::span<const std::uint8_t> bytes) {
  const iovec pages{const_cast<std::uint8_t*>(bytes.data()), bytes.size()};  // only read
  const ssize_t lent = ::vmsplice(pipe, &pages, 1, SPLICE_F_NONBLOCK);
  const bool as_write_would = errno == EAGAIN || errno == EINTR || errno == EPIPE;
  return lent >= 0 || as_write_would ? lent : copy_into(pipe, bytes);
}

/// Returns the exit status as a shell reports it.
int exit_status(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, Patience patience, int output)
    : patience_(patience) {
  Pipe input = make_pipe();
  Pipe errors = make_pipe();
  {
    // No signal may end us between starting the child and registering its kill action.
    const auto hold = hold_termination();
    kill_.emplace([this](TerminationMessage&) { ::kill(-pid_, SIGKILL); });
    pid_ = spawn(command, input.read, output, errors.write);
  }
  input_ = std::move(input.write);
  errors_ = std::move(errors.read);
  ::fcntl(input_.get(), F_SETFL, O_NONBLOCK);
  // A frame is several megabytes: a larger pipe means fewer, larger writes. If the system refuses,
  // writing is merely slower.
  ::fcntl(input_.get(), F_SETPIPE_SZ, 1 << 20);
}

ChildProcess::~ChildProcess() {
  if (pid_ < 0) return;
  // Once it has been waited for, its number may belong to another process.
  const auto hold = hold_termination();
  ::kill(-pid_, SIGKILL);
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
  kill_.reset();
}

bool ChildProcess::has_ended() {
  const auto hold = hold_termination();
  const pid_t ended = ::waitpid(pid_, &status_, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
  if (ended < 0) {  // its exit status is unknown, so its work may be incomplete
    ::kill(-pid_, SIGKILL);
    status_ = W_EXITCODE(255, 0);
  }
  kill_.reset();
  pid_ = -1;
  return true;
}

int ChildProcess::read_errors() {
  constexpr std::size_t kept = 8192;
  std::array<char, 4096> portion{};
  const ssize_t got = ::read(errors_.get(), portion.data(), portion.size());
  if (got > 0) {
    error_output_.append(portion.data(), static_cast<std::size_t>(got));
    error_output_.erase(0, error_output_.size() - std::min(error_output_.size(), kept));
  } else if (got == 0 || errno != EINTR) {
    errors_.close();
  }
  return static_cast<int>(std::max<ssize_t>(got, 0));
}

void ChildProcess::kill_unresponsive(Time waited) {
  timed_out_ = true;
  time_waited_ = waited;
  ::kill(-pid_, SIGKILL);
}

bool ChildProcess::write(std::span<const std::uint8_t> bytes) { return send(bytes, &copy_into); }

bool ChildProcess::lend(std::span<const std::uint8_t> bytes) { return send(bytes, &lend_to); }

std::size_t ChildProcess::pipe_size() const {
  return static_cast<std::size_t>(::fcntl(input_.get(), F_GETPIPE_SZ));
}

bool ChildProcess::send(std::span<const std::uint8_t> bytes, Put put) {
  const SigpipeBlocked blocked;
  Idleness idle(patience_);
  while (!bytes.empty()) {
    // Standard error is read meanwhile, because a child blocked on writing errors would stop
    // reading.
    std::array<pollfd, 2> ready{{{input_.get(), POLLOUT, 0}, {errors_.get(), POLLIN, 0}}};
    const bool has_event = idle.wait(ready);
    if (has_event && ready[1].revents != 0) read_errors();
    if (!has_event || ready[0].revents == 0) {
      if (!idle.is_over()) continue;
      kill_unresponsive(patience_.time);
      return false;
    }
    const ssize_t written = put(input_.get(), bytes);
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
      idle = Idleness(patience_);
    } else if (errno != EINTR && errno != EAGAIN) {
      return false;
    }
  }
  return true;
}

int ChildProcess::wait(Time work_left) {
  if (pid_ < 0) return exit_status(status_);
  input_.close();
  const Time most_time = patience_.time + work_left;
  Idleness idle({most_time, patience_.stop});
  std::array<pollfd, 1> ready{};
  while (!has_ended()) {
    // The end of standard error usually means the end of the child. If the child closed it earlier,
    // its exit is polled.
    ready[0] = {errors_.get(), POLLIN, 0};
    const Time most = errors_ ? Idleness::longest_wait : Time(1);
    if (idle.wait(ready, most)) read_errors();
    if (idle.is_over() && !timed_out_) kill_unresponsive(most_time);
  }
  // Reads only as much as the pipe holds, because a process that the child started may still print.
  const int in_pipe = errors_ ? ::fcntl(errors_.get(), F_GETPIPE_SZ) : 0;
  ready[0] = {errors_.get(), POLLIN, 0};
  for (int read = 0; read < in_pipe && errors_ && ::poll(ready.data(), 1, 0) > 0;) {
    read += read_errors();
  }
  return exit_status(status_);
}

OutputPipe::OutputPipe(Receive receive) : receive_(std::move(receive)) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  read_end_ = Descriptor(ends[0]);
  write_end_ = Descriptor(ends[1]);
  ::fcntl(read_end_.get(), F_SETFL, O_NONBLOCK);
  reader_ = std::thread([this] { read_all(); });
}

void OutputPipe::finish() {
  write_end_.close();
  has_ended_ = true;
  if (reader_.joinable()) reader_.join();
}

/// Ends at the end of the output. A process that the child started may keep the pipe open; then it
/// ends when the pipe is empty after the end of the child.
void OutputPipe::read_all() {
  constexpr int longest_wait = 200;  // ms
  std::vector<std::uint8_t> piece(1U << 16U);
  while (true) {
    const bool was_last_wait = has_ended_;
    pollfd ready{read_end_.get(), POLLIN, 0};
    ::poll(&ready, 1, was_last_wait ? 0 : longest_wait);
    const ssize_t got = ::read(read_end_.get(), piece.data(), piece.size());
    if (got > 0) {
      receive_({piece.data(), static_cast<std::size_t>(got)});
    } else if (got == 0 || was_last_wait || (errno != EAGAIN && errno != EINTR)) {
      return;
    }
  }
}

}  // namespace twrench::system
