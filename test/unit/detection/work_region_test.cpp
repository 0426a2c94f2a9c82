#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/detection/work_region.hpp>

namespace mixed_palletizing::detection {
namespace {

TEST(WorkRegion, isEverywhereByDefault) {
  const WorkRegion region{RegionOptions()};
  EXPECT_FALSE(region.limited());
  EXPECT_TRUE(region.contains({100.0f, -50.0f, 1.0f}));
  EXPECT_FALSE(WorkRegion().limited());
}

TEST(WorkRegion, holdsAPolygonWithADentInEitherSense) {
  RegionOptions options;
  options.polygon_m = {0, 0, 2, 0, 2, 2, 1, 0.5, 0, 2};  // the dent reaches down to (1, 0.5)
  for (int sense = 0; sense < 2; ++sense) {
    const WorkRegion region(options);
    EXPECT_TRUE(region.limited());
    EXPECT_TRUE(region.contains({0.2f, 1.0f, 0.1f}));
    EXPECT_TRUE(region.contains({1.8f, 1.0f, 0.1f}));
    EXPECT_TRUE(region.contains({1.0f, 0.3f, 0.1f}));
    EXPECT_FALSE(region.contains({1.0f, 1.0f, 0.1f}));
    EXPECT_FALSE(region.contains({2.1f, 1.0f, 0.1f}));
    EXPECT_FALSE(region.contains({std::numeric_limits<float>::quiet_NaN(), 1.0f, 0.1f}));
    options.polygon_m = {0, 2, 1, 0.5, 2, 2, 2, 0, 0, 0};
  }
}

TEST(WorkRegion, limitsHeightAndCutsOutPlanes) {
  RegionOptions options;
  options.max_z_m = 0.5;
  options.planes = {{Eigen::Vector3d::UnitX(), -1.0}};  // a wall at x = 1
  const WorkRegion region(options);
  EXPECT_TRUE(region.contains({0.98f, 0.0f, 0.4f}));
  EXPECT_FALSE(region.contains({1.005f, 0.0f, 0.4f}));
  EXPECT_FALSE(region.contains({0.5f, 0.0f, 0.6f}));
}

TEST(WorkRegion, refusesWhatIsNoRegion) {
  RegionOptions options;
  options.polygon_m = {0, 0, 1, 0, 1};
  EXPECT_THROW(WorkRegion{options}, std::invalid_argument);
  options.polygon_m = {0, 0, 1, 0, 2, 0};
  EXPECT_EQ(problems(options).size(), 1u);
  options.polygon_m = {0, 0, 1, 0, 1, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(problems(options).size(), 1u);
  options = RegionOptions();
  options.min_z_m = options.max_z_m;
  options.planes = {{Eigen::Vector3d(0, 0, 2), 0.0}};
  options.plane_distance_m = 0.0;
  EXPECT_EQ(problems(options).size(), 3u);
}

}  // namespace
}  // namespace mixed_palletizing::detection
