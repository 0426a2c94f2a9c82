// The tools generate_instances, pack, plan_picks and check_packing, run as a user runs them.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tool_fixture.hpp"

namespace {

class OrderTools : public mixed_palletizing::test::ToolFixture {
 protected:
  OrderTools() : ToolFixture(GENERATE_INSTANCES_TOOL) {}

  int generate(const std::string& arguments) const { return run(arguments); }
  int plan(const std::string& arguments) const { return runTool(PLAN_PICKS_TOOL, arguments); }
  int check(const std::string& orders, const std::string& results) const {
    return runTool(CHECK_PACKING_TOOL, "--instances " + path(orders) + " --results " + path(results));
  }
};

std::vector<nlohmann::json> lines(const std::string& text) {
  std::vector<nlohmann::json> values;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) values.push_back(nlohmann::json::parse(line));
  return values;
}

TEST_F(OrderTools, OrdersArePlannedAndEveryPlacementIsValid) {
  ASSERT_EQ(generate("--height_mm 600 --count 12 --seed 5 --out " + path("i.jsonl")), 0) << read("err.txt");
  ASSERT_EQ(generate("--height_mm 600 --count 12 --seed 5 --out " + path("again.jsonl")), 0);
  EXPECT_EQ(read("i.jsonl"), read("again.jsonl"));
  for (const std::string method : {"dblf", "ga", "best"}) {
    ASSERT_EQ(plan("--instances " + path("i.jsonl") + " --method " + method + " --out " + path("r.jsonl")), 0)
        << read("err.txt");
    EXPECT_EQ(read("err.txt"), "") << "progress although stderr is no terminal";
    EXPECT_EQ(read("out.txt").find("orders 12  perfect "), 0U) << read("out.txt");
    const auto results = lines(read("r.jsonl"));
    ASSERT_EQ(results.size(), 12U);
    EXPECT_EQ(results[0].at("method"), method);
    EXPECT_EQ(results[0].at("placements").at(0).at("available").size(), 3U);
    EXPECT_EQ(check("i.jsonl", "r.jsonl"), 0) << read("out.txt");
    EXPECT_NE(read("out.txt").find("12 of 12 results valid"), std::string::npos) << read("out.txt");
  }
}

TEST_F(OrderTools, AnOrderWithoutArrivalIsPlayedInTheOrderOfTheSeed) {
  write("i.jsonl",
        R"({"name":"a","pallet_mm":[400,400,200],"items":[{"type":"x","size_mm":[100,100,100],"count":20},)"
        R"({"type":"y","size_mm":[200,200,100],"count":3,"rotations":"yaw"}]})");
  ASSERT_EQ(plan("--instances " + path("i.jsonl") + " --seed 4 --out " + path("r.jsonl")), 0)
      << read("err.txt");
  EXPECT_EQ(check("i.jsonl", "r.jsonl"), 0) << read("out.txt");
  nlohmann::json other = lines(read("r.jsonl"))[0];
  other["seed"] = 5;
  write("r2.jsonl", other.dump());
  EXPECT_EQ(check("i.jsonl", "r2.jsonl"), 1) << "another seed is another arrival";
}

TEST_F(OrderTools, BadLinesAreNamedAndTheOthersKept) {
  ASSERT_EQ(generate("--height_mm 600 --count 3 --seed 5 --out " + path("i.jsonl")), 0);
  std::string text = read("i.jsonl");
  text.insert(text.find('\n') + 1, "{\"name\": \"broken\"\n");
  write("bad.jsonl", text);
  const std::string arguments =
      "--instances " + path("bad.jsonl") + " --method dblf --out " + path("r.jsonl");
  expectOneClearLine(PLAN_PICKS_TOOL, arguments, "bad.jsonl:2: no JSON");
  expectOneClearLine(PLAN_PICKS_TOOL, arguments + " --keep-going", "bad.jsonl:2: no JSON");
  EXPECT_EQ(lines(read("r.jsonl")).size(), 3U);
  EXPECT_EQ(check("i.jsonl", "r.jsonl"), 0) << read("out.txt");
}

