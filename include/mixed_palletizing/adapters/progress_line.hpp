// "12 of 50 scenes" on stderr, for people who wait.
#pragma once

#include <cstdint>
#include <string>

namespace mixed_palletizing::adapters {

/// Writes nothing when stderr is no terminal. Not for several threads at once.
class ProgressLine {
 public:
  ProgressLine(std::uint64_t total, const std::string& what);
  ~ProgressLine();  ///< ends the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void step();

 private:
  const std::uint64_t total_;
  const std::string what_;
  const bool visible_;
  std::uint64_t done_ = 0;
};

}  // namespace mixed_palletizing::adapters
