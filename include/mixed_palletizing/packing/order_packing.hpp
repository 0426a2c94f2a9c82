// Packing of a whole order onto one pallet, the sequence free to choose.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/key_genetic_search.hpp>
#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

enum class PackMethod {
  kDblf,      ///< items one by one in the given order, by DBLF
  kDistance,  ///< the same by the distance rule
  kContact,   ///< the same by contact
  kBestFit,   ///< the same by best fit
  kGa,        ///< the thesis' genetic search for the sequence
  kBrkga,     ///< the random-key genetic search for sequence, rotations and rules
  kBest,      ///< the strongest search there is
};

/// The words of the methods: "dblf", "distance", "contact", "best_fit", "ga", "brkga", "best".
const std::vector<std::string>& packMethodWords();

/// Parses one of packMethodWords(); std::nullopt for another word.
std::optional<PackMethod> packMethodFromString(const std::string& word);

/// True when the method goes on until everything is packed or it is told to stop.
bool needsBudget(PackMethod method);

struct PackOptions {
  PackMethod method = PackMethod::kBest;
  GeneticOptions genetic{30, 2, 10};         ///< of kGa: the thesis' packing experiment (4.2)
  KeyGeneticOptions key_genetic;             ///< of kBrkga
  std::uint64_t seed = 1;                    ///< of every random choice; replaces those of the searches
  int threads = 1;                           ///< 1 or 2, of kBrkga and kBest; replaces key_genetic.threads
  SpaceKind spaces = SpaceKind::kSupported;  ///< that offer places; all rules hold in both
};

std::vector<std::string> problems(const PackOptions& options);

struct PackProgress {
  int round = 0;   ///< generation or pass of the search, from 1
  int rounds = 0;  ///< 0 when only the stop callback ends the search
  double best_utilization = 0.0;
};

using PackReport = std::function<void(const PackProgress&)>;

struct PackedItem {
  int item = 0;  ///< index in the given items
  Placement placement;
};

struct OrderPacking {
  std::vector<PackedItem> packed;  ///< in loading order
  std::vector<int> unpacked;       ///< indices in the given items, ascending
  double utilization = 0.0;        ///< of the pallet's volume, [0, 1]
};

/// Packs `items` (type indices, in their given order) of `order`, whose counts do not matter here, onto an
/// empty pallet. kBrkga and kBest go on until everything is packed or `stop` says so, so they need one; both
/// callbacks may be empty otherwise. With two threads kBest asks two copies of `stop`, each in its thread, so that what
/// they refer to must bear that. Throws std::invalid_argument for broken rules, options or type indices.
OrderPacking packOrder(const Order& order, const std::vector<int>& items, const PackOptions& options,
                       const StopCallback& stop, const PackReport& report = {});

/// Gives every placement the index of an item of its type that is not used yet. Throws std::invalid_argument
/// when there are more placements of a type than items.
OrderPacking assignItems(const std::vector<Placement>& placements, const std::vector<int>& items,
                         double utilization);

}  // namespace mixed_palletizing::packing
