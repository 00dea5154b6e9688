// The sound of films, decoded by ffmpeg, with the real program.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "cli/twrench.h"
#include "run_command.h"

namespace twrench {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int rate = 48'000;
constexpr double fps = 6;
/// The largest difference between lengths that should be equal, in s.
constexpr double length_tolerance = 1.0 / 30;

const std::string sound_film = "render --size 32x32 --fps 6 --bare --progress none --no-frames ";
/// A body that flips 15.3 s after its start, and then every 30.7 s.
const std::string flipping = "--inertia 3,5,9 --omega 0.001,1,0 ";

/// The output of a command with a file of the folder as %.
std::string output_of(const ScratchFolder& folder, std::string command, const std::string& file) {
  command.replace(command.find('%'), 1, "'" + (folder / file).string() + "'");
  const std::string out = (folder / "tool.out").string();
  run_command(command + " >'" + out + "'");
  return text_of(out);
}

/// The left samples in a file of 16 bits, from -1 to 1.
std::vector<double> left_samples(const std::string& bytes) {
  std::vector<std::int16_t> words(bytes.size() / 2);
  std::memcpy(words.data(), bytes.data(), 2 * words.size());
  std::vector<double> left;
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) left.push_back(words[i] / 32768.0);
  return left;
}

/// The left samples of the sound of a video, from -1 to 1.
std::vector<double> samples_in(const ScratchFolder& folder, const std::string& video) {
  return left_samples(
      output_of(folder, "ffmpeg -v error -i % -map 0:a -f s16le -ar 48000 -", video));
}

/// The root of the mean square of the samples from `begin` to `end`, in s.
double level(const std::vector<double>& samples, double begin, double end) {
  double sum = 0;
  const auto first = std::size_t(begin * rate), last = std::size_t(end * rate);
  for (std::size_t i = first; i < last; ++i) sum += samples.at(i) * samples.at(i);
  return std::sqrt(sum / double(last - first));
}

/// The left samples, the integrated loudness in LUFS, and the largest true peak in dB, by ffmpeg's
/// meter.
struct Loudness {
  std::vector<double> samples;
  double integrated = 0, peak = -100;
};
Loudness loudness_of(const ScratchFolder& folder, const std::string& video) {
  const std::filesystem::path raw = folder / "tool.raw";
  std::istringstream lines(output_of(folder,
                                     "ffmpeg -v error -y -i % -map 0:a -f s16le -ar 48000 '" +
                                         raw.string() +
                                         "' -map 0:a -af ebur128=metadata=1:peak=true,"
                                         "ametadata=mode=print:file=- -f null -",
                                     video));
  Loudness found{.samples = left_samples(text_of(raw))};
  for (std::string line; std::getline(lines, line);) {
    const auto value = [&] { return std::stod(line.substr(line.find('=') + 1)); };
    if (line.starts_with("lavfi.r128.I=")) found.integrated = value();
    if (line.starts_with("lavfi.r128.true_peak=")) found.peak = 20 * std::log10(value());
  }
  return found;
}

/// The length of the sound in s: that of its track, or of the file if the track states none.
double length_of(const ScratchFolder& folder, const std::string& video) {
  std::istringstream lengths(
      output_of(folder,
                "ffprobe -v error -of csv=p=0 -select_streams a -show_entries "
                "stream=duration:format=duration %",
                video));
  std::string track, file;
  std::getline(lengths, track);
  std::getline(lengths, file);
  return std::stod(track.starts_with("N/A") ? file : track);
}

