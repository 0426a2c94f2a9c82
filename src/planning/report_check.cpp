#include "report_check.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace mixed_palletizing::planning {
namespace {

std::string text(const packing::Vec3& v) {
  return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
}

}  // namespace

std::string reportProblem(const PickDecided& decided, const PickReported& report, const OpenPallet& open) {
  if (report.outcome != PickOutcome::kPlaced && report.measured) {
    return "a placement was reported for a box that was not placed";
  }
  if (report.outcome != PickOutcome::kDiscarded && !report.discarded.empty()) {
    return "items were reported as discarded, but the outcome is another";
  }
  const std::set<std::size_t> distinct(report.discarded.begin(), report.discarded.end());
  if (distinct.size() != report.discarded.size()) return "an item was reported as discarded twice";
  for (const std::size_t item : distinct) {
    if (item < decided.available.size()) continue;
    return "discarded item " + std::to_string(item) + " of " + std::to_string(decided.available.size()) +
           " available";
  }
  if (report.outcome != PickOutcome::kPlaced) return {};
  if (!decided.reply.decision.chosen) return "the decision chose no box, so none can have been placed";
  if (!report.measured) return {};
  const int type = decided.available[*decided.reply.decision.chosen];
  if (report.measured->type != type) {
    return "the measured box is of type " + std::to_string(report.measured->type) +
           ", the decision chose type " + std::to_string(type);
  }
  const packing::ItemType& item = open.order.types[static_cast<std::size_t>(type)];
  const std::vector<packing::Vec3> sizes = packing::orientations(item);
  if (std::find(sizes.begin(), sizes.end(), report.measured->size) == sizes.end()) {
    return "'" + item.name + "' may not stand with the size " + text(report.measured->size) + " mm";
  }
  return open.pallet.whyNot(*report.measured);
}

}  // namespace mixed_palletizing::planning
