// Counts what was dropped and why, and warns about it now and then.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace mixed_palletizing::adapters {

/// Thread safe. Warnings of one reason come at most once per interval of the steady clock, so that they also
/// come when simulated time stands still.
class FaultCounter {
 public:
  using Clock = std::chrono::steady_clock;

  /// `warn` gets the lines; it is called without a lock held.
  FaultCounter(std::function<void(const std::string&)> warn, std::chrono::milliseconds interval);

  /// `reason` is a short word ("wrong_row_step"), `message` has the values.
  void count(const std::string& reason, const std::string& message);

  std::map<std::string, std::uint64_t> counts() const;
  std::uint64_t total() const;

 private:
  struct Entry {
    std::uint64_t count = 0;
    std::uint64_t unreported = 0;
    Clock::time_point next_warning{};
  };
  std::function<void(const std::string&)> warn_;
  std::chrono::milliseconds interval_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;
};

}  // namespace mixed_palletizing::adapters
