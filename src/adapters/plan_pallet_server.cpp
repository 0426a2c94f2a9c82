#include "plan_pallet_server.hpp"

#include <cmath>
#include <exception>

#include <ros/console.h>
#include <ros/init.h>

#include <mixed_palletizing/StartPallet.h>
#include <mixed_palletizing/adapters/names.hpp>
#include <mixed_palletizing/adapters/pallet_messages.hpp>

namespace mixed_palletizing::adapters {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongestBudgetS = 86400.0;

void refuse(std::uint8_t status, const std::string& message, PlanPalletResult& result) {
  result.status = status;
  result.message = message;
}

std::vector<int> itemsOf(const std::vector<int>& counts) {
  std::vector<int> items;
  for (std::size_t type = 0; type < counts.size(); ++type) {
    items.insert(items.end(), static_cast<std::size_t>(counts[type]), static_cast<int>(type));
  }
  return items;
}

}  // namespace

PlanPalletServer::PlanPalletServer(ros::NodeHandle& node, const PickPlannerOptions& options,
                                   std::mutex& session_mutex, const planning::PalletSession& session)
    : options_(options),
      session_mutex_(session_mutex),
      session_(session),
      server_(
          node, names::kPlanPallet, [this](const PlanPalletGoalConstPtr& goal) { execute(goal); }, false) {
  server_.start();
}

void PlanPalletServer::execute(const PlanPalletGoalConstPtr& goal) {
  PlanPalletResult result;
  try {
    plan(*goal, result);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("plan_pallet: " << error.what());
    refuse(PlanPalletResult::FAILED, error.what(), result);
  }
  if (result.status != PlanPalletResult::OK) {
    server_.setAborted(result, result.message);
  } else if (server_.isPreemptRequested()) {
    server_.setPreempted(result, result.message);
  } else {
    server_.setSucceeded(result, result.message);
  }
}

std::optional<PlanPalletServer::Task> PlanPalletServer::taskOf(const PlanPalletGoal& goal,
                                                               PlanPalletResult& result) {
  if (goal.order.empty()) {
    std::lock_guard<std::mutex> lock(session_mutex_);
    if (!session_.open()) {
      refuse(PlanPalletResult::NO_PALLET, "the order is empty, and no pallet is open", result);
      return std::nullopt;
    }
    return Task{*session_.order(), *session_.pallet(), itemsOf(session_.remaining())};
  }
  const ReadOrder read =
      readOrder({goal.size, goal.order, goal.gap, goal.min_support_ratio, StartPalletRequest::SET, {}});
  if (read.problems.empty()) {
    return Task{read.order, packing::PalletState(read.order), itemsOf(read.order.counts)};
  }
  result.status = PlanPalletResult::BAD_REQUEST;
  for (const auto& line : read.problems) result.message += (result.message.empty() ? "" : "; ") + line;
  return std::nullopt;
}

void PlanPalletServer::plan(const PlanPalletGoal& goal, PlanPalletResult& result) {
  if (!(goal.time_budget >= 0.0 && goal.time_budget <= kLongestBudgetS)) {
    return refuse(PlanPalletResult::BAD_REQUEST,
                  "time_budget: " + std::to_string(goal.time_budget) + " s is not within 0 and 86400",
                  result);
  }
  const std::optional<Task> task = taskOf(goal, result);
  if (!task) return;
  packing::GeneticOptions genetic = options_.plan.genetic;
  if (goal.seed != 0) genetic.seed = goal.seed;
  const Clock::time_point start = Clock::now();
  const std::chrono::duration<double> budget(goal.time_budget > 0.0 ? goal.time_budget
                                                                    : options_.plan.time_budget_s);
  const auto stop = [&] {
    return Clock::now() - start >= budget || server_.isPreemptRequested() || !ros::ok();
  };
  const auto report = [&](const packing::GenerationReport& generation) {
    PlanPalletFeedback feedback;
    feedback.generation = static_cast<std::uint32_t>(generation.generation);
    feedback.generations = static_cast<std::uint32_t>(generation.generations);
    feedback.best_utilization = generation.best_utilization;
    feedback.elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    server_.publishFeedback(feedback);
  };
  const packing::GeneticResult found =
      packing::geneticSearch(task->pallet, task->order.types, task->items, genetic, 1, stop, report);
  result.status = PlanPalletResult::OK;
  result.header.frame_id = options_.pallet_frame;
  result.header.stamp = ros::Time::now();
  for (const auto& placement : found.best.placements) {
    result.placements.push_back(toMessage(placement, task->order));
  }
  result.unpacked.assign(task->order.types.size(), 0);
  for (const int position : found.best.unpacked) {
    ++result.unpacked.at(
        static_cast<std::size_t>(found.best.sequence.at(static_cast<std::size_t>(position))));
  }
  result.utilization = found.best.utilization;
  result.generations = static_cast<std::uint32_t>(found.generations_run);
  result.message = std::to_string(found.best.placements.size()) + " boxes packed, " +
                   std::to_string(found.best.unpacked.size()) + " found no place";
}

}  // namespace mixed_palletizing::adapters
