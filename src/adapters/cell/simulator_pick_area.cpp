#include <algorithm>
#include <array>
#include <stdexcept>

#include <mixed_palletizing/adapters/cell/simulator_pick_area.hpp>
#include <mixed_palletizing/adapters/units.hpp>
#include <mixed_palletizing/instances/files.hpp>

namespace mixed_palletizing::cell {
namespace {

/// How often all boxes are laid out anew before the view counts as too small.
constexpr int kFreshLayouts = 50;

/// Cardboard, all light enough for a structured-light camera.
constexpr std::array<std::uint32_t, 8> kColors{0xb08a5a, 0xc9a06b, 0x9a7b4f, 0xd2b48c,
                                               0xa9825c, 0xbf9f7a, 0xc4a484, 0x94795d};

simulation::SceneBox solidOf(const packing::ItemType& type, int index) {
  simulation::SceneBox solid;
  solid.name = type.name;
  solid.size_m = Eigen::Vector3d(adapters::toMeters(type.size.x), adapters::toMeters(type.size.y),
                                 adapters::toMeters(type.size.z));
  solid.rgb = kColors[static_cast<std::size_t>(index) % kColors.size()];
  return solid;
}

std::vector<simulation::SceneBox> solidsOf(const std::vector<PickAreaBox>& boxes) {
  std::vector<simulation::SceneBox> solids;
  for (const PickAreaBox& box : boxes) solids.push_back(box.solid);
  return solids;
}

/// Distance of a point from the solid [m], 0 inside.
double distanceTo(const simulation::SceneBox& solid, const Eigen::Vector3d& point_world) {
  const Eigen::Vector3d local = simulation::worldFromBox(solid).inverse() * point_world;
  return (local.cwiseAbs() - 0.5 * solid.size_m).cwiseMax(Eigen::Vector3d::Zero()).norm();
}

}  // namespace

PickArea::PickArea(const instances::Instance& instance, int n_pick, const CellLayout& layout,
                   std::uint64_t seed)
    : order_(instance.order), layout_(layout), random_(seed) {
  std::vector<std::string> broken = instances::problems(instance);
  if (n_pick < 0) broken.push_back("n_pick: " + std::to_string(n_pick) + " is negative");
  if (!broken.empty()) throw std::invalid_argument("PickArea: " + instances::joinFaults(broken));
  arrival_ = instances::arrivalOf(instance, seed);
  n_pick_ = static_cast<std::size_t>(n_pick > 0 ? n_pick : instance.n_pick);
  requireRoom();
  fill();
}

/// The largest boxes of the order must fit all at once: a later arrival could bring them together.
void PickArea::requireRoom() {
  std::vector<PickAreaBox> largest;
  for (const int type : arrival_) {
    largest.push_back({0, type, solidOf(order_.types[static_cast<std::size_t>(type)], type)});
  }
  const auto diagonal = [](const PickAreaBox& box) { return box.solid.size_m.head<2>().norm(); };
  std::stable_sort(largest.begin(), largest.end(),
                   [&](const PickAreaBox& a, const PickAreaBox& b) { return diagonal(a) > diagonal(b); });
  largest.resize(std::min(largest.size(), n_pick_));
  if (layAfresh(largest)) return;
  throw std::invalid_argument("PickArea: the camera's view has no room for " +
                              std::to_string(largest.size()) + " boxes up to " + largest.front().solid.name +
                              ": a greater distance or field of view, or a smaller n_pick is needed");
}

bool PickArea::layAfresh(std::vector<PickAreaBox>& boxes) {
  for (int i = 0; i < kFreshLayouts; ++i) {
    std::vector<simulation::SceneBox> solids;
    for (PickAreaBox& box : boxes) {
      if (!layout_.place(box.solid, solids, random_)) break;
      solids.push_back(box.solid);
    }
    if (solids.size() == boxes.size()) return true;
  }
  return false;
}

PickAreaBox PickArea::arriving() const {
  const int type = arrival_[next_];
  return {static_cast<int>(next_), type, solidOf(order_.types[static_cast<std::size_t>(type)], type)};
}

void PickArea::arrive() {
  std::vector<PickAreaBox> boxes = boxes_;
  boxes.push_back(arriving());
  // When the others leave no room, somebody shoves them together.
  if (!layout_.place(boxes.back().solid, solidsOf(boxes_), random_) && !layAfresh(boxes)) {
    throw std::runtime_error("PickArea: no room for box " + std::to_string(next_) + ", " +
                             boxes.back().solid.name);
  }
  boxes_ = std::move(boxes);
  ++next_;
}

void PickArea::fill() {
  while (boxes_.size() < n_pick_ && next_ < arrival_.size()) arrive();
}

std::optional<std::size_t> PickArea::find(const Eigen::Vector3d& point_world, double tolerance_m) const {
  std::optional<std::size_t> found;
  double nearest = tolerance_m;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const double distance = distanceTo(boxes_[i].solid, point_world);
    if (!(distance <= nearest)) continue;
    nearest = distance;
    found = i;
  }
  return found;
}

PickAreaBox PickArea::take(std::size_t index, bool discard) {
  if (index >= boxes_.size()) {
    throw std::invalid_argument("PickArea::take: index: " + std::to_string(index) + " of " +
                                std::to_string(boxes_.size()) + " boxes");
  }
  const PickAreaBox taken = boxes_[index];
  boxes_.erase(boxes_.begin() + static_cast<std::ptrdiff_t>(index));
  if (!discard || boxes_.empty()) fill();
  return taken;
}

}  // namespace mixed_palletizing::cell
