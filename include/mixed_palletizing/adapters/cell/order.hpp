// The order of the simulated cell: the simulator brings its boxes, the executive packs them; both read the same
// parameters here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/instances/instance.hpp>

namespace mixed_palletizing::cell {

struct CellOrderOptions {
  int height_mm = 600;     ///< of the packing volume of a generated order
  std::uint64_t seed = 1;  ///< of the generated order, and of an arrival that the file does not give
  std::string instances;   ///< file of orders, one JSON object a line; empty: the order is generated
  int index = 0;           ///< which order of the generator or of the file, from 0
};

/// Reads height_mm, seed, instances and index.
void readCellOrderOptions(adapters::OptionReader& reader, CellOrderOptions& options);

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const CellOrderOptions& options);

/// The order. Throws std::invalid_argument with every broken rule or with the faults of the file,
/// std::runtime_error when the file cannot be read.
instances::Instance cellOrder(const CellOrderOptions& options);

}  // namespace mixed_palletizing::cell
