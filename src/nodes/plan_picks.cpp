// Plays the arrival of every order against the planner.
#include <fstream>
#include <iostream>
#include <mutex>
#include <optional>
#include <stdexcept>

#include <unistd.h>

#include <mixed_palletizing/adapters/order_files.hpp>
#include <mixed_palletizing/instances/result_summary.hpp>
#include <mixed_palletizing/packing/in_parallel.hpp>
#include <mixed_palletizing/planning/play_arrivals.hpp>

namespace instances = mixed_palletizing::instances;
namespace packing = mixed_palletizing::packing;
namespace planning = mixed_palletizing::planning;

namespace {

/// The play in terms of the instance's items.
instances::PackingResult toResult(const instances::Instance& instance, const planning::PlayResult& play,
                                  const std::string& method, std::uint64_t seed) {
  const std::vector<int> items = instances::arrivalItems(instance, seed);
  const auto item = [&items](int position) { return items[static_cast<std::size_t>(position)]; };
  instances::PackingResult result;
  result.name = instance.name;
  for (const planning::PlayedPlacement& played : play.placements) {
    instances::ResultPlacement placement{item(played.item), played.placement, {}};
    for (const int position : played.available) placement.available.push_back(item(position));
    result.placements.push_back(std::move(placement));
  }
  for (const int position : play.unpacked) result.unpacked.push_back(item(position));
  result.utilization = play.utilization;
  result.decision_ms = instances::decisionTimes(play.decision_ms);
  result.method = method;
  result.seed = seed;
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  planning::PlayOptions options;
  mixed_palletizing::adapters::OrderFileOptions orders;
  std::string out, policy, method = "best", rule = "dblf", knowledge = "set";
  int threads = 1;
  bool keep_going = false, progress = false, quiet = false;
  mixed_palletizing::adapters::CommandLine line("plan_picks",
                                                "Plays arrivals: n_pick boxes visible at a time.");
  orders.declare(line);
  line.required("out", &out, "results, one JSON object a line");
  line.choice("method", &method, {"dblf", "ga", "best"}, "of planning");
  line.choice("rule", &rule, {"dblf", "distance"}, "ga and dblf: where a box is put");
  line.choice("knowledge", &knowledge, {"set", "forecast", "types", "order"},
              "of the items to come: how many of each type, those numbers in the mean only, the types alone, "
              "or (best: to "
              "compare) their order");
  line.option("budget_ms", &options.budget_ms,
              "per decision; 0 = as many as the iterations take, reproducible");
  line.option("samples", &options.planner.best.samples,
              "best: futures played for a candidate at most; 0 = the budget's, or 16 without one");
  line.option("candidates", &options.planner.best.candidates, "best: placements whose futures are played");
  line.option("policy", &policy, "best: file of weights; empty = the built-in ones");
  line.option("threads", &threads, "orders played at the same time");
  line.option("seed", &options.seed, "of the planner, and of the arrival where an order has none");
  line.flag("keep-going", &keep_going, "plan the sound orders of a file with faults");
  line.flag("progress", &progress, "show progress although stderr is no terminal");
  line.flag("quiet", &quiet, "show none");
  return line.run(argc, argv, [&] {
    options.planner.method = *planning::planMethodFromString(method);
    options.planner.genetic.rule = *packing::placementRuleFromString(rule);
    options.knowledge = *planning::playKnowledgeFromString(knowledge);
    if (!policy.empty()) options.planner.best.weights = planning::readPolicyWeights(policy);
    if (threads < 1) throw std::invalid_argument("threads: " + std::to_string(threads) + ": at least 1");
    progress = !quiet && (progress || isatty(STDERR_FILENO) != 0);
    const instances::InstanceFile file = orders.readSound("plan_picks", keep_going);
    std::ofstream results(out);
    instances::ResultSummary summary;
    std::vector<std::optional<planning::PlayResult>> plays(file.instances.size());
    std::size_t written = 0;
    std::mutex mutex;
    packing::inParallel(plays.size(), threads, [&](std::size_t, std::size_t i) {
      const instances::Instance& instance = file.instances[i];
      planning::PlayOptions mine = options;
      mine.n_pick = instance.n_pick;
      planning::PlayResult play = planning::playArrivals(
          instance.order, instances::arrivalOf(instance, mine.seed), mine, [&](int done, int total) {
            const std::lock_guard<std::mutex> lock(mutex);
            if (progress) std::cerr << '\r' << instance.name << ' ' << done << '/' << total << "   ";
          });
      const std::lock_guard<std::mutex> lock(mutex);
      plays[i] = std::move(play);
      for (; written < plays.size() && plays[written]; plays[written++] = planning::PlayResult()) {
        const auto& next = file.instances[written];
        const instances::PackingResult result = toResult(next, *plays[written], method, options.seed);
        summary.add(result, plays[written]->decision_ms);
        results << instances::formatResult(result, next) << std::endl;
        if (!results) throw std::runtime_error(out + ": cannot be written");
      }
    });
    if (progress) std::cerr << '\n';
    std::cout << summary.text(options.budget_ms) << '\n';
    return file.faults.empty() ? 0 : 1;
  });
}
