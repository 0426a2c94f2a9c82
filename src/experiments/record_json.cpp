#include <cmath>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/experiments/record_json.hpp>

namespace mixed_palletizing::experiments {
namespace {

using nlohmann::json;

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / M_PI;

json toJson(const Eigen::Vector3d& v) { return json::array({v.x(), v.y(), v.z()}); }

json toJson(const std::array<Eigen::Vector2d, 4>& corners) {
  json points = json::array();
  for (const Eigen::Vector2d& corner : corners) points.push_back(json::array({corner.x(), corner.y()}));
  return points;
}

json toJson(const TrueBox& box) {
  return {{"top_center", toJson(box.top_center)},
          {"size", toJson(box.size)},
          {"yaw", box.yaw_rad},
          {"visible_ratio", box.visible_ratio},
          {"measured_ratio", box.measured_ratio},
          {"truncated", box.truncated},
          {"counts", box.counts()},
          {"corners_px", toJson(box.corners_px)}};
}

json toJson(const detection::DetectedBox& box, const std::array<Eigen::Vector2d, 4>& corners) {
  json flags = json::array();
  if (box.flags & detection::kOccluded) flags.push_back("OCCLUDED");
  if (box.flags & detection::kTruncated) flags.push_back("TRUNCATED");
  if (box.flags & detection::kTouching) flags.push_back("TOUCHING");
  if (box.flags & detection::kUnevenTop) flags.push_back("UNEVEN_TOP");
  if (box.flags & detection::kIncomplete) flags.push_back("INCOMPLETE");
  if (box.flags & detection::kHeightUnknown) flags.push_back("HEIGHT_UNKNOWN");
  return {
      {"top_center", toJson(box.top_center)}, {"size", toJson(box.size)}, {"yaw", box.yaw_rad},
      {"top_visibility", box.top_visibility}, {"flags", flags},           {"corners_px", toJson(corners)}};
}

json byQuantity(const std::array<double, kQuantityCount>& values) {
  json out;
  for (std::size_t i = 0; i < kQuantityCount; ++i) {
    const auto quantity = static_cast<Quantity>(i);
    out[toString(quantity)] = values[i] * (quantity == kYaw ? kDegrees : kMillimetres);
  }
  return out;
}

json toJson(const ErrorStatistics& s) {
  return {{"count", s.count}, {"mean", s.mean},   {"rms", s.rms},   {"median", s.median},
          {"p95", s.p95},     {"worst", s.worst}, {"bias", s.bias}, {"stddev", s.stddev}};
}

}  // namespace

std::string recordJson(const SceneRecord& record) {
  json out;
  out["scene"] = record.index;
  out["base"] = {{"found", record.base_found},
                 {"message", record.base_message},
                 {"origin_mm", toJson(Eigen::Vector3d(kMillimetres * record.base.origin_m))},
                 {"tilt_deg", kDegrees * record.base.tilt_rad},
                 {"yaw_deg", kDegrees * record.base.yaw_rad}};
  out["boxes"] = json::array();
  for (std::size_t i = 0; i < record.boxes.size(); ++i) {
    const BoxRecord& box = record.boxes[i];
    json entry;
    entry["truth"] = toJson(box.truth);
    entry["found"] = nullptr;
    if (box.found) {
      entry["found"] = toJson(*box.found, record.found_corners_px[i]);
      entry["errors"] = byQuantity(box.errors.error);
      entry["stddevs"] = byQuantity(box.errors.stddev);
      entry["complete"] = box.errors.isComplete();
      entry["camera_error_mm"] = toJson(Eigen::Vector3d(kMillimetres * box.errors.camera_error_m));
      entry["camera_turn_deg"] = toJson(Eigen::Vector3d(kDegrees * box.errors.camera_turn_rad));
    }
    out["boxes"].push_back(entry);
  }
  out["invented"] = json::array();
  for (std::size_t i = 0; i < record.invented.size(); ++i) {
    out["invented"].push_back(toJson(record.invented[i], record.invented_corners_px[i]));
  }
  out["refusals"] = record.refusals;
  out["base_ms"] = record.base_ms;
  out["detect_ms"] = record.detect_ms;
  return out.dump();
}

std::string summaryJson(const DetectionSummary& s) {
  json out = {{"scenes", s.scenes},
              {"boxes", s.boxes},
              {"found", s.found},
              {"invented", s.invented},
              {"incomplete", s.incomplete},
              {"recall", s.recall()},
              {"precision", s.precision()},
              {"position_mm", toJson(s.position_mm)},
              {"yaw_deg", toJson(s.yaw_deg)},
              {"side_mm", toJson(s.side_mm)},
              {"height_mm", toJson(s.height_mm)},
              {"coverage", s.coverage},
              {"confident_wrong_sizes", s.confident_wrong_sizes},
              {"sizes_beyond_stddev", s.sizes_beyond_stddev},
              {"truncated", s.truncated},
              {"truncated_found", s.truncated_found},
              {"truncated_flagged", s.truncated_flagged},
              {"base_found", s.base_found},
              {"base_origin_mm", toJson(s.base_origin_mm)},
              {"base_height_mm", toJson(s.base_height_mm)},
              {"base_tilt_deg", toJson(s.base_tilt_deg)},
              {"base_yaw_deg", toJson(s.base_yaw_deg)},
              {"detect_ms", toJson(s.detect_ms)},
              {"base_ms", toJson(s.base_ms)},
              {"worst_scene", s.worst_scene}};
  for (std::size_t i = 0; i < kQuantityCount; ++i) {
    out["within_2_stddev"][toString(static_cast<Quantity>(i))] = s.within_2_stddev[i];
  }
  return out.dump();
}

}  // namespace mixed_palletizing::experiments
