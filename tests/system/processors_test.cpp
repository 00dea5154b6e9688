#include "system/processors.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <cmath>
#include <fstream>
#include <string>

#include "scratch_folder.h"

namespace twrench::system {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

double limit(const ScratchFolder& scratch) {
  return processor_limit(scratch / "groups", scratch / "mounts");
}

TEST(ProcessorLimit, IsThatOfTheGroup) {
  const ScratchFolder scratch;
  write(scratch / "groups", "0::/user/job\n");
  write(scratch / "mounts/user/job/cpu.max", "150000 100000\n");
  EXPECT_EQ(limit(scratch), 1.5);
  write(scratch / "mounts/user/job/cpu.max", "max 100000\n");
  EXPECT_EQ(limit(scratch), HUGE_VAL);
}

TEST(ProcessorLimit, IsTheLeastOfTheGroupsAround) {
  const ScratchFolder scratch;
  write(scratch / "groups", "0::/user/job\n");
  write(scratch / "mounts/user/job/cpu.max", "400000 100000\n");
  write(scratch / "mounts/user/cpu.max", "50000 20000\n");
  EXPECT_EQ(limit(scratch), 2.5);
  write(scratch / "mounts/cpu.max", "100000 100000\n");
  EXPECT_EQ(limit(scratch), 1);
}

TEST(ProcessorLimit, IsReadFromVersionOneToo) {
  const ScratchFolder scratch;
  write(scratch / "groups", "4:memory:/elsewhere\n3:cpu,cpuacct:/job\n2:cpuset:/other\n");
  write(scratch / "mounts/cpu/job/cpu.cfs_quota_us", "300000\n");
  write(scratch / "mounts/cpu/job/cpu.cfs_period_us", "100000\n");
  write(scratch / "mounts/cpu/other/cpu.cfs_quota_us", "100000\n");
  write(scratch / "mounts/cpu/other/cpu.cfs_period_us", "100000\n");
  write(scratch / "mounts/cpu/cpu.cfs_quota_us", "-1\n");
  write(scratch / "mounts/cpu/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(limit(scratch), 3);
}

// In a container, the group is the mount but keeps its name outside.
TEST(ProcessorLimit, IsFoundAtTheMountWhereTheGroupIsNot) {
  const ScratchFolder scratch;
  write(scratch / "groups", "0::/../docker/1234\n");
  write(scratch / "mounts/cpu.max", "200000 100000\n");
  EXPECT_EQ(limit(scratch), 2);
}

TEST(ProcessorLimit, IsNoneWhereNothingSetsOne) {
  const ScratchFolder scratch;
  EXPECT_EQ(limit(scratch), HUGE_VAL);
  write(scratch / "groups", "0::/\nnonsense\n1:cpu\n");
  EXPECT_EQ(limit(scratch), HUGE_VAL);
  for (const std::string text : {"", "max", "x 100000", "0 100000", "100000 0", "100000"}) {
    write(scratch / "mounts/cpu.max", text);
    EXPECT_EQ(limit(scratch), HUGE_VAL) << text;
  }
}

TEST(ProcessorCount, IsOneOnOneProcessor) {
  cpu_set_t before;
  ASSERT_EQ(::sched_getaffinity(0, sizeof before, &before), 0);
  EXPECT_GE(processor_count(), 1U);
  EXPECT_LE(processor_count(), static_cast<unsigned>(CPU_COUNT(&before)));
  cpu_set_t one;
  CPU_ZERO(&one);
  for (std::size_t i = 0; CPU_COUNT(&one) == 0; ++i) {
    if (CPU_ISSET(i, &before)) CPU_SET(i, &one);
  }
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(processor_count(), 1U);
  ::sched_setaffinity(0, sizeof before, &before);
}

}  // namespace
}  // namespace twrench::system
