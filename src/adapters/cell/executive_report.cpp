#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/adapters/cell/executive_report.hpp>
#include <mixed_palletizing/adapters/units.hpp>
#include <mixed_palletizing/instances/result_summary.hpp>

namespace mixed_palletizing::cell {
namespace {

using Json = nlohmann::json;
using Triple = std::array<double, 3>;

/// Rounded to a thousandth: more digits are noise in a report.
double rounded(double value) { return std::round(value * 1e3) / 1e3; }

Json toJson(const Triple& values) { return {rounded(values[0]), rounded(values[1]), rounded(values[2])}; }

Json toJson(const packing::Vec3& size) { return {size.x, size.y, size.z}; }

Json timesJson(const std::vector<double>& times_ms) {
  const instances::DecisionTimes times = instances::decisionTimes(times_ms);
  return {{"count", times_ms.size()},
          {"median", rounded(times.median_ms)},
          {"p99", rounded(times.p99_ms)},
          {"max", rounded(times.max_ms)}};
}

Json pickJson(const PickRecord& pick, std::size_t sequence) {
  return {{"sequence", sequence},
          {"type", pick.type_id},
          {"item", pick.item},
          {"origin_mm", toJson(pick.origin_mm)},
          {"size_mm", toJson(pick.placed_size_mm)},
          {"measured_mm", toJson(pick.measured.size_mm)},
          {"measured_stddev_mm", toJson(pick.measured.stddev_mm)},
          {"nominal_mm", toJson(pick.nominal_mm)},
          {"decision_id", pick.decision_id},
          {"available", pick.available},
          {"capture_ms", rounded(pick.capture_ms)},
          {"detection_ms", rounded(pick.detection_ms)},
          {"decision_ms", rounded(pick.decision_ms)},
          {"utilization", pick.utilization}};
}

Json discardJson(const DiscardRecord& discard) {
  return {{"type", discard.type_id.empty() ? Json() : Json(discard.type_id)},
          {"item", discard.item},
          {"reason", discard.reason},
          {"measured_mm", toJson(discard.measured.size_mm)}};
}

Json orderJson(const instances::Instance& instance) {
  const packing::Order& order = instance.order;
  Json items = Json::array();
  for (std::size_t i = 0; i < order.types.size(); ++i) {
    items.push_back({{"type", order.types[i].name},
                     {"size_mm", toJson(order.types[i].size)},
                     {"count", order.counts[i]}});
  }
  return {{"name", instance.name}, {"pallet_mm", toJson(order.rules.size)}, {"items", items}};
}

/// Of the measured against the nominal sizes of all picks [mm]: length, width, height.
Json sizeErrorJson(const std::vector<PickRecord>& picks) {
  Triple mean{};
  Triple largest{};
  for (const PickRecord& pick : picks) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double error = pick.measured.size_mm[i] - pick.nominal_mm[i];
      mean[i] += error / static_cast<double>(picks.size());
      largest[i] = std::max(largest[i], std::abs(error));
    }
  }
  return {{"mean", toJson(mean)}, {"max", toJson(largest)}};
}

std::string timesLine(const char* what, const std::vector<double>& times_ms) {
  const instances::DecisionTimes times = instances::decisionTimes(times_ms);
  char line[160];
  std::snprintf(line, sizeof line, "%-10s %4zu times, median %7.1f ms, 99 %% %7.1f ms, longest %7.1f ms",
                what, times_ms.size(), times.median_ms, times.p99_ms, times.max_ms);
  return line;
}

std::string text(const Triple& values, const char* format) {
  char line[128];
  std::snprintf(line, sizeof line, format, values[0], values[1], values[2]);
  return line;
}

/// Of a point or vector in metres.
template <typename Xyz>
Triple millimeters(const Xyz& v) {
  return {v.x * adapters::kMillimetersPerMeter, v.y * adapters::kMillimetersPerMeter,
          v.z * adapters::kMillimetersPerMeter};
}

