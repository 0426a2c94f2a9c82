#include "event_json.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace mixed_palletizing::planning {
namespace {

using nlohmann::json;

json triple(const packing::Vec3& v) { return json::array({v.x, v.y, v.z}); }

/// The JSON library casts what is written as 1e99, and what does not fit.
template <typename T>
T wholeFrom(const json& j) {
  if (!j.is_number_integer()) throw std::invalid_argument(std::string(j.type_name()) + " is no whole number");
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<T>::max());
  const bool negative = !j.is_number_unsigned() && j.get<std::int64_t>() < 0;
  const bool in_range =
      negative ? j.get<std::int64_t>() >= static_cast<std::int64_t>(std::numeric_limits<T>::min())
               : j.get<std::uint64_t>() <= kMost;
  if (!in_range) throw std::invalid_argument(j.dump() + " is out of range");
  return j.get<T>();
}

template <typename T>
std::vector<T> wholesFrom(const json& j) {
  std::vector<T> values;
  for (const json& value : j) values.push_back(wholeFrom<T>(value));
  return values;
}

packing::Vec3 tripleFrom(const json& j) {
  return {wholeFrom<int>(j.at(0)), wholeFrom<int>(j.at(1)), wholeFrom<int>(j.at(2))};
}

packing::Placement placementFrom(const json& j) {
  return {wholeFrom<int>(j.at("type")), tripleFrom(j.at("origin_mm")), tripleFrom(j.at("size_mm"))};
}

packing::Order orderFrom(const json& j) {
  packing::Order order;
  order.rules.size = tripleFrom(j.at("pallet_mm"));
  order.rules.gap = wholeFrom<int>(j.at("gap_mm"));
  order.rules.min_support_ratio = j.at("min_support_ratio").get<double>();
  order.rules.overhang = wholeFrom<int>(j.at("overhang_mm"));
  order.rules.max_weight_kg = j.at("max_weight_kg").get<double>();
  for (const json& line : j.at("items")) {
    packing::ItemType type;
    type.name = line.at("type").get<std::string>();
    type.size = tripleFrom(line.at("size_mm"));
    type.rotations.yaw = line.at("yaw").get<bool>();
    for (std::size_t i = 0; i < 3; ++i) type.rotations.vertical[i] = line.at("vertical").at(i).get<bool>();
    type.weight_kg = line.at("weight_kg").get<double>();
    type.max_load_kg = line.at("max_load_kg").get<double>();
    order.types.push_back(type);
    order.counts.push_back(wholeFrom<int>(line.at("count")));
  }
  return order;
}

PickOption optionFrom(const json& j) {
  PickOption option;
  option.feasible = j.at("feasible").get<bool>();
  option.reason = j.value("reason", std::string());
  option.looked_at = j.value("looked_at", true);
  if (!option.feasible) return option;
  option.placement = placementFrom(j.at("placement"));
  option.future_costs = j.at("future_costs").get<std::vector<double>>();
  option.future.playouts = wholeFrom<int>(j.at("playouts"));
  option.future.perfect_ratio = j.at("perfect_ratio").get<double>();
  option.future.unpacked_ratio = j.at("unpacked_ratio").get<double>();
  return option;
}

constexpr std::array<Knowledge, 3> kKnowledge{Knowledge::kSet, Knowledge::kForecast, Knowledge::kTypes};

json body(const PalletStarted& e) {
  return {{"pallet_id", e.pallet_id},
          {"order", toJson(e.order)},
          {"knowledge", toString(e.knowledge.kind)},
          {"expected", e.knowledge.expected}};
}

/// Journals of older planners tell nothing: the set was known.
OrderKnowledge knowledgeFrom(const json& j) {
  const std::string word = j.value("knowledge", toString(Knowledge::kSet));
  const auto found = std::find_if(kKnowledge.begin(), kKnowledge.end(),
                                  [&](Knowledge kind) { return word == toString(kind); });
  if (found == kKnowledge.end()) throw std::invalid_argument("knowledge '" + word + "' is not known");
  return {*found, j.value("expected", std::vector<double>())};
}

/// Items of one type have one option: it is written once, in the order of their first items.
json optionsJson(const PickDecided& e) {
  json options = json::array();
  std::set<int> written;
  for (std::size_t i = 0; i < e.available.size(); ++i) {
    if (written.insert(e.available[i]).second) options.push_back(toJson(e.reply.decision.options[i]));
  }
  return options;
}

std::vector<PickOption> optionsFrom(const json& j, const std::vector<int>& available) {
  std::vector<PickOption> read;
  for (const json& option : j) read.push_back(optionFrom(option));
  if (read.size() == available.size()) return read;  // all of one type each, or an older planner's
  std::vector<PickOption> options;
  std::map<int, std::size_t> index_of_type;
  for (const int type : available) {
    const std::size_t index = index_of_type.emplace(type, index_of_type.size()).first->second;
    if (index >= read.size()) throw std::invalid_argument("options: fewer than types");
    options.push_back(read[index]);
  }
  return options;
}

