#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include <mixed_palletizing/experiments/detection_summary.hpp>

namespace mixed_palletizing::experiments {
namespace {

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / M_PI;
constexpr double kCoverageStddevs = 2.0;

/// The value below which `share` of the sorted values lie: the nearest rank.
double quantile(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

/// Errors of all records, one list a column.
struct Columns {
  std::vector<double> position, yaw, side, height;
  std::vector<double> origin, base_height, tilt, base_yaw, detect_ms, base_ms;
  std::array<std::size_t, kQuantityCount> within{};
  std::size_t judged = 0;  // complete boxes
};

void addBox(const BoxErrors& errors, Columns& columns) {
  const bool complete = errors.isComplete();
  for (const Quantity side : {kLength, kWidth}) {
    if (complete || errors.isKnown(side)) columns.side.push_back(kMillimetres * errors.error[side]);
  }
  columns.height.push_back(kMillimetres * errors.error[kHeight]);
  if (!complete) return;
  columns.position.push_back(kMillimetres * errors.position());
  columns.yaw.push_back(kDegrees * errors.error[kYaw]);
  ++columns.judged;
  for (std::size_t i = 0; i < kQuantityCount; ++i) {
    if (std::abs(errors.error[i]) <= kCoverageStddevs * errors.stddev[i]) ++columns.within[i];
  }
}

void countBox(const BoxRecord& box, DetectionSummary& summary, Columns& columns) {
  const bool counts = box.truth.counts();
  if (counts) ++summary.boxes;
  if (box.truth.truncated) ++summary.truncated;
  if (!box.found) return;
  if (box.truth.truncated) {
    ++summary.truncated_found;
    if ((box.errors.flags & detection::kTruncated) != 0u) ++summary.truncated_flagged;
  }
  if (box.errors.hasConfidentWrongSize()) ++summary.confident_wrong_sizes;
  if (box.errors.hasSizeBeyondStddev()) ++summary.sizes_beyond_stddev;
  if (!counts) return;
  ++summary.found;
  if (!box.errors.isComplete()) ++summary.incomplete;
  addBox(box.errors, columns);
}

/// How bad a scene is, the worst reason first.
std::tuple<std::size_t, std::size_t, double> badness(const SceneRecord& record) {
  std::size_t faults = record.invented.size() + (record.base_found ? 0 : 1);
  std::size_t wrong = 0;
  double largest = 0.0;
  for (const BoxRecord& box : record.boxes) {
    if (box.truth.counts() && !box.found) ++faults;
    if (!box.found) continue;
    if (box.errors.hasConfidentWrongSize()) ++wrong;
    if (box.truth.counts() && box.errors.isComplete()) largest = std::max(largest, box.errors.position());
  }
  return {faults, wrong, largest};
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole);
}

void addScene(const SceneRecord& record, DetectionSummary& summary, Columns& columns) {
  for (const BoxRecord& box : record.boxes) countBox(box, summary, columns);
  summary.invented += record.invented.size();
  if (!record.base_found) return;
  ++summary.base_found;
  columns.origin.push_back(kMillimetres * record.base.origin_m.head<2>().norm());
  columns.base_height.push_back(kMillimetres * record.base.origin_m.z());
  columns.tilt.push_back(kDegrees * record.base.tilt_rad);
  columns.base_yaw.push_back(kDegrees * record.base.yaw_rad);
  columns.base_ms.push_back(record.base_ms);
  columns.detect_ms.push_back(record.detect_ms);
}

}  // namespace

ErrorStatistics statisticsOf(const std::vector<double>& errors) {
  ErrorStatistics result;
  result.count = errors.size();
  if (errors.empty()) return result;
  const double n = static_cast<double>(errors.size());
  std::vector<double> absolute;
  double squares = 0.0;
  for (const double error : errors) {
    absolute.push_back(std::abs(error));
    result.mean += std::abs(error) / n;
    result.bias += error / n;
    squares += error * error / n;
  }
  result.rms = std::sqrt(squares);
  result.stddev = std::sqrt(std::max(0.0, squares - result.bias * result.bias));
  std::sort(absolute.begin(), absolute.end());
  result.median = quantile(absolute, 0.5);
  result.p95 = quantile(absolute, 0.95);
  result.worst = absolute.back();
  return result;
}

double DetectionSummary::recall() const { return share(found, boxes); }
double DetectionSummary::precision() const { return share(found, found + invented); }

DetectionSummary summarize(const std::vector<SceneRecord>& records) {
  DetectionSummary summary;
  summary.scenes = records.size();
  Columns columns;
  for (const SceneRecord& record : records) addScene(record, summary, columns);
  summary.position_mm = statisticsOf(columns.position);
  summary.yaw_deg = statisticsOf(columns.yaw);
  summary.side_mm = statisticsOf(columns.side);
  summary.height_mm = statisticsOf(columns.height);
  std::size_t within = 0;
  for (std::size_t i = 0; i < kQuantityCount; ++i) {
    summary.within_2_stddev[i] = share(columns.within[i], columns.judged);
    within += columns.within[i];
  }
  summary.coverage = share(within, columns.judged * kQuantityCount);
  summary.base_origin_mm = statisticsOf(columns.origin);
  summary.base_height_mm = statisticsOf(columns.base_height);
  summary.base_tilt_deg = statisticsOf(columns.tilt);
  summary.base_yaw_deg = statisticsOf(columns.base_yaw);
  summary.detect_ms = statisticsOf(columns.detect_ms);
  summary.base_ms = statisticsOf(columns.base_ms);
  const auto worst =
      std::max_element(records.begin(), records.end(),
                       [](const SceneRecord& a, const SceneRecord& b) { return badness(a) < badness(b); });
  if (worst != records.end()) summary.worst_scene = worst->index;
  return summary;
}

std::string summaryText(const DetectionSummary& s) {
  char text[2000];
  std::snprintf(
      text, sizeof text,
      "scenes %zu  boxes %zu  found %zu  invented %zu  recall %.3f  precision %.3f  incomplete %zu\n"
      "position mm  mean %.3f  rms %.3f  p95 %.3f  worst %.3f\n"
      "yaw deg      mean %.4f  p95 %.4f  worst %.4f\n"
      "sides mm     rms %.3f  bias %.3f  p95 %.3f  worst %.3f\n"
      "height mm    mean %.3f  bias %.3f  worst %.3f\n"
      "2 sigma hold %.3f  (x %.2f  y %.2f  top %.2f  yaw %.2f  length %.2f  width %.2f  height %.2f)\n"
      "sizes wrong beyond 3 sigma and 5 mm: %zu, without a flag %zu\n"
      "outside the image: %zu boxes, %zu found, %zu of them flagged\n"
      "base frame   found %zu of %zu  origin mm mean %.3f worst %.3f  height mm %.3f  tilt deg %.4f  yaw deg "
      "mean %.4f "
      "worst %.4f\n"
      "median ms    detection %.1f  base frame %.1f\n"
      "worst scene  %llu",
      s.scenes, s.boxes, s.found, s.invented, s.recall(), s.precision(), s.incomplete, s.position_mm.mean,
      s.position_mm.rms, s.position_mm.p95, s.position_mm.worst, s.yaw_deg.mean, s.yaw_deg.p95,
      s.yaw_deg.worst, s.side_mm.rms, s.side_mm.bias, s.side_mm.p95, s.side_mm.worst, s.height_mm.mean,
      s.height_mm.bias, s.height_mm.worst, s.coverage, s.within_2_stddev[kX], s.within_2_stddev[kY],
      s.within_2_stddev[kTopZ], s.within_2_stddev[kYaw], s.within_2_stddev[kLength],
      s.within_2_stddev[kWidth], s.within_2_stddev[kHeight], s.sizes_beyond_stddev, s.confident_wrong_sizes,
      s.truncated, s.truncated_found, s.truncated_flagged, s.base_found, s.scenes, s.base_origin_mm.mean,
      s.base_origin_mm.worst, s.base_height_mm.mean, s.base_tilt_deg.mean, s.base_yaw_deg.mean,
      s.base_yaw_deg.worst, s.detect_ms.median, s.base_ms.median,
      static_cast<unsigned long long>(s.worst_scene));
  return text;
}

}  // namespace mixed_palletizing::experiments
