// The robot executive in small: plays one order to its end. Parameters: config/cell_executive.yaml.
#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include <mixed_palletizing/adapters/cell/executive.hpp>

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // warnings on stderr must not cut lines in a log of both
  try {
    ros::init(argc, argv, "cell_executive");
    const ros::NodeHandle node;
    const ros::NodeHandle private_node("~");
    return mixed_palletizing::cell::CellExecutive(node, private_node).run() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cell_executive: %s\n", error.what());  // the log is down by now
    return 1;
  }
}
