#include <algorithm>
#include <cmath>

#include <mixed_palletizing/simulation/scene_box.hpp>

namespace mixed_palletizing::simulation {

geometry::Pose worldFromBox(const SceneBox& box) {
  const double center_z = box.base_z_m + 0.5 * box.size_m.z();
  return geometry::poseFromYaw({box.position_m.x(), box.position_m.y(), center_z}, box.yaw_rad);
}

double topOffset(const SceneBox& box, const Eigen::Vector2d& place_m) {
  // A cushion that is fixed along the edges: the product of two parabolas.
  const Eigen::Array2d share = (2.0 * place_m.array() / box.size_m.head<2>().array()).min(1.0).max(-1.0);
  double offset = box.shape.bulge_m * (1.0 - share.square()).prod();
  for (const BoxDent& dent : box.shape.dents) {
    const double squared = (place_m - dent.center_m).squaredNorm() / (dent.radius_m * dent.radius_m);
    if (squared < 1.0) offset -= dent.depth_m * (1.0 - squared) * (1.0 - squared);  // level at rim and centre
  }
  return offset;
}

TopOffsets topOffsets(const SceneBox& box) {
  constexpr int kCells = 200;  // along each side
  const Eigen::Array2d size = box.size_m.head<2>().array() - 2.0 * box.shape.rounding_m;
  TopOffsets result;
  if (box.shape.bulge_m == 0.0 && box.shape.dents.empty()) return result;
  double sum = 0.0;
  const auto visit = [&](const Eigen::Vector2d& place) {
    const double offset = topOffset(box, place);
    sum += offset;
    result.lowest_m = std::min(result.lowest_m, offset);
    result.highest_m = std::max(result.highest_m, offset);
  };
  for (int row = 0; row < kCells; ++row) {
    for (int col = 0; col < kCells; ++col) {
      const Eigen::Array2d share((col + 0.5) / kCells - 0.5, (row + 0.5) / kCells - 0.5);
      visit((share * size).matrix());
    }
  }
  result.mean_m = sum / (kCells * kCells);
  visit(Eigen::Vector2d::Zero());
  for (const BoxDent& dent : box.shape.dents) visit(dent.center_m);
  return result;
}

std::vector<std::string> shapeFlags(const BoxShape& shape) {
  std::vector<std::string> flags;
  if (shape.bulge_m > 0.0) flags.push_back("BULGED");
  if (shape.bulge_m < 0.0) flags.push_back("SAGGED");
  if (shape.rounding_m > 0.0) flags.push_back("ROUNDED_EDGES");
  if (!shape.dents.empty()) flags.push_back("DENTED");
  if (!shape.flaps.empty()) flags.push_back("OPEN_FLAPS");
  return flags;
}

}  // namespace mixed_palletizing::simulation
