// Results that are right by construction.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/generator.hpp>
#include <mixed_palletizing/instances/packing_result.hpp>

namespace mixed_palletizing::instances::test {

/// The perfect packing of a generated instance as an order-free result.
inline PackingResult perfectResult(const Instance& instance) {
  PackingResult result;
  result.name = instance.name;
  result.utilization = 1.0;
  std::vector<int> types = itemTypes(instance);
  for (const packing::Placement& placement : instance.perfect_packing) {
    const auto item = std::find(types.begin(), types.end(), placement.type);
    *item = -1;
    result.placements.push_back({static_cast<int>(item - types.begin()), placement, {}});
  }
  return result;
}

/// The same, played with n_pick visible; the instance's arrival becomes the loading order.
inline PackingResult perfectPlay(Instance& instance) {
  instance.arrival.clear();
  for (const packing::Placement& placement : instance.perfect_packing)
    instance.arrival.push_back(placement.type);
  PackingResult result = perfectResult(instance);
  for (std::size_t i = 0; i < result.placements.size(); ++i) {
    result.placements[i].item = static_cast<int>(i);
    const std::size_t end = std::min(i + static_cast<std::size_t>(instance.n_pick), result.placements.size());
    for (std::size_t k = i; k < end; ++k) result.placements[i].available.push_back(static_cast<int>(k));
  }
  return result;
}

inline std::string writeFile(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path) << text;
  return path;
}

/// Folder of the shared test data, empty when it is not there.
inline std::string dataFolder() {
  const char* given = std::getenv("MIXED_PALLETIZING_DATA");
  const std::string folder =
      given != nullptr ? given : std::string(MIXED_PALLETIZING_SOURCE_DIR) + "/../shared/data";
  return std::ifstream(folder + "/packing/README.md").good() ? folder : std::string();
}

}  // namespace mixed_palletizing::instances::test
