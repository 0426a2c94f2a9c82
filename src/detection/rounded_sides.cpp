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
constexpr double kLeastMove = 0.00015;   // [m] a face that stands out less is the side itself ...
constexpr double kLeastShare = 0.06;     // ... and this share of the drop at which the surface ends
constexpr double kLargestMove = 0.012;   // [m]
constexpr double kLeastOpening = 0.2;    // 1 - sine of the flattest ray that tells a radius
constexpr double kLargestRadius = 0.03;  // [m]
constexpr double kUncertainShare =
    0.1;  // of the move onto a face that is seen, that a side remains uncertain by
constexpr double kGuessedShare = 0.2;   // the same of what is known by the radius only
constexpr double kPossibleShare = 1.0;  // of the move that an edge would need if it were round
constexpr double kRoundSigmas = 3.0;    // of the mean drop before a jump, that may be a round edge's
constexpr int kHalvings = 30;
constexpr double kNormalMedian = 0.6745;  // median of |x| for a standard normal x
constexpr double kCornerShare = 0.95;     // of a side

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// How far a round goes on beyond the place where it is `drop_m` below its begin.
double restOf(double radius_m, double drop_m) {
  const double d = std::clamp(drop_m, 0.0, radius_m);
  return radius_m - std::sqrt(d * (2.0 * radius_m - d));
}

/// What is seen of the face below a side.
struct Face {
  double beyond_m = 0.0;  ///< outwards from the end of the surface
  double drop_m = 0.0;    ///< of the place on it, below the surface
};

/// Radius of a round of which the surface ends `end_drop_m` below its begin, and goes on to the faces: to places that
/// are on the round themselves when they lie higher than its end.
double radiusOf(const std::array<std::optional<Face>, 4>& faces, double end_drop_m) {
  double low = 0.0;
  double high = kLargestRadius;
  for (int i = 0; i < kHalvings; ++i) {
    const double radius = 0.5 * (low + high);
    double missing = 0.0;
    for (const auto& face : faces) {
      if (face) missing += face->beyond_m - restOf(radius, end_drop_m) + restOf(radius, face->drop_m);
    }
    (missing > 0.0 ? low : high) = radius;
  }
  return 0.5 * (low + high);
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
  std::optional<Face> faceBeyond(const std::vector<EdgeSample>& samples) {
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
    const double drop = median(drops);
    return Face{middle + behindTheTangent(drop), drop};
  }

  /// The rest of a round of a known radius, behind where the surface ends: at a bend, or where a ray of the camera or
  /// of the projector touches the round.
  std::optional<double> restOfRound(const std::vector<EdgeSample>& samples, double radius_m) {
    if (!readEnds(samples)) return std::nullopt;
    if (bends_ > values_.size()) return restOf(radius_m, median(others_));
    const double drop = std::max(0.0, median(values_));
    return restOf(radius_m, drop) + drop * tangent_ - past_m_;
  }

  /// What may be missing of a side that ends at a jump, by the drop of its last pixels: those of a sharp edge lie on
  /// the surface.
  double possibleRest(const std::vector<EdgeSample>& samples) {
    if (!(tangent_ > 0.0) || !readEnds(samples) || bends_ > values_.size()) return 0.0;
    const double drop = median(values_);
    if (drop < kRoundSigmas * scale_.noise_m / std::sqrt(static_cast<double>(values_.size()))) return 0.0;
    const double sine = tangent_ / std::sqrt(1.0 + tangent_ * tangent_);
    const double radius = drop / std::max(1.0 - sine, kLeastOpening);
    return std::clamp(restOf(radius, drop) + drop * tangent_, 0.0, kLargestMove);
  }

  void doubt(double by_m) {
    SideFit& side = fit_.sides[side_];
    side.stddev_m = std::hypot(side.stddev_m, by_m);
  }

  /// Moves the side when that is more than the noise of the samples; returns whether it did. `doubt_m`: of the move.
  bool move(double by_m, double doubt_m) {
    if (by_m < kLeastMove + kLeastShare * scale_.bend_m || by_m < 4.0 * stddev_ || by_m > kLargestMove) {
      return false;
    }
    fit_.rectangle.center += 0.5 * by_m * normal_;
    fit_.rectangle.size(side_ % 2 == 0 ? 1 : 0) += by_m;
    doubt(stddev_ + doubt_m);
    return true;
  }

 private:
  bool isNear(const EdgeSample& s) const {
    if (s.outward.dot(normal_) < 0.3) return false;
    const Eigen::Vector2d local = axes_.local(s.place);
    return std::abs(kOutward[side_].dot(local) - halfAcross(fit_.rectangle, side_)) < kGate &&
           std::abs(alongOf(side_).dot(local)) < kCornerShare * halfAlong(fit_.rectangle, side_);
  }

  /// Drops of the last pixels before jumps into the values, of bends into the others; false for too few.
  bool readEnds(const std::vector<EdgeSample>& samples) {
    values_.clear();
    others_.clear();
    past_m_ = 0.0;
    for (const EdgeSample& s : samples) {
      if (s.beyond != Beyond::kDrop || !isNear(s)) continue;
      (s.bent ? others_ : values_).push_back(static_cast<double>(s.drop_m));
      if (!s.bent) past_m_ += 0.5 * static_cast<double>(s.pixel_m) * s.outward.dot(normal_);
    }
    bends_ = others_.size();
    past_m_ /= std::max(1.0, static_cast<double>(values_.size()));
    return values_.size() + bends_ >= kMinSamples;
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
  double past_m_ = 0.0;   // half a pixel: from the last pixels before jumps to the ends
  std::size_t bends_ = 0;
};

}  // namespace

void moveOntoFaces(const std::vector<EdgeSample>& samples, const FitScale& scale, FitBuffers& buffers,
                   RectangleFit& fit) {
  std::array<std::optional<Face>, 4> faces;
  double sum = 0.0;
  double measured = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    Side side(scale, buffers, fit, i);
    if (fit.sides[i].found && side.inView()) faces[i] = side.faceBeyond(samples);
    if (!faces[i]) continue;
    sum += faces[i]->beyond_m;
    measured += 1.0;
  }
  // A round shows on all sides alike.
  const bool round = measured > 0.0 && sum / measured > kLeastMove + kLeastShare * scale.bend_m;
  if (round) fit.rounding_m = radiusOf(faces, scale.bend_m);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!fit.sides[i].found) continue;
    Side side(scale, buffers, fit, i);
    if (round && faces[i]) {
      const Face face = side.faceBeyond(samples).value_or(*faces[i]);
      const double rest = restOf(fit.rounding_m, face.drop_m);
      side.move(face.beyond_m + rest, kUncertainShare * face.beyond_m + kGuessedShare * rest);
    } else if (round) {
      const auto rest = side.restOfRound(samples, fit.rounding_m);
      if (rest) side.move(*rest, kGuessedShare * *rest);
    } else if (measured > 0.0) {
      side.doubt(kPossibleShare * side.possibleRest(samples));
    } else if (const auto face = side.faceBeyond(samples)) {
      if (!side.move(face->beyond_m, kGuessedShare * face->beyond_m)) continue;
      fit.rounding_m = std::max(fit.rounding_m, radiusOf({face}, scale.bend_m));
    }
  }
}

}  // namespace mixed_palletizing::detection
