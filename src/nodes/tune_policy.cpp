// Tunes the weights of the placement policy on generated orders and writes them to a file.
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/adapters/tuning_orders.hpp>
#include <mixed_palletizing/planning/policy_tuning.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace planning = mixed_palletizing::planning;

namespace {

constexpr int kCheckIteration = -1;  ///< its orders are used by no iteration

std::string line(const std::string& what, const planning::PolicyScore& score) {
  return what + " value " + std::to_string(score.value) + " perfect " +
         std::to_string(100.0 * score.perfect_ratio) + " % unpacked " + std::to_string(score.unpacked);
}

/// By kind, on orders that were not tuned on.
void tellUnseen(adapters::TuningMixture mixture, const planning::PolicyWeights& before,
                const planning::PolicyWeights& after) {
  for (const std::string& kind : std::vector<std::string>(mixture.kinds)) {
    mixture.kinds = {kind};
    const auto unseen = adapters::tuningOrders(mixture, kCheckIteration);
    std::cout << line(kind + " before:", planning::playPolicy(unseen, before)) << '\n'
              << line(kind + " after:", planning::playPolicy(unseen, after)) << '\n';
  }
}

std::string commandOf(const planning::TuningOptions& options, const adapters::TuningMixture& mixture) {
  std::string kinds, heights;
  for (const std::string& kind : mixture.kinds) kinds += " " + kind;
  for (const int height : mixture.heights) heights += " " + std::to_string(height);
  return "tune_policy --seed " + std::to_string(options.seed) + " --iterations " +
         std::to_string(options.iterations) + " --population " + std::to_string(options.population) +
         " --spread " + std::to_string(options.spread) + " --count " + std::to_string(mixture.count) +
         " --heights_mm" + heights + " --kinds" + kinds;
}

}  // namespace

int main(int argc, char** argv) {
  planning::TuningOptions options;
  adapters::TuningMixture mixture;
  std::string out, start;
  bool from_zero = false;
  adapters::CommandLine command("tune_policy",
                                "Tunes the weights of the placement policy by the cross-entropy method.");
  command.required("out", &out, "file of weights, as config/placement_policy.txt");
  command.option("start", &start, "file of weights to begin with; empty = the built-in ones");
  command.flag("from-zero", &from_zero, "begin with weights of 0");
  command.option("kinds", &mixture.kinds, "of orders");
  command.option("heights_mm", &mixture.heights, "of the orders' pallets");
  command.option("count", &mixture.count, "orders of each kind and height in an iteration");
  command.option("iterations", &options.iterations, "of the method");
  command.option("population", &options.population, "vectors of weights tried in an iteration");
  command.option("spread", &options.spread, "standard deviation of the weights at the start");
  command.option("threads", &options.threads, "vectors tried at the same time");
  command.option("seed", &options.seed, "of orders and weights");
  return command.run(argc, argv, [&] {
    mixture.seed = options.seed;
    if (from_zero && !start.empty()) throw std::invalid_argument("--from-zero: --start says where to begin");
    if (!start.empty()) options.start = planning::readPolicyWeights(start);
    if (start.empty() && !from_zero) options.start = planning::tunedPolicyWeights();
    const auto orders = [&](int iteration) { return adapters::tuningOrders(mixture, iteration); };
    const planning::PolicyWeights weights =
        planning::tunePolicy(options, orders, [](const planning::TuningReport& report) {
          std::cout << line(std::to_string(report.iteration) + ":", report.mean) << " best "
                    << report.best_value << std::endl;
        });
    tellUnseen(mixture, options.start, weights);
    std::ofstream file(out);
    file << planning::formatPolicyWeights(
        weights,
        {"Weights of the policy that plays the futures of a placement. Made by", commandOf(options, mixture),
         from_zero ? "--from-zero." : "from " + (start.empty() ? "the weights before." : start)});
    if (!file) throw std::runtime_error(out + ": cannot be written");
    return 0;
  });
}
