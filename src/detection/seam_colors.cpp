#include "seam_colors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mixed_palletizing::detection {
namespace {

constexpr double kSameShare = 0.7;    // of the lines that must change alike
constexpr double kSameChange = 0.35;  // of the usual change: what one line may differ

constexpr double kEndFrom = 0.004;  // [m] behind the end of a change of colour ...
constexpr double kEndTo = 0.010;    // ... and up to here there is no surface

using Change = std::array<double, 3>;

/// Mean colour of the surface in the window that begins at a place; nothing when less than half of it is seen.
std::optional<Change> meanColor(const SeamLattice& lattice, int line, int from, int window) {
  Change sum{};
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

std::vector<Change> changesOf(const SeamLattice& lattice, const SeamWindows& windows) {
  std::vector<Change> changes;
  for (int line = windows.first_line; line <= windows.last_line; ++line) {
    const auto low = meanColor(lattice, line, windows.place - windows.near - windows.window, windows.window);
    const auto high = meanColor(lattice, line, windows.place + windows.near + 1, windows.window);
    if (!low || !high) continue;
    changes.push_back({(*high)[0] - (*low)[0], (*high)[1] - (*low)[1], (*high)[2] - (*low)[2]});
  }
  return changes;
}

/// The median of each channel: of the majority, when there is one.
Change usualOf(const std::vector<Change>& changes) {
  Change usual{};
  std::vector<double> values(changes.size());
  for (std::size_t k = 0; k < usual.size(); ++k) {
    std::transform(changes.begin(), changes.end(), values.begin(), [k](const Change& c) { return c[k]; });
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    usual[k] = *middle;
  }
  return usual;
}

}  // namespace

bool changesEvenly(const SeamLattice& lattice, const SeamWindows& windows, double tolerance) {
  const std::vector<Change> changes = changesOf(lattice, windows);
  if (changes.empty()) return false;
  const Change usual = usualOf(changes);
  double size = 0.0;
  for (const double value : usual) size = std::max(size, std::abs(value));
  const double largest = std::max(tolerance, kSameChange * size);
  const auto same = std::count_if(changes.begin(), changes.end(), [&](const Change& change) {
    for (std::size_t k = 0; k < usual.size(); ++k) {
      if (std::abs(change[k] - usual[k]) > largest) return false;
    }
    return true;
  });
  return static_cast<double>(same) >= kSameShare * static_cast<double>(changes.size());
}

bool surfaceEnds(const SeamLattice& lattice, double along_m, int sign, const std::array<int, 2>& places) {
  int tops = 0;
  int all = 0;
  for (double off = kEndFrom; off <= kEndTo; off += lattice.lineStep()) {
    const int line = static_cast<int>(std::lround(lattice.lineAt(along_m + sign * off)));
    for (const int at : places) {
      ++all;
      if (lattice.top(line, at)) ++tops;
    }
  }
  return 2 * tops <= all;
}

}  // namespace mixed_palletizing::detection
