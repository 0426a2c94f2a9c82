// Place of the base frame on the floor by the markers in a cloud's colour.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <mixed_palletizing/detection/base_frame.hpp>

#include "plane_map.hpp"

namespace mixed_palletizing::detection {

/// Fills markers and base_from_camera of a frame whose floor is known; returns what is wrong, empty when nothing is.
std::string placeOnMarkers(const geometry::CloudView& cloud, const DetectionOptions& options,
                           BaseFrame& frame);

/// Pixels (columns, rows) of the corners of the wanted markers that are seen, whatever plane they lie on. `floor`
/// helps to find them.
std::vector<std::array<Eigen::Vector2d, 4>> seenMarkers(const geometry::CloudView& cloud,
                                                        const geometry::Plane& floor,
                                                        const MarkerOptions& options);

/// Base frame with its origin and its x direction given in `axes` of the floor.
geometry::Pose floorFrame(const PlaneAxes& axes, const Eigen::Vector2d& origin, double yaw_rad);

}  // namespace mixed_palletizing::detection
