#include "pick_request.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace mixed_palletizing::adapters {
namespace {

Box box(double length_m, double width_m, double height_m) {
  Box box;
  box.size.x = length_m;
  box.size.y = width_m;
  box.size.z = height_m;
  box.size_stddev.x = box.size_stddev.y = box.size_stddev.z = 0.001;
  return box;
}

class PickRequest : public testing::Test {
 protected:
  PickRequest() : session_(planning::PlannerOptions{}) {
    packing::Order order;
    order.rules.size = {1200, 800, 600};
    order.types = {{"small", {300, 200, 100}, packing::Rotations::yawOnly()},
                   {"large", {600, 400, 200}, packing::Rotations::yawOnly()},
                   {"nearly small", {304, 204, 104}, packing::Rotations::none()}};
    order.counts = {2, 1, 1};
    EXPECT_TRUE(session_.start("p", order, false).ok());
  }
  IdentifiedBoxes identified() const { return identify(request_, session_, {}); }

  planning::PalletSession session_;
  ChooseNextPickRequest request_;
};

TEST_F(PickRequest, typeIdsAreLookedUpAndCounted) {
  request_.type_ids = {"large", "small", "green", "small", "small"};
  const IdentifiedBoxes boxes = identified();
  EXPECT_EQ(boxes.types, (std::vector<int>{1, 0, 0}));
  EXPECT_EQ(boxes.request_index, (std::vector<std::size_t>{0, 1, 3}));
  ASSERT_EQ(boxes.options.size(), 5u);
  EXPECT_EQ(boxes.options[2].status, PickOption::UNKNOWN_BOX);
  EXPECT_EQ(boxes.options[4].status, PickOption::UNKNOWN_BOX);
  EXPECT_FALSE(boxes.options[4].reason.empty());
  EXPECT_EQ(boxes.options[0].type_id, "large");
}

TEST_F(PickRequest, detectedBoxesAreMatchedBySize) {
  request_.boxes = {box(0.601, 0.398, 0.201), box(0.302, 0.202, 0.102), box(0.5, 0.5, 0.5)};
  const IdentifiedBoxes boxes = identified();
  EXPECT_EQ(boxes.types, std::vector<int>{1});
  EXPECT_EQ(boxes.options[1].status, PickOption::AMBIGUOUS_BOX);
  EXPECT_EQ(boxes.options[2].status, PickOption::UNKNOWN_BOX);
}

TEST_F(PickRequest, saysAmbiguousOnlyWhenSomethingIs) {
  request_.boxes = {box(0.5, 0.5, 0.5)};
  EXPECT_EQ(nothingIdentified(identified()), ChooseNextPickResponse::UNKNOWN_BOX);
  request_.boxes.push_back(box(0.302, 0.202, 0.102));
  EXPECT_EQ(nothingIdentified(identified()), ChooseNextPickResponse::AMBIGUOUS_BOX);
}

TEST_F(PickRequest, faultsAreSeenWithoutTheOrder) {
  EXPECT_EQ(faultOf(request_, 10), "");
  request_.boxes.assign(11, box(0.3, 0.2, 0.1));
  EXPECT_NE(faultOf(request_, 10).find("max_available"), std::string::npos);
  EXPECT_EQ(faultOf(request_, 11), "");
  request_.boxes[7].size.y = std::nan("");
  EXPECT_NE(faultOf(request_, 11).find("boxes[7].size.y"), std::string::npos);
  request_.boxes.assign(1, box(0.3, 0.2, 0.1));
  for (const double budget : {-1.0, std::nan(""), 1e9}) {
    request_.time_budget = budget;
    EXPECT_NE(faultOf(request_, 10).find("time_budget"), std::string::npos) << budget;
  }
  request_.time_budget = 0.0;
  request_.type_ids = {"small"};
  EXPECT_NE(faultOf(request_, 10), "");
}

}  // namespace
}  // namespace mixed_palletizing::adapters
