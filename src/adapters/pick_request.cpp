#include "pick_request.hpp"

#include <algorithm>
#include <cmath>

#include <mixed_palletizing/adapters/box_messages.hpp>

namespace mixed_palletizing::adapters {
namespace {

constexpr double kLongestBudgetS = 3600.0;

PickOption refused(std::uint8_t status, const std::string& reason) {
  PickOption option;
  option.status = status;
  option.reason = reason;
  return option;
}

/// Type of a detected box, or -1 with the option saying why not.
int typeOf(const Box& box, const planning::PalletSession& session, const std::vector<int>& remaining,
           const planning::MatchingOptions& matching, PickOption& option) {
  const planning::BoxMatch match =
      planning::matchBox(measuredBox(box), session.order()->types, remaining, matching);
  if (match.status == planning::MatchStatus::kMatched) return match.type;
  const bool ambiguous = match.status == planning::MatchStatus::kAmbiguous;
  option = refused(ambiguous ? PickOption::AMBIGUOUS_BOX : PickOption::UNKNOWN_BOX, match.message);
  return -1;
}

int typeOf(const std::string& type_id, const planning::PalletSession& session, PickOption& option) {
  const auto& types = session.order()->types;
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const auto& type) { return type.name == type_id; });
  if (found != types.end()) return static_cast<int>(found - types.begin());
  option = refused(PickOption::UNKNOWN_BOX, "the order has no line '" + type_id + "'");
  return -1;
}

}  // namespace

std::string faultOf(const ChooseNextPickRequest& request, int max_available) {
  const std::size_t count = request.boxes.size() + request.type_ids.size();
  if (!request.boxes.empty() && !request.type_ids.empty())
    return "boxes and type_ids: only one of them can be given";
  if (count > static_cast<std::size_t>(max_available)) {
    return "boxes: " + std::to_string(count) + " are more than max_available " +
           std::to_string(max_available);
  }
  if (!(request.time_budget >= 0.0 && request.time_budget <= kLongestBudgetS)) {
    return "time_budget: " + std::to_string(request.time_budget) + " s is not within 0 and 3600";
  }
  for (std::size_t i = 0; i < request.boxes.size(); ++i) {
    const std::vector<std::string> faults = problems(request.boxes[i]);
    if (!faults.empty()) return "boxes[" + std::to_string(i) + "]." + faults.front();
  }
  return "";
}

IdentifiedBoxes identify(const ChooseNextPickRequest& request, const planning::PalletSession& session,
                         const planning::MatchingOptions& matching) {
  IdentifiedBoxes identified;
  std::vector<int> remaining = session.remaining();
  // Where the counts are not all of the order, any number of any type may come.
  if (session.knowledge()->kind != planning::Knowledge::kSet) {
    std::fill(remaining.begin(), remaining.end(), packing::kMaxItems);
  }
  std::vector<int> left = remaining;
  const bool detected = !request.boxes.empty();
  const std::size_t count = detected ? request.boxes.size() : request.type_ids.size();
  identified.options.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    PickOption& option = identified.options[i];
    const int type = detected ? typeOf(request.boxes[i], session, remaining, matching, option)
                              : typeOf(request.type_ids[i], session, option);
    if (type < 0) continue;
    const auto index = static_cast<std::size_t>(type);
    const std::string& name = session.order()->types[index].name;
    if (left[index] == 0) {
      option =
          refused(PickOption::UNKNOWN_BOX, "the order needs no more boxes of type '" + name + "' than the " +
                                               std::to_string(remaining[index]) + " before this one");
      continue;
    }
    --left[index];
    option.type_id = name;
    identified.types.push_back(type);
    identified.request_index.push_back(i);
  }
  return identified;
}

std::uint8_t nothingIdentified(const IdentifiedBoxes& boxes) {
  const bool ambiguous =
      std::any_of(boxes.options.begin(), boxes.options.end(),
                  [](const PickOption& option) { return option.status == PickOption::AMBIGUOUS_BOX; });
  return ambiguous ? ChooseNextPickResponse::AMBIGUOUS_BOX : ChooseNextPickResponse::UNKNOWN_BOX;
}

}  // namespace mixed_palletizing::adapters
