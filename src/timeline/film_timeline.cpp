#include "timeline/film_timeline.h"

#include <algorithm>

#include "scene/interior.h"

namespace twrench::timeline {
namespace {

/// Rises from 0 to 1 while `time` goes from 0 to `length`, with a smooth start and end.
double smooth_share(double time, double length) {
  if (time >= length) return 1;
  const double share = time / length;
  return share * share * (3 - 2 * share);
}

/// Finds the shot of each frame, and the frame's time in that shot.
class Clocks {
 public:
  explicit Clocks(const scene::Scene& film) : film_(film), first_(scene::first_frames(film)) {}

  /// Returns the index of the shot to which the frame belongs.
  std::size_t shot_of(int frame) const {
    if (film_.shots.empty()) return 0;
    const auto after = std::ranges::upper_bound(first_, frame);
    return static_cast<std::size_t>(after - first_.begin()) - 1;
  }

  /// Returns the time in the shot that the frame shows; it may lie after the shot's end.
  FrameTime at(std::size_t shot, int frame) const {
    if (film_.shots.empty()) return frame_times(film_.film, {frame}).front();
    const scene::Shot& of = film_.shots[shot];
    const double time = (frame - first_[shot]) / film_.film.fps;
    return {frame, time, of.time_of(time), of.speed.at(time) / film_.film.fps};
  }

 private:
  const scene::Scene& film_;
  std::vector<int> first_;
};

}  // namespace

const scene::Scene& scene_of_shot(const scene::Scene& film, std::size_t shot) {
  return film.shots.empty() ? film : film.shots[shot].scene;
}

std::vector<double> motion_times(const scene::Scene& film) {
  const Clocks clocks(film);
  std::vector<double> times;
  for (int i = 0; i < film.frame_count(); ++i) times.push_back(clocks.at(clocks.shot_of(i), i).t);
  return times;
}

FilmTimeline::FilmTimeline(const scene::Scene& film, const std::vector<int>& frames,
                           const std::atomic<bool>* stop) {
  scene::check_shown_motion(film);
  const Clocks clocks(film);
  std::map<std::size_t, std::vector<FrameTime>> times;  // of each shot
  const auto place = [&](std::size_t shot, int frame) {
    times[shot].push_back(clocks.at(shot, frame));
    return Place{shot, times[shot].size() - 1};
  };
  for (const int number : frames) {
    const std::size_t shot = clocks.shot_of(number);
    Frame frame{place(shot, number), std::nullopt, 1, 1};
    if (shot > 0) {
      const double time = times[shot].back().video_time;
      frame.faded = smooth_share(time, film.shots[shot].fade);
      frame.moved = smooth_share(time, film.shots[shot].move);
      if (frame.faded < 1 || frame.moved < 1) frame.previous = place(shot - 1, number);
    }
    frames_.push_back(frame);
  }
  for (auto& [shot, of] : times) timelines_.try_emplace(shot, scene_of_shot(film, shot), of, stop);
  for (std::size_t i = 0; i < film.shots.size(); ++i) {
    caption_stays_.push_back(i > 0 &&
                             film.shots[i].scene.caption == film.shots[i - 1].scene.caption);
  }
}

FilmFrame FilmTimeline::frame(std::size_t index) const {
  const auto& [own, previous, faded, moved] = frames_[index];
  const auto state = [&](const Place& place) {
    return timelines_.at(place.shot).frame_state(place.index);
  };
  FilmFrame frame{own.shot, state(own), std::nullopt, faded, moved};
  if (previous) frame.previous = state(*previous);
  if (faded < 1 && !caption_stays_[own.shot]) {  // one caption disappears before the next appears
    frame.state.caption_opacity = std::max(0.0, 2 * faded - 1);
    frame.previous->caption_opacity = std::max(0.0, 1 - 2 * faded);
  }
  return frame;
}

}  // namespace twrench::timeline
