#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "run_command.h"
#include "scratch_folder.h"
#include "system/error.h"
#include "system/file.h"
#include "video/error.h"
#include "video/sound_track.h"
#include "video/stub_ffmpeg.h"

namespace twrench::video {
namespace {

using testing::HasSubstr;

template <typename Integer>
std::string little_endian(Integer number) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof(number); ++i) {
    bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
  }
  return bytes;
}

/// A WAV file of one channel.
struct Wav {
  std::string samples;
  std::uint32_t rate = 8000;
  std::uint16_t bits = 16;
  std::uint16_t channels = 1;
  /// The stated sizes of the file and of its samples; the true ones if 0.
  std::uint32_t stated_file_size = 0, stated_size = 0;
  /// Whether the header states 0 for both sizes.
  bool has_no_sizes = false;

  std::string bytes() const {
    constexpr std::uint16_t integers = 1, floats = 3;
    const std::uint32_t frame = channels * bits / 8U;
    const auto size = static_cast<std::uint32_t>(samples.size());
    const auto stated = [&](std::uint32_t value, std::uint32_t true_size) {
      return little_endian(has_no_sizes ? 0U : value != 0 ? value : true_size);
    };
    return "RIFF" + stated(stated_file_size, 36 + size) + "WAVEfmt " + little_endian(16U) +
           little_endian(bits >= 32 ? floats : integers) + little_endian(channels) +
           little_endian(rate) + little_endian(rate * frame) +
           little_endian(static_cast<std::uint16_t>(frame)) + little_endian(bits) + "data" +
           stated(stated_size, size) + samples;
  }
};

/// Samples of a tone, of 16 bits each.
std::string tone(int count) {
  std::string samples;
  for (int i = 0; i < count; ++i) {
    samples += little_endian(static_cast<std::uint16_t>(std::lround(8000 * std::sin(0.3 * i))));
  }
  return samples;
}

std::string floats(const std::vector<float>& samples) {
  std::string bytes;
  for (const float sample : samples) bytes += little_endian(std::bit_cast<std::uint32_t>(sample));
  return bytes;
}

class SoundFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  /// Expects that a film can use the sound.
  static void expect_used(const std::filesystem::path& file, double length = 10) {
    EXPECT_NO_THROW(sound_length(file)) << file;
    EXPECT_NO_THROW(require_sound(file, length, {})) << file;
  }

  /// Expects a message about the file, with a remedy.
  static void expect_refused(const std::filesystem::path& file, const std::string& message) {
    try {
      require_sound(file, 10, {});
      ADD_FAILURE() << file;
    } catch (const system::FileError& error) {
      EXPECT_THAT(error.what(), HasSubstr("cannot use " + file.string() + ": " + message));
      EXPECT_FALSE(error.remedy().empty());
    }
  }

  const ScratchFolder folder_;
};

TEST_F(SoundFile, OfEachUsualFormatIsUsed) {
  const auto wav = write("a.wav", Wav{.samples = tone(8000)}.bytes());
  for (const std::string name : {"a.flac", "a.mp3", "a.opus", "a.m4a", "a.webm", "a.aiff"}) {
    const auto file = folder_ / name;
    run_command("ffmpeg -v error -i '" + wav.string() + "' '" + file.string() + "'");
    expect_used(file);
    EXPECT_NEAR(sound_length(file), 1, 0.2) << name;
  }
}

