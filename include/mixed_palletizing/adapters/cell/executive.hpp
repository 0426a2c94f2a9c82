// The robot executive in small, as a node.
#pragma once

#include <ros/node_handle.h>

#include <mixed_palletizing/adapters/cell/executive_options.hpp>
#include <mixed_palletizing/instances/instance.hpp>

namespace mixed_palletizing::cell {

/// Plays one order to its end, prints a line per pick and a summary, writes the report (also when it fails), and
/// closes the pallet of a complete order.
class CellExecutive {
 public:
  /// Throws std::invalid_argument with all wrong parameters, std::runtime_error when a file cannot be read or
  /// written.
  CellExecutive(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// True when the order is complete and the report written. What went wrong is logged in one line.
  bool run();

 private:
  void hold() const;

  ros::NodeHandle node_;
  const CellExecutiveOptions options_;
  const instances::Instance instance_;
};

}  // namespace mixed_palletizing::cell
