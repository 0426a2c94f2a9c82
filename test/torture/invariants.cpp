// Tries what must always hold, and prints what did not; the last line of each test is for scripts/torture.sh.
#include "invariants.hpp"

#include <stdexcept>

#include <mixed_palletizing/adapters/command_line.hpp>

namespace torture = mixed_palletizing::torture;

int main(int argc, char** argv) {
  int placements = 1000000, seeds = 1000, deviations = 20000;
  std::uint64_t seed = 1;
  mixed_palletizing::adapters::CommandLine line("invariants", "Tries what must always hold.");
  line.option("placements", &placements, "random placements, each compared with the definition");
  line.option("seeds", &seeds, "for which one thread and two must answer the same");
  line.option("deviations", &deviations, "boxes put down elsewhere than planned, missing, swapped, added");
  line.option("seed", &seed, "the first");
  return line.run(argc, argv, [&] {
    if (placements < 0 || seeds < 0 || deviations < 0)
      throw std::invalid_argument("placements, seeds, deviations: at least 0");
    int lost = 0;
    if (placements > 0)
      lost += torture::report("random placements", torture::placeAtRandom(placements, seed));
    if (seeds > 0) lost += torture::report("one thread and two", torture::compareThreads(seeds, seed));
    if (deviations > 0) lost += torture::report("boxes not as planned", torture::deviate(deviations, seed));
    return lost == 0 ? 0 : 1;
  });
}
