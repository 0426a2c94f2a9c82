// Who carries whom on a pallet, and how much.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

/// The weight of a box and of all it carries rests on the boxes right below it in proportion to the areas of
/// contact; on the floor the pallet carries it. A box's load is what rests on its top. Adding and removing a
/// box takes time linear in the boxes and their contacts.
class LoadBook {
 public:
  /// Limits nothing and keeps no books.
  LoadBook() = default;

  /// Limits of ItemType::max_load_kg and PalletRules::max_weight_kg; a weight that is not known counts as 0.
  explicit LoadBook(const Order& order);

  bool active() const { return limits_ != nullptr; }

  /// Some type's top is limited, so that it matters where a box goes.
  bool limitsTops() const { return active() && limits_->any_top; }

  /// Empty when `placement`, whose place is sound, may stand on `placed`; otherwise the limit it breaks.
  std::string whyNot(const std::vector<Placement>& placed, const Placement& placement) const;

  /// The same answer as whyNot().empty(), without the words.
  bool carries(const std::vector<Placement>& placed, const Placement& placement) const;

  /// An item of this type would not make the pallet too heavy.
  bool carriesWeightOf(int type) const;

  /// The last of `placed` is new.
  void addLast(const std::vector<Placement>& placed);
  void removeLast();

  /// On the top of every box [kg]; empty when not active.
  const std::vector<double>& loads() const { return loads_; }

 private:
  struct Limits {
    std::vector<double> weight;    ///< of a type [kg]
    std::vector<double> max_load;  ///< on a type [kg]; infinite without a limit
    double max_weight = 0.0;       ///< of all boxes [kg]; infinite without a limit
    bool any_top = false;
  };
  struct Contact {
    std::size_t box;
    double share;  ///< of the weight that comes down
  };

  struct Overload {
    std::size_t box;
    double load;  ///< [kg]
  };

  std::optional<Overload> firstOverload(const std::vector<Placement>& placed,
                                        const Placement& placement) const;
  std::vector<Contact> contactsOf(const std::vector<Placement>& placed, const Placement& placement) const;
  std::vector<double> addedLoads(const std::vector<Contact>& contacts, double weight) const;
  double weightOf(int type) const { return limits_->weight[static_cast<std::size_t>(type)]; }
  double totalWeight() const { return totals_.empty() ? 0.0 : totals_.back(); }

  std::shared_ptr<const Limits> limits_;
  std::vector<double> loads_;
  std::vector<int> types_;                                 ///< of every box
  std::vector<double> totals_;                             ///< weight of the boxes up to each
  std::vector<Contact> contacts_;                          ///< of all boxes, one after the other
  std::vector<std::size_t> contact_ends_;                  ///< of every box, in contacts_
  std::vector<std::pair<std::size_t, double>> old_loads_;  ///< that each box has changed
  std::vector<std::size_t> old_load_ends_;
};

}  // namespace mixed_palletizing::packing
