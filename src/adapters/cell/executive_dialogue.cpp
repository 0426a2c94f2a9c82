#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/adapters/cell/executive_dialogue.hpp>
#include <mixed_palletizing/adapters/start_request.hpp>

namespace mixed_palletizing::cell {
namespace {

constexpr int kMostRetries = 1000;
constexpr double kMostSeconds = 3600.0;

bool isIdentified(const PickOption& option) {
  return option.status != PickOption::UNKNOWN_BOX && option.status != PickOption::AMBIGUOUS_BOX;
}

double volumeOf(const geometry_msgs::Vector3& size) { return size.x * size.y * size.z; }

/// The largest group of points that is no box.
const RejectedCluster& largest(const std::vector<RejectedCluster>& clusters) {
  return *std::max_element(clusters.begin(), clusters.end(),
                           [](const RejectedCluster& a, const RejectedCluster& b) {
                             return volumeOf(a.extent) < volumeOf(b.extent);
                           });
}

}  // namespace

std::vector<std::string> problems(const CellDialogueOptions& options) {
  std::vector<std::string> all;
  if (options.retries < 0 || options.retries > kMostRetries) {
    all.push_back("retries: " + std::to_string(options.retries) + " is not in [0, " +
                  std::to_string(kMostRetries) + "]");
  }
  if (!(options.time_budget_s >= 0.0 && options.time_budget_s <= kMostSeconds)) {
    all.push_back("time_budget_s: " + std::to_string(options.time_budget_s) + " is not in [0, 3600] s");
  }
  return all;
}

CellDialogue::CellDialogue(const instances::Instance& instance, const CellDialogueOptions& options,
                           CellLink& link)
    : instance_(instance),
      options_(options),
      link_(link),
      looks_(link, options.retries),
      total_(static_cast<std::size_t>(instance.order.itemCount())) {
  const std::vector<std::string> broken = problems(options);
  if (!broken.empty()) throw std::invalid_argument("CellDialogue: options: " + broken.front());
  report_.pallet_id = options.pallet_id.empty() ? instance.name : options.pallet_id;
}

CellReport CellDialogue::run() {
  try {
    start();
    while (step()) {
    }
    report_.complete = true;
  } catch (const std::exception& error) {
    report_.message = error.what();
  }
  return report_;
}

void CellDialogue::start() {
  StartPalletRequest request = adapters::startRequest(report_.pallet_id, instance_.order);
  request.close_open = options_.close_open;
  const StartPalletResponse response = link_.startPallet(request);
  if (response.status != StartPalletResponse::OK) throw CellError("start_pallet: " + response.message);
  link_.say("pallet " + report_.pallet_id + ": " + std::to_string(total_) + " boxes of " +
            std::to_string(instance_.order.types.size()) + " types");
}

bool CellDialogue::step() {
  if (done_ >= total_) {
    finish();
    return false;
  }
  const CellLook seen = looks_.look();
  report_.capture_ms.push_back(seen.capture_ms);
  report_.detection_ms.push_back(seen.detection_ms);
  if (seen.seen.boxes.empty()) {
    handleEmpty(seen);
    return true;
  }
  empty_looks_ = 0;
  const ChooseNextPickResponse answer = choose(seen);
  switch (answer.status) {
    case ChooseNextPickResponse::PICK:
      throwOutUnidentified(seen, answer);
      pick(seen, answer);
      return true;
    case ChooseNextPickResponse::NONE_FITS:
      throwOutUnidentified(seen, answer);
      discardAll(seen, answer);
      return true;
    case ChooseNextPickResponse::UNKNOWN_BOX:
    case ChooseNextPickResponse::AMBIGUOUS_BOX:
      link_.warn(answer.message);
      throwOutUnidentified(seen, answer);
      return true;
    case ChooseNextPickResponse::ORDER_COMPLETE:
      finish();
      return false;
    default:
      throw CellError("choose_next_pick: " + answer.message);
  }
}

void CellDialogue::handleEmpty(const CellLook& look) {
  unidentified_looks_ = 0;
  if (++empty_looks_ <= options_.retries) {
    link_.warn("no box is seen; looking again");
    return;
  }
  empty_looks_ = 0;
  if (look.seen.rejected.empty()) {
    throw CellError("the pick area is empty, but " + std::to_string(total_ - done_) + " of " +
                    std::to_string(total_) + " boxes of the order have not been packed");
  }
  // One at a time: the next boxes may already lie where another group of points was.
  const RejectedCluster& cluster = largest(look.seen.rejected);
  link_.warn("threw out what is no box: " + cluster.text);
  throwOut(look.seen.header, cluster.centroid, {"", cluster.text, {}, 0});
}

ChooseNextPickResponse CellDialogue::choose(const CellLook& look) {
  ChooseNextPickRequest request;
  request.request_id = report_.pallet_id + "/" + std::to_string(++requests_);
  request.boxes = look.seen.boxes;
  request.time_budget = options_.time_budget_s;
  ChooseNextPickResponse answer = link_.choose(request);
  report_.decision_ms.push_back(answer.decision_ms);
  const std::size_t count = request.boxes.size();
  const bool judged = answer.status <= ChooseNextPickResponse::AMBIGUOUS_BOX &&
                      answer.status != ChooseNextPickResponse::ORDER_COMPLETE &&
                      answer.status != ChooseNextPickResponse::NO_PALLET;
  if (judged && answer.options.size() != count) {
    throw CellError("choose_next_pick: " + std::to_string(answer.options.size()) + " options for " +
                    std::to_string(count) + " boxes");
  }
  if (answer.status == ChooseNextPickResponse::PICK &&
      (answer.chosen_index < 0 || static_cast<std::size_t>(answer.chosen_index) >= count ||
       answer.placement.type_index >= instance_.order.types.size())) {
    throw CellError("choose_next_pick: chose box " + std::to_string(answer.chosen_index) + " of " +
                    std::to_string(count) + ", type " + std::to_string(answer.placement.type_index));
  }
  return answer;
}

void CellDialogue::pick(const CellLook& look, const ChooseNextPickResponse& answer) {
  const Box& box = look.seen.boxes[static_cast<std::size_t>(answer.chosen_index)];
  link_.move();
  reportOutcome(answer.decision_id, ReportPickRequest::PLACED);
  const TakeBoxResponse taken = take(look.seen.header, box.top_center, false);
  if (taken.type_id != answer.type_id) {
    throw CellError("take_box: the box that was packed as " + answer.type_id + " is a " + taken.type_id);
  }
  ++done_;

  const packing::ItemType& type = instance_.order.types[answer.placement.type_index];
  PickRecord record = pickRecord(box, answer.placement, type.size);
  record.type_id = answer.type_id;
  record.item = taken.item;
  record.decision_id = answer.decision_id;
  record.available = look.seen.boxes.size();
  record.capture_ms = look.capture_ms;
  record.detection_ms = look.detection_ms;
  record.decision_ms = answer.decision_ms;
  const double pallet_mm3 = static_cast<double>(packing::volume(instance_.order.rules.size));
  const auto& size = record.placed_size_mm;
  record.utilization = report_.utilization + size[0] * size[1] * size[2] / pallet_mm3;
  report_.utilization = record.utilization;
  report_.picks.push_back(record);
  link_.say(progressLine(record, done_, total_));
}

void CellDialogue::discardAll(const CellLook& look, const ChooseNextPickResponse& answer) {
  reportOutcome(answer.decision_id, ReportPickRequest::DISCARDED);
  for (std::size_t i = 0; i < look.seen.boxes.size(); ++i) {
    const PickOption& option = answer.options[i];
    if (!isIdentified(option)) continue;
    const Box& box = look.seen.boxes[i];
    link_.warn("discarded " + option.type_id + ": " + option.reason);
    throwOut(look.seen.header, box.top_center, {option.type_id, option.reason, measuredSize(box), 0});
    ++done_;
  }
}

/// Every look at a box that cannot be identified is a try; after the last one it goes.
void CellDialogue::throwOutUnidentified(const CellLook& look, const ChooseNextPickResponse& answer) {
  const bool all_known = std::all_of(answer.options.begin(), answer.options.end(), isIdentified);
  unidentified_looks_ = all_known ? 0 : unidentified_looks_ + 1;
  if (unidentified_looks_ <= options_.retries) return;
  unidentified_looks_ = 0;
  for (std::size_t i = 0; i < look.seen.boxes.size(); ++i) {
    if (isIdentified(answer.options[i])) continue;
    const Box& box = look.seen.boxes[i];
    link_.warn("threw out a box that was not identified: " + answer.options[i].reason);
    throwOut(look.seen.header, box.top_center, {"", answer.options[i].reason, measuredSize(box), 0});
  }
}

TakeBoxResponse CellDialogue::take(const std_msgs::Header& header, const geometry_msgs::Point& point,
                                   bool discard) {
  geometry_msgs::PointStamped where;
  where.header = header;
  where.point = point;
  const TakeBoxResponse response = link_.take(where, discard);
  if (!response.success) throw CellError("take_box: " + response.message);
  return response;
}

void CellDialogue::throwOut(const std_msgs::Header& header, const geometry_msgs::Point& point,
                            DiscardRecord record) {
  record.item = take(header, point, true).item;
  report_.discards.push_back(std::move(record));
}

void CellDialogue::reportOutcome(std::uint64_t decision_id, std::uint8_t outcome) {
  ReportPickRequest request;
  request.decision_id = decision_id;
  request.outcome = outcome;
  const ReportPickResponse response = link_.report(request);
  if (response.status != ReportPickResponse::OK) throw CellError("report_pick: " + response.message);
}

/// The planner has the last word on what is left.
void CellDialogue::finish() {
  const GetPalletStateResponse response = link_.palletState();
  if (response.status != GetPalletStateResponse::OK) throw CellError("get_pallet_state: " + response.message);
  std::size_t remaining = 0;
  for (const std::uint32_t count : response.state.remaining) remaining += count;
  if (remaining > 0) {
    throw CellError("the planner still waits for " + std::to_string(remaining) + " boxes");
  }
  report_.utilization = response.state.utilization;
}

}  // namespace mixed_palletizing::cell
