#include "video/encoder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <future>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "base/enumeration.h"
#include "run_command.h"
#include "scratch_folder.h"
#include "stub_ffmpeg.h"
#include "system/error.h"
#include "system/file.h"
#include "video/error.h"
#include "video/video_file.h"

namespace twrench::video {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr VideoFormat format{64, 48, 30.0};

image::Image flat(std::array<int, 3> color) {
  image::Image image(format.width, format.height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(color[i % 3]);
  }
  return image;
}

void encode(const std::filesystem::path& output, const std::vector<image::Image>& frames) {
  VideoEncoder encoder(output, format);
  for (const image::Image& frame : frames) {
    encoder.write(frame);
  }
  encoder.finish();
}

/// The frames of a video, decoded by ffmpeg.
std::vector<std::uint8_t> decode(const ScratchFolder& scratch, const std::string& film) {
  const std::string raw = (scratch / (film + ".rgb")).string();
  run_command("ffmpeg -v error -i 'file:" + (scratch / film).string() +
              "' -vf scale=flags=accurate_rnd+full_chroma_int+full_chroma_inp"
              " -f rawvideo -pix_fmt rgb24 'file:" +
              raw + "'");
  return system::read_file(raw, 100'000'000);
}

/// ffprobe's description of the video stream.
std::string probe(const ScratchFolder& scratch, const std::string& film) {
  const std::string out = (scratch / (film + ".txt")).string();
  run_command(
      "ffprobe -v error -count_frames -of default=noprint_wrappers=1 -show_entries stream '" +
      (scratch / film).string() + "' >'" + out + "'");
  const auto text = system::read_file(out, 100'000);
  return {text.begin(), text.end()};
}

/// The error that stops the encoding of many frames.
template <typename Expected>
Expected failure(const std::filesystem::path& output) {
  try {
    encode(output, std::vector<image::Image>(2000, flat({1, 2, 3})));
  } catch (const Expected& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return Expected("", "");
}

TEST(Encoder, MakesATaggedFilmOfAllFrames) {
  const ScratchFolder scratch;
  encode(scratch / "film.mp4", std::vector<image::Image>(7, flat({40, 80, 120})));
  const std::string said = probe(scratch, "film.mp4");
  for (const char* expected :
       {"codec_name=h264\n", "width=64\n", "height=48\n", "pix_fmt=yuv420p\n", "color_range=tv\n",
        "chroma_location=left\n", "color_space=bt709\n", "color_transfer=bt709\n",
        "color_primaries=bt709\n", "r_frame_rate=30/1\n", "nb_read_frames=7\n"}) {
    EXPECT_THAT(said, HasSubstr(expected));
  }
  EXPECT_EQ(decode(scratch, "film.mp4").size(), std::size_t{7} * 64 * 48 * 3);
}

TEST(Encoder, PutsTheIndexFirstSoThatPlayersStartAtOnce) {
  const ScratchFolder scratch;
  encode(scratch / "film.mp4", {flat({1, 2, 3})});
  const auto bytes = system::read_file(scratch / "film.mp4", 100'000);
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_LT(text.find("moov"), text.find("mdat"));
}

TEST(Encoder, KeepsColours) {
  // 4:2:0 at 8 bits, limited range: a step of luma is 255/219, one of chroma up to 2.1 levels.
  constexpr int tolerance = 2;
  const std::vector<std::array<int, 3>> colors{
      {0, 0, 0},     {16, 16, 16}, {128, 128, 128}, {255, 255, 255}, {255, 0, 0},
      {0, 255, 0},   {0, 0, 255},  {255, 255, 0},   {0, 255, 255},   {255, 0, 255},
      {200, 30, 60}, {12, 14, 20}, {184, 188, 196}, {30, 120, 220},  {250, 140, 10}};
  const ScratchFolder scratch;
  std::vector<image::Image> frames;
  std::transform(colors.begin(), colors.end(), std::back_inserter(frames), flat);
  encode(scratch / "film.mp4", frames);
  const auto decoded = decode(scratch, "film.mp4");
  const std::size_t frame_size = frames[0].pixels.size();
  ASSERT_EQ(decoded.size(), frame_size * frames.size());
  for (std::size_t i = 0; i < decoded.size(); ++i) {
    ASSERT_NEAR(decoded[i], frames[i / frame_size].pixels[i % frame_size], tolerance)
        << "colour " << i / frame_size << ", channel " << i % 3;
  }
}

class EncoderEffort : public ::testing::TestWithParam<Effort> {};

INSTANTIATE_TEST_SUITE_P(Each, EncoderEffort, ::testing::ValuesIn(enumerators<Effort>),
                         [](const auto& effort) {
                           return std::string(enumerator_name(effort.param));
                         });

// A dithered dark gradient of one hue, like that of the floor. Stretched five times, it must not
// show patches of other hues.
TEST_P(EncoderEffort, KeepsTheHueOfADarkGradient) {
  const VideoFormat wide{.width = 640, .height = 360, .fps = 30.0, .quality = {GetParam()}};
  image::Image image(wide.width, wide.height, 3);
  for (int i = 0; i < wide.width * wide.height; ++i) {
    const int x = i % wide.width, y = i / wide.width;
    const int gray = static_cast<int>(13 + 42.0 * y / wide.height + 0.25 * ((x + 2 * y) % 4));
    const auto at = 3 * static_cast<std::size_t>(i);
    image.pixels[at] = static_cast<std::uint8_t>(gray - 3);
    image.pixels[at + 1] = static_cast<std::uint8_t>(gray);
    image.pixels[at + 2] = static_cast<std::uint8_t>(gray + 8);
  }
  const ScratchFolder scratch;
  VideoEncoder encoder(scratch / "film.mp4", wide);
  for (int frame = 0; frame < 3; ++frame) encoder.write(image);
  encoder.finish();
  const auto decoded = decode(scratch, "film.mp4");
  int least_red = -3, most_red = -3, least_blue = 8, most_blue = 8;
  for (std::size_t i = 0; i < decoded.size(); i += 3) {
    const int red = decoded[i] - decoded[i + 1], blue = decoded[i + 2] - decoded[i + 1];
    std::tie(least_red, most_red) = std::minmax({least_red, most_red, red});
    std::tie(least_blue, most_blue) = std::minmax({least_blue, most_blue, blue});
  }
  EXPECT_LE(5 * (most_red - least_red), 10) << least_red << " to " << most_red;
  EXPECT_LE(5 * (most_blue - least_blue), 10) << least_blue << " to " << most_blue;
}

TEST(Encoder, MakesColoursNeitherDarkerNorLighter) {
  // Every 17th level of each channel, in squares of 16 pixels whose inner 8 are compared.
  constexpr int side = 1024;
  const ScratchFolder scratch;
  image::Image image(side, side, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const std::size_t square = i / 3 / side / 16 * 64 + i / 3 % side / 16;
    image.pixels[i] = static_cast<std::uint8_t>((square >> (i % 3 * 4) & 15U) * 17);
  }
  VideoEncoder encoder(scratch / "film.mp4", {side, side, 30});
  encoder.write(image);
  encoder.finish();
  const auto decoded = decode(scratch, "film.mp4");
  ASSERT_EQ(decoded.size(), image.pixels.size());
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < decoded.size(); ++i) {
    if ((i / 3 / side + 4) % 16 >= 8 && (i / 3 % side + 4) % 16 >= 8) {
      sum += decoded[i] - image.pixels[i];
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 0.0, 0.05) << "swscale without accurate_rnd has -0.1";
}

TEST(Encoder, KeepsFramesUprightAndInOrder) {
  const ScratchFolder scratch;
  std::vector<image::Image> frames;
  for (int k = 0; k < 3; ++k) {
    frames.push_back(flat({20, 20, 20}));
    // Bright: the top 16 rows, and that many columns on the left.
    for (std::size_t i = 0; i < frames.back().pixels.size(); ++i) {
      const auto x = static_cast<int>(i / 3 % 64);
      const auto y = static_cast<int>(i / 3 / 64);
      if (y < 16 || x < 16 * k) {
        frames.back().pixels[i] = 220;
      }
    }
  }
  encode(scratch / "film.mp4", frames);
  const auto decoded = decode(scratch, "film.mp4");
  ASSERT_EQ(decoded.size(), 3 * frames[0].pixels.size());
  double sum = 0;
  for (std::size_t i = 0; i < decoded.size(); ++i) {
    sum += std::abs(decoded[i] -
                    frames[i / frames[0].pixels.size()].pixels[i % frames[0].pixels.size()]);
  }
  EXPECT_LT(sum / static_cast<double>(decoded.size()), 1.0);
}

TEST(Encoder, NeedsOnlyTheAreasThatChanged) {
  const ScratchFolder scratch;
  VideoEncoder whole(scratch / "whole.mp4", format);
  VideoEncoder areas(scratch / "areas.mp4", format);
  const auto background = std::make_shared<const image::Image>();
  for (int k = 0; k < 4; ++k) {
    image::Image frame = flat({20, 60, 90});
    const image::Area area{3 + 12 * k, 5 + 7 * k, 9, 11};  // at another place in each frame
    for (int y = area.y; y < area.y + area.height; ++y) {
      for (int i = 3 * area.x; i < 3 * (area.x + area.width); ++i) {
        frame
            .pixels[static_cast<std::size_t>(y) * frame.row_bytes() + static_cast<std::size_t>(i)] =
            230;
      }
    }
    whole.write(frame);
    areas.convert({frame, {area}, true, background});
    areas.write_converted();
  }
  whole.finish();
  areas.finish();
  EXPECT_EQ(decode(scratch, "areas.mp4"), decode(scratch, "whole.mp4"));
}

TEST(Encoder, NoticesThatTheBackgroundIsAnother) {
  const ScratchFolder scratch;
  VideoEncoder whole(scratch / "whole.mp4", format);
  VideoEncoder areas(scratch / "areas.mp4", format);
  const std::array backgrounds{std::make_shared<const image::Image>(),
                               std::make_shared<const image::Image>()};
  for (const std::size_t which : {0U, 0U, 1U, 1U, 1U, 0U, 1U}) {
    const image::Image frame = flat({20, static_cast<std::uint8_t>(60 + 100 * which), 90});
    whole.write(frame);
    areas.convert({frame, {{1, 1, 2, 2}}, true, backgrounds[which]});
    areas.write_converted();
  }
  whole.finish();
  areas.finish();
  EXPECT_EQ(decode(scratch, "areas.mp4"), decode(scratch, "whole.mp4"));
}

TEST(Encoder, PassesLargeFramesOnAsTheyWere) {
  const ScratchFolder scratch;
  const std::string raw = (scratch / "raw").string();
  const StubFfmpeg slow(scratch, "part=" + raw +
                                     ".part; while dd bs=256k count=1 status=none "
                                     "of=$part && [ -s $part ]; do cat $part >>" +
                                     raw +
                                     "; sleep 0.01; done; "
                                     "for film; do :; done; exec touch \"${film#file:}\"");
  constexpr int width = 1280, height = 720;  // more than the pipe holds
  VideoEncoder encoder(scratch / "film.mp4", {width, height, 30});
  const auto background = std::make_shared<const image::Image>();
  std::vector<std::uint8_t> expected;
  for (int k = 0; k < 9; ++k) {
    image::Image frame(width, height, 3);
    const image::Area area{130 * k, 3 + 70 * k, 200, 100};
    for (int y = area.y; y < area.y + area.height; ++y) {
      std::fill_n(&frame.pixels[static_cast<std::size_t>(3 * (y * width + area.x))], 3 * area.width,
                  static_cast<std::uint8_t>(90 + 15 * k));
    }
    encoder.convert({frame, {area}, true, background});
    encoder.write_converted();
    image::Yuv420 planes(width, height);
    planes.update(frame, {0, 0, width, height});
    expected.insert(expected.end(), planes.bytes().begin(), planes.bytes().end());
  }
  EXPECT_THROW(encoder.finish(), EncoderError) << "it is no film";
  EXPECT_EQ(system::read_file(raw, 100'000'000), expected);
}

TEST(Encoder, RefusesTransparentFramesThatItsContainerCannotKeep) {
  const ScratchFolder scratch;
  for (const auto& [name, container] :
       {std::pair{"mp4", Container::mp4}, {"mkv", Container::matroska}}) {
    VideoFormat transparent = format;
    transparent.container = container;
    transparent.transparent = true;
    try {
      require_encoder(transparent);
      ADD_FAILURE() << name;
    } catch (const InvalidArgument& error) {
      EXPECT_EQ(error.quantity(), std::string("container ") + name);
      EXPECT_THAT(error.remedy(), HasSubstr(".mov or .webm"));
    }
    EXPECT_THROW(VideoEncoder(scratch / "film", transparent), InvalidArgument);
  }
  EXPECT_TRUE(scratch.names().empty());
}

TEST(Encoder, TakesFramesWithAlphaOnlyForATransparentVideo) {
  const ScratchFolder scratch;
  const image::Image rgba(format.width, format.height, 4);
  VideoEncoder opaque(scratch / "film.mp4", format);
  EXPECT_THROW(opaque.write(rgba), std::invalid_argument);
  VideoFormat transparent = format;
  transparent.container = Container::webm;
  transparent.transparent = true;
  VideoEncoder with_alpha(scratch / "film.webm", transparent);
  EXPECT_THROW(with_alpha.write(flat({1, 2, 3})), std::invalid_argument);
}

TEST(Encoder, KeepsAlphaWhereTheContainerDoes) {
  // Opaque on the left, half transparent in the middle, transparent on the right.
  image::Image image(format.width, format.height, 4);
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const auto x = i / 4 % 64;
    image.pixels[i] = 200;
    image.pixels[i + 1] = 120;
    image.pixels[i + 2] = 40;
    image.pixels[i + 3] = x < 16 ? 255 : (x < 48 ? 128 : 0);
  }
  const ScratchFolder scratch;
  for (const auto& [name, decoder] :
       {std::pair{"film.webm", "-c:v libvpx-vp9"}, {"film.mov", ""}}) {
    VideoFormat with_alpha = format;
    with_alpha.container = container_of(name);
    with_alpha.transparent = true;
    require_encoder(with_alpha);
    VideoEncoder encoder(scratch / name, with_alpha);
    for (int i = 0; i < 3; ++i) encoder.write(image);
    encoder.finish();
    const std::string raw = (scratch / "film.rgba").string();
    run_command(
        "ffmpeg -v error -y " + std::string(decoder) + " -i 'file:" + (scratch / name).string() +
        "' -vf scale=flags=accurate_rnd+full_chroma_int -f rawvideo -pix_fmt rgba 'file:" + raw +
        "'");
    const auto decoded = system::read_file(raw, 1'000'000);
    ASSERT_EQ(decoded.size(), 3 * image.pixels.size()) << name;
    for (std::size_t i = 0; i < decoded.size(); ++i) {
      const auto x = i / 4 % 64;
      if (x % 16 < 4 || x % 16 >= 12) continue;  // away from the edges
      ASSERT_NEAR(decoded[i], image.pixels[i % image.pixels.size()], 4) << name << " " << i;
    }
  }
}

TEST_P(EncoderEffort, EncodesEachOutputFormat) {
  const ScratchFolder scratch;
  for (const OutputFormat& output : output_formats()) {
    for (const bool alpha : {false, true}) {
      if (alpha && !output.keeps_alpha()) continue;
      const std::string name = (alpha ? "alpha" : "film") + output.extension();
      EXPECT_EQ(container_of(name), output.container);
      VideoFormat of{format.width, format.height, 30, output.container, alpha};
      const bool is_default = GetParam() == of.quality.effort;
      if (!is_default && !output.has_quality(alpha)) continue;
      of.quality.effort = GetParam();
      EXPECT_NO_THROW(require_encoder(of)) << name;
      VideoEncoder encoder(scratch / name, of, "twrench:1");
      image::Image image(of.width, of.height, alpha ? 4 : 3);
      for (int i = 0; i < 3; ++i) {
        std::ranges::fill(image.pixels, static_cast<std::uint8_t>(80 * (i + 1)));
        encoder.write(image);
      }
      EXPECT_NO_THROW(encoder.finish()) << name;
      if (!is_default) continue;  // the identity does not depend on the effort
      EXPECT_NO_THROW(require_replaceable(scratch / name, {"twrench:1"})) << name;
      EXPECT_THROW(require_replaceable(scratch / name, {"twrench:2"}), system::OverwriteError);
    }
  }
}

TEST(Encoder, TakesTheCodecFromTheEnding) {
  const ScratchFolder scratch;
  for (const auto& [name, codec] : {std::pair{"film.mov", "codec_name=h264\n"},
                                    {"film.mkv", "codec_name=h264\n"},
                                    {"film.webm", "codec_name=vp9\n"}}) {
    VideoFormat opaque = format;
    opaque.container = container_of(name);
    VideoEncoder encoder(scratch / name, opaque);
    encoder.write(flat({40, 80, 120}));
    encoder.finish();
    EXPECT_THAT(probe(scratch, name), HasSubstr(codec));
    EXPECT_THAT(probe(scratch, name), HasSubstr("pix_fmt=yuv420p\n"));
  }
}

TEST(Encoder, TakesRatesThatAreNotWhole) {
  const ScratchFolder scratch;
  const std::vector<std::pair<double, std::string>> rates{{59.94, "2997/50"},
                                                          {60000.0 / 1001, "60000/1001"},
                                                          {0.5, "1/2"},
                                                          {60, "60/1"},
                                                          {12.5, "25/2"},
                                                          {23.976, "2997/125"},
                                                          {0.001, "1/1000"},
                                                          {1000, "1000/1"},
                                                          {30000.0 / 1001, "30000/1001"},
                                                          {24000.0 / 1001, "24000/1001"},
                                                          {120000.0 / 1001, "120000/1001"},
                                                          {23.976023976, "24000/1001"},
                                                          {1.0 / 3, "1/3"},
                                                          {999983.0 / 33333, "999983/33333"},
                                                          {30.000000001, "30/1"},
                                                          {0.0011, "11/10000"}};
  for (const auto& [fps, fraction] : rates) {
    EXPECT_THAT(encoder_arguments({64, 48, fps}), ::testing::Contains(fraction)) << fps;
  }
  for (const double fps : {0.0, -1.0, 1e9, std::nan("")}) {
    EXPECT_THROW(encoder_arguments({64, 48, fps}), OutOfRange);
  }
}

/// A video of the standard size in the container of the file name.
VideoFormat format_for(const std::string& name, bool alpha, const Quality& quality) {
  return {.width = format.width,
          .height = format.height,
          .fps = 30,
          .container = container_of(name),
          .transparent = alpha,
          .quality = quality};
}

TEST(EncoderQuality, IsThatOfTheCodecUnlessOneIsRequested) {
  EXPECT_EQ(chosen_quality(format), (Quality{Effort::balanced, 16}));
  for (const auto& [name, most] : {std::pair{"f.mp4", 51}, {"f.mkv", 51}, {"f.webm", 63}}) {
    for (const int crf : {0, 23, most}) {
      const VideoFormat of = format_for(name, false, {Effort::small, crf});
      EXPECT_EQ(chosen_quality(of), of.quality) << name;
      EXPECT_THAT(fmt::format("{}", fmt::join(encoder_arguments(of), " ")),
                  HasSubstr(fmt::format(" -crf {} ", crf)));
    }
    for (const int crf : {-1, most + 1}) {
      EXPECT_THROW(encoder_arguments(format_for(name, false, {.crf = crf})), OutOfRange) << name;
    }
  }
}

TEST(EncoderQuality, DiffersBetweenTheEfforts) {
  for (const char* name : {"f.mp4", "f.webm"}) {
    std::set<Arguments> different;
    for (const Effort effort : enumerators<Effort>) {
      different.insert(encoder_arguments(format_for(name, false, {effort, 20})));
    }
    EXPECT_EQ(different.size(), enumerators<Effort>.size()) << name;
  }
}

TEST(EncoderQuality, IsRefusedByCodecsThatHaveNone) {
  struct Request {
    const char* name;
    bool alpha;
    Quality quality;
    const char* quantity;
    const char* others;
  };
  const Request requests[] = {
      {"f.gif", false, {.crf = 3}, "crf 3", "(.mp4, .mov, .mkv, .webm)"},
      {"f.gif", true, {Effort::balanced}, "encode balanced", "(.webm)"},
      {"f.webp", false, {Effort::small, 3}, "encode small", "(.mp4, .mov, .mkv, .webm)"},
      {"f.mov", true, {Effort::fast}, "encode fast", "(.webm)"}};
  for (const auto& [name, alpha, quality, quantity, others] : requests) {
    EXPECT_EQ(chosen_quality(format_for(name, alpha, {})), Quality{});
    try {
      require_encoder(format_for(name, alpha, quality));
      ADD_FAILURE() << name;
    } catch (const InvalidArgument& error) {
      EXPECT_EQ(error.quantity(), quantity) << name;
      EXPECT_THAT(error.remedy(), HasSubstr(others)) << name;
    }
  }
}

/// ffprobe's list of the chapters, with start, end and title of each.
std::string chapters_in(const ScratchFolder& scratch, const std::string& film) {
  const std::string out = (scratch / (film + ".chapters")).string();
  run_command(
      "ffprobe -v error -show_chapters -of csv=p=0 -show_entries "
      "chapter=start_time,end_time:chapter_tags=title '" +
      (scratch / film).string() + "' >'" + out + "'");
  const auto text = system::read_file(out, 100'000);
  return {text.begin(), text.end()};
}

TEST(Encoder, MakesChaptersInEveryContainerThatHasThem) {
  const ScratchFolder scratch;
  const std::vector<Cue> chapters{{0, 4.0 / 30, "start"}, {4.0 / 30, 0.3, "flip 1 at 2.5 s"}};
  for (const char* name : {"film.mp4", "film.mov", "film.mkv", "film.webm"}) {
    VideoFormat of = format;
    of.container = container_of(name);
    VideoEncoder encoder(scratch / name, of, "twrench:1", chapters);
    for (int i = 0; i < 9; ++i) encoder.write(flat({40, 80, 120}));
    encoder.finish();
    EXPECT_EQ(chapters_in(scratch, name),
              "0.000000,0.134000,start\n0.134000,0.300000,flip 1 at 2.5 s\n")
        << name;
    EXPECT_THAT(probe(scratch, name), HasSubstr("nb_read_frames=9\n")) << name;
  }
}

TEST(Encoder, StreamsChapters) {
  const ScratchFolder scratch;
  run_command("mkfifo '" + (scratch / "pipe.mp4").string() + "'");
  auto reader = std::async(std::launch::async, [&] {
    run_command("cat '" + (scratch / "pipe.mp4").string() + "' >'" +
                (scratch / "film.mp4").string() + "'");
  });
  VideoEncoder encoder(scratch / "pipe.mp4", format, {}, {{0, 0.1, "start"}, {0.1, 0.2, "flip"}});
  for (int i = 0; i < 6; ++i) encoder.write(flat({40, 80, 120}));
  encoder.finish();
  reader.get();
  EXPECT_THAT(chapters_in(scratch, "film.mp4"), HasSubstr("0.100000,0.200000,flip"));
}

/// A square that moves over a gradient, in a picture of an odd size. With alpha, the right third of
/// the square is faint, and the gradient is transparent.
image::Image square_at(int k, int channels) {
  image::Image image(65, 47, channels);
  for (int y = 0; y < 47; ++y) {
    for (int x = 0; x < 65; ++x) {
      auto* pixel = &image.pixels[static_cast<std::size_t>((y * 65 + x) * channels)];
      const bool inside = x >= 4 * k && x < 4 * k + 12 && y >= 10 && y < 22;
      pixel[0] = static_cast<std::uint8_t>(inside ? 230 : 3 * y);
      pixel[1] = static_cast<std::uint8_t>(inside ? 120 : 3 * y);
      pixel[2] = static_cast<std::uint8_t>(inside ? 20 : 40 + 3 * y);
      if (channels == 4) pixel[3] = inside ? (x < 4 * k + 8 ? 255 : 100) : 0;
    }
  }
  return image;
}

/// Encodes 10 frames, and returns them as Pillow decodes them: RGBA, and the durations in ms.
std::pair<std::vector<std::uint8_t>, std::string> animated(const ScratchFolder& scratch,
                                                           const std::string& name, double fps,
                                                           int channels, int width = 0) {
  VideoFormat animation{65, 47, fps, container_of(name), channels == 4};
  animation.scaled_width = width;
  require_encoder(animation);
  VideoEncoder encoder(scratch / name, animation, "twrench:1");
  for (int k = 0; k < 10; ++k) encoder.write(square_at(k, channels));
  encoder.finish();
  const std::string base = (scratch / name).string();
  // The system's Python has the packages that the set-up installs.
  run_command(
      "/usr/bin/python3 -c \"import sys; from PIL import Image, ImageSequence as S; i = "
      "Image.open('" +
      base + "'); raw = open('" + base + ".raw', 'wb'); t = open('" + base +
      ".txt', 'w'); print(i.size, i.info.get('loop'), file=t)\nfor f in S.Iterator(i): "
      "raw.write(f.convert('RGBA').tobytes()); print(f.info['duration'], end=' ', file=t)\"");
  const auto said = system::read_file(base + ".txt", 10'000);
  return {system::read_file(base + ".raw", 10'000'000), {said.begin(), said.end()}};
}

TEST(AnimatedImage, ShowsItsFramesForEver) {
  const ScratchFolder scratch;
  const std::size_t size = std::size_t{65} * 47 * 4;
  for (const auto& [name, said] :
       {std::pair{"film.gif", "(65, 47) 0\n40 40 40 40 40 40 40 40 40 40 "},
        {"film.webp", "(65, 47) 0\n40 40 40 40 40 40 40 40 40 40 "}}) {
    const auto [pixels, text] = animated(scratch, name, 25, 3);
    EXPECT_EQ(text, said) << name;
    ASSERT_EQ(pixels.size(), 10 * size) << name;
    for (int k = 0; k < 10; ++k) {
      const image::Image expected = square_at(k, 3);
      double sum = 0;
      for (std::size_t i = 0; i < size; ++i) {
        if (i % 4 == 3) continue;
        sum += std::abs(pixels[static_cast<std::size_t>(k) * size + i] -
                        expected.pixels[i / 4 * 3 + i % 4]);
      }
      EXPECT_LT(sum / static_cast<double>(size), 3) << name << " " << k;
    }
  }
}

/// The durations of the frames in ms, from the result of animated().
std::vector<int> durations_in(const std::string& said) {
  std::istringstream words(said.substr(said.find('\n')));
  return {std::istream_iterator<int>(words), {}};
}

// GIF counts hundredths of a second, and browsers show a frame for at least two.
TEST(AnimatedImage, LeavesOutFramesThatAreTooFast) {
  using ::testing::AllOf, ::testing::Each, ::testing::Ge, ::testing::Le, ::testing::SizeIs;
  const ScratchFolder scratch;
  EXPECT_THAT(durations_in(animated(scratch, "film.gif", 60, 3).second),
              AllOf(SizeIs(5), Each(AllOf(Ge(30), Le(40)))));
  EXPECT_THAT(durations_in(animated(scratch, "even.gif", 50, 3).second),
              AllOf(SizeIs(10), Each(20)));
  for (const auto& [fps, frames] : {std::pair{60.0, 10U}, {120.0, 5U}}) {
    EXPECT_THAT(durations_in(animated(scratch, "film.webp", fps, 3).second),
                AllOf(SizeIs(frames), Each(AllOf(Ge(16), Le(17)))));
  }
}

TEST(AnimatedImage, KeepsAlpha) {
  const ScratchFolder scratch;
  const std::size_t size = std::size_t{65} * 47 * 4;
  for (const char* name : {"film.gif", "film.webp"}) {
    const auto pixels = animated(scratch, name, 25, 4).first;
    ASSERT_EQ(pixels.size(), 10 * size) << name;
    for (int k = 0; k < 10; ++k) {
      const auto alpha = [&](int x) {
        return pixels[static_cast<std::size_t>(k) * size +
                      static_cast<std::size_t>(4 * (16 * 65 + x) + 3)];
      };
      EXPECT_EQ(alpha(4 * k + 6), 255) << name << " " << k;
      EXPECT_EQ(alpha((4 * k + 30) % 65), 0) << name << " " << k << ": what was there before";
    }
  }
}

TEST(AnimatedImage, IsScaled) {
  const ScratchFolder scratch;
  EXPECT_THAT(animated(scratch, "film.gif", 25, 3, 32).second, testing::StartsWith("(32, 23) 0\n"));
  EXPECT_THAT(animated(scratch, "film.webp", 25, 3, 32).second,
              testing::StartsWith("(32, 23) 0\n"));
}

TEST(AnimatedImage, SaysWhatItIsOf) {
  const ScratchFolder scratch;
  for (const char* name : {"film.gif", "film.webp"}) {
    animated(scratch, name, 25, 3);
    EXPECT_NO_THROW(require_replaceable(scratch / name, {"twrench:1"}));
    EXPECT_THROW(require_replaceable(scratch / name, {"twrench:2"}), system::OverwriteError);
    EXPECT_THAT(scratch.names(), testing::Contains(name));
  }
  for (const std::string& name : scratch.names())
    EXPECT_THAT(name, testing::Not(HasSubstr(".tmp")));
}

TEST(AnimatedImage, OfOnePictureIsThatPicture) {
  const ScratchFolder scratch;
  for (const char* name : {"film.gif", "film.webp"}) {
    VideoEncoder encoder(scratch / name, {65, 47, 25, container_of(name)}, "twrench:1");
    for (int k = 0; k < 5; ++k) encoder.write(square_at(2, 3));
    EXPECT_NO_THROW(encoder.finish()) << name;
    EXPECT_NO_THROW(require_replaceable(scratch / name, {"twrench:1"}));
    VideoEncoder single(scratch / name, {65, 47, 60, container_of(name)}, "twrench:1");
    single.write(square_at(2, 3));
    EXPECT_NO_THROW(single.finish()) << name;
  }
}

TEST(AnimatedImage, IsStreamed) {
  const ScratchFolder scratch;
  for (const char* name : {"film.gif", "film.webp"}) {
    const std::string pipe = (scratch / (std::string("pipe-") + name)).string();
    run_command("mkfifo '" + pipe + "'");
    auto reader = std::async(std::launch::async, [&] {
      run_command("cat '" + pipe + "' >'" + (scratch / name).string() + "'");
    });
    VideoEncoder encoder(pipe, {65, 47, 25, container_of(name)});
    for (int k = 0; k < 10; ++k) encoder.write(square_at(k, 3));
    encoder.finish();
    reader.get();
    EXPECT_EQ(probe_video(scratch / name).value().frames, 10) << name;
  }
}

TEST(Encoder, RefusesOddSizesBeforeAnythingIsStarted) {
  const ScratchFolder scratch;
  for (const auto& [width, height] : {std::pair{641, 480}, {640, 481}, {0, 0}}) {
    const VideoFormat odd{width, height, 30};
    EXPECT_THROW(require_encoder(odd), FilmSizeError);
    EXPECT_THROW(VideoEncoder(scratch / "film.mp4", odd), FilmSizeError);
  }
  for (const auto& [width, height] : {std::pair{641, 481}, {643, 483}, {645, 485}, {1, 1}}) {
    try {
      require_encoder({width, height, 30});
      ADD_FAILURE() << width << "x" << height;
    } catch (const FilmSizeError& error) {
      EXPECT_EQ(error.width(), width + 1);
      EXPECT_EQ(error.height(), height + 1);
    }
  }
}

TEST(Encoder, RefusesAFrameOfAnotherSize) {
  const ScratchFolder scratch;
  VideoEncoder encoder(scratch / "film.mp4", format);
  EXPECT_THROW(encoder.write(image::Image(format.width, 64, 3)), std::invalid_argument);
  EXPECT_THROW(encoder.write(image::Image(48, format.height, 3)), std::invalid_argument);
}

TEST(Encoder, TakesAnyFileName) {
  const ScratchFolder scratch;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(scratch.path());
  const std::vector<std::string> names{"-y.mp4", "http:x.mp4", "a 'b' \"c\" %d é.mp4", "noending"};
  for (const std::string& name : names) {
    encode(name, {flat({9, 9, 9})});
  }
  std::filesystem::current_path(before);
  EXPECT_THAT(scratch.names(), ::testing::UnorderedElementsAreArray(names));
}

TEST(Encoder, LeavesNothingWhenItIsNotFinished) {
  const ScratchFolder scratch;
  {
    VideoEncoder encoder(scratch / "film.mp4", format);
    encoder.write(flat({1, 2, 3}));
  }
  EXPECT_THAT(scratch.names(), ::testing::IsEmpty());
}

TEST(Encoder, ThatIsThereIsAccepted) { EXPECT_NO_THROW(require_encoder(format)); }

TEST(Encoder, MissingIsToldWithTheRemedy) {
  const ScratchFolder scratch;
  const PathSetting nothing(scratch.path().string());
  try {
    require_encoder(format);
    FAIL();
  } catch (const EncoderError& error) {
    EXPECT_STREQ(error.what(), "cannot start ffmpeg: it was not found in PATH");
    EXPECT_THAT(error.remedy(), HasSubstr("apt-get install ffmpeg"));
  }
  EXPECT_THAT(failure<EncoderError>(scratch / "film.mp4").what(), HasSubstr("cannot start ffmpeg"));
  EXPECT_THAT(scratch.names(), ::testing::IsEmpty());
}

TEST(Encoder, ThatCannotDoItIsToldBeforeTheFirstFrame) {
  const ScratchFolder scratch;
  const StubFfmpeg stub(scratch, "echo \"Unknown encoder 'libx264'\" >&2; exit 1");
  try {
    require_encoder(format);
    FAIL();
  } catch (const EncoderError& error) {
    EXPECT_STREQ(error.what(),
                 "ffmpeg cannot encode the video: ffmpeg ended with exit status 1: "
                 "Unknown encoder 'libx264'");
    EXPECT_THAT(error.remedy(), HasSubstr("libx264"));
  }
}

TEST(Encoder, ThatDiesAtOnceIsToldWithItsWordsAndItsCommand) {
  const ScratchFolder scratch;
  const StubFfmpeg stub(scratch, "echo 'first line' >&2; echo 'last line' >&2; exit 3");
  const auto error = failure<EncoderError>(scratch / "film.mp4");
  EXPECT_EQ(error.what(), "cannot encode " + (scratch / "film.mp4").string() +
                              ": ffmpeg ended with exit status 3: first line; last line");
  EXPECT_THAT(error.remedy(), HasSubstr("ffmpeg -hide_banner"));
  EXPECT_THAT(error.remedy(), HasSubstr("-c:v libx264"));
  EXPECT_THAT(scratch.names(), ElementsAre("bin"));
}

TEST(Encoder, ThatDiesMidwayIsTold) {
  const ScratchFolder scratch;
  system::write_file_atomically(scratch / "film.mp4", std::string_view("the film before"));
  const StubFfmpeg stub(scratch, "head -c 1000000 >/dev/null; kill -KILL $$");
  EXPECT_THAT(failure<EncoderError>(scratch / "film.mp4").what(),
              HasSubstr("exit status 137: it printed no message"));
  EXPECT_THAT(scratch.names(), ::testing::UnorderedElementsAre("bin", "film.mp4"));
  EXPECT_EQ(system::read_file(scratch / "film.mp4", 100).size(), 15U);
}

TEST(Encoder, ThatEndsTooEarlyIsToldAlthoughItReportsSuccess) {
  const ScratchFolder scratch;
  const StubFfmpeg stub(scratch, "head -c 1000 >/dev/null; exit 0");
  EXPECT_THAT(failure<EncoderError>(scratch / "film.mp4").what(),
              HasSubstr("ffmpeg ended before it had read all of its input"));
}

TEST(Encoder, ThatHangsIsStoppedAndTold) {
  constexpr system::Patience patience{std::chrono::milliseconds(200)};
  const ScratchFolder scratch;
  for (const char* script :
       {"sleep 1000", "cat >/dev/null; sleep 1000", "while :; do echo busy >&2; done",
        "cat >/dev/null; while :; do echo busy >&2; done"}) {
    const StubFfmpeg stub(scratch, script);
    try {
      VideoEncoder encoder(scratch / "film.mp4", format, {}, {}, patience);
      for (int i = 0; i < 500; ++i) encoder.write(flat({1, 2, 3}));
      encoder.finish();
      FAIL();
    } catch (const EncoderError& error) {
      EXPECT_THAT(error.what(), HasSubstr("ffmpeg made no progress for 0.2 s and was killed"));
    }
    EXPECT_THAT(scratch.names(), ElementsAre("bin"));
    try {
      require_encoder(format, patience);
      FAIL();
    } catch (const EncoderError& error) {
      EXPECT_THAT(error.what(), HasSubstr("ffmpeg made no progress for 0.2 s and was killed"));
      EXPECT_THAT(error.remedy(), HasSubstr("the command was: ffmpeg -hide_banner"));
    }
  }
}

TEST(Encoder, ThatFailsAtTheEndIsTold) {
  const ScratchFolder scratch;
  const StubFfmpeg stub(scratch, "cat >/dev/null; echo 'no trailer' >&2; exit 1");
  EXPECT_THAT(failure<EncoderError>(scratch / "film.mp4").what(), HasSubstr("no trailer"));
  EXPECT_THAT(scratch.names(), ElementsAre("bin"));
}

TEST(Encoder, ThatSaysItIsDoneIsNotBelieved) {
  const ScratchFolder scratch;
  system::write_file_atomically(scratch / "film.mp4", std::string_view("the film before"));
  const std::string last = "for film; do :; done; film=${film#file:}; ";
  const std::string real = "$(PATH=${PATH#*:} command -v ffmpeg)";
  const std::pair<std::string, const char*> stubs[] = {
      {last + "cat >/dev/null; : >\"$film\"", "its output is not a video"},
      {"head -c 18432 | " + real + " \"$@\"", "a video of 4 frames"}};
  for (const auto& [script, message] : stubs) {
    const StubFfmpeg stub(scratch, script);
    VideoEncoder encoder(scratch / "film.mp4", format);
    for (int i = 0; i < 5; ++i) encoder.write(flat({1, 2, 3}));
    try {
      encoder.finish();
      FAIL();
    } catch (const EncoderError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
    EXPECT_EQ(system::read_file(scratch / "film.mp4", 100).size(), 15U);
  }
}

TEST(Encoder, IsKeptFromAFilmThatAnotherWrites) {
  const ScratchFolder scratch;
  const VideoEncoder one(scratch / "film.mp4", format);
  const VideoEncoder other(scratch / "other.mp4", format);
  EXPECT_THROW(VideoEncoder(scratch / "film.mp4", format), system::FileError);
}

TEST(Encoder, StreamsToADevice) {
  const ScratchFolder scratch;
  run_command("mkfifo '" + (scratch / "pipe.mp4").string() + "'");
  auto reader = std::async(std::launch::async, [&] {
    run_command("cat '" + (scratch / "pipe.mp4").string() + "' >'" +
                (scratch / "film.mp4").string() + "'");
  });
  encode(scratch / "pipe.mp4", std::vector<image::Image>(7, flat({40, 80, 120})));
  reader.get();
  EXPECT_THAT(probe(scratch, "film.mp4"), HasSubstr("nb_read_frames=7\n"));
}

TEST(Encoder, AFullDiskIsAFilesFailure) {
  const ScratchFolder scratch;
  const StubFfmpeg stub(scratch,
                        "echo 'av_interleaved_write_frame(): No space left on device' >&2"
                        "; exit 1");
  EXPECT_THAT(failure<system::FileError>(scratch / "film.mp4").remedy(),
              HasSubstr("free some space"));
}

TEST(Encoder, NeedsAFolderForTheFilm) {
  const ScratchFolder scratch;
  EXPECT_THROW(VideoEncoder(scratch / "no/film.mp4", format), system::FileError);
  EXPECT_THROW(VideoEncoder(scratch.path(), format), system::FileError);
}

}  // namespace
}  // namespace twrench::video
