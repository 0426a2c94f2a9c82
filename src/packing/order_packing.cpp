#include <algorithm>
#include <queue>
#include <stdexcept>

#include <mixed_palletizing/packing/order_packing.hpp>

#include "messages.hpp"

namespace mixed_palletizing::packing {

namespace {

using Report = std::function<void(const PackProgress&)>;

SequenceResult thesisSearch(const PalletState& pallet, const std::vector<ItemType>& types,
                            const std::vector<int>& items, const PackOptions& options,
                            const StopCallback& stop, const Report& report) {
  GeneticOptions genetic = options.genetic;
  genetic.seed = options.seed;
  const auto passOn = [&report](const GenerationReport& r) {
    if (report) report({r.generation, r.generations, r.best_utilization});
  };
  return geneticSearch(pallet, types, items, genetic, 1, stop, passOn).best;
}

/// The genetic search again and again, both placement rules in turn, the population growing.
SequenceResult repeatedSearch(const PalletState& pallet, const std::vector<ItemType>& types,
                              const std::vector<int>& items, const PackOptions& options,
                              const StopCallback& stop, const Report& report) {
  SequenceResult best;
  GeneticOptions genetic = options.genetic;
  for (int round = 1; round == 1 || (!best.unpacked.empty() && !stop()); ++round) {
    genetic.seed = options.seed + static_cast<std::uint64_t>(round - 1);
    genetic.rule = round % 4 == 0 ? PlacementRule::kDistance : PlacementRule::kDblf;
    genetic.population = std::min(2 * options.genetic.population, options.genetic.population * round);
    SequenceResult found = geneticSearch(pallet, types, items, genetic, 1, stop).best;
    if (round == 1 || found.utilization > best.utilization) best = std::move(found);
    if (report) report({round, 0, best.utilization});
  }
  return best;
}

}  // namespace

std::optional<PackMethod> packMethodFromString(const std::string& word) {
  if (word == "dblf") return PackMethod::kDblf;
  if (word == "distance") return PackMethod::kDistance;
  if (word == "ga") return PackMethod::kGa;
  if (word == "best") return PackMethod::kBest;
  return std::nullopt;
}

std::vector<std::string> problems(const PackOptions& options) {
  std::vector<std::string> lines;
  for (const std::string& line : problems(options.genetic)) lines.push_back("genetic." + line);
  return lines;
}

OrderPacking assignItems(const std::vector<Placement>& placements, const std::vector<int>& items,
                         double utilization) {
  std::vector<std::queue<int>> waiting;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i] < 0) throw std::invalid_argument("assignItems: items: type " + std::to_string(items[i]));
    const std::size_t type = static_cast<std::size_t>(items[i]);
    if (type >= waiting.size()) waiting.resize(type + 1);
    waiting[type].push(static_cast<int>(i));
  }
  OrderPacking packing;
  packing.utilization = utilization;
  for (const Placement& placement : placements) {
    const std::size_t type = static_cast<std::size_t>(placement.type);
    if (type >= waiting.size() || waiting[type].empty()) {
      throw std::invalid_argument("assignItems: placements: more of type " + std::to_string(placement.type) +
                                  " than there are items");
    }
    packing.packed.push_back({waiting[type].front(), placement});
    waiting[type].pop();
  }
  for (std::queue<int>& rest : waiting) {
    for (; !rest.empty(); rest.pop()) packing.unpacked.push_back(rest.front());
  }
  std::sort(packing.unpacked.begin(), packing.unpacked.end());
  return packing;
}

OrderPacking packOrder(const Order& order, const std::vector<int>& items, const PackOptions& options,
                       const StopCallback& stop, const std::function<void(const PackProgress&)>& report) {
  throwProblems("packOrder: options", problems(options));
  if (options.method == PackMethod::kBest && !stop) {
    throw std::invalid_argument("packOrder: stop: the method best needs a callback that ends it");
  }
  for (const int type : items) {
    if (type >= 0 && static_cast<std::size_t>(type) < order.types.size()) continue;
    throw std::invalid_argument("packOrder: items: type index " + std::to_string(type) + " of " +
                                std::to_string(order.types.size()) + " types");
  }
  const PalletState pallet(order.rules);
  SequenceResult result;
  switch (options.method) {
    case PackMethod::kDblf:
      result = packSequence(pallet, order.types, items, PlacementRule::kDblf);
      break;
    case PackMethod::kDistance:
      result = packSequence(pallet, order.types, items, PlacementRule::kDistance);
      break;
    case PackMethod::kGa:
      result = thesisSearch(pallet, order.types, items, options, stop, report);
      break;
    case PackMethod::kBest:
      result = repeatedSearch(pallet, order.types, items, options, stop, report);
      break;
  }
  return assignItems(result.placements, items, result.utilization);
}

}  // namespace mixed_palletizing::packing
