// "[####------] 12 of 50 scenes, 0:38 left" on stderr, for people who wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace mixed_palletizing::adapters {

/// Writes nothing when stderr is no terminal. Not for several threads at once.
class ProgressLine {
 public:
  /// `done`: what was done before; it took no time.
  ProgressLine(std::uint64_t total, const std::string& what, std::uint64_t done = 0);
  ~ProgressLine();  ///< ends the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void step();

 private:
  const std::uint64_t total_;
  const std::string what_;
  const bool visible_;
  const std::uint64_t done_before_;
  const std::chrono::steady_clock::time_point start_;
  std::uint64_t done_;
};

/// The line's text, `seconds` after the start; the time left as if every step took the same.
std::string progressText(std::uint64_t done_before, std::uint64_t done, std::uint64_t total,
                         const std::string& what, double seconds);

}  // namespace mixed_palletizing::adapters
