#include <array>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/pack_instance.hpp>
#include <mixed_palletizing/instances/published_orders.hpp>

#include "support.hpp"

namespace mixed_palletizing::instances {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

constexpr const char* kCsv =
    "Order,Product,Quantity,Length,Width,Height,Weight\r\n7,a,36,225,225.2,180,5.186\r\n8,a,2,300,200,100,"
    "1\r\n"
    "7,b,10,335,250,264,14.614\r\n";

TEST(OrderCsv, isRead) {
  const InstanceFile file = readOrderCsv(test::writeFile("orders.csv", kCsv));
  ASSERT_TRUE(file.faults.empty()) << file.faults[0];
  ASSERT_EQ(file.instances.size(), 2U);
  const Instance& first = file.instances[0];
  EXPECT_EQ(first.name, "7");
  EXPECT_EQ(first.order.counts, (std::vector<int>{36, 10}));
  EXPECT_EQ(first.order.types[0].size, (packing::Vec3{225, 226, 180})) << "rounded up";
  EXPECT_EQ(first.order.types[1].weight_kg, 14.614);
  EXPECT_EQ(first.order.rules.size, (packing::Vec3{1200, 800, 1400}));
  const InstanceFile small = readOrderCsv(test::writeFile("orders.csv", kCsv), {{{300, 230, 180}}, {}});
  EXPECT_EQ(small.instances.size(), 1U) << "335 mm do not fit: order 7 is left out";
  EXPECT_EQ(small.faults.size(), 1U);
  EXPECT_THROW(readOrderCsv(test::writeFile("orders.csv", kCsv), {{{0, 1, 1}}, {}}), std::invalid_argument);
}

TEST(OrderCsv, namesItsFaultsAndKeepsOtherOrders) {
  for (const auto& [from, to, fault] :
       std::vector<std::array<const char*, 3>>{{"36,", "0,", "Quantity"},
                                               {"36,", "2000000,", "Quantity"},
                                               {"36,", "1.5,", "Quantity"},
                                               {"225,", "-1,", "Length"},
                                               {"225,", "0,", "Length"},
                                               {"225,", "nan,", "Length"},
                                               {"225,", "inf,", "Length"},
                                               {"225,", "x,", "Length"},
                                               {"225,", "1500,", "larger than the pallet"},
                                               {"225,", "\"225\",", "quotes"},
                                               {",5.186", "", "6 values in the line, 7 needed"},
                                               {",5.186", ",-5", "Weight"},
                                               {"7,a", "7,", "Product"}}) {
    const std::string path = test::writeFile("bad.csv", replaced(kCsv, from, to));
    const InstanceFile file = readOrderCsv(path);
    ASSERT_EQ(file.faults.size(), 1U) << from << " -> " << to;
    EXPECT_EQ(file.faults[0].find(path + ":2: "), 0U) << file.faults[0];
    EXPECT_NE(file.faults[0].find(fault), std::string::npos) << file.faults[0];
    ASSERT_EQ(file.instances.size(), 1U);
    EXPECT_EQ(file.instances[0].name, "8");
  }
  const InstanceFile twice = readOrderCsv(test::writeFile("bad.csv", replaced(kCsv, "7,b", "7,a")));
  ASSERT_EQ(twice.faults.size(), 1U);
  EXPECT_NE(twice.faults[0].find("occurs twice"), std::string::npos);
}

TEST(OrderCsv, refusesAHeaderThatIsNoHeader) {
  for (const auto& [from, to] : std::vector<std::array<const char*, 2>>{
           {"Height,", ""}, {"Height", "height"}, {"Weight", "Length"}, {"Order", "7"}}) {
    const InstanceFile file = readOrderCsv(test::writeFile("bad.csv", replaced(kCsv, from, to)));
    EXPECT_EQ(file.faults.size(), 1U) << from << " -> " << to;
    EXPECT_TRUE(file.instances.empty());
  }
  EXPECT_EQ(
      readOrderCsv(test::writeFile("bad.csv", "Order,Product,Quantity,Length,Width,Height\n")).faults.size(),
      1U);
  EXPECT_THROW(readOrderCsv(test::writeFile("bad.csv", "")), std::runtime_error);
}

constexpr const char* kBed =
    R"({"A": {"item_sequence": {"10": {"article": "x", "length/mm": 300, "width/mm": 200, "height/mm": 100},
 "2": {"article": "y", "length/mm": 400, "width/mm": 200.5, "height/mm": 100, "weight/kg": 2.5, "id": "1"}},
 "properties": {"target": "rollcontainer", "type": "t"}},
"B": {"item_sequence": {"1": {"article": "z", "length/mm": 30, "width/mm": 20, "height/mm": 10}},
 "properties": {"target": "euro-pallet"}}})";

TEST(BedBpp, isRead) {
  const InstanceFile file = readBedBppFile(test::writeFile("bed.json", kBed));
  ASSERT_TRUE(file.faults.empty()) << file.faults[0];
  ASSERT_EQ(file.instances.size(), 2U);
  const Instance& a = file.instances[0];
  EXPECT_EQ(a.order.rules.size, (packing::Vec3{800, 700, 2000}));
  ASSERT_EQ(a.arrival.size(), 2U);
  EXPECT_EQ(a.order.types[static_cast<std::size_t>(a.arrival[0])].name, "y") << "2 arrives before 10";
  EXPECT_EQ(a.order.types[0].size, (packing::Vec3{400, 201, 100}));
  EXPECT_EQ(a.order.types[0].weight_kg, 2.5);
}