/// Beside the report, so that it can be renamed to it.
std::string partOf(const std::string& path) { return path + ".part"; }

}  // namespace

MeasuredSize measuredSize(const Box& box) { return {millimeters(box.size), millimeters(box.size_stddev)}; }

std::array<double, 3> standingSize(const packing::Vec3& size_mm, const MeasuredSize& measured) {
  const Triple sides{static_cast<double>(size_mm.x), static_cast<double>(size_mm.y),
                     static_cast<double>(size_mm.z)};
  Triple best{};
  double smallest = INFINITY;
  for (const std::size_t up : {2U, 1U, 0U}) {
    const double a = sides[(up + 1) % 3];
    const double b = sides[(up + 2) % 3];
    const Triple standing{std::max(a, b), std::min(a, b), sides[up]};
    double error = 0.0;
    for (std::size_t i = 0; i < 3; ++i) error += std::abs(standing[i] - measured.size_mm[i]);
    if (!(error < smallest)) continue;
    smallest = error;
    best = standing;
  }
  return best;
}

PickRecord pickRecord(const Box& box, const Placement& placement, const packing::Vec3& nominal_mm) {
  PickRecord record;
  record.origin_mm = millimeters(placement.origin);
  record.placed_size_mm = millimeters(placement.size);
  record.measured = measuredSize(box);
  record.nominal_mm = standingSize(nominal_mm, record.measured);
  return record;
}

std::string progressLine(const PickRecord& pick, std::size_t done, std::size_t total) {
  char line[256];
  const int width = static_cast<int>(std::to_string(total).size());
  std::snprintf(line, sizeof line, "[%*zu/%zu] %s -> %s as %s mm, 1 of %zu in %.0f ms, utilization %.1f %%",
                width, done, total, pick.type_id.c_str(), text(pick.origin_mm, "(%.0f, %.0f, %.0f)").c_str(),
                text(pick.placed_size_mm, "%.0f x %.0f x %.0f").c_str(), pick.available, pick.decision_ms,
                100.0 * pick.utilization);
  return line;
}

std::vector<std::string> summaryLines(const CellReport& report) {
  char line[160];
  std::snprintf(line, sizeof line, "placed %zu, discarded %zu, utilization %.1f %%", report.picks.size(),
                report.discards.size(), 100.0 * report.utilization);
  return {line, timesLine("capture", report.capture_ms), timesLine("detection", report.detection_ms),
          timesLine("decision", report.decision_ms)};
}

std::string reportJson(const CellReport& report, const instances::Instance& instance) {
  Json picks = Json::array();
  for (std::size_t i = 0; i < report.picks.size(); ++i) picks.push_back(pickJson(report.picks[i], i + 1));
  Json discards = Json::array();
  for (const DiscardRecord& discard : report.discards) discards.push_back(discardJson(discard));
  const Json json = {{"pallet_id", report.pallet_id},
                     {"complete", report.complete},
                     {"message", report.message},
                     {"order", orderJson(instance)},
                     {"placed", report.picks.size()},
                     {"discarded", report.discards.size()},
                     {"utilization", report.utilization},
                     {"times_ms",
                      {{"capture", timesJson(report.capture_ms)},
                       {"detection", timesJson(report.detection_ms)},
                       {"decision", timesJson(report.decision_ms)}}},
                     {"size_error_mm", sizeErrorJson(report.picks)},
                     {"picks", picks},
                     {"discards", discards}};
  // Messages may quote bytes that are no UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void prepareReport(const std::string& path) {
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder, failure);
  std::ofstream file(partOf(path));
  file.close();
  if (failure || !file || std::filesystem::is_directory(path)) {
    throw std::runtime_error(path + ": cannot be written");
  }
  std::filesystem::remove(partOf(path), failure);
  std::filesystem::remove(path, failure);
}

void writeReport(const std::string& path, const std::string& text) {
  std::ofstream file(partOf(path));
  file << text;
  file.close();
  if (!file || std::rename(partOf(path).c_str(), path.c_str()) != 0) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

}  // namespace mixed_palletizing::cell
