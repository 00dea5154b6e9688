#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "image/png.h"
#include "image/sample_image.h"
#include "run_command.h"
#include "scratch_folder.h"
#include "system/error.h"
#include "system/file.h"

namespace twrench::image {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

enum ColourType : std::uint8_t { gray = 0, rgb = 2, indexed = 3, gray_alpha = 4, rgba = 6 };

void put_number(Bytes& png, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) {
    png[at + i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
  }
}

Bytes compressed(const Bytes& data) {
  uLongf size = compressBound(data.size());
  Bytes result(size);
  compress2(result.data(), &size, data.data(), data.size(), Z_BEST_SPEED);
  result.resize(size);
  return result;
}

/// A PNG file, chunk by chunk, with the right checksums.
class PngFile {
 public:
  PngFile(std::uint32_t width, std::uint32_t height, std::uint8_t depth, ColourType type,
          bool interlaced = false) {
    Bytes header(8);
    put_number(header, 0, width);
    put_number(header, 4, height);
    header.insert(header.end(), {depth, type, 0, 0, interlaced});
    add("IHDR", header);
  }

  PngFile& add(const std::string& type, const Bytes& data) {
    const std::size_t start = bytes_.size();
    bytes_.resize(start + 4);
    put_number(bytes_, start, static_cast<std::uint32_t>(data.size()));
    bytes_.insert(bytes_.end(), type.begin(), type.end());
    bytes_.insert(bytes_.end(), data.begin(), data.end());
    bytes_.resize(bytes_.size() + 4);
    put_number(
        bytes_, bytes_.size() - 4,
        static_cast<std::uint32_t>(crc32_z(0, &bytes_[start + 4], bytes_.size() - start - 8)));
    return *this;
  }

  /// Returns the file with these rows. Each row begins with its filter.
  Bytes with(const Bytes& rows) { return add("IDAT", compressed(rows)).end(); }

  Bytes end() { return add("IEND", {}).bytes_; }

