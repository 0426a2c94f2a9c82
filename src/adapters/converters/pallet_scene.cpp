#include <cmath>
#include <utility>

#include <shape_msgs/SolidPrimitive.h>

#include <mixed_palletizing/adapters/converters/pallet_scene.hpp>
#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>

namespace mixed_palletizing::converters {
namespace {

using moveit_msgs::CollisionObject;

constexpr double kHighestCarrierM = 2.0;

/// A cuboid along the axes of its frame.
CollisionObject cuboid(const std_msgs::Header& header, const std::string& id, const Eigen::Vector3d& center,
                       const Eigen::Vector3d& size) {
  CollisionObject object;
  object.header = header;
  object.id = id;
  object.operation = CollisionObject::ADD;
  object.pose = adapters::poseMessage(geometry::poseFromYaw(center, 0.0));
  shape_msgs::SolidPrimitive box;
  box.type = shape_msgs::SolidPrimitive::BOX;
  box.dimensions = {size.x(), size.y(), size.z()};
  object.primitives.push_back(box);
  object.primitive_poses.push_back(adapters::poseMessage(geometry::Pose::Identity()));
  return object;
}

moveit_msgs::PlanningScene difference() {
  moveit_msgs::PlanningScene scene;
  scene.is_diff = 1;
  scene.robot_state.is_diff = 1;  // otherwise an empty state replaces the robot's
  return scene;
}

std::vector<CollisionObject> objectsOf(const PalletState& state, double carrier_height_m) {
  std::vector<CollisionObject> objects;
  if (state.is_open == 0) return objects;
  std_msgs::Header header;  // without a stamp: the frame as it is now
  header.frame_id = state.header.frame_id;
  const Eigen::Vector3d carrier(state.size.x, state.size.y, carrier_height_m);
  objects.push_back(cuboid(header, header.frame_id + "_carrier",
                           {carrier.x() / 2, carrier.y() / 2, -carrier.z() / 2}, carrier));
  for (std::size_t i = 0; i < state.placements.size(); ++i) {
    const Placement& placement = state.placements[i];
    const Eigen::Vector3d size = adapters::toEigen(placement.size);
    objects.push_back(cuboid(header, header.frame_id + "_box_" + std::to_string(i + 1),
                             adapters::toEigen(placement.origin) + size / 2, size));
    objects.back().type.key = placement.type_id;
  }
  return objects;
}

}  // namespace

std::vector<std::string> problems(const PalletSceneOptions& options) {
  const double height = options.carrier_height_m;
  if (height > 0.0 && height <= kHighestCarrierM) return {};
  return {"carrier_height_m: " + std::to_string(height) + " m is not above 0 and at most " +
          std::to_string(kHighestCarrierM)};
}

PalletSceneOptions readPalletSceneOptions(const YAML::Node& tree) {
  PalletSceneOptions options;
  adapters::OptionReader reader(tree);
  reader.read("carrier_height_m", options.carrier_height_m);
  reader.add(problems(options));
  reader.finish("parameters of pallet_to_moveit");
  return options;
}

PalletScene::PalletScene(const PalletSceneOptions& options) : options_(options) {}

std::vector<moveit_msgs::PlanningScene> PalletScene::update(const PalletState& state) {
  moveit_msgs::PlanningScene there = difference();
  there.world.collision_objects = objectsOf(state, options_.carrier_height_m);
  std::set<std::string> ids;
  for (const CollisionObject& object : there.world.collision_objects) ids.insert(object.id);

  moveit_msgs::PlanningScene gone = difference();
  for (const std::string& id : known_) {
    if (ids.count(id) > 0) continue;
    CollisionObject object;
    object.header.frame_id = frame_;
    object.id = id;
    object.operation = CollisionObject::REMOVE;
    object.pose.orientation.w = 1.0;
    gone.world.collision_objects.push_back(object);
  }
  frame_ = state.header.frame_id;
  known_ = std::move(ids);
  if (gone.world.collision_objects.empty()) return {there};
  return {gone, there};
}

}  // namespace mixed_palletizing::converters
