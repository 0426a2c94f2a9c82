#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <mixed_palletizing/planning/journal_export.hpp>

#include "event_json.hpp"

namespace mixed_palletizing::planning {
namespace {

using nlohmann::json;

constexpr int kIndent = 2;

const PalletStarted& startOf(const std::vector<JournalEntry>& entries) {
  return std::get<PalletStarted>(entries.at(0).event);
}

bool isClosed(const std::vector<JournalEntry>& entries) {
  return std::holds_alternative<PalletClosed>(entries.back().event);
}

/// As in the journal, but with an option for every available item.
json eventJson(const SessionEvent& event) {
  json j = toJson(event);
  const auto* decided = std::get_if<PickDecided>(&event);
  if (decided == nullptr) return j;
  j["options"] = json::array();
  for (const PickOption& option : decided->reply.decision.options) j["options"].push_back(toJson(option));
  return j;
}

/// The state after the last event that is no close.
SessionState lastOpen(std::vector<JournalEntry> entries) {
  if (isClosed(entries)) entries.pop_back();
  return replay(entries);
}

std::vector<std::vector<JournalEntry>> byPallet(const std::vector<JournalEntry>& entries) {
  std::vector<std::vector<JournalEntry>> pallets;
  for (const JournalEntry& entry : entries) {
    if (pallets.empty() || pallets.back().back().pallet != entry.pallet) pallets.emplace_back();
    pallets.back().push_back(entry);
  }
  return pallets;
}

int total(const std::vector<int>& counts) { return std::accumulate(counts.begin(), counts.end(), 0); }

std::string text(const packing::Placement& p, const packing::Order& order) {
  const auto triple = [](const packing::Vec3& v) {
    return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
  };
  return "'" + order.types.at(static_cast<std::size_t>(p.type)).name + "' at " + triple(p.origin) + " of " +
         triple(p.size) + " mm";
}

/// What an event says, to people.
struct Words {
  const packing::Order& order;

  std::string operator()(const PalletStarted& e) const {
    return "started '" + e.pallet_id + "' with " + std::to_string(e.order.itemCount()) + " items";
  }
  std::string operator()(const PickDecided& e) const {
    return "decision " + std::to_string(e.reply.decision_id) + ": " + e.reply.message;
  }
  std::string operator()(const PickReported& e) const {
    return "decision " + std::to_string(e.decision_id) + " " + toString(e.outcome) +
           (e.measured ? ", measured " + text(*e.measured, order) : "");
  }
  std::string operator()(const LastUndone&) const { return "last report taken back"; }
  std::string operator()(const PalletClosed&) const { return "closed"; }
};

}  // namespace

std::vector<JournalEntry> entriesOf(const std::vector<JournalEntry>& entries, const std::string& pallet_id) {
  const auto pallets = byPallet(entries);
  const auto found = std::find_if(pallets.rbegin(), pallets.rend(), [&](const auto& pallet) {
    return pallet_id.empty() || startOf(pallet).pallet_id == pallet_id;
  });
  if (found == pallets.rend()) {
    throw std::invalid_argument(pallet_id.empty() ? "the journal has no pallet"
                                                  : "the journal has no pallet '" + pallet_id + "'");
  }
  return *found;
}

std::string palletList(const std::vector<JournalEntry>& entries) {
  std::string lines;
  for (const auto& pallet : byPallet(entries)) {
    const SessionState state = lastOpen(pallet);
    const OpenPallet& open = *state.open();
    lines += std::to_string(pallet.front().pallet) + "  " + pallet.front().time + "  " + open.id + "  " +
             std::to_string(open.pallet.placements().size()) + " placed, " +
             std::to_string(total(open.discarded)) + " discarded, " + std::to_string(total(open.remaining)) +
             " to come, " + (isClosed(pallet) ? "closed" : "open") + "\n";
  }
  return lines;
}

std::string palletHistory(const std::vector<JournalEntry>& entries) {
  std::string lines;
  for (const JournalEntry& entry : entries) {
    lines += std::to_string(entry.sequence) + "  " + entry.time + "  revision " +
             std::to_string(entry.revision) + "  " + std::visit(Words{startOf(entries).order}, entry.event) +
             "\n";
  }
  return lines;
}

std::string palletJson(const std::vector<JournalEntry>& entries) {
  const SessionState state = lastOpen(entries);
  const OpenPallet& open = *state.open();
  json placements = json::array();
  for (const packing::Placement& p : open.pallet.placements()) placements.push_back(toJson(p));
  json history = json::array();
  for (const JournalEntry& entry : entries) {
    history.push_back({{"sequence", entry.sequence},
                       {"time", entry.time},
                       {"revision", entry.revision},
                       {"kind", kindOf(entry.event)},
                       {"event", eventJson(entry.event)}});
  }
  json pallet{{"pallet_id", open.id},        {"revision", state.revision()},
              {"open", !isClosed(entries)},  {"order", toJson(open.order)},
              {"placements", placements},    {"remaining", open.remaining},
              {"discarded", open.discarded}, {"utilization", open.pallet.utilization()},
              {"pending", nullptr},          {"history", history}};
  if (!open.decisions.empty()) pallet["pending"] = eventJson(*open.decisions.back());
  return pallet.dump(kIndent);
}

}  // namespace mixed_palletizing::planning
