// The planner: a plain node, so that a fault in it cannot take the camera's manager down.
#include <cstdio>
#include <exception>

#include <ros/init.h>
#include <ros/spinner.h>

#include <mixed_palletizing/adapters/master_watch.hpp>
#include <mixed_palletizing/adapters/planner_server.hpp>

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "pick_planner");
    const mixed_palletizing::adapters::PlannerServer server(ros::NodeHandle("~"));
    const mixed_palletizing::adapters::MasterWatch watch(mixed_palletizing::adapters::endNode);
    constexpr std::uint32_t kThreads = 4;  // get_pallet_state answers while others wait for a decision
    ros::MultiThreadedSpinner spinner(kThreads);
    spinner.spin();
    if (watch.forgotten()) return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pick_planner does not start: %s\n", error.what());
    return 1;
  }
  return 0;
}
