#include <mixed_palletizing/adapters/detection_options.hpp>

namespace mixed_palletizing::adapters {

const std::vector<std::pair<std::string, detection::Method>>& detectionMethods() {
  static const std::vector<std::pair<std::string, detection::Method>> words = {
      {"best", detection::Method::kBest}, {"thesis", detection::Method::kThesis}};
  return words;
}

void readDetectionOptions(OptionReader& reader, detection::DetectionOptions& options) {
  reader.readWord("method", options.method, detectionMethods());
  OptionReader plane = reader.section("plane");
  plane.read("distance_m", options.plane.distance_m);
  plane.read("probability", options.plane.probability);
  plane.read("max_iterations", options.plane.max_iterations);
  plane.read("min_inlier_ratio", options.plane.min_inlier_ratio);
  plane.read("seed", options.plane.seed);
  OptionReader marker = reader.section("marker");
  marker.read("dictionary", options.marker.dictionary);
  marker.read("id", options.marker.id);
  marker.read("inverted", options.marker.inverted);
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
  reader.add(detection::problems(options));
}

}  // namespace mixed_palletizing::adapters
