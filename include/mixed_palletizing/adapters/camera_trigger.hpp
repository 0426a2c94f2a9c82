// Asks the camera for a cloud, without waiting longer for its answer than the caller may.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

namespace mixed_palletizing::adapters {

/// Thread safe. A driver that hangs keeps one thread here, not those of its callers. Callers that come while a
/// capture is under way share it.
class CameraTrigger {
 public:
  enum class Outcome { kTriggered, kRefused, kNoAnswer };
  using Deadline = std::chrono::steady_clock::time_point;

  /// `capture` calls the camera and returns true when it did what was asked; it must not throw.
  explicit CameraTrigger(std::function<bool()> capture);
  /// Waits for the capture that is under way; roscpp ends that when the node ends.
  ~CameraTrigger();
  CameraTrigger(const CameraTrigger&) = delete;
  CameraTrigger& operator=(const CameraTrigger&) = delete;

  Outcome trigger(Deadline deadline);

 private:
  std::shared_future<bool> underWay();

  const std::function<bool()> capture_;
  std::mutex mutex_;  // guards the next two
  std::shared_future<bool> answer_;
  std::thread thread_;
};

}  // namespace mixed_palletizing::adapters
