#include "top_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lens_rays.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kMargin_m = 0.02;
constexpr int kAngles = 90;            // tried within a quarter turn
constexpr int kFinerAngles = 10;       // and between two of those
constexpr double kBorderGray = 255.0;  // a border of the segment counts as a step of that

Eigen::Vector2d axisOf(double yaw_rad) { return {std::cos(yaw_rad), std::sin(yaw_rad)}; }

Eigen::Vector2d placeOf(const HeightRaster& raster, std::size_t cell) {
  const auto cols = static_cast<std::size_t>(raster.cols());
  return raster.place(static_cast<int>(cell / cols), static_cast<int>(cell % cols));
}

/// A step across a direction: its place and how much it says.
struct Step {
  Eigen::Vector2d place;
  double weight;
};

/// How far the steps gather on few lines along and across a direction: the sum of the squares of their histograms.
double sharpness(const std::vector<Step>& steps, double yaw_rad, double bin_m) {
  double sum = 0.0;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d axis = axisOf(yaw_rad + k * M_PI / 2);
    double low = INFINITY, high = -INFINITY;
    for (const Step& step : steps) {
      low = std::min(low, axis.dot(step.place));
      high = std::max(high, axis.dot(step.place));
    }
    std::vector<double> bins(static_cast<std::size_t>((high - low) / bin_m) + 2, 0.0);
    for (const Step& step : steps) {
      const double at = (axis.dot(step.place) - low) / bin_m;
      const auto bin = static_cast<std::size_t>(at);
      bins[bin] += step.weight * (1.0 - (at - std::floor(at)));
      bins[bin + 1] += step.weight * (at - std::floor(at));
    }
    for (const double bin : bins) sum += bin * bin;
  }
  return sum;
}

/// Steps of grey inside the segment and its border.
std::vector<Step> stepsOf(const HeightRaster& raster, const TopSegments& segments, int number) {
  std::vector<Step> steps;
  const auto cols = static_cast<std::size_t>(raster.cols());
  for (const std::size_t cell : segments.segments()[static_cast<std::size_t>(number)].cells) {
    const int row = static_cast<int>(cell / cols);
    const int col = static_cast<int>(cell % cols);
    if (row < 1 || col < 1 || row + 1 >= raster.rows() || col + 1 >= raster.cols()) continue;
    const std::array<std::size_t, 4> around{raster.index(row, col + 1), raster.index(row, col - 1),
                                            raster.index(row + 1, col), raster.index(row - 1, col)};
    const bool border = std::any_of(around.begin(), around.end(),
                                    [&](std::size_t other) { return segments.segmentOf(other) != number; });
    if (border) {
      steps.push_back({raster.place(row, col), kBorderGray});
      continue;
    }
    const float along = raster.gray(around[0]) - raster.gray(around[1]);
    const float across = raster.gray(around[2]) - raster.gray(around[3]);
    const double weight = static_cast<double>(std::hypot(along, across));
    if (weight > 12.0) steps.push_back({raster.place(row, col), weight});
  }
  return steps;
}

/// Grey value between pixels of the cloud's colour, that of the nearest pixel at the border of the image.
float grayBetween(const BaseCloud& cloud, const Eigen::Vector2d& pixel) {
  if (!cloud.view().hasColor()) return 0.0f;
  const auto value = [&](int row, int col) {
    const std::uint8_t* bgr =
        cloud.view().bgr(std::clamp(row, 0, cloud.height() - 1), std::clamp(col, 0, cloud.width() - 1));
    return 0.114 * bgr[0] + 0.587 * bgr[1] + 0.299 * bgr[2];
  };
  const int col = static_cast<int>(std::floor(pixel.x()));
  const int row = static_cast<int>(std::floor(pixel.y()));
  const double s = pixel.x() - col;
  const double t = pixel.y() - row;
  return static_cast<float>((1 - t) * ((1 - s) * value(row, col) + s * value(row, col + 1)) +
                            t * ((1 - s) * value(row + 1, col) + s * value(row + 1, col + 1)));
}

enum class Owner { kSegment, kNobody, kOther };

/// Whose surface a point lies on: that of its cell of the raster, unless the point is seen below it, on a side face.
Owner ownerOf(const HeightRaster& raster, const TopSegments& segments, const Eigen::Vector3f& point,
              int number, double step_m) {
  const Eigen::Vector2d grid = raster.gridOf(point.head<2>().cast<double>());
  const int row = static_cast<int>(std::lround(grid.y()));
  const int col = static_cast<int>(std::lround(grid.x()));
  if (!raster.holds(row, col)) return Owner::kOther;
  const std::size_t cell = raster.index(row, col);
  if (static_cast<double>(raster.height(cell) - point.z()) > step_m) return Owner::kOther;
  const int segment = segments.segmentOf(cell);
  if (segment == number) return Owner::kSegment;
  return segment < 0 ? Owner::kNobody : Owner::kOther;
}

}  // namespace

