// An OpenGL driver, for tests, that crashes as soon as it is loaded.
#include <csignal>

namespace {
[[gnu::constructor]] void crash() { static_cast<void>(std::raise(SIGSEGV)); }
}  // namespace
