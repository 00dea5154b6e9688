#include "image/png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/mman.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "run_command.h"
#include "scratch_folder.h"

namespace twrench {
namespace {

using ::testing::HasSubstr;

/// A gradient and some noise, so that every filter and the compressor have something to do.
Image sample_image(int width, int height, int channels, unsigned seed) {
  Image image(width, height, channels);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(i / 50 + random() % 3);
  }
  return image;
}

std::string failure(const std::vector<std::uint8_t>& bytes) {
  try {
    decode_png(bytes, "a.png");
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

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
    write_file_atomically(scratch / "a.png", encode_png(image));
    run_command("cd '" + scratch.path().string() + "' && " +
                (channels == 3 ? GetParam().rgb : GetParam().rgba));
    EXPECT_EQ(read_file(scratch / "a.raw", image.pixels.size()), image.pixels);
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

// libpng's own tool inflates all there is and checks every sum.
TEST(Png, HasNothingForLibpngToMend) {
  if (!installed("pngfix")) GTEST_SKIP() << "pngfix is not installed";
  for (const int channels : {3, 4}) {
    const ScratchFolder scratch;
    write_file_atomically(scratch / "a.png", encode_png(sample_image(321, 200, channels, 6)));
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

/// The image as PNG, encoded by a thread whose stack lies at that address; empty where that is
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
  Image image(64, 8, 3);  // whose rows are alike, so that what starts the first is found in all
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

/// Frames of a film: what is the same in all, but for an area that is elsewhere in each.
struct FilmFrame {
  Image image;
  Area changed;
};

std::vector<FilmFrame> film_frames(int height, int channels) {
  std::vector<FilmFrame> frames;
  for (int k = 0; k < 6; ++k) {
    FilmFrame frame{sample_image(150, height, channels, 7), {20 * k, k * height / 7, 30, 20}};
    for (int y = frame.changed.y; y < std::min(frame.changed.y + 20, height); ++y) {
      std::fill_n(
          frame.image.pixels.begin() +
              static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * frame.image.row_bytes()) +
              frame.changed.x * channels,
          30 * channels, static_cast<std::uint8_t>(40 * k));
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

TEST(Png, OfAFilmIsTheSameBytesAsAlone) {
  for (const int height : {1, 31, 32, 33, 200}) {
    for (const int channels : {3, 4}) {
      const auto frames = film_frames(height, channels);
      std::vector<std::vector<std::uint8_t>> together(frames.size());
      StillBands bands;
      std::vector<std::jthread> threads;
      for (std::size_t k = 0; k < frames.size(); ++k) {
        threads.emplace_back([&, k] {
          together[k] = encode_png(frames[k].image, {{&frames[k].changed, 1}, bands});
        });
      }
      threads.clear();  // joins
      for (std::size_t k = 0; k < frames.size(); ++k) {
        EXPECT_EQ(together[k], encode_png(frames[k].image)) << height << " rows, frame " << k;
      }
    }
  }
}

TEST(Png, OfAFilmHasItsStillRowsFromTheFirstFrameThatHasThem) {
  StillBands bands;
  const Image first = sample_image(50, 96, 3, 1), other = sample_image(50, 96, 3, 2);
  const Area above{10, 3, 5, 28}, below{30, 32, 5, 1};  // the rows from 64 on are still in both
  encode_png(first, {{&below, 1}, bands});
  const Image read = decode_png(encode_png(other, {{&above, 1}, bands}), "a.png");
  const auto last_band = static_cast<std::ptrdiff_t>(64 * first.row_bytes());
  EXPECT_TRUE(std::equal(first.pixels.begin() + last_band, first.pixels.end(),
                         read.pixels.begin() + last_band));
  EXPECT_TRUE(
      std::equal(other.pixels.begin(), other.pixels.begin() + last_band, read.pixels.begin()));
}

TEST(Png, CompressesASmoothFrameWell) {
  Image image(640, 360, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(20 + i / image.row_bytes() / 30);
  }
  EXPECT_LT(encode_png(image).size(), image.pixels.size() / 100);
}

TEST(Png, GrayIsReadAsRgb) {
  const ScratchFolder scratch;
  const std::vector<std::uint8_t> gray{0, 50, 100, 255};
  write_file_atomically(scratch / "gray.raw", gray);
  run_command("ffmpeg -v error -f rawvideo -pix_fmt gray -video_size 2x2 -i '" +
              (scratch / "gray.raw").string() + "' -frames:v 1 '" +
              (scratch / "gray.png").string() + "'");
  const Image image = read_png(scratch / "gray.png");
  EXPECT_EQ(image.channels, 3);
  EXPECT_THAT(image.pixels,
              ::testing::ElementsAre(0, 0, 0, 50, 50, 50, 100, 100, 100, 255, 255, 255));
}

TEST(Png, EncodingRefusesSizesOutOfRange) {
  Image image;
  EXPECT_THROW(encode_png(image), UsageError);
  image.width = max_image_side + 1;
  image.height = 1;
  EXPECT_THROW(encode_png(image), UsageError);
}

TEST(Png, DecodingRefusesWhatIsNoPng) {
  EXPECT_THAT(failure({}), HasSubstr("cannot read a.png: it is no PNG image"));
  EXPECT_THAT(failure({'t', 'e', 'x', 't'}), HasSubstr("it is no PNG image"));
}

TEST(Png, DecodingRefusesTruncatedFiles) {
  const auto whole = encode_png(sample_image(40, 30, 3, 3));
  // The last 12 bytes say only that this is the end.
  for (std::size_t length = 0; length + 12 < whole.size(); length += 7) {
    EXPECT_NE(failure({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}),
              "no error")
        << length;
  }
}

TEST(Png, DecodingRefusesASizeThatWouldExhaustTheMemory) {
  auto bytes = encode_png(sample_image(4, 4, 3, 4));
  bytes[16] = 0x00;  // the width in the header, big endian: 65536 + 4
  bytes[17] = 0x01;
  EXPECT_THAT(failure(bytes), HasSubstr("too large"));
}

// What a decoder allocates before it finds them out.
TEST(Png, DecodingRefusesWhatTheFileIsTooShortFor) {
  auto larger = encode_png(sample_image(4, 4, 3, 4));
  for (const std::size_t side : {18U, 22U}) larger[side] = 0x20;  // 8196 pixels
  EXPECT_THAT(failure(larger), HasSubstr("cut short"));
  auto longer = encode_png(sample_image(4, 4, 3, 4));
  longer[33] = 0x3f;  // the length of the chunk after the header: a gigabyte
  EXPECT_THAT(failure(longer), HasSubstr("cut short"));
}

/// Where the chunk of that type has its data; its length lies 8 bytes before, its type 4.
std::size_t data_of(const std::vector<std::uint8_t>& png, const std::string& type) {
  const auto at = std::search(png.begin(), png.end(), type.begin(), type.end());
  return static_cast<std::size_t>(at - png.begin()) + 4;
}

void put_number(std::vector<std::uint8_t>& png, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i)
    png[at + i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

/// Makes the chunk's checksum right, after its data were changed.
void sum_again(std::vector<std::uint8_t>& png, const std::string& type) {
  const std::size_t data = data_of(png, type);
  std::uint32_t length = 0;
  for (std::size_t i = 0; i < 4; ++i) length = length << 8U | png[data - 8 + i];
  put_number(png, data + length, static_cast<std::uint32_t>(crc32(0, &png[data - 4], length + 4)));
}

TEST(Png, DecodingRefusesAWrongChecksumOfAnyChunk) {
  const auto whole = encode_png(sample_image(40, 30, 3, 3));
  for (const char* type : {"IHDR", "IDAT"}) {
    auto damaged = whole;
    damaged[data_of(whole, type) - 4] ^= 0x20;  // another type, which a decoder may ignore
    EXPECT_NE(failure(damaged), "no error");
    damaged = whole;
    damaged[type == std::string("IHDR") ? 16 + 13 : whole.size() - 12 - 4] ^= 1;
    EXPECT_THAT(failure(damaged), HasSubstr(std::string("checksum of its chunk ") + type));
  }
  auto end = whole;
  end.back() ^= 1;
  EXPECT_THAT(failure(end), HasSubstr("checksum of its chunk IEND"));
}

TEST(Png, DecodingRefusesDataThatAreNotWhatTheirChecksumSays) {
  const auto whole = encode_png(sample_image(40, 30, 3, 3));
  auto adler = whole;
  adler[whole.size() - 12 - 4 - 1] ^= 1;  // the last byte of the data
  sum_again(adler, "IDAT");
  EXPECT_THAT(failure(adler), HasSubstr("its compressed data are damaged"));
  auto shorter = whole;
  const std::size_t data = data_of(whole, "IDAT");
  shorter.erase(shorter.end() - 12 - 4 - 4, shorter.end() - 12 - 4);
  put_number(shorter, data - 8, static_cast<std::uint32_t>(whole.size() - 16 - data - 4));
  sum_again(shorter, "IDAT");
  EXPECT_THAT(failure(shorter), HasSubstr("its compressed data are cut short"));
}

TEST(Png, DecodingRefusesMoreDataThanPixels) {
  auto png = encode_png(Image(200, 2000, 3));  // a million bytes, by a few
  put_number(png, 20, 1);                      // of one row
  sum_again(png, "IHDR");
  EXPECT_THAT(failure(png), HasSubstr("its compressed data are damaged"));
}

/// A file of the data that a test has for one: chunks as PNG has them, compressed by zlib.
std::vector<std::uint8_t> png_of(std::uint8_t depth, std::uint8_t colour_type,
                                 const std::vector<std::uint8_t>& transparency,
                                 const std::vector<std::uint8_t>& row) {
  std::vector<std::uint8_t> png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  const auto add = [&](const std::string& type, const std::vector<std::uint8_t>& data) {
    png.resize(png.size() + 4);
    put_number(png, png.size() - 4, static_cast<std::uint32_t>(data.size()));
    png.insert(png.end(), type.begin(), type.end());
    png.insert(png.end(), data.begin(), data.end());
    png.resize(png.size() + 4);
    sum_again(png, type);
  };
  add("IHDR", {0, 0, 0, 1, 0, 0, 0, 1, depth, colour_type, 0, 0, 0});
  if (!transparency.empty()) add("tRNS", transparency);
  std::vector<std::uint8_t> filtered(1 + row.size());  // no filter, and the row
  std::ranges::copy(row, filtered.begin() + 1);
  std::vector<std::uint8_t> data(100);
  uLongf size = data.size();
  compress(data.data(), &size, filtered.data(), filtered.size());
  data.resize(size);
  add("IDAT", data);
  add("IEND", {});
  return png;
}

TEST(Png, AColourThatIsTransparentMakesAlpha) {
  const auto opaque = decode_png(png_of(8, 2, {}, {10, 20, 30}), "a.png");
  EXPECT_THAT(opaque.pixels, ::testing::ElementsAre(10, 20, 30));
  const auto hole = decode_png(png_of(8, 2, {0, 10, 0, 20, 0, 30}, {10, 20, 30}), "a.png");
  EXPECT_THAT(hole.pixels, ::testing::ElementsAre(10, 20, 30, 0));
  const auto other = decode_png(png_of(8, 2, {0, 10, 0, 20, 0, 31}, {10, 20, 30}), "a.png");
  EXPECT_THAT(other.pixels, ::testing::ElementsAre(10, 20, 30, 255));
  const auto gray = decode_png(png_of(8, 0, {0, 7}, {7}), "a.png");
  EXPECT_THAT(gray.pixels, ::testing::ElementsAre(7, 7, 7, 0));
}

TEST(Png, DeepImagesHaveAllTheirBits) {
  const ScratchFolder scratch;
  write_file_atomically(scratch / "deep.png", png_of(16, 2, {}, {1, 2, 3, 4, 5, 6}));
  EXPECT_THAT(read_deep_png(scratch / "deep.png").pixels,
              ::testing::ElementsAre(0x102, 0x304, 0x506));
  write_file_atomically(scratch / "flat.png", png_of(8, 2, {}, {1, 2, 255}));
  EXPECT_THAT(read_deep_png(scratch / "flat.png").pixels,
              ::testing::ElementsAre(0x101, 0x202, 0xFFFF));
}

TEST(Png, NamesTheFileThatCannotBeRead) {
  try {
    read_png("/no/such.png");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "cannot read /no/such.png: No such file or directory");
  }
}

}  // namespace
}  // namespace twrench
