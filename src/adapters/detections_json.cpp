#include <utility>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/adapters/detections_json.hpp>

namespace mixed_palletizing::adapters {
namespace {

using Json = nlohmann::json;

Json toJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

template <typename Matrix>
Json rowsOf(const Matrix& matrix) {
  Json rows = Json::array();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    Json cells = Json::array();
    for (Eigen::Index col = 0; col < matrix.cols(); ++col) cells.push_back(matrix(row, col));
    rows.push_back(cells);
  }
  return rows;
}

Json toJson(std::size_t id, const detection::DetectedBox& box) {
  Json json;
  json["id"] = id;
  json["center"] = toJson(box.center);
  json["top_center"] = toJson(box.top_center);
  json["top_normal"] = toJson(box.top_normal);
  json["yaw"] = box.yaw_rad;
  json["size"] = toJson(box.size);
  json["size_stddev"] = toJson(box.size_stddev);
  json["pose_covariance"] = rowsOf(box.pose_covariance);
  json["top_visibility"] = box.top_visibility;
  json["point_count"] = box.point_count;
  json["flags"] = flagNames(box.flags);
  return json;
}

Json toJson(const detection::RejectedCluster& cluster) {
  Json json;
  json["reason"] = detection::toString(cluster.reason);
  json["text"] = cluster.text;
  json["centroid"] = toJson(cluster.centroid);
  json["extent"] = toJson(cluster.extent);
  return json;
}

}  // namespace

std::vector<std::string> flagNames(std::uint8_t flags) {
  const std::vector<std::pair<std::uint8_t, const char*>> names = {
      {detection::kOccluded, "OCCLUDED"},     {detection::kTruncated, "TRUNCATED"},
      {detection::kTouching, "TOUCHING"},     {detection::kUnevenTop, "UNEVEN_TOP"},
      {detection::kIncomplete, "INCOMPLETE"}, {detection::kHeightUnknown, "HEIGHT_UNKNOWN"}};
  std::vector<std::string> set;
  for (const auto& name : names) {
    if ((flags & name.first) != 0) set.emplace_back(name.second);
  }
  return set;
}

std::string detectionsJson(const geometry::Pose& base_from_camera, const detection::Detections& detections,
                           double total_ms) {
  Json json;
  json["base_from_camera"] = rowsOf(base_from_camera.matrix());
  json["cloud"] = {
      {"width", detections.width}, {"height", detections.height}, {"valid_ratio", detections.valid_ratio}};
  json["boxes"] = Json::array();
  for (std::size_t i = 0; i < detections.boxes.size(); ++i) {
    json["boxes"].push_back(toJson(i, detections.boxes[i]));
  }
  json["rejected"] = Json::array();
  for (const detection::RejectedCluster& cluster : detections.rejected) {
    json["rejected"].push_back(toJson(cluster));
  }
  json["timings_ms"] = Json::object();
  for (const detection::StageTime& time : detections.stage_times) {
    json["timings_ms"][time.stage] = time.milliseconds;
  }
  json["timings_ms"]["total"] = total_ms;
  return json.dump(1);
}

}  // namespace mixed_palletizing::adapters