/// The times in s at which a low tone starts: where the spectrum at 75 Hz rises most from one
/// twentieth of a second to the next.
std::vector<double> accents_in(const std::vector<double>& samples) {
  constexpr std::size_t hop = rate / 1000, window = 50;
  std::vector<std::complex<double>> sums{0};  // of the first n ms
  for (std::size_t n = 0; n + 1 <= samples.size() / hop; ++n) {
    std::complex<double> sum = sums.back();
    for (std::size_t i = n * hop; i < (n + 1) * hop; ++i) {
      sum += samples[i] * std::polar(1.0, -2 * std::numbers::pi * 75 * double(i) / rate);
    }
    sums.push_back(sum);
  }
  std::vector<double> rises(sums.size());
  for (std::size_t n = window; n + window < sums.size(); ++n) {
    rises[n] = std::abs(sums[n + window] - sums[n]) - std::abs(sums[n] - sums[n - window]);
  }
  const double most = *std::ranges::max_element(rises);
  std::vector<double> found;
  for (std::size_t n = window; n + window < rises.size(); ++n) {
    const auto around = rises.begin() + std::ptrdiff_t(n);
    if (rises[n] > 0.5 * most && rises[n] == *std::max_element(around - 50, around + 50)) {
      found.push_back(double(n) / 1000);
    }
  }
  return found;
}

/// The times of the flips in s of motion.
std::vector<double> exact_flips(double end) {
  const auto flips =
      *motion::ExactMotion(motion::FreeBody(Eigen::Vector3d(3, 5, 9).asDiagonal(), {0.001, 1, 0}))
           .flips();
  std::vector<double> times;
  for (double t = flips.first; t < end; t += flips.interval) times.push_back(t);
  return times;
}

void expect_accents(const std::vector<double>& samples, const std::vector<double>& flips) {
  const std::vector<double> accents = accents_in(samples);
  ASSERT_EQ(accents.size(), flips.size()) << testing::PrintToString(accents);
  for (std::size_t i = 0; i < flips.size(); ++i) EXPECT_NEAR(accents[i], flips[i], 0.02);
}

void expect_sound_of_motion(const ScratchFolder& folder, const std::string& video, double length,
                            const std::vector<double>& flips) {
  const Loudness loudness = loudness_of(folder, video);
  EXPECT_NEAR(loudness.integrated, -16, 1) << video;
  EXPECT_LE(loudness.peak, -1) << video;
  EXPECT_NEAR(length_of(folder, video), length, length_tolerance) << video;
  expect_accents(loudness.samples, flips);
}

TEST(Sound, OfAMotionHasAnAccentAtEachFlip) {
  const ScratchFolder folder;
  // 10.17 s are no whole number of packets.
  for (const char* video : {"film.mp4", "film.mov", "film.mkv", "film.webm"}) {
    const Outcome run = run_twrench(
        folder, sound_film + flipping + "--duration 81.33 --speed 8 --sound motion -o " + video);
    ASSERT_EQ(run.code, 0) << run.err;
    std::vector<double> flips = exact_flips(81.3);
    for (double& flip : flips) flip /= 8;
    EXPECT_EQ(flips.size(), 3U);
    expect_sound_of_motion(folder, video, 61 / fps, flips);
  }
}

TEST(Sound, OfAMotionFollowsShotsAndSlowMotion) {
  const ScratchFolder folder;
  std::ofstream(folder / "scene.toml")
      << "[body]\nmoments = [3, 5, 9]\n[motion]\nomega = [0.001, 1, 0]\n"
         "[film]\nsound = \"motion\"\n"
         "[[shot]]\nlength = 4\nspeed = 5\n"
         "[[shot]]\nlength = 3\nstart = 15\nspeed = [[0, 0.1], [3, 0.4]]\n"
         "[[shot]]\nlength = 3\nstart = 10\nspeed = 2\nfade = 0.5\n"
         "[[shot]]\nlength = 1\nspeed = 0\n";
  ASSERT_EQ(run_twrench(folder, sound_film + "scene.toml -o film.webm").code, 0);
  // The first shot shows the motion from 0 to 20 s; the second from 15 s in slow motion, at 15 s +
  // 0.1 t + 0.05 t^2; the third from 10 to 16 s.
  const double flip = exact_flips(20).at(0);
  const double slow = -1 + std::sqrt(1 + 20 * (flip - 15));
  EXPECT_GT(slow, 1);
  expect_sound_of_motion(folder, "film.webm", 11, {flip / 5, 4 + slow, 7 + (flip - 10) / 2});
}

