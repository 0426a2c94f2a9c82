#include "seam_ends.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr double kEndAtSeam = 0.003;  // [m] or a seam runs across this near
constexpr double kEndFrom = 0.004;    // [m] behind the end of a change of colour ...
constexpr double kEndTo = 0.010;      // ... and up to here there is no surface
constexpr double kMargin = 0.004;     // [m] beside an end that may be torn

/// A few millimetres farther along at most half of the surface is left.
bool surfaceEnds(const SeamLattice& lattice, const SeamEnd& end, const std::array<int, 2>& places) {
  int tops = 0;
  int all = 0;
  for (double off = kEndFrom; off <= kEndTo; off += lattice.lineStep()) {
    const int line = static_cast<int>(std::lround(lattice.lineAt(end.at_m + end.sign * off)));
    for (const int at : places) {
      ++all;
      if (lattice.top(line, at)) ++tops;
    }
  }
  return 2 * tops <= all;
}

}  // namespace

bool endsAsBoxes(const SeamLattice& lattice, const std::vector<Seam>& seams, const SeamEnd& end,
                 const std::array<int, 2>& places) {
  for (const Seam& seam : seams) {
    if (seam.axis != end.axis && std::abs(seam.at_m - end.at_m) < kEndAtSeam) return true;
  }
  return surfaceEnds(lattice, end, places);
}

std::array<int, 2> linesBehind(const SeamLattice& lattice, const std::vector<Seam>& seams,
                               const SeamEnd& end) {
  double far_m = lattice.lines() * lattice.lineStep();
  for (const Seam& seam : seams) {
    const double behind_m = end.sign * (seam.at_m - end.at_m);
    if (seam.axis != end.axis && behind_m > -kEndAtSeam) far_m = std::min(far_m, behind_m);
  }
  if (far_m <= 2.0 * kMargin) return {0, -1};
  const double near = lattice.lineAt(end.at_m + end.sign * kMargin);
  const double far = lattice.lineAt(end.at_m + end.sign * (far_m - kMargin));
  return {std::max(0, static_cast<int>(std::ceil(std::min(near, far)))),
          std::min(lattice.lines() - 1, static_cast<int>(std::floor(std::max(near, far))))};
}

}  // namespace mixed_palletizing::detection
