// Every threshold of the detection. The member defaults are the documented defaults.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/detection/work_region.hpp>

namespace mixed_palletizing::detection {

/// How boxes are found in a cloud.
enum class Method {
  kBest,    ///< the best there is
  kThesis,  ///< the chain of chapter 3.2 of the source thesis, for comparison
};

/// Where boxes stand.
enum class Mode {
  kPalletize,    ///< on the floor of the base frame: heights are measured from there
  kDepalletize,  ///< on a pallet or on each other, seen from above: heights come from their own side faces
};

/// Which of the planes of a cloud is the floor of the base frame.
enum class FloorChoice {
  kLargest,
  kLowest,        ///< the farthest from the camera of those about parallel to the largest
  kMarker,        ///< the one that carries the marker
  kCameraHeight,  ///< the one whose distance from the camera is nearest to camera_height_m
};

/// Which of the other planes are no places of boxes.
enum class RemovedPlanes { kNone, kUpright, kAll };

/// RANSAC for the planes (thesis 3.2.1).
struct PlaneOptions {
  double distance_m = 0.005;      ///< inlier distance; grown to the measured noise where the sensor is coarse
  double probability = 0.99999;   ///< p_t of eq. 3.4
  int max_iterations = 5000;      ///< upper bound on eq. 3.4 while the best plane is still small
  double min_inlier_ratio = 0.1;  ///< of the valid points; a smaller plane is no floor
  int seed = 1;
  int max_planes =
      1;  ///< that are looked for: the floor and others, each after the points of those before are gone
  FloorChoice floor = FloorChoice::kLargest;
  double camera_height_m = 0.0;                 ///< of the camera above the floor, for kCameraHeight
  RemovedPlanes remove = RemovedPlanes::kNone;  ///< of the planes that a calibration finds beside the floor
};

/// One of several markers whose places in the base frame are known.
struct BoardMarker {
  int id = 0;
  double x_m = 0.0;  ///< centre on the floor of the base frame
  double y_m = 0.0;
  double yaw_rad = 0.0;  ///< direction from corner 0 to corner 1
};

struct MarkerOptions {
  std::string dictionary = "DICT_4X4_50";  ///< OpenCV's name of a predefined dictionary
  int id = 0;                              ///< its centre is the origin; not used with a board
  bool inverted = true;  ///< white on black printed as its negative: look for both ink polarities
  double side_m = 0.0;   ///< outer side of the border; 0: not known. Known, it must be measured to 5 %
  std::vector<BoardMarker> board;  ///< several markers instead of one; those that are seen are fitted jointly
  double max_board_error_m = 0.005;  ///< a marker of the board farther from its place refuses the frame
};

/// How far thresholds grow with what the sensor can do. Noise and point spacing are measured in every cloud,
/// so the lengths below are lower bounds: they hold for a fine sensor and are raised for a coarse one.
struct NoiseOptions {
  double sigmas = 4.0;    ///< a threshold covers this many standard deviations of the noise
  double spacings = 3.0;  ///< and this many distances between neighbours of the grid
};

/// Clusters above the floor (thesis 3.2.2).
struct ClusterOptions {
  double min_height_m = 0.02;          ///< plane removal: lower points belong to the floor
  double max_height_m = 2.0;           ///< higher points are ignored (robot, lamp)
  double neighbor_distance_m = 0.005;  ///< Euclidean comparator between grid neighbours
  int min_points = 400;                ///< smaller components are noise
};

/// Top face and its edges (thesis 3.2.2, 4.1.3).
struct TopOptions {
  double height_patch_radius_m = 0.05;  ///< patch around the centroid whose mean is the height
  double slice_m = 0.001;               ///< height of one slice of the adaptive separation
  double search_depth_m = 0.010;        ///< the slices start this far below the height
  double slice_ratio = 2.0;             ///< th_slice: points of a top slice over points of a side slice
  double min_edge_length_m = 0.015;     ///< th_length of Algorithm 2
  double new_edge_angle_rad = 1.3963;   ///< th_add of Algorithm 2: 80 degrees
  double merge_angle_rad = 0.17453;     ///< th_merge of Algorithm 2: 10 degrees
  double uneven_m = 0.004;              ///< a top whose surface strays more from a level is UNEVEN_TOP
};

/// What may be called a box.
struct BoxOptions {
  double min_side_m = 0.04;
  double max_side_m = 1.5;
  double min_rectangularity = 0.8;     ///< area of the top's hull over the area of the fitted rectangle
  double min_outline_ratio = 0.6;      ///< share of the top's free outline that lies on the rectangle's sides
  double touching_distance_m = 0.005;  ///< boxes this near to each other are TOUCHING
};

/// Boxes in a stack (mode depalletize).
struct StackOptions {
  double max_slope_rad = 0.17453;  ///< of a top against the floor: 10 degrees
  double step_m = 0.012;           ///< neighbours that differ more in height are two surfaces
  double min_height_m = 0.05;      ///< tops nearer to the floor are the pallet
};

struct DetectionOptions {
  Method method = Method::kBest;
  Mode mode = Mode::kPalletize;
  PlaneOptions plane;
  MarkerOptions marker;
  NoiseOptions noise;
  ClusterOptions cluster;
  TopOptions top;
  BoxOptions box;
  StackOptions stack;
  RegionOptions region;
};

/// Every broken rule as one line "section.key: what is wrong"; empty when the options can be used.
std::vector<std::string> problems(const DetectionOptions& options);

}  // namespace mixed_palletizing::detection
