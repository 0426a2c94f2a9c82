#include <algorithm>
#include <cstdint>
#include <limits>

#include <mixed_palletizing/packing/load_book.hpp>

#include "level_spaces.hpp"

namespace mixed_palletizing::packing {

namespace {

constexpr double kTolerance = 1e-9;  ///< of a load, relative

double limitOf(double kg) { return kg > 0.0 ? kg : std::numeric_limits<double>::infinity(); }

bool exceeds(double load, double limit) { return load > limit * (1.0 + kTolerance); }

}  // namespace

LoadBook::LoadBook(const Order& order) {
  const bool any_top = std::any_of(order.types.begin(), order.types.end(),
                                   [](const ItemType& type) { return type.max_load_kg > 0.0; });
  if (!any_top && order.rules.max_weight_kg <= 0.0) return;
  Limits limits;
  for (const ItemType& type : order.types) {
    limits.weight.push_back(type.weight_kg);
    limits.max_load.push_back(limitOf(type.max_load_kg));
  }
  limits.max_weight = limitOf(order.rules.max_weight_kg);
  limits.any_top = any_top;
  limits_ = std::make_shared<const Limits>(std::move(limits));
}

bool LoadBook::carriesWeightOf(int type) const {
  return !active() || (static_cast<std::size_t>(type) < limits_->weight.size() &&
                       !exceeds(totalWeight() + weightOf(type), limits_->max_weight));
}

std::string LoadBook::whyNot(const std::vector<Placement>& placed, const Placement& placement) const {
  if (!active()) return {};
  const std::size_t type = static_cast<std::size_t>(placement.type);
  if (type >= limits_->weight.size()) {
    return "type " + std::to_string(placement.type) + " of " + std::to_string(limits_->weight.size()) +
           " types";
  }
  if (!carriesWeightOf(placement.type)) {
    return "the boxes would weigh " + std::to_string(totalWeight() + weightOf(placement.type)) +
           " kg, more than " + std::to_string(limits_->max_weight) + " kg";
  }
  const std::optional<Overload> overload = firstOverload(placed, placement);
  if (!overload) return {};
  return "box " + std::to_string(overload->box) + " would carry " + std::to_string(overload->load) +
         " kg, more than " +
         std::to_string(limits_->max_load[static_cast<std::size_t>(types_[overload->box])]) + " kg";
}

bool LoadBook::carries(const std::vector<Placement>& placed, const Placement& placement) const {
  if (!carriesWeightOf(placement.type)) return false;
  if (!limitsTops()) return true;
  // Most places fail for a box right below: no need to follow the weight any further down.
  for (const Contact& contact : contactsOf(placed, placement)) {
    const double added = weightOf(placement.type) * contact.share;
    const double limit = limits_->max_load[static_cast<std::size_t>(types_[contact.box])];
    if (added > 0.0 && exceeds(loads_[contact.box] + added, limit)) return false;
  }
  return !firstOverload(placed, placement);
}

/// The first placed box whose limit `placement` would break.
std::optional<LoadBook::Overload> LoadBook::firstOverload(const std::vector<Placement>& placed,
                                                          const Placement& placement) const {
  if (!limitsTops() || placement.origin.z == 0) return std::nullopt;
  const std::vector<double> added = addedLoads(contactsOf(placed, placement), weightOf(placement.type));
  for (std::size_t i = 0; i < added.size(); ++i) {
    const double load = loads_[i] + added[i];
    if (added[i] > 0.0 && exceeds(load, limits_->max_load[static_cast<std::size_t>(types_[i])])) {
      return Overload{i, load};
    }
  }
  return std::nullopt;
}

std::vector<LoadBook::Contact> LoadBook::contactsOf(const std::vector<Placement>& placed,
                                                    const Placement& placement) const {
  std::vector<Contact> contacts;
  if (placement.origin.z == 0) return contacts;
  const Rect footprint = footprintOf(placement);
  double sum = 0.0;
  for (std::size_t i = 0; i < placed.size() && i < types_.size(); ++i) {
    if (placed[i].origin.z + placed[i].size.z != placement.origin.z) continue;
    const Rect r = intersection(footprint, footprintOf(placed[i]));
    if (r.empty()) continue;
    const double area = static_cast<double>(r.x1 - r.x0) * (r.y1 - r.y0);
    contacts.push_back({i, area});
    sum += area;
  }
  for (Contact& contact : contacts) contact.share /= sum;
  return contacts;
}

/// On every box when a weight comes down on `contacts`. Boxes rest on earlier ones only.
std::vector<double> LoadBook::addedLoads(const std::vector<Contact>& contacts, double weight) const {
  std::vector<double> added(types_.size(), 0.0);
  for (const Contact& contact : contacts) added[contact.box] += weight * contact.share;
  for (std::size_t i = added.size(); i-- > 0;) {
    if (added[i] <= 0.0) continue;
    const std::size_t begin = i == 0 ? 0 : contact_ends_[i - 1];
    for (std::size_t c = begin; c < contact_ends_[i]; ++c) {
      added[contacts_[c].box] += added[i] * contacts_[c].share;
    }
  }
  return added;
}

void LoadBook::addLast(const std::vector<Placement>& placed) {
  if (!active()) return;
  const Placement& placement = placed.back();
  const std::vector<Contact> contacts = contactsOf(placed, placement);
  const std::vector<double> added = addedLoads(contacts, weightOf(placement.type));
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (added[i] <= 0.0) continue;
    old_loads_.emplace_back(i, loads_[i]);
    loads_[i] += added[i];
  }
  old_load_ends_.push_back(old_loads_.size());
  contacts_.insert(contacts_.end(), contacts.begin(), contacts.end());
  contact_ends_.push_back(contacts_.size());
  totals_.push_back(totalWeight() + weightOf(placement.type));
  types_.push_back(placement.type);
  loads_.push_back(0.0);
}

void LoadBook::removeLast() {
  if (!active()) return;
  const auto cut = [](auto& values, std::vector<std::size_t>& ends) {
    ends.pop_back();
    const std::size_t size = ends.empty() ? 0 : ends.back();
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(size), values.end());
  };
  const std::size_t first = old_load_ends_.size() < 2 ? 0 : old_load_ends_[old_load_ends_.size() - 2];
  for (std::size_t i = first; i < old_loads_.size(); ++i) loads_[old_loads_[i].first] = old_loads_[i].second;
  cut(old_loads_, old_load_ends_);
  cut(contacts_, contact_ends_);
  totals_.pop_back();
  types_.pop_back();
  loads_.pop_back();
}

}  // namespace mixed_palletizing::packing