TEST(Sound, OfAPartIsThatOfThePart) {
  const ScratchFolder folder;
  const std::string film = sound_film + flipping + "--duration 80 --speed 4 --sound motion ";
  ASSERT_EQ(run_twrench(folder, film + "--frames 60-77 -o part.mp4").code, 0);
  EXPECT_NEAR(length_of(folder, "part.mp4"), 3, length_tolerance);
  expect_accents(samples_in(folder, "part.mp4"), {exact_flips(80)[1] / 4 - 10});
  const Outcome gaps = run_twrench(folder, film + "--frames 0-9:3 -o gaps.mp4");
  EXPECT_EQ(gaps.code, 2);
  EXPECT_THAT(gaps.err, HasSubstr("so its frames must follow each other"));
}

TEST(Sound, IsStreamed) {
  const ScratchFolder folder;
  ASSERT_EQ(run_shell(folder, "\"$TWRENCH\" " + sound_film + flipping +
                                  "--duration 80 --speed 8 --sound motion -o - >film.mp4")
                .code,
            0);
  std::vector<double> flips = exact_flips(80);
  for (double& flip : flips) flip /= 8;
  EXPECT_EQ(flips.size(), 3U);
  expect_sound_of_motion(folder, "film.mp4", 10, flips);
}

TEST(Sound, IsPossibleForEveryFilm) {
  const ScratchFolder folder;
  for (const std::string film : {"--duration 0.1 --speed 1 ", "sphere --duration 1 --speed 1 ",
                                 "stable-y --duration 1e-6 --speed 1e-6 --omega 0,6e6,0 ",
                                 "--omega 0,0,0 --duration 1 --speed 1 "}) {
    const Outcome run = run_twrench(folder,
                                    "render --size 32x32 --fps 30 --bare --progress none "
                                    "--no-frames --sound motion -o film.mp4 --overwrite " +
                                        film);
    EXPECT_EQ(run.code, 0) << film << run.err;
    EXPECT_FALSE(samples_in(folder, "film.mp4").empty());
  }
}

/// Writes a tone of that many seconds.
void write_tone(const ScratchFolder& folder, const std::string& file, double seconds) {
  run_command(fmt::format("ffmpeg -v error -f lavfi -i sine=f=1000:d={} '{}'", seconds,
                          (folder / file).string()));
}

TEST(Audio, IsTrimmedWithAFadeOrFollowedBySilence) {
  const ScratchFolder folder;
  write_tone(folder, "long.mp3", 9);
  write_tone(folder, "short.wav", 1.5);
  const std::string film = sound_film + "--duration 4 --speed 1 ";
  for (const std::string video : {"film.mp4", "film.mov", "film.mkv", "film.webm"}) {
    ASSERT_EQ(run_twrench(folder, film + "--audio long.mp3 -o " + video).code, 0);
    const std::vector<double> samples = samples_in(folder, video);
    EXPECT_NEAR(length_of(folder, video), 4, length_tolerance);
    const double usual = level(samples, 1, 3);
    EXPECT_GT(usual, 0.05);
    EXPECT_NEAR(level(samples, 3.3, 3.45), usual, 0.1 * usual);
    EXPECT_LT(level(samples, 3.9, 4), 0.2 * usual);
  }
  ASSERT_EQ(run_twrench(folder, film + "--audio short.wav -o short.mp4").code, 0);
  const std::vector<double> samples = samples_in(folder, "short.mp4");
  EXPECT_NEAR(length_of(folder, "short.mp4"), 4, length_tolerance);
  EXPECT_NEAR(level(samples, 1.35, 1.45), level(samples, 0.5, 1), 0.1 * level(samples, 0.5, 1));
  EXPECT_LT(level(samples, 1.6, 4), 1e-3);
  // Another sound makes another video.
  EXPECT_THAT(run_twrench(folder, film + "--audio long.mp3 -o short.mp4").err,
              HasSubstr("different video"));
}

