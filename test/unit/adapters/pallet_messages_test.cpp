#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/pallet_messages.hpp>

namespace mixed_palletizing::adapters {
namespace {

geometry_msgs::Vector3 vector(double x, double y, double z) {
  geometry_msgs::Vector3 v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

OrderLine line(const std::string& type_id, const geometry_msgs::Vector3& size, std::uint32_t count) {
  OrderLine line;
  line.type_id = type_id;
  line.size = size;
  line.count = count;
  line.rotations = OrderLine::YAW;
  return line;
}

OrderRequest request() {
  OrderRequest request;
  request.size = vector(1.2, 0.8, 0.6);
  request.lines = {line("a", vector(0.3, 0.2, 0.1), 4), line("b", vector(0.4, 0.3, 0.2), 2)};
  return request;
}

Eigen::Matrix3d rotationOf(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}

TEST(ReadOrder, sizesUpPalletDownGapUp) {
  OrderRequest odd = request();
  odd.size = vector(1.2009, 0.8, 0.6);
  odd.gap = 0.0011;
  odd.lines[0].size = vector(0.3, 0.2001, 0.1);
  const ReadOrder read = readOrder(odd);
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(read.order.rules.size, (packing::Vec3{1200, 800, 600}));
  EXPECT_EQ(read.order.rules.gap, 2);
  EXPECT_EQ(read.order.rules.min_support_ratio, 1.0);
  EXPECT_EQ(read.order.types[0].size, (packing::Vec3{300, 201, 100}));
  EXPECT_EQ(read.order.counts, (std::vector<int>{4, 2}));
}

TEST(ReadOrder, linesSurviveTheWayBack) {
  OrderRequest all = request();
  all.lines[0].rotations = OrderLine::CUSTOM;
  all.lines[0].vertical = {1, 0, 1};
  all.lines[1].rotations = OrderLine::ANY;
  all.lines[1].vertical = {1, 1, 1};
  all.lines[1].weight = 2.5;
  all.lines[1].max_load = 10.0;
  const std::vector<OrderLine> lines = toLines(readOrder(all).order);
  ASSERT_EQ(lines.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(lines[i].type_id, all.lines[i].type_id);
    EXPECT_EQ(lines[i].count, all.lines[i].count);
    EXPECT_EQ(lines[i].rotations, all.lines[i].rotations);
    EXPECT_EQ(lines[i].vertical, all.lines[i].vertical);
    EXPECT_EQ(lines[i].weight, all.lines[i].weight);
    EXPECT_EQ(lines[i].max_load, all.lines[i].max_load);
    EXPECT_NEAR(lines[i].size.x, all.lines[i].size.x, 1e-12);
  }
}

TEST(ReadOrder, listsAllThatIsWrong) {
  OrderRequest bad = request();
  bad.size.x = std::nan("");
  bad.gap = std::numeric_limits<double>::infinity();
  bad.lines[0].size.z = 2000.0;
  bad.lines[0].rotations = 9;
  bad.lines[1].weight = std::nan("");
  const ReadOrder read = readOrder(bad);
  EXPECT_EQ(read.problems.size(), 5u);
  const auto broken = [](auto change) {
    OrderRequest order = request();
    change(order);
    return !readOrder(order).problems.empty();
  };
  EXPECT_TRUE(broken([](auto& r) { r.lines.clear(); }));
  EXPECT_TRUE(broken([](auto& r) { r.lines[0].count = 0; }));
  EXPECT_TRUE(broken([](auto& r) { r.lines[0].count = 0xffffffffu; }));
  EXPECT_TRUE(broken([](auto& r) { r.lines[0].type_id.clear(); }));
  EXPECT_TRUE(broken([](auto& r) { r.lines[0].type_id = "b"; }));
  EXPECT_TRUE(broken([](auto& r) { r.lines[0].size.x = 0.0; }));
  EXPECT_TRUE(broken([](auto& r) { r.lines[0].size.x = -0.1; }));
  EXPECT_TRUE(broken([](auto& r) { r.lines[0].weight = -1.0; }));
  EXPECT_TRUE(broken([](auto& r) { r.size.z = 0.0; }));
  EXPECT_TRUE(broken([](auto& r) { r.gap = -0.01; }));
  EXPECT_TRUE(broken([](auto& r) { r.min_support_ratio = 1.5; }));
}

TEST(PlacementMessage, posesAreProperRotationsThatMapTheSizes) {
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> length(50, 600);
  for (int i = 0; i < 500; ++i) {
    packing::Order order;
    order.types.resize(1);
    order.types[0].size = {length(random), length(random), length(random)};
    order.types[0].rotations = packing::Rotations::any();
    for (const packing::Vec3& placed : packing::orientations(order.types[0])) {
      const packing::Placement placement{0, {10, 20, 30}, placed};
      const Placement message = toMessage(placement, order);
      const Eigen::Matrix3d rotation = rotationOf(message.pose);
      ASSERT_NEAR(rotation.determinant(), 1.0, 1e-9);
      const packing::Vec3& own = order.types[0].size;
      const Eigen::Vector3d turned = rotation.cwiseAbs() * Eigen::Vector3d(own.x, own.y, own.z);
      ASSERT_NEAR(turned.x(), placed.x, 1.001);
      ASSERT_NEAR(turned.y(), placed.y, 1.001);
      ASSERT_NEAR(turned.z(), placed.z, 1.001);
      ASSERT_NEAR(message.pose.position.x, (10 + placed.x / 2.0) / 1000.0, 1e-9);
    }
  }
}

TEST(PlacementMessage, alignsWithTheDetectedBox) {
  packing::Order order;
  order.types.resize(1);
  order.types[0].name = "a";
  order.types[0].size = {200, 300, 100};  // the order gives the short side first
  Placement message = toMessage(packing::Placement{0, {0, 0, 0}, {200, 300, 100}}, order);
  EXPECT_TRUE(rotationOf(message.pose).isIdentity(1e-9));
  alignPose(message, {0.303, 0.198, 0.101});  // the detected box has its length along x
  const Eigen::Vector3d length_axis = rotationOf(message.pose).col(0);
  EXPECT_NEAR(std::abs(length_axis.y()), 1.0, 1e-9);
  EXPECT_NEAR(rotationOf(message.pose).col(2).z(), 1.0, 1e-9);
}

class Measured : public testing::Test {
 protected:
  Measured() {
    pose_.position.x = 0.15;
    pose_.position.y = 0.10;
    pose_.position.z = 0.05;
    pose_.orientation.w = 1.0;
  }
  MeasuredPlacement measure() const { return measuredPlacement(pose_, planned_, 0.005, 0.05); }
  void turn(double angle_rad) {
    pose_.orientation.w = std::cos(angle_rad / 2);
    pose_.orientation.z = std::sin(angle_rad / 2);
  }

  packing::Placement planned_{0, {0, 0, 0}, {300, 200, 100}};
  geometry_msgs::Pose pose_;
};

TEST_F(Measured, isThePlanWithinTheTolerance) {
  for (const double off : {0.0, 0.0049, -0.0049}) {
    pose_.position.x = 0.15 + off;
    ASSERT_TRUE(measure().placement);
    EXPECT_EQ(*measure().placement, planned_);
  }
}

TEST_F(Measured, isRoundedBeyondIt) {
  pose_.position.x = 0.1652;
  pose_.position.y = 0.0996;
  ASSERT_TRUE(measure().placement);
  EXPECT_EQ(measure().placement->origin, (packing::Vec3{15, 0, 0}));
  EXPECT_EQ(measure().placement->size, planned_.size);
}

TEST_F(Measured, mustStandAlongTheSides) {
  for (const double quarter : {0.0, M_PI / 2, M_PI, -M_PI / 2}) {
    turn(quarter + 0.04);
    EXPECT_TRUE(measure().placement);
    turn(quarter + 0.06);
    EXPECT_FALSE(measure().placement);
    EXPECT_FALSE(measure().problem.empty());
  }
}

TEST_F(Measured, refusesWhatIsNoPose) {
  pose_.position.z = std::nan("");
  EXPECT_FALSE(measure().placement);
  pose_.position.z = 0.05;
  pose_.orientation.w = 0.0;
  EXPECT_FALSE(measure().placement);
  pose_.orientation.w = std::nan("");
  EXPECT_FALSE(measure().placement);
  pose_.orientation.w = 1.0;
  pose_.position.x = 1e30;
  EXPECT_FALSE(measure().placement);
}

TEST(PalletState, showsTheSession) {
  planning::PalletSession session{planning::PlannerOptions{}};
  EXPECT_FALSE(toMessage(session).is_open);
  ASSERT_TRUE(session.start("p", readOrder(request()).order, false).ok());
  const auto never = [] { return false; };
  const planning::ChooseReply reply = session.choose("r", {0, 1}, never);
  ASSERT_EQ(reply.status, planning::ChooseStatus::kPick);
  PalletState state = toMessage(session);
  EXPECT_TRUE(state.is_open);
  EXPECT_TRUE(state.has_pending);
  EXPECT_EQ(state.pallet_id, "p");
  EXPECT_EQ(state.remaining, (std::vector<std::uint32_t>{4, 2}));
  ASSERT_TRUE(session.report(reply.decision_id, planning::PickOutcome::kPlaced, std::nullopt, {}).ok());
  state = toMessage(session);
  EXPECT_FALSE(state.has_pending);
  ASSERT_EQ(state.placements.size(), 1u);
  EXPECT_FALSE(state.spaces.empty());
  EXPECT_GT(state.utilization, 0.0);
  EXPECT_NEAR(state.center_of_gravity.x, state.placements[0].pose.position.x, 1e-9);
  EXPECT_EQ(state.remaining[0] + state.remaining[1], 5u);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