TEST(BedBpp, namesItsFaultsAndKeepsOtherOrders) {
  for (const auto& [from, to, fault] :
       std::vector<std::array<const char*, 3>>{{"300", "0", "length/mm"},
                                               {"300", "-3", "length/mm"},
                                               {"300", "\"300\"", "length/mm"},
                                               {"300", "900", "larger than the pallet"},
                                               {"\"length/mm\": 300, ", "", "length/mm: is missing"},
                                               {"\"10\"", "\"ten\"", "is no number"},
                                               {"rollcontainer", "truck", "'truck' is not known"},
                                               {"\"x\"", "\"y\"", "other sizes"}}) {
    const std::string path = test::writeFile("bad.json", replaced(kBed, from, to));
    const InstanceFile file = readBedBppFile(path);
    ASSERT_FALSE(file.faults.empty()) << from << " -> " << to;
    EXPECT_EQ(file.faults[0].find(path + ":1: order A: "), 0U) << file.faults[0];
    EXPECT_NE(file.faults[0].find(fault), std::string::npos) << file.faults[0];
    ASSERT_EQ(file.instances.size(), 1U);
    EXPECT_EQ(file.instances[0].name, "B");
  }
  const std::string text = kBed;
  for (std::size_t end = 1; end < text.size(); end += 7) {
    const InstanceFile cut = readBedBppFile(test::writeFile("cut.json", text.substr(0, end)));
    EXPECT_EQ(cut.faults.size(), 1U) << "cut at " << end;
    EXPECT_TRUE(cut.instances.empty());
  }
  EXPECT_THROW(readBedBppFile("/no/such/file"), std::runtime_error);
}

TEST(ReadOrders, publishedFilesArePackedOnSeveralPallets) {
  const std::string folder = test::dataFolder();
  if (folder.empty()) GTEST_SKIP() << "no shared test data (MIXED_PALLETIZING_DATA)";
  const std::vector<std::pair<std::string, OrderFormat>> files{
      {"orders_eur_pallet.csv", OrderFormat::kCsv}, {"bed_bpp_5_orders.json", OrderFormat::kBedBpp}};
  for (const auto& [name, format] : files) {
    const InstanceFile file = readOrders(folder + "/packing/" + name, format);
    ASSERT_TRUE(file.faults.empty()) << file.faults[0];
    EXPECT_EQ(file.instances.size(), format == OrderFormat::kCsv ? 150U : 5U);
    PackRun run;
    run.options.method = packing::PackMethod::kDblf;
    run.max_pallets = 0;
    for (std::size_t i = 0; i < file.instances.size(); i += 4) {
      const Instance& instance = file.instances[i];
      const PackingResult packed = packInstance(instance, run);
      EXPECT_TRUE(packed.unpacked.empty()) << instance.name;
      const PackingResult result = parseResult(formatResult(packed, instance), instance);
      EXPECT_EQ(result.pallets, packed.pallets);
      EXPECT_EQ(joinFaults(checkResult(instance, result)), "") << instance.name;
    }
  }
}

TEST(OrderFormat, isParsedFromItsWord) {
  EXPECT_EQ(orderFormatFromString("jsonl"), OrderFormat::kJsonLines);
  EXPECT_EQ(orderFormatFromString("br"), OrderFormat::kBr);
  EXPECT_EQ(orderFormatFromString("csv"), OrderFormat::kCsv);
  EXPECT_EQ(orderFormatFromString("bed_bpp"), OrderFormat::kBedBpp);
  EXPECT_FALSE(orderFormatFromString("json"));
}

TEST(PackInstance, isTheSameAgainWithABudgetOfEvaluations) {
  GeneratorOptions generator;
  generator.pallet.z = 1200;
  const Instance instance = generateInstance(generator, 3, 0);
  PackRun run;
  run.time_limit_s = 0.0;
  EXPECT_THROW(packInstance(instance, run), std::invalid_argument) << "best would never end";
  run.max_evaluations = 30;
  PackingResult first = packInstance(instance, run);
  PackingResult second = packInstance(instance, run);
  first.decision_ms = second.decision_ms = {};
  EXPECT_EQ(formatResult(first, instance), formatResult(second, instance));
  EXPECT_EQ(joinFaults(checkResult(instance, first)), "");
}

TEST(CheckResult, keepsPalletsApart) {
  Instance instance = generateInstance({}, 4, 0);
  PackingResult result = test::perfectResult(instance);
  result.pallets = 2;
  result.utilization = 0.5;
  EXPECT_EQ(joinFaults(checkResult(instance, result)), "");
  result.placements.back().pallet = 2;
  EXPECT_NE(joinFaults(checkResult(instance, result)).find("pallet 2 of 2"), std::string::npos);
  result.placements.back().pallet = 1;
  const bool on_floor = result.placements.back().placement.origin.z == 0;
  EXPECT_EQ(joinFaults(checkResult(instance, result)).empty(), on_floor) << "nothing supports it on pallet 1";
}

}  // namespace
}  // namespace mixed_palletizing::instances
