#include <algorithm>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/command_line.hpp>

namespace mixed_palletizing::adapters {
namespace {

struct Values {
  std::string path;
  int count = 7;
  double budget = 0.5;
  std::uint64_t seed = 1;
  std::string method = "ga";
  std::vector<int> heights{300, 200};
  bool quiet = false;
};

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

Outcome runWith(const std::vector<const char*>& words, Values& values, const std::function<int()>& body) {
  std::vector<const char*> argv{"tool"};
  argv.insert(argv.end(), words.begin(), words.end());
  CommandLine line("tool", "Does a thing.");
  line.required("path", &values.path, "the file");
  line.option("count", &values.count, "how many");
  line.option("budget", &values.budget, "seconds");
  line.option("seed", &values.seed, "of the random choices");
  line.option("heights", &values.heights, "millimetres");
  line.choice("method", &values.method, {"dblf", "ga"}, "how");
  line.flag("quiet", &values.quiet, "say nothing");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.code = line.run(static_cast<int>(argv.size()), argv.data(), body);
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  return outcome;
}

TEST(CommandLine, readsEveryKindOfValueAndKeepsDefaults) {
  Values values;
  const Outcome outcome = runWith({"--path", "a b", "--count=-3", "--heights", "1", "2", "3", "--quiet"},
                                  values, [] { return 5; });
  EXPECT_EQ(outcome.code, 5) << outcome.err;
  EXPECT_EQ(values.path, "a b");
  EXPECT_EQ(values.count, -3);
  EXPECT_EQ(values.heights, (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(values.quiet);
  EXPECT_EQ(values.seed, 1u);
  EXPECT_EQ(values.method, "ga");
}

TEST(CommandLine, refusesEveryWrongLineWithOneLine) {
  const std::vector<std::vector<const char*>> wrong = {
      {},
      {"--path"},
      {"--path", "a", "--pathh", "b"},
      {"--pat", "a"},
      {"--path", "a", "stray"},
      {"--path", "a", "--count", "many"},
      {"--path", "a", "--count", "99999999999"},
      {"--path", "a", "--seed", "-1"},
      {"--path", "a", "--budget", "nan"},
      {"--path", "a", "--method", "magic"},
      {"--path", "a", "--heights", "1", "x"},
      {"--path", "a", "--path", "b"},
  };
  for (const auto& words : wrong) {
    Values values;
    bool ran = false;
    const Outcome outcome = runWith(words, values, [&] {
      ran = true;
      return 0;
    });
    EXPECT_EQ(outcome.code, 2) << testing::PrintToString(words);
    EXPECT_FALSE(ran);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("tool: ", 0), 0u) << outcome.err;
  }
}

TEST(CommandLine, showsHelpWithDefaultsAndChoices) {
  Values values;
  const Outcome outcome = runWith({"--help"}, values, [] { return 9; });
  EXPECT_EQ(outcome.code, 0);
  for (const char* text :
       {"Does a thing.", "--path", "(required)", "default: 300 200", "dblf, ga", "default: 0.5"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text << " in\n" << outcome.out;
  }
}

TEST(CommandLine, turnsAnExceptionIntoOneLine) {
  Values values;
  const Outcome outcome =
      runWith({"--path", "a"}, values, []() -> int { throw std::runtime_error("first\nsecond\n"); });
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.err, "tool: first;second\n");
}

}  // namespace
}  // namespace mixed_palletizing::adapters
