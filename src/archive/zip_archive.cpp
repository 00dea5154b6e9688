#include "archive/zip_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "system/error.h"

namespace twrench::archive {

/// The archive, and its place in the bytes that it reads.
struct ZipArchive::State {
  ZipBytes bytes;
  std::uint64_t offset = 0;
  std::exception_ptr failure;  ///< of reading the bytes, which may not pass through the library
  zip_error_t error{};
  zip_t* archive = nullptr;

  explicit State(ZipBytes read_from) : bytes(std::move(read_from)) { zip_error_init(&error); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (archive) zip_discard(archive);
    zip_error_fini(&error);
  }

  void rethrow_failure() const {
    if (failure) std::rethrow_exception(failure);
  }

  /// Returns the error about the archive or, if `member` is not empty, a member of it.
  system::FileError bad(const std::string& member, const std::string& why) const {
    return {member.empty() ? bytes.name : fmt::format("{}: {}", bytes.name, member), why,
            bytes.remedy};
  }
};

struct ZipArchive::Stream::State {
  const ZipArchive::State* archive = nullptr;
  std::string member;
  zip_file_t* file = nullptr;

  State(const ZipArchive::State* in, std::string name) : archive(in), member(std::move(name)) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (file) zip_fclose(file);
  }
};

namespace {

/// The library's interface to the bytes.
template <typename State>
zip_int64_t read_bytes(void* user, void* data, zip_uint64_t length, zip_source_cmd_t command) {
  State& state = *static_cast<State*>(user);
  constexpr zip_int64_t failed = -1;
  // The commands of libzip's other sources are not announced by ZIP_SOURCE_SUPPORTS.
  if (command == ZIP_SOURCE_OPEN) {
    state.offset = 0;
    return 0;
  }
  if (command == ZIP_SOURCE_READ) {
    try {
      const std::size_t got = state.bytes.read(state.offset, static_cast<char*>(data),
                                               static_cast<std::size_t>(length));
      state.offset += got;
      return static_cast<zip_int64_t>(got);
    } catch (...) {
      state.failure = std::current_exception();
      zip_error_set(&state.error, ZIP_ER_READ, 0);
      return failed;
    }
  }
  if (command == ZIP_SOURCE_STAT) {
    auto* stat = static_cast<zip_stat_t*>(data);
    zip_stat_init(stat);
    stat->size = state.bytes.size;
    stat->valid = ZIP_STAT_SIZE;
    return sizeof(zip_stat_t);
  }
  if (command == ZIP_SOURCE_SEEK) {
    const zip_int64_t offset =
        zip_source_seek_compute_offset(state.offset, state.bytes.size, data, length, &state.error);
    if (offset < 0) return failed;
    state.offset = static_cast<std::uint64_t>(offset);
    return 0;
  }
  if (command == ZIP_SOURCE_TELL) return static_cast<zip_int64_t>(state.offset);
  if (command == ZIP_SOURCE_ERROR) return zip_error_to_data(&state.error, data, length);
  if (command == ZIP_SOURCE_SUPPORTS) {
    return zip_source_make_command_bitmap(
        ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR,
        ZIP_SOURCE_FREE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, ZIP_SOURCE_SUPPORTS, -1);
  }
  return 0;  // close, free
}

}  // namespace

ZipArchive::ZipArchive(ZipBytes bytes) : state_(std::make_unique<State>(std::move(bytes))) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_function_create(read_bytes<State>, state_.get(), &error);
  if (source) state_->archive = zip_open_from_source(source, ZIP_RDONLY, &error);
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (!state_->archive) {
    if (source) zip_source_free(source);
    state_->rethrow_failure();
    throw state_->bad({}, fmt::format("the ZIP archive is cut off or damaged ({})", why));
  }
  constexpr zip_int64_t most_members = 16384;
  const zip_int64_t count = zip_get_num_entries(state_->archive, 0);
  if (count > most_members) {
    throw state_->bad({}, fmt::format("the ZIP archive has {} members, but at most {} are read",
                                      count, most_members));
  }
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    const auto index = static_cast<zip_uint64_t>(i);
    if (zip_stat_index(state_->archive, index, 0, &stat) != 0) continue;
    if ((stat.valid & ZIP_STAT_NAME) != 0 && (stat.valid & ZIP_STAT_SIZE) != 0)
      members_.push_back({stat.name, index, stat.size});
  }
}

ZipArchive::~ZipArchive() = default;
ZipArchive::ZipArchive(ZipArchive&&) noexcept = default;
ZipArchive& ZipArchive::operator=(ZipArchive&&) noexcept = default;

ZipArchive::Stream::Stream(std::unique_ptr<State> state) : state_(std::move(state)) {}
ZipArchive::Stream::~Stream() = default;
ZipArchive::Stream::Stream(Stream&&) noexcept = default;
ZipArchive::Stream& ZipArchive::Stream::operator=(Stream&&) noexcept = default;

ZipArchive::Stream ZipArchive::open(const ZipMember& member) const {
  zip_stat_t stat;
  if (zip_stat_index(state_->archive, member.index, 0, &stat) != 0) {
    throw state_->bad(member.name, zip_strerror(state_->archive));
  }
  if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE) {
    throw state_->bad(member.name, "it is encrypted");
  }
  // Deflate, the usual method, packs at most 1032 bytes into one.
  constexpr std::uint64_t most_ratio = 1100;
  if ((stat.valid & ZIP_STAT_COMP_SIZE) != 0 && stat.size / most_ratio > stat.comp_size) {
    throw state_->bad(
        member.name, fmt::format("its {} bytes cannot be packed in {}", stat.size, stat.comp_size));
  }
  auto state = std::make_unique<Stream::State>(state_.get(), member.name);
  state->file = zip_fopen_index(state_->archive, member.index, 0);
  if (!state->file) {
    state_->rethrow_failure();
    throw state_->bad(member.name,
                      fmt::format("it cannot be unpacked ({})", zip_strerror(state_->archive)));
  }
  return Stream(std::move(state));
}

std::size_t ZipArchive::Stream::read(char* to, std::size_t length) {
  std::size_t done = 0;
  while (done < length) {
    const zip_int64_t got = zip_fread(state_->file, to + done, length - done);
    if (got < 0) {
      state_->archive->rethrow_failure();
      throw state_->archive->bad(state_->member, fmt::format("it cannot be unpacked ({})",
                                                             zip_file_strerror(state_->file)));
    }
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace twrench::archive
