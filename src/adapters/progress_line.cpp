#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

#include <mixed_palletizing/adapters/progress_line.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// "1:05" or "2:01:05".
std::string clockText(double seconds) {
  const long whole = std::lround(std::min(seconds, 1e8));
  char text[48];
  if (whole < 3600) {
    std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  }
  return text;
}

}  // namespace

std::string progressText(std::uint64_t done_before, std::uint64_t done, std::uint64_t total,
                         const std::string& what, double seconds) {
  constexpr std::uint64_t kWidth = 24;
  const std::uint64_t full = total > 0 ? std::min(kWidth, kWidth * done / total) : kWidth;
  std::string text = "[" + std::string(full, '#') + std::string(kWidth - full, '-') + "] " +
                     std::to_string(done) + " of " + std::to_string(total) + " " + what;
  if (done > done_before && done < total) {
    const double each = seconds / static_cast<double>(done - done_before);
    text += ", " + clockText(each * static_cast<double>(total - done)) + " left";
  }
  return text;
}

ProgressLine::ProgressLine(std::uint64_t total, const std::string& what, std::uint64_t done)
    : total_(total),
      what_(what),
      visible_(isatty(STDERR_FILENO) != 0),
      done_before_(done),
      start_(std::chrono::steady_clock::now()),
      done_(done) {}

ProgressLine::~ProgressLine() {
  if (visible_ && done_ > done_before_) std::fputc('\n', stderr);
}

void ProgressLine::step() {
  ++done_;
  if (!visible_) return;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  std::fprintf(stderr, "\r\033[K%s", progressText(done_before_, done_, total_, what_, seconds).c_str());
  std::fflush(stderr);
}

}  // namespace mixed_palletizing::adapters