TEST_F(SoundFile, MayHaveManyFormsOfSamples) {
  expect_used(write("float.wav", Wav{.samples = floats({0, 1, -1.5F}), .bits = 32}.bytes()));
  expect_used(write("stereo.wav", Wav{.samples = tone(8000), .channels = 2}.bytes()));
  expect_used(write("surround.wav", Wav{.samples = tone(6000), .channels = 6}.bytes()));
  expect_used(write("fast.wav", Wav{.samples = tone(8000), .rate = 192'000}.bytes()));
}

// Such a file states the largest size, or none.
TEST_F(SoundFile, MayHaveBeenWrittenToAPipe) {
  Wav wav{.samples = tone(7777)};
  for (const std::uint32_t size : {0xFFFF'FFFFU, 0x7FFF'F000U, 0x8000'0000U}) {
    wav.stated_file_size = wav.stated_size = size;
    expect_used(write("streamed.wav", wav.bytes()));
  }
  wav.has_no_sizes = true;
  expect_used(write("streamed.wav", wav.bytes()));
}

// It would make files that it names inputs of the program.
TEST_F(SoundFile, ThatNamesOtherFilesIsRefused) {
  write("tone.wav", Wav{.samples = tone(8000)}.bytes());
  const std::vector<std::pair<std::string, std::string>> lists{
      {"list.txt", "ffconcat version 1.0\nfile 'tone.wav'\n"},
      {"list.wav", "ffconcat version 1.0\nfile 'tone.wav'\n"},
      {"list.ffconcat", "ffconcat version 1.0\nfile tone.wav\nduration 1\n"},
      {"list.m3u8", "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\ntone.wav\n#EXT-X-ENDLIST\n"},
      {"list.sdp",
       "v=0\no=- 0 0 IN IP4 127.0.0.1\ns=a\nc=IN IP4 127.0.0.1\nt=0 0\n"
       "m=audio 5004 RTP/AVP 0\n"},
      {"list.mpd",
       "<?xml version=\"1.0\"?><MPD xmlns=\"urn:mpeg:dash:schema:mpd:2011\">"
       "<BaseURL>tone.wav</BaseURL></MPD>"},
      {"list.pls", "[playlist]\nFile1=tone.wav\n"}};
  for (const auto& [name, text] : lists) {
    expect_refused(write(name, text), "it is ");
    EXPECT_THROW(sound_length(folder_ / name), system::FileError) << name;
  }
}

TEST_F(SoundFile, ThatIsAnotherFileIsNamed) {
  expect_refused(write("a.wav", ""), "it is empty, not a sound file");
  expect_refused(write("a.wav", "<!DOCTYPE html><html>"), "it is an HTML page, not a sound file");
  expect_refused(write("a.wav", "PK\3\4 and more"), "it is a ZIP archive, not a sound file");
  expect_refused(write("a.wav", "ffconcat version 1.0\n"),
                 "it is a list of other files, not a sound file");
  expect_refused(write("a.wav", "no sound\n"), "it is not a sound file");
  expect_refused(write("a.flac", "fLaC and more"), "it begins like a FLAC sound, but is damaged");
}

TEST_F(SoundFile, WithDamagedSamplesIsRefused) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float sample : {nan, infinity, -infinity}) {
    expect_refused(write("nan.wav", Wav{.samples = floats({0, 0, sample, 0}), .bits = 32}.bytes()),
                   "it has samples that are not numbers");
  }
  for (const float sample : {1e30F, -1e30F, 1001.F}) {
    expect_refused(write("huge.wav", Wav{.samples = floats({0, sample}), .bits = 32}.bytes()),
                   "it has a sample of 1e+");
  }
}

TEST_F(SoundFile, ThatIsCutOffIsRefused) {
  expect_refused(write("cut.wav", Wav{.samples = tone(8001), .stated_size = 30'000}.bytes()),
                 "its sound cannot be decoded: corrupt input packet");
  expect_refused(write("none.wav", Wav{}.bytes()), "it has no samples");
}

// Decoders stop at a broken frame, or leave it out.
TEST_F(SoundFile, WithABrokenPartIsRefused) {
  const auto wav = write("a.wav", Wav{.samples = tone(40'000)}.bytes());
  const std::vector<std::pair<std::string, std::string>> formats{
      {"a.flac", ""}, {"a.ogg", "-c:a flac"}, {"a.mp3", ""}, {"a.m4a", "-b:a 64k"}};
  for (const auto& [name, options] : formats) {
    const auto file = folder_ / name;
    run_command(
        fmt::format("ffmpeg -v error -i '{}' {} '{}'", wav.string(), options, file.string()));
    expect_used(file);
    const auto read = system::read_file(file, 1'000'000);
    std::string bytes(read.begin(), read.end());
    std::fill_n(bytes.begin() + std::ptrdiff_t(bytes.size() / 2), bytes.size() / 5, '\0');
    write(name, bytes);
    EXPECT_THROW(require_sound(file, 10, {}), system::FileError) << name;
  }
}

TEST_F(SoundFile, ThatCannotBeConvertedIsRefused) {
  expect_refused(write("rate.wav", Wav{.samples = tone(8000), .rate = 0x7FFF'FFFF}.bytes()),
                 "its sound cannot be decoded: ");
  expect_refused(write("channels.wav", Wav{.samples = tone(8000), .channels = 20}.bytes()),
                 "its sound cannot be decoded: ");
}

TEST_F(SoundFile, IsLookedAtAsFarAsTheFilmUsesIt) {
  std::vector<float> samples(16'000);
  samples.back() = std::numeric_limits<float>::quiet_NaN();
  const auto file = write("late.wav", Wav{.samples = floats(samples), .bits = 32}.bytes());
  expect_refused(file, "it has samples that are not numbers");
  expect_used(file, 1);
}

TEST_F(SoundFile, MessageHasNoAddressOfFfmpeg) {
  const auto file = write("a.wav", Wav{.samples = tone(8000)}.bytes());
  const StubFfmpeg stub(folder_,
                        "echo '[flac @ 0x55] [SWR @ 0x56] bad frame' >&2; "
                        "echo second >&2; exit 1");
  try {
    require_sound(file, 1, {});
    FAIL();
  } catch (const system::FileError& error) {
    EXPECT_STREQ(
        error.what(),
        ("cannot use " + file.string() + ": its sound cannot be decoded: bad frame").c_str());
  }
}

TEST_F(SoundFile, IsNotBlamedForAnFfmpegThatHangs) {
  const auto file = write("a.wav", Wav{.samples = tone(8000)}.bytes());
  const StubFfmpeg stub(folder_, "sleep 1000");
  EXPECT_THROW(require_sound(file, 0.1, {std::chrono::milliseconds(200)}), EncoderError);
}

}  // namespace
}  // namespace twrench::video
