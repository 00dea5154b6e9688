#include "system/pending_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

#include "scratch_folder.h"
#include "system/error.h"
#include "system/file.h"

namespace twrench::system {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::string whole_text(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, std::string_view text, Links links = Links::follow) {
  PendingFile file(path, links);
  file.write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  file.commit();
}

unsigned mode_of(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777U;
}

TEST(PendingFile, IsUnderAnotherNameInTheSameFolderAndVanishes) {
  const ScratchFolder scratch;
  {
    const PendingFile pending(scratch / "film.mp4");
    EXPECT_EQ(pending.path().parent_path(), scratch.path());
    EXPECT_THAT(scratch.names(), ElementsAre(pending.path().filename().string()));
  }
  EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(PendingFile, IsGoneFromAFolderThatWasMoved) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "here");
  {
    PendingFile pending(scratch / "here/film.mp4");
    fs::rename(scratch / "here", scratch / "there");
    EXPECT_THROW(pending.commit(), FileError);
  }
  EXPECT_TRUE(fs::is_empty(scratch / "there"));
}

TEST(PendingFile, TakesNobodysName) {
  const ScratchFolder scratch;
  const PendingFile one(scratch / "a");
  const PendingFile other(scratch / "a");
  EXPECT_NE(one.path(), other.path());
}

TEST(PendingFile, FollowsLinks) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "far");
  put(scratch / "far/file", "old");
  fs::create_symlink("far/file", scratch / "second");
  fs::create_symlink(scratch / "second", scratch / "first");
  put(scratch / "first", "new");
  EXPECT_TRUE(fs::is_symlink(scratch / "first"));
  EXPECT_TRUE(fs::is_symlink(scratch / "second"));
  EXPECT_EQ(whole_text(scratch / "far/file"), "new");
  fs::create_symlink("far/made", scratch / "dangling");
  put(scratch / "dangling", "made");
  EXPECT_EQ(whole_text(scratch / "far/made"), "made");
}

TEST(PendingFile, RefusesLinksInACircle) {
  const ScratchFolder scratch;
  fs::create_symlink("b", scratch / "a");
  fs::create_symlink("a", scratch / "b");
  EXPECT_THROW(PendingFile(scratch / "a"), FileError);
}

TEST(PendingFile, ReplacesALinkWhereThatIsAskedFor) {
  const ScratchFolder scratch;
  put(scratch / "precious", "untouched");
  fs::create_symlink("precious", scratch / "link");
  put(scratch / "link", "new", Links::replace);
  EXPECT_FALSE(fs::is_symlink(scratch / "link"));
  EXPECT_EQ(whole_text(scratch / "precious"), "untouched");
}

TEST(PendingFile, KeepsTheModeOfWhatItReplaces) {
  const ScratchFolder scratch;
  put(scratch / "script", "old");
  for (const unsigned mode : {0600U, 0755U, 0664U}) {
    ::chmod((scratch / "script").c_str(), mode);
    put(scratch / "script", "new");
    EXPECT_EQ(mode_of(scratch / "script"), mode);
  }
}

TEST(PendingFile, KeepsTheOwnerOfWhatItReplaces) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives files away";
  const ScratchFolder scratch;
  put(scratch / "theirs", "old");
  if (::chown((scratch / "theirs").c_str(), 1234, 2345) != 0) {
    GTEST_SKIP() << "root of this container gives no files away";
  }
  put(scratch / "theirs", "new");
  struct stat status {};
  ASSERT_EQ(::stat((scratch / "theirs").c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 1234U);
  EXPECT_EQ(status.st_gid, 2345U);
}

TEST(PendingFile, IsNotMadeWhereTheTargetMayNotBeWritten) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write all";
  const ScratchFolder scratch;
  put(scratch / "kept", "old");
  ::chmod((scratch / "kept").c_str(), 0444);
  EXPECT_THROW(PendingFile(scratch / "kept"), FileError);
}

TEST(PendingFile, WritesToADeviceAndAPipeDirectly) {
  const ScratchFolder scratch;
  fs::create_symlink("/dev/null", scratch / "null");
  put(scratch / "null", "nothing");
  EXPECT_TRUE(fs::is_symlink(scratch / "null"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  const Descriptor reader(::open((scratch / "pipe").c_str(), O_RDONLY | O_NONBLOCK));
  put(scratch / "pipe", "through");
  char text[8] = {};
  EXPECT_EQ(::read(reader.get(), text, sizeof text), 7);
  EXPECT_STREQ(text, "through");
  EXPECT_THAT(scratch.names(), UnorderedElementsAre("null", "pipe"));
}

// A shell may have opened it for appending; reopening it would start at its beginning.
TEST(PendingFile, WritesToTheDescriptorThatIsNamed) {
  const ScratchFolder scratch;
  const Descriptor log(::open((scratch / "log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600));
  ASSERT_EQ(::write(log.get(), "before ", 7), 7);
  put("/dev/fd/" + std::to_string(log.get()), "after");
  EXPECT_EQ(whole_text(scratch / "log"), "before after");
}

TEST(PendingFile, RefusesAFolderAndANameThatIsTooLong) {
  const ScratchFolder scratch;
  EXPECT_THROW(PendingFile(scratch.path()), FileError);
  EXPECT_THROW(PendingFile(scratch / std::string(256, 'n')), FileError);
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(PendingFile(scratch / "pipe", Links::replace), FileError);
  EXPECT_THAT(scratch.names(), ElementsAre("pipe"));
}

TEST(PendingFile, CanBeClaimedByOneAlone) {
  const ScratchFolder scratch;
  PendingFile one(scratch / "film.mp4");
  PendingFile second(scratch / "film.mp4");
  PendingFile other(scratch / "other.mp4");
  one.claim();
  EXPECT_THROW(second.claim(), FileError);
  EXPECT_NO_THROW(other.claim());
}

}  // namespace
}  // namespace twrench::system
