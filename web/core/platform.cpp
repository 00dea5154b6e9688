// Stubs for the facilities that a page lacks: threads, and exceptions, which JavaScript catches.
// Debian has no unwinder for WebAssembly, so the stack is not unwound: instance.js replaces the
// whole instance after an exception.

#include <cstdint>
#include <cstdlib>
#include <exception>

#include "base/parallel.h"

extern "C" {

[[noreturn, clang::import_module("env"), clang::import_name("fail")]] void fail(const char* what);

void* __cxa_allocate_exception(std::size_t size) { return std::malloc(size); }

void __cxa_free_exception(void*) {}

/// Every exception of the core derives from std::exception, which is at the start of the object.
[[noreturn]] void __cxa_throw(void* thrown, void*, void (*)(void*)) {
  fail(static_cast<const std::exception*>(thrown)->what());
}

std::uintptr_t __stack_chk_guard = 0x595e9fbd;
[[noreturn]] void __stack_chk_fail() { fail("core: the stack was overwritten"); }

}  // extern "C"

namespace twrench {

void for_each_part(std::size_t count, std::size_t, unsigned,
                   const std::function<void(std::size_t, std::size_t)>& work) {
  if (count > 0) work(0, count);
}

}  // namespace twrench
