#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/converters/pallet_scene.hpp>

namespace mixed_palletizing::converters {
namespace {

using moveit_msgs::CollisionObject;

PalletState pallet(std::size_t placed) {
  PalletState state;
  state.header.frame_id = "left_pallet";
  state.is_open = 1;
  state.size.x = 1.2;
  state.size.y = 0.8;
  state.size.z = 0.6;
  for (std::size_t i = 0; i < placed; ++i) {
    Placement placement;
    placement.type_id = "t" + std::to_string(i);
    placement.origin.x = 0.1 * static_cast<double>(i);
    placement.size.x = 0.1;
    placement.size.y = 0.2;
    placement.size.z = 0.3;
    state.placements.push_back(placement);
  }
  return state;
}

/// What MoveIt knows after the differences: ADD replaces, REMOVE must know what it takes away.
class World {
 public:
  void apply(const moveit_msgs::PlanningScene& scene) {
    EXPECT_TRUE(scene.is_diff);
    EXPECT_TRUE(scene.robot_state.is_diff);
    for (const CollisionObject& object : scene.world.collision_objects) {
      EXPECT_EQ(object.header.frame_id, "left_pallet");
      EXPECT_DOUBLE_EQ(object.pose.orientation.w, 1.0);
      if (object.operation == CollisionObject::REMOVE) {
        EXPECT_EQ(objects.erase(object.id), 1u) << object.id;
      } else {
        EXPECT_EQ(object.operation, CollisionObject::ADD);
        EXPECT_EQ(object.primitives.size(), object.primitive_poses.size());
        objects[object.id] = object;
      }
    }
  }
  std::map<std::string, CollisionObject> objects;
};

TEST(PalletScene, carrierAndBoxesStandWhereTheyAre) {
  PalletScene scene({0.15});
  World world;
  for (const auto& message : scene.update(pallet(2))) world.apply(message);
  ASSERT_EQ(world.objects.size(), 3u);
  const CollisionObject& carrier = world.objects.at("left_pallet_carrier");
  EXPECT_DOUBLE_EQ(carrier.pose.position.x, 0.6);
  EXPECT_DOUBLE_EQ(carrier.pose.position.y, 0.4);
  EXPECT_DOUBLE_EQ(carrier.pose.position.z, -0.075);  // its top is the pallet's z = 0
  EXPECT_DOUBLE_EQ(carrier.primitives.at(0).dimensions.at(2), 0.15);
  const CollisionObject& box = world.objects.at("left_pallet_box_2");
  EXPECT_EQ(box.type.key, "t1");
  EXPECT_EQ(box.primitives.at(0).type, shape_msgs::SolidPrimitive::BOX);
  EXPECT_DOUBLE_EQ(box.primitives.at(0).dimensions.at(1), 0.2);
  EXPECT_DOUBLE_EQ(box.pose.position.x, 0.15);
  EXPECT_DOUBLE_EQ(box.pose.position.z, 0.15);
}

TEST(PalletScene, theWorldFollowsAnyHistory) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  PalletScene scene({});
  World world;
  for (int step = 0; step < 200; ++step) {
    PalletState state = pallet(random() % 5);
    state.is_open = random() % 4 != 0;
    const auto messages = scene.update(state);
    for (const auto& message : messages) world.apply(message);
    const std::size_t expected = state.is_open != 0 ? 1 + state.placements.size() : 0;
    ASSERT_EQ(world.objects.size(), expected) << "seed " << kSeed << " step " << step;
    ASSERT_EQ(messages.back().world.collision_objects.size(), expected) << "the last message is the whole";
  }
}

TEST(PalletScene, refusesWrongParameters) {
  EXPECT_EQ(readPalletSceneOptions(YAML::Load("{}")).carrier_height_m, PalletSceneOptions().carrier_height_m);
  for (const char* wrong :
       {"{carrier_height_m: 0.0}", "{carrier_height_m: .nan}", "{carrier_height_m: 144}", "{carier: 0.1}"})
    EXPECT_THROW(readPalletSceneOptions(YAML::Load(wrong)), std::invalid_argument) << wrong;
}

}  // namespace
}  // namespace mixed_palletizing::converters
