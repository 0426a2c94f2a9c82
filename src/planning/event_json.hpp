// Events of a session as JSON and back.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/planning/session_state.hpp>

namespace mixed_palletizing::planning {

/// "started", "decided", "reported", "undone", "closed".
std::string kindOf(const SessionEvent& event);

nlohmann::json toJson(const SessionEvent& event);

constexpr int kMaxEventDepth = 16;

/// The JSON of an event's text. Throws nlohmann's exceptions, and std::invalid_argument beyond kMaxEventDepth.
nlohmann::json parseEvent(const std::string& text);

/// Throws std::invalid_argument or nlohmann's exceptions for what toJson() did not make.
SessionEvent eventFromJson(const std::string& kind, const nlohmann::json& body);

nlohmann::json toJson(const packing::Order& order);
nlohmann::json toJson(const PickOption& option);
nlohmann::json toJson(const packing::Placement& placement);

}  // namespace mixed_palletizing::planning
