// Loaded with LD_PRELOAD: counts the calls of each kind that the program makes, and makes one of
// them, or all from one on, fail as with a full disk, a limit or a lack of memory.
//
//  TWRENCH_FAULT=KIND:N:ERRNO:once|always   the N-th call, from 1, fails with errno's number ERRNO
//  TWRENCH_FAULT_LOG=FILE                   gets the number of calls of each kind when the program
//                                           ends, and the place of the first call that failed
//
// Only calls by our own code count and fail: those from the program's file, and from the C++
// libraries that work for it (libstdc++, fmt, toml++) if the first caller outside of them is the
// program. Calls by OpenGL drivers, LLVM, Cairo and OpenSSL always succeed: some of them abort when
// memory runs out, which we cannot fix. Internal calls of libc (the mmap below a malloc, a write
// below a printf) cannot be intercepted like this; the functions that make them can, and do fail.
//
// The functions have separate C++ names, and get those of libc through asm labels, because releases
// of libc declare different functions as noexcept.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string_view>

namespace {

enum Kind : unsigned {
  memory,
  opening,
  reading,
  writing,
  renaming,
  syncing,
  closing,
  piping,
  spawning,
  waiting,
  polling,
  mapping,
  listing,
  folding,
  threading,
  asking,
  controlling,
  kind_count
};
constexpr std::array<const char*, kind_count> kind_names{
    "memory", "open", "read", "write",   "rename", "fsync",  "close", "pipe", "spawn",
    "wait",   "poll", "mmap", "opendir", "mkdir",  "thread", "stat",  "fcntl"};

struct Range {
  std::uintptr_t begin = 0, end = 0;
  bool has(const void* address) const {
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    return begin <= at && at < end;
  }
};

struct State {
  Range program;
  std::array<Range, 8> helpers;  ///< the libraries that the program uses, and this one
  std::size_t helper_count = 0;
  std::array<std::atomic<long>, kind_count> counts{};
  unsigned target = kind_count;
  long at = 0;
  int error = 0;
  bool always = false;
  bool counts_all = false;
  const char* log = nullptr;
  std::atomic<bool> ready = false;
};

State& state() {
  static State the_state;
  return the_state;
}

/// Set while the shim itself runs; its calls are not counted.
__attribute__((tls_model("initial-exec"))) thread_local bool inside = false;

class Inside {
 public:
  Inside() : before_(inside) { inside = true; }
  ~Inside() { inside = before_; }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

