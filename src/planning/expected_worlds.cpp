#include "expected_worlds.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace mixed_palletizing::planning {
namespace {

/// There is no time to think about more.
constexpr std::size_t kMostWorlds = 32;

/// The types of which one may come beside the available items, the likeliest first.
std::vector<int> nextTypes(const Situation& situation) {
  std::vector<double> likely(situation.remaining.begin(), situation.remaining.end());
  for (const int type : situation.available) --likely[static_cast<std::size_t>(type)];
  for (std::size_t t = 0; t < situation.forecast.size(); ++t) likely[t] += situation.forecast[t];
  std::vector<int> types;
  for (std::size_t t = 0; t < likely.size(); ++t) {
    if (likely[t] > 0.0) types.push_back(static_cast<int>(t));
  }
  std::stable_sort(types.begin(), types.end(), [&](int a, int b) {
    return likely[static_cast<std::size_t>(a)] > likely[static_cast<std::size_t>(b)];
  });
  return types;
}

}  // namespace

std::vector<ExpectedWorld> expectedWorlds(const OpenPallet& open,
                                          const std::optional<packing::Placement>& placed,
                                          const std::vector<int>& visible, std::uint64_t seed) {
  auto pallet = std::make_shared<packing::PalletState>(open.pallet);
  std::vector<int> taken = open.taken;
  if (placed) {
    pallet->place(*placed);
    ++taken[static_cast<std::size_t>(placed->type)];
  }
  const auto types = std::make_shared<const std::vector<packing::ItemType>>(open.order.types);
  std::vector<ExpectedWorld> worlds;
  const auto add = [&](const std::vector<int>& available) {
    if (available.empty()) return;
    Situation s = situationOf(*pallet, open.order, open.knowledge, taken, available);
    worlds.push_back({pallet, types, available, std::move(s.remaining), std::move(s.forecast), seed});
  };
  std::vector<int> more = nextTypes(situationOf(*pallet, open.order, open.knowledge, taken, visible));
  more.resize(std::min(more.size(), kMostWorlds));
  for (const int type : more) {
    std::vector<int> available = visible;
    available.push_back(type);
    add(available);
  }
  add(visible);
  return worlds;
}

std::vector<ExpectedWorld> worldsAfter(const PickReported& report, const OpenPallet& open,
                                       const std::vector<int>& available, std::optional<std::size_t> chosen,
                                       std::uint64_t seed) {
  const bool failed = report.outcome == PickOutcome::kFailed;
  std::vector<std::size_t> gone = report.discarded;
  if (!failed && gone.empty() && chosen) gone = {*chosen};
  if (!failed && gone.empty()) return {};  // all were discarded
  return expectedWorlds(open, {}, without(available, gone), seed);
}

std::vector<int> without(const std::vector<int>& items, std::vector<std::size_t> indices) {
  std::sort(indices.begin(), indices.end());
  std::vector<int> rest;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!std::binary_search(indices.begin(), indices.end(), i)) rest.push_back(items[i]);
  }
  return rest;
}

}  // namespace mixed_palletizing::planning
