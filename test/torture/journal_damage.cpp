// Damages journals in every way and prints what became of them; the last lines are for scripts/torture.sh.
#include <cstdio>
#include <filesystem>
#include <string>

#include <unistd.h>

#include <mixed_palletizing/adapters/command_line.hpp>

#include "journal_torture.hpp"
#include "tally.hpp"

namespace torture = mixed_palletizing::torture;

namespace {

/// 1 when something was lost.
int print(const std::string& test, const torture::Tally& tally) {
  std::printf("%s: %d tried, %d recovered, %d refused, %d lost, slowest opening %.3f s\n", test.c_str(),
              tally.tried, tally.recovered, tally.refused, tally.lost, tally.slowest_s);
  if (tally.lost > 0) std::printf("first lost: %s\n", tally.first_lost.c_str());
  torture::printRow(test, tally.tried, tally.lost, tally.slowest_s);
  return tally.lost > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  int step = 1, flips = 10000, draws = 5;
  std::uint64_t seed = 1;
  mixed_palletizing::adapters::CommandLine line("journal_damage",
                                                "Damages journals of a planner and opens them.");
  line.option("cut-step", &step, "bytes between the lengths that are tried; 1 = every length");
  line.option("flips", &flips, "bits flipped, one at a time");
  line.option("draws", &draws, "ways in which the power goes at each write");
  line.option("seed", &seed, "of sessions, bits and draws");
  return line.run(argc, argv, [&] {
    if (step < 1 || flips < 0 || draws < 1)
      throw std::invalid_argument("cut-step, draws: at least 1; flips: at least 0");
    const std::string folder =
        (std::filesystem::temp_directory_path() / ("journal_damage_" + std::to_string(::getpid()))).string();
    std::filesystem::create_directories(folder);
    int lost = 0;
    lost += print("journal cut off", torture::cutJournals(folder, step, seed));
    lost += print("journal with a flipped bit", torture::flipBits(folder, flips, seed));
    using torture::DiskFault;
    lost += print("disk full", torture::failDisk(folder, DiskFault::kFull, 1, seed));
    lost += print("disk full for a moment", torture::failDisk(folder, DiskFault::kFullForAMoment, 1, seed));
    lost += print("disk with write and sync errors", torture::failDisk(folder, DiskFault::kBroken, 1, seed));
    lost +=
        print("one write or sync error", torture::failDisk(folder, DiskFault::kBrokenForAMoment, 1, seed));
    lost += print("power cut", torture::failDisk(folder, DiskFault::kPowerCut, draws, seed));
    std::filesystem::remove_all(folder);
    return lost == 0 ? 0 : 1;
  });
}
