#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/option_reader.hpp>

namespace mixed_palletizing::adapters {
namespace {

struct Options {
  int count = 3;
  double length_m = 0.5;
  bool on = true;
  std::string name = "unnamed";
  std::uint64_t seed = 1;
  std::vector<int> list{1, 2};
  int choice = 0;
};

/// Reads every member, two of them from a section.
OptionReader readAll(const std::string& yaml, Options& options) {
  OptionReader reader(YAML::Load(yaml));
  reader.read("count", options.count);
  reader.read("on", options.on);
  reader.read("name", options.name);
  reader.read("seed", options.seed);
  reader.read("list", options.list);
  reader.readWord<int>("choice", options.choice, {{"zero", 0}, {"one", 1}});
  OptionReader section = reader.section("section");
  section.read("length_m", options.length_m);
  return reader;
}

std::vector<std::string> problemsOf(const std::string& yaml) {
  Options options;
  return readAll(yaml, options).problems();
}

TEST(OptionReader, keepsDefaultsOfAbsentKeys) {
  Options options;
  EXPECT_TRUE(readAll("{}", options).problems().empty());
  EXPECT_TRUE(readAll("", options).problems().empty());
  EXPECT_TRUE(readAll("section:", options).problems().empty());
  EXPECT_EQ(options.count, 3);
  EXPECT_EQ(options.list, (std::vector<int>{1, 2}));
}

TEST(OptionReader, readsEveryType) {
  Options options;
  const auto reader = readAll(
      "{count: 7, on: false, name: x, seed: 18446744073709551615, list: [5], choice: one, section: "
      "{length_m: 2}}",
      options);
  EXPECT_TRUE(reader.problems().empty());
  EXPECT_EQ(options.count, 7);
  EXPECT_FALSE(options.on);
  EXPECT_EQ(options.name, "x");
  EXPECT_EQ(options.seed, UINT64_MAX);
  EXPECT_EQ(options.list, std::vector<int>{5});
  EXPECT_EQ(options.choice, 1);
  EXPECT_EQ(options.length_m, 2.0);
}

TEST(OptionReader, namesUnknownKeysWithTheNearestOne) {
  const auto problems = problemsOf("{cuont: 1, section: {lenght_m: 1}, other: {a: 1}}");
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_NE(problems[0].find("cuont: nobody knows this key (did you mean 'count'?)"), std::string::npos);
  EXPECT_NE(problems[1].find("section.lenght_m"), std::string::npos);
  EXPECT_NE(problems[2].find("other"), std::string::npos);
}

TEST(OptionReader, namesWrongTypesAndKeepsTheDefault) {
  for (const char* yaml : {"count: x", "count: 1.5", "count: [1]", "on: 3", "seed: -1", "list: 5",
                           "list: [a]", "section: 5", "choice: two", "choice: [one]",
                           "section: {length_m: .nan}", "section: {length_m: .inf}", "count: 99999999999"}) {
    Options options;
    EXPECT_EQ(readAll(yaml, options).problems().size(), 1u) << yaml;
    EXPECT_EQ(options.count, 3) << yaml;
    EXPECT_EQ(options.length_m, 0.5) << yaml;
  }
  EXPECT_EQ(problemsOf("[1, 2]").size(), 1u);
  EXPECT_EQ(problemsOf("just words").size(), 1u);
}

TEST(OptionReader, finishListsEverythingAtOnce) {
  Options options;
  OptionReader reader = readAll("{count: x, tpyo: 1}", options);
  reader.section("section").add({"length_m: too long"});
  try {
    reader.finish("these options");
    FAIL() << "nothing thrown";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("these options: 3 mistakes:"), std::string::npos) << text;
    for (const char* part : {"count: x", "tpyo", "section.length_m: too long"}) {
      EXPECT_NE(text.find(part), std::string::npos) << text;
    }
  }
}

TEST(OptionReader, ignoredKeysAreNoMistakes) {
  OptionReader reader(YAML::Load("{diagnostic_period: 1, a: 2}"));
  reader.ignore("diagnostic_period");
  EXPECT_EQ(reader.problems().size(), 1u);
}

TEST(LoadYaml, namesTheFile) {
  EXPECT_THROW(
      try { loadYaml("/nowhere/x.yaml"); } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("/nowhere/x.yaml: cannot be read"), std::string::npos);
        throw;
      },
      std::runtime_error);
  const std::string path = testing::TempDir() + "broken.yaml";
  std::ofstream(path) << "a: [1";
  EXPECT_THROW(loadYaml(path), std::runtime_error);
}

TEST(LoadYaml, refusesDeepAndHugeFiles) {
  const std::string path = testing::TempDir() + "deep.yaml";
  for (const char c : {'[', '{'}) {
    std::ofstream(path) << std::string(100000, c);
    EXPECT_THROW(loadYaml(path), std::runtime_error) << c;
  }
  EXPECT_THROW(loadYaml("/dev/zero"), std::runtime_error);
}

TEST(OptionReader, manyMistakesAreAShortMessage) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "key" + std::to_string(i) + ": " + std::string(1000, 'x') + "\n";
  OptionReader reader(YAML::Load(text + std::string(1000, 'k') + ": 1"));
  int number = 0;
  reader.read("key7", number);
  try {
    reader.finish("these options");
    FAIL() << "nothing thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_LT(std::string(error.what()).size(), 10000U);
    EXPECT_NE(std::string(error.what()).find("more"), std::string::npos);
  }
}

}  // namespace
}  // namespace mixed_palletizing::adapters
