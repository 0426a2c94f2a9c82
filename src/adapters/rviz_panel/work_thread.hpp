// One thread that does one job after the other.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace mixed_palletizing::rviz_panel {

class WorkThread {
 public:
  WorkThread();
  /// Waits for the running job and drops those that wait.
  ~WorkThread();
  WorkThread(const WorkThread&) = delete;
  WorkThread& operator=(const WorkThread&) = delete;

  /// The job must not throw.
  void post(std::function<void()> job);

 private:
  void run();

  std::mutex mutex_;  // guards jobs_ and stop_
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace mixed_palletizing::rviz_panel
