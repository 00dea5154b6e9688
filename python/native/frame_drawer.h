#pragma once

#include <unistd.h>

#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

#include "gl/backend.h"
#include "image/image.h"
#include "scene/scene.h"
#include "system/bounded_queue.h"

namespace twrench::python {

/// Draws single frames of a scene on a separate thread, because an OpenGL context belongs to the
/// thread that created it. Any thread may request a frame. The first request creates the thread and
/// the context.
class FrameDrawer {
 public:
  FrameDrawer(scene::Scene scene, gl::BackendChoice backend);
  ~FrameDrawer();
  FrameDrawer(const FrameDrawer&) = delete;
  FrameDrawer& operator=(const FrameDrawer&) = delete;

  /// Returns the frame. Another thread can end the integration of the motion through `stop`, as in
  /// StepControl. Throws as film::RenderJob() does, and GlError in a forked process, because
  /// neither threads nor OpenGL survive a fork.
  image::Image draw(int frame, const std::atomic<bool>& stop);

  /// Deletes a drawer, except in a forked process, which lacks its thread: joining it would fail,
  /// and destroying what it waits for would wait for it forever.
  struct Deleter {
    void operator()(FrameDrawer* drawer) const {
      if (::getpid() == drawer->process_) delete drawer;
    }
  };

 private:
  class Canvas;
  using Task = std::packaged_task<image::Image(Canvas&)>;

  const scene::Scene scene_;
  const gl::BackendChoice backend_;
  const pid_t process_ = ::getpid();
  system::BoundedQueue<std::shared_ptr<Task>> tasks_{16};
  std::once_flag started_;
  std::thread thread_;
};

}  // namespace twrench::python