TEST(Audio, IsLouderThanTheMotion) {
  const ScratchFolder folder;
  write_tone(folder, "tone.wav", 1);
  ASSERT_EQ(run_twrench(folder, sound_film + "--duration 24 --sound motion -o alone.mp4").code, 0);
  ASSERT_EQ(
      run_twrench(folder, sound_film + "--duration 24 --sound motion --audio tone.wav -o mixed.mp4")
          .code,
      0);
  const std::vector<double> alone = samples_in(folder, "alone.mp4"),
                            mixed = samples_in(folder, "mixed.mp4");
  EXPECT_NEAR(20 * std::log10(level(mixed, 2, 3.5) / level(alone, 2, 3.5)), -12, 0.5);
  EXPECT_GT(level(mixed, 0.2, 0.8), level(mixed, 2, 3.5));
}

TEST(Audio, DoesNotClipWithTheMotion) {
  const ScratchFolder folder;
  run_command("ffmpeg -v error -f lavfi -i 'aevalsrc=0.99*sin(6000*t):d=4' '" +
              (folder / "loud.wav").string() + "'");
  for (const std::string video : {"loud.mp4", "loud.webm"}) {
    ASSERT_EQ(run_twrench(folder,
                          sound_film + "--duration 24 --sound motion --audio loud.wav -o " + video)
                  .code,
              0);
    EXPECT_LE(loudness_of(folder, video).peak, -1);
  }
}