double sideDirection(const HeightRaster& raster, const TopSegments& segments, int number) {
  const std::vector<Step> steps = stepsOf(raster, segments, number);
  if (steps.empty()) return 0.0;
  const double bin_m = 1.5 * raster.cell();
  double best = 0.0;
  double most = -1.0;
  const auto look = [&](double yaw_rad) {
    const double value = sharpness(steps, yaw_rad, bin_m);
    if (value <= most) return;
    most = value;
    best = yaw_rad;
  };
  const double turn = M_PI / 2 / kAngles;
  for (int i = 0; i < kAngles; ++i) look(i * turn);
  const double coarse = best;
  for (int i = -kFinerAngles; i <= kFinerAngles; ++i) look(coarse + i * turn / kFinerAngles);
  return best;
}

TopPicture::TopPicture(const BaseCloud& cloud, const geometry::Pose& camera_from_base,
                       const HeightRaster& raster, const TopSegments& segments, int number, double yaw_rad,
                       double step_m)
    : cell_m_(raster.cell()), yaw_rad_(yaw_rad) {
  setBounds(raster, segments.segments()[static_cast<std::size_t>(number)]);
  const std::size_t count = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(cols_);
  kinds_.assign(count, TopCell::kNoData);
  grays_.assign(count, HeightRaster::kNone);
  look(cloud, camera_from_base, raster, segments, number, step_m);
}

void TopPicture::setBounds(const HeightRaster& raster, const TopSegment& segment) {
  origin_ = segment.center;
  const Eigen::Vector2d x = axisOf(yaw_rad_);
  const Eigen::Vector2d y(-x.y(), x.x());
  Eigen::Array2d low(INFINITY, INFINITY);
  Eigen::Array2d high = -low;
  for (const std::size_t cell : segment.cells) {
    const Eigen::Vector2d d = placeOf(raster, cell) - origin_;
    const Eigen::Array2d local(x.dot(d), y.dot(d));
    low = low.min(local);
    high = high.max(local);
  }
  low_ = low - kMargin_m;
  cols_ = static_cast<int>((high.x() + kMargin_m - low_.x()) / cell_m_) + 1;
  rows_ = static_cast<int>((high.y() + kMargin_m - low_.y()) / cell_m_) + 1;
}

void TopPicture::look(const BaseCloud& cloud, const geometry::Pose& camera_from_base,
                      const HeightRaster& raster, const TopSegments& segments, int number, double step_m) {
  const TopSegment& segment = segments.segments()[static_cast<std::size_t>(number)];
  const auto rays = LensRays::fit(cloud.view(), {0, 0, cloud.width(), cloud.height()});
  if (!rays) return;
  std::vector<float> top_grays;
  for (int v = 0; v < rows_; ++v) {
    for (int u = 0; u < cols_; ++u) {
      const Eigen::Vector2d at = place(Eigen::Vector2d(u, v));
      const double level = segment.heightAt(at);
      const auto pixel = rays->pixel(camera_from_base * Eigen::Vector3d(at.x(), at.y(), level));
      if (!pixel) continue;
      const int row = static_cast<int>(std::lround(pixel->y()));
      const int col = static_cast<int>(std::lround(pixel->x()));
      if (row < 0 || col < 0 || row >= cloud.height() || col >= cloud.width()) continue;
      grays_[index(u, v)] = grayBetween(cloud, *pixel);
      if (!cloud.valid(row, col)) continue;
      const Eigen::Vector3f p = cloud.point(row, col);
      const double rise = static_cast<double>(p.z()) - level;
      TopCell& kind = kinds_[index(u, v)];
      kind = rise > step_m ? TopCell::kAbove : TopCell::kBelow;
      const Owner owner = ownerOf(raster, segments, p, number, step_m);
      if (owner == Owner::kOther || (owner == Owner::kNobody && std::abs(rise) > step_m)) continue;
      kind = TopCell::kTop;
      top_grays.push_back(grays_[index(u, v)]);
    }
  }
  if (top_grays.empty()) return;
  const auto middle = top_grays.begin() + static_cast<std::ptrdiff_t>(top_grays.size() / 2);
  std::nth_element(top_grays.begin(), middle, top_grays.end());
  median_gray_ = *middle;
}

Eigen::Vector2d TopPicture::place(const Eigen::Vector2d& uv) const {
  const Eigen::Vector2d local = low_ + cell_m_ * uv;
  const Eigen::Vector2d x = axisOf(yaw_rad_);
  return origin_ + local.x() * x + local.y() * Eigen::Vector2d(-x.y(), x.x());
}

}  // namespace mixed_palletizing::detection
