// Stands for a driver of OpenGL that crashes as soon as it is loaded.
#include <csignal>

namespace {
[[gnu::constructor]] void crash() { static_cast<void>(std::raise(SIGSEGV)); }
}  // namespace