TEST(Audio, ThatCannotBeUsedIsReportedBeforeTheFirstFrame) {
  const ScratchFolder folder;
  write_tone(folder, "tone.wav", 4);
  run_command("ffmpeg -v error -f lavfi -i color=s=32x32:d=1 '" + (folder / "mute.mp4").string() +
              "'");
  std::ofstream(folder / "empty.wav").flush();
  std::ofstream(folder / "text.wav") << "no sound\n";
  std::ofstream(folder / "list.wav") << "ffconcat version 1.0\nfile 'tone.wav'\n";
  run_command(
      "ffmpeg -v error -f lavfi -i 'aevalsrc=if(gt(t\\,0.5)\\,0/0\\,0):d=1' -c:a pcm_f32le '" +
      (folder / "nan.wav").string() + "'");
  std::filesystem::create_directory(folder / "folder");
  const auto expect = [&](const std::string& options, int code, const std::string& message) {
    const Outcome run = run_twrench(folder, sound_film + "--duration 4 " + options);
    EXPECT_EQ(run.code, code) << options;
    EXPECT_THAT(run.err, HasSubstr(message)) << options;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 2) << run.err;
    EXPECT_THAT(run.err, Not(HasSubstr("frames"))) << options;
    EXPECT_FALSE(std::filesystem::exists(folder / "film.mp4"));
  };
  expect("--audio none.wav -o film.mp4", 5, "cannot read none.wav: No such file");
  expect("--audio folder -o film.mp4", 5, "cannot read folder: it is not a regular file");
  expect("--audio empty.wav -o film.mp4", 5, "cannot use empty.wav: it is empty, not a sound file");
  expect("--audio text.wav -o film.mp4", 5, "cannot use text.wav: it is not a sound file");
  expect("--audio list.wav -o film.mp4", 5,
         "cannot use list.wav: it is a list of other files, not a sound file");
  for (const char* more : {"", " --sound motion"}) {
    expect(std::string("--audio nan.wav -o film.mp4") + more, 5,
           "cannot use nan.wav: it has samples that are not numbers");
  }
  expect("--audio mute.mp4 -o film.mp4", 5, "cannot use mute.mp4: it has no sound");
  expect("--audio tone.wav -o film.gif", 2, "audio: GIF has no sound");
  expect("--sound motion -o film.webp", 2, "sound: WebP has no sound");
  expect("--sound loud -o film.mp4", 2, "--sound: unknown name 'loud'");
  const std::string before = text_of(folder / "mute.mp4");
  expect("--audio mute.mp4 -o mute.mp4 --overwrite", 2, "mute.mp4: it is an input of this command");
  EXPECT_EQ(text_of(folder / "mute.mp4"), before);
  for (const char* options : {"--audio tone.wav", "--sound motion"}) {
    const Outcome run =
        run_twrench(folder, std::string("render --no-video --frames-dir out ") + options);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("no sound is written"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

TEST(Audio, NeedsAnFfmpegWithItsEncoder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "bin");
  std::ofstream(folder / "bin/ffmpeg")
      << "#!/bin/sh\ncase \"$*\" in *'-c:a aac'*|*'-c:a libopus'*)\n"
         "  echo 'Unknown encoder' >&2; exit 1;;\nesac\nexec /usr/bin/env PATH=\"${PATH#*:}\" "
         "ffmpeg \"$@\"\n";
  std::filesystem::permissions(folder / "bin/ffmpeg", std::filesystem::perms::owner_all);
  for (const auto& [video, encoder] : {std::pair{"film.mp4", "aac"}, {"film.webm", "libopus"}}) {
    const Outcome run =
        run_twrench(folder, sound_film + "--duration 4 --sound motion -o " + std::string(video),
                    "PATH=\"$PWD/bin:$PATH\" ");
    EXPECT_EQ(run.code, 4) << run.err;
    EXPECT_THAT(run.err, HasSubstr("Unknown encoder"));
    EXPECT_THAT(run.err, HasSubstr(std::string("an ffmpeg that has ") + encoder));
    EXPECT_FALSE(std::filesystem::exists(folder / video));
  }
}

/// Writes a scene of three shots of 2 s. The second has a narration.
void write_story(const ScratchFolder& folder, const std::string& narration) {
  std::ofstream(folder / "story/scene.toml")
      << "[body]\nmoments = [3, 5, 9]\n[motion]\nomega = [0.01, 1, 0]\n"
         "[[shot]]\nlength = 2\nspeed = 1\n[[shot]]\nlength = 2\nspeed = 1\nnarration = \"" +
             narration + "\"\n[[shot]]\nlength = 2\nspeed = 1\n";
}

TEST(Narration, StartsWithItsShot) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "story");
  write_tone(folder, "story/1.wav", 1.5);
  write_tone(folder, "story/2.wav", 3);
  write_tone(folder, "story/3.wav", 4.1);
  write_story(folder, "1.wav");
  const Outcome run = run_twrench(folder, sound_film + "story/scene.toml -o film.mp4");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, Not(HasSubstr("narration")));
  const std::vector<double> samples = samples_in(folder, "film.mp4");
  const double usual = level(samples, 2.2, 3.4);
  EXPECT_GT(usual, 0.05);
  EXPECT_LT(level(samples, 0.1, 1.98), 0.01 * usual);
  EXPECT_NEAR(level(samples, 2.02, 2.2), usual, 0.1 * usual);
  EXPECT_NEAR(level(samples, 3.4, 3.48), usual, 0.1 * usual);
  EXPECT_LT(level(samples, 3.55, 6), 0.01 * usual);

  write_story(folder, "2.wav");
  const Outcome longer = run_twrench(folder, sound_film + "story/scene.toml -o longer.mp4");
  EXPECT_EQ(longer.code, 0);
  EXPECT_THAT(longer.err, HasSubstr("warning: story/scene.toml:8: shot[1].narration: 2.wav lasts "
                                    "3.00 s, but the shot 2.00 s"));
  write_story(folder, "3.wav");
  const Outcome wrong = run_twrench(folder, sound_film + "story/scene.toml -o wrong.mp4");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("shot[1].narration: 3.wav lasts 4.10 s, but the film ends 4.00 "
                                   "s after its start"));
  std::ofstream(folder / "story/list.wav") << "ffconcat version 1.0\nfile '1.wav'\n";
  for (const char* unusable : {"none.wav", "list.wav"}) {
    write_story(folder, unusable);
    const Outcome refused = run_twrench(folder, sound_film + "story/scene.toml -o wrong.mp4");
    EXPECT_EQ(refused.code, 5);
    EXPECT_THAT(refused.err, HasSubstr("error: story/scene.toml:8: shot[1].narration: cannot"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "wrong.mp4"));
  // An animated image has none.
  EXPECT_EQ(run_twrench(folder, sound_film + "story/scene.toml -o story.gif").code, 0);
}

