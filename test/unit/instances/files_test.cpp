#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/instances/files.hpp>

#include "support.hpp"

namespace mixed_palletizing::instances {
namespace {

constexpr const char* kGood =
    R"({"name":"a","pallet_mm":[1200,800,600],"items":[{"type":"x","size_mm":[300,200,100],"count":2},)"
    R"({"type":"y","size_mm":[400,300,200],"count":1,"rotations":[true,false,true],"weight_kg":2.5,"max_load_kg":9}],)"
    R"("arrival":["x","y","x"],"n_pick":2,"gap_mm":3,"min_support_ratio":0.75})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string faultOf(const std::string& line) {
  try {
    parseInstance(line);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(InstanceLine, isRead) {
  const Instance instance = parseInstance(kGood);
  EXPECT_EQ(instance.name, "a");
  EXPECT_EQ(instance.order.rules.size, (packing::Vec3{1200, 800, 600}));
  EXPECT_EQ(instance.order.rules.gap, 3);
  EXPECT_EQ(instance.order.rules.min_support_ratio, 0.75);
  EXPECT_EQ(instance.arrival, (std::vector<int>{0, 1, 0}));
  EXPECT_EQ(instance.n_pick, 2);
  EXPECT_FALSE(instance.order.types[0].rotations.yaw);
  EXPECT_TRUE(instance.order.types[1].rotations.yaw);
  EXPECT_EQ(instance.order.types[1].rotations.vertical, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(instance.order.types[1].weight_kg, 2.5);
  EXPECT_EQ(instance.order.types[1].max_load_kg, 9.0);
}

TEST(InstanceLine, comesBackAsItWas) {
  for (int i = 0; i < 50; ++i) {
    Instance instance = generateInstance({}, 9, i);
    instance.order.types[0].rotations =
        i % 3 == 0 ? packing::Rotations::yawOnly() : packing::Rotations::any();
    instance.order.types[0].weight_kg = 0.1 * i;
    if (i % 2 == 0) instance.arrival.clear();
    if (i % 5 == 0) instance.perfect_packing.clear();
    const std::string line = formatInstance(instance);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const Instance again = parseInstance(line);
    EXPECT_EQ(formatInstance(again), line);
    EXPECT_EQ(again.perfect_packing, instance.perfect_packing);
    EXPECT_EQ(again.arrival, instance.arrival);
  }
  Instance instance = generateInstance({}, 9, 0);
  instance.order.types[0].rotations = {false, {true, true, true}};
  EXPECT_THROW(formatInstance(instance), std::invalid_argument);
}

TEST(InstanceLine, faultsAreNamed) {
  const std::vector<std::array<const char*, 3>> cases = {
      {"\"n_pick\":2", "\"n_pik\":2", "n_pik: is no known key"},
      {"\"count\":2", "\"count\":2,\"cuont\":3", "items[0].cuont: is no known key"},
      {"\"n_pick\":2", "\"n_pick\":0", "n_pick: an integer"},
      {"\"n_pick\":2", "\"n_pick\":2.5", "n_pick: an integer"},
      {"\"n_pick\":2", "\"n_pick\":2,\"n_pick\":3", "occurs twice"},
      {"\"count\":2", "\"count\":99999999999999", "items[0].count"},
      {"\"count\":2", "\"count\":-2", "items[0].count"},
      {"\"count\":2", "\"count\":3", "arrival"},
      {"[300,200,100]", "[300,200,0]", "items[0].size_mm"},
      {"[300,200,100]", "[300,200]", "items[0].size_mm"},
      {"[300,200,100]", "[300,200.5,100]", "items[0].size_mm"},
      {"[300,200,100]", "[1300,200,100]", "larger than the pallet"},
      {"[1200,800,600]", "\"EUR\"", "pallet_mm"},
      {"\"name\":\"a\",", "", "name: is missing"},
      {"\"name\":\"a\"", "\"name\":7", "name: a string"},
      {"[\"x\",\"y\",\"x\"]", "[\"x\",\"z\",\"x\"]", "arrival[1]: 'z'"},
      {"[\"x\",\"y\",\"x\"]", "[]", "arrival"},
      {"[true,false,true]", "[true,false]", "rotations"},
      {"[true,false,true]", "\"all\"", "rotations"},
      {"[true,false,true]", "[false,false,false]", "no side may stand vertical"},
      {"0.75", "1.5", "min_support_ratio"},
      {"0.75", "0", "min_support_ratio"},
      {"0.75", "1e999", "no JSON"},
      {"\"gap_mm\":3", "\"gap_mm\":-3", "gap_mm"},
      {"\"gap_mm\":3",
       "\"gap_mm\":3,\"perfect_packing\":[{\"type\":\"x\",\"origin_mm\":[0,0,0],\"size_mm\":[300,200,100]}]",
       "perfect_packing"},
      {"2.5", "-1", "weight_kg"},
      {"}", "", "no JSON"},
  };
  for (const auto& [from, to, fault] : cases) {
    EXPECT_NE(faultOf(replaced(kGood, from, to)).find(fault), std::string::npos)
        << to << " gives: " << faultOf(replaced(kGood, from, to));
  }
  EXPECT_NE(faultOf("[]").find("object"), std::string::npos);
  EXPECT_NE(faultOf(std::string(100000, '[')).find("levels"), std::string::npos);
  const std::string renamed = replaced(kGood, "\"type\":\"y\"", "\"type\":\"x\"");
  EXPECT_NE(faultOf(replaced(renamed, "\"x\",\"y\",\"x\"", "\"x\",\"x\",\"x\"")).find("given twice"),
            std::string::npos);
  const std::string both = faultOf(replaced(replaced(kGood, "\"n_pick\":2", "\"n_pick\":0"), "2.5", "-1"));
  EXPECT_TRUE(both.find("n_pick") != std::string::npos && both.find("weight_kg") != std::string::npos)
      << both;
}

TEST(InstanceLine, everyCutIsRefused) {
  const std::string good = kGood;
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_THROW(parseInstance(good.substr(0, length)), std::invalid_argument) << length;
  }
}

TEST(InstanceFile, keepsTheSoundLinesAndNamesTheOthers) {
  const std::string other = replaced(kGood, "\"a\"", "\"b\"");
  const std::string path =
      test::writeFile("instances.jsonl", std::string(kGood) + "\n\n{\"name\":\n" + kGood + "\r\n" + other);
  const InstanceFile file = readInstanceFile(path);
  ASSERT_EQ(file.instances.size(), 2U);
  EXPECT_EQ(file.instances[1].name, "b");
  ASSERT_EQ(file.faults.size(), 2U);
  EXPECT_EQ(file.faults[0].find(path + ":3: "), 0U) << file.faults[0];
  EXPECT_EQ(file.faults[1].find(path + ":4: name: 'a' is also that of line 1"), 0U) << file.faults[1];
  EXPECT_THROW(readInstances(path), std::invalid_argument);
  EXPECT_THROW(readInstances(path + ".absent"), std::runtime_error);
  EXPECT_THROW(readInstances(test::writeFile("empty.jsonl", "")), std::runtime_error);
  EXPECT_THROW(readInstances(::testing::TempDir()), std::runtime_error);
}

TEST(ResultLine, comesBackAsItWas) {
  Instance instance = generateInstance({}, 9, 1);
  PackingResult result = test::perfectPlay(instance);
  result.decision_ms = {1.0, 2.5, 3.0};
  result.method = "ga";
  result.seed = 18446744073709551615ULL;
  const std::string line = formatResult(result, instance);
  const PackingResult again = parseResult(line, instance);
  EXPECT_EQ(formatResult(again, instance), line);
  EXPECT_TRUE(checkResult(instance, again).empty());
  EXPECT_EQ(again.seed, result.seed);
  result.utilization = std::nan("");
  EXPECT_THROW(formatResult(result, instance), std::invalid_argument);
}

TEST(ResultFile, namesItsFaults) {
  const Instance instance = generateInstance({}, 9, 1);
  const Instance other = generateInstance({}, 9, 2);
  const std::string good = formatResult(test::perfectResult(instance), instance);
  const std::string first = formatResult(test::perfectResult(other), other);
  const std::vector<std::array<std::string, 2>> cases = {
      {first, "has a result in line 1"},
      {replaced(good, instance.name, "nobody"), "is that of no instance"},
      {replaced(good, "\"item\":", "\"itme\":"), "placements[0].item: is missing"},
      {replaced(good, "\"seed\":0", "\"seed\":-1"), "seed"},
      {replaced(good, "\"utilization\":1.0", "\"utilization\":1.5"), "utilization"},
      {replaced(good, "\"utilization\":1.0", "\"utilization\":null"), "utilization"},
      {"7", "name"},
  };
  for (const auto& [line, fault] : cases) {
    const std::string path = test::writeFile("results.jsonl", first + "\n" + line + "\n");
    const ResultFile file = readResultFile(path, {instance, other});
    EXPECT_EQ(file.results.size(), 1U);
    ASSERT_FALSE(file.faults.empty()) << line.substr(0, 80);
    EXPECT_EQ(file.faults[0].find(path + ":2: "), 0U);
    EXPECT_NE(joinFaults(file.faults).find(fault), std::string::npos) << joinFaults(file.faults);
    EXPECT_NE(file.find(other.name), nullptr);
    EXPECT_EQ(file.find("nobody"), nullptr);
  }
}

TEST(JoinFaults, isShort) {
  EXPECT_EQ(joinFaults({}), "");
  EXPECT_EQ(joinFaults({"a", "b"}), "a; b");
  EXPECT_NE(joinFaults(std::vector<std::string>(50, "x")).find("and 40 more"), std::string::npos);
}

constexpr const char* kBr =
    " 1\n 1 2502505\n 587 233 220\n 2\n 1 108 0 76 0 30 1 40\n 2 110 0 43 1 25 1 33\n";

TEST(BrFile, isRead) {
  const InstanceFile file = readBrFile(test::writeFile("BR9.txt", kBr));
  ASSERT_TRUE(file.faults.empty()) << file.faults[0];
  ASSERT_EQ(file.instances.size(), 1U);
  const Instance& instance = file.instances[0];
  EXPECT_EQ(instance.name, "BR9_1");
  EXPECT_EQ(instance.order.rules.size, (packing::Vec3{5870, 2330, 2200}));
  EXPECT_EQ(instance.order.counts, (std::vector<int>{40, 33}));
  EXPECT_EQ(packing::orientations(instance.order.types[0]).size(), 2U);
  EXPECT_EQ(packing::orientations(instance.order.types[1]).size(), 4U);
}

TEST(BrFile, namesItsFaults) {
  const std::string good = kBr;
  for (std::size_t lines = 1; lines < 6; ++lines) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < lines; ++i) end = good.find('\n', end) + 1;
    EXPECT_NE(readBrFile(test::writeFile("cut.txt", good.substr(0, end))).faults.size(), 0U);
  }
  for (const auto& [from, to] : {std::array<const char*, 2>{"587", "x"},
                                 {"587", "0"},
                                 {"587", "-5"},
                                 {"587", "1e3"},
                                 {"587", "99999999999999999999"},
                                 {" 40", ""},
                                 {" 40", " 0"},
                                 {" 40", " 9999999"},
                                 {"108", "600"},
                                 {" 2\n", " 0\n"},
                                 {" 33\n", " 33\n 7\n"}}) {
    const InstanceFile file = readBrFile(test::writeFile("bad.txt", replaced(good, from, to)));
    EXPECT_EQ(file.faults.size(), 1U) << from << " -> " << to;
    EXPECT_THROW(readBrInstances(test::writeFile("bad.txt", replaced(good, from, to))),
                 std::invalid_argument);
  }
}

TEST(BrFile, keepsTheInstancesBesideAFaultyOne) {
  const std::string one = std::string(kBr).substr(std::string(kBr).find('\n') + 1);
  const std::string text = "3\n" + one + replaced(one, "108", "0") + one;
  const std::string path = test::writeFile("BR9.txt", text);
  const InstanceFile file = readBrFile(path);
  EXPECT_EQ(file.instances.size(), 2U);
  ASSERT_EQ(file.faults.size(), 1U);
  EXPECT_EQ(file.faults[0].find(path + ":10: length of 0 cm"), 0U) << file.faults[0];
  EXPECT_EQ(readBrFile(test::writeFile("BR9.txt", "2\n" + replaced(one, " 40", "") + one)).instances.size(),
            0U)
      << "who knows where the next one begins";
}

TEST(BrFile, readsThePublicFiles) {
  const std::string folder = test::dataFolder();
  if (folder.empty()) GTEST_SKIP() << "no shared test data (MIXED_PALLETIZING_DATA)";
  for (int i = 1; i <= 15; ++i) {
    const auto instances = readBrInstances(folder + "/packing/br/BR" + std::to_string(i) + ".txt");
    EXPECT_EQ(instances.size(), i <= 7 ? 20U : 5U);
    for (const Instance& instance : instances) EXPECT_TRUE(problems(instance).empty());
  }
}

}  // namespace
}  // namespace mixed_palletizing::instances
