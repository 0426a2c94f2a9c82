// The simulated cell: a camera driver before a pick area of boxes. Parameters: config/cell_simulator.yaml.
#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include <mixed_palletizing/adapters/cell/simulator.hpp>

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "cell_simulator");
    const ros::NodeHandle node;
    const ros::NodeHandle private_node("~");
    const mixed_palletizing::cell::CellSimulator simulator(node, private_node);
    ros::spin();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cell_simulator: %s\n", error.what());  // the log is down by now
    return 1;
  }
}
