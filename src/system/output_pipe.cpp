#include "system/output_pipe.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

namespace twrench::system {

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
