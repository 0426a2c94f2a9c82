#include "simulated_pick_area.hpp"

#include <mixed_palletizing/TakeBox.h>

namespace mixed_palletizing::rviz_panel {
namespace {

constexpr char kTakeBox[] = "zivid_camera/take_box";

}  // namespace

LeavingBoxes leavingBoxes(const BoxArray& seen, const ChooseNextPickResponse& answer) {
  LeavingBoxes leaving;
  leaving.decision_id = answer.decision_id;
  const bool picks = answer.status == ChooseNextPickResponse::PICK;
  if (!picks && answer.status != ChooseNextPickResponse::NONE_FITS) return leaving;
  for (std::size_t i = 0; i < seen.boxes.size(); ++i) {
    if (picks && static_cast<std::int64_t>(i) != answer.chosen_index) continue;
    geometry_msgs::PointStamped top;
    top.header = seen.header;
    top.point = seen.boxes[i].top_center;
    leaving.tops.push_back(top);
  }
  return leaving;
}

std::string takeFromSimulation(CellLink& link, const LeavingBoxes& boxes, bool discard) {
  if (boxes.tops.empty() || !link.has(kTakeBox)) return "";
  std::string what;
  for (const geometry_msgs::PointStamped& top : boxes.tops) {
    TakeBoxRequest request;
    request.point = top;
    request.discard = discard ? 1 : 0;
    what = "simulated robot: " + link.call<TakeBox>(kTakeBox, request).message;
  }
  return what;
}

}  // namespace mixed_palletizing::rviz_panel
