#include "film/frames_output.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "film/error.h"
#include "scratch_folder.h"

namespace twrench::film {
namespace {

video::Manifest manifest_of(const char* scene) {
  return {.version = "0.1.0",
          .scene = {{"name", scene}},
          .renderer = "none",
          .width = 16,
          .height = 9,
          .fps = 60,
          .encoder = {},
          .range = "0",
          .frames = {}};
}

void draw(FramesOutput& output) {
  static const video::FrameRecord record{};
  video::FrameSequence& sequence = output.open();
  sequence.write(record, std::vector<std::uint8_t>{1, 2, 3});
  sequence.finish();
}

// Both runs find the folder empty; the second gets its lock only after the first has ended.
TEST(FramesOutput, LooksAgainUnderTheLock) {
  const ScratchFolder scratch;
  const auto output_of = [&](const char* scene, Reuse reuse) {
    return std::make_optional<FramesOutput>(scratch / "f", manifest_of(scene), std::vector{0},
                                            reuse);
  };
  auto second = output_of("second", Reuse::none), same = output_of("first", Reuse::none),
       careless = output_of("third", Reuse::overwrite), first = output_of("first", Reuse::none);
  draw(*first);
  first.reset();
  EXPECT_THROW(second->open(), ForeignFramesError);
  second.reset();
  EXPECT_NO_THROW(draw(*same)) << "frames of the same film may be drawn again";
  same.reset();
  EXPECT_NO_THROW(draw(*careless));
}

}  // namespace
}  // namespace twrench::film
