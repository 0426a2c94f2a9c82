// The detector as a node of its own.
#include <cstdio>
#include <exception>

#include <ros/init.h>
#include <ros/spinner.h>

#include <mixed_palletizing/adapters/detector_server.hpp>

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "box_detector");
    const mixed_palletizing::adapters::DetectorServer server(ros::NodeHandle("~"));
    ros::spin();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "box_detector does not start: %s\n", error.what());
    return 1;
  }
  return 0;
}
