#include "outline_lines.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::detection {
namespace {

constexpr std::size_t kEnough = 700;    // samples that tell a direction
constexpr double kAcross = 0.5;         // cosine between a walk and the normal of the side it ends at
constexpr double kCoarseStep = 0.0262;  // [rad] 1.5 degrees
constexpr double kFineStep = 0.0026;
constexpr int kFineSteps = 10;
constexpr double kCoarseBin = 0.003;  // [m]
constexpr double kLeastBin = 0.0005;  // [m] of the histogram that lines are found in
constexpr double kBinPixels = 0.7;    // or so many pixels
constexpr int kLineReach = 2;         // bins that belong to one peak, each way
constexpr std::size_t kMaxLines = 8;  // of a sign

using SideSample = LineBuffers::SideSample;

/// Sum of the squared counts of the histograms of places along two directions.
class Profile {
 public:
  /// Of the places in the buffers.
  explicit Profile(LineBuffers& buffers) : x_(buffers.x), y_(buffers.y), axes_(buffers.profiles) {}

  double sharpness(double yaw, double bin) {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    project(c, s, bin, axes_[0]);
    project(-s, c, bin, axes_[1]);
    // Side by side: neighbours of one line fall into the same bins, and wait for each other there.
    for (std::size_t i = 0; i < x_.size(); ++i) {
      share(axes_[0].at[i], axes_[0].counts);
      share(axes_[1].at[i], axes_[1].counts);
    }
    return squares(axes_[0].counts) + squares(axes_[1].counts);
  }

 private:
  using Axis = LineBuffers::Profile;

  void project(double axis_x, double axis_y, double bin, Axis& axis) const {
    axis.at.resize(x_.size());
    double* at = axis.at.data();
    for (std::size_t i = 0; i < x_.size(); ++i) at[i] = x_[i] * axis_x + y_[i] * axis_y;
    std::array<double, 4> low{at[0], at[0], at[0], at[0]};
    std::array<double, 4> high = low;
    const std::size_t whole = x_.size() / 4 * 4;
    for (std::size_t i = 0; i < whole; i += 4) {
      for (std::size_t k = 0; k < 4; ++k) {
        low[k] = at[i + k] < low[k] ? at[i + k] : low[k];
        high[k] = at[i + k] > high[k] ? at[i + k] : high[k];
      }
    }
    for (std::size_t i = whole; i < x_.size(); ++i) {
      low[0] = std::min(low[0], at[i]);
      high[0] = std::max(high[0], at[i]);
    }
    const double from = *std::min_element(low.begin(), low.end());
    const double to = *std::max_element(high.begin(), high.end());
    for (std::size_t i = 0; i < x_.size(); ++i) at[i] = (at[i] - from) / bin;
    axis.counts.assign(static_cast<std::size_t>((to - from) / bin) + 3, 0.0);
  }

  /// Shared between two bins, so that a line on the border of bins counts as much as one in the middle.
  static void share(double at, std::vector<double>& counts) {
    const int bin = static_cast<int>(at);
    double* count = counts.data() + bin;
    count[0] += 1.0 - (at - bin);
    count[1] += at - bin;
  }

  static double squares(const std::vector<double>& counts) {
    double sum = 0.0;
    for (const double c : counts) sum += c * c;
    return sum;
  }

  const std::vector<double>& x_;
  const std::vector<double>& y_;
  std::array<Axis, 2>& axes_;
};

/// Peaks of the samples' places.
class PeakFinder {
 public:
  PeakFinder(double min_length_m, double bin_m, std::vector<double>& bins)
      : min_length_m_(min_length_m), bin_m_(bin_m), bins_(bins) {}

  /// Adds the lines found, longest first.
  void find(const std::vector<SideSample>& samples, bool low, std::vector<OutlineLine>& lines) {
    if (samples.empty()) return;
    double least = INFINITY;
    double most = -INFINITY;
    for (const SideSample& s : samples) {
      least = std::min(least, s.across);
      most = std::max(most, s.across);
    }
    least -= 2.0 * kLineReach * bin_m_;
    bins_.assign(static_cast<std::size_t>((most - least) / bin_m_) + 4 * kLineReach + 2, 0.0);
    for (const SideSample& s : samples)
      bins_[static_cast<std::size_t>((s.across - least) / bin_m_)] += s.length;
    for (std::size_t n = 0; n < kMaxLines; ++n) {
      std::size_t best = 0;
      double length = 0.0;
      for (std::size_t i = kLineReach; i + kLineReach < bins_.size(); ++i) {
        double sum = 0.0;
        for (std::size_t k = i - kLineReach; k <= i + kLineReach; ++k) sum += bins_[k];
        if (sum > length) {
          length = sum;
          best = i;
        }
      }
      if (length < min_length_m_) return;
      double mean = 0.0;
      for (std::size_t k = best - kLineReach; k <= best + kLineReach; ++k) {
        mean += bins_[k] * (static_cast<double>(k) + 0.5) / length;
      }
      OutlineLine line;
      line.at_m = least + mean * bin_m_;
      line.length_m = length;
      (low ? line.low : line.high) = true;
      lines.push_back(line);
      constexpr std::size_t gap = 2 * kLineReach;
      const std::size_t from = best > gap ? best - gap : 0;
      for (std::size_t k = from; k < std::min(bins_.size(), best + gap + 1); ++k) bins_[k] = 0.0;
    }
  }

