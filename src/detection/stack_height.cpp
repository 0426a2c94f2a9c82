#include "stack_height.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mixed_palletizing::detection {
namespace {

constexpr double kReach_m = 0.05;  // beyond a side in which its foot is looked for
constexpr double kSampleStep_m = 0.004;
constexpr double kInner = 0.8;         // of a side's length
constexpr double kMostSamples = 0.5;   // share of a side's samples that must agree
constexpr double kAgree_m = 0.012;     // on a drop
constexpr double kLeastFacing = 0.03;  // sine of the angle at which the camera sees a side's face

/// Drops from the top to the first level surface beyond a side, one for each place along it that shows one.
std::vector<double> dropsBeyond(const HeightRaster& raster, const TopSegments& segments,
                                const Eigen::Vector2d& begin, const Eigen::Vector2d& end,
                                const Eigen::Vector2d& normal, double top_m, double step_m, int& samples) {
  std::vector<double> drops;
  const double length = (end - begin).norm();
  samples = std::max(1, static_cast<int>(kInner * length / kSampleStep_m));
  for (int i = 0; i < samples; ++i) {
    const double share = 0.5 * (1.0 - kInner) + kInner * (i + 0.5) / samples;
    const Eigen::Vector2d at = begin + share * (end - begin);
    for (double out = raster.cell(); out < kReach_m; out += raster.cell()) {
      const Eigen::Vector2d grid = raster.gridOf(at + out * normal);
      const int row = static_cast<int>(std::lround(grid.y()));
      const int col = static_cast<int>(std::lround(grid.x()));
      if (!raster.holds(row, col)) break;
      const std::size_t cell = raster.index(row, col);
      if (segments.segmentOf(cell) < 0) continue;
      const TopSegment& foot = segments.segments()[static_cast<std::size_t>(segments.segmentOf(cell))];
      const double drop = top_m - foot.heightAt(raster.place(row, col));
      if (drop < step_m) {
        if (out > 2.0 * raster.cell()) break;  // a neighbour of the same height: no face is seen
        continue;                              // still the top itself
      }
      drops.push_back(drop);
      break;
    }
  }
  return drops;
}

}  // namespace

std::optional<SideHeight> heightOfSides(const HeightRaster& raster, const TopSegments& segments,
                                        const geometry::Rectangle& rectangle, double top_m,
                                        const Eigen::Vector3d& camera, double step_m) {
  const auto corners = rectangle.corners();
  const std::array<Eigen::Vector2d, 4> normals{-rectangle.axisY(), rectangle.axisX(), rectangle.axisY(),
                                               -rectangle.axisX()};
  std::optional<SideHeight> best;
  double largest = 0.0;
  std::vector<double> found;  // drop of each side that shows one
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d middle = 0.5 * (corners[i] + corners[(i + 1) % 4]);
    const Eigen::Vector3d ray(camera.x() - middle.x(), camera.y() - middle.y(), camera.z() - top_m);
    if (normals[i].dot(ray.head<2>()) < kLeastFacing * ray.norm()) continue;
    int samples = 0;
    std::vector<double> drops =
        dropsBeyond(raster, segments, corners[i], corners[(i + 1) % 4], normals[i], top_m, step_m, samples);
    if (drops.size() < static_cast<std::size_t>(kMostSamples * samples) + 1) continue;
    std::sort(drops.begin(), drops.end());
    const double drop = drops[drops.size() / 2];
    const auto agree =
        std::count_if(drops.begin(), drops.end(), [&](double d) { return std::abs(d - drop) < kAgree_m; });
    if (static_cast<double>(agree) < kMostSamples * samples) continue;
    largest = std::max(largest, drop);
    found.push_back(drop);
    if (best && best->height_m <= drop) continue;
    const double spread = drops[drops.size() * 5 / 6] - drops[drops.size() / 6];
    best = SideHeight{drop, std::max(0.5 * spread, 0.25 * step_m)};
  }
  // Sides that differ: one of them shows the top of a lower neighbour, or boxes below that stand flush.
  if (best && largest - best->height_m > kAgree_m) {
    best->stddev_m = std::hypot(best->stddev_m, 0.5 * (largest - best->height_m));
  }
  if (!best) return best;
  // The foot of a single side may be the top of a lower neighbour: the box may reach down to the ground.
  const auto agree = std::count_if(found.begin(), found.end(),
                                   [&](double drop) { return std::abs(drop - best->height_m) < kAgree_m; });
  const double below = top_m - best->height_m - raster.low();
  if (agree < 2 && below > kAgree_m) best->stddev_m = std::hypot(best->stddev_m, 0.5 * below);
  return best;
}

}  // namespace mixed_palletizing::detection
