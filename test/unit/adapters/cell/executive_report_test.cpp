#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/adapters/cell/executive_report.hpp>
#include <mixed_palletizing/adapters/cell/order.hpp>

namespace mixed_palletizing::cell {
namespace {

CellReport someReport() {
  CellReport report;
  report.pallet_id = "p1";
  report.complete = true;
  PickRecord pick;
  pick.type_id = "a";
  pick.origin_mm = {600, 0, 200};
  pick.placed_size_mm = {400, 300, 200};
  pick.measured = {{401.23456, 299.5, 200.25}, {1.5, 1.25, 0.5}};
  pick.nominal_mm = {400, 300, 200};
  pick.decision_id = 7;
  pick.available = 3;
  pick.decision_ms = 41.4;
  pick.utilization = 0.125;
  report.picks = {pick, pick};
  report.picks[1].measured.size_mm = {398.0, 300.5, 200.25};
  report.discards = {{"b", "no room", {}, 5}, {"", "nothing fits \xff", {}, 6}};
  report.utilization = 0.25;
  report.capture_ms = {100, 300, 200};
  report.decision_ms = {41.4, 41.4};
  return report;
}

TEST(CellReport, JsonHoldsEverything) {
  const auto json = nlohmann::json::parse(reportJson(someReport(), cellOrder({})));
  EXPECT_EQ(json["pallet_id"], "p1");
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["placed"], 2);
  EXPECT_EQ(json["discarded"], 2);
  EXPECT_EQ(json["utilization"], 0.25);
  EXPECT_EQ(json["order"]["pallet_mm"], (std::vector<int>{1200, 800, 600}));
  EXPECT_EQ(json["picks"].size(), 2U);
  EXPECT_EQ(json["picks"][1]["sequence"], 2);
  EXPECT_EQ(json["picks"][0]["origin_mm"], (std::vector<int>{600, 0, 200}));
  EXPECT_EQ(json["picks"][0]["measured_mm"][0], 401.235);
  EXPECT_TRUE(json["discards"][1]["type"].is_null());
  EXPECT_EQ(json["discards"][0]["type"], "b");
  EXPECT_EQ(json["discards"][0]["item"], 5);
  EXPECT_EQ(json["times_ms"]["capture"]["median"], 200);
  EXPECT_EQ(json["times_ms"]["capture"]["max"], 300);
  EXPECT_EQ(json["times_ms"]["detection"]["count"], 0);
  EXPECT_EQ(json["size_error_mm"]["max"][0], 2.0);
  EXPECT_EQ(json["size_error_mm"]["mean"][1], 0.0);
}

TEST(CellReport, JsonOfAnOrderThatDidNotStart) {
  CellReport report;
  report.message = "service /planner/start_pallet did not appear";
  const auto json = nlohmann::json::parse(reportJson(report, cellOrder({})));
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["message"], report.message);
  EXPECT_TRUE(json["picks"].is_array());
  EXPECT_TRUE(json["discards"].is_array());
}

TEST(CellReport, LinesForPeople) {
  const CellReport report = someReport();
  EXPECT_EQ(progressLine(report.picks[0], 3, 24),
            "[ 3/24] a -> (600, 0, 200) as 400 x 300 x 200 mm, 1 of 3 in 41 ms, utilization 12.5 %");
  const std::vector<std::string> lines = summaryLines(report);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "placed 2, discarded 2, utilization 25.0 %");
}

TEST(CellReport, NominalSizeIsThatOfTheStandingBox) {
  const packing::Vec3 size{300, 400, 200};
  EXPECT_EQ(standingSize(size, {{401, 299, 198}, {}}), (std::array<double, 3>{400, 300, 200}));
  EXPECT_EQ(standingSize(size, {{398, 205, 303}, {}}), (std::array<double, 3>{400, 200, 300}));
  EXPECT_EQ(standingSize(size, {{300, 200, 400}, {}}), (std::array<double, 3>{300, 200, 400}));
}

TEST(CellReport, IsWrittenWholeOrNotAtAll) {
  const std::string folder = testing::TempDir() + "cell_report_test";
  std::filesystem::remove_all(folder);
  const std::string path = folder + "/deeper/report.json";
  prepareReport(path);
  writeReport(path, "first");
  writeReport(path, "second");
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(), "second");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder + "/deeper"), {}), 1)
      << "nothing else stays";
  EXPECT_THROW(prepareReport(path + "/below_a_file.json"), std::runtime_error);
  EXPECT_THROW(prepareReport(folder), std::runtime_error) << "a folder";
  prepareReport(path);
  EXPECT_FALSE(std::filesystem::exists(path)) << "the old report";
  EXPECT_THROW(writeReport(folder + "/nowhere/report.json", "x"), std::runtime_error);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace mixed_palletizing::cell
