#include "image/png.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/mman.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "image/sample_image.h"
#include "run_command.h"
#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::image {
namespace {

class PngRoundTrip : public ::testing::TestWithParam<std::tuple<int, int, int>> {};

TEST_P(PngRoundTrip, GivesTheSamePixels) {
  const auto [width, height, channels] = GetParam();
  const Image image = sample_image(width, height, channels, 1);
  const Image read = decode_png(encode_png(image), "a.png");
  EXPECT_EQ(read.width, width);
  EXPECT_EQ(read.height, height);
  EXPECT_EQ(read.channels, channels);
  EXPECT_EQ(read.pixels, image.pixels);
}

INSTANTIATE_TEST_SUITE_P(Sizes, PngRoundTrip,
                         ::testing::Combine(::testing::Values(1, 2, 321), ::testing::Values(1, 180),
                                            ::testing::Values(3, 4)));

bool installed(const std::string& tool) {
  return std::system(("command -v " + tool + " >/dev/null").c_str()) == 0;  // NOLINT(cert-env33-c)
}

/// A command that decodes a.png to the bytes a.raw, in the folder where both are.
struct Decoder {
  const char* tool;
  const char* rgb;
  const char* rgba;
};

class PngDecodedBy : public testing::TestWithParam<Decoder> {};

TEST_P(PngDecodedBy, IsTheImage) {
  if (!installed(GetParam().tool)) GTEST_SKIP() << GetParam().tool << " is not installed";
  for (const int channels : {3, 4}) {
    const ScratchFolder scratch;
    const Image image = sample_image(123, 45, channels, 2);
    system::write_file_atomically(scratch / "a.png", encode_png(image));
    run_command("cd '" + scratch.path().string() + "' && " +
                (channels == 3 ? GetParam().rgb : GetParam().rgba));
    EXPECT_EQ(system::read_file(scratch / "a.raw", image.pixels.size()), image.pixels);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Others, PngDecodedBy,
    testing::Values(Decoder{"ffmpeg",
                            "ffmpeg -v error -xerror -i a.png -f rawvideo -pix_fmt rgb24 a.raw",
                            "ffmpeg -v error -xerror -i a.png -f rawvideo -pix_fmt rgba a.raw"},
                    Decoder{"convert", "convert a.png -depth 8 rgb:a.raw",  // ImageMagick
                            "convert a.png -depth 8 rgba:a.raw"}),
    [](const auto& param) { return std::string(param.param.tool); });

// pngfix, libpng's tool, inflates all data and verifies every checksum.
TEST(Png, HasNothingForLibpngToMend) {
  if (!installed("pngfix")) GTEST_SKIP() << "pngfix is not installed";
  for (const int channels : {3, 4}) {
    const ScratchFolder scratch;
    system::write_file_atomically(scratch / "a.png",
                                  encode_png(sample_image(321, 200, channels, 6)));
    run_command("pngfix --quiet '" + (scratch / "a.png").string() + "'");
  }
}

TEST(Png, BytesDependOnTheImageAloneWhicheverThreadsRun) {
  std::vector<std::vector<std::uint8_t>> alone;
  for (unsigned seed = 0; seed < 4; ++seed) {
    alone.push_back(encode_png(sample_image(200, 100, 3, seed)));
  }
  std::vector<std::vector<std::uint8_t>> together(alone.size());
  std::vector<std::thread> threads;
  for (unsigned seed = 0; seed < 4; ++seed) {
    threads.emplace_back(
        [&together, seed] { together[seed] = encode_png(sample_image(200, 100, 3, seed)); });
  }
  std::for_each(threads.begin(), threads.end(), [](std::thread& thread) { thread.join(); });
  EXPECT_EQ(together, alone);
}

/// The image as PNG, encoded by a thread whose stack is at that address; empty if the address is
/// taken.
std::vector<std::uint8_t> encoded_at(std::uintptr_t address, const Image& image) {
  constexpr std::size_t size = std::size_t{1} << 20U;
  void* const stack = ::mmap(reinterpret_cast<void*>(address), size, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
  if (stack == MAP_FAILED) return {};
  struct Job {
    const Image& image;
    std::vector<std::uint8_t> png;
  } job{image, {}};
  pthread_attr_t attributes;
  ::pthread_attr_init(&attributes);
  ::pthread_attr_setstack(&attributes, stack, size);
  const auto run = [](void* argument) -> void* {
    auto& its = *static_cast<Job*>(argument);
    its.png = encode_png(its.image);
    return nullptr;
  };
  pthread_t thread{};
  EXPECT_EQ(::pthread_create(&thread, &attributes, run, &job), 0);
  ::pthread_join(thread, nullptr);
  ::pthread_attr_destroy(&attributes);
  ::munmap(stack, size);
  return job.png;
}

TEST(Png, BytesDependOnTheImageAloneWhereverItIsCompressed) {
  Image image(64, 8, 3);  // equal rows: all contain the start of the first
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(i % image.row_bytes() / 3 * 2);
  }
  const auto expected = encode_png(image);
  std::mt19937 random(1);
  int compared = 0;
  for (int i = 0; i < 12'000; ++i) {
    const std::uintptr_t address = 0x1000'0000'0000 + std::uintptr_t{random()} * 0x10'0000 / 64;
    const auto png = encoded_at(address & ~std::uintptr_t{0xffff}, image);
    if (png.empty()) continue;
    ASSERT_EQ(png, expected) << "stack at " << address;
    ++compared;
  }
  EXPECT_GT(compared, 6'000);
}

TEST(Png, HasAllRowsWhateverTheirNumber) {
  for (const int height : {1, 31, 32, 33, 200}) {
    for (const int channels : {3, 4}) {
      const Image image = sample_image(150, height, channels, 7);
      EXPECT_EQ(decode_png(encode_png(image), "a").pixels, image.pixels) << height << " rows";
    }
  }
}

TEST(Png, CompressesASmoothFrameWell) {
  Image image(640, 360, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(20 + i / image.row_bytes() / 30);
  }
  EXPECT_LT(encode_png(image).size(), image.pixels.size() / 100);
}

TEST(Png, EncodingRefusesSizesOutOfRange) {
  Image image;
  EXPECT_THROW(encode_png(image), InvalidArgument);
  image.width = max_image_side + 1;
  image.height = 1;
  EXPECT_THROW(encode_png(image), InvalidArgument);
}

}  // namespace
}  // namespace twrench::image