 private:
  Bytes bytes_{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
};

std::string failure(const Bytes& bytes) {
  try {
    decode_png(bytes, "a.png");
  } catch (const system::FileError& error) {
    return error.what();
  }
  return "no error";
}

DeepImage decode_deep(const Bytes& bytes) { return decode_deep_png(bytes, "a.png"); }

TEST(PngReading, GrayBecomesRgb) {
  const ScratchFolder scratch;
  const Bytes levels{0, 50, 100, 255};
  system::write_file_atomically(scratch / "gray.raw", levels);
  run_command("ffmpeg -v error -f rawvideo -pix_fmt gray -video_size 2x2 -i '" +
              (scratch / "gray.raw").string() + "' -frames:v 1 '" +
              (scratch / "gray.png").string() + "'");
  const Image image = read_png(scratch / "gray.png");
  EXPECT_EQ(image.channels, 3);
  EXPECT_THAT(image.pixels, ElementsAre(0, 0, 0, 50, 50, 50, 100, 100, 100, 255, 255, 255));
}

TEST(PngReading, FewBitsOfGrayReachFromBlackToWhite) {
  const auto one = PngFile(3, 1, 1, gray).with({0, 0b01000000});
  EXPECT_THAT(decode_png(one, "a").pixels, ElementsAre(0, 0, 0, 255, 255, 255, 0, 0, 0));
  EXPECT_THAT(decode_deep(one).pixels, ElementsAre(0, 0, 0, 0xFFFF, 0xFFFF, 0xFFFF, 0, 0, 0));
  const auto two = PngFile(2, 1, 2, gray).with({0, 0b01110000});
  EXPECT_THAT(decode_png(two, "a").pixels, ElementsAre(85, 85, 85, 255, 255, 255));
  const auto four = PngFile(2, 1, 4, gray).with({0, 0x1F});
  EXPECT_THAT(decode_png(four, "a").pixels, ElementsAre(17, 17, 17, 255, 255, 255));
  EXPECT_THAT(decode_deep(four).pixels,
              ElementsAre(0x1111, 0x1111, 0x1111, 0xFFFF, 0xFFFF, 0xFFFF));
}

TEST(PngReading, PalettesBecomeTheirColours) {
  const Bytes palette{10, 20, 30, 40, 50, 60, 70, 80, 90};
  const Bytes row_of_depth[] = {{0, 2, 0, 1}, {0, 0x20, 0x10}, {0, 0b10000100}};
  std::uint8_t depth = 8;
  for (const Bytes& row : row_of_depth) {
    const auto opaque = PngFile(3, 1, depth, indexed).add("PLTE", palette).with(row);
    EXPECT_THAT(decode_png(opaque, "a").pixels, ElementsAre(70, 80, 90, 10, 20, 30, 40, 50, 60));
    const auto clear =
        PngFile(3, 1, depth, indexed).add("PLTE", palette).add("tRNS", {0, 128}).with(row);
    EXPECT_THAT(decode_png(clear, "a").pixels,
                ElementsAre(70, 80, 90, 255, 10, 20, 30, 0, 40, 50, 60, 128));
    depth /= 2;
  }
  const auto deep = PngFile(1, 1, 8, indexed).add("PLTE", palette).add("tRNS", {7}).with({0, 0});
  EXPECT_THAT(decode_deep(deep).pixels, ElementsAre(0x0A0A, 0x1414, 0x1E1E, 0x0707));
  EXPECT_THAT(failure(PngFile(1, 1, 8, indexed).with({0, 0})), HasSubstr("damaged"));
}

TEST(PngReading, AColourThatIsTransparentMakesAlpha) {
  const auto rgb8 = [](const Bytes& transparency) {
    return decode_png(PngFile(1, 1, 8, rgb).add("tRNS", transparency).with({0, 10, 20, 30}), "a");
  };
  EXPECT_THAT(decode_png(PngFile(1, 1, 8, rgb).with({0, 10, 20, 30}), "a").pixels,
              ElementsAre(10, 20, 30));
  EXPECT_THAT(rgb8({0, 10, 0, 20, 0, 30}).pixels, ElementsAre(10, 20, 30, 0));
  EXPECT_THAT(rgb8({0, 10, 0, 20, 0, 31}).pixels, ElementsAre(10, 20, 30, 255));
  const auto gray8 = PngFile(2, 1, 8, gray).add("tRNS", {0, 7}).with({0, 7, 8});
  EXPECT_THAT(decode_png(gray8, "a").pixels, ElementsAre(7, 7, 7, 0, 8, 8, 8, 255));
  const auto gray1 = PngFile(2, 1, 1, gray).add("tRNS", {0, 1}).with({0, 0b10000000});
  EXPECT_THAT(decode_png(gray1, "a").pixels, ElementsAre(255, 255, 255, 0, 0, 0, 0, 255));
  // All 16 bits are compared, even if only 8 are read.
  const auto gray16 = PngFile(2, 1, 16, gray).add("tRNS", {1, 2}).with({0, 1, 2, 1, 3});
  EXPECT_THAT(decode_png(gray16, "a").pixels, ElementsAre(1, 1, 1, 0, 1, 1, 1, 255));
  EXPECT_THAT(decode_deep(gray16).pixels,
              ElementsAre(0x102, 0x102, 0x102, 0, 0x103, 0x103, 0x103, 0xFFFF));
}

TEST(PngReading, AlphaIsKept) {
  const auto gray8 = PngFile(1, 1, 8, gray_alpha).with({0, 7, 9});
  EXPECT_THAT(decode_png(gray8, "a").pixels, ElementsAre(7, 7, 7, 9));
  EXPECT_THAT(decode_deep(gray8).pixels, ElementsAre(0x707, 0x707, 0x707, 0x909));
  const auto rgba16 = PngFile(1, 1, 16, rgba).with({0, 1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_THAT(decode_png(rgba16, "a").pixels, ElementsAre(1, 3, 5, 7));
  EXPECT_THAT(decode_deep(rgba16).pixels, ElementsAre(0x102, 0x304, 0x506, 0x708));
}

TEST(PngReading, DeepImagesHaveAllTheirBits) {
  const auto two = PngFile(2, 1, 16, rgb).with({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  const DeepImage deep = decode_deep(two);
  EXPECT_EQ(deep.channels, 3);
  EXPECT_THAT(deep.pixels, ElementsAre(0x102, 0x304, 0x506, 0x708, 0x90A, 0xB0C));
  EXPECT_THAT(decode_png(two, "a").pixels, ElementsAre(1, 3, 5, 7, 9, 11));
  EXPECT_THAT(decode_deep(PngFile(1, 1, 8, rgb).with({0, 1, 2, 255})).pixels,
              ElementsAre(0x101, 0x202, 0xFFFF));
}

/// The image's rows without filters, in the seven passes of Adam7 (PNG specification, 8.2).
Bytes interlaced_rows(const Image& image) {
  constexpr struct {
    int x, y, step_x, step_y;
  } passes[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  Bytes rows;
  for (const auto& pass : passes) {
    for (int y = pass.y; y < image.height && pass.x < image.width; y += pass.step_y) {
      rows.push_back(0);
      for (int x = pass.x; x < image.width; x += pass.step_x) {
        const auto pixel = image.pixels.begin() + (y * image.width + x) * image.channels;
        rows.insert(rows.end(), pixel, pixel + image.channels);
      }
    }
  }
  return rows;
}

TEST(PngReading, InterlacedImagesAreTheSame) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {5, 9}, {33, 17}}) {
    for (const int channels : {3, 4}) {
      const Image image = sample_image(width, height, channels, 5);
      const auto png =
          PngFile(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 8,
                  channels == 4 ? rgba : rgb, true)
              .with(interlaced_rows(image));
      EXPECT_EQ(decode_png(png, "a").pixels, image.pixels) << width << 'x' << height;
      EXPECT_EQ(decode_deep(png).pixels.size(), image.pixels.size());
      EXPECT_EQ(decode_deep(png).pixels.back(), image.pixels.back() * 0x101);
    }
  }
}

/// The prediction of a filter from the samples on the left, above, and above on the left (PNG
/// specification, 9.2).
int predicted(int filter, int left, int above, int corner) {
  const int estimate = left + above - corner;
  const int a = std::abs(estimate - left), b = std::abs(estimate - above),
            c = std::abs(estimate - corner);
  const int paeth = a <= b && a <= c ? left : b <= c ? above : corner;
  return std::array{0, left, above, (left + above) / 2, paeth}[static_cast<std::size_t>(filter)];
}

/// The rows of an image; the filters are applied to them in turn.
Bytes filtered_rows(const Image& image, const std::vector<int>& filters) {
  const auto size = static_cast<int>(image.row_bytes());
  const auto at = [&](int i, int y) {
    return i < 0 || y < 0 ? 0 : int{image.pixels[static_cast<std::size_t>(y * size + i)]};
  };
  Bytes rows;
  for (int y = 0; y < image.height; ++y) {
    const int filter = filters[static_cast<std::size_t>(y) % filters.size()];
    rows.push_back(static_cast<std::uint8_t>(filter));
    for (int i = 0; i < size; ++i) {
      const int left = i - image.channels;
      rows.push_back(static_cast<std::uint8_t>(
          at(i, y) - predicted(filter, at(left, y), at(i, y - 1), at(left, y - 1))));
    }
  }
  return rows;
}

// ISA-L's path undoes some of them, libspng all others.
TEST(PngReading, UndoesEveryFilter) {
  const std::vector<std::vector<int>> all{{0}, {1}, {2}, {3}, {4}, {2, 1, 0}, {1, 2, 3, 4, 0}};
  for (const std::vector<int>& filters : all) {
    for (const int channels : {3, 4}) {
      const Image image = sample_image(9, 7, channels, 5);
      const auto png =
          PngFile(9, 7, 8, channels == 4 ? rgba : rgb).with(filtered_rows(image, filters));
      EXPECT_EQ(decode_png(png, "a").pixels, image.pixels) << filters.front();
      const auto marked = PngFile(9, 7, 8, channels == 4 ? rgba : rgb)
                              .add("pHYs", {0, 0, 0, 1, 0, 0, 0, 1, 0})
                              .add("gAMA", {0, 0, 0xB1, 0x8F})
                              .with(filtered_rows(image, filters));
      EXPECT_EQ(decode_png(marked, "a").pixels, image.pixels) << filters.front();
    }
  }
}

TEST(PngReading, DataMayComeInPieces) {
  const Bytes data = compressed({0, 10, 20, 30});
  PngFile file(1, 1, 8, rgb);
  for (const std::uint8_t byte : data) file.add("IDAT", {byte}).add("IDAT", {});
  file.add("IDAT", {1, 2, 3});  // bytes after the end are ignored
  EXPECT_THAT(decode_png(file.end(), "a").pixels, ElementsAre(10, 20, 30));
}

TEST(PngReading, RefusesWhatIsNoPng) {
  EXPECT_EQ(failure({}), "cannot read a.png: it is empty, not a PNG image");
  const std::string jpeg("\xFF\xD8\xFF\xE0\0\x10JFIF", 10);
  EXPECT_EQ(failure({jpeg.begin(), jpeg.end()}),
            "cannot read a.png: it is a JPEG picture, not a PNG image");
  const std::string gif = "GIF89a and more";
  EXPECT_EQ(failure({gif.begin(), gif.end()}),
            "cannot read a.png: it is a GIF picture, not a PNG image");
  EXPECT_THAT(failure({'t', 'e', 'x', 't'}), HasSubstr("it is not a PNG image"));
  EXPECT_THAT(failure(Bytes(1000, 'x')), HasSubstr("it is not a PNG image"));
}

TEST(PngReading, RefusesWhatNoPngCanBe) {
  const Bytes row{0, 0, 0, 0};
  EXPECT_THAT(failure(PngFile(1, 1, 3, rgb).with(row)), HasSubstr("damaged (invalid bit depth)"));
  EXPECT_THAT(failure(PngFile(0, 1, 8, rgb).with(row)), HasSubstr("damaged"));
  EXPECT_THAT(failure(PngFile(1, 1, 8, ColourType{5}).with(row)), HasSubstr("damaged"));
  EXPECT_THAT(failure(PngFile(1, 1, 8, rgb).with({5, 0, 0, 0})), HasSubstr("damaged"));  // filter
  EXPECT_THAT(failure(PngFile(1, 1, 8, rgb).add("ABCD", {1}).with(row)), HasSubstr("damaged"));
  EXPECT_THAT(failure(PngFile(1, 1, 8, rgb).end()), HasSubstr("damaged"));  // no data
}

std::string chunk_failure(const Bytes& bytes) {
  try {
    require_whole_png(bytes, "a.png");
  } catch (const system::FileError& error) {
    return error.what();
  }
  return "whole";
}

TEST(PngReading, ChecksThatChunksAreWholeWithoutDecoding) {
  const auto whole = encode_png(sample_image(40, 30, 3, 3));
  EXPECT_EQ(chunk_failure(whole), "whole");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto end = whole.begin() + static_cast<std::ptrdiff_t>(length);
    EXPECT_NE(chunk_failure({whole.begin(), end}), "whole") << length;
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Bytes damaged = whole;
    damaged[i] ^= 0x10;
    EXPECT_NE(chunk_failure(damaged), "whole") << i;
  }
  EXPECT_THAT(chunk_failure(Bytes(1000, 'x')),
              HasSubstr("cannot read a.png: it is not a PNG image"));
}

TEST(PngReading, ReadsTheHeader) {
  const PngHeader header = png_header(PngFile(40, 30, 16, gray).end());
  EXPECT_EQ(header.width, 40U);
  EXPECT_EQ(header.height, 30U);
  EXPECT_EQ(header.bit_depth, 16);
  EXPECT_EQ(png_header({}).width, 0U);
}

TEST(PngReading, RefusesTruncatedFiles) {
  const auto whole = encode_png(sample_image(40, 30, 3, 3));
  // The last 12 bytes only mark the end.
  for (std::size_t length = 0; length + 12 < whole.size(); length += 7) {
    EXPECT_NE(failure({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}),
              "no error")
        << length;
  }
}

/// The peak memory of the process so far.
long peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

TEST(PngReading, ASizeThatTheFileIsTooShortForTakesNoMemory) {
  const long before = peak_mebibytes();
  for (const bool interlaced : {false, true}) {
    for (const auto& [depth, type] : {std::pair{1, gray}, {16, rgba}}) {
      const auto png = PngFile(max_image_side, max_image_side, static_cast<std::uint8_t>(depth),
                               type, interlaced)
                           .with({0, 0, 0});
      EXPECT_LT(png.size(), 100);
      EXPECT_THAT(failure(png), HasSubstr("truncated"));
    }
  }
  EXPECT_LT(peak_mebibytes() - before, 100);  // of 768 for the smaller
}

TEST(PngReading, RefusesASizeBeyondTheLargest) {
  EXPECT_THAT(failure(PngFile(max_image_side + 1, 1, 1, gray).with({0})),
              HasSubstr("too large: a side has more than 16384 pixels"));
  EXPECT_THAT(failure(PngFile(1, max_image_side + 1, 1, gray).with({0})), HasSubstr("too large"));
  const Bytes widest(1 + max_image_side / 8);
  EXPECT_EQ(decode_png(PngFile(max_image_side, 1, 1, gray).with(widest), "a").width,
            max_image_side);
}

TEST(PngReading, RefusesAChunkThatIsLongerThanTheFile) {
  auto longer = encode_png(sample_image(4, 4, 3, 4));
  longer[33] = 0x3f;  // the length of the chunk after the header: a gigabyte
  EXPECT_THAT(failure(longer), HasSubstr("cut off: at least 1056964596 bytes are missing"));
}

TEST(PngReading, SaysHowMuchOfACutFileIsMissing) {
  const auto whole = encode_png(sample_image(4, 4, 3, 4));
  const auto deep = PngFile(4, 4, 16, rgb).with(Bytes(4 * 25));
  for (const Bytes& file : {whole, deep}) {
    for (std::ptrdiff_t missing = 1; missing < std::ssize(file); ++missing) {
      const Bytes cut{file.begin(), file.end() - missing};
      EXPECT_THAT(failure(cut), HasSubstr("it is cut off: at least ")) << missing;
      if (missing > 12) continue;  // those of the last chunk
      EXPECT_THAT(failure(cut), HasSubstr(fmt::format("at least {} bytes are missing", missing)));
    }
  }
}

TEST(PngReading, RefusesAWrongChecksumOfAnyChunk) {
  const auto file = [](const std::string& changed) {
    auto png = PngFile(1, 1, 8, indexed)
                   .add("tEXt", {'a', 0, 'b'})
                   .add("PLTE", {1, 2, 3})
                   .add("tRNS", {4})
                   .add("IDAT", compressed({0, 0}))
                   .add("tIME", {7, 230, 1, 1, 0, 0, 0})
                   .end();
    const auto type = std::search(png.begin(), png.end(), changed.begin(), changed.end());
    if (type != png.end()) *(type + 4 + *(type - 1)) ^= 1;  // of its checksum
    return png;
  };
  EXPECT_EQ(failure(file("none")), "no error");
  for (const char* type : {"IHDR", "tEXt", "PLTE", "tRNS", "IDAT", "tIME", "IEND"}) {
    EXPECT_THAT(failure(file(type)), HasSubstr("the checksum of a chunk is wrong")) << type;
  }
  auto renamed = encode_png(sample_image(40, 30, 3, 3));
  renamed[37] ^= 0x20;  // IDAT becomes a chunk that decoders may ignore
  EXPECT_NE(failure(renamed), "no error");
}

/// A file of one pixel with these data: in one piece, or in two if `second`, the length of the
/// second piece, is not 0.
Bytes png_of_data(const Bytes& data, int second) {
  const auto cut = data.end() - second;
  PngFile file(1, 1, 8, rgb);
  file.add("IDAT", {data.begin(), cut});
  if (second > 0) file.add("IDAT", {cut, data.end()});
  return file.end();
}

TEST(PngReading, RefusesDataThatAreNotWhatTheirChecksumSays) {
  Bytes adler = compressed({0, 10, 20, 30});
  adler.back() ^= 1;
  for (const int second : {0, 1, 4, 5}) {
    EXPECT_THAT(failure(png_of_data(adler, second)), HasSubstr("its compressed data are damaged"));
  }
}

TEST(PngReading, RefusesDataWithoutTheirEnd) {
  const Bytes whole = compressed({0, 10, 20, 30});
  for (std::ptrdiff_t missing = 1; missing < std::ssize(whole); ++missing) {
    EXPECT_THAT(failure(png_of_data({whole.begin(), whole.end() - missing}, 0)),
                HasSubstr("its compressed data are truncated"))
        << missing;
  }
}

TEST(PngReading, RefusesMoreDataThanPixels) {
  EXPECT_THAT(failure(PngFile(200, 1, 8, rgb).with(Bytes(1'000'000))),
              HasSubstr("its compressed data are damaged"));
  EXPECT_THAT(failure(PngFile(200, 2, 8, rgb).with(Bytes(601))),
              HasSubstr("its compressed data are truncated"));
}

/// A compressed text or colour profile that inflates to that size.
Bytes metadata(const std::string& start, std::size_t size) {
  Bytes data(start.begin(), start.end());
  data.insert(data.end(), {0, 0});  // the end of the name, and deflate
  const Bytes inflated = compressed(Bytes(size, ' '));
  data.insert(data.end(), inflated.begin(), inflated.end());
  return data;
}

TEST(PngReading, MetadataAreBounded) {
  const Bytes row{0, 10, 20, 30};
  for (const char* type : {"zTXt", "iCCP"}) {
    const auto with = [&](const Bytes& data) {
      return failure(PngFile(1, 1, 8, rgb).add(type, data).with(row));
    };
    EXPECT_EQ(with(metadata("name", 100'000)), "no error") << type;
    EXPECT_EQ(with({'a', 0, 0, 1, 2, 3}), "no error") << type;  // damaged, but not used here
    EXPECT_THAT(with(metadata("name", std::size_t{65} << 20U)), HasSubstr("metadata")) << type;
  }
  PngFile many(1, 1, 8, rgb);
  for (int i = 0; i <= 1000; ++i) many.add("tEXt", {'a', 0, 'b'});
  EXPECT_THAT(failure(many.with(row)), HasSubstr("more than 64 MiB, or 1000 chunks"));
}

TEST(PngReading, NamesTheFileThatCannotBeRead) {
  try {
    read_png("/no/such.png");
    FAIL();
  } catch (const system::FileError& error) {
    EXPECT_STREQ(error.what(), "cannot read /no/such.png: No such file or directory");
  }
}

}  // namespace
}  // namespace twrench::image
