#include <mixed_palletizing/adapters/detection_options.hpp>

namespace mixed_palletizing::adapters {

const std::vector<std::pair<std::string, detection::Method>>& detectionMethods() {
  static const std::vector<std::pair<std::string, detection::Method>> words = {
      {"best", detection::Method::kBest}, {"thesis", detection::Method::kThesis}};
  return words;
}

const std::vector<std::pair<std::string, detection::Mode>>& detectionModes() {
  static const std::vector<std::pair<std::string, detection::Mode>> words = {
      {"palletize", detection::Mode::kPalletize}, {"depalletize", detection::Mode::kDepalletize}};
  return words;
}

namespace {

detection::BoardMarker readBoardMarker(OptionReader& reader) {
  detection::BoardMarker marker;
  reader.read("id", marker.id);
  reader.read("x_m", marker.x_m);
  reader.read("y_m", marker.y_m);
  reader.read("yaw_rad", marker.yaw_rad);
  return marker;
}

/// Planes as one list of numbers: normal x, y, z and offset of each.
void readPlanes(OptionReader& region, std::vector<geometry::Plane>& planes) {
  std::vector<double> flat;
  region.read("planes", flat);
  if (flat.size() % 4 != 0) {
    region.add({"planes: " + std::to_string(flat.size()) + " numbers; four are needed for each plane"});
    return;
  }
  for (std::size_t i = 0; i < flat.size(); i += 4) {
    planes.push_back({Eigen::Vector3d(flat[i], flat[i + 1], flat[i + 2]), flat[i + 3]});
  }
}

void readStackAndRegion(OptionReader& reader, detection::DetectionOptions& options) {
  OptionReader stack = reader.section("stack");
  stack.read("max_slope_rad", options.stack.max_slope_rad);
  stack.read("step_m", options.stack.step_m);
  stack.read("min_height_m", options.stack.min_height_m);
  OptionReader region = reader.section("region");
  region.read("polygon_m", options.region.polygon_m);
  region.read("min_z_m", options.region.min_z_m);
  region.read("max_z_m", options.region.max_z_m);
  readPlanes(region, options.region.planes);
  region.read("plane_distance_m", options.region.plane_distance_m);
}

}  // namespace

void readDetectionOptions(OptionReader& reader, detection::DetectionOptions& options) {
  reader.readWord("method", options.method, detectionMethods());
  reader.readWord("mode", options.mode, detectionModes());
  OptionReader plane = reader.section("plane");
  plane.read("distance_m", options.plane.distance_m);
  plane.read("probability", options.plane.probability);
  plane.read("max_iterations", options.plane.max_iterations);
  plane.read("min_inlier_ratio", options.plane.min_inlier_ratio);
  plane.read("seed", options.plane.seed);
  plane.read("max_planes", options.plane.max_planes);
  plane.readWord<detection::FloorChoice>("floor", options.plane.floor,
                                         {{"largest", detection::FloorChoice::kLargest},
                                          {"lowest", detection::FloorChoice::kLowest},
                                          {"marker", detection::FloorChoice::kMarker},
                                          {"camera_height", detection::FloorChoice::kCameraHeight}});
  plane.read("camera_height_m", options.plane.camera_height_m);
  plane.readWord<detection::RemovedPlanes>("remove", options.plane.remove,
                                           {{"none", detection::RemovedPlanes::kNone},
                                            {"upright", detection::RemovedPlanes::kUpright},
                                            {"all", detection::RemovedPlanes::kAll}});
  OptionReader marker = reader.section("marker");
  marker.read("dictionary", options.marker.dictionary);
  marker.read("id", options.marker.id);
  marker.read("inverted", options.marker.inverted);
  marker.read("side_m", options.marker.side_m);
  marker.read("max_board_error_m", options.marker.max_board_error_m);
  for (OptionReader place : marker.items("board")) options.marker.board.push_back(readBoardMarker(place));
  OptionReader noise = reader.section("noise");
  noise.read("sigmas", options.noise.sigmas);
  noise.read("spacings", options.noise.spacings);
  OptionReader cluster = reader.section("cluster");
  cluster.read("min_height_m", options.cluster.min_height_m);
  cluster.read("max_height_m", options.cluster.max_height_m);
  cluster.read("neighbor_distance_m", options.cluster.neighbor_distance_m);
  cluster.read("min_points", options.cluster.min_points);
  OptionReader top = reader.section("top");
  top.read("height_patch_radius_m", options.top.height_patch_radius_m);
  top.read("slice_m", options.top.slice_m);
  top.read("search_depth_m", options.top.search_depth_m);
  top.read("slice_ratio", options.top.slice_ratio);
  top.read("min_edge_length_m", options.top.min_edge_length_m);
  top.read("new_edge_angle_rad", options.top.new_edge_angle_rad);
  top.read("merge_angle_rad", options.top.merge_angle_rad);
  top.read("uneven_m", options.top.uneven_m);
  OptionReader box = reader.section("box");
  box.read("min_side_m", options.box.min_side_m);
  box.read("max_side_m", options.box.max_side_m);
  box.read("min_rectangularity", options.box.min_rectangularity);
  box.read("min_outline_ratio", options.box.min_outline_ratio);
  box.read("touching_distance_m", options.box.touching_distance_m);
  readStackAndRegion(reader, options);
  reader.add(detection::problems(options));
}

}  // namespace mixed_palletizing::adapters
