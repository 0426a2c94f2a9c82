// Files without an end, and deep ones.
#include <gtest/gtest.h>

#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/instances/published_orders.hpp>

#include "support.hpp"

namespace mixed_palletizing::instances {
namespace {

TEST(InstanceFile, endlessAndDeepFilesAreRefused) {
  const InstanceFile endless = readInstanceFile("/dev/zero");
  ASSERT_EQ(endless.faults.size(), 1U);
  EXPECT_NE(endless.faults.front().find("bytes"), std::string::npos) << endless.faults.front();
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "{\"a\":[";
  const std::string path = test::writeFile("deep.json", deep);
  for (const InstanceFile& file : {readInstanceFile(path), readBedBppFile(path)}) {
    EXPECT_NE(joinFaults(file.faults).find("levels"), std::string::npos);
    EXPECT_LT(joinFaults(file.faults).size(), 1000U);
  }
}

}  // namespace
}  // namespace mixed_palletizing::instances
