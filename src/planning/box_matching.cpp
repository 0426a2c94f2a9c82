#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <mixed_palletizing/planning/box_matching.hpp>

namespace mixed_palletizing::planning {
namespace {

using packing::ItemType;

/// The distinct ways a type can lie before the robot: longer side, shorter side, height.
std::vector<std::array<int, 3>> lyingSizes(const ItemType& type) {
  std::vector<std::array<int, 3>> sizes;
  for (const packing::Vec3& s : packing::orientations(type)) {
    sizes.push_back({std::max(s.x, s.y), std::min(s.x, s.y), s.z});
  }
  return sizes;
}

/// By how much the worst side of the best orientation exceeds its tolerance [mm]; not positive = within.
double excess(const MeasuredBox& box, const ItemType& type, const MatchingOptions& options) {
  double best = std::numeric_limits<double>::infinity();
  for (const std::array<int, 3>& size : lyingSizes(type)) {
    double worst = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const double tolerance = std::max(options.tolerance_mm, options.sigmas * box.stddev_mm[i]);
      worst = std::max(worst, std::abs(box.size_mm[i] - size[i]) - tolerance);
    }
    best = std::min(best, worst);
  }
  return best;
}

/// Whether it makes no difference which of the two is packed.
bool packAlike(const ItemType& a, const ItemType& b) {
  const std::vector<packing::Vec3> sizes_a = packing::orientations(a);
  const std::vector<packing::Vec3> sizes_b = packing::orientations(b);
  return a.weight_kg == b.weight_kg && a.max_load_kg == b.max_load_kg && sizes_a.size() == sizes_b.size() &&
         std::all_of(sizes_a.begin(), sizes_a.end(), [&sizes_b](const packing::Vec3& size) {
           return std::find(sizes_b.begin(), sizes_b.end(), size) != sizes_b.end();
         });
}

std::string measurementProblem(const MeasuredBox& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(box.size_mm[i] > 0.0 && std::isfinite(box.size_mm[i])))
      return "its size is not positive and finite";
    if (!(box.stddev_mm[i] >= 0.0 && std::isfinite(box.stddev_mm[i]))) {
      return "the standard deviation of its size is negative or not finite";
    }
  }
  return {};
}

/// The same box with length >= width.
MeasuredBox sorted(MeasuredBox box) {
  if (box.size_mm[0] < box.size_mm[1]) {
    std::swap(box.size_mm[0], box.size_mm[1]);
    std::swap(box.stddev_mm[0], box.stddev_mm[1]);
  }
  return box;
}

}  // namespace

std::vector<std::string> problems(const MatchingOptions& options) {
  std::vector<std::string> found;
  if (!(options.tolerance_mm >= 0.0 && std::isfinite(options.tolerance_mm))) {
    found.push_back("tolerance_mm: " + std::to_string(options.tolerance_mm) +
                    " mm: must be finite and not negative");
  }
  if (!(options.sigmas >= 0.0 && std::isfinite(options.sigmas))) {
    found.push_back("sigmas: " + std::to_string(options.sigmas) + ": must be finite and not negative");
  }
  return found;
}

BoxMatch matchBox(const MeasuredBox& measured, const std::vector<ItemType>& types,
                  const std::vector<int>& remaining, const MatchingOptions& options) {
  if (types.size() != remaining.size()) {
    throw std::invalid_argument("matchBox: remaining: " + std::to_string(remaining.size()) + " counts for " +
                                std::to_string(types.size()) + " types");
  }
  BoxMatch match;
  match.message = measurementProblem(measured);
  if (!match.message.empty()) return match;
  const MeasuredBox box = sorted(measured);
  double nearest_excess = std::numeric_limits<double>::infinity();
  std::string nearest = "no items are left in the order";
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (remaining[i] < 1) continue;
    const double by = excess(box, types[i], options);
    if (by <= 0.0) match.candidates.push_back(static_cast<int>(i));
    if (by < nearest_excess) {
      nearest_excess = by;
      std::ostringstream text;
      text << "the nearest type, '" << types[i].name << "', is missed by " << std::fixed
           << std::setprecision(1) << by << " mm more than the tolerance";
      nearest = text.str();
    }
  }
  if (match.candidates.empty()) {
    match.message = nearest;
    return match;
  }
  const ItemType& first = types[static_cast<std::size_t>(match.candidates.front())];
  const bool alike = std::all_of(match.candidates.begin(), match.candidates.end(),
                                 [&](int i) { return packAlike(first, types[static_cast<std::size_t>(i)]); });
  match.status = alike ? MatchStatus::kMatched : MatchStatus::kAmbiguous;
  if (alike) {
    match.type = match.candidates.front();
    return match;
  }
  match.message = "within tolerance are";
  for (const int i : match.candidates) {
    match.message +=
        (i == match.candidates.front() ? " '" : ", '") + types[static_cast<std::size_t>(i)].name + "'";
  }
  return match;
}

}  // namespace mixed_palletizing::planning
