// What a journal survives: cuts, flipped bits, faults of the disk, power cuts.
#pragma once

#include <cstdint>
#include <string>

namespace mixed_palletizing::torture {

/// `lost`: opened as something that was never acknowledged, or refused without need, or without saying what to do.
struct Tally {
  int tried = 0;
  int recovered = 0;  ///< opened as the last acknowledged state
  int refused = 0;    ///< with what to do
  int lost = 0;
  double slowest_s = 0.0;  ///< opening
  std::string first_lost;  ///< which
};

/// Every length from 0, `step` bytes apart. A cut journal must be refused, or be whole.
Tally cutJournals(const std::string& folder, int step, std::uint64_t seed);

/// One random bit each.
Tally flipBits(const std::string& folder, int flips, std::uint64_t seed);

enum class DiskFault { kFull, kBroken, kFullForAMoment, kBrokenForAMoment, kPowerCut };

/// A session in which the fault happens at its first write, its second, ... to the last, each in `draws` ways.
Tally failDisk(const std::string& folder, DiskFault fault, int draws, std::uint64_t seed);

}  // namespace mixed_palletizing::torture
