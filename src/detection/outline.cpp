#include "outline.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr int kSlopePixels = 4;        // pixels inwards from which the spacing of the rays is taken
constexpr int kLookPixels = 5;         // with data, across the outline
constexpr int kOccluderPixels = 3;     // of these: a rim of fewer high pixels is a fault of the sensor
constexpr double kShadowShare = 0.10;  // of the image side: how far across missing data the search goes
constexpr double kBorderShare = 0.03;  // of the image side: an image border this near, behind no data

/// Makes the samples of one top.
class SampleMaker {
 public:
  SampleMaker(const BaseCloud& cloud, double height_m, const TopBand& band, double step_m)
      : cloud_(cloud), height_m_(height_m), band_(band), step_m_(step_m) {}

  /// Sample outside of pixel (row, col) in direction (down, right), one of which is +-1 and the other 0.
  /// `depth`: pixels of the top on the inner side, this one included.
  OutlineSample make(int row, int col, int down, int right, int depth) const {
    OutlineSample sample;
    sample.row = row;
    sample.col = col;
    sample.along_row = down == 0;
    sample.measured = cloud_.point(row, col).head<2>().cast<double>();
    const Eigen::Vector3d ray = borderRay(row, col, down, right, depth);
    sample.at_top = atHeight(ray, height_m_);
    sample.at_band = atHeight(ray, band_.low_m);
    sample.pixel_m = 2.0 * (sample.at_top - atHeight(cloud_.ray(row, col), height_m_)).norm();
    sample.goes_on = hasData(row + down, col + right);
    sample.across = lookAcross(row, col, down, right);
    return sample;
  }

 private:
  bool hasData(int row, int col) const {
    return row >= 0 && col >= 0 && row < cloud_.height() && col < cloud_.width() && cloud_.valid(row, col);
  }

  Eigen::Vector3d borderRay(int row, int col, int down, int right, int depth) const {
    Eigen::Vector3d last = cloud_.ray(row, col);
    for (int back = std::min(kSlopePixels, depth - 1); back > 0; --back) {
      const int inner_row = row - back * down;
      const int inner_col = col - back * right;
      if (!cloud_.valid(inner_row, inner_col)) continue;
      return last + 0.5 / back * (last - cloud_.ray(inner_row, inner_col));
    }
    return last;
  }

  Eigen::Vector2d atHeight(const Eigen::Vector3d& ray, double height_m) const {
    const Eigen::Vector3d camera = cloud_.camera();
    return (camera + (height_m - camera.z()) / ray.z() * ray).head<2>();
  }

  Across lookAcross(int row, int col, int down, int right) const {
    const int side = down != 0 ? cloud_.height() : cloud_.width();
    const int reach = std::max(3, static_cast<int>(kShadowShare * side));
    const int border = std::max(2, static_cast<int>(kBorderShare * side));
    const Eigen::Vector3f last = cloud_.point(row, col);
    int seen = 0;
    int higher = 0;
    for (int k = 1; k <= reach && seen < kLookPixels; ++k) {
      const int r = row + k * down;
      const int c = col + k * right;
      if (r < 0 || c < 0 || r >= cloud_.height() || c >= cloud_.width()) {
        return seen == 0 && k <= border ? Across::kBorder : Across::kFree;
      }
      if (!cloud_.valid(r, c)) continue;
      const Eigen::Vector3f next = cloud_.point(r, c);
      ++seen;
      if (next.z() > height_m_ + step_m_ && (next - last).norm() > step_m_) ++higher;
      if (higher == kOccluderPixels) return Across::kOccluder;
    }
    return Across::kFree;
  }

  const BaseCloud& cloud_;
  const double height_m_;
  const TopBand& band_;
  const double step_m_;
};

}  // namespace

void OutlineTracer::trace(const BaseCloud& cloud, const RunRange& top, double height_m, const TopBand& band,
                          double step_m, std::vector<OutlineSample>& samples) {
  samples.clear();
  columns_.assign(static_cast<std::size_t>(cloud.width()), Span{});
  const SampleMaker maker(cloud, height_m, band, step_m);
  for (const Run* run = top.begin(); run != top.end();) {
    const int row = run->row;
    const int first = run->begin;
    int last = first;
    for (; run != top.end() && run->row == row; ++run) {
      last = run->end - 1;
      for (int col = run->begin; col < run->end; ++col) {
        Span& column = columns_[static_cast<std::size_t>(col)];
        if (column.first < 0) column.first = row;
        column.last = row;
      }
    }
    samples.push_back(maker.make(row, first, 0, -1, last - first + 1));
    samples.push_back(maker.make(row, last, 0, 1, last - first + 1));
  }
  for (int col = 0; col < cloud.width(); ++col) {
    const Span column = columns_[static_cast<std::size_t>(col)];
    if (column.first < 0) continue;
    samples.push_back(maker.make(column.first, col, -1, 0, column.last - column.first + 1));
    samples.push_back(maker.make(column.last, col, 1, 0, column.last - column.first + 1));
  }
}

}  // namespace mixed_palletizing::detection