TEST_F(OrderTools, AnOrderTableIsPackedOnSeveralPallets) {
  write("o.csv",
        "Order,Product,Quantity,Length,Width,Height,Weight\n7,a,40,400,300,250,5\n8,b,2,300,200,100,1\n"
        "7,c,9,600,400,300,9\n");
  const std::string csv = "--instances " + path("o.csv") + " --format csv --pallet_mm 1200 800 600";
  for (const std::string method : {"dblf", "distance", "ga", "best"}) {
    ASSERT_EQ(
        runTool(PACK_TOOL, csv + " --time_limit_s 0.4 --method " + method + " --out " + path("r.jsonl")), 0)
        << read("err.txt");
    EXPECT_EQ(read("out.txt").find("orders 2  packed completely 2  pallets "), 0U) << read("out.txt");
    EXPECT_EQ(runTool(CHECK_PACKING_TOOL, csv + " --results " + path("r.jsonl")), 0) << read("out.txt");
  }
  EXPECT_EQ(runTool(PLAN_PICKS_TOOL, csv + " --method dblf --out " + path("p.jsonl")), 0) << read("err.txt");
  EXPECT_EQ(runTool(CHECK_PACKING_TOOL, csv + " --results " + path("p.jsonl")), 0) << read("out.txt");
  expectOneClearLine(PACK_TOOL, csv + " --time_limit_s 0 --out " + path("r.jsonl"), "max_evaluations");
  expectOneClearLine(PACK_TOOL, csv + " --max_pallets -1 --out " + path("r.jsonl"), "max_pallets");
  expectOneClearLine(PACK_TOOL, "--instances " + path("o.csv") + " --rotations any --out " + path("r.jsonl"),
                     "--rotations: --format jsonl says it itself");
  const std::string rules = csv + " --min_support_ratio 0.7 --overhang_mm 20 --gap_mm 5 --max_weight_kg 90";
  for (const std::string more :
       {" --method dblf", " --method best --time_limit_s 0.3", " --method dblf --spaces empty"}) {
    ASSERT_EQ(runTool(PACK_TOOL, rules + more + " --out " + path("r.jsonl")), 0) << read("err.txt");
    EXPECT_EQ(runTool(CHECK_PACKING_TOOL, rules + " --results " + path("r.jsonl")), 0) << read("out.txt");
    EXPECT_EQ(runTool(CHECK_PACKING_TOOL, csv + " --results " + path("r.jsonl")), 1) << "rules were used";
  }
  expectOneClearLine(PACK_TOOL, csv + " --overhang_mm 20 --out " + path("r.jsonl"),
                     "contradicts min_support_ratio 1");
  write("bad.csv", read("o.csv") + "9,d,1,nan,1,1,1\n");
  const std::string bad =
      "--instances " + path("bad.csv") + " --format csv --method dblf --out " + path("r.jsonl");
  expectOneClearLine(PACK_TOOL, bad, "bad.csv:5: Length");
  expectOneClearLine(PACK_TOOL, bad + " --keep-going", "bad.csv:5: Length");
  EXPECT_EQ(lines(read("r.jsonl")).size(), 2U);
}

TEST_F(OrderTools, FurtherKindsOfOrdersAreGenerated) {
  for (const std::string kind :
       {"--structure cuts --boxes 25 --spread 0.8 --rotations any",
        "--structure columns --continuous_heights --rotations yaw", "--continuous_heights"}) {
    ASSERT_EQ(generate("--height_mm 600 --count 3 --seed 5 --out " + path("i.jsonl") + " " + kind), 0)
        << read("err.txt");
    ASSERT_EQ(
        runTool(PACK_TOOL, "--method contact --instances " + path("i.jsonl") + " --out " + path("r.jsonl")),
        0);
    EXPECT_EQ(check("i.jsonl", "r.jsonl"), 0) << read("out.txt");
  }
  const std::string out = "--height_mm 600 --out " + path("i.jsonl");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, out + " --structure cuts --heights 100",
                     "--heights: --structure cuts has no use");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, out + " --boxes 9",
                     "--boxes: --structure blocks and columns has no use");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, out + " --structure cuts --boxes 0", "boxes: 0");
}

TEST_F(OrderTools, CheckPackingFindsWhatIsWrong) {
  ASSERT_EQ(generate("--height_mm 600 --count 2 --seed 5 --out " + path("i.jsonl")), 0);
  ASSERT_EQ(plan("--instances " + path("i.jsonl") + " --method dblf --out " + path("r.jsonl")), 0);
  auto results = lines(read("r.jsonl"));
  results[0]["placements"][3]["origin_mm"][2] = 1;
  write("bad.jsonl", results[0].dump() + "\n");
  EXPECT_EQ(check("i.jsonl", "bad.jsonl"), 1);
  EXPECT_NE(read("out.txt").find("placement 3: "), std::string::npos) << read("out.txt");
  EXPECT_NE(read("out.txt").find("has no result"), std::string::npos) << read("out.txt");
  EXPECT_NE(read("out.txt").find("0 of 1 results valid"), std::string::npos) << read("out.txt");
}

TEST_F(OrderTools, BadInputIsOneClearLine) {
  const std::string out = " --out " + path("x.jsonl");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, "--height_mm 650" + out, "650");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, "--height_mm 600 --divisors 3" + out, "power of two");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, "--height_mm 600 --count 0" + out, "count");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, "--height_mm 600 --pallet_mm 1200" + out, "pallet_mm");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, "--height_mm x" + out, "height_mm");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, "--height_mm 600", "out");
  expectOneClearLine(GENERATE_INSTANCES_TOOL, "--height_mm 600 --out " + path("no/x"), "no/x");
  ASSERT_EQ(generate("--height_mm 600 --seed 5 --out " + path("i.jsonl")), 0);
  const std::string good = "--instances " + path("i.jsonl");
  expectOneClearLine(PLAN_PICKS_TOOL, good + out + " --method magic", "method");
  expectOneClearLine(PLAN_PICKS_TOOL, good + out + " --budget_ms -1", "budget_ms");
  expectOneClearLine(PLAN_PICKS_TOOL, good + " --out " + path("no/x"), "no/x");
  expectOneClearLine(PLAN_PICKS_TOOL, "--instances " + path("none") + out, "none");
  expectOneClearLine(CHECK_PACKING_TOOL, good + " --results " + path("none"), "none");
}

TEST_F(OrderTools, Help) {
  for (const std::string tool : {GENERATE_INSTANCES_TOOL, PACK_TOOL, PLAN_PICKS_TOOL, CHECK_PACKING_TOOL}) {
    EXPECT_EQ(runTool(tool, "--help"), 0);
    EXPECT_NE(read("out.txt").find("--"), std::string::npos);
  }
}

}  // namespace
