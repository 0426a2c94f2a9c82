#include <algorithm>
#include <stdexcept>

#include <mixed_palletizing/adapters/tuning_orders.hpp>
#include <mixed_palletizing/instances/generator.hpp>

namespace mixed_palletizing::adapters {
namespace {

constexpr int kSizeSpread = 10;  ///< [mm] of the kind "spread"

instances::GeneratorOptions generatorOf(const std::string& kind, int height) {
  instances::GeneratorOptions options;
  options.pallet.z = height;
  if (kind == "columns") options.structure = instances::PackingStructure::kColumns;
  if (kind == "cuts") options.structure = instances::PackingStructure::kCuts;
  options.continuous_heights = kind == "continuous";
  if (kind == "spread") options.size_spread = kSizeSpread;
  if (kind == "yaw" || kind == "spread" || kind == "cuts") options.rotations = packing::Rotations::yawOnly();
  if (kind == "any") options.rotations = packing::Rotations::any();
  return options;
}

}  // namespace

const std::vector<std::string>& tuningKinds() {
  static const std::vector<std::string> kinds{"blocks", "columns", "continuous", "yaw",
                                              "any",    "spread",  "cuts"};
  return kinds;
}

std::vector<std::string> problems(const TuningMixture& mixture) {
  std::vector<std::string> found;
  if (mixture.kinds.empty()) found.emplace_back("kinds: none given");
  if (mixture.heights.empty()) found.emplace_back("heights: none given");
  if (mixture.count < 1) found.push_back("count: " + std::to_string(mixture.count) + ": must be at least 1");
  for (const std::string& kind : mixture.kinds) {
    if (std::find(tuningKinds().begin(), tuningKinds().end(), kind) == tuningKinds().end()) {
      found.push_back("kinds: '" + kind + "' is not known");
      continue;
    }
    for (const int height : mixture.heights) {
      for (const std::string& line : instances::problems(generatorOf(kind, height))) found.push_back(line);
    }
  }
  return found;
}

std::vector<planning::TuningOrder> tuningOrders(const TuningMixture& mixture, int iteration) {
  const std::vector<std::string> found = problems(mixture);
  if (!found.empty()) throw std::invalid_argument("tuningOrders: " + found.front());
  std::vector<planning::TuningOrder> orders;
  for (const std::string& kind : mixture.kinds) {
    for (const int height : mixture.heights) {
      for (int i = 0; i < mixture.count; ++i) {
        instances::Instance made = instances::generateInstance(generatorOf(kind, height), mixture.seed,
                                                               (iteration + 1) * mixture.count + i);
        orders.push_back({std::move(made.order), std::move(made.arrival), made.n_pick});
      }
    }
  }
  return orders;
}

}  // namespace mixed_palletizing::adapters
