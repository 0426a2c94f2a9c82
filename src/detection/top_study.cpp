#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/detection/top_study.hpp>

#include "clusters.hpp"
#include "edge_sizes.hpp"
#include "height.hpp"
#include "outline.hpp"
#include "top_plane.hpp"

namespace mixed_palletizing::detection {
namespace {

void requireSound(const DetectionOptions& options) {
  std::string text;
  for (const std::string& line : problems(options)) text += "\n  " + line;
  if (!text.empty()) throw std::invalid_argument("studyTops: options:" + text);
}

Eigen::Vector2d centroidOf(const BaseCloud& cloud, const RunRange& top) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Run& run : top) {
    for (int col = run.begin; col < run.end; ++col) sum += cloud.point(run.row, col).head<2>().cast<double>();
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, pixelCount(top)));
}

/// Runs the stages after the clusters; keeps their buffers.
class Study {
 public:
  Study(const BaseCloud& cloud, const DetectionOptions& options, const SensorNoise& noise)
      : cloud_(cloud), options_(options), noise_(noise) {}

  std::optional<TopVariant> variant(const RunRange& cluster, const TopLevel& level, const TopBand& band,
                                    double threshold_m) {
    const auto piece = findTopPiece(cloud_, cluster, band, pieces_);
    if (!piece) return std::nullopt;
    const RunRange top = pieces_.component(*piece);
    TopVariant variant;
    variant.threshold_m = threshold_m;
    variant.low_m = band.low_m;
    variant.points = pixelCount(top);
    variant.centroid = centroidOf(cloud_, top);
    tracer_.trace(cloud_, top, level.height_m, band, options_.top.search_depth_m, outline_);
    points_.clear();
    for (const OutlineSample& sample : outline_) points_.push_back(sample.measured);
    const std::vector<Edge> edges = findEdges(convexHull(points_), leastEdge(variant.centroid), options_.top);
    if (edges.empty()) return variant;
    const EdgeSides sides = pickSides(edges);
    variant.sides = static_cast<int>(
        std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.has_value(); }));
    variant.edge_angle_rad = largestEdgeAngle(sides);
    variant.sizes = sizesFromEdges(sides);
    return variant;
  }

 private:
  double leastEdge(const Eigen::Vector2d& centroid) const {
    const Eigen::Vector3d camera = cloud_.camera();
    const double depth = std::hypot((camera.head<2>() - centroid).norm(), camera.z());
    return std::max(options_.top.min_edge_length_m, 2.0 * options_.noise.spacings * noise_.spacing(depth));
  }

  const BaseCloud& cloud_;
  const DetectionOptions& options_;
  const SensorNoise& noise_;
  RunForest pieces_;
  OutlineTracer tracer_;
  std::vector<OutlineSample> outline_;
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace

std::vector<TopStudy> studyTops(const geometry::CloudView& view, const geometry::Pose& base_from_camera,
                                const DetectionOptions& options, const std::vector<double>& thresholds_m) {
  requireSound(options);
  const BaseCloud cloud(view, base_from_camera);
  const SensorNoise noise = measureNoise(cloud, options.cluster.min_height_m);
  const ClusterLimits limits(options, noise, cloud);
  RunForest clusters;
  findClusters(cloud, limits, clusters);
  Study study(cloud, options, noise);
  const double window = std::max(4.0 * options.top.slice_m, options.noise.sigmas * noise.floor_stddev_m);
  std::vector<TopStudy> studies;
  ClusterShape shape;
  for (std::size_t i = 0; i < clusters.componentCount(); ++i) {
    const RunRange cluster = clusters.component(i);
    if (pixelCount(cluster) < static_cast<std::size_t>(options.cluster.min_points)) continue;
    measureShape(cloud, cluster, options.top.slice_m, shape);
    const auto patch = patchHeight(cloud, cluster, shape, options.top.height_patch_radius_m);
    const TopLevel level = findTopLevel(shape.profile, patch, static_cast<double>(limits.low_m), window);
    const auto adaptive = separateTop(shape.profile, level, options);
    if (!adaptive) continue;
    TopStudy result{shape.centroid,       level.height_m,     shape.profile.slice_m,
                    shape.profile.counts, level.side_density, {}};
    if (const auto v = study.variant(cluster, level, *adaptive, 0.0)) result.variants.push_back(*v);
    for (const double threshold : thresholds_m) {
      const TopBand band{level.height_m - threshold, level.height_m + threshold};
      if (const auto v = study.variant(cluster, level, band, threshold)) result.variants.push_back(*v);
    }
    studies.push_back(result);
  }
  return studies;
}

}  // namespace mixed_palletizing::detection
