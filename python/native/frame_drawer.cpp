#include "frame_drawer.h"

#include <optional>
#include <utility>

#include "draw/film_renderer.h"
#include "gl/context.h"
#include "timeline/film_timeline.h"

namespace twrench::python {

/// The objects that belong to the drawing thread.
class FrameDrawer::Canvas {
 public:
  explicit Canvas(const FrameDrawer& drawer) : drawer_(drawer) {}

  image::Image draw(int frame, const std::atomic<bool>& stop) {
    const timeline::FilmTimeline timeline(drawer_.scene_, {frame}, &stop);
    if (!renderer_) {
      if (!opened_.context) opened_ = gl::open_context(drawer_.backend_);
      renderer_.emplace(*opened_.context, drawer_.scene_);
    }
    return renderer_->draw(timeline, timeline.frame(0)).image;
  }

 private:
  const FrameDrawer& drawer_;
  gl::OpenedContext opened_;
  std::optional<draw::FilmRenderer> renderer_;
};

FrameDrawer::FrameDrawer(scene::Scene scene, gl::BackendChoice backend)
    : scene_(std::move(scene)), backend_(std::move(backend)) {}

FrameDrawer::~FrameDrawer() {
  if (!thread_.joinable()) return;
  tasks_.close();
  thread_.join();
}

image::Image FrameDrawer::draw(int frame, const std::atomic<bool>& stop) {
  if (::getpid() != process_) {
    throw gl::GlError("frame", "this process was forked from the one that began to draw the scene",
                      {}, gl::GlError::Reason::forked);
  }
  std::call_once(started_, [this] {
    thread_ = std::thread([this] {
      Canvas canvas(*this);
      while (const auto task = tasks_.pop()) (**task)(canvas);
    });
  });
  const auto task =
      std::make_shared<Task>([&](Canvas& canvas) { return canvas.draw(frame, stop); });
  tasks_.push(task);
  return task->get_future().get();
}

}  // namespace twrench::python
