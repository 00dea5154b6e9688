#include <gtest/gtest.h>

#include "scratch_folder.h"
#include "system/error.h"
#include "system/file_lock.h"

namespace twrench::system {
namespace {

TEST(FolderLock, KeepsOthersOutUnlessBothShareIt) {
  const ScratchFolder scratch;
  {
    const FolderLock one(scratch.path(), LockKind::exclusive);
    EXPECT_THROW(FolderLock(scratch.path(), LockKind::exclusive), FileError);
    EXPECT_THROW(FolderLock(scratch.path(), LockKind::shared), FileError);
  }
  const FolderLock one(scratch.path(), LockKind::shared);
  EXPECT_NO_THROW(FolderLock(scratch.path(), LockKind::shared));
  EXPECT_THROW(FolderLock(scratch.path(), LockKind::exclusive), FileError);
  EXPECT_TRUE(scratch.names().empty());
}

}  // namespace
}  // namespace twrench::system
