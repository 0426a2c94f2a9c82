#include <algorithm>
#include <queue>
#include <stdexcept>

#include <mixed_palletizing/packing/order_packing.hpp>

#include "messages.hpp"
#include "strongest_search.hpp"

namespace mixed_palletizing::packing {

namespace {

SequenceResult thesisSearch(const PalletState& pallet, const std::vector<ItemType>& types,
                            const std::vector<int>& items, const PackOptions& options,
                            const StopCallback& stop, const PackReport& report) {
  GeneticOptions genetic = options.genetic;
  genetic.seed = options.seed;
  const auto passOn = [&report](const GenerationReport& r) {
    if (report) report({r.generation, r.generations, r.best_utilization});
  };
  return geneticSearch(pallet, types, items, genetic, 1, stop, passOn).best;
}

SequenceResult randomKeySearch(const PalletState& pallet, const std::vector<ItemType>& types,
                               const std::vector<int>& items, const PackOptions& options,
                               const StopCallback& stop, const PackReport& report) {
  KeyGeneticOptions genetic = options.key_genetic;
  genetic.seed = options.seed;
  genetic.threads = options.threads;
  const auto passOn = [&report](const GenerationReport& r) {
    if (report) report({r.generation, r.generations, r.best_utilization});
  };
  return keyGeneticSearch(pallet, types, items, genetic, stop, passOn);
}

/// Of the methods that place the items one by one.
PlacementRule ruleOf(PackMethod method) {
  if (method == PackMethod::kDistance) return PlacementRule::kDistance;
  if (method == PackMethod::kContact) return PlacementRule::kContact;
  if (method == PackMethod::kBestFit) return PlacementRule::kBestFit;
  return PlacementRule::kDblf;
}

void checkItems(const Order& order, const std::vector<int>& items) {
  throwProblems("packOrder", problems(order.rules));
  for (const int type : items) {
    if (type < 0 || static_cast<std::size_t>(type) >= order.types.size()) {
      throw std::invalid_argument("packOrder: items: type index " + std::to_string(type) + " of " +
                                  std::to_string(order.types.size()) + " types");
    }
    const Vec3& size = order.types[static_cast<std::size_t>(type)].size;
    if (size.x <= 0 || size.y <= 0 || size.z <= 0) {
      throw std::invalid_argument("packOrder: order.types[" + std::to_string(type) +
                                  "].size: every side must be positive");
    }
  }
}

}  // namespace

const std::vector<std::string>& packMethodWords() {
  static const std::vector<std::string> words{"dblf", "distance", "contact", "best_fit",
                                              "ga",   "brkga",    "best"};
  return words;
}

std::optional<PackMethod> packMethodFromString(const std::string& word) {
  const std::vector<std::string>& words = packMethodWords();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<PackMethod>(found - words.begin());
}

bool needsBudget(PackMethod method) { return method == PackMethod::kBest || method == PackMethod::kBrkga; }

std::vector<std::string> problems(const PackOptions& options) {
  std::vector<std::string> lines;
  for (const std::string& line : problems(options.genetic)) lines.push_back("genetic." + line);
  for (const std::string& line : problems(options.key_genetic)) lines.push_back("key_genetic." + line);
  if (options.threads < 1 || options.threads > 2) {
    lines.push_back("threads: " + std::to_string(options.threads) + ": must be 1 or 2");
  }
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
                       const StopCallback& stop, const PackReport& report) {
  throwProblems("packOrder: options", problems(options));
  if (needsBudget(options.method) && !stop) {
    throw std::invalid_argument("packOrder: stop: this method needs a callback that ends it");
  }
  checkItems(order, items);
  if (options.method == PackMethod::kBest) {
    StrongestSearch search(order, items, options, stop);
    search.run(report);
    return assignItems(search.placements(), items, search.utilization());
  }
  const PalletState pallet(order, options.spaces);
  SequenceResult result;
  if (options.method == PackMethod::kGa) {
    result = thesisSearch(pallet, order.types, items, options, stop, report);
  } else if (options.method == PackMethod::kBrkga) {
    result = randomKeySearch(pallet, order.types, items, options, stop, report);
  } else {
    result = packSequence(pallet, order.types, items, ruleOf(options.method));
  }
  return assignItems(result.placements, items, result.utilization);
}

}  // namespace mixed_palletizing::packing
