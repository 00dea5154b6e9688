#include "app/interruption.h"

#include <ctime>

namespace twrench {

Interruption::Interruption() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
}

Interruption::~Interruption() {
  arrived();  // those that still wait would end the program at the next line
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

std::optional<int> Interruption::arrived() {
  constexpr timespec at_once{0, 0};
  for (int signal = 0; (signal = sigtimedwait(&signals_, nullptr, &at_once)) > 0;) {
    if (!first_) first_ = signal;
  }
  return first_;
}

}  // namespace twrench
