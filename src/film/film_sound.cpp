#include "film/film_sound.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>

#include "sound/motion_track.h"
#include "system/error.h"
#include "video/sound_file.h"

namespace twrench::film {
namespace {

/// A narration and the shot that it starts with.
struct Narration {
  const scene::Shot& shot;
  double start;  ///< In s of film.
};

std::vector<Narration> narrations_of(const scene::Scene& film) {
  std::vector<Narration> narrations;
  const std::vector<int> first = scene::first_frames(film);
  for (std::size_t i = 0; i < film.shots.size(); ++i) {
    const scene::Shot& shot = film.shots[i];
    if (shot.narration.is_given()) narrations.push_back({shot, first[i] / film.film.fps});
  }
  return narrations;
}

/// Returns the length of the narration in s. Throws FileError about the shot.
double length_of_narration(const scene::Shot& shot) {
  try {
    return video::sound_length(shot.narration.path);
  } catch (const system::FileError& error) {
    throw system::FileError(shot.place + ".narration", error.what(), error.remedy());
  }
}

double length_of(const scene::Scene& film) { return film.frame_count() / film.film.fps; }

/// s. A film with sound may not be longer.
constexpr double longest_film = 12 * 3600;

void require_length(const scene::Scene& film) {
  if (length_of(film) <= longest_film) return;
  throw InvalidArgument("sound",
                        fmt::format("the film lasts {:.0f} s, and one with sound at most {} s",
                                    length_of(film), longest_film),
                        "leave the sound out, or take a greater speed or a shorter duration");
}

void require_consecutive(const std::vector<int>& frames) {
  if (frames.back() - frames.front() == static_cast<int>(frames.size()) - 1) return;
  throw InvalidArgument("sound", "the film has sound, so its frames must follow each other",
                        "select one range a-b, or write the frames alone, without a video");
}

}  // namespace

bool has_sound(const scene::Scene& film) {
  return film.film.audio.is_given() || film.film.sound == scene::Sound::motion ||
         !narrations_of(film).empty();
}

void require_sound_container(const scene::Scene& film, video::Container container) {
  const video::OutputFormat& format = video::output_format(container);
  const bool is_motion = film.film.sound == scene::Sound::motion;
  if (format.sound != nullptr || !(is_motion || film.film.audio.is_given())) return;
  throw InvalidArgument(is_motion ? "sound" : "audio", fmt::format("{} has no sound", format.label),
                        fmt::format("leave the sound out, or choose {}",
                                    video::listed(video::format_texts(&video::OutputFormat::ending,
                                                                      &video::OutputFormat::sound),
                                                  "or")));
}

std::vector<std::string> check_narration(const scene::Scene& film) {
  constexpr double round_off = 1e-3;
  std::vector<std::string> warnings;
  for (const auto& [shot, start] : narrations_of(film)) {
    const double length = length_of_narration(shot);
    const double room = *shot.scene.length, left = length_of(film) - start;
    if (length <= room + round_off) continue;
    if (std::isinf(length)) {
      throw InvalidArgument(shot.place + ".narration",
                            shot.narration.file + " does not state its length",
                            "convert it to WAV, FLAC, MP3 or Opus");
    }
    const std::string what = fmt::format("lasts {:.2f} s", length);
    if (length > left + round_off) {
      throw InvalidArgument(shot.place + ".narration",
                            fmt::format("{} {}, but the film ends {:.2f} s after its start",
                                        shot.narration.file, what, left),
                            "make the shot longer, or the narration shorter");
    }
    warnings.push_back(fmt::format("{}.narration: {} {}, but the shot {:.2f} s", shot.place,
                                   shot.narration.file, what, room));
  }
  return warnings;
}

std::shared_ptr<const video::SoundTrack> sound_track(const scene::Scene& film,
                                                     const std::vector<int>& frames,
                                                     video::Container container,
                                                     system::Patience patience) {
  if (!has_sound(film) || video::output_format(container).sound == nullptr) return nullptr;
  require_length(film);
  require_consecutive(frames);
  const double fps = film.film.fps;
  video::SoundMix mix{.files = {},
                      .begin = frames.front() / fps,
                      .end = (frames.back() + 1) / fps,
                      .film_length = length_of(film)};
  if (film.film.audio.is_given()) mix.files.push_back({film.film.audio.path});
  for (const auto& [shot, start] : narrations_of(film)) {
    mix.files.push_back({shot.narration.path, start});
  }
  std::optional<sound::MotionTrack> motion;
  if (film.film.sound == scene::Sound::motion) {
    motion.emplace(film, patience.stop);
    mix.motion = [&](const auto& sink) { motion->play(mix.begin, mix.end, sink); };
  }
  return std::make_shared<video::SoundTrack>(mix, container, patience);
}

}  // namespace twrench::film
