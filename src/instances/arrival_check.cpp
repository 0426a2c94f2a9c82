#include "arrival_check.hpp"

#include <algorithm>
#include <set>

#include "placement_check.hpp"

namespace mixed_palletizing::instances {
namespace {

std::string listText(const std::vector<int>& items) {
  std::string text = "[";
  for (const int item : items) text += (text.size() > 1 ? ", " : "") + std::to_string(item);
  return text + "]";
}

class Play {
 public:
  Play(const Instance& instance, std::uint64_t seed)
      : instance_(instance), types_(itemTypes(instance)), arrival_(arrivalItems(instance, seed)) {
    while (visible_.size() < static_cast<std::size_t>(instance.n_pick) && next_ < arrival_.size()) join();
  }

  bool sees(std::vector<int> items) const {
    std::vector<int> mine = visible_;
    std::sort(mine.begin(), mine.end());
    std::sort(items.begin(), items.end());
    return mine == items;
  }

  bool seesAnyOf(const std::vector<int>& items) const {
    return std::any_of(items.begin(), items.end(), [this](int item) {
      return std::find(visible_.begin(), visible_.end(), item) != visible_.end();
    });
  }

  bool over() const { return visible_.empty(); }
  const std::vector<int>& visible() const { return visible_; }

  /// Empty when all visible items may be discarded; they are, and the next ones arrive.
  std::string discard() {
    if (instance_.order.rules.min_support_ratio >= 1.0 && !limitsLoads(instance_.order)) {
      for (const int item : visible_) {
        const int type = types_[static_cast<std::size_t>(item)];
        if (!refused_.insert(type).second) continue;  // did not fit since the last placement
        if (tooHeavy(type)) continue;
        for (const packing::Vec3& size :
             allowedSizes(instance_.order.types[static_cast<std::size_t>(type)])) {
          if (fitsSomewhere(instance_.order.rules, placed_, size)) {
            return "items " + listText(visible_) + " were discarded after placement " +
                   std::to_string(static_cast<int>(placed_.size()) - 1) + ", though item " +
                   std::to_string(item) + " fits";
          }
        }
      }
    }
    visible_.clear();
    while (visible_.size() < static_cast<std::size_t>(instance_.n_pick) && next_ < arrival_.size()) join();
    return {};
  }

  void place(const ResultPlacement& placement) {
    placed_.push_back(placement.placement);
    refused_.clear();
    visible_.erase(std::remove(visible_.begin(), visible_.end(), placement.item), visible_.end());
    if (next_ < arrival_.size()) join();
  }

 private:
  /// With this item the boxes would weigh more than the pallet may carry.
  bool tooHeavy(int type) const {
    const packing::Order& order = instance_.order;
    double weight = order.types[static_cast<std::size_t>(type)].weight_kg;
    for (const packing::Placement& p : placed_)
      weight += order.types[static_cast<std::size_t>(p.type)].weight_kg;
    return order.rules.max_weight_kg > 0.0 && weight > order.rules.max_weight_kg;
  }

  void join() { visible_.push_back(arrival_[next_++]); }

  const Instance& instance_;
  const std::vector<int> types_;
  const std::vector<int> arrival_;
  std::size_t next_ = 0;
  std::vector<int> visible_;
  std::vector<packing::Placement> placed_;
  std::set<int> refused_;  ///< types that fit nowhere on `placed_`
};

}  // namespace

std::vector<std::string> arrivalFaults(const Instance& instance, const PackingResult& result) {
  Play play(instance, result.seed);
  for (std::size_t i = 0; i < result.placements.size(); ++i) {
    const ResultPlacement& placement = result.placements[i];
    const std::string name = "placement " + std::to_string(i) + ": ";
    while (!play.sees(placement.available)) {
      if (play.over() || play.seesAnyOf(placement.available)) {
        const std::vector<int>& visible = play.visible();
        return {name + "states " + listText(placement.available) + " as available, but " + listText(visible) +
                " were visible"};
      }
      const std::string fault = play.discard();
      if (!fault.empty()) return {name + fault};
    }
    if (std::count(placement.available.begin(), placement.available.end(), placement.item) == 0) {
      return {name + "item " + std::to_string(placement.item) + " is not among the available " +
              listText(placement.available)};
    }
    play.place(placement);
  }
  while (!play.over()) {
    const std::string fault = play.discard();
    if (!fault.empty()) return {"at the end: " + fault};
  }
  return {};
}

}  // namespace mixed_palletizing::instances
