#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/experiments/top_measurement.hpp>

namespace mixed_palletizing::experiments {
namespace {

using nlohmann::json;

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / M_PI;
constexpr double kShownDepth = 0.02;  // of the slices below the height [m]

double distanceTo(const TrueBox& box, const detection::TopStudy& study) {
  return (box.top_center.head<2>() - study.centroid.head<2>()).norm();
}

/// Errors of a rectangle as those of a detection.
BoxErrors errorsOf(const TrueBox& truth, const geometry::Rectangle& rectangle) {
  detection::DetectedBox box;
  box.top_center = Eigen::Vector3d(rectangle.center.x(), rectangle.center.y(), truth.top_center.z());
  box.yaw_rad = rectangle.yaw_rad;
  box.size = Eigen::Vector3d(rectangle.size.x(), rectangle.size.y(), truth.size.z());
  return boxErrors(truth, box, geometry::Pose::Identity(), geometry::Pose::Identity());
}

json sizeErrors(const TrueBox& truth, const geometry::Rectangle& rectangle) {
  const BoxErrors errors = errorsOf(truth, rectangle);
  return {{"length_mm", kMillimetres * errors.error[kLength]},
          {"width_mm", kMillimetres * errors.error[kWidth]},
          {"yaw_deg", kDegrees * errors.error[kYaw]}};
}

json toJson(const TrueBox& truth, const detection::TopStudy& study, const detection::TopVariant& variant) {
  json out = {{"threshold_mm", kMillimetres * variant.threshold_m},
              {"depth_mm", kMillimetres * (study.height_m - variant.low_m)},
              {"points", variant.points},
              {"sides", variant.sides},
              {"edge_angle_deg", kDegrees * variant.edge_angle_rad},
              {"centroid_error_mm", kMillimetres * (variant.centroid - truth.top_center.head<2>()).norm()},
              {"center_error_mm", nullptr},
              {"sizes", nullptr}};
  if (!variant.sizes) return out;
  const Eigen::Vector2d shift = variant.sizes->along_yaw.center - truth.top_center.head<2>();
  out["center_error_mm"] = kMillimetres * shift.norm();
  out["sizes"] = {{"by_offsets", sizeErrors(truth, variant.sizes->by_offsets)},
                  {"along_yaw", sizeErrors(truth, variant.sizes->along_yaw)},
                  {"smallest_sum", sizeErrors(truth, variant.sizes->smallest_sum)}};
  return out;
}

json slicesOf(const detection::TopStudy& study) {
  json slices = json::array();
  const double lowest = std::max(0.0, study.height_m - kShownDepth);
  for (auto i = static_cast<std::size_t>(lowest / study.slice_m); i < study.slices.size(); ++i) {
    const double upper = static_cast<double>(i + 1) * study.slice_m;
    slices.push_back(json::array({kMillimetres * (study.height_m - upper), study.slices[i]}));
  }
  return slices;
}

}  // namespace

std::vector<TopRecord> measureTops(const SceneSource& source, std::uint64_t index,
                                   const detection::DetectionOptions& options,
                                   const std::vector<double>& thresholds_m) {
  const simulation::Scene scene = source.scene(index);
  const simulation::Capture capture = simulation::capture(scene, source.noise_seed(index));
  const std::vector<TrueBox> truth = trueBoxes(scene, capture);
  const geometry::Pose base_from_camera = trueBaseFromCamera(scene);
  std::vector<TopRecord> records;
  for (const detection::TopStudy& study :
       detection::studyTops(capture.cloud.view(), base_from_camera, options, thresholds_m)) {
    const auto nearest = std::min_element(
        truth.begin(), truth.end(),
        [&](const TrueBox& a, const TrueBox& b) { return distanceTo(a, study) < distanceTo(b, study); });
    if (nearest == truth.end() || !nearest->counts()) continue;
    if (distanceTo(*nearest, study) > 0.5 * nearest->size.y()) continue;
    TopRecord record;
    record.scene = index;
    record.truth = *nearest;
    record.study = study;
    record.center_px = projectedPoint(scene, base_from_camera, nearest->top_center);
    record.centroid_px = record.center_px;
    if (!study.variants.empty()) {
      const Eigen::Vector2d& centroid = study.variants.front().centroid;
      record.centroid_px =
          projectedPoint(scene, base_from_camera, {centroid.x(), centroid.y(), study.height_m});
    }
    records.push_back(record);
  }
  return records;
}

std::string topJson(const TopRecord& record) {
  const Eigen::Vector3d& size = record.truth.size;
  const Eigen::Vector3d& center = record.truth.top_center;
  json out = {{"scene", record.scene},
              {"truth",
               {{"size", {size.x(), size.y(), size.z()}},
                {"top_center", {center.x(), center.y(), center.z()}},
                {"visible_ratio", record.truth.visible_ratio},
                {"center_px", {record.center_px.x(), record.center_px.y()}}}},
              {"centroid_px", {record.centroid_px.x(), record.centroid_px.y()}},
              {"reference", record.study.reference},
              {"slices", slicesOf(record.study)},
              {"variants", json::array()}};
  for (const detection::TopVariant& variant : record.study.variants) {
    out["variants"].push_back(toJson(record.truth, record.study, variant));
  }
  return out.dump();
}

}  // namespace mixed_palletizing::experiments
