// Source: the decoder of Goncalves and Resende (2012): items by rising first key; each goes where its rule puts it in its
// rotation, in any allowed rotation when that one fits nowhere, and stays out when none does.
#include "key_decoder.hpp"

#include <algorithm>
#include <numeric>

#include "sequence_packer.hpp"

namespace mixed_palletizing::packing {

KeyDecoder::KeyDecoder(const PalletState& start, const std::vector<ItemType>& types,
                       const std::vector<int>& items)
    : start_(start), items_(items) {
  SequencePacker(start, types, PlacementRule::kDblf).check(items, "keyGeneticSearch");
  for (const ItemType& type : types) sizes_.push_back(orientations(type));
}

std::vector<std::size_t> KeyDecoder::sequenceOf(const Keys& keys) const {
  std::vector<std::size_t> sequence(items_.size());
  std::iota(sequence.begin(), sequence.end(), std::size_t{0});
  std::stable_sort(sequence.begin(), sequence.end(), [&](std::size_t a, std::size_t b) {
    return keys[a * kKeysPerItem] < keys[b * kKeysPerItem];
  });
  return sequence;
}

std::optional<Placement> KeyDecoder::place(const PalletState& state, const Keys& keys,
                                           std::size_t item) const {
  const int type = items_[item];
  const std::vector<Vec3>& sizes = sizes_[static_cast<std::size_t>(type)];
  if (sizes.empty()) return std::nullopt;
  const auto chosen = [&](std::size_t key, std::size_t count) {
    return static_cast<std::size_t>(keys[item * kKeysPerItem + key] * static_cast<double>(count));
  };
  const PlacementRule rule = kKeyRules[chosen(2, kKeyRules.size())];
  if (auto found = findPlacement(state, {sizes[chosen(1, sizes.size())]}, type, rule)) return found;
  return sizes.size() > 1 ? findPlacement(state, sizes, type, rule) : std::nullopt;
}

PalletState KeyDecoder::packed(const Keys& keys, std::vector<int>* unpacked) const {
  PalletState state = start_;
  // Of a type: boxes on the pallet when it last fitted nowhere.
  std::vector<std::size_t> refused_at(sizes_.size(), items_.size() + state.placements().size() + 1);
  const std::vector<std::size_t> sequence = sequenceOf(keys);
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    std::size_t& refused = refused_at[static_cast<std::size_t>(items_[sequence[i]])];
    if (refused != state.placements().size()) {
      if (const auto placement = place(state, keys, sequence[i])) {
        state.place(*placement);
        continue;
      }
      refused = state.placements().size();
    }
    if (unpacked != nullptr) unpacked->push_back(static_cast<int>(i));
  }
  return state;
}

SequenceResult KeyDecoder::decode(const Keys& keys) const {
  SequenceResult result;
  for (const std::size_t item : sequenceOf(keys)) result.sequence.push_back(items_[item]);
  const PalletState state = packed(keys, &result.unpacked);
  const auto first = static_cast<std::ptrdiff_t>(start_.placements().size());
  result.placements.assign(state.placements().begin() + first, state.placements().end());
  result.utilization = state.utilization();
  return result;
}

}  // namespace mixed_palletizing::packing
