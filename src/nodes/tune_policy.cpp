// Tunes the weights of the placement policy on generated orders and writes them to a file.
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/instances/generator.hpp>
#include <mixed_palletizing/planning/policy_tuning.hpp>

namespace instances = mixed_palletizing::instances;
namespace planning = mixed_palletizing::planning;

namespace {

constexpr int kCheckIteration = -1;  ///< its orders are used by no iteration

void add(instances::Instance made, std::vector<planning::TuningOrder>& orders) {
  orders.push_back({std::move(made.order), std::move(made.arrival), made.n_pick});
}

/// For every height `count` orders of blocks and of columns, and `mixed` ones of unlike boxes that may be turned.
std::vector<planning::TuningOrder> ordersOf(const std::vector<int>& heights, int count, int mixed,
                                            std::uint64_t seed, int iteration) {
  std::vector<planning::TuningOrder> orders;
  instances::GeneratorOptions options;
  instances::GeneratorOptions unlike;
  unlike.structure = instances::PackingStructure::kCuts;
  unlike.rotations = mixed_palletizing::packing::Rotations::yawOnly();
  for (const int height : heights) {
    options.pallet.z = unlike.pallet.z = height;
    for (int i = 0; i < count; ++i) {
      for (const auto structure :
           {instances::PackingStructure::kBlocks, instances::PackingStructure::kColumns}) {
        options.structure = structure;
        add(instances::generateInstance(options, seed, (iteration + 1) * count + i), orders);
      }
    }
    for (int i = 0; i < mixed; ++i) {
      add(instances::generateInstance(unlike, seed, (iteration + 1) * mixed + i), orders);
    }
  }
  return orders;
}

std::string line(const std::string& what, const planning::PolicyScore& score) {
  return what + " value " + std::to_string(score.value) + " perfect " +
         std::to_string(100.0 * score.perfect_ratio) + " % unpacked " + std::to_string(score.unpacked);
}

}  // namespace

int main(int argc, char** argv) {
  planning::TuningOptions options;
  std::string out, start;
  std::vector<int> heights{600, 800, 1200};
  int count = 16, mixed = 0;
  mixed_palletizing::adapters::CommandLine command(
      "tune_policy", "Tunes the weights of the placement policy by the cross-entropy method.");
  command.required("out", &out, "file of weights, as config/placement_policy.txt");
  command.option("start", &start, "file of weights to begin with; empty = the built-in ones");
  command.option("heights_mm", &heights, "of the orders' pallets");
  command.option("count", &count, "orders of each height and structure in an iteration");
  command.option("mixed", &mixed, "orders of unlike boxes of each height in an iteration");
  command.option("iterations", &options.iterations, "of the method");
  command.option("population", &options.population, "vectors of weights tried in an iteration");
  command.option("spread", &options.spread, "standard deviation of the weights at the start");
  command.option("threads", &options.threads, "vectors tried at the same time");
  command.option("seed", &options.seed, "of orders and weights");
  return command.run(argc, argv, [&] {
    if (count < 0 || mixed < 0 || count + mixed < 1) throw std::invalid_argument("count, mixed: no orders");
    options.start = start.empty() ? planning::tunedPolicyWeights() : planning::readPolicyWeights(start);
    const auto orders = [&](int iteration) {
      return ordersOf(heights, count, mixed, options.seed, iteration);
    };
    const planning::PolicyWeights weights =
        planning::tunePolicy(options, orders, [](const planning::TuningReport& report) {
          std::cout << line(std::to_string(report.iteration) + ":", report.mean) << " best "
                    << report.best_value << std::endl;
        });
    const auto unseen = orders(kCheckIteration);
    std::cout << line("before:", planning::playPolicy(unseen, options.start)) << '\n'
              << line("after: ", planning::playPolicy(unseen, weights)) << '\n';
    std::ofstream file(out);
    file << planning::formatPolicyWeights(
        weights,
        {"Weights of the policy that plays the futures of a placement. Made by tune_policy",
         "--seed " + std::to_string(options.seed) + " --iterations " + std::to_string(options.iterations) +
             " --population " + std::to_string(options.population) + " --count " + std::to_string(count) +
             " --mixed " + std::to_string(mixed) + ", from the weights before."});
    if (!file) throw std::runtime_error(out + ": cannot be written");
    return 0;
  });
}
