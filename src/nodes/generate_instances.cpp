// Writes random orders with a known perfect packing as JSON lines.
#include <cstdint>
#include <fstream>
#include <stdexcept>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/instances/generator.hpp>

namespace instances = mixed_palletizing::instances;

namespace {

void refuseContradictions(const mixed_palletizing::adapters::CommandLine& line,
                          const instances::GeneratorOptions& options) {
  const bool cuts = options.structure == instances::PackingStructure::kCuts;
  const auto refuse = [&line](const char* name, const char* structure) {
    if (line.given(name))
      throw std::invalid_argument("--" + std::string(name) + ": --structure " + structure +
                                  " has no use for it");
  };
  if (cuts) {
    for (const char* name : {"divisors", "heights", "continuous_heights"}) refuse(name, "cuts");
  } else {
    for (const char* name : {"boxes", "min_side", "spread"}) refuse(name, "blocks and columns");
  }
}

}  // namespace

int main(int argc, char** argv) {
  instances::GeneratorOptions options;
  std::vector<int> pallet{options.pallet.x, options.pallet.y};
  std::string structure = "blocks";
  std::string rotations = "none";
  std::uint64_t seed = 1;
  int count = 1;
  std::string out;
  mixed_palletizing::adapters::CommandLine line(
      "generate_instances",
      "Writes random orders whose items fill the pallet without waste, one JSON object a line.");
  line.required("height_mm", &options.pallet.z, "height of the packing volume [mm]");
  line.required("out", &out, "file to write");
  line.option("count", &count, "how many orders");
  line.option("seed", &seed, "of every random choice");
  line.option("pallet_mm", &pallet, "length and width of the pallet [mm]");
  line.option("divisors", &options.footprint_divisors,
              "shares of the pallet's area: 4 = a quarter; powers of two");
  line.option("heights", &options.heights, "heights of the items [mm]");
  line.option("n_pick", &options.n_pick, "items that can be picked at a time");
  line.choice("structure", &structure, {"blocks", "columns", "cuts"},
              "of the perfect packing; cuts = boxes of any size, cut at any millimetre");
  line.flag("continuous_heights", &options.continuous_heights,
            "blocks, columns: any height from the smallest to the largest of --heights");
  line.option("boxes", &options.boxes, "cuts: how many, as far as --min_side allows");
  line.option("min_side", &options.min_side, "cuts: shortest side of a box [mm]");
  line.option("spread", &options.spread,
              "cuts: share of a side, about its middle, in which it is cut; 0 = always in the middle");
  line.choice("rotations", &rotations, {"none", "yaw", "any"},
              "of the items; boxes that can be turned into each other are one type");
  line.option(
      "size_spread_mm", &options.size_spread,
      "every side of every type is drawn anew within so much of its own; no perfect packing is known then");
  line.option("gap_mm", &options.gap, "rule of the pallet; no perfect packing is known with one");
  line.option("min_support_ratio", &options.min_support_ratio, "rule of the pallet");
  return line.run(argc, argv, [&] {
    if (pallet.size() != 2)
      throw std::invalid_argument("--pallet_mm: two numbers are needed, length and width");
    if (count < 1) throw std::invalid_argument("--count: must be at least 1, not " + std::to_string(count));
    options.pallet.x = pallet[0];
    options.pallet.y = pallet[1];
    options.structure = *instances::packingStructureFromString(structure);
    if (rotations == "yaw") options.rotations = mixed_palletizing::packing::Rotations::yawOnly();
    if (rotations == "any") options.rotations = mixed_palletizing::packing::Rotations::any();
    refuseContradictions(line, options);
    const std::vector<std::string> found = instances::problems(options);
    if (!found.empty()) throw std::invalid_argument(instances::joinFaults(found));
    std::ofstream file(out);
    for (int i = 0; i < count && file; ++i) {
      file << instances::formatInstance(instances::generateInstance(options, seed, i)) << '\n';
    }
    file.close();
    if (!file) throw std::runtime_error(out + ": cannot be written");
    return 0;
  });
}
