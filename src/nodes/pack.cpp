// Packs the orders of a file, each onto one pallet, the sequence free to choose.
#include <chrono>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/packing/order_packing.hpp>

namespace instances = mixed_palletizing::instances;
namespace packing = mixed_palletizing::packing;

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

instances::PackingResult packOne(const instances::Instance& instance, const packing::PackOptions& options,
                                 const std::string& method, double time_limit_s) {
  const Clock::time_point start = Clock::now();
  const packing::OrderPacking packed =
      packing::packOrder(instance.order, instances::itemTypes(instance), options,
                         [&] { return secondsSince(start) >= time_limit_s; });
  const double ms = 1000.0 * secondsSince(start);
  instances::PackingResult result;
  result.name = instance.name;
  for (const packing::PackedItem& item : packed.packed) {
    result.placements.push_back({item.item, item.placement, {}});
  }
  result.unpacked = packed.unpacked;
  result.utilization = packed.utilization;
  result.decision_ms = {ms, ms, ms};
  result.method = method;
  result.seed = options.seed;
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  std::string instance_path;
  std::string format = "json";
  std::string method = "best";
  std::string out;
  double time_limit_s = 10.0;
  bool keep_going = false;
  bool progress = false;
  packing::PackOptions options;
  mixed_palletizing::adapters::CommandLine line(
      "pack",
      "Packs every order of a file onto one pallet, the sequence free to choose (dblf, distance: in the "
      "given order).");
  line.required("instances", &instance_path, "orders");
  line.required("out", &out, "file to write, one JSON object a line");
  line.choice("method", &method, {"dblf", "distance", "ga", "best"}, "best = the strongest search there is");
  line.option("time_limit_s", &time_limit_s, "of ga and best, for one order [s]");
  line.choice("format", &format, {"json", "br"}, "of the orders");
  line.option("seed", &options.seed, "of every random choice");
  line.flag("keep-going", &keep_going, "pack the sound orders of a file that has faults");
  line.flag("progress", &progress, "one line an order on stderr");
  return line.run(argc, argv, [&] {
    if (!(time_limit_s > 0.0)) throw std::invalid_argument("--time_limit_s: must be positive");
    options.method = *packing::packMethodFromString(method);
    const instances::InstanceFile orders =
        format == "br" ? instances::readBrFile(instance_path) : instances::readInstanceFile(instance_path);
    if (!orders.faults.empty() && !keep_going)
      throw std::invalid_argument(instances::joinFaults(orders.faults));
    for (const std::string& fault : orders.faults) std::cerr << "pack: " << fault << '\n';
    std::ofstream file(out);
    std::size_t complete = 0;
    double utilization = 0.0;
    for (const instances::Instance& instance : orders.instances) {
      const instances::PackingResult result = packOne(instance, options, method, time_limit_s);
      file << instances::formatResult(result, instance) << std::endl;
      if (!file) break;
      if (result.unpacked.empty()) ++complete;
      utilization += result.utilization;
      if (progress) {
        std::cerr << result.name << ": " << 100.0 * result.utilization << " %, " << result.unpacked.size()
                  << " unpacked, " << result.decision_ms.max_ms << " ms" << std::endl;
      }
    }
    file.close();
    if (!file) throw std::runtime_error(out + ": cannot be written");
    const double count = static_cast<double>(orders.instances.size());
    std::cout << orders.instances.size() << " orders, " << complete << " packed completely, mean utilization "
              << (orders.instances.empty() ? 0.0 : 100.0 * utilization / count) << " %\n";
    return orders.faults.empty() ? 0 : 1;
  });
}