TEST(Sound, IsAddedToAFilmByItsResumption) {
  const ScratchFolder folder;
  write_tone(folder, "tone.wav", 4);
  const std::string film =
      "render --size 32x32 --fps 6 --progress none --duration 24 -o film.mp4 --frames-dir f ";
  ASSERT_EQ(run_twrench(folder, film).code, 0);
  const auto frame = [&] {
    return std::filesystem::last_write_time(folder / "f/frame_000000.png");
  };
  const auto drawn = frame();
  EXPECT_EQ(run_twrench(folder, film + "--sound motion").code, 5) << "may not be wanted";
  const Outcome added = run_twrench(folder, film + "--resume --sound motion");
  ASSERT_EQ(added.code, 0) << added.err;
  EXPECT_EQ(frame(), drawn);
  EXPECT_GT(level(samples_in(folder, "film.mp4"), 1, 3), 0);
  EXPECT_EQ(run_twrench(folder, film + "--resume --sound motion").code, 0) << "the same film";
  const Outcome other = run_twrench(folder, film + "--resume --audio tone.wav");
  EXPECT_EQ(other.code, 5);
  EXPECT_THAT(other.err, HasSubstr("a different video"));
  EXPECT_THAT(other.err, HasSubstr("--overwrite instead of --resume"));
}

TEST(Encode, AddsAFileOrLeavesTheSoundOut) {
  const ScratchFolder folder;
  write_tone(folder, "tone.wav", 1);
  const std::string film = "render --size 32x32 --fps 30 --bare --progress none --duration 6 ";
  ASSERT_EQ(run_twrench(folder, film + "--sound motion -o film.mp4").code, 0);
  // The sound does not make other frames: they are kept.
  const auto drawn = std::filesystem::last_write_time(folder / "film/frame_000000.png");
  ASSERT_EQ(run_twrench(folder, film + "--resume -o silent.mp4 --frames-dir film").code, 0);
  ASSERT_EQ(
      run_twrench(folder, film + "--resume --sound motion -o again.mp4 --frames-dir film").code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "film/frame_000000.png"), drawn);
  EXPECT_NEAR(loudness_of(folder, "again.mp4").integrated, -16, 1);
  const std::string encode = "encode film --progress none ";
  const Outcome refused = run_twrench(folder, encode + "-o a.mp4");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err,
              HasSubstr("sound: the scene has sound, which its frames do not contain"));
  ASSERT_EQ(run_twrench(folder, encode + "--sound none -o a.mp4").code, 0);
  ASSERT_EQ(run_twrench(folder, encode + "-o a.gif").code, 0);
  ASSERT_EQ(run_twrench(folder, encode + "--audio tone.wav -o b.webm").code, 0);
  EXPECT_GT(level(samples_in(folder, "b.webm"), 0.2, 0.8), 0.05);
  EXPECT_EQ(run_twrench(folder, encode + "--audio tone.wav -o tone.wav --container mp4").code, 2);
  EXPECT_EQ(run_twrench(folder, encode + "--audio tone.wav -o b.gif").code, 2);
  EXPECT_EQ(run_twrench(folder, encode + "--audio none.wav -o c.mp4").code, 5);
  // A video without sound is the same as one of a scene without.
  EXPECT_EQ(run_twrench(folder, film + "--resume -o a.mp4 --frames-dir film").code, 0);
}

}  // namespace
}  // namespace twrench
