#include <cstdio>

#include <unistd.h>

#include <mixed_palletizing/adapters/progress_line.hpp>

namespace mixed_palletizing::adapters {

ProgressLine::ProgressLine(std::uint64_t total, const std::string& what)
    : total_(total), what_(what), visible_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (visible_ && done_ > 0) std::fputc('\n', stderr);
}

void ProgressLine::step() {
  ++done_;
  if (!visible_) return;
  std::fprintf(stderr, "\r%llu of %llu %s", static_cast<unsigned long long>(done_),
               static_cast<unsigned long long>(total_), what_.c_str());
  std::fflush(stderr);
}

}  // namespace mixed_palletizing::adapters
