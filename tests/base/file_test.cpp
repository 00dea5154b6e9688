#include "base/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scratch_folder.h"

namespace twrench {
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

TEST(File, DoesNotReplaceADeviceOrAFolder) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "folder");
  std::filesystem::create_symlink("/dev/null", scratch / "null");
  for (const char* name : {"folder", "null"}) {
    EXPECT_THAT(failure([&] { write_file_atomically(scratch / name, std::string_view("y")); }),
                HasSubstr("not a regular file"));
  }
}

TEST(File, OnAFullDiskLeavesTheOldOneAndNothingElse) {
  const ScratchFolder scratch;
  write_file_atomically(scratch / "a", std::string_view("old"));
  // A limit on the size of files stands for a full disk: write() comes back short, then fails.
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

TEST(File, PendingIsUnderAnotherNameInTheSameFolderAndVanishes) {
  const ScratchFolder scratch;
  {
    const PendingFile pending(scratch / "film.mp4");
    EXPECT_EQ(pending.path().parent_path(), scratch.path());
    EXPECT_THAT(scratch.names(), ElementsAre(pending.path().filename().string()));
  }
  EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(File, PendingIsGoneFromAFolderThatWasMoved) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "here");
  {
    PendingFile pending(scratch / "here/film.mp4");
    std::filesystem::rename(scratch / "here", scratch / "there");
    EXPECT_THROW(pending.commit(), FileError);
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch / "there"));
}

TEST(File, PendingTakesNobodysName) {
  const ScratchFolder scratch;
  const PendingFile one(scratch / "a");
  const PendingFile other(scratch / "a");
  EXPECT_NE(one.path(), other.path());
}

TEST(File, ANameOfGreatestLengthCanBeWritten) {
  const ScratchFolder scratch;
  const std::string name(255, 'n');
  write_file_atomically(scratch / name, std::string_view("x"));
  EXPECT_THAT(scratch.names(), ElementsAre(name));
}

TEST(File, ErrorsCarryARemedyWhereThereIsOne) {
  EXPECT_THAT(file_error("cannot write a", ENOSPC).remedy(), HasSubstr("free some space"));
  EXPECT_EQ(file_error("cannot write a", ENOSPC).code(), ExitCode::file);
}

}  // namespace
}  // namespace twrench
