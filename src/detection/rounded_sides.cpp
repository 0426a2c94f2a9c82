#include "rounded_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "rectangle_sides.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kGate = 0.004;  // [m] samples this near to a side speak of its face
constexpr std::size_t kMinSamples = 8;
constexpr double kLeastMove = 0.00015;    // [m] a face that stands out less is the side itself ...
constexpr double kLeastShare = 0.06;      // ... and this share of the drop at which the surface ends
constexpr double kLargestMove = 0.012;    // [m]
constexpr double kLeastOpening = 0.2;     // 1 - sine of the flattest ray that tells a radius
constexpr double kUncertainShare = 0.15;  // of the move, that a side remains uncertain by
constexpr double kGuessedShare = 0.2;     // the same of a side that takes the radius of others
constexpr double kNormalMedian = 0.6745;  // median of |x| for a standard normal x
constexpr double kCornerShare = 0.95;     // of a side

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Radius of a round that ends `move_m` beyond the place where it is `drop_m` below its begin.
double radiusOf(double move_m, double drop_m) { return move_m + drop_m + std::sqrt(2.0 * move_m * drop_m); }

/// How far a round goes on beyond the place where it is `drop_m` below its begin.
double restOf(double radius_m, double drop_m) {
  const double d = std::clamp(drop_m, 0.0, radius_m);
  return radius_m - std::sqrt(d * (2.0 * radius_m - d));
}

/// One side of a fit as the camera sees it.
class Side {
 public:
  Side(const FitScale& scale, FitBuffers& buffers, RectangleFit& fit, std::size_t side)
      : scale_(scale),
        values_(buffers.values),
        others_(buffers.others),
        fit_(fit),
        side_(side),
        axes_(fit.rectangle),
        normal_(kOutward[side].x() * axes_.x + kOutward[side].y() * axes_.y) {
    const Eigen::Vector2d edge = fit.rectangle.center + halfAcross(fit.rectangle, side) * normal_;
    tangent_ = normal_.dot(edge - scale.camera.head<2>()) / scale.camera.z();
  }

  bool inView() const { return tangent_ < 0.0; }

  /// How far the faces below the edge stand out; nothing when too few are seen.
  std::optional<double> faceBeyond(const std::vector<EdgeSample>& samples) {
    std::vector<double>& beyond = values_;
    std::vector<double>& drops = others_;
    beyond.clear();
    drops.clear();
    for (const EdgeSample& s : samples) {
      if (!s.has_face || !isNear(s)) continue;
      beyond.push_back(kOutward[side_].dot(axes_.local(s.face)) - halfAcross(fit_.rectangle, side_));
      drops.push_back(static_cast<double>(s.face_drop_m));
    }
    if (beyond.size() < kMinSamples) return std::nullopt;
    const double middle = median(beyond);
    for (double& x : beyond) x = std::abs(x - middle);
    stddev_ = median(beyond) / kNormalMedian / std::sqrt(static_cast<double>(beyond.size()));
    return middle + behindTheTangent(median(drops));
  }

  /// The rest of a round of a known radius, behind where the surface ends: at a bend, or where a ray of the camera or
  /// of the projector touches the round.
  std::optional<double> restOfRound(const std::vector<EdgeSample>& samples, double radius_m) const {
    std::vector<double>& bends = values_;
    std::vector<double>& jumps = others_;
    bends.clear();
    jumps.clear();
    for (const EdgeSample& s : samples) {
      if (s.beyond != Beyond::kDrop || !isNear(s)) continue;
      (s.bent ? bends : jumps).push_back(static_cast<double>(s.drop_m));
    }
    if (bends.size() + jumps.size() < kMinSamples) return std::nullopt;
    if (bends.size() > jumps.size()) return restOf(radius_m, median(bends));
    const double drop = std::max(0.0, median(jumps));
    return restOf(radius_m, drop) + drop * tangent_;
  }

  /// Moves the side when that is more than the noise of the samples; returns whether it did.
  bool move(double by_m, double uncertain_share) {
    if (by_m < kLeastMove + kLeastShare * scale_.bend_m || by_m < 4.0 * stddev_ || by_m > kLargestMove) {
      return false;
    }
    fit_.rectangle.center += 0.5 * by_m * normal_;
    fit_.rectangle.size(side_ % 2 == 0 ? 1 : 0) += by_m;
    SideFit& side = fit_.sides[side_];
    side.stddev_m = std::hypot(side.stddev_m, stddev_ + uncertain_share * by_m);
    return true;
  }

 private:
  bool isNear(const EdgeSample& s) const {
    if (s.outward.dot(normal_) < 0.3) return false;
    const Eigen::Vector2d local = axes_.local(s.place);
    return std::abs(kOutward[side_].dot(local) - halfAcross(fit_.rectangle, side_)) < kGate &&
           std::abs(alongOf(side_).dot(local)) < kCornerShare * halfAlong(fit_.rectangle, side_);
  }

  /// How far a rounded edge of a face that is not in view goes on behind the ray that touches it: the ray leaves the
  /// round of radius r at r (1 - sin) below the top and r (1 - cos) before the face, by its angle with the vertical.
  double behindTheTangent(double drop_m) const {
    if (!(tangent_ > 0.0) || !(drop_m > 0.0)) return 0.0;
    const double cosine = 1.0 / std::sqrt(1.0 + tangent_ * tangent_);
    const double sine = tangent_ * cosine;
    return drop_m * (1.0 - cosine) / std::max(1.0 - sine, kLeastOpening);
  }

  const FitScale& scale_;
  std::vector<double>& values_;
  std::vector<double>& others_;
  RectangleFit& fit_;
  const std::size_t side_;
  const Axes axes_;
  const Eigen::Vector2d normal_;
  double tangent_ = 0.0;  // of the camera's ray with the vertical, outwards
  double stddev_ = 0.0;   // of the move that was measured
};

}  // namespace

void moveOntoFaces(const std::vector<EdgeSample>& samples, const FitScale& scale, FitBuffers& buffers,
                   RectangleFit& fit) {
  std::array<std::optional<double>, 4> faces;
  double sum = 0.0;
  double measured = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    Side side(scale, buffers, fit, i);
    if (fit.sides[i].found && side.inView()) faces[i] = side.faceBeyond(samples);
    if (!faces[i]) continue;
    sum += *faces[i];
    measured += 1.0;
  }
  // A round shows on all sides alike.
  const bool round = measured > 0.0 && sum / measured > kLeastMove + kLeastShare * scale.bend_m;
  if (round) fit.rounding_m = radiusOf(sum / measured, scale.bend_m);
  if (measured > 0.0 && !round) return;
  for (std::size_t i = 0; i < 4; ++i) {
    Side side(scale, buffers, fit, i);
    if (!fit.sides[i].found) continue;
    auto beyond = side.faceBeyond(samples);
    const bool guessed = round && !faces[i];
    if (guessed) beyond = side.restOfRound(samples, fit.rounding_m);
    if (!beyond || !side.move(*beyond, guessed ? kGuessedShare : kUncertainShare) || round) continue;
    fit.rounding_m = std::max(fit.rounding_m, radiusOf(*beyond, scale.bend_m));
  }
}

}  // namespace mixed_palletizing::detection
