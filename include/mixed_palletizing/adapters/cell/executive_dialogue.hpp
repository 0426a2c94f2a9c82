// The executive's dialogue with the cell: what to ask next, and what an answer means. No ROS runs in here.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/adapters/cell/executive_link.hpp>
#include <mixed_palletizing/adapters/cell/executive_looks.hpp>
#include <mixed_palletizing/adapters/cell/executive_report.hpp>
#include <mixed_palletizing/instances/instance.hpp>

namespace mixed_palletizing::cell {

struct CellDialogueOptions {
  std::string pallet_id;       ///< empty = the order's name
  bool close_open = false;     ///< close a pallet that is still open instead of refusing
  double time_budget_s = 0.0;  ///< of one decision; 0 = the planner's
  int retries = 3;  ///< further looks when something was not seen or not identified, before it is thrown out
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const CellDialogueOptions& options);

/// Plays one order: look (capture, detect, once calibrate), choose, move, report, take away, until nothing of the
/// order is left. Boxes that cannot be identified in `retries` + 1 looks in a row are thrown out; so are all when
/// none fits.
class CellDialogue {
 public:
  /// Throws std::invalid_argument with every line of problems(options). The link must outlive the dialogue.
  CellDialogue(const instances::Instance& instance, const CellDialogueOptions& options, CellLink& link);

  /// To the end of the order, or as far as the cell goes: then the report says why. Throws nothing that a link or
  /// an answer causes.
  CellReport run();

 private:
  void start();
  bool step();
  void handleEmpty(const CellLook& look);
  ChooseNextPickResponse choose(const CellLook& look);
  void pick(const CellLook& look, const ChooseNextPickResponse& answer);
  void discardAll(const CellLook& look, const ChooseNextPickResponse& answer);
  void throwOutUnidentified(const CellLook& look, const ChooseNextPickResponse& answer);
  TakeBoxResponse take(const std_msgs::Header& header, const geometry_msgs::Point& point, bool discard);
  void throwOut(const std_msgs::Header& header, const geometry_msgs::Point& point, DiscardRecord record);
  void reportOutcome(std::uint64_t decision_id, std::uint8_t outcome);
  void finish();

  const instances::Instance instance_;
  const CellDialogueOptions options_;
  CellLink& link_;
  CellLooks looks_;
  CellReport report_;
  std::size_t total_ = 0;  // boxes of the order
  std::size_t done_ = 0;   // placed, or discarded from the order
  std::size_t requests_ = 0;
  int empty_looks_ = 0;         // in a row
  int unidentified_looks_ = 0;  // in a row
};

}  // namespace mixed_palletizing::cell
