// Pictures of a cloud with boxes drawn into it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/golden_detections.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::adapters {

struct DrawnBoxes {
  std::vector<GoldenBox> boxes;
  std::uint32_t rgb = 0x00ff00;
};

/// Writes the colours of the cloud (the depth as gray where it has none) with the edges of the boxes of each
/// list in its colour. The camera is taken for a pinhole, fitted to the cloud's own points. Throws
/// std::runtime_error "PATH: reason".
void writeDetectionPicture(const std::string& path, const geometry::CloudView& cloud,
                           const geometry::Pose& base_from_camera, const std::vector<DrawnBoxes>& lists);

}  // namespace mixed_palletizing::adapters
