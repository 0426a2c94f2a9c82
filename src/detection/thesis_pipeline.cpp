// The chain of thesis 3.2.2 and 3.2.3, one file per stage:
//   sensor_noise        how far thresholds must be raised for this sensor
//   clusters            plane removal along z and connected components (eq. 3.8), one pass over the cloud
//   cluster_shape,      height of each cluster (3.2.2 "Height calculation")
//   height
//   top_plane           adaptive separation of the top (3.2.2 "Top-plane separation")
//   outline, hull_edges convex hull and edges (Algorithms 1 and 2)
//   rectangle_from_edges  position, yaw, size (3.2.3), then rectangle_fit beyond the thesis
//   uncertainty, top_surface, top_visibility  what the rectangle is worth
#include <algorithm>
#include <string>

#include "box_candidate.hpp"
#include "clusters.hpp"
#include "detection_pipeline.hpp"

namespace mixed_palletizing::detection {
namespace {

// Components smaller than this share of the smallest cluster are stray points, not even worth a reason.
constexpr int kStrayDivisor = 4;

void addRuns(const RunRange& runs, int width, std::vector<std::uint32_t>& pixels) {
  for (const Run& run : runs) {
    for (int col = run.begin; col < run.end; ++col)
      pixels.push_back(static_cast<std::uint32_t>(run.row * width + col));
  }
}

/// Pixels of the stages, for debugging.
struct Stages {
  StagePixels floor{"floor", {}};
  StagePixels clusters{"clusters", {}};
  StagePixels tops{"tops", {}};
  StagePixels edges{"edges", {}};
};

void addFloor(const BaseCloud& cloud, float low_m, StagePixels& stage) {
  for (int row = 0; row < cloud.height(); ++row) {
    for (int col = 0; col < cloud.width(); ++col) {
      if (!cloud.valid(row, col) || cloud.point(row, col).z() > low_m) continue;
      stage.pixels.push_back(static_cast<std::uint32_t>(row * cloud.width() + col));
    }
  }
}

void flagTouching(const std::vector<geometry::Rectangle>& footprints, double distance_m,
                  std::vector<DetectedBox>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = i + 1; k < boxes.size(); ++k) {
      if (geometry::distance(footprints[i], footprints[k]) > distance_m) continue;
      boxes[i].flags = static_cast<std::uint8_t>(boxes[i].flags | kTouching);
      boxes[k].flags = static_cast<std::uint8_t>(boxes[k].flags | kTouching);
    }
  }
}

/// A side face seen at a flat angle falls into clusters of its own: they are parts of the box above, not refused
/// things.
void forgetParts(const std::vector<geometry::Rectangle>& footprints, double margin_m, Detections& result) {
  const auto is_part = [&](const RejectedCluster& cluster) {
    for (std::size_t i = 0; i < footprints.size(); ++i) {
      if (cluster.centroid.z() < result.boxes[i].size.z() &&
          footprints[i].contains(cluster.centroid.head<2>(), margin_m)) {
        return true;
      }
    }
    return false;
  };
  result.rejected.erase(std::remove_if(result.rejected.begin(), result.rejected.end(), is_part),
                        result.rejected.end());
}

class ThesisPipeline : public DetectionPipeline {
 public:
  explicit ThesisPipeline(const DetectionOptions& options) : options_(options), candidate_(options_) {}

  Detections detect(const geometry::CloudView& view, const geometry::Pose& base_from_camera,
                    bool keep_stages) override {
    StageClock clock;
    const BaseCloud cloud(view, base_from_camera);
    Detections result;
    result.width = view.width;
    result.height = view.height;
    result.labels.assign(view.size(), 0);
    const SensorNoise noise = measureNoise(cloud, options_.cluster.min_height_m);
    clock.done("noise");
    const ClusterLimits limits(options_, noise, cloud);
    const std::size_t valid = findClusters(cloud, limits, clusters_);
    result.valid_ratio = static_cast<double>(valid) / static_cast<double>(view.size());
    clock.done("clusters");
    Stages stages;
    footprints_.clear();
    for (std::size_t i = 0; i < clusters_.componentCount(); ++i) {
      examine(cloud, base_from_camera, noise, limits, clusters_.component(i), clock, result,
              keep_stages ? &stages : nullptr);
    }
    flagTouching(footprints_, options_.box.touching_distance_m + 2.0 * noise.floor_stddev_m, result.boxes);
    forgetParts(footprints_, static_cast<double>(limits.distance_m), result);
    if (keep_stages) {
      addFloor(cloud, limits.low_m, stages.floor);
      result.stage_pixels = {stages.floor, stages.clusters, stages.tops, stages.edges};
    }
    result.stage_times = clock.times();
    return result;
  }

