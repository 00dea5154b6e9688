#include "app/pipeline.h"

#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "base/bounded_queue.h"
#include "image/png.h"

namespace twrench {
namespace {

struct DrawnFrame {
  const FrameRecord* record;
  std::shared_ptr<const Picture> picture;
};

/// Adds the time of its own life to a stage.
class Timed {
 public:
  explicit Timed(std::atomic<std::int64_t>& total) : total_(total) {}
  ~Timed() {
    total_ += std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start_).count();
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  std::atomic<std::int64_t>& total_;
  Clock::time_point start_ = Clock::now();
};

class Pipeline {
 public:
  Pipeline(const Outputs& outputs, StageTimes& times)
      : outputs_(outputs), times_(times), to_compress_(static_cast<std::size_t>(outputs.jobs) + 1) {
    if (outputs.sequence != nullptr) {
      for (int i = 0; i < outputs.jobs; ++i) start([this] { compress(); });
    }
    if (outputs.encoder != nullptr) start([this] { encode(); });
  }

  /// False when a stage has failed: then there is no use in drawing on.
  bool pass_on(const DrawnFrame& frame) {
    const bool compress = outputs_.sequence != nullptr && frame.picture->is_new;
    return (!compress || to_compress_.push(frame)) &&
           (outputs_.encoder == nullptr || to_encode_.push(frame));
  }

  /// Lets the stages end what is on its way, and throws what the first to fail threw.
  void finish() {
    close();
    threads_.clear();  // joins
    if (error_) std::rethrow_exception(error_);
  }

  ~Pipeline() { close(); }
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

 private:
  void start(std::function<void()> stage) {
    threads_.emplace_back([this, stage = std::move(stage)] {
      try {
        stage();
      } catch (...) {
        {
          const std::lock_guard lock(error_mutex_);
          if (!error_) error_ = std::current_exception();
        }
        close();
      }
    });
  }

  void close() {
    to_compress_.close();
    to_encode_.close();
  }

  void compress() {
    while (const auto frame = to_compress_.pop()) {
      const Timed timed(times_.compress);
      outputs_.sequence->write(*frame->record, encode_png(frame->picture->image));
    }
  }

  void encode() {
    while (const auto frame = to_encode_.pop()) {
      const Timed timed(times_.encode);
      outputs_.encoder->write(frame->picture->image);
    }
  }

  const Outputs& outputs_;
  StageTimes& times_;
  BoundedQueue<DrawnFrame> to_compress_;
  BoundedQueue<DrawnFrame> to_encode_{4};
  std::mutex error_mutex_;
  std::exception_ptr error_;
  std::vector<std::jthread> threads_;  ///< last: joined before what they use goes
};

}  // namespace

std::size_t run_pipeline(const std::vector<FrameRecord>& frames,
                         const std::function<Picture(const FrameRecord&)>& draw,
                         const std::function<bool()>& stop, const Outputs& outputs,
                         Progress& progress, StageTimes& times) {
  Pipeline pipeline(outputs, times);
  std::size_t done = 0;
  while (done < frames.size() && !stop()) {
    const FrameRecord& frame = frames[done];
    std::shared_ptr<const Picture> picture;
    {
      const Timed timed(times.draw);
      picture = std::make_shared<const Picture>(draw(frame));
    }
    if (!pipeline.pass_on({&frame, std::move(picture)})) break;
    progress.update(static_cast<int>(++done), static_cast<int>(frames.size()));
  }
  pipeline.finish();
  return done;
}

}  // namespace twrench
