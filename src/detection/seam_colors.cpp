#include "seam_colors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mixed_palletizing::detection {
namespace {

constexpr double kSameShare = 0.7;    // of the lines that must change alike
constexpr double kSameChange = 0.35;  // of the usual change: what one line may differ

constexpr std::size_t kFewLines = 4;  // say nothing

constexpr double kForeignShare =
    0.1;  // of the lines: more that show the colour of the other side are of one top

using Color = std::array<double, 3>;

/// Mean colour of the surface in the window that begins at a place; nothing when less than half of it is seen.
std::optional<Color> meanColor(const SeamLattice& lattice, int line, int from, int window) {
  Color sum{};
  int seen = 0;
  for (int i = from; i < from + window; ++i) {
    if (!lattice.top(line, i)) continue;
    ++seen;
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += lattice.colors(line, k)[i];
  }
  if (2 * seen <= window) return std::nullopt;
  for (double& value : sum) value /= seen;
  return sum;
}

Color difference(const Color& a, const Color& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double sizeOf(const Color& color) {
  double size = 0.0;
  for (const double value : color) size = std::max(size, std::abs(value));
  return size;
}

/// How many of the colours are about this one.
std::size_t countNear(const std::vector<Color>& colors, const Color& other, double largest) {
  return static_cast<std::size_t>(std::count_if(colors.begin(), colors.end(), [&](const Color& color) {
    return sizeOf(difference(color, other)) <= largest;
  }));
}

}  // namespace

/// The median of each channel: of the majority, when there is one.
SeamColors::Color SeamColors::usualOf(const std::vector<Color>& colors) {
  Color usual{};
  values_.resize(colors.size());
  for (std::size_t k = 0; k < usual.size(); ++k) {
    std::transform(colors.begin(), colors.end(), values_.begin(), [k](const Color& c) { return c[k]; });
    const auto middle = values_.begin() + static_cast<std::ptrdiff_t>(values_.size() / 2);
    std::nth_element(values_.begin(), middle, values_.end());
    usual[k] = *middle;
  }
  return usual;
}

void SeamColors::read(const SeamLattice& lattice, const SeamWindows& windows) {
  lows_.clear();
  highs_.clear();
  changes_.clear();
  for (int line = windows.first_line; line <= windows.last_line; ++line) {
    const auto low = meanColor(lattice, line, windows.place - windows.near - windows.window, windows.window);
    const auto high = meanColor(lattice, line, windows.place + windows.near + 1, windows.window);
    if (!low || !high) continue;
    lows_.push_back(*low);
    highs_.push_back(*high);
    changes_.push_back(difference(*high, *low));
  }
}

double SeamColors::changeAt(const SeamLattice& lattice, const SeamWindows& windows) {
  read(lattice, windows);
  return changes_.empty() ? 0.0 : sizeOf(usualOf(changes_));
}

bool SeamColors::differ(const SeamLattice& lattice, const SeamWindows& windows, double tolerance) {
  read(lattice, windows);
  if (changes_.empty()) return false;
  const Color usual = usualOf(changes_);
  const double largest = std::max(tolerance, kSameChange * sizeOf(usual));
  const auto lines = static_cast<double>(changes_.size());
  if (static_cast<double>(countNear(changes_, usual, largest)) < kSameShare * lines) return false;
  const std::size_t foreign =
      countNear(lows_, usualOf(highs_), largest) + countNear(highs_, usualOf(lows_), largest);
  return static_cast<double>(foreign) <= kForeignShare * lines;
}

bool SeamColors::goesOn(const SeamLattice& lattice, const SeamWindows& windows, double tolerance) {
  read(lattice, windows);
  const auto changed = static_cast<std::size_t>(std::count_if(
      changes_.begin(), changes_.end(), [&](const Color& change) { return sizeOf(change) > tolerance; }));
  return changes_.size() < kFewLines || 2 * changed >= changes_.size();
}

}  // namespace mixed_palletizing::detection
