#include "deadline_worlds.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <mixed_palletizing/instances/generator.hpp>
#include <mixed_palletizing/packing/placement_rule.hpp>

namespace mixed_palletizing::bench {
namespace {

constexpr int kManyAvailable = 10000;
constexpr int kMostPlaced = 400;

int number(std::mt19937_64& rng, int low, int high) {
  return low + static_cast<int>(rng() % static_cast<std::uint64_t>(high - low + 1));
}

packing::Order usualOrder(std::mt19937_64& rng) {
  instances::GeneratorOptions generator;
  generator.pallet.z = std::array<int, 3>{600, 800, 1200}.at(rng() % 3);
  if (rng() % 2 == 0) {
    generator.structure = instances::PackingStructure::kCuts;
    generator.boxes = number(rng, 20, 80);
    generator.rotations = rng() % 2 == 0 ? packing::Rotations::yawOnly() : packing::Rotations::any();
  }
  return instances::generateInstance(generator, rng(), 0).order;
}

packing::Order largeOrder(std::mt19937_64& rng, int items) {
  packing::Order order;
  order.rules.size = {1200, 1000, 2000};
  const int types = number(rng, 1, 200);
  for (int i = 0; i < types; ++i) {
    order.types.push_back({"t" + std::to_string(i),
                           {number(rng, 60, 300), number(rng, 60, 200), number(rng, 40, 200)},
                           rng() % 2 == 0 ? packing::Rotations::any() : packing::Rotations::yawOnly(),
                           0.0,
                           0.0});
    order.counts.push_back(items / types + 1);
  }
  return order;
}

void drawRules(std::mt19937_64& rng, packing::Order& order) {
  if (rng() % 3 == 0) order.rules.gap = number(rng, 1, 10);
  if (rng() % 3 == 0) order.rules.min_support_ratio = 0.7;
  if (rng() % 4 != 0) return;
  for (packing::ItemType& type : order.types) {
    type.weight_kg = number(rng, 1, 20);
    type.max_load_kg = number(rng, 0, 1) * number(rng, 20, 100);
  }
}

/// A decision for one item at this place, and its report.
void placeOne(planning::SessionState& state, const packing::Placement& placement) {
  planning::PickDecided decided;
  decided.available = {placement.type};
  decided.reply.decision_id = state.nextDecisionId();
  decided.reply.decision.chosen = 0;
  decided.reply.decision.options.resize(1);
  decided.reply.decision.options.front().feasible = true;
  decided.reply.decision.options.front().placement = placement;
  const std::uint64_t id = decided.reply.decision_id;
  state.apply(decided);
  state.apply(planning::PickReported{id, planning::PickOutcome::kPlaced, std::nullopt, {}});
}

}  // namespace

const char* toString(WorldKind kind) {
  switch (kind) {
    case WorldKind::kUsual:
      return "usual orders";
    case WorldKind::kLargeOrder:
      return "large orders";
    case WorldKind::kManyBoxes:
      return "10,000 boxes visible";
  }
  return "";
}

World randomWorld(std::mt19937_64& rng, WorldKind kind) {
  packing::Order order =
      kind == WorldKind::kUsual
          ? usualOrder(rng)
          : largeOrder(rng, kind == WorldKind::kManyBoxes ? 2 * kManyAvailable : number(rng, 500, 5000));
  drawRules(rng, order);
  World world;
  if (rng() % 4 == 0)
    world.options.gripper = {number(rng, 50, 200), number(rng, 50, 200), number(rng, 0, 60)};
  world.state.apply(planning::PalletStarted{"p", order});
  const int wanted = number(rng, 0, std::min(order.itemCount() * 3 / 4, kMostPlaced));
  for (int i = 0; i < wanted; ++i) {
    const planning::OpenPallet& open = *world.state.open();
    const auto type = static_cast<std::size_t>(rng() % order.types.size());
    if (open.remaining[type] == 0) continue;
    const auto place = packing::findPlacement(open.pallet, order.types[type], static_cast<int>(type),
                                              packing::PlacementRule::kDblf);
    if (place) placeOne(world.state, *place);
  }
  return world;
}

std::vector<int> World::draw(std::mt19937_64& rng, WorldKind kind) const {
  const std::size_t wanted = kind == WorldKind::kUsual
                                 ? std::array<std::size_t, 5>{1, 2, 3, 5, 10}.at(rng() % 5)
                             : kind == WorldKind::kManyBoxes ? kManyAvailable
                                                             : static_cast<std::size_t>(number(rng, 3, 100));
  std::vector<int> left = state.open()->remaining;
  std::vector<int> available;
  for (int tries = 0; available.size() < wanted && tries < 10 * kManyAvailable; ++tries) {
    const auto type = static_cast<std::size_t>(rng() % left.size());
    if (left[type] == 0) continue;
    --left[type];
    available.push_back(static_cast<int>(type));
  }
  return available;
}

}  // namespace mixed_palletizing::bench
