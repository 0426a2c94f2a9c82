#include <stdexcept>

#include <mixed_palletizing/adapters/cell/order.hpp>
#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/instances/generator.hpp>

namespace mixed_palletizing::cell {
namespace {

instances::GeneratorOptions generatorOptions(const CellOrderOptions& options) {
  instances::GeneratorOptions generator;
  generator.pallet.z = options.height_mm;
  return generator;
}

}  // namespace

void readCellOrderOptions(adapters::OptionReader& reader, CellOrderOptions& options) {
  reader.read("height_mm", options.height_mm);
  reader.read("seed", options.seed);
  reader.read("instances", options.instances);
  reader.read("index", options.index);
}

std::vector<std::string> problems(const CellOrderOptions& options) {
  std::vector<std::string> all;
  if (options.index < 0) all.push_back("index: " + std::to_string(options.index) + " is negative");
  if (!options.instances.empty()) return all;
  for (const std::string& problem : instances::problems(generatorOptions(options))) {
    all.push_back("height_mm: " + std::to_string(options.height_mm) + ": " + problem);
  }
  return all;
}

instances::Instance cellOrder(const CellOrderOptions& options) {
  const std::vector<std::string> broken = problems(options);
  if (!broken.empty()) throw std::invalid_argument("cellOrder: options: " + instances::joinFaults(broken));
  if (options.instances.empty()) {
    return instances::generateInstance(generatorOptions(options), options.seed, options.index);
  }
  const std::vector<instances::Instance> all = instances::readInstances(options.instances);
  if (static_cast<std::size_t>(options.index) >= all.size()) {
    throw std::invalid_argument("index: " + std::to_string(options.index) + ": " + options.instances +
                                " has " + std::to_string(all.size()) + " orders");
  }
  return all[static_cast<std::size_t>(options.index)];
}

}  // namespace mixed_palletizing::cell
