// Private parameters of the executive.
#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/adapters/cell/executive_dialogue.hpp>
#include <mixed_palletizing/adapters/cell/order.hpp>

namespace mixed_palletizing::cell {

/// Where the executive finds the cell, and how long it waits.
struct CellLinkOptions {
  std::string camera = "zivid_camera";    ///< namespace of `capture` and `take_box`
  std::string detector = "box_detector";  ///< name of the detector
  std::string planner = "pick_planner";   ///< name of the planner
  bool triggers_camera = true;            ///< false: the detector does it, or the camera runs free
  int calibration_clouds = 0;             ///< 0 = the detector's
  double cloud_timeout_s = 10.0;          ///< how long the detector waits for a cloud
  double calibration_timeout_s = 120.0;   ///< how long a calibration may take
  double call_timeout_s =
      30.0;  ///< a service that has not answered by then (beyond the times it was given) is dead
  double service_wait_s = 30.0;  ///< how long services may take to appear, at the start or again later
  double move_s = 0.2;           ///< of ROS time: how long the pretended movement takes
};

struct CellExecutiveOptions {
  CellOrderOptions order;
  CellDialogueOptions dialogue;
  CellLinkOptions link;
  std::string report;   ///< JSON file; empty: none
  double hold_s = 0.0;  ///< how long to stay, with the pallet open, after the report is written
};

/// Every broken rule as one line "key: what is wrong".
std::vector<std::string> problems(const CellExecutiveOptions& options);

/// Reads a tree of parameters. Throws std::invalid_argument with everything that is wrong: unknown keys, wrong
/// types, broken rules.
CellExecutiveOptions readCellExecutiveOptions(const YAML::Node& tree);

}  // namespace mixed_palletizing::cell