json body(const PickDecided& e) {
  json j{{"request_id", e.request_id},
         {"available", e.available},
         {"decision_id", e.reply.decision_id},
         {"message", e.reply.message},
         {"options", optionsJson(e)},
         {"assumed", e.reply.assumed},
         {"pondered", e.reply.pondered},
         {"decision_ms", e.decision_ms},
         {"request_index", e.notes.request_index},
         {"box_sizes_m", e.notes.box_sizes_m}};
  if (e.reply.decision.chosen) j["chosen"] = *e.reply.decision.chosen;
  return j;
}

json body(const PickReported& e) {
  json j{{"decision_id", e.decision_id}, {"outcome", toString(e.outcome)}, {"discarded", e.discarded}};
  if (e.measured) j["measured"] = toJson(*e.measured);
  return j;
}

json body(const LastUndone&) { return json::object(); }
json body(const PalletClosed&) { return json::object(); }

PickDecided decidedFrom(const json& j) {
  PickDecided e;
  e.request_id = j.at("request_id").get<std::string>();
  e.available = wholesFrom<int>(j.at("available"));
  e.reply.decision_id = wholeFrom<std::uint64_t>(j.at("decision_id"));
  e.reply.message = j.at("message").get<std::string>();
  e.reply.decision.options = optionsFrom(j.at("options"), e.available);
  e.reply.assumed = j.value("assumed", std::string());
  e.reply.pondered = j.value("pondered", false);
  if (j.count("chosen") != 0) e.reply.decision.chosen = wholeFrom<std::size_t>(j.at("chosen"));
  e.reply.status = e.reply.decision.chosen ? ChooseStatus::kPick : ChooseStatus::kNoneFits;
  e.decision_ms = j.at("decision_ms").get<double>();
  e.notes.request_index = wholesFrom<std::size_t>(j.at("request_index"));
  e.notes.box_sizes_m = j.at("box_sizes_m").get<std::vector<std::array<double, 3>>>();
  return e;
}

PickReported reportedFrom(const json& j) {
  PickReported e;
  e.decision_id = wholeFrom<std::uint64_t>(j.at("decision_id"));
  const std::string outcome = j.at("outcome").get<std::string>();
  bool known = false;
  for (const PickOutcome word : {PickOutcome::kPlaced, PickOutcome::kDiscarded, PickOutcome::kFailed}) {
    if (outcome != toString(word)) continue;
    e.outcome = word;
    known = true;
  }
  if (!known) throw std::invalid_argument("outcome '" + outcome + "' is not known");
  e.discarded = wholesFrom<std::size_t>(j.at("discarded"));
  if (j.count("measured") != 0) e.measured = placementFrom(j.at("measured"));
  return e;
}

}  // namespace

nlohmann::json toJson(const packing::Placement& placement) {
  return {
      {"type", placement.type}, {"origin_mm", triple(placement.origin)}, {"size_mm", triple(placement.size)}};
}

nlohmann::json toJson(const PickOption& option) {
  json j{{"feasible", option.feasible}};
  if (!option.reason.empty()) j["reason"] = option.reason;
  if (!option.looked_at) j["looked_at"] = false;
  if (!option.feasible) return j;
  j["placement"] = toJson(option.placement);
  j["future_costs"] = option.future_costs;
  j["playouts"] = option.future.playouts;
  j["perfect_ratio"] = option.future.perfect_ratio;
  j["unpacked_ratio"] = option.future.unpacked_ratio;
  return j;
}

nlohmann::json toJson(const packing::Order& order) {
  json items = json::array();
  for (std::size_t i = 0; i < order.types.size(); ++i) {
    const packing::ItemType& type = order.types[i];
    items.push_back({{"type", type.name},
                     {"size_mm", triple(type.size)},
                     {"count", order.counts[i]},
                     {"yaw", type.rotations.yaw},
                     {"vertical", type.rotations.vertical},
                     {"weight_kg", type.weight_kg},
                     {"max_load_kg", type.max_load_kg}});
  }
  return {{"pallet_mm", triple(order.rules.size)},
          {"gap_mm", order.rules.gap},
          {"min_support_ratio", order.rules.min_support_ratio},
          {"overhang_mm", order.rules.overhang},
          {"max_weight_kg", order.rules.max_weight_kg},
          {"items", items}};
}

std::string kindOf(const SessionEvent& event) {
  constexpr std::array<const char*, std::variant_size_v<SessionEvent>> kKinds{"started", "decided",
                                                                              "reported", "undone", "closed"};
  return kKinds.at(event.index());
}

nlohmann::json toJson(const SessionEvent& event) {
  return std::visit([](const auto& e) { return body(e); }, event);
}

nlohmann::json parseEvent(const std::string& text) {
  const auto watch = [](int depth, json::parse_event_t, json&) {
    if (depth <= kMaxEventDepth) return true;
    throw std::invalid_argument("more than " + std::to_string(kMaxEventDepth) + " levels of JSON");
  };
  return json::parse(text, watch);
}

SessionEvent eventFromJson(const std::string& kind, const nlohmann::json& j) {
  if (kind == "started")
    return PalletStarted{j.at("pallet_id").get<std::string>(), orderFrom(j.at("order")), knowledgeFrom(j)};
  if (kind == "decided") return decidedFrom(j);
  if (kind == "reported") return reportedFrom(j);
  if (kind == "undone") return LastUndone{};
  if (kind == "closed") return PalletClosed{};
  throw std::invalid_argument("event '" + kind + "' is not known");
}

}  // namespace mixed_palletizing::planning
