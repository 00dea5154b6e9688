#include "film/pipeline.h"

#include <chrono>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#include "film/error.h"
#include "image/png.h"
#include "system/bounded_queue.h"

namespace twrench::film {
namespace {

using Clock = std::chrono::steady_clock;

/// A frame that has been drawn, and its record.
struct DrawnEntry {
  const video::FrameRecord* record;
  image::PendingFrame frame;
};

/// A frame and its record, on their way through the stages.
struct Entry {
  const video::FrameRecord* record;
  std::shared_ptr<const image::Frame> frame;
};

class Pipeline {
 public:
  Pipeline(const Outputs& outputs, StageTimes& times)
      : outputs_(outputs), times_(times), to_compress_(static_cast<std::size_t>(outputs.jobs) + 1) {
    try {
      start_stages();
    } catch (const std::system_error& error) {
      close();  // the threads already started end and are joined
      throw ThreadError("cannot start a thread", error.code().message());
    } catch (...) {
      close();
      throw;
    }
  }

  /// Passes a drawn frame on to the stages. Returns false if a stage has failed, so that drawing
  /// more is pointless.
  bool pass_on(const video::FrameRecord& record, image::PendingFrame frame) {
    return to_composite_.push({&record, std::move(frame)});
  }

  /// Lets the stages complete the frames in flight, and rethrows the first error.
  void finish() {
    to_composite_.close();
    threads_.clear();  // Joins.
    if (error_) std::rethrow_exception(error_);
  }

  ~Pipeline() { to_composite_.close(); }
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

 private:
  void start_stages() {
    start([this] { composite(); });
    if (outputs_.sequence != nullptr) {
      for (int i = 0; i < outputs_.jobs; ++i) start([this] { compress(); });
    }
    if (outputs_.encoder != nullptr) start([this] { encode(); });
  }

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
    to_composite_.close();
    to_compress_.close();
    to_encode_.close();
  }

  /// Composites the frames, and then closes the later stages.
  void composite() {
    while (auto drawn = to_composite_.pop()) {
      std::shared_ptr<const image::Frame> frame;
      {
        const Timed timed(times_.composite);
        frame = std::make_shared<const image::Frame>(drawn->frame.finish());
      }
      if (outputs_.sequence != nullptr && frame->is_new) to_compress_.push({drawn->record, frame});
      if (outputs_.encoder != nullptr) to_encode_.push({drawn->record, std::move(frame)});
    }
    to_compress_.close();
    to_encode_.close();
  }

  void compress() {
    while (const auto entry = to_compress_.pop()) {
      std::vector<std::uint8_t> png;
      {
        const Timed timed(times_.compress);
        png = image::encode_png(entry->frame->image);
      }
      const Timed timed(times_.write);
      outputs_.sequence->write(*entry->record, png);
      note_first();
    }
  }

  void encode() {
    while (const auto entry = to_encode_.pop()) {
      {
        const Timed timed(times_.convert);
        outputs_.encoder->convert(*entry->frame);
      }
      const Timed timed(times_.encode);
      outputs_.encoder->write_converted();
      if (outputs_.sequence == nullptr) note_first();
    }
  }

  void note_first() {
    if (first_.test_and_set()) return;
    const auto since = Clock::now() - outputs_.start;
    times_.first = std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
  }

  const Outputs& outputs_;
  StageTimes& times_;
  system::BoundedQueue<DrawnEntry> to_composite_{1};
  system::BoundedQueue<Entry> to_compress_;
  system::BoundedQueue<Entry> to_encode_{4};
  std::atomic_flag first_;
  std::mutex error_mutex_;
  std::exception_ptr error_;
  std::vector<std::jthread> threads_;  ///< declared last, so that they are joined first
};

}  // namespace

void run_pipeline(const std::vector<video::FrameRecord>& frames, const Drawing& drawing,
                  const Outputs& outputs, const ProgressCallback& progress, StageTimes& times) {
  Pipeline pipeline(outputs, times);
  std::deque<image::PendingFrame> begun;  // The frames from `done` on.
  std::size_t done = 0;
  const auto begin_next = [&] {
    const std::size_t next = done + begun.size();
    if (next == frames.size()) return false;
    const Timed timed(times.draw);
    begun.push_back(drawing.begin(next));
    return true;
  };
  for (;;) {
    while (begun.size() <= drawing.ahead && begin_next()) {
    }
    if (begun.empty()) break;
    {
      const Timed timed(times.draw);
      begun.front().fetch();
    }
    if (!pipeline.pass_on(frames[done], std::move(begun.front()))) break;
    begun.pop_front();
    ++done;
    if (progress) progress(static_cast<int>(done), static_cast<int>(frames.size()));
  }
  pipeline.finish();
}

}  // namespace twrench::film
