// Seen share of a top face.
#pragma once

#include <mixed_palletizing/geometry/pose.hpp>
#include <mixed_palletizing/geometry/rectangle.hpp>

#include "base_cloud.hpp"
#include "grid_runs.hpp"

namespace mixed_palletizing::detection {

/// Points of the top over the pixels that its rectangle covers in the image when nothing hides it, at most 1.
double topVisibility(const BaseCloud& cloud, const geometry::Pose& base_from_camera, const RunRange& top,
                     const geometry::Rectangle& rectangle, double height_m);

}  // namespace mixed_palletizing::detection
