#include "panel_text.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>

#include <mixed_palletizing/adapters/units.hpp>

namespace mixed_palletizing::rviz_panel {
namespace {

std::size_t total(const std::vector<std::uint32_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string counted(std::size_t count, const char* one, const char* more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

/// A box as the markers of the detection label it.
std::string numbered(std::int64_t index) { return "#" + std::to_string(index); }

std::string millimeters(double x, double y, double z) {
  const auto mm = [](double m) { return fixed(m * adapters::kMillimetersPerMeter, 0); };
  return mm(x) + ", " + mm(y) + ", " + mm(z);
}

}  // namespace

OrderProgress orderProgress(const PalletState& state) {
  OrderProgress progress;
  progress.placed = state.placements.size();
  progress.discarded = total(state.discarded);
  for (const OrderLine& line : state.order) progress.total += line.count;
  return progress;
}

std::string palletLine(const PalletState& state) {
  if (state.is_open == 0) return "no pallet is open";
  const OrderProgress progress = orderProgress(state);
  return "pallet " + state.pallet_id + ": " + std::to_string(progress.placed) + " of " +
         std::to_string(progress.total) + " placed, " + std::to_string(progress.discarded) + " discarded";
}

std::string detectLine(const DetectBoxesResponse& answer) {
  if (answer.success == 0) return answer.message;
  std::string line = counted(answer.boxes.boxes.size(), "box", "boxes");
  if (!answer.boxes.rejected.empty()) {
    line += ", " + counted(answer.boxes.rejected.size(), "group of points is no box",
                           "groups of points are no boxes");
  }
  return line + ", " + fixed(answer.boxes.processing_ms, 0) + " ms";
}

std::string calibrateLine(const CalibrateResponse& answer) {
  if (answer.success == 0) return answer.message;
  return answer.message + " (" + counted(answer.clouds_used, "cloud", "clouds") + ", floor within " +
         fixed(answer.plane_rms * adapters::kMillimetersPerMeter, 2) + " mm)";
}

std::string chooseLine(const ChooseNextPickResponse& answer) {
  const bool picks = answer.status == ChooseNextPickResponse::PICK;
  return (picks ? numbered(answer.chosen_index) + ": " : "") + answer.message + " (" +
         fixed(answer.decision_ms, 0) + " ms)";
}

std::string closeLine(const ClosePalletResponse& answer) {
  if (answer.status != ClosePalletResponse::OK) return answer.message;
  const PalletSummary& summary = answer.summary;
  return "pallet " + summary.pallet_id + " closed: " + std::to_string(summary.placed) + " placed, " +
         std::to_string(summary.discarded) + " discarded, " + std::to_string(summary.remaining) +
         " never came, utilization " + fixed(100.0 * summary.utilization, 1) + " %";
}

std::vector<std::array<std::string, kOptionTitles.size()>> optionRows(const PickDecision& decision) {
  std::vector<std::array<std::string, kOptionTitles.size()>> rows;
  for (std::size_t i = 0; i < decision.options.size(); ++i) {
    const PickOption& option = decision.options[i];
    const geometry_msgs::Point& corner = option.placement.origin;
    const bool played = option.playouts > 0;
    rows.push_back({numbered(static_cast<std::int64_t>(i)), option.type_id.empty() ? "?" : option.type_id,
                    option.feasible != 0 ? millimeters(corner.x, corner.y, corner.z) : option.reason,
                    option.future_costs.empty() ? "" : fixed(option.future_costs.front(), 4),
                    played ? std::to_string(option.playouts) : "",
                    played ? fixed(100.0 * option.perfect_ratio, 0) + " %" : ""});
  }
  return rows;
}

}  // namespace mixed_palletizing::rviz_panel
