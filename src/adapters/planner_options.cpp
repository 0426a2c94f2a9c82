#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <stdexcept>

#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>
#include <mixed_palletizing/adapters/planner_options.hpp>

namespace mixed_palletizing::adapters {
namespace {

constexpr int kMostAvailable = 100000;

void readGenetic(OptionReader reader, packing::GeneticOptions& options) {
  reader.read("population", options.population);
  reader.read("elite", options.elite);
  reader.read("generations", options.generations);
  reader.read("prob_tournament", options.prob_tournament);
  reader.read("prob_crossover", options.prob_crossover);
  reader.read("prob_mutation", options.prob_mutation);
  reader.readWord<packing::PlacementRule>(
      "rule", options.rule,
      {{"dblf", packing::PlacementRule::kDblf}, {"distance", packing::PlacementRule::kDistance}});
  reader.read("seed", options.seed);
}

/// `policy` is a file of weights; empty = the built-in ones.
void readBest(OptionReader reader, planning::BestOptions& options, std::vector<std::string>& wrong) {
  std::string policy;
  reader.read("candidates", options.candidates);
  reader.read("samples", options.samples);
  reader.read("threads", options.threads);
  reader.read("seed", options.seed);
  reader.read("policy", policy);
  if (policy.empty()) return;
  try {
    options.weights = planning::readPolicyWeights(policy);
  } catch (const std::exception& error) {
    wrong.push_back(std::string("planner.best.policy: ") + error.what());
  }
}

/// The broken rules of a nested struct, named by where it stands.
void append(const std::string& prefix, const std::vector<std::string>& more, std::vector<std::string>& all) {
  for (const std::string& line : more) all.push_back(prefix + line);
}

}  // namespace

std::vector<std::string> problems(const PickPlannerOptions& options) {
  std::vector<std::string> all;
  const auto require = [&](bool holds, const std::string& key, double value, const std::string& what) {
    if (!holds) all.push_back(key + ": " + std::to_string(value) + " " + what);
  };
  if (options.pallet_frame.empty()) all.push_back("pallet_frame: a name is needed");
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  const auto not_negative = [](double value) { return std::isfinite(value) && value >= 0.0; };
  require(positive(options.time_budget_s), "time_budget_s", options.time_budget_s, "s is not positive");
  require(options.max_available >= 1 && options.max_available <= kMostAvailable, "max_available",
          options.max_available, "is not within 1 and " + std::to_string(kMostAvailable));
  require(not_negative(options.position_tolerance_m), "position_tolerance_m", options.position_tolerance_m,
          "m is negative");
  require(not_negative(options.angle_tolerance_rad) && options.angle_tolerance_rad < M_PI / 4,
          "angle_tolerance_rad", options.angle_tolerance_rad, "rad is not within 0 and 45 degrees");
  require(not_negative(options.matching.tolerance_mm), "matching.tolerance_mm", options.matching.tolerance_mm,
          "mm is negative");
  require(not_negative(options.matching.sigmas), "matching.sigmas", options.matching.sigmas, "is negative");
  append("planner.", problems(options.planner), all);
  append("approach.", problems(options.approach), all);
  require(positive(options.plan.time_budget_s), "plan.time_budget_s", options.plan.time_budget_s,
          "s is not positive");
  append("plan.genetic.", problems(options.plan.genetic), all);
  require(options.journal.keep_pallets >= 1, "journal.keep_pallets", options.journal.keep_pallets,
          "is less than 1");
  return all;
}

PickPlannerOptions readPickPlannerOptions(const YAML::Node& tree) {
  PickPlannerOptions options;
  OptionReader reader(tree);
  reader.read("pallet_frame", options.pallet_frame);
  reader.read("time_budget_s", options.time_budget_s);
  reader.read("ponder", options.ponder);
  reader.read("max_available", options.max_available);
  reader.read("position_tolerance_m", options.position_tolerance_m);
  reader.read("angle_tolerance_rad", options.angle_tolerance_rad);
  OptionReader matching = reader.section("matching");
  matching.read("tolerance_mm", options.matching.tolerance_mm);
  matching.read("sigmas", options.matching.sigmas);
  OptionReader planner = reader.section("planner");
  planner.readWord<planning::PlanMethod>("method", options.planner.method,
                                         {{"dblf", planning::PlanMethod::kDblf},
                                          {"ga", planning::PlanMethod::kGa},
                                          {"best", planning::PlanMethod::kBest}});
  planner.read("n_cost", options.planner.n_cost);
  planner.readWord<planning::CostComparison>("comparison", options.planner.comparison,
                                             {{"lexicographic", planning::CostComparison::kLexicographic},
                                              {"mean", planning::CostComparison::kMean}});
  readGenetic(planner.section("genetic"), options.planner.genetic);
  OptionReader gripper = planner.section("gripper");
  gripper.read("size_x_mm", options.planner.gripper.size_x);
  gripper.read("size_y_mm", options.planner.gripper.size_y);
  gripper.read("reach_mm", options.planner.gripper.reach);
  OptionReader approach = reader.section("approach");
  approach.read("sideways_mm", options.approach.sideways);
  approach.read("height_mm", options.approach.height);
  std::vector<std::string> wrong;
  readBest(planner.section("best"), options.planner.best, wrong);
  OptionReader plan = reader.section("plan");
  plan.read("time_budget_s", options.plan.time_budget_s);
  readGenetic(plan.section("genetic"), options.plan.genetic);
  OptionReader journal = reader.section("journal");
  journal.read("file", options.journal.file);
  journal.read("keep_pallets", options.journal.keep_pallets);
  reader.add(wrong);
  reader.add(problems(options));
  reader.finish("parameters of the pick planner");
  return options;
}

std::string journalPath(const JournalFileOptions& options, const std::string& node_name) {
  if (options.file == "none") return "";
  if (!options.file.empty()) return expandPath(options.file);
  const char* ros_home = std::getenv("ROS_HOME");
  const char* home = std::getenv("HOME");
  if (ros_home == nullptr && home == nullptr) {
    throw std::invalid_argument("journal.file: neither ROS_HOME nor HOME is set: name a file");
  }
  const std::string folder = ros_home != nullptr ? ros_home : std::string(home) + "/.ros";
  std::string name = node_name.substr(std::min(node_name.find_first_not_of('/'), node_name.size()));
  std::replace(name.begin(), name.end(), '/', '_');
  return folder + "/mixed_palletizing/" + name + ".journal";
}

}  // namespace mixed_palletizing::adapters
