// What the executive asks of the cell: camera, detector, planner, gripper. A fake in tests, services in the node.
#pragma once

#include <stdexcept>
#include <string>

#include <geometry_msgs/PointStamped.h>

#include <mixed_palletizing/Calibrate.h>
#include <mixed_palletizing/ChooseNextPick.h>
#include <mixed_palletizing/DetectBoxes.h>
#include <mixed_palletizing/GetPalletState.h>
#include <mixed_palletizing/ReportPick.h>
#include <mixed_palletizing/StartPallet.h>
#include <mixed_palletizing/TakeBox.h>

namespace mixed_palletizing::cell {

/// The cell does not go on: what happened, as one line for people.
class CellError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All functions return when the answer is there and throw CellError when none comes; what the answer says is the
/// caller's business.
class CellLink {
 public:
  virtual ~CellLink() = default;

  /// Triggers the camera; the next detect() answers for this or a later cloud.
  virtual void capture() = 0;
  virtual DetectBoxesResponse detect() = 0;
  virtual CalibrateResponse calibrate() = 0;

  virtual StartPalletResponse startPallet(const StartPalletRequest& request) = 0;
  virtual ChooseNextPickResponse choose(const ChooseNextPickRequest& request) = 0;
  virtual ReportPickResponse report(const ReportPickRequest& request) = 0;
  virtual GetPalletStateResponse palletState() = 0;

  /// The robot brings a box to its place; the simulated one only lets time go by.
  virtual void move() = 0;
  virtual TakeBoxResponse take(const geometry_msgs::PointStamped& point, bool discard) = 0;

  /// Progress, one line for people.
  virtual void say(const std::string& line) = 0;
  virtual void warn(const std::string& line) = 0;
};

}  // namespace mixed_palletizing::cell
