// Checks every placement of a result file against its instances, apart from the code that made them.
#include <iostream>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/instances/files.hpp>

namespace instances = mixed_palletizing::instances;

int main(int argc, char** argv) {
  std::string instance_path;
  std::string result_path;
  std::string format = "json";
  mixed_palletizing::adapters::CommandLine line(
      "check_packing", "Checks results independently; one line a fault, exit code 1 when there is any.");
  line.required("instances", &instance_path, "orders");
  line.required("results", &result_path, "results of them, one JSON object a line");
  line.choice("format", &format, {"json", "br"}, "of the orders");
  return line.run(argc, argv, [&] {
    const instances::InstanceFile orders =
        format == "br" ? instances::readBrFile(instance_path) : instances::readInstanceFile(instance_path);
    const instances::ResultFile results = instances::readResultFile(result_path, orders.instances);
    std::vector<std::string> faults = orders.faults;
    faults.insert(faults.end(), results.faults.begin(), results.faults.end());
    std::size_t placements = 0;
    std::size_t valid = 0;
    std::size_t checked = 0;
    for (const instances::Instance& instance : orders.instances) {
      const instances::PackingResult* result = results.find(instance.name);
      if (result == nullptr) {
        faults.push_back(instance.name + ": has no result");
        continue;
      }
      ++checked;
      placements += result->placements.size();
      const std::vector<std::string> found = instances::checkResult(instance, *result);
      if (found.empty()) ++valid;
      for (const std::string& fault : found) faults.push_back(instance.name + ": " + fault);
    }
    for (const std::string& fault : faults) std::cout << fault << '\n';
    std::cout << valid << " of " << checked << " results valid, " << placements << " placements checked, "
              << faults.size() << " faults\n";
    return faults.empty() ? 0 : 1;
  });
}
