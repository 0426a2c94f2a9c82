// The detector as a node of its own.
#include <cstdio>
#include <exception>

#include <ros/init.h>
#include <ros/spinner.h>

#include <mixed_palletizing/adapters/detector_server.hpp>
#include <mixed_palletizing/adapters/master_watch.hpp>

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "box_detector");
    const mixed_palletizing::adapters::DetectorServer server(ros::NodeHandle("~"));
    const mixed_palletizing::adapters::MasterWatch watch(mixed_palletizing::adapters::endNode);
    ros::spin();
    if (watch.forgotten()) return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "box_detector does not start: %s\n", error.what());
    return 1;
  }
  return 0;
}
