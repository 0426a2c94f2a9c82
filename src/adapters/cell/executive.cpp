#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include <ros/ros.h>

#include <mixed_palletizing/adapters/cell/executive.hpp>
#include <mixed_palletizing/adapters/cell/executive_services.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>

namespace mixed_palletizing::cell {

CellExecutive::CellExecutive(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : node_(node),
      options_(readCellExecutiveOptions(adapters::parameterTree(private_node))),
      instance_(cellOrder(options_.order)) {
  if (!options_.report.empty()) prepareReport(options_.report);
}

bool CellExecutive::run() {
  CellServices link(node_, options_.link);
  CellReport report;
  try {
    link.waitForAll();
    report = CellDialogue(instance_, options_.dialogue, link).run();
  } catch (const CellError& error) {
    report.message = error.what();
  }
  if (!report.capture_ms.empty()) {
    for (const std::string& line : summaryLines(report)) ROS_INFO("%s", line.c_str());
  }
  if (!options_.report.empty()) writeReport(options_.report, reportJson(report, instance_));
  if (!report.complete) {
    const std::string reason = "order " + instance_.name + " is not complete: " + report.message;
    if (ros::ok()) {
      ROS_FATAL("%s", reason.c_str());
    } else {
      std::fprintf(stderr, "%s\n", reason.c_str());  // the log is down after an interrupt
    }
    return false;
  }
  ROS_INFO("order %s is complete", instance_.name.c_str());
  hold();
  if (!ros::ok()) return true;
  try {
    link.closePallet();
  } catch (const CellError& error) {
    ROS_WARN("the pallet stays open: %s", error.what());
  }
  return true;
}

/// For those who look at the cell: the pallet stays open and its markers visible.
void CellExecutive::hold() const {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(options_.hold_s);
  while (ros::ok() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

}  // namespace mixed_palletizing::cell
