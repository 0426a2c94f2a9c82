#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <utility>

#include <mixed_palletizing/planning/knowledge.hpp>

namespace mixed_palletizing::planning {
namespace {

std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

std::vector<int> countsOf(const std::vector<int>& items, std::size_t types) {
  std::vector<int> counts(types, 0);
  for (const int item : items) {
    if (item >= 0 && static_cast<std::size_t>(item) < types) ++counts[static_cast<std::size_t>(item)];
  }
  return counts;
}

}  // namespace

const char* toString(Knowledge knowledge) {
  switch (knowledge) {
    case Knowledge::kSet:
      return "set";
    case Knowledge::kForecast:
      return "forecast";
    case Knowledge::kTypes:
      return "types";
  }
  return "";
}

std::vector<std::string> problems(const packing::Order& order, const OrderKnowledge& knowledge) {
  packing::Order counted = order;
  const bool none_counted =
      std::all_of(order.counts.begin(), order.counts.end(), [](int c) { return c == 0; });
  if (knowledge.kind != Knowledge::kSet && none_counted && !counted.counts.empty())
    counted.counts.front() = 1;
  std::vector<std::string> found = packing::problems(counted);
  if (knowledge.kind == Knowledge::kTypes && !none_counted) {
    found.emplace_back("counts: must all be 0 when the types only are known");
  }
  if (knowledge.kind != Knowledge::kForecast) {
    if (!knowledge.expected.empty()) found.emplace_back("expected: given, but there is no forecast");
    return found;
  }
  if (knowledge.expected.size() != order.types.size()) {
    found.push_back("expected: " + std::to_string(knowledge.expected.size()) + " counts for " +
                    std::to_string(order.types.size()) + " types");
  }
  double sum = order.itemCount();
  for (std::size_t i = 0; i < knowledge.expected.size(); ++i) {
    const double count = knowledge.expected[i];
    sum += count;
    if (count >= 0.0 && count <= packing::kMaxItems) continue;
    found.push_back("expected[" + std::to_string(i) + "]: " + std::to_string(count) + ": must lie in 0 .. " +
                    std::to_string(packing::kMaxItems));
  }
  if (sum > packing::kMaxItems) {
    found.push_back("expected: " + rounded(sum) + " items in all: at most " +
                    std::to_string(packing::kMaxItems));
  }
  return found;
}

std::vector<double> equalShares(const packing::PalletState& pallet,
                                const std::vector<packing::ItemType>& types,
                                const std::vector<int>& available) {
  auto free_volume = static_cast<double>(packing::volume(pallet.rules().size) - pallet.packedVolume());
  for (const int type : available) {
    free_volume -= static_cast<double>(packing::volume(types[static_cast<std::size_t>(type)].size));
  }
  const double share = std::max(0.0, free_volume) / static_cast<double>(types.size());
  std::vector<double> expected;
  for (const packing::ItemType& type : types) {
    const double count = share / static_cast<double>(packing::volume(type.size));
    expected.push_back(
        std::min(count, static_cast<double>(packing::kMaxItems) / static_cast<double>(types.size())));
  }
  return expected;
}

Situation situationOf(const packing::PalletState& pallet, const packing::Order& order,
                      const OrderKnowledge& knowledge, const std::vector<int>& taken,
                      std::vector<int> available) {
  std::vector<int> remaining(order.types.size(), 0);
  for (std::size_t t = 0; t < remaining.size(); ++t) remaining[t] = std::max(0, order.counts[t] - taken[t]);
  Situation situation{pallet, order.types, std::move(available), std::move(remaining)};
  if (knowledge.kind == Knowledge::kSet) return situation;
  const std::vector<int> at_hand = countsOf(situation.available, order.types.size());
  if (knowledge.kind == Knowledge::kTypes) {
    situation.remaining = at_hand;
    situation.forecast = equalShares(pallet, order.types, situation.available);
    return situation;
  }
  for (std::size_t t = 0; t < at_hand.size(); ++t) {
    // Of the expected those came already that are at hand, or gone, beyond the sure ones.
    const int came =
        std::max(0, at_hand[t] - situation.remaining[t]) + std::max(0, taken[t] - order.counts[t]);
    situation.remaining[t] = std::max(situation.remaining[t], at_hand[t]);
    situation.forecast.push_back(std::max(0.0, knowledge.expected[t] - came));
  }
  return situation;
}

std::string assumptionOf(const Situation& situation, Knowledge knowledge) {
  const auto visible = static_cast<int>(situation.available.size());
  const int sure = std::accumulate(situation.remaining.begin(), situation.remaining.end(), 0) - visible;
  const double expected = std::accumulate(situation.forecast.begin(), situation.forecast.end(), 0.0);
  std::string text;
  if (knowledge == Knowledge::kSet) {
    text = std::to_string(sure) + " more boxes come";
  } else if (knowledge == Knowledge::kForecast) {
    text = std::to_string(sure) + " more boxes are sure to come, " + rounded(expected) +
           " are expected beside them";
  } else {
    text = "nothing is known but the types: each is taken to fill an equal share of the free room, " +
           rounded(expected) + " more boxes in all";
  }
  text += ", every sequence as likely as another";
  if (visible == 0) return text;
  return text + "; " + std::to_string(visible) + (visible == 1 ? " is" : " are") + " visible at a time";
}

}  // namespace mixed_palletizing::planning
