#include <cmath>
#include <set>
#include <sstream>

#include <mixed_palletizing/detection/options.hpp>

#include "marker_dictionary.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr int kMostPlanes = 20;

/// Collects broken rules about numbers.
class Rules {
 public:
  template <typename T>
  void positive(const char* key, T value) {
    if (!(value > T(0)) || !std::isfinite(static_cast<double>(value))) add(key, value, "must be positive");
  }

  void atLeast(const char* key, double value, double limit) {
    if (!(value >= limit) || !std::isfinite(value)) add(key, value, "must be at least ", limit);
  }

  void inside(const char* key, double value, double low, double high) {
    if (!(value > low && value < high)) add(key, value, "must lie between ", low, " and ", high);
  }

  template <typename... Words>
  void add(const char* key, const Words&... words) {
    std::ostringstream line;
    line << key << ": ";
    (line << ... << words);
    lines_.push_back(line.str());
  }

  template <typename T, typename... Words>
  std::enable_if_t<std::is_arithmetic_v<T>> add(const char* key, T value, const Words&... words) {
    std::ostringstream line;
    line << key << ": " << value << ' ';
    (line << ... << words);
    lines_.push_back(line.str());
  }

  void addLine(const std::string& line) { lines_.push_back(line); }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

void checkPlanes(const PlaneOptions& plane, Rules& rules) {
  rules.atLeast("plane.max_planes", plane.max_planes, 1);
  if (plane.max_planes > kMostPlanes)
    rules.add("plane.max_planes", plane.max_planes, "is more than ", kMostPlanes);
  const bool needs_more = plane.floor != FloorChoice::kLargest || plane.remove != RemovedPlanes::kNone;
  if (needs_more && plane.max_planes < 2) {
    rules.add("plane.max_planes", plane.max_planes,
              "must be at least 2 to choose a floor or to remove others");
  }
  if (plane.floor == FloorChoice::kCameraHeight)
    rules.positive("plane.camera_height_m", plane.camera_height_m);
}

void checkBoard(const MarkerOptions& marker, int dictionary_size, Rules& rules) {
  std::set<int> ids;
  for (const BoardMarker& place : marker.board) {
    if (place.id < 0 || place.id >= dictionary_size) {
      rules.add("marker.board", place.id, "is not in ", marker.dictionary);
    }
    if (!ids.insert(place.id).second) rules.add("marker.board", place.id, "is there twice");
    if (!std::isfinite(place.x_m) || !std::isfinite(place.y_m) || !std::isfinite(place.yaw_rad)) {
      rules.add("marker.board", place.id, "has a place that is not finite");
    }
  }
}

void checkCalibration(const DetectionOptions& options, Rules& rules) {
  rules.positive("plane.distance_m", options.plane.distance_m);
  rules.inside("plane.probability", options.plane.probability, 0.0, 1.0);
  rules.positive("plane.max_iterations", options.plane.max_iterations);
  rules.inside("plane.min_inlier_ratio", options.plane.min_inlier_ratio, 0.0, 1.0);
  checkPlanes(options.plane, rules);
  rules.atLeast("marker.id", options.marker.id, 0);
  rules.atLeast("marker.side_m", options.marker.side_m, 0.0);
  rules.positive("marker.max_board_error_m", options.marker.max_board_error_m);
  const auto size = dictionarySize(options.marker.dictionary);
  if (!size) {
    rules.add("marker.dictionary", "'", options.marker.dictionary, "' is no predefined dictionary of OpenCV");
  } else if (options.marker.id >= *size) {
    rules.add("marker.id", options.marker.id, "is not in ", options.marker.dictionary, ", which has ", *size,
              " markers");
  }
  if (size) checkBoard(options.marker, *size, rules);
}

void checkTop(const TopOptions& top, Rules& rules) {
  rules.positive("top.height_patch_radius_m", top.height_patch_radius_m);
  rules.atLeast("top.slice_m", top.slice_m, 1e-5);  // the height profile has a count for each
  rules.positive("top.search_depth_m", top.search_depth_m);
  if (top.search_depth_m < top.slice_m) {
    rules.add("top.search_depth_m", top.search_depth_m, "is less than top.slice_m");
  }
  rules.atLeast("top.slice_ratio", top.slice_ratio, 1.0);
  rules.positive("top.min_edge_length_m", top.min_edge_length_m);
  rules.inside("top.new_edge_angle_rad", top.new_edge_angle_rad, 0.0, M_PI / 2);
  rules.inside("top.merge_angle_rad", top.merge_angle_rad, 0.0, M_PI / 2);
  if (top.merge_angle_rad >= top.new_edge_angle_rad) {
    rules.add("top.merge_angle_rad", top.merge_angle_rad, "must be smaller than top.new_edge_angle_rad");
  }
  rules.positive("top.uneven_m", top.uneven_m);
}

}  // namespace

std::vector<std::string> problems(const DetectionOptions& options) {
  Rules rules;
  checkCalibration(options, rules);
  rules.atLeast("noise.sigmas", options.noise.sigmas, 0.0);
  rules.atLeast("noise.spacings", options.noise.spacings, 0.0);
  rules.positive("cluster.min_height_m", options.cluster.min_height_m);
  if (!(options.cluster.max_height_m > options.cluster.min_height_m) || options.cluster.max_height_m > 20.0) {
    rules.add("cluster.max_height_m", options.cluster.max_height_m,
              "must lie between cluster.min_height_m and 20");
  }
  rules.positive("cluster.neighbor_distance_m", options.cluster.neighbor_distance_m);
  rules.atLeast("cluster.min_points", options.cluster.min_points, 4);
  checkTop(options.top, rules);
  rules.positive("box.min_side_m", options.box.min_side_m);
  if (!(options.box.max_side_m > options.box.min_side_m) || !std::isfinite(options.box.max_side_m)) {
    rules.add("box.max_side_m", options.box.max_side_m, "must be larger than box.min_side_m");
  }
  rules.inside("box.min_rectangularity", options.box.min_rectangularity, 0.0, 1.0);
  rules.inside("box.min_outline_ratio", options.box.min_outline_ratio, 0.0, 1.0);
  rules.atLeast("box.touching_distance_m", options.box.touching_distance_m, 0.0);
  rules.inside("stack.max_slope_rad", options.stack.max_slope_rad, 0.0, M_PI / 4);
  rules.positive("stack.step_m", options.stack.step_m);
  rules.atLeast("stack.min_height_m", options.stack.min_height_m, 0.0);
  for (const std::string& line : problems(options.region)) rules.addLine("region." + line);
  return rules.take();
}

}  // namespace mixed_palletizing::detection
