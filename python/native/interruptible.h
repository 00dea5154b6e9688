#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>

namespace twrench::python {

/// Thrown to end work between two of its pieces.
struct Stopped {};

/// Calls `work` on another thread, without Python's global lock, while this thread runs Python's
/// signal handlers. If a handler raises an exception, as that for Ctrl-C does, the argument of
/// `work` becomes true, and the exception is thrown once `work` has returned.
template <typename Work>
auto run_interruptibly(const Work& work) {
  namespace py = pybind11;
  std::atomic<bool> stop = false;
  auto result = std::async(std::launch::async, [&] { return work(stop); });
  const auto is_ready = [&] {
    const py::gil_scoped_release others_run;
    return result.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
  };
  while (!is_ready()) {
    if (PyErr_CheckSignals() == 0) continue;
    const py::error_already_set raised;
    stop = true;
    {
      const py::gil_scoped_release others_run;
      result.wait();
    }
    throw raised;
  }
  return result.get();
}

}  // namespace twrench::python
