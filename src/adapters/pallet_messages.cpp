#include <algorithm>
#include <cmath>
#include <limits>

#include <mixed_palletizing/StartPallet.h>
#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/pallet_messages.hpp>
#include <mixed_palletizing/adapters/units.hpp>

namespace mixed_palletizing::adapters {
namespace {

using Problems = std::vector<std::string>;

/// Converts a length, or notes that it is none.
template <typename Convert>
int lengthOf(double meters, const std::string& name, Convert convert, Problems& problems) {
  if (isLength(meters)) return convert(meters);
  problems.push_back(name + ": " + std::to_string(meters) +
                     " m is no length: metres up to 1000, not millimetres");
  return 1;
}

packing::Vec3 sizeOf(const geometry_msgs::Vector3& size, const std::string& name, int (*convert)(double),
                     Problems& problems) {
  return {lengthOf(size.x, name + ".x", convert, problems), lengthOf(size.y, name + ".y", convert, problems),
          lengthOf(size.z, name + ".z", convert, problems)};
}

double finite(double value, const std::string& name, Problems& problems) {
  if (std::isfinite(value)) return value;
  problems.push_back(name + ": " + std::to_string(value) + " is not finite");
  return 0.0;
}

packing::Rotations rotationsOf(const OrderLine& line, const std::string& name, Problems& problems) {
  switch (line.rotations) {
    case OrderLine::NONE:
      return packing::Rotations::none();
    case OrderLine::YAW:
      return packing::Rotations::yawOnly();
    case OrderLine::ANY:
      return packing::Rotations::any();
    case OrderLine::CUSTOM:
      return {true, {line.vertical[0] != 0, line.vertical[1] != 0, line.vertical[2] != 0}};
    default:
      break;
  }
  problems.push_back(name + ".rotations: " + std::to_string(line.rotations) +
                     " is none of NONE, YAW, ANY, CUSTOM");
  return packing::Rotations::none();
}

packing::ItemType typeOf(const OrderLine& line, const std::string& name, Problems& problems) {
  packing::ItemType type;
  type.name = line.type_id;
  type.size = sizeOf(line.size, name + ".size", millimetersUp, problems);
  type.rotations = rotationsOf(line, name, problems);
  type.weight_kg = finite(line.weight, name + ".weight", problems);
  type.max_load_kg = finite(line.max_load, name + ".max_load", problems);
  return type;
}

std::uint8_t rotationsWord(const packing::Rotations& rotations) {
  if (!rotations.yaw) return OrderLine::NONE;
  const std::array<bool, 3> upright{false, false, true};
  const std::array<bool, 3> any{true, true, true};
  if (rotations.vertical == upright) return OrderLine::YAW;
  return rotations.vertical == any ? OrderLine::ANY : OrderLine::CUSTOM;
}

Eigen::Vector3d metersOf(const packing::Vec3& v) { return {toMeters(v.x), toMeters(v.y), toMeters(v.z)}; }

planning::Knowledge knowledgeOf(std::uint8_t word, Problems& problems) {
  switch (word) {
    case StartPalletRequest::SET:
      return planning::Knowledge::kSet;
    case StartPalletRequest::FORECAST:
      return planning::Knowledge::kForecast;
    case StartPalletRequest::TYPES:
      return planning::Knowledge::kTypes;
    default:
      break;
  }
  problems.push_back("knowledge: " + std::to_string(word) + " is none of SET, FORECAST, TYPES");
  return planning::Knowledge::kSet;
}

std::uint8_t codeOf(planning::Knowledge knowledge) {
  switch (knowledge) {
    case planning::Knowledge::kForecast:
      return StartPalletRequest::FORECAST;
    case planning::Knowledge::kTypes:
      return StartPalletRequest::TYPES;
    case planning::Knowledge::kSet:
      break;
  }
  return StartPalletRequest::SET;
}

void fillOrder(const planning::PalletSession& session, PalletState& state) {
  const packing::Order& order = *session.order();
  state.pallet_id = session.palletId();
  state.size = vectorMessage(metersOf(order.rules.size));
  state.gap = toMeters(order.rules.gap);
  state.min_support_ratio = order.rules.min_support_ratio;
  state.order = toLines(order);
  for (const int count : session.remaining()) state.remaining.push_back(static_cast<std::uint32_t>(count));
  for (const int count : session.discarded()) state.discarded.push_back(static_cast<std::uint32_t>(count));
  state.knowledge = codeOf(session.knowledge()->kind);
  state.expected = session.expected();
  const planning::PickDecided* pending = session.pendingDecision();
  if (pending == nullptr || !pending->reply.decision.chosen) return;
  state.has_pending = true;
  state.pending_decision_id = pending->reply.decision_id;
  state.pending = toMessage(*planning::plannedPlacement(pending->reply.decision), order);
  const auto& detected = pending->notes.box_sizes_m;
  if (!detected.empty()) alignPose(state.pending, detected.at(*pending->reply.decision.chosen));
}

geometry_msgs::Point centerOfGravity(const planning::PalletSummary& summary) {
  const auto& mm = summary.center_of_gravity_mm;
  return pointMessage({toMeters(mm[0]), toMeters(mm[1]), toMeters(mm[2])});
}

}  // namespace

ReadOrder readOrder(const OrderRequest& request) {
  ReadOrder read;
  packing::PalletRules& rules = read.order.rules;
  rules.size = sizeOf(request.size, "size", millimetersDown, read.problems);
  rules.gap = lengthOf(request.gap, "gap", millimetersUp, read.problems);
  const double ratio = finite(request.min_support_ratio, "min_support_ratio", read.problems);
  rules.min_support_ratio = ratio == 0.0 ? 1.0 : ratio;
  read.knowledge = {knowledgeOf(request.knowledge, read.problems), request.expected};
  for (std::size_t i = 0; i < request.lines.size(); ++i) {
    const OrderLine& line = request.lines[i];
    const std::string name = "order[" + std::to_string(i) + "]";
    if (line.type_id.empty()) read.problems.push_back(name + ".type_id: a name is needed");
    if (line.count == 0 && read.knowledge.kind == planning::Knowledge::kSet)
      read.problems.push_back(name + ".count: 0: at least 1 is needed");
    read.order.types.push_back(typeOf(line, name, read.problems));
    constexpr std::uint32_t kMostItems = packing::kMaxItems;
    read.order.counts.push_back(static_cast<int>(std::min(line.count, kMostItems + 1)));
  }
  if (read.problems.empty()) read.problems = problems(read.order, read.knowledge);
  return read;
}

std::vector<OrderLine> toLines(const packing::Order& order) {
  std::vector<OrderLine> lines(order.types.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const packing::ItemType& type = order.types[i];
    OrderLine& line = lines[i];
    line.type_id = type.name;
    line.size = vectorMessage(metersOf(type.size));
    line.count = static_cast<std::uint32_t>(order.counts.at(i));
    line.rotations = rotationsWord(type.rotations);
    for (std::size_t k = 0; k < 3; ++k) line.vertical[k] = type.rotations.vertical[k] ? 1 : 0;
    line.weight = type.weight_kg;
    line.max_load = type.max_load_kg;
  }
  return lines;
}

Placement toMessage(const packing::Placement& placement, const packing::Order& order) {
  const packing::ItemType& type = order.types.at(static_cast<std::size_t>(placement.type));
  Placement message;
  message.type_id = type.name;
  message.type_index = static_cast<std::uint32_t>(placement.type);
  const Eigen::Vector3d origin = metersOf(placement.origin);
  const Eigen::Vector3d size = metersOf(placement.size);
  message.origin = pointMessage(origin);
  message.size = vectorMessage(size);
  message.pose.position = pointMessage(origin + size / 2.0);
  setApproach(message, {});
  alignPose(message, {toMeters(type.size.x), toMeters(type.size.y), toMeters(type.size.z)});
  return message;
}

PalletState toMessage(const planning::PalletSession& session) {
  PalletState state;
  state.revision = session.revision();
  state.is_open = session.open() ? 1 : 0;
  if (!session.open()) return state;
  fillOrder(session, state);
  for (const auto& placement : session.pallet()->placements()) {
    state.placements.push_back(toMessage(placement, *session.order()));
  }
  for (const packing::Space& space : session.pallet()->spaces()) {
    Space message;
    message.min = pointMessage(metersOf(space.min));
    message.max = pointMessage(metersOf(space.max));
    state.spaces.push_back(message);
  }
  state.utilization = session.pallet()->utilization();
  state.center_of_gravity = centerOfGravity(session.summary());
  return state;
}

PalletSummary toMessage(const planning::PalletSummary& summary) {
  PalletSummary message;
  message.pallet_id = summary.pallet_id;
  message.placed = static_cast<std::uint32_t>(summary.placed);
  message.discarded = static_cast<std::uint32_t>(summary.discarded);
  message.remaining = static_cast<std::uint32_t>(summary.remaining);
  message.utilization = summary.utilization;
  message.center_of_gravity = centerOfGravity(summary);
  message.decisions = static_cast<std::uint32_t>(summary.decisions);
  message.unpacked_ratio = summary.unpacked_volume_ratio;
  message.min_support_ratio = summary.min_support_ratio;
  message.gravity_margin = toMeters(summary.gravity_margin_mm);
  message.median_decision_ms = summary.median_decision_ms;
  message.p99_decision_ms = summary.p99_decision_ms;
  message.max_decision_ms = summary.max_decision_ms;
  return message;
}

}  // namespace mixed_palletizing::adapters
