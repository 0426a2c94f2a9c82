// Options of the detector and the planner node, and their shipped parameter files.
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/detector_options.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/adapters/planner_options.hpp>

namespace mixed_palletizing::adapters {
namespace {

YAML::Node shipped(const std::string& name) {
  return loadYaml(std::string(MIXED_PALLETIZING_SOURCE_DIR) + "/config/" + name);
}

/// What readers say about a tree; empty when nothing.
template <typename Read>
std::string complaint(Read read, const std::string& yaml) {
  try {
    read(YAML::Load(yaml));
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(DetectorOptions, shippedFileIsReadAndHoldsTheDefaults) {
  const DetectorOptions read = readDetectorOptions(shipped("box_detector.yaml"));
  const DetectorOptions defaults;
  EXPECT_EQ(read.base_frame, defaults.base_frame);
  EXPECT_EQ(read.base_source, defaults.base_source);
  EXPECT_EQ(read.publish_tf, defaults.publish_tf);
  EXPECT_EQ(read.tf_direction, defaults.tf_direction);
  EXPECT_EQ(read.calibration_file, defaults.calibration_file);
  EXPECT_EQ(read.calibration_clouds, defaults.calibration_clouds);
  EXPECT_EQ(read.calibrate_on_start, defaults.calibrate_on_start);
  EXPECT_EQ(read.cloud_timeout_s, defaults.cloud_timeout_s);
  EXPECT_EQ(read.tf_timeout_s, defaults.tf_timeout_s);
  EXPECT_EQ(read.capture_service, defaults.capture_service);
}

/// The numbers of the detection, in any fixed order.
std::vector<double> numbers(const detection::DetectionOptions& o) {
  return {o.plane.distance_m,
          o.plane.probability,
          double(o.plane.max_iterations),
          o.plane.min_inlier_ratio,
          double(o.plane.seed),
          double(o.marker.id),
          double(o.marker.inverted),
          o.noise.sigmas,
          o.noise.spacings,
          o.cluster.min_height_m,
          o.cluster.max_height_m,
          o.cluster.neighbor_distance_m,
          double(o.cluster.min_points),
          o.top.height_patch_radius_m,
          o.top.slice_m,
          o.top.search_depth_m,
          o.top.slice_ratio,
          o.top.min_edge_length_m,
          o.top.new_edge_angle_rad,
          o.top.merge_angle_rad,
          o.top.uneven_m,
          double(o.method),
          o.box.min_side_m,
          o.box.max_side_m,
          o.box.min_rectangularity,
          o.box.min_outline_ratio,
          o.box.touching_distance_m};
}

TEST(DetectorOptions, shippedThresholdsAreTheDefaults) {
  const DetectorOptions read = readDetectorOptions(shipped("box_detector.yaml"));
  EXPECT_EQ(numbers(read.detection), numbers(detection::DetectionOptions{}));
  EXPECT_EQ(read.detection.marker.dictionary, detection::MarkerOptions{}.dictionary);
}

TEST(DetectorOptions, everyMistakeIsNamedAtOnce) {
  const std::string text =
      complaint(readDetectorOptions,
                "{base_frame: '', base_sorce: floor, tf_direction: up, calibration_clouds: 0, "
                "cloud_timeout_s: -1, tf_timeout_s: -1, detection: {plane: {distnce_m: 1}}}");
  EXPECT_NE(text.find("7 mistakes"), std::string::npos) << text;
  for (const char* part : {"base_frame", "base_sorce", "base_source", "camera_to_base", "calibration_clouds",
                           "cloud_timeout_s", "tf_timeout_s", "detection.plane.distnce_m"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
  EXPECT_NE(complaint(readDetectorOptions, "base_source: file").find("calibration_file"), std::string::npos);
  EXPECT_EQ(complaint(readDetectorOptions, "diagnostic_period: 2"), "");
}

TEST(PickPlannerOptions, shippedFileIsReadAndHoldsTheDefaults) {
  const PickPlannerOptions read = readPickPlannerOptions(shipped("pick_planner.yaml"));
  const PickPlannerOptions defaults;
  EXPECT_EQ(read.pallet_frame, defaults.pallet_frame);
  EXPECT_EQ(read.time_budget_s, defaults.time_budget_s);
  EXPECT_EQ(read.max_available, defaults.max_available);
  EXPECT_EQ(read.position_tolerance_m, defaults.position_tolerance_m);
  EXPECT_EQ(read.angle_tolerance_rad, defaults.angle_tolerance_rad);
  EXPECT_EQ(read.matching.tolerance_mm, defaults.matching.tolerance_mm);
  EXPECT_EQ(read.matching.sigmas, defaults.matching.sigmas);
  EXPECT_EQ(read.planner.method, defaults.planner.method);
  EXPECT_EQ(read.planner.n_cost, defaults.planner.n_cost);
  EXPECT_EQ(read.planner.comparison, defaults.planner.comparison);
  EXPECT_EQ(read.planner.best.candidates, defaults.planner.best.candidates);
  EXPECT_EQ(read.planner.best.samples, defaults.planner.best.samples);
  EXPECT_EQ(read.planner.best.threads, defaults.planner.best.threads);
  EXPECT_EQ(read.planner.best.seed, defaults.planner.best.seed);
  EXPECT_EQ(read.planner.best.weights, defaults.planner.best.weights);
  EXPECT_EQ(read.planner.gripper.isThere(), defaults.planner.gripper.isThere());
  EXPECT_EQ(read.journal.file, defaults.journal.file);
  EXPECT_EQ(read.journal.keep_pallets, defaults.journal.keep_pallets);
  EXPECT_EQ(read.plan.time_budget_s, defaults.plan.time_budget_s);
  for (const auto& [a, b] : {std::pair(read.planner.genetic, defaults.planner.genetic),
                             std::pair(read.plan.genetic, defaults.plan.genetic)}) {
    EXPECT_EQ(a.population, b.population);
    EXPECT_EQ(a.elite, b.elite);
    EXPECT_EQ(a.generations, b.generations);
    EXPECT_EQ(a.prob_tournament, b.prob_tournament);
    EXPECT_EQ(a.prob_crossover, b.prob_crossover);
    EXPECT_EQ(a.prob_mutation, b.prob_mutation);
    EXPECT_EQ(a.rule, b.rule);
    EXPECT_EQ(a.seed, b.seed);
  }
}

TEST(PickPlannerOptions, everyMistakeIsNamedAtOnce) {
  const std::string text = complaint(readPickPlannerOptions,
                                     "{pallet_frame: '', time_budget_s: 0, max_available: 0, "
                                     "position_tolerance_m: -1, angle_tolerance_rad: 1, "
                                     "matching: {tolerance_mm: -1, sigmas: -1, x: 1}, planner: {method: "
                                     "best2, n_cost: 0, genetic: {population: 0}}, "
                                     "plan: {time_budget_s: -1, genetic: {elite: -1}}}");
  for (const char* part :
       {"pallet_frame", "time_budget_s", "max_available", "position_tolerance_m", "angle_tolerance_rad",
        "matching.tolerance_mm", "matching.sigmas", "matching.x", "planner.method", "planner.n_cost",
        "planner.population", "plan.time_budget_s", "plan.genetic.elite"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
}

TEST(JournalPath, followsTheNodesNameUnlessItIsNamed) {
  const char* before = std::getenv("ROS_HOME");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("ROS_HOME", "/ros", 1);
  EXPECT_EQ(journalPath({"", 50}, "/pick_planner"), "/ros/mixed_palletizing/pick_planner.journal");
  EXPECT_EQ(journalPath({"", 50}, "/cell1/pick_planner"),
            "/ros/mixed_palletizing/cell1_pick_planner.journal");
  EXPECT_EQ(journalPath({"/a/b", 50}, "/pick_planner"), "/a/b");
  EXPECT_EQ(journalPath({"none", 50}, "/pick_planner"), "");
  if (before == nullptr) {
    ::unsetenv("ROS_HOME");
  } else {
    ::setenv("ROS_HOME", kept.c_str(), 1);
  }
}

TEST(PickPlannerOptions, policyFilesAreReadAndTheirFaultsNamed) {
  const auto read = [](const YAML::Node& tree) { return readPickPlannerOptions(tree); };
  const std::string policy = std::string(MIXED_PALLETIZING_SOURCE_DIR) + "/config/placement_policy.txt";
  EXPECT_EQ(complaint(read, "planner: {best: {policy: " + policy + "}}"), "");
  EXPECT_NE(complaint(read, "planner: {best: {policy: /none/such}}").find("planner.best.policy"),
            std::string::npos);
  EXPECT_NE(complaint(read, "planner: {gripper: {reach_mm: -1}}").find("gripper.reach"), std::string::npos);
  EXPECT_NE(complaint(read, "journal: {keep_pallets: 0}").find("journal.keep_pallets"), std::string::npos);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