 private:
  const double min_length_m_;
  const double bin_m_;
  std::vector<double>& bins_;
};

/// Turn that levels the samples around their lines, by least squares over those nearer than `reach_m`.
double levelling(const std::array<std::vector<SideSample>, 4>& sides, const OutlineLines& lines,
                 double reach_m) {
  double squares = 0.0;
  double products = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t axis = k / 2;
    const bool low = k % 2 == 0;
    for (const OutlineLine& line : lines[axis]) {
      if (low ? !line.low : !line.high) continue;
      double n = 0.0, along = 0.0, across = 0.0, along2 = 0.0, mixed = 0.0;
      for (const SideSample& s : sides[k]) {
        if (std::abs(s.across - line.at_m) > reach_m) continue;
        n += s.length;
        along += s.length * s.along;
        across += s.length * s.across;
        along2 += s.length * s.along * s.along;
        mixed += s.length * s.along * s.across;
      }
      if (n <= 0.0) continue;
      squares += along2 - along * along / n;
      products += (axis == 0 ? 1.0 : -1.0) * (mixed - along * across / n);
    }
  }
  return squares > 0.0 ? products / squares : 0.0;
}

void sortBySide(const std::vector<EdgeSample>& samples, const TopAxes& axes,
                std::array<std::vector<SideSample>, 4>& sides) {
  for (auto& side : sides) side.clear();
  for (const EdgeSample& s : samples) {
    if (!s.isEdge() && s.beyond != Beyond::kHole && s.beyond != Beyond::kInk) continue;
    const Eigen::Vector2d local = axes.local(s.place);
    const Eigen::Vector2d out(s.outward.dot(axes.u), s.outward.dot(axes.v));
    const double pixel = s.pixel_m;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double cosine = out(static_cast<Eigen::Index>(axis));
      if (std::abs(cosine) < kAcross) continue;
      const auto a = static_cast<Eigen::Index>(axis);
      sides[2 * axis + (cosine < 0.0 ? 0 : 1)].push_back({local(a), local(1 - a), pixel * std::abs(cosine)});
    }
  }
}

}  // namespace

TopAxes::TopAxes(const Eigen::Vector2d& at, double yaw)
    : origin(at), yaw_rad(yaw), u(std::cos(yaw), std::sin(yaw)), v(-u.y(), u.x()) {}

double sharpestYaw(const std::vector<EdgeSample>& samples, double pixel_m, LineBuffers& buffers) {
  buffers.x.clear();
  buffers.y.clear();
  const std::size_t stride = std::max<std::size_t>(1, samples.size() / kEnough);
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    if (!samples[i].isEdge() && samples[i].beyond != Beyond::kHole) continue;
    buffers.x.push_back(samples[i].place.x());
    buffers.y.push_back(samples[i].place.y());
  }
  if (buffers.x.size() < 2) return 0.0;
  Profile profile(buffers);
  double best_yaw = 0.0;
  double best = -1.0;
  const auto search = [&](double from, double step, int steps, double bin) {
    best = -1.0;
    double found = from;
    for (int i = 0; i <= steps; ++i) {
      const double sharpness = profile.sharpness(from + i * step, bin);
      if (sharpness <= best) continue;
      best = sharpness;
      found = from + i * step;
    }
    best_yaw = found;
  };
  search(0.0, kCoarseStep, static_cast<int>(M_PI / 2 / kCoarseStep), std::max(kCoarseBin, 2.0 * pixel_m));
  search(best_yaw - kFineSteps * kFineStep, kFineStep, 2 * kFineSteps, std::max(0.3 * kCoarseBin, pixel_m));
  return best_yaw;
}

void findLines(const std::vector<EdgeSample>& samples, double pixel_m, double min_length_m, TopAxes& axes,
               LineBuffers& buffers, OutlineLines& lines) {
  for (int round = 0; round < 2; ++round) {
    const auto& sides = buffers.sides;
    sortBySide(samples, axes, buffers.sides);
    PeakFinder finder(min_length_m, std::max(kLeastBin, kBinPixels * pixel_m), buffers.bins);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      lines[axis].clear();
      finder.find(sides[2 * axis], true, lines[axis]);
      finder.find(sides[2 * axis + 1], false, lines[axis]);
      std::sort(lines[axis].begin(), lines[axis].end(),
                [](const OutlineLine& a, const OutlineLine& b) { return a.at_m < b.at_m; });
    }
    if (round > 0) break;
    // A side that runs ahead along v falls back when the axes turn with it.
    const double turn = levelling(sides, lines, std::max(0.003, 3.0 * pixel_m));
    axes = TopAxes(axes.origin, axes.yaw_rad - turn);
  }
}

}  // namespace mixed_palletizing::detection
