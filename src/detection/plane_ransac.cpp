#include "plane_ransac.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_plane.h>

#include "quiet_pcl.hpp"

namespace mixed_palletizing::detection {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;

constexpr std::size_t kSubset = 20000;    // points that hypotheses are counted on
constexpr int kRounds = 6;                // of least squares
constexpr double kSigmas = 3.0;           // inlier distance over the spread
constexpr double kLookSigmas = 2.5;       // inlier distances within which the spread is measured
constexpr double kSmallestShare = 0.25;   // of the option: the inlier distance never falls below
constexpr double kLargestShare = 6.0;     // of the option: nor does it rise above
constexpr double kTakenDistances = 2.0;   // inlier distances within which points are gone for the next plane
constexpr double kNormalMedian = 0.6745;  // median of |x| for a standard normal x

bool measured(const Eigen::Vector3f& p) {
  return p.z() > 0.0f && std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

/// Calls visit(point) for every point with data; returns their number.
template <typename Visit>
std::size_t forEachPoint(const geometry::CloudView& cloud, Visit visit) {
  std::size_t count = 0;
  for (int row = 0; row < cloud.height; ++row) {
    for (int col = 0; col < cloud.width; ++col) {
      const Eigen::Vector3f p = cloud.point(row, col);
      if (!measured(p)) continue;
      ++count;
      visit(p);
    }
  }
  return count;
}

/// Every n-th point with data, in an order drawn from the seed.
Points::Ptr drawSubset(const geometry::CloudView& cloud, std::size_t valid, int seed) {
  Points::Ptr subset(new Points);
  const std::size_t stride = std::max<std::size_t>(1, valid / kSubset);
  std::mt19937 rng(static_cast<std::mt19937::result_type>(seed));
  std::size_t index = rng() % stride;
  forEachPoint(cloud, [&](const Eigen::Vector3f& p) {
    if (index++ % stride == 0) subset->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  });
  std::shuffle(subset->begin(), subset->end(), rng);
  return subset;
}

/// Best plane of the subset; PCL stops by eq. 3.4.
std::optional<geometry::Plane> sampleConsensus(const Points::Ptr& subset, const PlaneOptions& options) {
  if (subset->size() < 3) return std::nullopt;
  const QuietPcl quiet;
  const pcl::SampleConsensusModelPlane<pcl::PointXYZ>::Ptr model(
      new pcl::SampleConsensusModelPlane<pcl::PointXYZ>(subset));
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, options.distance_m);
  ransac.setProbability(options.probability);
  ransac.setMaxIterations(options.max_iterations);
  if (!ransac.computeModel()) return std::nullopt;
  Eigen::VectorXf coefficients;
  ransac.getModelCoefficients(coefficients);
  const Eigen::Vector4d c = coefficients.cast<double>();
  const double length = c.head<3>().norm();
  if (!(length > 0.0) || !c.allFinite()) return std::nullopt;
  return geometry::Plane{c.head<3>() / length, c.w() / length};
}

/// Robust standard deviation of the subset's distances below `reach`.
double spread(const Points& subset, const geometry::Plane& plane, double reach) {
  std::vector<double> distances;
  for (const pcl::PointXYZ& p : subset) {
    const double d = std::abs(plane.signedDistance(p.getVector3fMap().cast<double>()));
    if (d < reach) distances.push_back(d);
  }
  if (distances.empty()) return 0.0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle / kNormalMedian;
}

/// True for points that belong to one of the planes found before.
bool taken(const Eigen::Vector3d& p, const std::vector<PlaneFit>& before) {
  return std::any_of(before.begin(), before.end(), [&](const PlaneFit& fit) {
    return std::abs(fit.plane.signedDistance(p)) < kTakenDistances * fit.distance_m;
  });
}

/// Least squares on all inliers, in rounds.
std::optional<PlaneFit> refine(const geometry::CloudView& cloud, const Points& subset, geometry::Plane plane,
                               const std::vector<PlaneFit>& before, const PlaneOptions& options) {
  PlaneFit fit;
  double distance = options.distance_m;
  for (int round = 0; round < kRounds; ++round) {
    distance = std::clamp(kSigmas * spread(subset, plane, kLookSigmas * distance),
                          kSmallestShare * options.distance_m, kLargestShare * options.distance_m);
    geometry::PlaneAccumulator inliers;
    fit.valid = forEachPoint(cloud, [&](const Eigen::Vector3f& point) {
      const Eigen::Vector3d p = point.cast<double>();
      if (std::abs(plane.signedDistance(p)) < distance && !taken(p, before)) inliers.add(p);
    });
    fit.inliers = inliers.count();
    try {
      const geometry::PlaneAccumulator::Fit best = inliers.fit();
      plane = best.plane;
      fit.rms_m = best.rms_m;
      fit.centroid = best.centroid;
    } catch (const std::invalid_argument&) {
      return std::nullopt;  // too few inliers, or all on one line
    }
  }
  fit.distance_m = distance;
  fit.plane = plane.facing(Eigen::Vector3d::Zero());
  return fit;
}

/// The points of the subset that no plane has taken.
Points::Ptr without(const Points& subset, const std::vector<PlaneFit>& planes) {
  Points::Ptr left(new Points);
  for (const pcl::PointXYZ& p : subset) {
    if (!taken(p.getVector3fMap().cast<double>(), planes)) left->push_back(p);
  }
  return left;
}

}  // namespace

PlanesResult findPlanes(const geometry::CloudView& cloud, const PlaneOptions& options) {
  PlanesResult result;
  const std::size_t valid = forEachPoint(cloud, [](const Eigen::Vector3f&) {});
  std::ostringstream message;
  message << "no floor plane: ";
  if (valid < 3) {
    message << "the cloud of " << cloud.width << " x " << cloud.height << " has " << valid
            << " points with data";
    result.message = message.str();
    return result;
  }
  Points::Ptr left = drawSubset(cloud, valid, options.seed);
  while (static_cast<int>(result.fits.size()) < options.max_planes) {
    const auto plane = sampleConsensus(left, options);
    const auto fit = plane ? refine(cloud, *left, *plane, result.fits, options) : std::nullopt;
    const double share = fit ? static_cast<double>(fit->inliers) / static_cast<double>(valid) : 0.0;
    if (!fit || share < options.min_inlier_ratio) {
      if (!fit) message << "the " << valid << " points with data hold no plane";
      if (fit) {
        message << "the largest plane holds " << 100.0 * share << " % of the " << valid
                << " points with data, less than " << 100.0 * options.min_inlier_ratio << " %";
      }
      break;
    }
    result.fits.push_back(*fit);
    left = without(*left, result.fits);
  }
  if (result.fits.empty()) result.message = message.str();
  return result;
}

}  // namespace mixed_palletizing::detection
