// Instance and result files: one JSON object a line, and the BR text format.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <mixed_palletizing/instances/instance.hpp>
#include <mixed_palletizing/instances/packing_result.hpp>

namespace mixed_palletizing::instances {

/// One line of JSON. Throws std::invalid_argument with every fault of the line.
Instance parseInstance(const std::string& line);
std::string formatInstance(const Instance& instance);

/// One line of JSON; type names are looked up in `instance`. Throws std::invalid_argument.
PackingResult parseResult(const std::string& line, const Instance& instance);
std::string formatResult(const PackingResult& result, const Instance& instance);

/// All instances of a JSON-lines file, blank lines skipped. Throws std::invalid_argument naming path and
/// line, std::runtime_error when the file cannot be read.
std::vector<Instance> readInstances(const std::string& path);

/// All instances of a BR text file (Bischoff and Ratcliff 1995): centimetres become millimetres, the flags
/// tell which side may stand vertical. Errors as readInstances().
std::vector<Instance> readBrInstances(const std::string& path);

}  // namespace mixed_palletizing::instances
