#include "sequence_packer.hpp"

#include <limits>
#include <stdexcept>
#include <string>

namespace mixed_palletizing::packing {

SequencePacker::SequencePacker(const PalletState& start, const std::vector<ItemType>& types,
                               PlacementRule rule)
    : start_(start), state_(start), rule_(rule) {
  sizes_.reserve(types.size());
  for (const ItemType& type : types) sizes_.push_back(orientations(type));
}

void SequencePacker::check(const std::vector<int>& sequence, const char* function) const {
  for (const int type : sequence) {
    if (type >= 0 && static_cast<std::size_t>(type) < sizes_.size()) continue;
    throw std::invalid_argument(std::string(function) + ": type index " + std::to_string(type) + " of " +
                                std::to_string(sizes_.size()) + " types");
  }
}

bool SequencePacker::pack(const std::vector<int>& sequence) {
  state_ = start_;
  unpacked_.clear();
  refused_at_.assign(sizes_.size(), std::numeric_limits<std::size_t>::max());
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const std::size_t type = static_cast<std::size_t>(sequence[i]);
    const std::size_t placed = state_.placements().size();
    if (refused_at_[type] != placed) {
      if (const auto placement = findPlacement(state_, sizes_[type], sequence[i], rule_)) {
        state_.place(*placement);
        continue;
      }
      refused_at_[type] = placed;
    }
    unpacked_.push_back(static_cast<int>(i));
  }
  return unpacked_.empty();
}

SequenceResult packSequence(PalletState state, const std::vector<ItemType>& types,
                            const std::vector<int>& sequence, PlacementRule rule) {
  SequencePacker packer(state, types, rule);
  packer.check(sequence, "packSequence");
  packer.pack(sequence);
  const auto first = static_cast<std::ptrdiff_t>(state.placements().size());
  const std::vector<Placement>& placements = packer.state().placements();
  return {sequence,
          {placements.begin() + first, placements.end()},
          packer.unpacked(),
          packer.state().utilization()};
}

}  // namespace mixed_palletizing::packing
