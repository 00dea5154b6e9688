#include "timeline/film_timeline.h"

#include <algorithm>

#include "scene/interior.h"
#include "timeline/smooth_share.h"

namespace twrench::timeline {
namespace {

/// The share of a transition of that length; 1 if its length is 0.
double share_of(double time, double length) {
  return time >= length ? 1 : smooth_share(time / length);
}

/// Returns whether a shot shows the text of the previous one as well, and of the same motion.
bool shows_same_text(const scene::Shot& shot, const scene::Shot& previous) {
  const scene::Overlay &own = shot.scene.overlay, &before = previous.scene.overlay;
  return shot.continues && own.view == before.view && std::ranges::includes(own.show, before.show);
}

/// Returns the clock of a shot; none in a film without shots.
Clock clock_of(const scene::Scene& film, std::size_t shot) {
  if (film.shots.empty()) return {};
  return [of = film.shots[shot]](double time) { return of.time_of(time); };
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

bool changes_frame(const scene::Scene& film, std::size_t shot) {
  const scene::Shot& own = film.shots[shot];
  return own.move > 0 && own.continues &&
         own.scene.camera.frame != film.shots[shot - 1].scene.camera.frame;
}

std::vector<double> motion_times(const scene::Scene& film) {
  const Clocks clocks(film);
  std::vector<double> times;
  for (int i = 0; i < film.frame_count(); ++i) times.push_back(clocks.at(clocks.shot_of(i), i).t);
  return times;
}

FilmTimeline::FilmTimeline(const scene::Scene& film, const std::vector<int>& frames,
                           const std::atomic<bool>* stop)
    : text_fade_(film.film.text_fade) {
  scene::check_shown_motion(film);
  const Clocks clocks(film);
  std::map<std::size_t, std::vector<FrameTime>> times;  // of each shot
  const auto place = [&](std::size_t shot, const FrameTime& time) {
    times[shot].push_back(time);
    return Place{shot, times[shot].size() - 1};
  };
  for (const int number : frames) {
    const std::size_t shot = clocks.shot_of(number);
    const FrameTime own = clocks.at(shot, number);
    Frame frame{place(shot, own), std::nullopt, 1, 1};
    if (shot > 0) {
      frame.faded = share_of(own.video_time, film.shots[shot].fade);
      frame.moved = share_of(own.video_time, film.shots[shot].move);
      if (frame.faded < 1 || frame.moved < 1) {
        FrameTime previous = clocks.at(shot - 1, number);
        if (changes_frame(film, shot)) {  // both shots show the body in the same pose
          previous.t = own.t;
          previous.interval = own.interval;
        }
        frame.previous = place(shot - 1, previous);
      }
    }
    frames_.push_back(frame);
  }
  for (auto& [shot, of] : times) {
    timelines_.try_emplace(shot, scene_of_shot(film, shot), of, stop, clock_of(film, shot));
  }
  for (const auto& [shot, of] : times) {
    if (shot > 0 && film.shots[shot].move > 0) moves_[shot] = move_of(film, shot);
  }
  for (std::size_t i = 1; i < film.shots.size(); ++i) {
    const scene::Shot &previous = film.shots[i - 1], &shot = film.shots[i];
    text_ends_.push_back({*previous.scene.length, shot.scene.caption != previous.scene.caption,
                          shot.fade > 0 && !shows_same_text(shot, previous)});
  }
}

std::shared_ptr<const CameraMove> FilmTimeline::move_of(const scene::Scene& film,
                                                        std::size_t shot) const {
  const scene::Shot &own = film.shots[shot], &previous = film.shots[shot - 1];
  CameraMove move{
      previous.scene.camera, *previous.scene.length, own.move, {}, own.start, own.speed};
  if (changes_frame(film, shot)) {
    const Solution& solution = solutions(shot).front();
    const std::vector<double> ends{own.start, own.time_of(own.move)};
    const std::vector<motion::Sample> samples = solution.samples_at(ends);
    move.change.emplace(
        solution.body, FrameChange::End{previous.scene.camera.frame, samples[0], own.speed.at(0)},
        FrameChange::End{own.scene.camera.frame, samples[1], own.speed.at(own.move)}, own.move);
  }
  return std::make_shared<const CameraMove>(std::move(move));
}

FilmFrame FilmTimeline::frame(std::size_t index) const {
  const auto& [own, previous, faded, moved] = frames_[index];
  const auto state = [&](const Place& place) {
    return timelines_.at(place.shot).frame_state(place.index);
  };
  FilmFrame frame{own.shot, state(own), std::nullopt, faded, moved};
  if (previous) frame.previous = state(*previous);
  const auto move = moves_.find(own.shot);
  if (move != moves_.end()) {
    frame.state.move = move->second;
    frame.state.move_time = frame.state.video_time;
    if (move->second->change && frame.previous) {  // one camera for both shots
      frame.previous->move = move->second;
      frame.previous->move_time = frame.state.video_time;
    }
  }
  if (faded < 1 && text_ends_[own.shot - 1].caption_leaves) {
    // One caption disappears before the next appears.
    frame.state.caption_opacity = std::max(0.0, 2 * faded - 1);
    frame.previous->caption_opacity = std::max(0.0, 1 - 2 * faded);
  }
  fade_text(own.shot, frame.state);
  if (previous) fade_text(previous->shot, *frame.previous);
  return frame;
}

/// Fades the text that leaves at the end of the shot.
void FilmTimeline::fade_text(std::size_t shot, FrameState& state) const {
  if (!text_fade_ || shot >= text_ends_.size()) return;
  const auto& [end, caption_leaves, text_leaves] = text_ends_[shot];
  const double left = 1 - share_of(state.video_time - (end - *text_fade_), *text_fade_);
  if (caption_leaves) state.caption_opacity = std::min(state.caption_opacity, left);
  if (text_leaves) state.text_opacity = left;
}

}  // namespace twrench::timeline
