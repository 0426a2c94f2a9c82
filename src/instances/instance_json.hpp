// Instances and results as JSON values, with the faults as a list.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/instances/instance.hpp>
#include <mixed_palletizing/instances/packing_result.hpp>

#include "json_reader.hpp"

namespace mixed_palletizing::instances {

Instance instanceFromJson(const Json& line, std::vector<std::string>& faults);
PackingResult resultFromJson(const Json& line, const Instance& instance, std::vector<std::string>& faults);

Json toJson(const packing::Vec3& v);
/// Index of a type by name, -1 when there is none.
int typeIndex(const packing::Order& order, const std::string& name);

}  // namespace mixed_palletizing::instances
