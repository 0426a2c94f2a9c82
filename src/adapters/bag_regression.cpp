#include <cstdio>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <mixed_palletizing/adapters/bag_regression.hpp>
#include <mixed_palletizing/adapters/cloud_message.hpp>
#include <mixed_palletizing/adapters/detection_picture.hpp>

namespace mixed_palletizing::adapters {
namespace {

GoldenCloud goldenCloud(const ReplayedCloud& cloud) {
  GoldenCloud golden;
  golden.stamp_ns = cloud.message->header.stamp.toNSec();
  golden.fault = cloud.fault;
  golden.boxes = goldenBoxes(cloud.result.detections);
  return golden;
}

GoldenDetections replay(const OfflineDetectionRequest& request) {
  GoldenDetections now;
  replayOffline(request, [&](const ReplayedCloud& cloud) {
    now.base_from_camera = cloud.result.base_from_camera;
    now.clouds.push_back(goldenCloud(cloud));
  });
  return now;
}

std::string lineOf(const GoldenDifference& difference, const GoldenDetections& now) {
  if (difference.cloud < 0) return difference.text;
  const auto cloud = static_cast<std::size_t>(difference.cloud);
  char head[64];
  std::snprintf(head, sizeof head, "cloud %zu at %.3f s: ", cloud,
                1e-9 * static_cast<double>(now.clouds[cloud].stamp_ns));
  return head + difference.text;
}

/// A second pass over the bag, for a picture of each cloud in `changed`.
void draw(const BagRegression& job, const GoldenDetections& golden, const GoldenDetections& now,
          const std::set<int>& changed) {
  std::error_code fault;
  std::filesystem::create_directories(job.pictures, fault);
  if (fault) throw std::runtime_error(job.pictures + ": " + fault.message());
  int index = 0;
  replayOffline(job.request, [&](const ReplayedCloud& cloud) {
    const int at = index++;
    const CheckedCloud content = checkCloud(*cloud.message);
    if (changed.count(at) == 0 || !content.view) return;
    char name[32];
    std::snprintf(name, sizeof name, "cloud_%04d.png", at);
    const auto k = static_cast<std::size_t>(at);
    writeDetectionPicture((std::filesystem::path(job.pictures) / name).string(), *content.view,
                          now.base_from_camera,
                          {{golden.clouds[k].boxes, 0xff3020}, {now.clouds[k].boxes, 0x20c040}});
  });
}

}  // namespace

std::size_t updateGolden(const BagRegression& job) {
  const GoldenDetections now = replay(job.request);
  writeGolden(job.golden, now);
  return now.clouds.size();
}

BagRegressionOutcome compareWithGolden(const BagRegression& job) {
  const GoldenDetections golden = readGolden(job.golden);
  const GoldenDetections now = replay(job.request);
  BagRegressionOutcome outcome;
  outcome.clouds = now.clouds.size();
  std::set<int> changed;
  for (const GoldenDifference& difference : compareGolden(golden, now, job.tolerances)) {
    outcome.lines.push_back(lineOf(difference, now));
    if (difference.cloud >= 0) changed.insert(difference.cloud);
  }
  if (!job.pictures.empty() && !changed.empty()) draw(job, golden, now, changed);
  return outcome;
}

}  // namespace mixed_palletizing::adapters