 private:
  bool before_;
};

Range range_of(const dl_phdr_info& info) {
  Range range{~std::uintptr_t{0}, 0};
  for (unsigned i = 0; i < info.dlpi_phnum; ++i) {
    const auto& segment = info.dlpi_phdr[i];
    if (segment.p_type != PT_LOAD) continue;
    const std::uintptr_t begin = info.dlpi_addr + segment.p_vaddr;
    range.begin = begin < range.begin ? begin : range.begin;
    range.end = begin + segment.p_memsz > range.end ? begin + segment.p_memsz : range.end;
  }
  return range;
}

/// The first one reported is the program itself.
int note_library(dl_phdr_info* info, std::size_t, void*) {
  State& s = state();
  if (s.program.end == 0) {
    s.program = range_of(*info);
    return 0;
  }
  const std::string_view name(info->dlpi_name);
  for (const char* helper : {"libstdc++", "libfmt", "libtomlplusplus", "torture_fault_shim"}) {
    if (name.find(helper) == std::string_view::npos || s.helper_count == s.helpers.size()) continue;
    s.helpers[s.helper_count++] = range_of(*info);
  }
  return 0;
}

bool is_helper(const void* address) {
  const State& s = state();
  for (std::size_t i = 0; i < s.helper_count; ++i) {
    if (s.helpers[i].has(address)) return true;
  }
  return false;
}

/// Whether the program made the call, directly or through its helpers.
bool is_ours(const void* caller) {
  if (state().program.has(caller)) return true;
  if (!is_helper(caller)) return false;
  std::array<void*, 24> frames{};
  const int depth = ::backtrace(frames.data(), static_cast<int>(frames.size()));
  for (int i = 0; i < depth; ++i) {
    if (!is_helper(frames[static_cast<std::size_t>(i)])) {
      return state().program.has(frames[static_cast<std::size_t>(i)]);
    }
  }
  return false;
}

/// Logs the callers; addr2line -Cfie PROGRAM translates the numbers in brackets to lines.
void log_place(int log) {
  std::array<void*, 24> frames{};
  const int depth = ::backtrace(frames.data(), static_cast<int>(frames.size()));
  ::backtrace_symbols_fd(frames.data(), depth, log);
}

int open_log() {
  if (state().log == nullptr) return -1;
  static const auto open_file =
      reinterpret_cast<int (*)(const char*, int, ...)>(::dlsym(RTLD_NEXT, "open"));
  return open_file(state().log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
}

/// Returns the errno with which this call should fail; 0 if it should not.
int failure(Kind kind, const void* caller) {
  State& s = state();
  if (!s.ready || inside || (!s.counts_all && s.target != kind)) return 0;
  const Inside at_work;
  const int before = errno;
  const bool counts = is_ours(caller);
  const long n = counts ? ++s.counts[kind] : 0;
  errno = before;
  if (!counts || s.target != kind || n < s.at || (n > s.at && !s.always)) return 0;
  if (n == s.at) {
    if (const int log = open_log(); log >= 0) log_place(log);
  }
  return s.error;
}

void log_counts() {
  const Inside at_work;
  const int log = open_log();
  if (log < 0) return;
  for (unsigned i = 0; i < kind_count; ++i) {
    static_cast<void>(::dprintf(log, "count %s %ld\n", kind_names[i], state().counts[i].load()));
  }
}

/// "KIND:N:ERRNO:once|always"
void read_order(std::string_view order) {
  State& s = state();
  const std::string_view kind = order.substr(0, order.find(':'));
  for (unsigned i = 0; i < kind_count; ++i) {
    if (kind == kind_names[i]) s.target = i;
  }
  const char* const number = kind.data() + kind.size() + 1;
  char* end = nullptr;
  s.at = std::strtol(number, &end, 10);
  s.error = static_cast<int>(std::strtol(end + 1, nullptr, 10));
  s.always = order.ends_with(":always");
}

__attribute__((constructor)) void start() {
  const Inside at_work;
  State& s = state();
  // The program's children run undisturbed.
  ::unsetenv("LD_PRELOAD");
  ::dl_iterate_phdr(&note_library, nullptr);
  std::array<void*, 2> frames{};
  ::backtrace(frames.data(), 2);  // loads the libraries that it needs
  s.log = std::getenv("TWRENCH_FAULT_LOG");
  const char* const order = std::getenv("TWRENCH_FAULT");
  s.counts_all = order == nullptr;
  if (order != nullptr) read_order(order);
  if (s.counts_all) static_cast<void>(std::atexit(&log_counts));
  s.ready = true;
}

template <typename Function>
Function* next(const char* name) {
  const Inside at_work;
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp): glibc's own
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)

// FAULT_FUNCTION(KIND, RESULT IF IT FAILS, TYPE, NAME, (PARAMETERS), (ARGUMENTS)): interposes
// libc's function of that name. NOLINTBEGIN(bugprone-macro-parentheses): parameters and types take
// none
#define FAULT_FUNCTION(kind, failed, type, name, parameters, arguments) \
  extern "C" type fault_##name parameters __asm__(#name);               \
  extern "C" type fault_##name parameters {                             \
    if (const int error = failure(kind, __builtin_return_address(0))) { \
      errno = error;                                                    \
      return failed;                                                    \
    }                                                                   \
    static const auto libc = next<type parameters>(#name);              \
    return libc arguments;                                              \
  }

// Functions with an optional last argument, which is passed on whether or not it is present.
#define FAULT_OPEN(name)                                                        \
  extern "C" int fault_##name(const char* path, int flags, ...) __asm__(#name); \
  extern "C" int fault_##name(const char* path, int flags, ...) {               \
    std::va_list rest;                                                          \
    va_start(rest, flags);                                                      \
    const mode_t mode = va_arg(rest, mode_t);                                   \
    va_end(rest);                                                               \
    if (const int error = failure(opening, __builtin_return_address(0))) {      \
      errno = error;                                                            \
      return -1;                                                                \
    }                                                                           \
    static const auto libc = next<int(const char*, int, ...)>(#name);           \
    return libc(path, flags, mode);                                             \
  }

#define FAULT_OPENAT(name)                                                              \
  extern "C" int fault_##name(int at, const char* path, int flags, ...) __asm__(#name); \
  extern "C" int fault_##name(int at, const char* path, int flags, ...) {               \
    std::va_list rest;                                                                  \
    va_start(rest, flags);                                                              \
    const mode_t mode = va_arg(rest, mode_t);                                           \
    va_end(rest);                                                                       \
    if (const int error = failure(opening, __builtin_return_address(0))) {              \
      errno = error;                                                                    \
      return -1;                                                                        \
    }                                                                                   \
    static const auto libc = next<int(int, const char*, int, ...)>(#name);              \
    return libc(at, path, flags, mode);                                                 \
  }

#define FAULT_FCNTL(name)                                                      \
  extern "C" int fault_##name(int file, int command, ...) __asm__(#name);      \
  extern "C" int fault_##name(int file, int command, ...) {                    \
    std::va_list rest;                                                         \
    va_start(rest, command);                                                   \
    void* const argument = va_arg(rest, void*);                                \
    va_end(rest);                                                              \
    if (const int error = failure(controlling, __builtin_return_address(0))) { \
      errno = error;                                                           \
      return -1;                                                               \
    }                                                                          \
    static const auto libc = next<int(int, int, ...)>(#name);                  \
    return libc(file, command, argument);                                      \
  }

using Path = const char*;
// NOLINTNEXTLINE(performance-no-int-to-ptr): as defined by libc
void* const no_memory = reinterpret_cast<void*>(-1);
FAULT_OPEN(open)
FAULT_OPEN(open64)
FAULT_OPENAT(openat)
FAULT_OPENAT(openat64)
FAULT_FUNCTION(opening, nullptr, FILE*, fopen, (Path path, Path mode), (path, mode))
FAULT_FUNCTION(opening, nullptr, FILE*, fopen64, (Path path, Path mode), (path, mode))
FAULT_FUNCTION(reading, -1, ssize_t, read, (int file, void* to, std::size_t n), (file, to, n))
FAULT_FUNCTION(writing, -1, ssize_t, write, (int file, const void* from, std::size_t n),
               (file, from, n))
FAULT_FUNCTION(writing, -1, ssize_t, writev, (int file, const void* parts, int n), (file, parts, n))
FAULT_FUNCTION(writing, -1, ssize_t, vmsplice,
               (int file, const void* parts, std::size_t n, unsigned flags),
               (file, parts, n, flags))
FAULT_FUNCTION(writing, 0, std::size_t, fwrite,
               (const void* from, std::size_t size, std::size_t n, FILE* file),
               (from, size, n, file))
FAULT_FUNCTION(writing, EOF, int, fflush, (FILE * file), (file))
FAULT_FUNCTION(renaming, -1, int, rename, (Path from, Path to), (from, to))
FAULT_FUNCTION(renaming, -1, int, renameat, (int a, Path from, int b, Path to), (a, from, b, to))
FAULT_FUNCTION(renaming, -1, int, renameat2, (int a, Path from, int b, Path to, unsigned flags),
               (a, from, b, to, flags))
FAULT_FUNCTION(renaming, -1, int, linkat, (int a, Path from, int b, Path to, int flags),
               (a, from, b, to, flags))
FAULT_FUNCTION(syncing, -1, int, fsync, (int file), (file))
FAULT_FUNCTION(syncing, -1, int, fdatasync, (int file), (file))
FAULT_FUNCTION(syncing, -1, int, ftruncate, (int file, off_t size), (file, size))
FAULT_FUNCTION(piping, -1, int, pipe2, (int* ends, int flags), (ends, flags))
FAULT_FUNCTION(spawning, -1, pid_t, fork, (), ())
FAULT_FUNCTION(waiting, -1, pid_t, waitpid, (pid_t pid, int* status, int how), (pid, status, how))
FAULT_FUNCTION(polling, -1, int, poll, (void* events, unsigned long n, int ms), (events, n, ms))
FAULT_FUNCTION(polling, -1, int, ppoll,
               (void* events, unsigned long n, const void* time, const void* signals),
               (events, n, time, signals))
FAULT_FUNCTION(mapping, no_memory, void*, mmap,
               (void* at, std::size_t n, int protection, int flags, int file, off_t from),
               (at, n, protection, flags, file, from))
FAULT_FUNCTION(mapping, no_memory, void*, mmap64,
               (void* at, std::size_t n, int protection, int flags, int file, off_t from),
               (at, n, protection, flags, file, from))
FAULT_FUNCTION(listing, nullptr, void*, opendir, (Path path), (path))
FAULT_FUNCTION(listing, nullptr, void*, fdopendir, (int file), (file))
FAULT_FUNCTION(folding, -1, int, mkdir, (Path path, mode_t mode), (path, mode))
FAULT_FUNCTION(folding, -1, int, mkdirat, (int at, Path path, mode_t mode), (at, path, mode))
FAULT_FUNCTION(asking, -1, int, stat, (Path path, void* to), (path, to))
FAULT_FUNCTION(asking, -1, int, stat64, (Path path, void* to), (path, to))
FAULT_FUNCTION(asking, -1, int, lstat, (Path path, void* to), (path, to))
FAULT_FUNCTION(asking, -1, int, lstat64, (Path path, void* to), (path, to))
FAULT_FUNCTION(asking, -1, int, fstat, (int file, void* to), (file, to))
FAULT_FUNCTION(asking, -1, int, fstat64, (int file, void* to), (file, to))
FAULT_FUNCTION(asking, -1, int, fstatat, (int at, Path path, void* to, int flags),
               (at, path, to, flags))
FAULT_FUNCTION(asking, -1, int, statvfs, (Path path, void* to), (path, to))
FAULT_FUNCTION(asking, -1, int, statvfs64, (Path path, void* to), (path, to))
FAULT_FUNCTION(controlling, -1, int, flock, (int file, int how), (file, how))
FAULT_FCNTL(fcntl)
FAULT_FCNTL(fcntl64)

// These return the error and leave errno unchanged.
#define FAULT_ERROR(kind, name, parameters, arguments)                              \
  extern "C" int fault_##name parameters __asm__(#name);                            \
  extern "C" int fault_##name parameters {                                          \
    if (const int error = failure(kind, __builtin_return_address(0))) return error; \
    static const auto libc = next<int parameters>(#name);                           \
    return libc arguments;                                                          \
  }

FAULT_ERROR(spawning, posix_spawn,
            (pid_t * pid, Path path, const void* actions, const void* attributes,
             char* const* words, char* const* environment),
            (pid, path, actions, attributes, words, environment))
FAULT_ERROR(spawning, posix_spawnp,
            (pid_t * pid, Path file, const void* actions, const void* attributes,
             char* const* words, char* const* environment),
            (pid, file, actions, attributes, words, environment))
FAULT_ERROR(threading, pthread_create,
            (void* thread, const void* attributes, void* (*run)(void*), void* argument),
            (thread, attributes, run, argument))

// NOLINTEND(bugprone-macro-parentheses)

// close must release the descriptor even if it reports lost data.
extern "C" int fault_close(int file) __asm__("close");
extern "C" int fault_close(int file) {
  const int error = failure(closing, __builtin_return_address(0));
  static const auto libc = next<int(int)>("close");
  const int result = libc(file);
  if (error == 0) return result;
  errno = error;
  return -1;
}

extern "C" void* fault_malloc(std::size_t size) __asm__("malloc");
extern "C" void* fault_malloc(std::size_t size) {
  if (failure(memory, __builtin_return_address(0)) == 0) return __libc_malloc(size);
  errno = ENOMEM;
  return nullptr;
}

extern "C" void* fault_calloc(std::size_t count, std::size_t size) __asm__("calloc");
extern "C" void* fault_calloc(std::size_t count, std::size_t size) {
  if (failure(memory, __builtin_return_address(0)) == 0) return __libc_calloc(count, size);
  errno = ENOMEM;
  return nullptr;
}

extern "C" void* fault_realloc(void* old, std::size_t size) __asm__("realloc");
extern "C" void* fault_realloc(void* old, std::size_t size) {
  if (failure(memory, __builtin_return_address(0)) == 0) return __libc_realloc(old, size);
  errno = ENOMEM;
  return nullptr;
}

extern "C" void* fault_aligned_alloc(std::size_t to, std::size_t size) __asm__("aligned_alloc");
extern "C" void* fault_aligned_alloc(std::size_t to, std::size_t size) {
  if (failure(memory, __builtin_return_address(0)) == 0) return __libc_memalign(to, size);
  errno = ENOMEM;
  return nullptr;
}

extern "C" int fault_posix_memalign(void** at, std::size_t to,
                                    std::size_t size) __asm__("posix_memalign");
extern "C" int fault_posix_memalign(void** at, std::size_t to, std::size_t size) {
  if (failure(memory, __builtin_return_address(0)) != 0) return ENOMEM;
  *at = __libc_memalign(to, size);
  return *at == nullptr ? ENOMEM : 0;
}

namespace {

/// As the standard requires: calls the program's new handler, which may throw.
void* allocate(std::size_t size, const void* caller) {
  bool fails = failure(memory, caller) != 0;
  while (true) {
    void* const place = fails ? nullptr : __libc_malloc(size == 0 ? 1 : size);
    if (place != nullptr) return place;
    fails = false;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

}  // namespace

// Replaces operator new of libstdc++, so that the callers are visible. The other operators call
// these, or malloc.
void* operator new(std::size_t size) { return allocate(size, __builtin_return_address(0)); }
void* operator new[](std::size_t size) { return allocate(size, __builtin_return_address(0)); }
void operator delete(void* place) noexcept { std::free(place); }
void operator delete[](void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t) noexcept { std::free(place); }
