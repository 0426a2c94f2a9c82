// Times of the stages of one detection.
#pragma once

#include <chrono>
#include <cstring>
#include <vector>

#include <mixed_palletizing/detection/detections.hpp>

namespace mixed_palletizing::detection {

/// Adds the time since the last call to a stage; a stage that runs once per cluster gets the sum.
class StageClock {
 public:
  StageClock() { times_.reserve(kMostStages); }

  void done(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    const double milliseconds = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    for (StageTime& time : times_) {
      if (std::strcmp(time.stage, stage) != 0) continue;
      time.milliseconds += milliseconds;
      return;
    }
    times_.push_back({stage, milliseconds});
  }

  const std::vector<StageTime>& times() const { return times_; }

 private:
  static constexpr std::size_t kMostStages = 16;

  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<StageTime> times_;
};

}  // namespace mixed_palletizing::detection
