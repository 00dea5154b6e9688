#include "system/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scratch_folder.h"
#include "system/error.h"

namespace twrench::system {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string text_of(const std::filesystem::path& path) {
  const auto bytes = read_file(path, 1'000'000);
  return {bytes.begin(), bytes.end()};
}

/// The message of the FileError that `action` throws.
template <typename Action>
std::string failure(Action&& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(File, IsWrittenWholeAndAlone) {
  const ScratchFolder scratch;
  write_file_atomically(scratch / "a.txt", std::string_view("first, and longer"));
  write_file_atomically(scratch / "a.txt", std::string_view("second"));
  EXPECT_EQ(text_of(scratch / "a.txt"), "second");
  EXPECT_THAT(scratch.names(), ElementsAre("a.txt"));
}

TEST(File, ReadsBackAnyBytes) {
  const ScratchFolder scratch;
  std::vector<std::uint8_t> bytes(100'001);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::uint8_t>(i * 7 >> 3U);
  }
  write_file_atomically(scratch / "bytes", bytes);
  EXPECT_EQ(read_file(scratch / "bytes", bytes.size()), bytes);
}

TEST(File, ReadsWhatHasNoSize) { EXPECT_THAT(text_of("/proc/self/status"), HasSubstr("Pid:")); }

TEST(File, RefusesToReadWhatIsLongerThanAllowed) {
  const ScratchFolder scratch;
  write_file_atomically(scratch / "long", std::string_view("0123456789"));
  EXPECT_THAT(failure([&] { read_file(scratch / "long", 9); }), HasSubstr("longer than 9 bytes"));
  EXPECT_THAT(failure([] { read_file("/dev/zero", 1'000'000); }), HasSubstr("longer than"));
}

TEST(File, ThatMustBeRegularIsNotAPipe) {
  const ScratchFolder scratch;
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(failure([&] { read_regular_file(scratch / "pipe", 10); }),
              HasSubstr("not a regular file"));
  EXPECT_THAT(failure([] { read_regular_file("/dev/zero", 10); }), HasSubstr("not a regular file"));
  write_file_atomically(scratch / "file", std::string_view("x"));
  EXPECT_EQ(read_regular_file(scratch / "file", 10).size(), 1U);
}

TEST(File, SaysWhichFileCannotBeReadAndWhy) {
  const ScratchFolder scratch;
  EXPECT_EQ(failure([&] { read_file("/no/such.png", 10); }),
            "cannot read /no/such.png: No such file or directory");
  EXPECT_THAT(failure([&] { read_file(scratch.path(), 10); }), HasSubstr("Is a directory"));
}

TEST(File, CannotBeWrittenUnderAFile) {
  const ScratchFolder scratch;
  write_file_atomically(scratch / "file", std::string_view("x"));
  EXPECT_THAT(failure([&] { write_file_atomically(scratch / "file/b", std::string_view("y")); }),
              HasSubstr("cannot write"));
  EXPECT_THAT(scratch.names(), ElementsAre("file"));
}

TEST(File, OnAFullDiskLeavesTheOldOneAndNothingElse) {
  const ScratchFolder scratch;
  write_file_atomically(scratch / "a", std::string_view("old"));
  // A file size limit simulates a full disk: write() is short at first, then fails.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message =
      failure([&] { write_file_atomically(scratch / "a", std::string(1000, 'y')); });
  setrlimit(RLIMIT_FSIZE, &before);
  (void)std::signal(SIGXFSZ, handler);
  EXPECT_THAT(message, HasSubstr("File too large"));
  EXPECT_EQ(text_of(scratch / "a"), "old");
  EXPECT_THAT(scratch.names(), ElementsAre("a"));
}

TEST(File, ANameOfGreatestLengthCanBeWritten) {
  const ScratchFolder scratch;
  const std::string name(255, 'n');
  write_file_atomically(scratch / name, std::string_view("x"));
  EXPECT_THAT(scratch.names(), ElementsAre(name));
}

TEST(File, ErrorsCarryARemedyWhereThereIsOne) {
  EXPECT_THAT(file_error("cannot write a", ENOSPC).remedy(), HasSubstr("free some space"));
}

}  // namespace
}  // namespace twrench::system
