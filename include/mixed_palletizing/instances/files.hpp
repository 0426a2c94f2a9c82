// Instance and result files: one JSON object a line, and the BR text format.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/instances/instance.hpp>
#include <mixed_palletizing/instances/packing_result.hpp>

namespace mixed_palletizing::instances {

/// One line of JSON (docs/file_formats.md). Throws std::invalid_argument with every fault of the line.
Instance parseInstance(const std::string& line);
/// Throws std::invalid_argument for rotations that the format has no word for.
std::string formatInstance(const Instance& instance);

/// One line of JSON; type names are looked up in `instance`. Throws std::invalid_argument with every fault of
/// the line; whether the placements are valid is the business of checkResult().
PackingResult parseResult(const std::string& line, const Instance& instance);
std::string formatResult(const PackingResult& result, const Instance& instance);

/// What a file held. A line with faults gives "path:line: fault" for each of them and no instance.
struct InstanceFile {
  std::vector<Instance> instances;
  std::vector<std::string> faults;
};

/// All instances of a JSON-lines file, blank lines skipped; names must differ. Throws std::runtime_error when
/// the file cannot be read.
InstanceFile readInstanceFile(const std::string& path);

/// All instances of a BR text file (Bischoff and Ratcliff 1995): centimetres become millimetres, the flags
/// tell which side may stand vertical, turning about the vertical is free. The names are those of file and
/// instance ("BR1_3"). A faulty value spoils its instance; a line of another shape ends the reading, as
/// the lines after it cannot be told apart.
InstanceFile readBrFile(const std::string& path);

/// The same, but any fault throws std::invalid_argument with all of them.
std::vector<Instance> readInstances(const std::string& path);
std::vector<Instance> readBrInstances(const std::string& path);

struct ResultFile {
  std::vector<PackingResult> results;
  std::vector<std::string> faults;

  /// The result of the instance of this name, null when there is none.
  const PackingResult* find(const std::string& name) const;
};

/// All results of a JSON-lines file, at most one for each of `instances`. Errors as readInstanceFile().
ResultFile readResultFile(const std::string& path, const std::vector<Instance>& instances);

/// "fault; fault; ... and n more": the first ten faults in one line.
std::string joinFaults(const std::vector<std::string>& faults);

}  // namespace mixed_palletizing::instances
