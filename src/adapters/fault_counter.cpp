#include <utility>

#include <mixed_palletizing/adapters/fault_counter.hpp>

namespace mixed_palletizing::adapters {

FaultCounter::FaultCounter(std::function<void(const std::string&)> warn, std::chrono::milliseconds interval)
    : warn_(std::move(warn)), interval_(interval) {}

void FaultCounter::count(const std::string& reason, const std::string& message) {
  std::string line;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    Entry& entry = entries_[reason];
    ++entry.count;
    ++entry.unreported;
    const Clock::time_point now = Clock::now();
    if (now < entry.next_warning) return;
    entry.next_warning = now + interval_;
    line = reason + ": " + message;
    if (entry.unreported > 1)
      line += " (" + std::to_string(entry.unreported) + " times since the last warning)";
    entry.unreported = 0;
  }
  warn_(line);
}

std::map<std::string, std::uint64_t> FaultCounter::counts() const {
  std::lock_guard<std::mutex> lock(mutex_);
  std::map<std::string, std::uint64_t> counts;
  for (const auto& [reason, entry] : entries_) counts[reason] = entry.count;
  return counts;
}

std::uint64_t FaultCounter::total() const {
  std::uint64_t sum = 0;
  for (const auto& reason_count : counts()) sum += reason_count.second;
  return sum;
}

}  // namespace mixed_palletizing::adapters