 private:
  void examine(const BaseCloud& cloud, const geometry::Pose& base_from_camera, const SensorNoise& noise,
               const ClusterLimits& limits, const RunRange& cluster, StageClock& clock, Detections& result,
               Stages* stages) {
    const std::size_t count = pixelCount(cluster);
    const auto min_points = static_cast<std::size_t>(options_.cluster.min_points);
    if (count < min_points / kStrayDivisor) return;
    measureShape(cloud, cluster, options_.top.slice_m, shape_);
    clock.done("shapes");
    if (count < min_points) {
      reject({RejectReason::kTooFewPoints,
              std::to_string(count) + " points, less than " + std::to_string(min_points)},
             result);
      return;
    }
    const auto outcome = candidate_.examine(cloud, base_from_camera, noise, static_cast<double>(limits.low_m),
                                            cluster, shape_, clock);
    if (stages != nullptr) {
      addRuns(cluster, cloud.width(), stages->clusters.pixels);
      addRuns(candidate_.top(), cloud.width(), stages->tops.pixels);
      for (const OutlineSample& sample : candidate_.outline()) {
        stages->edges.pixels.push_back(static_cast<std::uint32_t>(sample.row * cloud.width() + sample.col));
      }
    }
    if (const auto* refusal = std::get_if<Refusal>(&outcome)) {
      reject(*refusal, result);
      return;
    }
    FoundBox found = std::get<FoundBox>(outcome);
    label(cloud, cluster, limits, found, result);
    footprints_.push_back(found.footprint);
    result.boxes.push_back(found.box);
    clock.done("labels");
  }

  void reject(const Refusal& refusal, Detections& result) const {
    result.rejected.push_back({refusal.reason, refusal.text, shape_.centroid, shape_.extent()});
  }

  /// Labels the cluster's points inside the box and counts them; the rest of the cluster is something else.
  void label(const BaseCloud& cloud, const RunRange& cluster, const ClusterLimits& limits, FoundBox& found,
             Detections& result) const {
    const auto value = static_cast<std::uint16_t>(std::min<std::size_t>(result.boxes.size() + 1, UINT16_MAX));
    const Eigen::Vector2f center = found.footprint.center.cast<float>();
    const Eigen::Vector2f axis = found.footprint.axisX().cast<float>();
    const Eigen::Array2f reach = 0.5f * found.footprint.size.cast<float>().array() + limits.distance_m;
    const float top = static_cast<float>(found.top_m);
    for (const Run& run : cluster) {
      std::uint16_t* labels =
          result.labels.data() + static_cast<std::size_t>(run.row) * static_cast<std::size_t>(cloud.width());
      for (int col = run.begin; col < run.end; ++col) {
        const Eigen::Vector3f p = cloud.point(run.row, col);
        const Eigen::Vector2f d = p.head<2>() - center;
        const Eigen::Array2f local(d.dot(axis), axis.x() * d.y() - axis.y() * d.x());
        if (p.z() > top || (local.abs() > reach).any()) continue;
        labels[col] = value;
        ++found.box.point_count;
      }
    }
  }

  const DetectionOptions& options_;
  BoxCandidate candidate_;
  RunForest clusters_;
  ClusterShape shape_;
  std::vector<geometry::Rectangle> footprints_;
};

}  // namespace

std::unique_ptr<DetectionPipeline> makeThesisPipeline(const DetectionOptions& options) {
  return std::make_unique<ThesisPipeline>(options);
}

}  // namespace mixed_palletizing::detection
