// Private parameters of the planner node.
#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/planning/approach.hpp>
#include <mixed_palletizing/planning/box_matching.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::adapters {

/// The action plan_pallet: the thesis' packing experiment (4.2) with more generations, cut by the time.
struct PlanPalletOptions {
  double time_budget_s = 10.0;
  packing::GeneticOptions genetic;

  PlanPalletOptions() {
    genetic.population = 30;
    genetic.generations = 200;
  }
};

/// Where the session of a pallet is kept.
struct JournalFileOptions {
  std::string file;       ///< empty: by the node's name in ROS_HOME/mixed_palletizing; "none": in memory only
  int keep_pallets = 50;  ///< so many pallets back
};

struct PickPlannerOptions {
  std::string pallet_frame = "pallet";
  double time_budget_s = 1.0;           ///< of one decision
  bool ponder = true;                   ///< think about the next decision while the robot moves
  int max_available = 1000;             ///< boxes in one request
  double position_tolerance_m = 0.005;  ///< a measured pose this near to the plan is the plan
  double angle_tolerance_rad = 0.05;    ///< a measured box may be turned this much against the pallet
  planning::MatchingOptions matching;
  planning::PlannerOptions planner;
  planning::ApproachOptions approach;
  PlanPalletOptions plan;
  JournalFileOptions journal;
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const PickPlannerOptions& options);

/// Reads a tree of parameters. Throws std::invalid_argument with everything that is wrong: unknown keys, wrong
/// types, broken rules.
PickPlannerOptions readPickPlannerOptions(const YAML::Node& tree);

/// The path of the journal, empty for none. Without a name of its own it is ROS_HOME (or ~/.ros) +
/// "/mixed_palletizing/" + the node's name with '_' for the slashes inside + ".journal".
std::string journalPath(const JournalFileOptions& options, const std::string& node_name);

}  // namespace mixed_palletizing::adapters
