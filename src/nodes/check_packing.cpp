// Checks every placement of a result file against its instances, apart from the code that made them.
#include <iostream>

#include <mixed_palletizing/adapters/order_files.hpp>

namespace instances = mixed_palletizing::instances;

int main(int argc, char** argv) {
  mixed_palletizing::adapters::OrderFileOptions orders_options;
  std::string result_path;
  mixed_palletizing::adapters::CommandLine line(
      "check_packing", "Checks results independently; one line a fault, exit code 1 when there is any.");
  orders_options.declare(line);
  line.required("results", &result_path, "results of them, one JSON object a line");
  return line.run(argc, argv, [&] {
    const instances::InstanceFile orders = orders_options.read();
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
