#include <cstdio>
#include <fstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <mixed_palletizing/adapters/cell/order.hpp>
#include <mixed_palletizing/instances/files.hpp>

namespace mixed_palletizing::cell {
namespace {

TEST(CellOrder, OfAGeneratedOrderSimulatorAndExecutiveAgree) {
  CellOrderOptions options;
  const instances::Instance order = cellOrder(options);
  EXPECT_EQ(instances::formatInstance(order), instances::formatInstance(cellOrder(options)));
  EXPECT_TRUE(instances::problems(order).empty());
  EXPECT_EQ(order.order.rules.size, (packing::Vec3{1200, 800, 600}));
  EXPECT_EQ(order.order.itemVolume(), packing::volume(order.order.rules.size));
  options.seed = 2;
  EXPECT_NE(instances::formatInstance(order), instances::formatInstance(cellOrder(options)));
  options.seed = 1;
  options.index = 1;
  EXPECT_NE(instances::formatInstance(order), instances::formatInstance(cellOrder(options)));
}

TEST(CellOrder, ComesFromTheLineOfAFile) {
  const std::string path = testing::TempDir() + "cell_order_test.jsonl";
  CellOrderOptions generated;
  std::ofstream(path)
      << instances::formatInstance(cellOrder(generated)) << "\n"
      << R"({"name": "two", "pallet_mm": [400, 300, 200], "n_pick": 2, )"
      << R"("items": [{"type": "a", "size_mm": [200, 150, 100], "count": 5, "rotations": "yaw"}]})"
      << "\n";
  CellOrderOptions options;
  options.instances = path;
  EXPECT_EQ(cellOrder(options).name, cellOrder(generated).name);
  options.index = 1;
  EXPECT_EQ(cellOrder(options).name, "two");
  options.index = 2;
  EXPECT_THROW(cellOrder(options), std::invalid_argument);
  std::ofstream(path) << "{\"name\": 3}\n";
  options.index = 0;
  EXPECT_THROW(cellOrder(options), std::invalid_argument);
  std::remove(path.c_str());
  EXPECT_THROW(cellOrder(options), std::runtime_error);
}

TEST(CellOrder, NamesEveryBrokenRule) {
  CellOrderOptions options;
  options.height_mm = 650;  // no sum of the generator's heights
  options.index = -1;
  const std::vector<std::string> found = problems(options);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].rfind("index: ", 0), 0U) << found[0];
  EXPECT_EQ(found[1].rfind("height_mm: ", 0), 0U) << found[1];
  EXPECT_THROW(cellOrder(options), std::invalid_argument);
}

TEST(CellOrder, IsReadFromParameters) {
  adapters::OptionReader reader(YAML::Load("{height_mm: 800, seed: 7, instances: orders.jsonl, index: 3}"));
  CellOrderOptions options;
  readCellOrderOptions(reader, options);
  EXPECT_TRUE(reader.problems().empty());
  EXPECT_EQ(options.height_mm, 800);
  EXPECT_EQ(options.seed, 7U);
  EXPECT_EQ(options.instances, "orders.jsonl");
  EXPECT_EQ(options.index, 3);
}

}  // namespace
}  // namespace mixed_palletizing::cell
