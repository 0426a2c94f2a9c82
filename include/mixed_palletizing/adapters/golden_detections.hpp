// What a bag's clouds are expected to hold: written once, compared ever after.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <mixed_palletizing/detection/detections.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {

struct GoldenBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< base frame [m]
  double yaw_rad = 0.0;                              ///< of the length, in [-pi/2, pi/2)
  Eigen::Vector3d size = Eigen::Vector3d::Zero();    ///< length >= width, height [m]
  std::vector<std::string> flags;                    ///< names as in Box.msg
};

struct GoldenCloud {
  std::uint64_t stamp_ns = 0;
  std::string fault;  ///< why the message is no usable cloud; empty when it is one
  std::vector<GoldenBox> boxes;
};

struct GoldenDetections {
  geometry::Pose base_from_camera = geometry::Pose::Identity();
  std::vector<GoldenCloud> clouds;  ///< in recorded order
};

/// The part of a detection that is compared.
std::vector<GoldenBox> goldenBoxes(const detection::Detections& detections);

/// JSON text, the same bytes for the same content.
std::string goldenJson(const GoldenDetections& golden);

/// Writes goldenJson() to a temporary file beside `path` and renames it. Throws std::runtime_error
/// "PATH: reason".
void writeGolden(const std::string& path, const GoldenDetections& golden);

/// Throws std::runtime_error "PATH: reason" when the file cannot be read or is no golden file.
GoldenDetections readGolden(const std::string& path);

struct GoldenTolerances {
  double position_m = 0.002;
  double size_m = 0.003;
  double yaw_rad = 0.01;
  double base_m = 0.002;      ///< of the base frame's origin
  double base_rad = 0.005;    ///< of its axes
  bool compare_flags = true;  ///< flags must be the same
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const GoldenTolerances& tolerances);

struct GoldenDifference {
  int cloud = -1;    ///< index of the cloud, -1 for the bag as a whole
  std::string text;  ///< one line for people, lengths in millimetres
};

/// What differs by more than the tolerances: clouds, faults, and boxes, each box paired with the nearest of the
/// other side (closer than half its shorter side), then compared. Throws std::invalid_argument with every
/// line of problems(tolerances).
std::vector<GoldenDifference> compareGolden(const GoldenDetections& golden, const GoldenDetections& now,
                                            const GoldenTolerances& tolerances);

}  // namespace mixed_palletizing::adapters
