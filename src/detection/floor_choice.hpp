// Which of a cloud's planes is the floor.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/detection/options.hpp>
#include <mixed_palletizing/geometry/cloud_view.hpp>

#include "plane_ransac.hpp"

namespace mixed_palletizing::detection {

/// Index of the floor, or why there is none.
struct FloorChoiceResult {
  std::optional<std::size_t> floor;
  std::string message;
};

/// By options.plane.floor; `planes`: the largest first, at least one.
FloorChoiceResult chooseFloor(const geometry::CloudView& cloud, const std::vector<PlaneFit>& planes,
                              const DetectionOptions& options);

}  // namespace mixed_palletizing::detection
