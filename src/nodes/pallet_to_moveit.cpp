// The pallet and what stands on it as obstacles for MoveIt.
#include <cstdio>
#include <exception>
#include <string>

#include <ros/ros.h>

#include <mixed_palletizing/adapters/converters/pallet_scene.hpp>
#include <mixed_palletizing/adapters/master_watch.hpp>
#include <mixed_palletizing/adapters/names.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace converters = mixed_palletizing::converters;

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, "pallet_to_moveit");
    ros::NodeHandle node;
    converters::PalletScene scene(
        converters::readPalletSceneOptions(adapters::parameterTree(ros::NodeHandle("~"))));
    constexpr std::uint32_t kQueue = 10;
    const ros::Publisher publisher =
        node.advertise<moveit_msgs::PlanningScene>(adapters::names::kPlanningScene, kQueue, true);
    const ros::Subscriber subscriber = node.subscribe<mixed_palletizing::PalletState>(
        std::string("pick_planner/") + adapters::names::kPalletState, kQueue,
        [&](const mixed_palletizing::PalletStateConstPtr& state) {
          for (const auto& message : scene.update(*state)) publisher.publish(message);
        });
    const adapters::MasterWatch watch(adapters::endNode);
    ros::spin();
    if (watch.forgotten()) return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pallet_to_moveit does not start: %s\n", error.what());
    return 1;
  }
  return 0;
}
